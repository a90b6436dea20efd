#!/usr/bin/env python3
"""Golden figures of frames around places on Earth: `tests/data/convergences.csv` and `tests/data/enu.csv`.

    pip install -r requirements.txt
    python3 frames.py

The first has places in and beyond zones of UTM, on their edges too, as coordinates of the map's zone with the convergence of its
grid; the second has places about a point as east, north and up. Both are made by pyproj.
"""

import csv
from pathlib import Path

import pyproj
from pyproj import Transformer

DATA = Path(__file__).resolve().parents[2] / "tests" / "data"
# Zone, whether it is southern, latitudes and longitudes: middles, edges, places beyond them, the other hemisphere.
ZONES = [
    (32, False, [0.0, 0.5, 30.0, 48.0, 60.0, 71.0, 83.5, -0.01], [5.0, 6.0, 6.001, 9.0, 9.5, 11.999, 12.0, 12.001, 12.3, 15.0]),
    (56, True, [-0.001, -12.0, -33.9, -55.0, -79.5], [149.9, 150.0, 152.0, 153.0, 155.9, 156.0, 156.1]),
    (1, False, [21.0, 52.0], [-180.0, -179.99, 179.99, -177.0, -174.0, -173.9]),
    (60, False, [52.0], [174.0, 177.0, 179.999, -179.9]),
]
# Definition of a map, latitude, longitude and altitude of the origin.
ORIGINS = [
    ("+proj=utm +zone=32 +datum=WGS84", 48.137, 11.575, 520.0),
    ("+proj=utm +zone=56 +south +datum=WGS84", -33.87, 151.21, 0.0),
    ("+proj=tmerc +lat_0=37.4168716 +lon_0=-122.1030492 +datum=WGS84", 37.4, -122.1, 30.0),
    ("+proj=merc +lat_ts=45 +lon_0=10 +datum=WGS84", 60.0, 10.0, 100.0),
]
# Places about an origin: degrees north and east of it, metres above it.
AROUND = [(0.0, 0.0, 0.0), (0.0, 0.0, 50.0), (1e-4, 0.0, 0.0), (0.0, 1e-4, 1.0), (0.01, -0.02, 5.0), (-0.1, 0.05, -20.0), (0.3, 0.4, 300.0)]


def convergences(made):
    with open(DATA / "convergences.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["definition", "latitude", "longitude", "x", "y", "convergence", "made_by"])
        for zone, south, latitudes, longitudes in ZONES:
            definition = f"+proj=utm +zone={zone}{' +south' if south else ''} +datum=WGS84"
            plane = pyproj.Proj(definition)
            for latitude in latitudes:
                for longitude in longitudes:
                    x, y = plane(longitude, latitude, errcheck=True)
                    convergence = plane.get_factors(longitude, latitude).meridian_convergence
                    out.writerow([definition, latitude, longitude, f"{x:.4f}", f"{y:.4f}", f"{convergence:.9f}", made])


def enu(made):
    with open(DATA / "enu.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["definition", "origin_latitude", "origin_longitude", "origin_altitude", "latitude", "longitude", "altitude", "east", "north", "up", "made_by"])
        for definition, latitude, longitude, altitude in ORIGINS:
            to_enu = Transformer.from_pipeline(
                "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84 "
                f"+step +proj=topocentric +ellps=WGS84 +lat_0={latitude} +lon_0={longitude} +h_0={altitude}"
            )
            for north, east, up in AROUND:
                place = round(latitude + north, 9), round(longitude + east, 9), altitude + up
                found = to_enu.transform(place[1], place[0], place[2], errcheck=True)
                out.writerow([definition, latitude, longitude, altitude, *place, *(f"{number:.5f}" for number in found), made])


def main():
    made = f"pyproj {pyproj.__version__} with PROJ {pyproj.proj_version_str}"
    convergences(made)
    enu(made)


if __name__ == "__main__":
    main()
