#!/usr/bin/env python3
"""What others read in the MCAP files of mapd-foxglove, compared with what mapd says of the same maps.

    pip install mcap mcap-protobuf-support pyogrio pyproj shapely
    tests/differential/mcap_files.py --mapd target/debug/mapd --foxglove target/foxglove/debug/mapd-foxglove examples/maps/*.xodr

For each map: the topics are there, once each, with the schemas that Foxglove knows; every road is an entity, and its triangles cover the area
of its lanes as GDAL reads it from mapd's FlatGeobuf; every road with marks and every signal is there, where mapd has it; the place on Earth
is that of the frame's origin as PROJ has it; the bytes are the same when written again. Maps of its own besides: one without lanes, one whose names
are hostile, one that does not fit on the disk, one that is rejected. Ends with 1 where something differs.
"""

import argparse
import collections
import html
import json
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import pyogrio
import pyproj
import shapely
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

TOPICS = {
    "/tf": "foxglove.FrameTransform",
    "/map/location": "foxglove.LocationFix",
    "/map/lanes": "foxglove.SceneUpdate",
    "/map/marks": "foxglove.SceneUpdate",
    "/map/signals": "foxglove.SceneUpdate",
}
# Seconds and nanoseconds since 1970.
TIME, NANOSECONDS = "1700000000.25", 1_700_000_000_250_000_000
# The first that the seconds of Foxglove's messages do not have.
TOO_LATE = str(1 << 32)
# Areas may differ by this part, and by so much besides [m²]: lanes that cross themselves.
AREA, CROSSED = 1e-5, 0.05
# Where GDAL has degrees, areas are those on a sphere [m], which differ by this part.
DEGREES, RADIUS, ON_SPHERE = "EPSG:4326", 6_371_008.8, 0.01
# Places may differ by so much [m].
PLACE = 1e-6
# Places on Earth may differ from PROJ's by so much [m].
ON_EARTH = 1e-3
# The program may write files up to this length [bytes] where the disk is to be full; larger than what it prints.
DISK = 4096
HOSTILE = "</script><b onload=\"x\">'&\\n\u202e"


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    return done.stdout


def layer(mapd, source, name, folder):
    """Rows of a layer, each with its geometry."""
    file = folder / f"{name}.fgb"
    run(mapd, "export", source, "--format", "flatgeobuf", "--layers", name, "-o", file)
    meta, _, geometry, columns = pyogrio.raw.read(file)
    # A box is found by the index, if there is anything to find.
    assert pyogrio.read_info(file)["capabilities"]["fast_spatial_filter"] == bool(len(geometry)), f"index of {name}"
    rows = [dict(zip(meta["fields"], values)) for values in zip(*columns)] if len(columns) else []
    return list(zip(rows, shapely.from_wkb(geometry))), meta["crs"]


def on_sphere(shape):
    """A small shape of longitudes and latitudes in metres."""
    middle = math.radians(shape.centroid.y)
    return shapely.transform(shape, lambda places: places * [math.radians(math.cos(middle)) * RADIUS, math.radians(RADIUS)])


def area(entity):
    """Area in plan view [m²] of an entity's triangles."""
    total = 0.0
    for part in entity.triangles:
        corners = [(part.points[i].x, part.points[i].y) for i in part.indices]
        assert len(part.colors) == len(part.points)
        for (ax, ay), (bx, by), (cx, cy) in zip(corners[::3], corners[1::3], corners[2::3], strict=True):
            total += 0.5 * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))
    return total


def on_earth(mapd, source, crs, place):
    """Longitude and latitude [deg] of a place in the map's frame, by PROJ."""
    if crs == DEGREES:
        # FlatGeobuf has degrees where the map's frame is one that no CRS names.
        crs = json.loads(run(mapd, "inspect", source, "--json"))["map"]["projection"]
    own = pyproj.CRS(crs)
    return pyproj.Transformer.from_crs(own, own.geodetic_crs, always_xy=True).transform(place.x, place.y)


def check_extremes(foxglove, folder):
    """Maps and disks that nobody wants."""
    source, file = folder / "map.xodr", folder / "map.mcap"

    def write(text):
        source.write_text(f'<OpenDRIVE><header revMajor="1" revMinor="7"/>{text}</OpenDRIVE>')
        return subprocess.run([foxglove, source, "-o", file, "--time", TIME], capture_output=True, text=True)

    def read():
        with open(file, "rb") as stream:
            messages = make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages()
            return {channel.topic: decoded for _, channel, _, decoded in messages}

    done = write("")
    assert done.returncode == 0 and "georeference" in done.stderr, done.stderr
    messages = read()
    assert set(messages) == set(TOPICS) - {"/map/location"}, set(messages)
    assert not any(messages[topic].entities for topic in messages if topic != "/tf")

    name = html.escape(HOSTILE)
    line = '<planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView>'
    lanes = '<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>'
    signal = f'<signal id="{name}" name="{name}" s="5" t="-4" dynamic="no" orientation="+" zOffset="1" country="DE" type="206" subtype="-1"/>'
    road = f'<road id="{name}" name="{name}" length="9" junction="-1">{line}<lanes><laneSection s="0">{lanes}</laneSection></lanes><signals>{signal}</signals></road>'
    done = write(road)
    assert done.returncode == 0, done.stderr
    messages = read()
    (entity,), (sign,) = messages["/map/lanes"].entities, messages["/map/signals"].entities
    told = lambda one: {pair.key: pair.value for pair in one.metadata}
    assert entity.id == f"road {HOSTILE}" and told(entity)["name"] == told(sign)["name"] == told(sign)["signal"] == HOSTILE, (entity.id, told(sign))

    # A disk that is full: what was there stays, and nothing is left beside it.
    whole = file.read_bytes()
    many = "".join(road.replace(name, f"{name}{number}") for number in range(500))
    full = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (DISK, DISK))
    source.write_text(f'<OpenDRIVE><header revMajor="1" revMinor="7"/>{many}</OpenDRIVE>')
    # Python ignores the signal of a file that is too large, and so do its children.
    done = subprocess.run([foxglove, source, "-o", file], capture_output=True, text=True, preexec_fn=full, restore_signals=False)
    assert done.returncode == 1, done
    assert re.fullmatch(r"(mapd-foxglove: the map has no georeference.*\n)?mapd-foxglove: writing .*map\.mcap: File too large.*\n", done.stderr), done.stderr
    assert file.read_bytes() == whole and {one.name for one in folder.iterdir()} == {"map.xodr", "map.mcap"}

    done = write("<road/>")
    assert done.returncode == 4 and "mapd check" in done.stderr, done
    print("maps of its own: fine")


