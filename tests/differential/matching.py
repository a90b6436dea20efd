#!/usr/bin/env python3
"""Lanelet2's probabilistic matching beside `mapd query SOURCE match`, on mapd's export of OpenDRIVE maps.

    pip install lanelet2==1.2.3
    cargo build -p mapd
    tests/differential/matching.py --mapd target/debug/mapd ../shared/maps/carla/*.xodr

Both measure how far a pose with a covariance lies from a lane's centre line, headed along the lane: the Mahalanobis
distance. Lanelet2's squared one is Δp Σ⁻¹ Δp + κ² Δyaw², so that κ = 1 / √(σ_heading² + σ_drive²) asks both the same.
For random poses on and beside lanes, the distance of each lane agrees, and with it the lanes' order; each lane that is a
clear candidate of one is one of the other; and mapd's distance is that of the formula at the lane's centre. The order of the
candidates is compared pair by pair, where their distances differ by more than both may be off. Lanelet2's deterministic
matching, by the distance from the lanelet's area, is compared with `mapd query SOURCE nearest`. Prints a table
of how often what held, and ends with 1 where something differs for a reason that nobody gave.
"""

import argparse
import csv
import io
import math
import random
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

from lanelet2 import geometry, matching
from lanelet2.core import BasicPoint2d
from lanelets import Map, run

# Poses on each map.
POSES = 500
# mapd's deviations: of drivers from the direction of their lane [rad], of the map in place and heading [m], [rad].
DRIVE, MAP_PLACE, MAP_TURN = 0.1, 1e-3, 1e-4
# Lanelet2 makes centre lines from the borders' polylines: where they differ by more, so may the distances [m], [rad].
PLACE, TURN = 0.05, 0.03
# A distance is what the formula gives to this share; Lanelet2's is at a foot that it finds with other roundings.
EXACT, SHARE = 1e-6, 1e-3
# Of a pose beside a lane's border, and of what Lanelet2 looks for around it [m].
ASIDE, REACH = 2.5, 8.0
# Around a foot, in which a polyline is looked at for bends [m].
NEAR = 2.0
# Along a road, in which it has a kink if its direction turns by more than [`TURN`] [m]. Beside a kink lanes are open, and polylines bridge the wedge.
KINK = 0.01
# So near to a section's end a place belongs to either [m].
SECTION = 1e-6
# Lanes nearer than this, in deviations, are clear candidates: both know them.
CLEAR = 2.0


def formula(pose, deviations, place, heading, turn=0.0, map_too=True):
    """Distance of a pose from a place with a heading, in deviations along axes that are turned."""
    x, y, own = pose
    sx, sy, shdg = deviations
    extra, more = (MAP_PLACE, MAP_TURN) if map_too else (0.0, 0.0)
    dx, dy = x - place[0], y - place[1]
    along, across = math.cos(turn) * dx + math.sin(turn) * dy, math.cos(turn) * dy - math.sin(turn) * dx
    yaw = math.remainder(own - heading, math.tau)
    return math.sqrt(
        along**2 / (sx**2 + extra**2) + across**2 / (sy**2 + extra**2) + yaw**2 / (shdg**2 + DRIVE**2 + more**2)
    )


def foot(line, x, y):
    """The nearest place of a polyline, its heading, and whether the polyline bends there by more than [`TURN`]."""
    best = None
    for a, b in zip(line, line[1:]):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = dx * dx + dy * dy
        share = 0.0 if length == 0.0 else min(1.0, max(0.0, ((x - a[0]) * dx + (y - a[1]) * dy) / length))
        place = a[0] + share * dx, a[1] + share * dy
        off = math.hypot(x - place[0], y - place[1])
        if best is None or off < best[0]:
            best = off, place, math.atan2(dy, dx)
    _, place, heading = best
    around = [point for point in line if math.dist(point, place) <= NEAR]
    before, behind = (around[0], around[-1]) if len(around) > 1 else (line[0], line[-1])
    chord = math.atan2(behind[1] - before[1], behind[0] - before[0])
    return place, heading, abs(math.remainder(heading - chord, math.tau)) > TURN


