#!/usr/bin/env python3
"""What Lanelet2 makes of mapd's export of OpenDRIVE maps, compared with what mapd says of the same maps.

    pip install lanelet2==1.2.3
    cargo build -p mapd
    tests/differential/lanelets.py --mapd target/debug/mapd ../shared/maps/carla/*.xodr

For each map: it loads without an error; the routing graphs pass Lanelet2's own checks; each lanelet's borders run as they are
meant; every lane that follows another one does so in both, or the export's report says why not; routes cost the same in
both graphs; the nearest lanelet is as near as the nearest lane; who gives way to whom, lights and turns are those that `mapd query` tells. Prints a table of how often what held, and ends with 1
where something differs for a reason that nobody gave.
"""

import argparse
import csv
import heapq
import io
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

import lanelet2
from lanelet2 import geometry, projection, routing, traffic_rules
from lanelet2.core import BasicPoint2d

# Where maps without a georeference are put.
ORIGIN = "49,8.4"
ROUTES, POINTS = 500, 2000
# What a change of lane costs in both [m].
CHANGE = 20.0
# A place this far inside a lane is in it [m].
INSIDE = 1e-3
# Sections that are merged with their neighbours are shorter [m].
SHORTEST = 0.1
# Routes may differ by so much besides [m]: rounding of lengths, and the places' distances from their lanes' ends.
ROUTE = 0.05
# Distances from the nearest lane may differ by so much [m]: half of what ends are put together over, and the tolerances of polylines.
NEAREST = 0.1
# Where the nearest lane may be farther away: what the report says of lanes that are not where the map has them.
CHANGED = ("merged", "narrow", "cut", "lost")
# How far points lie from a point of the map [m].
REACH = 8.0
# Lights so far before a junction are those of its movements [m].
APPROACH = 30.0
# Movements that turn by less are straight [rad]; by more, back. Nearer to either than this nothing is said of them.
STRAIGHT, BACK, UNCLEAR = math.pi / 4, math.pi * 7 / 8, 0.01


