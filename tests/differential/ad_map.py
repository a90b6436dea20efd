#!/usr/bin/env python3
"""Routes, borders and priorities of ad_map_access against mapd's.

usage: ad_map.py MAP.xodr...; wants the packages `ad_map_access` and `ad_physics` and `target/debug/mapd`, or the program that MAPD names.

Between the middles of random lanes both find the shortest route. Where both drive over the same lanes, the borders of ad_map_access's route should lie on
the edges of mapd's corridor, lanes to which mapd yields should go first there (right before left, as in Germany), and lanes that yield to mapd's path should not. A
lane's id is there road · 10000 + (section + 1) · 100 + 50 + lane.

Each difference is put to one of those that README.md explains (`EXPLAINED`); it ends with 1 if one is none of them.
"""
import collections
import csv
import io
import math
import os
import random
import subprocess
import sys

import ad_map_access
import ad_physics  # noqa: F401  (types of the answers)

PAIRS = 100
# Lengths that differ by a smaller share, and borders that lie nearer [m], are the same: ad_map_access cuts its lanes into chords.
SAME_LENGTH, SAME_BORDER = 0.005, 0.10
ROUTE = ["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane"]
# Chords of ad_map_access's borders lie this far from the curve at most [m].
CHORD = 0.20
EXPLAINED = {
    "length": "on a stretch with several lanes one length stands for all of them",
    "only mapd": "a lane is left by a change of lane",
    "border": "a chord of a curve",
    "turn across oncoming traffic": "PriorityToRight knows no rule of turns",
    "from the right": "another lane of the intersection has it on its right",
}
ad = ad_map_access.map


def number(lane):
    return int(str(lane))


def key(lane):
    """(road, section, lane) of an id."""
    n = number(lane)
    return n // 10000, n // 100 % 100 - 1, n % 100 - 50


def ask(mapd, path, kind, names, rows, *options):
    text = io.StringIO()
    out = csv.writer(text)
    out.writerow(names)
    out.writerows(rows)
    done = subprocess.run([mapd, "query", path, kind, *options], input=text.getvalue(), capture_output=True, text=True)
    return list(csv.DictReader(io.StringIO(done.stdout)))


def middle(lane):
    """A point in the middle of a lane."""
    half = ad_map_access.physics.ParametricValue(0.5)
    point = ad.lane.getENULanePoint(ad.point.createParaPoint(lane, half), half)
    return float(str(point.x)), float(str(point.y))


def plan(start, goal):
    half = ad_map_access.physics.ParametricValue(0.5)
    ends = [ad.route.createRoutingParaPoint(lane, half, ad.route.RoutingDirection.DONT_CARE) for lane in (start, goal)]
    return ad.route.planRoute(*ends, ad.route.RouteCreationMode.SameDrivingDirection)


def lanes_of(route):
    """Lanes of a route; of those beside each other any."""
    return [{key(lane.lane_interval.lane_id) for lane in segment.drivable_lane_segments} for segment in route.road_segments]