class Poses:
    """Random poses on lanes of a map, in the frames of both."""

    def __init__(self, one, randomly):
        nodes = [point for point in one.map.pointLayer if "local_x" in point.attributes]
        local = {point.id: (float(point.attributes["local_x"]), float(point.attributes["local_y"])) for point in nodes}
        base = nodes[0]
        far = max(nodes, key=lambda point: math.dist(local[point.id], local[base.id]))
        (x, y), (far_x, far_y) = local[base.id], local[far.id]
        turn = math.atan2(far.y - base.y, far.x - base.x) - math.atan2(far_y - y, far_x - x)
        self.poses = []
        for _ in range(POSES):
            lanelet = randomly.choice(one.own)
            line = [point for point in lanelet.leftBound if point.id in local]
            if len(line) < 2:
                continue
            i = randomly.randrange(len(line) - 1)
            (ax, ay), (bx, by) = local[line[i].id], local[line[i + 1].id]
            heading = math.atan2(by - ay, bx - ax) + (randomly.gauss(0, 0.1) if randomly.random() < 0.8 else randomly.uniform(-3, 3))
            dx, dy = randomly.uniform(-ASIDE, ASIDE), randomly.uniform(-ASIDE, ASIDE)
            deviations = randomly.uniform(0.1, 1), randomly.uniform(0.1, 1), randomly.uniform(0.02, 0.3)
            c, s = math.cos(turn), math.sin(turn)
            there = line[i].x + c * dx - s * dy, line[i].y + s * dx + c * dy
            self.poses.append(((ax + dx, ay + dy, heading), there, heading + turn, deviations, turn))

    def rows(self):
        text = io.StringIO()
        writer = csv.writer(text)
        writer.writerow(["n", "x", "y", "hdg", "sx", "sy", "shdg"])
        writer.writerows([n, *pose, *deviations] for n, (pose, _, _, deviations, _) in enumerate(self.poses))
        return text.getvalue()


def by_mapd(one, poses, kinds):
    """Of each pose, the distance of each lane and direction, and the lane's centre there with its own direction as it is driven."""
    answers, rows, keys = [{} for _ in poses.poses], io.StringIO(), []
    spans, ahead = defaultdict(list), {}
    for (lane, begin), feature in one.lanes.items():
        spans[lane].append((begin, feature["s_to_m"]))
        ahead[lane] = "+" if feature["is_forward"] else "-"
    writer = csv.writer(rows)
    writer.writerow(["road_id", "s", "lane_id"])
    asked = ["query", one.source, "match", "--types", ",".join(kinds)]
    for row in csv.DictReader(io.StringIO(run(one.mapd, *asked, given=poses.rows()))):
        if row["error"]:
            raise RuntimeError(row["error"])
        if row["lane"]:
            road, _, lane = row["lane"].rsplit(":", 2)
            writer.writerow([road, row["s"], lane])
            # Where a section ends, `query lane` answers for the next one.
            inside = any(
                begin + SECTION < float(row["s"]) < end - SECTION for begin, end in spans[row["lane"]]
            )
            keys.append((int(row["n"]), (row["lane"], row["direction"]), row, inside))
    centers = csv.DictReader(io.StringIO(run(one.mapd, "query", one.source, "lane", given=rows.getvalue())))
    for (n, key, row, inside), center in zip(keys, centers, strict=True):
        place = (float(center["x"]), float(center["y"])) if inside and not center["error"] else None
        own = float(center["hdg"]) if place else poses.poses[n][0][2] - float(row["heading_difference"])
        against = place is not None and key[1] != ahead[key[0]]
        answers[n][key] = float(row["mahalanobis"]), place, own + (math.pi if against else 0.0)
    return answers


def nearest_by_mapd(one, poses, kinds):
    """Of each pose the nearest lane's distance [m], the lane's key, its road and s there, if there is one."""
    rows = io.StringIO()
    csv.writer(rows).writerows([["x", "y"], *(pose[:2] for pose, *_ in poses.poses)])
    asked = ["query", one.source, "nearest", "--types", ",".join(kinds), "--radius", str(REACH)]
    for row in csv.DictReader(io.StringIO(run(one.mapd, *asked, given=rows.getvalue()))):
        yield (float(row["distance"]), row["lane"], row["road_id"], float(row["s"])) if row["lane"] else (None, None, None, None)


def has_kink(one, road, s):
    """Whether a road has a kink at s."""
    rows = f"road_id,s,t\n{road},{max(0.0, s - KINK)},0\n{road},{s + KINK},0\n"
    before, behind = (float(row["hdg"]) for row in csv.DictReader(io.StringIO(run(one.mapd, "query", one.source, "inertial", given=rows))))
    return abs(math.remainder(behind - before, math.tau)) > TURN