def run(mapd, *arguments, given=None):
    done = subprocess.run([mapd, *map(str, arguments)], input=given, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    return done.stdout


def export(mapd, source, folder):
    """The map's files; one without a georeference gets a place."""
    osm, report = folder / "map.osm", folder / "report.csv"
    for place in ([], ["--origin", ORIGIN]):
        try:
            run(mapd, "export", source, "--format", "lanelet2", "-o", osm, "--report", report, *place)
            text = run(mapd, "export", source, "--format", "geojson", "--layers", "lanes,edges", *place)
        except RuntimeError as error:
            if place or "--origin" not in str(error):
                raise
            continue
        features = [feature["properties"] for feature in json.loads(text)["features"]]
        with open(report, newline="") as lines:
            return osm, features, list(csv.DictReader(lines))
    raise AssertionError


class Map:
    """A map as both have it."""

    def __init__(self, mapd, source, folder):
        self.mapd, self.source, self.counts, self.wrong = mapd, source, Counter(), []
        osm, features, self.report = export(mapd, source, folder)
        for line in self.report:
            self.counts[line["what"]] += int(line["count"])
        self.lanes = {(one["key"], one["s_from_m"]): one for one in features if one["layer"] == "lanes"}
        self.edges = [one for one in features if one["layer"] == "edges"]
        first = re.search(r'lat="([^"]+)" lon="([^"]+)"', osm.read_text())
        if not first:
            raise RuntimeError("no lanes that anybody may use")
        projector = projection.UtmProjector(lanelet2.io.Origin(float(first[1]), float(first[2])))
        self.map, errors = lanelet2.io.loadRobust(str(osm), projector)
        self.wrong += [("load", error) for error in errors]
        self.own = [one for one in self.map.laneletLayer if "lane_key" in one.attributes]
        self.counts["lanelets"] = len(self.own)
        self.counts["areas"] = len(self.map.areaLayer)
        if len(self.map.areaLayer) != len(re.findall('v="multipolygon"', osm.read_text())):
            self.wrong.append(("areas", len(self.map.areaLayer)))
        self.graphs = {}
        for name in ("VehicleCar", "VehicleBus", "Bicycle", "Pedestrian"):
            rules = traffic_rules.create(traffic_rules.Locations.Germany, getattr(traffic_rules.Participants, name))
            costs = [routing.RoutingCostDistance(CHANGE, 0.0), routing.RoutingCostTravelTime(2.0)]
            self.graphs[name] = routing.RoutingGraph(self.map, rules, costs)
            self.wrong += [("graph", f"{name}: {fault}") for fault in self.graphs[name].checkValidity()]
        told = lambda what: {(line["lane"], line["other"]) for line in self.report if line["what"] == what}
        self.lost, self.extra = told("lost"), told("extra")
        self.turned = {lane for lane, _ in told("turned")}
        self.changed = {what: {lane for pair in told(what) for lane in pair if lane} for what in CHANGED}
        self.merged_sections = {tuple(lane.split(":")[:2]) for lane, _ in told("merged")}

    def lane(self, one):
        """The lane of a lanelet, as mapd has it."""
        key, begin = one.attributes["lane_key"], float(one.attributes["s_from"])
        starts = [s for own, s in self.lanes if own == key and s <= begin + 1e-5]
        return self.lanes[key, max(starts)]

    def orientation(self):
        for one in self.own:
            meant = self.lane(one)["is_forward"]
            found = {not one.leftBound.inverted(), not one.rightBound.inverted()}
            if found != {meant} and one.attributes["lane_key"] not in self.turned:
                self.wrong.append(("orientation", one.attributes["lane_key"]))

    def ends(self):
        """Lanelets by the keys and stretches of their nodes: at which s a lane's lanelets begin and end."""
        by_lane = defaultdict(list)
        for one in self.own:
            span = float(one.attributes["s_from"]), float(one.attributes["s_to"])
            by_lane[one.attributes["lane_key"]].append((*span, one))
        return by_lane

    def following(self):
        """Compares for cars what follows what, both ways."""
        by_lane, graph = self.ends(), self.graphs["VehicleCar"]
        near = lambda a, b: abs(a - b) < 1e-5
        at = lambda key, place, value: [one for *span, one in by_lane[key] if near(span[place], value)]
        expected, self.weight, through = set(), {}, defaultdict(set)
        for edge in self.edges:
            if "passengerCar" not in edge["vehicles"].split(","):
                continue
            span = edge["from_s_from_m"], edge["from_s_to_m"]
            pieces = [one for *own, one in by_lane[edge["from"]] if span[0] - 1e-5 <= own[0] and own[1] <= span[1] + 1e-5]
            for one in pieces:
                own = float(one.attributes["s_to"]) - float(one.attributes["s_from"])
                self.weight[one.id] = edge["length_m"] * own / (span[1] - span[0])
            node = edge["from"], *span, edge["from_is_forward"]
            target = edge["to"], edge["to_s_from_m"], edge["to_s_to_m"], edge["to_is_forward"]
            through[node].add(target)
        merged = lambda node: not any(near(own[0], node[1]) or near(own[1], node[2]) for *own, _ in by_lane[node[0]])

        def targets(node, seen):
            for target in through[node]:
                if merged(target):
                    if target not in seen:
                        seen.add(target)
                        yield from targets(target, seen)
                else:
                    yield target

        # A lanelet of a lane that is used both ways is driven against its own direction, too: it is inverted then.
        ways = lambda lanelets, forward: [(one.id, forward != self.lane(one)["is_forward"]) for one in lanelets]
        for node in list(through):
            if merged(node):
                continue
            forward = node[3]
            last = ways(at(node[0], 1, node[2]) if forward else at(node[0], 0, node[1]), forward)
            for target in targets(node, set()):
                forward = target[3]
                first = ways(at(target[0], 0, target[1]) if forward else at(target[0], 1, target[2]), forward)
                expected.update((a, b) for a in last for b in first)
        # Pieces of one node.
        for pieces in by_lane.values():
            pieces.sort(key=lambda piece: piece[0])
            for before, behind in zip(pieces, pieces[1:]):
                if near(before[1], behind[0]):
                    pair = before[2], behind[2]
                    a, b = pair if self.lane(before[2])["is_forward"] else pair[::-1]
                    if b in graph.following(a):
                        expected.add(((a.id, False), (b.id, False)))
                    if self.lane(a)["is_bidirectional"] and a.invert() in graph.following(b.invert()):
                        expected.add(((b.id, True), (a.id, True)))
        keys = {one.id: one.attributes["lane_key"] for one in self.own}
        driven = [(one, False) for one in self.own] + [(one.invert(), True) for one in self.own if self.lane(one)["is_bidirectional"]]
        found = {((one.id, inverted), (beyond.id, beyond.inverted())) for one, inverted in driven for beyond in graph.following(one)}
        # What routes cannot use, or use alone, for a reason that is known by then.
        self.missing, self.surplus = defaultdict(set), set()
        self.counts["edges of both"] = len(expected & found)
        for a, b in expected - found:
            pair = keys[a[0]], keys[b[0]]
            reason = "lost" if pair in self.lost else "turned" if self.turned & set(pair) else None
            self.counts[f"edges of mapd alone: {reason}"] += 1
            self.missing[a].add(b)
            if reason is None:
                self.wrong.append(("edge of mapd alone", pair))
        for a, b in found - expected:
            pair = keys[a[0]], keys[b[0]]
            reason = "extra" if pair in self.extra else "turned" if self.turned & set(pair) else None
            self.counts[f"edges of Lanelet2 alone: {reason}"] += 1
            self.surplus.add((a, b))
            if reason is None:
                self.wrong.append(("edge of Lanelet2 alone", pair))

    def length(self, one):
        """Of a lanelet, as mapd has it [m]; along the road where nothing follows the lane for cars."""
        attributes = one.attributes
        return self.weight.get(one.id, float(attributes["s_to"]) - float(attributes["s_from"]))

    def cheapest(self, start, target, mended=False):
        """Cost of the cheapest way through Lanelet2's graph, with mapd's lengths [m]; mended: with the edges that it lacks, without those that it alone has."""
        graph, begin = self.graphs["VehicleCar"], (start.id, False)
        best, queue = {begin: 0.0}, [(0.0, begin)]
        while queue:
            cost, at = heapq.heappop(queue)
            if at == (target.id, False):
                return cost
            if cost > best[at]:
                continue
            one = self.map.laneletLayer[at[0]]
            one = one.invert() if at[1] else one
            following = graph.following(one)
            if mended:
                following = [beyond for beyond in following if (at, (beyond.id, beyond.inverted())) not in self.surplus]
                lacking = [(self.map.laneletLayer[number], inverted) for number, inverted in self.missing[at]]
                following += [beyond.invert() if inverted else beyond for beyond, inverted in lacking]
            ways = [(beyond, self.length(one)) for beyond in following]
            ways += [(beside, CHANGE) for beside in (graph.left(one), graph.right(one)) if beside]
            for way, own in ways:
                way = way.id, way.inverted()
                if cost + own < best.get(way, math.inf):
                    best[way] = cost + own
                    heapq.heappush(queue, (cost + own, way))
        return None

    def routes(self, randomly):
        """Costs of routes between places where lanelets are entered."""
        cars = [one for one in self.own if one.id in self.weight]
        if not cars:
            return
        starts = {}
        for edge in self.edges:
            starts.setdefault(edge["to"], set()).update((edge["to_s_from_m"], edge["to_s_to_m"]))
            starts.setdefault(edge["from"], set()).update((edge["from_s_from_m"], edge["from_s_to_m"]))

        def entry(one):
            lane = self.lane(one)
            forward = lane["is_forward"]
            s = float(one.attributes["s_from" if forward else "s_to"])
            return lane["road"], s + INSIDE if forward else s - INSIDE, lane["lane"]

        def is_first(one):
            lane = self.lane(one)
            s = float(one.attributes["s_from" if lane["is_forward"] else "s_to"])
            return any(abs(s - own) < 1e-5 for own in starts.get(one.attributes["lane_key"], ()))

        # mapd reaches a lane that is used both ways from either end.
        cars = [one for one in cars if is_first(one) and not self.lane(one)["is_bidirectional"]]
        if not cars:
            return
        pairs = [(randomly.choice(cars), randomly.choice(cars)) for _ in range(ROUTES)]
        rows = io.StringIO()
        writer = csv.writer(rows)
        writer.writerow(["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane"])
        writer.writerows([*entry(a), *entry(b)] for a, b in pairs)
        answers = csv.DictReader(io.StringIO(run(self.mapd, "query", self.source, "route", given=rows.getvalue())))
        graph = self.graphs["VehicleCar"]
        for (a, b), answer in zip(pairs, answers, strict=True):
            own = self.cheapest(a, b)
            lanes = answer["lanes"].split(";") if answer["lanes"] else []
            if (own is None) != (graph.shortestPath(a, b) is None):
                self.wrong.append(("route of Lanelet2", (a.id, b.id)))
            cost = float(answer["length"]) + CHANGE * float(answer["lane_changes"]) if answer["length"] else None
            merged = sum(tuple(key.split(":")[:2]) in self.merged_sections for key in lanes)
            alike = lambda own: (own is None) == (cost is None) and (own is None or abs(own - cost) <= ROUTE + SHORTEST * merged)
            if alike(own):
                self.counts["routes alike" if own is not None else "no route in either"] += 1
                continue
            # Only what the report tells of edges may make it another route: with them it is the same.
            reason = "by an edge that is told of" if (self.missing or self.surplus) and alike(self.cheapest(a, b, True)) else None
            if reason is None and None not in (own, cost) and 0 < cost - own <= SHORTEST * len(lanes):
                reason = "through merged sections"
            self.counts[f"routes: {reason}"] += 1
            if reason is None:
                self.wrong.append(("route", (a.attributes["lane_key"], b.attributes["lane_key"], own, cost)))

    def query(self, kind, header, rows):
        """Answers of `mapd query`, those of each question together."""
        text = io.StringIO()
        writer = csv.writer(text)
        writer.writerow([*header, "question"])
        writer.writerows([*row, number] for number, row in enumerate(rows))
        answers = [[] for _ in rows]
        for answer in csv.DictReader(io.StringIO(run(self.mapd, "query", self.source, kind, given=text.getvalue()))):
            answers[int(answer["question"])].append(answer)
        return answers

    def rules(self):
        """Right of way, lights and turns of the lanes of junctions that cars use."""
        by_lane = self.ends()
        lanes = {}
        for (key, begin), lane in sorted(self.lanes.items()):
            is_own = lane["junction"] and lane["type"] != "sidewalk" and not lane["is_bidirectional"] and not lane["is_temporary"]
            if is_own and by_lane[key] and key not in lanes:
                lanes[key] = lane
        cars = [edge for edge in self.edges if "passengerCar" in edge["vehicles"].split(",")]
        used = {edge[end] for edge in cars for end in ("from", "to")}
        lanes = {key: lane for key, lane in lanes.items() if key in used}
        if not lanes:
            return
        before, behind = defaultdict(set), defaultdict(set)
        for edge in cars:
            before[edge["to"]].add(edge["from"])
            behind[edge["from"]].add(edge["to"])
        everything = {key: lane for (key, _), lane in self.lanes.items()}
        self.right_of_way(lanes, by_lane)
        self.lights(lanes, by_lane, before, everything)
        self.turns(lanes, by_lane, before, behind, everything)

    def first(self, key, by_lane):
        """The lanelet by which a lane is entered."""
        pieces = sorted(by_lane[key], key=lambda piece: piece[0])
        return pieces[0 if self.lane(pieces[0][2])["is_forward"] else -1][2]

    @staticmethod
    def along(lane, inside=INSIDE):
        """Where a lane is entered and left, as s."""
        ends = lane["s_from_m"] + inside, lane["s_to_m"] - inside
        return ends if lane["is_forward"] else ends[::-1]

    def right_of_way(self, lanes, by_lane):
        header = ["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane"]
        rows = []
        for lane in lanes.values():
            start, end = self.along(lane)
            rows.append([lane["road"], start, lane["lane"], lane["road"], end, lane["lane"]])
        for (key, lane), answers in zip(lanes.items(), self.query("conflicts", header, rows), strict=True):
            if any(answer["error"] for answer in answers):
                self.counts["right of way: no way along the lane"] += 1
                continue
            told = {one["other_lane"] for one in answers if one["yields"] == "yields" and one["basis"] == "written"}
            expected = {other for other in told if by_lane[other]}
            entered, found, lines = self.first(key, by_lane), set(), []
            for rule in entered.rightOfWay():
                if entered.id in {one.id for one in rule.yieldLanelets()}:
                    found |= {one.attributes["lane_key"] for one in rule.rightOfWayLanelets()}
                    lines.append(rule.stopLine)
            # A way over a lane begins and ends a millimetre inside: what it only touches is not told.
            self.counts[f"right of way: lanes alike{'' if expected else ', nobody to wait for'}" if expected == found else "right of way: lanes not alike"] += 1
            self.counts["right of way: with a line"] += sum(line is not None for line in lines)
            if expected != found:
                self.wrong.append(("right of way", (key, sorted(expected), sorted(found))))

    def lights(self, lanes, by_lane, before, everything):
        places, of = [], []
        for key, lane in lanes.items():
            # A movement that goes over several lanes has its lights on the first.
            if any(one in lanes and lanes[one]["junction"] == lane["junction"] for one in before[key]):
                continue
            # Lights may stand at its very beginning.
            start, end = self.along(lane, 0.0)
            places.append([lane["road"], start, lane["lane"], abs(end - start)])
            of.append((key, False))
            # From each lane that leads here as far as it reaches, then from those before it.
            level, left = before[key], {one: APPROACH for one in before[key]}
            while level:
                further = set()
                for one in level:
                    own = everything[one]
                    entry, exit = self.along(own)
                    reach = min(abs(exit - entry), left[one])
                    # Over its end: lights at the very beginning of the next lane are for this one, too, and lanes are longer than s in bends.
                    places.append([own["road"], exit + math.copysign(reach, entry - exit), own["lane"], 1.1 * reach + 0.1])
                    of.append((key, one in before[key]))
                    if left[one] > abs(exit - entry) + INSIDE:
                        for other in before[one] - left.keys():
                            left[other] = left[one] - abs(exit - entry)
                            further.add(other)
                level = further
        found, sure = defaultdict(set), defaultdict(set)
        header = ["road_id", "s", "lane_id", "distance"]
        for (key, is_next), place, answers in zip(of, places, self.query("signals", header, places), strict=True):
            for answer in answers:
                lamps = answer["state_machine"].split(":")
                if answer["id"] and lamps[0]:
                    found[key].add(answer["id"])
                    is_vague = len(lamps) > 2 or not answer["class"].startswith("traffic_light") or float(answer["distance"]) > 0.8 * place[3]
                    if is_next and not is_vague:
                        sure[key].add(answer["id"])
        for key in dict.fromkeys(key for key, _ in of):
            own = {light.attributes["signal_id"] for rule in self.first(key, by_lane).trafficLights() for light in rule.trafficLights}
            if own <= found[key] and sure[key] <= own:
                self.counts["lights: lanes alike" if own else "lights: none"] += 1
            else:
                self.counts["lights: lanes not alike"] += 1
                self.wrong.append(("lights", (key, sorted(own), sorted(found[key]), sorted(sure[key]))))

    def turns(self, lanes, by_lane, before, behind, everything):
        header, rows, keys = ["road_id", "s", "lane_id"], [], []
        for key, lane in lanes.items():
            own = lambda others: {one for one in others if everything[one]["junction"] == lane["junction"]}
            # One of a movement over several lanes is left to those of one lane.
            if own(before[key]) or own(behind[key]):
                self.counts["turns: of several lanes, not compared"] += 1
                continue
            keys.append(key)
            rows += [[lane["road"], s, lane["lane"]] for s in self.along(lane, 0.0)]
        answers = iter(self.query("lane", header, rows))
        for key, start, end in zip(keys, answers, answers, strict=True):
            turned = math.remainder(float(end[0]["hdg"]) - float(start[0]["hdg"]), math.tau)
            if min(abs(abs(turned) - limit) for limit in (STRAIGHT, BACK)) < UNCLEAR:
                continue
            # A way back is a turn to the side of the oncoming traffic.
            back = "left" if (everything[key]["lane"] < 0) == everything[key]["is_forward"] else "right"
            expected = "straight" if abs(turned) < STRAIGHT else back if abs(turned) > BACK else "left" if turned > 0 else "right"
            found = {one.attributes["turn_direction"] for *_, one in by_lane[key]}
            self.counts[f"turns: {expected}"] += 1
            if found != {expected}:
                self.wrong.append(("turn", (key, expected, found)))

    def nearest(self, randomly):
        """Distances of points from the nearest lanelet and lane."""
        nodes = [point for point in self.map.pointLayer if "local_x" in point.attributes]
        local = [(float(p.attributes["local_x"]), float(p.attributes["local_y"])) for p in nodes]
        # Both frames differ by a turn and a scale near 1.
        (x, y), base = local[0], nodes[0]
        far = max(range(len(local)), key=lambda i: math.dist(local[i], local[0]))
        turn = math.atan2(nodes[far].y - base.y, nodes[far].x - base.x) - math.atan2(local[far][1] - y, local[far][0] - x)
        kinds = sorted({self.lane(one)["type"] for one in self.own})
        points, rows = [], io.StringIO()
        writer = csv.writer(rows)
        writer.writerow(["x", "y"])
        for _ in range(POINTS):
            i = randomly.randrange(len(nodes))
            dx, dy = randomly.uniform(-REACH, REACH), randomly.uniform(-REACH, REACH)
            writer.writerow([local[i][0] + dx, local[i][1] + dy])
            points.append(BasicPoint2d(
                nodes[i].x + math.cos(turn) * dx - math.sin(turn) * dy,
                nodes[i].y + math.sin(turn) * dx + math.cos(turn) * dy,
            ))
        asked = ["query", self.source, "nearest", "--radius", 4 * REACH, "--types", ",".join(kinds)]
        answers = csv.DictReader(io.StringIO(run(self.mapd, *asked, given=rows.getvalue())))
        own = {one.id for one in self.own}
        for point, answer in zip(points, answers, strict=True):
            hits = [hit for hit in geometry.findNearest(self.map.laneletLayer, point, 8) if hit[1].id in own]
            if not hits or not answer["distance"]:
                self.wrong.append(("nearest", answer))
                continue
            distance = hits[0][0]
            same = any(hit[1].attributes["lane_key"] == answer["lane"] for hit in hits if hit[0] <= distance + NEAREST)
            if abs(distance - float(answer["distance"])) <= NEAREST:
                self.counts["nearest alike" if same else "nearest as near, another lane"] += 1
                continue
            lanes = {answer["lane"], *(hit[1].attributes["lane_key"] for hit in hits if hit[0] <= distance + NEAREST)}
            reason = next((what for what, named in self.changed.items() if named & lanes), None)
            self.counts[f"nearest: not as near, {reason}"] += 1
            if reason is None:
                self.wrong.append(("nearest", (answer["lane"], sorted(lanes), distance, float(answer["distance"]))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mapd", default="target/debug/mapd")
    parser.add_argument("maps", nargs="+", type=Path)
    options = parser.parse_args()
    total, failed = Counter(), False
    for source in options.maps:
        with tempfile.TemporaryDirectory() as folder:
            try:
                one = Map(options.mapd, source, Path(folder))
            except RuntimeError as error:
                print(f"{source}: left out: {error}".splitlines()[0])
                continue
            one.orientation()
            one.following()
            one.routes(random.Random(1))
            one.rules()
            one.nearest(random.Random(2))
        total += one.counts
        print(f"{source}: " + "; ".join(f"{what} {count}" for what, count in sorted(one.counts.items())))
        for what, where in one.wrong[:10]:
            print(f"  WRONG {what}: {where}")
        failed |= bool(one.wrong)
    print("\nall maps")
    for what, count in sorted(total.items()):
        print(f"{count:9} {what}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
