"""Golden figures of target frames: `tests/data/target_frames.csv` and `tests/data/target_frame_sets.csv`.

    pip install -r requirements.txt
    python3 target_frames.py

Ten straight roads of 2 km lie around a place, in a file's plane. Each definition's answers are the points of those roads in
another plane: x and y in metres, to a micrometre. The Rust test writes the same roads as a map and compiles it with `--crs`.
"""

import csv
import math
from pathlib import Path

import pyproj
from pyproj import CRS, Transformer

DATA = Path(__file__).resolve().parents[2] / "tests" / "data"
ROADS, POINTS, LENGTH = 10, 50, 2000.0

UTM32 = "+proj=utm +zone=32 +datum=WGS84"
GK3 = "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m"
OHIO = "+proj=lcc +lat_1=41.7 +lat_2=40.4333333333333 +lat_0=39.6666666666667 +lon_0=-82.5 +x_0=600000 +y_0=0 +ellps=GRS80 +towgs84=0,0,0 +units=us-ft"
SWISS = "+proj=somerc +lat_0=46.9524055555556 +lon_0=7.43958333333333 +k_0=1 +x_0=2600000 +y_0=1200000 +ellps=bessel +towgs84=674.374,15.056,405.346,0,0,0,0 +units=m"
# name, the file's georeference, header offset x y hdg, latitude and longitude of the roads, --crs, what pyproj is given for it
SETS = [
    ("zone_boundary", UTM32, (0, 0, 0), (48.0, 12.0), "epsg:32633", "EPSG:32633"),
    ("auto_zone", "+proj=tmerc +lat_0=48 +lon_0=12 +k=1 +datum=WGS84", (0, 0, 0), (48.0, 12.1), "utm", "EPSG:32633"),
    ("south", "+proj=tmerc +lat_0=-33.9 +lon_0=151.2 +k=1 +datum=WGS84", (0, 0, 0), (-33.9, 151.2), "utm", "EPSG:32756"),
    ("offset", UTM32, (691000.0, 5334000.0, 0.6), (48.14, 11.57), "epsg:25833", "EPSG:25833"),
    ("enu", UTM32, (0, 0, 0), (48.14, 11.57), "enu:48.137,11.575,520", "enu"),
    ("seven_parameters", GK3, (0, 0, 0), (48.1, 9.3), "utm", UTM32),
    ("to_seven_parameters", UTM32, (0, 0, 0), (48.1, 9.3), GK3, GK3),
    ("us_feet", OHIO, (0, 0, 0), (40.0, -82.9), "epsg:32617", "EPSG:32617"),
    ("to_us_feet", "+proj=utm +zone=17 +datum=WGS84", (0, 0, 0), (40.0, -82.9), OHIO, OHIO),
    ("swiss", SWISS, (0, 0, 0), (47.0, 8.0), "utm", UTM32),
    ("carla", "+lat_0=42.0 +lon_0=2.0", (0, 0, 0), (42.0, 2.0), "utm", "EPSG:32631"),
]


def crs(text):
    return CRS(text if "proj" in text or "EPSG" in text else f"+proj=tmerc {text} +datum=WGS84")


def unit(definition):
    """Metres of the plane's unit."""
    return definition.axis_info[0].unit_conversion_factor


def transformer(origin, target):
    return Transformer.from_crs(origin, target, always_xy=True, only_best=False, allow_ballpark=True)


def enu(text):
    """East and north of an origin, for places at its height."""
    latitude, longitude, height = text.removeprefix("enu:").split(",")
    steps = f"+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84 +step +proj=topocentric +ellps=WGS84 +lat_0={latitude} +lon_0={longitude} +h_0={height}"
    pipeline = Transformer.from_pipeline(steps)
    return lambda x, y: pipeline.transform(x, y, float(height))[:2]


def main():
    earth = CRS("EPSG:4326")
    with open(DATA / "target_frames.csv", "w", newline="") as points, open(DATA / "target_frame_sets.csv", "w", newline="") as sets:
        points, sets = csv.writer(points, lineterminator="\n"), csv.writer(sets, lineterminator="\n")
        points.writerow(["set", "x", "y"])
        sets.writerow(["set", "georeference", "offset_x", "offset_y", "offset_hdg", "x", "y", "crs", "made_by"])
        versions = f"pyproj {pyproj.__version__} with PROJ {pyproj.proj_version_str}"
        for name, text, (dx, dy, turn), (latitude, longitude), target, given in SETS:
            source = crs(text)
            cos, sin, feet = math.cos(turn), math.sin(turn), unit(source)
            x, y = (value * feet for value in transformer(earth, source).transform(longitude, latitude))
            # Back through the header's offset, to whole metres.
            x, y = x - dx, y - dy
            x, y = round(cos * x + sin * y), round(cos * y - sin * x)
            sets.writerow([name, text, dx, dy, turn, x, y, target, versions])
            to_earth = transformer(source, earth)
            from_earth = enu(target) if given == "enu" else transformer(earth, crs(given)).transform
            scale = 1.0 if given == "enu" else unit(crs(given))
            for road in range(ROADS):
                heading = 0.6 * road
                for point in range(POINTS):
                    s = LENGTH * point / (POINTS - 1)
                    px = x + 300.0 * road + s * math.cos(heading)
                    py = y - 200.0 * road + s * math.sin(heading)
                    px, py = cos * px - sin * py + dx, sin * px + cos * py + dy
                    east, north = from_earth(*to_earth.transform(px / feet, py / feet))
                    points.writerow([name, f"{east * scale:.6f}", f"{north * scale:.6f}"])


if __name__ == "__main__":
    main()