def from_polyline(points, place):
    """Distance of a place from a polyline whose points follow each other closely."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        share = 0.0 if square == 0 else max(0.0, min(1.0, ((place[0] - ax) * dx + (place[1] - ay) * dy) / square))
        best = min(best, math.hypot(place[0] - ax - share * dx, place[1] - ay - share * dy))
    return best


class Differences:
    """Differences by their explanation, and those without one."""

    def __init__(self):
        self.explained = collections.Counter()
        self.unexplained = []

    def add(self, kind, is_explained, text):
        if kind in EXPLAINED and is_explained:
            self.explained[kind] += 1
        else:
            self.unexplained.append(f"{kind}: {text}")


def compare(mapd, path):
    """The differences on a map."""
    found = Differences()
    ad.access.cleanup()
    ad.access.setLogLevel(ad.access.level_enum.off)
    with open(path, encoding="utf-8") as file:
        kind = ad.intersection.IntersectionType.PriorityToRight
        try:
            read = ad.access.initFromOpenDriveContent(file.read(), 0.05, kind, ad.landmark.TrafficLightType.UNKNOWN)
        except IndexError as error:
            read = print(f"{path}: {error}")
    if not read:
        print(f"{path}: ad_map_access does not read it")
        return found
    source = random.Random(7)
    normal = [lane for lane in ad.lane.getLanes() if str(ad.lane.getLane(lane).type) == "NORMAL" and float(str(ad.lane.getLane(lane).length)) > 2.0]
    normal.sort(key=number)
    points = [middle(lane) for lane in normal]
    places = ask(mapd, path, "nearest", ["x", "y"], points, "--types", "drivable")
    known = {}
    for lane, place in zip(normal, places):
        road, section, own = key(lane)
        if place["lane"] == f"{road}:{section}:{own}":
            known[number(lane)] = [place["road_id"], place["s"], place["lane_id"]]
    tried = [(a, b) for a, b in (source.sample(normal, 2) for _ in range(PAIRS)) if number(a) in known and number(b) in known]
    rows = [known[number(a)] + known[number(b)] for a, b in tried]
    routes = ask(mapd, path, "route", ROUTE, rows, "--lane-change", "0")
    counts = {name: 0 for name in ("same", "shorter", "longer", "only mapd", "only ad_map", "neither")}
    borders = apart = 0
    worst = 0.0
    yielded = agreed = kept = 0
    disagreed = collections.Counter()
    for (start, goal), row, own in zip(tried, rows, routes):
        route = plan(start, goal)
        theirs = lanes_of(route)
        if not theirs or own["error"]:
            kind = "neither" if not theirs and own["error"] else "only ad_map" if theirs else "only mapd"
            counts[kind] += 1
            if kind != "neither":
                found.add(kind, own["lane_changes"] not in ("", "0"), f"{row} {own['error']}")
            continue
        length, other = float(own["length"]), float(str(ad.route.calcLength(route)))
        if abs(length - other) > SAME_LENGTH * max(length, other) + 0.5:
            counts["shorter" if length < other else "longer"] += 1
            found.add("length", any(len(lanes) > 1 for lanes in theirs), f"{row} {length} there {other}")
            continue
        counts["same"] += 1
        ours = [tuple(int(n) for n in lane.split(":")) for lane in own["lanes"].split(";")]
        if [{lane} for lane in ours] != theirs:
            continue
        room = ask(mapd, path, "corridor", ROUTE, [row], "--step", "0.5")
        sides = {side: [(float(s[f"{side}_x"]), float(s[f"{side}_y"])) for s in room] for side in ("left", "right")}
        border = ad.route.getENUBorderOfRoute(route)
        for piece in border:
            for side in ("left", "right"):
                for p in getattr(piece, side).points:
                    borders += 1
                    far = from_polyline(sides[side], (float(str(p.x)), float(str(p.y))))
                    worst = max(worst, far)
                    apart += far > SAME_BORDER
                    if far > SAME_BORDER:
                        found.add("border", far <= CHORD, f"{row} {far:.2f} m {side}")
        meets = ask(mapd, path, "conflicts", ROUTE, [row], "--rules", "DE")
        before = set()
        for crossing in ad.intersection.Intersection.getIntersectionsForRoute(route):
            before |= {":".join(str(n) for n in key(lane)) for lane in crossing.internalLanesWithHigherPriority}
        for conflict in meets:
            if conflict["yields"] == "yields":
                yielded += 1
                agreed += conflict["other_lane"] in before
                if conflict["other_lane"] not in before:
                    found.add("yields", False, f"{row} to {conflict['other_lane']} by {conflict['reason']}")
            elif conflict["yields"] == "priority":
                kept += 1
                if conflict["other_lane"] in before:
                    disagreed[conflict["kind"], conflict["reason"]] += 1
                    found.add(conflict["reason"], conflict["basis"] == "rule", f"{row} {conflict['other_lane']}")
    print(
        f"{path}: {len(known)} of {len(normal)} lanes have the same name, {sum(counts.values())} pairs: "
        + ", ".join(f"{count} {name}" for name, count in counts.items())
        + f"; {borders} points of borders, {apart} apart (by up to {worst:.2f} m); of {yielded} lanes that mapd yields to {agreed} go first there, of {kept} that yield to it {sum(disagreed.values())}"
    )
    for (kind, reason), count in disagreed.items():
        print(f"  {count} of kind {kind}, which yield to mapd's path by {reason}")
    return found


if __name__ == "__main__":
    unexplained = 0
    for file in sys.argv[1:]:
        differences = compare(os.environ.get("MAPD", "target/debug/mapd"), file)
        for kind, count in differences.explained.items():
            print(f"  {count} explained: {kind}, {EXPLAINED[kind]}")
        for text in differences.unexplained:
            print(f"  UNEXPLAINED {text}")
        unexplained += len(differences.unexplained)
    sys.exit(1 if unexplained else 0)