def check(mapd, foxglove, source, folder):
    files = [folder / "a.mcap", folder / "b.mcap"]
    for file in files:
        run(foxglove, source, "-o", file, "--time", TIME)
    assert files[0].read_bytes() == files[1].read_bytes(), "other bytes"
    refused = subprocess.run([foxglove, source, "-o", folder / "late.mcap", "--time", TOO_LATE], capture_output=True, text=True)
    assert refused.returncode != 0 and "2106" in refused.stderr, refused.stderr
    assert not (folder / "late.mcap").exists()
    messages = {}
    with open(files[0], "rb") as stream:
        for schema, channel, message, decoded in make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            assert channel.topic not in messages, f"{channel.topic} twice"
            assert schema.name == TOPICS[channel.topic], schema.name
            assert message.log_time == NANOSECONDS, message.log_time
            messages[channel.topic] = decoded
    lanes, crs = layer(mapd, source, "lanes", folder)
    signals, _ = layer(mapd, source, "signals", folder)
    borders, _ = layer(mapd, source, "borders", folder)
    assert set(messages) == {topic for topic in TOPICS if crs or topic != "/map/location"}, set(messages)
    middle = messages["/tf"].translation
    entities = {one.id: one for topic in TOPICS if "map/" in topic and topic in messages for one in getattr(messages[topic], "entities", [])}
    assert all(one.frame_id == messages["/tf"].child_frame_id for one in entities.values())

    areas = collections.defaultdict(float)
    for row, shape in lanes:
        if not row["is_temporary"]:
            areas[row["road"]] += (on_sphere(shape) if crs == DEGREES else shape).area
    assert areas.keys() == {name[5:] for name in entities if name.startswith("road ")}
    for road, expected in areas.items():
        found = area(entities[f"road {road}"])
        assert abs(found - expected) <= (ON_SPHERE if crs == DEGREES else AREA) * expected + CROSSED, f"road {road}: {found} m², not {expected}"
    marked = {row["road"] for row, _ in borders if row["mark"] not in (None, "none") and not row["is_temporary"]}
    drawn = {name[6:] for name in entities if name.startswith("marks ")}
    assert drawn <= marked, drawn - marked
    assert marked <= drawn, marked - drawn

    assert len(messages["/map/signals"].entities) == len(signals)
    for one in messages["/map/signals"].entities:
        told = {pair.key: pair.value for pair in one.metadata}
        own = [(row, shape) for row, shape in signals if row["id"] == told["signal"] and row["class"] == told["class"]]
        assert own, told
        (board,), (text,) = one.cubes, one.texts
        place = board.pose.position
        lower = place.z - 0.5 * board.size.z + middle.z
        away = min(math.dist((place.x + middle.x, place.y + middle.y, lower), shape.coords[0]) for _, shape in own)
        # Where the file has a frame of its own, the map's is moved and turned in it.
        assert crs or away <= PLACE, f"signal {told['signal']}: {away} m away"
        assert text.text.startswith(told["class"]), text.text
    if crs:
        fix = messages["/map/location"]
        assert fix.frame_id == messages["/tf"].child_frame_id
        expected = on_earth(mapd, source, crs, middle)
        away = pyproj.Geod(ellps="WGS84").inv(fix.longitude, fix.latitude, *expected)[2]
        assert away <= ON_EARTH, f"/map/location is {away} m away from {expected}"
    print(f"{source}: {len(areas)} roads, {len(drawn)} with marks, {len(signals)} signals, {files[0].stat().st_size} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mapd", default="target/debug/mapd")
    parser.add_argument("--foxglove", default="target/foxglove/debug/mapd-foxglove")
    parser.add_argument("maps", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        try:
            check_extremes(options.foxglove, pathlib.Path(folder))
        except AssertionError as error:
            print(f"maps of its own: WRONG: {error}")
            failed = True
    for source in options.maps:
        with tempfile.TemporaryDirectory() as folder:
            try:
                check(options.mapd, options.foxglove, source, pathlib.Path(folder))
            except AssertionError as error:
                print(f"{source}: WRONG: {error}")
                failed = True
    sys.exit(failed)


if __name__ == "__main__":
    main()