def crosses_itself(lanelet):
    """Whether a lanelet's outline crosses itself, so that what lies inside is not told: where a lane is wider than its bend."""
    ring = [(point.x, point.y) for point in lanelet.polygon2d()]
    ring = [point for i, point in enumerate(ring) if point != ring[i - 1]]
    sides = [(point, ring[(i + 1) % len(ring)]) for i, point in enumerate(ring)]
    left = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return any(
        left(*first, second[0]) * left(*first, second[1]) < 0 and left(*second, first[0]) * left(*second, first[1]) < 0
        for i, first in enumerate(sides)
        for second in sides[i + 2 :]
    )


def reason(one, lane, road, s):
    """Why areas may differ at a place of a lane, if there is a reason."""
    if has_kink(one, road, s):
        return "the road has a kink there"
    if any(crosses_itself(lanelet) for lanelet in one.own if lanelet.attributes["lane_key"] == lane):
        return "the lane lies on itself"
    return None


def nearest_by_lanelet2(one, poses):
    """Of each pose the least distance of its deterministic matches [m], if there are any, and whether that is of a lanelet of mapd's."""
    own = {lanelet.id for lanelet in one.own}
    for _, (x, y), heading, _, _ in poses.poses:
        thing = matching.Object2d()
        thing.pose = matching.Pose2d(x, y, heading)
        found = [match.distance for match in matching.getDeterministicMatches(one.map, thing, REACH) if match.lanelet.id in own]
        yield min(found, default=None)


def by_lanelet2(one, poses):
    """Of each pose, the distance of each lane and direction, and the foot on Lanelet2's centre line with its heading."""
    own, lines = {lanelet.id for lanelet in one.own}, {}
    for _, (x, y), heading, (sx, sy, shdg), turn in poses.poses:
        thing = matching.ObjectWithCovariance2d()
        thing.pose = matching.Pose2d(x, y, heading)
        c, s = math.cos(turn), math.sin(turn)
        thing.positionCovariance = matching.PositionCovariance2d(
            c * c * sx * sx + s * s * sy * sy, s * s * sx * sx + c * c * sy * sy, c * s * (sx * sx - sy * sy)
        )
        thing.vonMisesKappa = 1 / math.hypot(shdg, DRIVE)
        found = {}
        for match in matching.getProbabilisticMatches(one.map, thing, REACH):
            lanelet = match.lanelet
            # Lanelet2 matches every lanelet turned round, too; mapd those that are driven both ways.
            if lanelet.id not in own or lanelet.inverted() and not one.lane(lanelet)["is_bidirectional"]:
                continue
            forward = one.lane(lanelet)["is_forward"] != lanelet.inverted()
            key, distance = (lanelet.attributes["lane_key"], "+" if forward else "-"), math.sqrt(match.mahalanobisDistSq)
            if key not in found or distance < found[key][0]:
                turned = lanelet.id, lanelet.inverted()
                if turned not in lines:
                    lines[turned] = [(point.x, point.y) for point in lanelet.centerline]
                found[key] = distance, lanelet, lines[turned]
        yield {key: (distance, *on_line(lanelet, line, x, y)) for key, (distance, lanelet, line) in found.items()}


def on_line(lanelet, line, x, y):
    """The foot on a lanelet's centre line, its heading, and whether the line cannot be trusted there: it bends, or leaves the lanelet."""
    place, heading, bends = foot(line, x, y)
    borders = (foot([(point.x, point.y) for point in border], *place)[0] for border in (lanelet.leftBound, lanelet.rightBound))
    leaves = not geometry.inside(lanelet, BasicPoint2d(*place)) and min(math.dist(place, border) for border in borders) > PLACE
    return place, heading, bends or leaves


