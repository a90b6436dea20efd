"""Golden figures of map projections: `tests/data/projections.csv` and `tests/data/georeferences.csv`.

    pip install -r requirements.txt
    python3 projections.py            # writes both; the second needs ../shared

Each definition is asked for points of a rectangle of latitudes and longitudes that the Rust test computes by the same
formula, so that only the answers are stored: x and y in metres, to a tenth of a millimetre.
"""

import csv
import math
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import pyproj
from pyproj import CRS, Transformer

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "tests" / "data"
SHARED = ROOT.parent / "shared" / "maps"
MANY, FEW = 500, 60
# A prime, so that points spread over the rectangle and do not repeat.
MODULUS = 10_007

NZTM_WKT1 = (
    'PROJCS["NZGD2000 / New Zealand Transverse Mercator 2000",GEOGCS["NZGD2000",DATUM["New_Zealand_Geodetic_Datum_2000",'
    'SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],'
    'PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",173],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",1600000],PARAMETER["false_northing",10000000],'
    'UNIT["metre",1]]'
)
UTM_WKT2 = (
    'PROJCRS["WGS 84 / UTM zone 32N",BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",'
    'ELLIPSOID["WGS 84",6378137,298.257223563,LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,'
    'ANGLEUNIT["degree",0.0174532925199433]]],CONVERSION["UTM zone 32N",METHOD["Transverse Mercator",ID["EPSG",9807]],'
    'PARAMETER["Latitude of natural origin",0,ANGLEUNIT["degree",0.0174532925199433]],'
    'PARAMETER["Longitude of natural origin",9,ANGLEUNIT["degree",0.0174532925199433]],'
    'PARAMETER["Scale factor at natural origin",0.9996,SCALEUNIT["unity",1]],'
    'PARAMETER["False easting",500000,LENGTHUNIT["metre",1]],PARAMETER["False northing",0,LENGTHUNIT["metre",1]]],'
    'CS[Cartesian,2],AXIS["(E)",east,ORDER[1],LENGTHUNIT["metre",1]],AXIS["(N)",north,ORDER[2],LENGTHUNIT["metre",1]],'
    'ID["EPSG",32632]]'
)
MASS_FEET_WKT1 = (
    'PROJCS["NAD83 / Massachusetts Mainland (ftUS)",GEOGCS["NAD83",DATUM["North_American_Datum_1983",'
    'SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],'
    'PROJECTION["Lambert_Conformal_Conic_2SP"],PARAMETER["standard_parallel_1",42.68333333333333],'
    'PARAMETER["standard_parallel_2",41.71666666666667],PARAMETER["latitude_of_origin",41],'
    'PARAMETER["central_meridian",-71.5],PARAMETER["false_easting",656166.6666666665],'
    'PARAMETER["false_northing",2460625],UNIT["US survey foot",0.3048006096012192]]'
)
# name, georeference, what pyproj is given where it differs, number of points, south, north, west, east
SETS = [
    ("utm", "+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs", None, MANY, 40.0, 60.0, 5.0, 13.0),
    ("tmerc", "+proj=tmerc +lat_0=37.4168716 +lon_0=-122.1030492 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs", None, MANY, 36.0, 39.0, -124.0, -120.0),
    ("lcc", "+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80 +towgs84=0,0,0 +units=m", None, MANY, 42.0, 51.0, -4.0, 8.0),
    ("merc", "+proj=merc +lat_ts=45 +lon_0=10 +x_0=0 +y_0=0 +datum=WGS84 +units=m", None, MANY, -60.0, 60.0, -20.0, 40.0),
    ("aeqd", "+proj=aeqd +lat_0=48.1 +lon_0=11.6 +x_0=0 +y_0=0 +datum=WGS84 +units=m", None, MANY, 46.0, 50.0, 9.0, 14.0),
    ("stere", "+proj=stere +lat_0=52.2 +lon_0=19.1 +k=0.9996 +x_0=500000 +y_0=300000 +datum=WGS84 +units=m", None, MANY, 49.0, 55.0, 14.0, 24.0),
    ("somerc", "+proj=somerc +lat_0=46.9524055555556 +lon_0=7.43958333333333 +k_0=1 +x_0=2600000 +y_0=1200000 +ellps=bessel +towgs84=674.374,15.056,405.346,0,0,0,0 +units=m +no_defs", None, MANY, 45.8, 47.8, 5.9, 10.5),
    ("south", "+proj=utm +zone=56 +south +datum=WGS84", None, FEW, -40.0, -20.0, 150.0, 156.0),
    ("bare_utm", "+proj=utm +zone=33", None, FEW, 45.0, 55.0, 12.0, 18.0),
    ("beyond_zone", "+proj=utm +zone=32 +datum=WGS84", None, FEW, 47.0, 55.0, 11.5, 12.5),
    ("false_easting", "+proj=tmerc +lat_0=-33 +lon_0=151 +k=0.99994 +x_0=4500000 +y_0=-250000.5 +ellps=GRS80", None, FEW, -35.0, -31.0, 149.0, 153.0),
    ("us_feet", "+proj=lcc +lat_0=41 +lon_0=-71.5 +lat_1=42.6833333333333 +lat_2=41.7166666666667 +x_0=200000 +y_0=750000 +ellps=GRS80 +towgs84=0,0,0 +units=us-ft +no_defs", None, FEW, 41.5, 43.0, -73.5, -70.0),
    ("feet", "+proj=tmerc +lat_0=42.5 +lon_0=-72.5 +k=0.999964286 +x_0=500000.00001016 +y_0=0 +ellps=GRS80 +to_meter=0.3048", None, FEW, 42.7, 45.0, -73.4, -71.5),
    ("seven_parameters", "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m", None, FEW, 47.5, 54.5, 8.0, 10.5),
    ("named_datum", "+proj=tmerc +lat_0=0 +lon_0=12 +k=1 +x_0=4500000 +y_0=0 +datum=potsdam +units=m", "+proj=tmerc +lat_0=0 +lon_0=12 +k=1 +x_0=4500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7", FEW, 48.0, 54.0, 10.6, 13.4),
    ("unknown_datum", "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +y_0=0 +ellps=bessel +units=m", None, FEW, 47.5, 54.5, 8.0, 10.5),
    ("web_mercator", "EPSG:3857", None, FEW, -60.0, 60.0, -150.0, 150.0),
    ("epsg", "epsg:25832", None, FEW, 47.0, 55.0, 6.0, 12.0),
    ("epsg_init", "+init=epsg:32756", "EPSG:32756", FEW, -40.0, -20.0, 150.0, 156.0),
    ("epsg_urn", "urn:ogc:def:crs:EPSG::2154", "EPSG:2154", FEW, 42.0, 51.0, -4.0, 8.0),
    ("carla", "+lat_0=4.9000000000000000e+1 +lon_0=8.0000000000000000e+0", "+proj=tmerc +lat_0=49 +lon_0=8 +datum=WGS84", FEW, 48.9, 49.1, 7.9, 8.1),
    ("wkt1", NZTM_WKT1, None, FEW, -47.0, -34.5, 167.0, 178.0),
    ("wkt2", UTM_WKT2, None, FEW, 47.0, 55.0, 6.0, 12.0),
    ("wkt1_us_feet", MASS_FEET_WKT1, None, FEW, 41.5, 43.0, -73.5, -70.0),
]


