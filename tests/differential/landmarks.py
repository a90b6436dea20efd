#!/usr/bin/env python3
"""The landmarks ahead that CARLA's own map library finds against mapd's signals ahead.

usage: landmarks.py MAP.xodr...; wants the package `carla` and `target/debug/mapd`, or the program that MAPD names; `--each` tells every difference.

From random waypoints CARLA looks 100 m ahead by `get_landmarks`, mapd by `query signals`: the same signals should be found, as far away. A signal that is found over
several ways counts once, by the shortest. Each difference has a reason of the table in README.md; one without any ends the run with an error.
"""
import collections
import csv
import io
import os
import random
import subprocess
import sys
import xml.etree.ElementTree as xml

import carla

STARTS = 300
AHEAD = 100.0
# Distances that differ by less are the same [m].
SAME = 0.5
# CARLA counts s of the reference line, mapd metres of the driven one: in bends they differ by up to this share.
BEND = 0.15


def written(path):
    """Of each signal its orientations and the lanes that are named, there and where it is referred to; the ids of several; and those of objects."""
    signals, seen, objects = collections.defaultdict(set), collections.Counter(), set()
    for road in xml.parse(path).getroot().iter("road"):
        for kind in ("signal", "signalReference"):
            for signal in road.iter(kind):
                lanes = {(own.get("fromLane"), own.get("toLane")) for own in signal.iter("validity")}
                signals[signal.get("id")].add((signal.get("orientation"), frozenset(lanes)))
        seen.update(signal.get("id") for signal in road.iter("signal"))
        objects |= {thing.get("id") for thing in road.iter("object")}
    return signals, {name for name, count in seen.items() if count > 1}, objects


def ask(mapd, path, places):
    text = io.StringIO()
    out = csv.writer(text)
    out.writerow(["road_id", "s", "lane_id", "distance", "start"])
    for number, place in enumerate(places):
        out.writerow([place.road_id, place.s, place.lane_id, AHEAD, number])
    found = subprocess.run([mapd, "query", path, "signals"], input=text.getvalue(), capture_output=True, text=True)
    answers = collections.defaultdict(dict)
    for row in csv.DictReader(io.StringIO(found.stdout)):
        if row["id"] and not row["error"]:
            own, distance = answers[int(row["start"])], float(row["distance"])
            own[row["id"]] = min(distance, own.get(row["id"], distance))
    return answers


def look(place):
    """Distance and lane of each landmark that CARLA finds, by its id."""
    least = {}
    for mark in place.get_landmarks(AHEAD, False):
        if mark.id not in least or mark.distance < least[mark.id][0]:
            least[mark.id] = (mark.distance, mark.waypoint.lane_id)
    return least


def reason(name, theirs, ours, facts):
    """Why both differ about a signal, as the table in README.md has it; none that is known: empty."""
    signals, several, objects = facts
    places = signals.get(name)
    if places is None:
        return "made of an object" if ours is None and name in objects else ""
    if name in several:
        return "one id, several signals"
    if theirs and ours is not None:
        return "s for metres" if abs(theirs[0] - ours) <= BEND * max(theirs[0], ours) else ""
    if (theirs[0] if theirs else ours) >= (1.0 - BEND) * AHEAD:
        return "about 100 m"
    named, orientations = frozenset().union(*(lanes for _, lanes in places)), {way for way, _ in places}
    if named == {("0", "0")} and theirs is None:
        return "lane 0 alone"
    if not named and orientations <= {"+", "-"}:
        # What CARLA finds lies on the lanes of the other direction.
        other = theirs is None or any((theirs[1] > 0) == (way == "+") for way in orientations)
        return "orientation" if other else ""
    return ""


def compare(mapd, path, each):
    with open(path, encoding="utf-8") as file:
        world = carla.Map("map", file.read())
    facts, places = written(path), world.generate_waypoints(5.0)
    places = random.Random(7).sample(places, min(STARTS, len(places)))
    answers = ask(mapd, path, places)
    same, differ = 0, collections.Counter()
    for number, place in enumerate(places):
        theirs, ours = look(place), answers[number]
        for name in sorted(theirs.keys() | ours.keys()):
            a, b = theirs.get(name), ours.get(name)
            if a and b is not None and abs(a[0] - b) <= SAME:
                same += 1
                continue
            why = reason(name, a, b, facts)
            differ[why] += 1
            if each or not why:
                print(f"  {place.road_id}:{place.section_id}:{place.lane_id} s {place.s:.2f}: signal {name}, CARLA {a}, mapd {b}: {why or 'NOT EXPLAINED'}")
    print(f"{path}: {same} alike, " + (", ".join(f"{count} {why}" for why, count in differ.most_common()) or "no difference"))
    return same > 0 and "" not in differ


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if argument != "--each"]
    program = os.environ.get("MAPD", "target/debug/mapd")
    explained = [compare(program, path, "--each" in sys.argv) for path in arguments]
    sys.exit(0 if explained and all(explained) else 1)