class Comparison:
    def __init__(self):
        self.counts, self.wrong = Counter(), []

    def count(self, what, where=None):
        self.counts[what] += 1
        if where is not None:
            self.wrong.append((what, where))

    def map(self, one):
        poses = Poses(one, random.Random(3))
        kinds = sorted({one.lane(lanelet)["type"] for lanelet in one.own})
        for n, (mine, theirs) in enumerate(zip(by_mapd(one, poses, kinds), by_lanelet2(one, poses), strict=True)):
            self.pose(one, n, poses.poses[n], mine, theirs)
            self.rank(poses.poses[n], mine, theirs)
        for n, ((mine, *where), theirs) in enumerate(zip(nearest_by_mapd(one, poses, kinds), nearest_by_lanelet2(one, poses), strict=True)):
            if mine is None or theirs is None:
                near = min(distance for distance in (mine, theirs, REACH) if distance is not None) < REACH - 2 * PLACE
                self.count("nearest known to one alone", (one.source.name, n, mine, theirs) if near else None)
            elif abs(mine - theirs) <= PLACE:
                self.count("nearest alike")
            else:
                why = reason(one, *where)
                what = f"nearest differs: {why}" if why else "nearest differs"
                self.count(what, None if why else (one.source.name, n, mine, theirs))

    def rank(self, given, mine, theirs):
        """Counts pairs of lanes that both know and whose distances are far from each other, by whether both put them in one order. Distances that agree
        leave no choice; of those that differ, `pose` has told why."""
        sx, sy, shdg = given[3]
        allowed = PLACE / min(sx, sy) + TURN / math.hypot(shdg, DRIVE)
        both = [key for key in mine if key in theirs]
        for i, a in enumerate(both):
            for b in both[i + 1 :]:
                if abs(mine[a][0] - mine[b][0]) > 2 * allowed:
                    same = (mine[a][0] < mine[b][0]) == (theirs[a][0] < theirs[b][0])
                    self.count("pairs in one order" if same else "pairs in the other order, for a distance differs")

    def pose(self, one, n, given, mine, theirs):
        local, there, heading, deviations, turn = given
        for key, (distance, place, direction) in mine.items():
            if place is not None:
                computed = formula(local, deviations, place, direction)
                same = abs(computed - distance) <= EXACT * (1 + distance)
                self.count("mapd as the formula says" if same else "mapd not as the formula says", None if same else (one.source.name, n, key, distance, computed))
        for key, (distance, place, direction, strays) in theirs.items():
            computed = formula((*there, heading), deviations, place, direction, turn, False)
            same = abs(computed - distance) <= SHARE * (1 + distance)
            self.count("Lanelet2 as the formula says" if same else "Lanelet2 not as the formula says at the foot on its centre line")
            if key not in mine or mine[key][1] is None:
                continue
            # The place of one on the other's axes.
            x, y = mine[key][1][0] - local[0], mine[key][1][1] - local[1]
            c, s = math.cos(turn), math.sin(turn)
            own = there[0] + c * x - s * y, there[1] + s * x + c * y
            apart = math.dist(own, place)
            turned = abs(math.remainder(mine[key][2] + turn - direction, math.tau))
            sx, sy, shdg = deviations
            allowed = PLACE / min(sx, sy) + TURN / math.hypot(shdg, DRIVE)
            if abs(distance - mine[key][0]) <= allowed:
                self.count("distances alike")
            elif not same:
                self.count("distances differ: Lanelet2's is not that of its centre line")
            elif apart > PLACE or turned > TURN or strays:
                self.count("distances differ: the centre lines are apart, turned or bent")
            else:
                self.count("distances differ", (one.source.name, n, key, distance, mine[key], place))
        for key, (distance, *_) in mine.items():
            if key not in theirs and distance < CLEAR:
                merged = tuple(key[0].split(":")[:2]) in one.merged_sections
                why = next((what for what, lanes in one.changed.items() if key[0] in lanes), "merged" if merged else None)
                self.count(f"clear candidate of mapd alone: {why}", None if why else (one.source.name, n, key, distance, local))
        for key, (distance, place, direction, strays) in theirs.items():
            if key not in mine and distance < CLEAR:
                computed = formula((*there, heading), deviations, place, direction, turn, False)
                why = "its centre line bends or leaves the lanelet there" if strays else None
                if abs(computed - distance) > SHARE * (1 + distance):
                    why = "not that of its centre line"
                self.count(f"clear candidate of Lanelet2 alone: {why}", None if why else (one.source.name, n, key, distance, local))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mapd", default="target/debug/mapd")
    parser.add_argument("maps", nargs="+", type=Path)
    options = parser.parse_args()
    comparison = Comparison()
    for source in options.maps:
        with tempfile.TemporaryDirectory() as folder:
            try:
                one = Map(options.mapd, source, Path(folder))
            except RuntimeError as error:
                print(f"{source}: left out: {error}".splitlines()[0])
                continue
            comparison.map(one)
    for what, where in comparison.wrong[:40]:
        print(f"  WRONG {what}: {where}")
    for what, count in sorted(comparison.counts.items()):
        print(f"{count:9} {what}")
    sys.exit(bool(comparison.wrong))


if __name__ == "__main__":
    main()
