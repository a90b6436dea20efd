#!/usr/bin/env python3
"""Routes, borders and priorities of ad_map_access against mapd's.

usage: ad_map.py MAP.xodr...; wants the packages `ad_map_access` and `ad_physics` and `target/debug/mapd`, or the program that MAPD names.

Between the middles of random lanes both find the shortest route. Where both drive over the same lanes, the borders of ad_map_access's route should lie on
the edges of mapd's corridor. Where the path passes one of its intersections, lanes to which mapd yields should go first there (right before left, as in Germany), and lanes
that yield to mapd's path should not. A lane's id is there road · 10000 + (section + 1) · 100 + 50 + lane.

Each difference is put to one of the reasons in `EXPLAINED`, which README.md lists, if the check of that reason holds for it; the program ends with 1 if one has none.
"""
import collections
import csv
import functools
import io
import math
import os
import random
import subprocess
import sys
import xml.etree.ElementTree as xml

import ad_map_access
import ad_physics  # noqa: F401  (types of the answers)

PAIRS = 100
# Lengths that differ by a smaller share, and borders that lie nearer [m], are the same: ad_map_access cuts its lanes into chords.
SAME_LENGTH, SAME_BORDER = 0.005, 0.10
ROUTE = ["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane"]
# Headings that differ by more come from the side, by more than thrice as much from ahead [rad]: as mapd has it.
BESIDE = math.pi / 4
# Each edge's middle is where half of its own length is: in a bend by up to this far before or beyond the middle of the lane [m].
BEYOND = 0.5
# Distance of stations of corridor and path [m].
STEP = 0.5
EXPLAINED = {
    "least length": "of lanes side by side ad_map_access counts the shortest; its own lengths of the lanes that mapd drives add up to mapd's",
    "another way": "the shortest way is another one where of lanes side by side the shortest counts",
    "not the shortest": "ad_map_access's own routes from lane to lane along mapd's way add up to less than its route does",
    "no link": "ad_map_access has no link between two lanes that follow each other on mapd's way, or lacks one of them",
    "behind": "the goal lies behind the start on the same stretch: mapd drives round, ad_map_access not at all",
    "forbidden change": "ad_map_access's way needs a change of lane that mapd does not find on its stretch: the road marks forbid it",
    "bidirectional": "mapd leaves a lane for both directions by a change of lane, ad_map_access does not",
    "no rule of turns": "by ad_map_access's own headings the lane comes from ahead, and `PriorityToRight` knows no rule of turns",
    "own headings": "by ad_map_access's own headings the lane comes from that side, but it lists it otherwise",
    "no normal lane": "ad_map_access does not take the lane for one that is driven on",
    "beyond the end": "in a bend ad_map_access ends each border at half of its own length, mapd straight across from the other one: the point lies straight on beyond mapd's edge",
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


def metres(distance):
    return float(str(distance))


def segments_of(route):
    """Of each stretch of a route the lanes, each with its length there; of those side by side any may be driven."""
    lengths = ad.route.calcLength
    return [{key(own.lane_interval.lane_id): metres(lengths(own.lane_interval)) for own in part.drivable_lane_segments} for part in route.road_segments]


def driven_there(ours, segments):
    """Least and largest length of mapd's way by ad_map_access's own lengths, which differ where lanes change; none if the way leads over other lanes."""
    least, most, at = 0.0, 0.0, 0
    for part in segments:
        driven = []
        while at < len(ours) and ours[at] in part:
            driven.append(part[ours[at]])
            at += 1
        if not driven:
            return None
        least, most = least + min(driven), most + max(driven)
    return (least, most) if at == len(ours) else None


def missing_link(ours, by_key):
    """The first two lanes of a way between which ad_map_access has no link; none if there are none."""
    for one, following in zip(ours, ours[1:]):
        if one not in by_key or following not in by_key:
            return one, following
        contacts = ad.lane.getLane(by_key[one]).contact_lanes
        if following not in {key(contact.to_lane) for contact in contacts}:
            return one, following
    return None


def leaves_bidirectional(ours, by_key):
    """Whether a way leaves or enters a lane for both directions by a change of lane."""
    changes = [pair for pair in zip(ours, ours[1:]) if pair[0][:2] == pair[1][:2]]
    both = {one for pair in changes for one in pair if one in by_key and str(ad.lane.getLane(by_key[one]).direction) in ("BIDIRECTIONAL", "REVERSABLE")}
    return bool(both)


def why_one_alone(ours, by_key):
    """Why mapd alone finds a way."""
    if missing_link(ours, by_key):
        return "no link"
    return "bidirectional" if leaves_bidirectional(ours, by_key) else ""


def needs_forbidden_change(mapd, path, start, segments):
    """Whether no lanes lead along a way by mapd's links and by changes that it finds on the same stretch."""
    sections = sections_of(path)
    on = {start}
    for part, following in zip(segments, segments[1:] + [None]):
        pairs, ends = [(a, b) for a in part for b in part if a != b and a[:2] == b[:2]], {}
        for road, section, lane in part:
            begin, end = sections[road][section]
            # Lanes with positive numbers run against s where one keeps right.
            ends[road, section, lane] = (begin, end) if lane < 0 else (end, begin)
        rows = [[a[0], ends[a][0], a[2], b[0], ends[b][1], b[2]] for a, b in pairs]
        found = ask(mapd, path, "route", ROUTE, rows, "--lane-change", "0") if rows else []
        # On a way round one would come back to the same stretch.
        leads = {(a, b) for (a, b), own in zip(pairs, found) if own["lanes"] and all(lane.startswith(f"{a[0]}:{a[1]}:") for lane in own["lanes"].split(";"))}
        on |= {b for a, b in leads if a in on}
        if following is None:
            return False
        rows = [[a[0], sum(ends[a]) / 2, a[2]] for a in on if a in ends]
        names = ";".join(own["successors"] for own in ask(mapd, path, "successors", ["road_id", "s", "lane_id"], rows)) if rows else ""
        on = {tuple(int(n) for n in name.split(":")) for name in names.split(";") if name} & set(following)
        if not on:
            return True
    return False


@functools.cache
def sections_of(path):
    """The ends of each lane section, by the number of its road."""
    found = {}
    for road in xml.parse(path).getroot().iter("road"):
        begins = [float(section.get("s")) for section in road.iter("laneSection")]
        found[int(road.get("id"))] = list(zip(begins, begins[1:] + [float(road.get("length"))]))
    return found


def why_other_length(mapd, path, length, ours, segments, by_key):
    """Why both find a way, of different lengths."""
    if len(segments) == 1 and ours[0][:2] == ours[-1][:2] and any(lane[:2] != ours[0][:2] for lane in ours):
        return "behind"
    there = driven_there(ours, segments)
    if there is not None:
        return "least length" if there[0] < length < there[1] or any(is_same(length, end) for end in there) else ""
    # Their way is in truth as long as the lanes that are driven: no shorter than mapd's, and no longer than this.
    longest, least = (sum(of(part.values()) for part in segments) for of in (max, min))
    if least < length and (length < longest or is_same(length, longest)):
        return "another way"
    reason = why_one_alone(ours, by_key)
    legs = None if reason else length_by_legs(ours, by_key)
    # Where lanes change, the shortest counts here, too.
    changes = any(one[:2] == following[:2] for one, following in zip(ours, ours[1:]))
    if legs is not None and (changes and legs < length or is_same(length, legs)) and legs < least:
        return "not the shortest"
    if not reason and length > least and needs_forbidden_change(mapd, path, ours[0], segments):
        return "forbidden change"
    return reason


def length_by_legs(ours, by_key):
    """What ad_map_access's own routes from the middle of each lane of a way to that of the next add up to; none if it finds none of them."""
    total = 0.0
    for one, following in zip(ours, ours[1:]):
        if one[:2] == following[:2]:
            # A change of lane is driven for no length.
            continue
        route = plan(by_key[one], by_key[following])
        if not segments_of(route):
            return None
        total += metres(ad.route.calcLength(route))
    return total


def is_same(length, other):
    return abs(length - other) <= SAME_LENGTH * max(length, other) + 0.5


def from_polyline(points, place):
    """Distance of a place from a polyline whose points follow each other closely."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        share = 0.0 if square == 0 else max(0.0, min(1.0, ((place[0] - ax) * dx + (place[1] - ay) * dy) / square))
        best = min(best, math.hypot(place[0] - ax - share * dx, place[1] - ay - share * dy))
    return best


def is_beyond_end(points, place):
    """Whether a place lies straight on beyond an end of a polyline."""
    for end, before in ((points[0], points[1]), (points[-1], points[-2])):
        dx, dy = end[0] - before[0], end[1] - before[1]
        length = math.hypot(dx, dy)
        ahead = ((place[0] - end[0]) * dx + (place[1] - end[1]) * dy) / length
        beside = ((place[1] - end[1]) * dx - (place[0] - end[0]) * dy) / length
        if 0.0 < ahead < BEYOND and abs(beside) <= SAME_BORDER:
            return True
    return False


class Differences:
    """Differences by their explanation, and those without one."""

    def __init__(self):
        self.explained = collections.Counter()
        self.unexplained = []

    def add(self, reason, text):
        if reason in EXPLAINED:
            self.explained[reason] += 1
        else:
            self.unexplained.append(text)


def read(path):
    """Whether ad_map_access reads a map; that becomes its only one."""
    ad.access.cleanup()
    ad.access.setLogLevel(ad.access.level_enum.off)
    kind = ad.intersection.IntersectionType.PriorityToRight
    with open(path, encoding="utf-8") as file:
        try:
            return ad.access.initFromOpenDriveContent(file.read(), 0.05, kind, ad.landmark.TrafficLightType.UNKNOWN)
        except IndexError as error:
            print(f"{path}: {error}")
            return False


def compare_borders(route, room, found):
    """Compares both borders of a route with the edges of a corridor; how many points, and how many of them are apart."""
    sides = {side: [(float(s[f"{side}_x"]), float(s[f"{side}_y"])) for s in room] for side in ("left", "right")}
    points, apart = 0, []
    for piece in ad.route.getENUBorderOfRoute(route):
        for side in ("left", "right"):
            for p in getattr(piece, side).points:
                points += 1
                place = (metres(p.x), metres(p.y))
                far = from_polyline(sides[side], place)
                if far > SAME_BORDER:
                    found.add("beyond the end" if is_beyond_end(sides[side], place) else "", f"border {far:.2f} m {side} of {place}")
                    apart.append(far)
    return points, apart


def heading(lane):
    """Heading of a lane's traffic where the lane begins, by ad_map_access's own points."""
    begin = 1.0 if str(ad.lane.getLane(lane).direction) == "NEGATIVE" else 0.0
    return metres(ad.lane.getLaneENUHeading(ad.point.createParaPoint(lane, ad_map_access.physics.ParametricValue(begin))))


def why_other_priority(one, own, inner, by_key):
    """Why mapd and ad_map_access differ about who goes first where the path meets a lane; `own` is the path's first lane of the intersection."""
    other = tuple(int(n) for n in one["other_lane"].split(":"))
    if other not in by_key or str(ad.lane.getLane(by_key[other]).type) not in ("NORMAL", "INTERSECTION") or one["other_lane"] not in inner:
        return "no normal lane"
    turned = (heading(by_key[other]) - heading(own) + math.pi) % (2 * math.pi) - math.pi
    if one["reason"].startswith("turn"):
        return "no rule of turns" if abs(turned) >= 3 * BESIDE else ""
    from_right = BESIDE < turned < 3 * BESIDE
    from_left = BESIDE < -turned < 3 * BESIDE
    return "own headings" if (from_right if one["yields"] == "yields" else from_left) else ""


def compare_priorities(route, stations, meets, row, by_key, found, counted):
    """Compares who goes first where the path passes an intersection."""
    name = lambda lane: ":".join(str(n) for n in key(lane))
    for crossing in ad.intersection.Intersection.getIntersectionsForRoute(route):
        own = {name(lane) for lane in crossing.lanesOnRoute}
        inside = [(float(s["S"]), s["lane"]) for s in stations if s["lane"] in own]
        if not inside:
            continue
        entered = by_key[tuple(int(n) for n in min(inside)[1].split(":"))]
        inner = {name(lane) for lane in crossing.internalLanes}
        first = {name(lane) for lane in crossing.internalLanesWithHigherPriority}
        for one in meets:
            # The same intersection may be passed again, by other lanes.
            if one["yields"] not in ("yields", "priority") or not min(inside)[0] - STEP <= float(one["S_from"]) <= max(inside)[0] + STEP:
                continue
            goes_first = one["other_lane"] in first
            counted[one["yields"]] += 1
            if goes_first != (one["yields"] == "yields"):
                reason = why_other_priority(one, entered, inner, by_key)
                found.add(reason, f"{row} {one['yields']} to {one['other_lane']} by {one['reason']}, there {'first' if goes_first else 'not first'}")


def compare(mapd, path):
    """The differences on a map."""
    found = Differences()
    if not read(path):
        print(f"{path}: ad_map_access does not read it")
        return found
    source = random.Random(7)
    by_key = {key(lane): lane for lane in ad.lane.getLanes()}
    normal = [lane for lane in ad.lane.getLanes() if str(ad.lane.getLane(lane).type) == "NORMAL" and metres(ad.lane.getLane(lane).length) > 2.0]
    normal.sort(key=number)
    places = ask(mapd, path, "nearest", ["x", "y"], [middle(lane) for lane in normal], "--types", "drivable")
    known = {}
    for lane, place in zip(normal, places):
        road, section, own = key(lane)
        if place["lane"] == f"{road}:{section}:{own}":
            known[number(lane)] = [place["road_id"], place["s"], place["lane_id"]]
    tried = [(a, b) for a, b in (source.sample(normal, 2) for _ in range(PAIRS)) if number(a) in known and number(b) in known]
    rows = [known[number(a)] + known[number(b)] for a, b in tried]
    routes = ask(mapd, path, "route", ROUTE, rows, "--lane-change", "0")
    counts = {name: 0 for name in ("same", "shorter", "longer", "only mapd", "only ad_map", "neither")}
    compared = []
    for (start, goal), row, own in zip(tried, rows, routes):
        route = plan(start, goal)
        segments = segments_of(route)
        ours = [tuple(int(n) for n in lane.split(":")) for lane in own["lanes"].split(";") if lane]
        if not segments or own["error"]:
            kind = "neither" if not segments and own["error"] else "only ad_map" if segments else "only mapd"
            counts[kind] += 1
            if kind != "neither":
                found.add(why_one_alone(ours, by_key) if ours else "", f"{kind} finds a way {row} {own['lanes']} {own['error']}")
            continue
        length, other = float(own["length"]), metres(ad.route.calcLength(route))
        if not is_same(length, other):
            counts["shorter" if length < other else "longer"] += 1
            reason = why_other_length(mapd, path, length, ours, segments, by_key)
            found.add(reason, f"{row} {length} m over {own['lanes']}, there {other} m over {segments}")
            continue
        counts["same"] += 1
        if [{lane} for lane in ours] == [set(part) for part in segments]:
            compared.append((route, row))
    # A question for each kind, not for each route.
    answers = {}
    for kind, options in (("corridor", ["--step", str(STEP)]), ("path", ["--step", str(STEP)]), ("conflicts", ["--rules", "DE"])):
        by_route = collections.defaultdict(list)
        for answer in ask(mapd, path, kind, ROUTE, list({tuple(row): row for _, row in compared}.values()), *options):
            by_route[tuple(answer[name] for name in ROUTE)].append(answer)
        answers[kind] = by_route
    borders, apart, counted = 0, [], collections.Counter()
    for route, row in compared:
        of = {kind: by_route[tuple(row)] for kind, by_route in answers.items()}
        points, beyond = compare_borders(route, of["corridor"], found)
        borders += points
        apart += beyond
        compare_priorities(route, of["path"], of["conflicts"], row, by_key, found, counted)
    print(
        f"{path}: {len(known)} of {len(normal)} lanes have the same name, {sum(counts.values())} pairs: "
        + ", ".join(f"{count} {name}" for name, count in counts.items())
        + f"; {borders} points of borders, {len(apart)} apart (by up to {max(apart, default=0.0):.2f} m); "
        + f"where the path passes an intersection it yields to {counted['yields']} lanes and {counted['priority']} yield to it"
    )
    return found


if __name__ == "__main__":
    unexplained = 0
    for file in sys.argv[1:]:
        differences = compare(os.environ.get("MAPD", "target/debug/mapd"), file)
        for kind, count in differences.explained.items():
            print(f"  {count} explained, {kind}: {EXPLAINED[kind]}")
        for text in differences.unexplained:
            print(f"  UNEXPLAINED {text}")
        unexplained += len(differences.unexplained)
    sys.exit(1 if unexplained else 0)
