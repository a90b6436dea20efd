#!/usr/bin/env python3
"""The way ahead of CARLA's own map library against mapd's paths.

usage: paths.py MAP.xodr...; wants the package `carla` and `target/debug/mapd`, or the program that MAPD names.

From random places CARLA drives on by `next(2 m)`, at forks by any way. mapd finds the route from the first of the waypoints to the last and projects
all of them on its path: they should lie on the driven line, in the same order, with its heading. CARLA's y points the other way.
"""
import csv
import io
import math
import os
import random
import subprocess
import sys

import carla

STARTS = 200
STEPS = 25
STEP = 2.0
# Offset from the line [m] and difference of heading [rad] that count as the same.
SAME, TURNED = 0.05, 0.02


def drive(places, source):
    """Waypoints of one way."""
    start = source.choice(places)
    way = [start]
    for _ in range(STEPS):
        following = way[-1].next(STEP)
        if not following:
            break
        way.append(source.choice(following))
    return way


def rows(mapd, path, ways):
    names = ["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane", "x", "y", "hdg", "way"]
    text = io.StringIO()
    out = csv.writer(text)
    out.writerow(names)
    for number, way in enumerate(ways):
        first, last = way[0], way[-1]
        for waypoint in way:
            place, heading = waypoint.transform.location, -math.radians(waypoint.transform.rotation.yaw)
            out.writerow([first.road_id, first.s, first.lane_id, last.road_id, last.s, last.lane_id, place.x, -place.y, heading, number])
    found = subprocess.run([mapd, "query", path, "project"], input=text.getvalue(), capture_output=True, text=True)
    return list(csv.DictReader(io.StringIO(found.stdout)))


def compare(mapd, path):
    with open(path, encoding="utf-8") as file:
        world = carla.Map("map", file.read())
    source = random.Random(7)
    all_places = world.generate_waypoints(10.0)
    ways = [drive(all_places, source) for _ in range(STARTS)]
    ways = [way for way in ways if len(way) > 3]
    answers = rows(mapd, path, ways)
    same = apart = turned = none = behind = 0
    worst, last = 0.0, {}
    for row in answers:
        if row["error"]:
            none += 1
            continue
        s, offset, heading = float(row["S"]), float(row["d"]), float(row["heading_difference"])
        if s < last.get(row["way"], 0.0) - 0.01:
            behind += 1
        last[row["way"]] = s
        if abs(offset) > SAME:
            apart += 1
            worst = max(worst, abs(offset))
        elif abs(heading) > TURNED:
            turned += 1
        else:
            same += 1
    print(f"{path}: {len(ways)} ways, {same} waypoints alike, {apart} off the line (by up to {worst:.2f} m), {turned} turned, {behind} behind, {none} without an answer")
    return same, apart + turned + behind + none


if __name__ == "__main__":
    program = os.environ.get("MAPD", "target/debug/mapd")
    counted = [compare(program, path) for path in sys.argv[1:]]
    sys.exit(0 if counted and all(same > 0 and other == 0 for same, other in counted) else 1)