def transformer(definition):
    """From WGS 84 to a plane, without heights."""
    return Transformer.from_crs(CRS("EPSG:4326"), CRS(definition), always_xy=True, only_best=False, allow_ballpark=True)


def unit(definition):
    """Metres of the plane's unit."""
    return CRS(definition).axis_info[0].unit_conversion_factor


def places(count, south, north, west, east):
    for i in range(count):
        u, v = (i * 7919 % MODULUS) / MODULUS, (i * 104729 % MODULUS) / MODULUS
        yield south + (north - south) * u, west + (east - west) * v


def projections():
    with open(DATA / "projections.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["set", "x", "y"])
        for name, text, other, count, south, north, west, east in SETS:
            definition = other or text
            to_plane, metres = transformer(definition), unit(definition)
            for lat, lon in places(count, south, north, west, east):
                x, y = to_plane.transform(lon, lat, errcheck=True)
                out.writerow([name, f"{x * metres:.4f}", f"{y * metres:.4f}"])
    with open(DATA / "projection_sets.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["set", "georeference", "count", "south", "north", "west", "east", "made_by"])
        made = f"pyproj {pyproj.__version__} with PROJ {pyproj.proj_version_str}"
        for name, text, _, *numbers in SETS:
            out.writerow([name, text, *numbers, made])


def as_pyproj_wants(text):
    """A georeference of the wild as a plain two-dimensional definition."""
    if "proj=" not in text:
        text = "+proj=tmerc +datum=WGS84 " + text
    return re.sub(r"\+(geoidgrids|vunits)=\S+", "", text)


def georeferences():
    """Some starts of geometries of each map that has a georeference."""
    rows = []
    for path in sorted(SHARED.glob("*/*.xodr")):
        try:
            text = path.read_text(encoding="utf-8-sig", errors="replace")
            # Some have comments before their XML declaration.
            root = ElementTree.fromstring(text[max(0, text.find("<OpenDRIVE")) :])
        except ElementTree.ParseError:
            continue
        for element in root.iter():
            element.tag = element.tag.split("}")[-1]
        text = (root.findtext("header/geoReference") or "").strip()
        if not text:
            continue
        offset = root.find("header/offset")
        number = lambda name: float(offset.get(name, 0)) if offset is not None else 0.0
        x0, y0 = number("x"), number("y")
        assert number("hdg") == 0.0
        if path.stem.endswith("netconvert"):
            x0, y0 = -x0, -y0
        crs = CRS(as_pyproj_wants(text))
        to_earth = Transformer.from_crs(crs, CRS("EPSG:4326"), always_xy=True)
        points = [(float(g.get("x")), float(g.get("y"))) for g in root.iter("geometry") if g.get("x")]
        points = [p for p in points if all(map(math.isfinite, p))]
        for x, y in points[:: max(1, len(points) // 12)][:12]:
            lon, lat = to_earth.transform(x + x0, y + y0, errcheck=True)
            rows.append([f"{path.parent.name}/{path.stem}", x, y, f"{lat:.12f}", f"{lon:.12f}"])
    with open(DATA / "georeferences.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["map", "x", "y", "lat", "lon"])
        out.writerows(rows)


if __name__ == "__main__":
    DATA.mkdir(exist_ok=True)
    projections()
    if SHARED.is_dir():
        georeferences()
    else:
        sys.exit("../shared is not there: georeferences.csv stays as it is")
