"""Questions with their answers by Rust (the program `answers` of the tests' crate), answered in Python and compared bit by bit.

Batches where there are any, and the single form for the first few of each.
"""

from __future__ import annotations

import os
import struct
import subprocess
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import WORKSPACE, program

import mapd

# Of every kind on each of the five maps.
COUNT = int(os.environ.get("MAPD_ANSWERS", "1000"))
# Single forms that are asked after the batch.
SINGLES = 100
NOTHING = 0xFFFFFFFF
CLASSES = {word: code for code, word in mapd.WORDS["class"].items()}
ENTER = {"start": 0, "ahead": 1, "left": 2, "right": 3}


def as_float(bits: int) -> float:
    (number,) = struct.unpack("<d", struct.pack("<Q", bits))
    assert isinstance(number, float)
    return number


def bits(number: float) -> int:
    (out,) = struct.unpack("<Q", struct.pack("<d", number))
    assert isinstance(out, int)
    return out


def text(word: str) -> int:
    """FNV-1a."""
    out = 0xCBF29CE484222325
    for byte in word.encode():
        out = (out ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return out


def clamped(code: int) -> int:
    return {0: 0, -1: 1, 1: 2}[int(code)]


def lane(one: mapd.Lane | None) -> int:
    return NOTHING if one is None else one.id


def lanes(ids: list[mapd.Lane]) -> list[int]:
    return [len(ids), *(one.id for one in ids)]


def option(number: float | None) -> list[int]:
    return [0, bits(0.0)] if number is None or np.isnan(number) else [1, bits(number)]


@dataclass
class Question:
    kind: str
    numbers: list[int]
    answer: list[int]

    def f(self, *places: int) -> list[float]:
        return [as_float(self.numbers[place]) for place in places]


@dataclass
class Asked:
    """A map, its questions by kind, and what is taken from the map once."""

    map: mapd.Map
    under: mapd.Map
    """The same under an overlay."""
    nodes: mapd.LaneNodes
    edges: mapd.LaneEdges
    kinds: dict[str, list[Question]] = field(default_factory=lambda: defaultdict(list))

    def by(self, kind: str, key: Callable[[Question], Any]) -> Iterator[tuple[Any, list[Question]]]:
        groups: dict[Any, list[Question]] = defaultdict(list)
        for question in self.kinds[kind]:
            groups[key(question)].append(question)
        return iter(groups.items())

    def expected(self, lane_id: int) -> list[mapd.Lane] | None:
        """The lane that a question expects, if any."""
        return None if lane_id == NOTHING else [self.map.lane(lane_id)]


def points(questions: list[Question], first: int = 0, with_z: bool = False) -> np.ndarray[Any, np.dtype[np.float64]]:
    places = range(first, first + (3 if with_z else 2))
    return np.array([question.f(*places) for question in questions])


def place_of(row: Any) -> list[int]:
    """The ten numbers of a place on a lane, without the lane."""
    names = ("s", "t", "offset", "offset_of_reference_line", "distance", "z", "heading", "heading_of_reference_line")
    return [*(bits(row[name]) for name in names), clamped(row["clamped"])]


def column_place(columns: Any, row: int) -> list[int]:
    here = {name: columns[name][row] for name in columns.names}
    return [int(here["lane"]), *place_of(here)]


@pytest.fixture(scope="module", params=["town", "objects", "marks", "surfaces", "one_road", "signals"])
def asked(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Asked:
    folder = tmp_path_factory.getbasetemp() / "answers"
    if not folder.exists():
        subprocess.run([program().with_name("answers"), folder, str(COUNT)], check=True, cwd=WORKSPACE)
    path = Path(folder, request.param)
    map = mapd.open(path.with_suffix(".mapd"))
    asked = Asked(map, map.with_overlay(path.with_suffix(".overlay").read_bytes()), *map.lane_graph())
    for line in path.with_suffix(".answers").read_text().splitlines():
        question, answer = line.split("|")
        kind, *numbers = question.split()
        asked.kinds[kind].append(Question(kind, [int(n, 16) for n in numbers], [int(n, 16) for n in answer.split()]))
    return asked


def test_every_kind_is_asked(asked: Asked) -> None:
    import test_parts
    import test_ways

    names = (*globals(), *vars(test_ways), *vars(test_parts))
    known = {name.removeprefix("test_") for name in names if name.startswith("test_")}
    assert set(asked.kinds) <= known
    assert all(len(asked.kinds[kind]) >= COUNT for kind in ("nearest", "match", "ground", "route"))


def test_nearest(asked: Asked) -> None:
    for (radius, has_z), questions in asked.by("nearest", lambda q: (q.numbers[4], q.numbers[3])):
        found = asked.map.nearest_lane(points(questions, with_z=has_z == 1), radius=as_float(radius))
        for row, question in enumerate(questions):
            if question.answer[0] == 0:
                assert found.lane[row] == mapd.NONE
            else:
                assert column_place(found, row) == question.answer[1:]
        for question in questions[:SINGLES]:
            x, y, z = question.f(0, 1, 2)
            one = asked.map.nearest_lane((x, y, z) if has_z else (x, y), radius=as_float(radius))
            assert (one is not None) == (question.answer[0] == 1)
            if one is not None:
                assert [one.lane.id, *place_of(one._asdict())] == question.answer[1:]


def test_near(asked: Asked) -> None:
    for (radius, has_z), questions in asked.by("near", lambda q: (q.numbers[4], q.numbers[3])):
        found = asked.map.lanes_near(points(questions, with_z=has_z == 1), radius=as_float(radius))
        rows = iter(range(len(found)))
        for number, question in enumerate(questions):
            for k in range(question.answer[0]):
                row = next(rows)
                assert found.point[row] == number
                assert column_place(found, row) == question.answer[1 + 10 * k : 11 + 10 * k]
        assert next(rows, None) is None


def test_around(asked: Asked) -> None:
    for question in asked.kinds["around"]:
        x, y, radius = question.f(0, 1, 2)
        answer = []
        for near in (asked.map.signals_near((x, y), radius), asked.map.objects_near((x, y), radius)):
            answer.append(len(near))
            for one, distance in near:
                answer += [text(one.id), bits(distance)]
        assert answer == question.answer


def number(one: mapd.Signal | mapd.Object | mapd.Lane | mapd.Junction | None) -> int:
    """The id of a part as one number."""
    return NOTHING if one is None else hash(one) & 0xFFFFFFFFFFFFFFFF


def test_landmarks(asked: Asked) -> None:
    for question in asked.kinds["landmarks"]:
        x, y, radius = question.f(0, 1, 2)
        found = asked.map.landmarks_near((x, y), radius)
        answer = [len(found)]
        for one in found:
            answer += [number(one.signal), number(one.object), CLASSES[one.meaning], *map(bits, (one.x, one.y, one.z, one.heading))]
            answer += map(bits, (one.length, one.width, one.height, one.distance))
        assert answer == question.answer


def test_objects(asked: Asked) -> None:
    for question in asked.kinds["objects"]:
        x, y, radius = question.f(0, 1, 2)
        found = asked.map.placements_near((x, y), radius)
        answer = [len(found)]
        for place, distance in found:
            answer += [number(place.object), NOTHING if place.copy is None else place.copy, bits(distance)]
        assert answer == question.answer
        assert [place.object for place, _ in found] == [one for one, _ in asked.map.objects_near((x, y), radius)]


def test_track(asked: Asked) -> None:
    for (number, has_z), questions in asked.by("track", lambda q: (q.numbers[0], q.numbers[4])):
        road = asked.map.roads()[number & NOTHING]
        found = road.to_track(points(questions, 1, has_z == 1))
        for row, question in enumerate(questions):
            answer = [bits(found.s[row]), bits(found.t[row]), *option(found.h[row]), bits(found.distance[row])]
            assert [*answer, clamped(found.clamped[row]), int(found.exact[row])] == question.answer


def poses(found: mapd.Poses, row: int) -> list[int]:
    return [*(bits(found[name][row]) for name in found.names[:-1]), clamped(found.clamped[row])]


def test_inertial(asked: Asked) -> None:
    for number, questions in asked.by("inertial", lambda q: q.numbers[0]):
        found = asked.map.roads()[number & NOTHING].to_inertial(points(questions, 1, True))
        for row, question in enumerate(questions):
            assert poses(found, row) == question.answer


def test_pose(asked: Asked) -> None:
    questions = asked.kinds["pose"]
    s, offset = points(questions, 1).T.copy()
    found = asked.map.pose_at(np.array([q.numbers[0] for q in questions], np.uint64), s, offset)
    for row, question in enumerate(questions):
        assert poses(found, row) == question.answer


def test_position(asked: Asked) -> None:
    questions = asked.kinds["position"]
    found = asked.map.position_of(np.array([q.numbers[0] for q in questions], np.uint64), points(questions, 1))
    for row, question in enumerate(questions):
        assert column_place(found, row) == question.answer


def test_geodetic(asked: Asked) -> None:
    for question in asked.kinds["geodetic"]:
        x, y, z = question.f(0, 1, 2)
        try:
            answer = [1, *(bits(number) for number in asked.map.to_geodetic((x, y, z)))]
        except mapd.ProjectionError:
            answer = [0]
        assert answer == question.answer


def test_at(asked: Asked) -> None:
    questions = asked.kinds["at"]
    ids = np.array([q.numbers[0] for q in questions], np.uint64)
    rules = asked.map.speed_rule_at(ids, points(questions, 0)[:, 1].copy())
    for row, question in enumerate(questions):
        (s,) = question.f(1)
        own = asked.map.lane(question.numbers[0])
        rule = own.speed_rule_at(s)
        assert mapd.SPEED_ORIGINS[rules.origin[row]] == rule.origin and option(rules.max[row]) == option(rule.max)
        answer = [bits(own.width_at(s)), *option(own.recorded_speed_limit_at(s)), *option(rule.max), int(own.allows_at(s))]
        stretches = own.speed_rules()
        answer.append(len(stretches))
        for one in stretches:
            answer += [bits(one.s_from), bits(one.s_to), *option(one.rule.max), *option(one.lowest)]
        assert answer == question.answer


def test_lane(asked: Asked) -> None:
    kinds = {name: code for code, name in mapd.LANE_TYPES.items()}
    for question in asked.kinds["lane"]:
        own = asked.map.lane(question.numbers[0])
        answer = [text(own.key), own.number & NOTHING, kinds[own.kind], int(own.is_forward)]
        answer += [*(bits(s) for s in own.s_range), lane(own.left()), lane(own.right()), lane(own.opposite())]
        assert answer + lanes(own.successors()) + lanes(own.predecessors()) == question.answer


def test_line(asked: Asked) -> None:
    lines = asked.map.lines()
    places = {int(id): place for place, id in enumerate(lines.lane)}
    for question in asked.kinds["line"]:
        place = places[question.numbers[0]]
        s = lines.s[lines.offsets[place] : lines.offsets[place + 1]]
        rows = np.column_stack([s, lines[place]])
        assert [len(s), *(bits(number) for number in rows.ravel())] == question.answer


def test_ahead(asked: Asked) -> None:
    for question in asked.kinds["ahead"]:
        s, reach = question.f(1, 2)
        answer = []
        found = asked.map.signals_ahead((question.numbers[0], s), reach)
        for one in found:
            answer += [text(one.signal.id), one.lane.id, bits(one.distance), bits(one.s)]
        assert [len(found), *answer] == question.answer


def test_sequences(asked: Asked) -> None:
    for question in asked.kinds["sequences"]:
        s, reach = question.f(1, 2)
        found = asked.map.lane_sequences_ahead((question.numbers[0], s), reach)
        sizes = [len(found.network.pieces.lane), len(found.network.links.end)]
        assert [*sizes, *(number for one in found for number in lanes(one))] == question.answer


def route_of(asked: Asked, question: Question) -> mapd.Route | None:
    start, goal = ((question.numbers[place], as_float(question.numbers[place + 1])) for place in (0, 2))
    return asked.map.route(start, goal, by="time" if question.numbers[4] == 1 else "length")


def test_route(asked: Asked) -> None:
    for question in asked.kinds["route"]:
        route = route_of(asked, question)
        if route is None:
            assert question.answer == [0]
            continue
        answer = [1, bits(route.cost), bits(route.length), bits(route.travel_time), bits(route.assumed_time), route.lane_changes, len(route.steps)]
        for step in route.steps:
            answer += [step.lane.id, int(step.forward), ENTER[step.enter]]
            answer += [bits(step.s_from), bits(step.s_to), bits(step.s_latest)]
        assert answer == question.answer


def columns_of(found: mapd.Columns, row: int, names: Sequence[str] | None = None) -> list[int]:
    """All numbers of a row: doubles by their bits, the rest as they are."""

    def number(name: str, value: Any) -> int:
        if isinstance(value, np.float64):
            return bits(float(value))
        if name == "clamped":
            return clamped(value)
        return int(value) & 0xFF if isinstance(value, np.int8) else int(value)

    return [number(name, found[name][row]) for name in names or found.names]


# What questions about paths have of the room; those about rooms have the rest.
ROOM = [
    *("along", "lane"),
    *(f"{edge}_{axis}" for edge in ("left", "right", "outer_left", "outer_right") for axis in "xyz"),
    *(f"{edge}_{what}" for edge in ("left", "right") for what in ("mark", "color", "may_cross")),
]


def test_path(asked: Asked) -> None:
    for question in asked.kinds["path"]:
        route = route_of(asked, question)
        assert route is not None
        along, x, y, step = question.f(5, 6, 7, 8)
        path = asked.map.path(route)
        answer = [bits(path.length), int(path.is_broken), *lanes(path.lanes())]
        answer += columns_of(path.at(np.array([along])), 0)
        answer += columns_of(path.project(np.array([[x, y]])), 0)
        answer += option(path.speed_at(along).max)
        assert option(path.speed_at(np.array([along])).max[0]) == option(path.speed_at(along).max)
        room = path.corridor(step)
        answer.append(len(room))
        for row in range(len(room)):
            answer += columns_of(room, row, ROOM)
        conflicts = path.conflicts()
        answer.append(len(conflicts))
        for one in conflicts:
            answer += [bits(one.start), bits(one.end), one.other.id, bits(one.other_start), bits(one.other_end)]
            answer += [bits(one.wait), text(one.kind), text(one.yields), text(one.reason), len(one.lanes)]
            for lane in one.lanes:
                answer += [lane.other.id, bits(lane.start), bits(lane.end)]
        assert answer == question.answer


def node_of_piece(asked: Asked, found: mapd.Reached, row: int) -> list[int]:
    """Lane, direction, both ends of the node and cost of what is reached."""
    lane, forward = int(found.lane[row]), bool(found.forward[row])
    s_from, s_to = float(found.s_from[row]), float(found.s_to[row])
    node = asked.map.lane(lane).node_at(0.5 * (s_from + s_to), forward)
    assert node is not None
    ends = sorted((asked.nodes.s_from[node], asked.nodes.s_to[node]))
    return [lane, int(forward), *map(bits, ends), bits(found.cost[row])]


def test_reachable(asked: Asked) -> None:
    for question in asked.kinds["reachable"]:
        s, limit = question.f(1, 2)
        found = asked.map.reachable((question.numbers[0], s), limit)
        answer = [len(found)]
        for row in range(len(found)):
            answer += node_of_piece(asked, found, row)
        assert answer == question.answer


def test_lines(asked: Asked) -> None:
    for question in asked.kinds["lines"]:
        route = route_of(asked, question)
        assert route is not None
        found = asked.map.lines_along(route)
        answer = [len(found)]
        for line, distance in found:
            answer += [number(line.signal), number(line.object), line.lane.id, bits(line.s), bits(distance), CLASSES[line.meaning]]
        assert answer == question.answer


def test_ground(asked: Asked) -> None:
    for (has_z, lane_id), questions in asked.by("ground", lambda q: (q.numbers[3], q.numbers[4])):
        expected = asked.expected(lane_id)
        found = asked.map.ground_at(points(questions, with_z=has_z == 1), expected=expected)
        for row, question in enumerate(questions):
            there = found.lane[row] != mapd.NONE
            assert ([1, *columns_of(found, row)] if there else [0]) == question.answer
        for question in questions[:SINGLES]:
            x, y, z = question.f(0, 1, 2)
            one = asked.map.ground_at((x, y, z) if has_z else (x, y), expected=expected)
            assert (one is not None) == (question.answer[0] == 1)
            assert one is None or [bits(one.z), one.lane.id] == [question.answer[1], question.answer[7]]


def test_mark(asked: Asked) -> None:
    questions = asked.kinds["mark"]
    found = asked.map.nearest_mark(points(questions))
    for row, question in enumerate(questions):
        if question.answer[0] == 0:
            assert found.lane[row] == mapd.NONE
            continue
        codes = [int(found.side[row] == 1), int(found.kind[row]), int(found.color[row])]
        answer = columns_of(found, row)[:6] + codes + [{-1: 2, 0: 0, 1: 1}[int(found.painted[row])]]
        assert [1, *answer] == question.answer
    for question in questions[:SINGLES]:
        x, y = question.f(0, 1)
        one = asked.map.nearest_mark((x, y))
        assert (one is not None) == (question.answer[0] == 1)
        if one is not None:
            assert [one.lane.id, bits(one.distance)] == [question.answer[1], question.answer[5]]
            assert one.kind == mapd.MARK_KINDS[question.answer[8]] and one.color == mapd.MARK_COLORS[question.answer[9]]


def test_match(asked: Asked) -> None:
    for has_z, questions in asked.by("match", lambda q: q.numbers[3]):
        heading = np.array([q.f(4)[0] for q in questions])
        covariance = np.array([q.f(*range(5, 14)) for q in questions]).reshape(-1, 3, 3)
        found = asked.map.match_pose(points(questions, with_z=has_z == 1), heading, covariance)
        rows = iter(range(len(found)))
        for number, question in enumerate(questions):
            for k in range(question.answer[1]):
                row, want = next(rows), question.answer[2 + 14 * k : 16 + 14 * k]
                assert found.point[row] == number
                values = (found.probability[row], found.mahalanobis[row], found.heading_difference[row])
                assert [int(found.forward[row]), *map(bits, values)] == want[:4]
                assert column_place(found, row) == want[4:]
            row = next(rows)
            assert found.lane[row] == mapd.NONE and bits(found.probability[row]) == question.answer[0]
        assert next(rows, None) is None
        for place, question in enumerate(questions[:SINGLES]):
            x, y, z = question.f(0, 1, 2)
            one = asked.map.match_pose((x, y, z) if has_z else (x, y), float(heading[place]), covariance[place])
            assert bits(one.none) == question.answer[0] and len(one.lanes) == question.answer[1]


def test_trace(asked: Asked) -> None:
    for question in asked.kinds["trace"]:
        fixes = np.array([as_float(number) for number in question.numbers]).reshape(-1, 5)
        known = question.numbers[3::5]
        heading = np.where(np.array(known) == 1, fixes[:, 4], np.nan)
        found = asked.map.match_trace(fixes[:, 0].copy(), fixes[:, 1:3], heading=heading)
        answer = []
        for row in range(len(found)):
            there = found.lane[row] != mapd.NONE
            answer += [int(found.forward[row]), bits(found.probability[row]), int(there)]
            answer += column_place(found, row) if there else []
        want: list[int] = []
        rest = iter(question.answer)
        for _ in found.s:
            want += [next(rest), next(rest), there := next(rest)]
            want += [next(rest) for _ in range(10)] if there else []
        assert answer == want
