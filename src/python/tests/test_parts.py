"""As test_answers: roads, junctions, and what a lane is made of, leads to and gives way to."""

from __future__ import annotations

from collections.abc import Iterator

from test_answers import NOTHING, Asked, bits, clamped, lane, lanes, number, text
from test_answers import asked as asked  # a fixture
from test_ways import TURNS, line

import mapd

KINDS = {name: code for code, name in mapd.MARK_KINDS.items()}
COLORS = {name: code for code, name in mapd.MARK_COLORS.items()}


class Words:
    """Words of Python and codes of answers: one of each for each."""

    def __init__(self) -> None:
        self.codes: dict[str, int] = {}

    def code(self, word: str, code: int) -> int:
        """What the word stood for before, else this code, which no other word stands for."""
        assert word in self.codes or code not in self.codes.values()
        return self.codes.setdefault(word, code)


def some(numbers: Iterator[int], count: int) -> list[int]:
    """The next numbers of an answer."""
    return [next(numbers) for _ in range(count)]


def mark(one: mapd.RoadMark) -> list[int]:
    return [KINDS[one.kind], COLORS[one.color]]


def friction(material: mapd.Material | None) -> list[int]:
    value = None if material is None else material.friction
    return [int(material is not None), bits(-1.0 if value is None else value)]


def test_road(asked: Asked) -> None:
    for question in asked.kinds["road"]:
        road = asked.map.roads()[question.numbers[0] & NOTHING]
        s, t = question.f(1, 2)
        answer = [text(road.id), *map(bits, (road.elevation_at(s), road.superelevation_at(s), road.lane_offset_at(s)))]
        answer.append(lane(road.lane_at(s, t)))
        # Lane 0 is in the answer, and not among the lanes of Python.
        first = [one.id for one in road.lanes() if one.section == 0]
        count, *ids = question.answer[5:]
        assert answer == question.answer[:5] and count == len(ids) and set(first) < set(ids)


def test_surface(asked: Asked) -> None:
    for question in asked.kinds["surface"]:
        road = asked.map.roads()[question.numbers[0] & NOTHING]
        at = road.surface_at(*question.f(1, 2))
        answer = [*map(bits, (at.x, at.y, at.z, at.nx, at.ny, at.nz)), lane(at.lane)]
        assert [*answer, *friction(at.material), clamped(at.clamped)] == question.answer


def test_edges(asked: Asked) -> None:
    for question in asked.kinds["edges"]:
        own, (s,) = asked.map.lane(question.numbers[0]), question.f(1)
        bounds = own.bounds_at(s)
        assert bounds is not None
        answer = [bits(edge) for edge in own.edges_at(s)]
        # Single waypoints have no form in Python: those of `waypoints` are asked instead.
        waypoint = question.answer[2:8]
        answer += [*waypoint, *(bits(part) for side in bounds for part in side), bits(own.length_between(s, own.s_range[1]))]
        answer.append(number(own.speed_rule_at(s).signal))
        found = own.road_mark_at(s)
        answer += [0] if found is None else [1, *mark(found), bits(found.width)]
        assert answer == question.answer


def test_movement(asked: Asked) -> None:
    relations, reasons = Words(), Words()
    for question in asked.kinds["movement"]:
        own = asked.map.lane(question.numbers[0])
        numbers = iter(question.answer)
        for found in (own.entries(), own.movement_lanes()):
            assert lanes(found) == some(numbers, 1 + len(found))
        assert TURNS[own.turn] == next(numbers)
        ways = own.right_of_way()
        assert len(ways) == next(numbers)
        for one in ways:
            other, relation, reason = some(numbers, 3)
            assert lane(one.other) == other
            assert relations.code(one.relation, relation) == relation and reasons.code(one.reason, reason) == reason
        lights = own.movement_lights()
        assert len(lights) == next(numbers)
        # The lane before each light is in the answer only.
        assert [number(light) for light in lights] == some(numbers, 2 * len(lights))[::2]
        given_way = [one.other for one in ways if one.relation == "yields" and one.basis == "written"]
        assert {one.id for one in own.yields_to()} <= {one.id for one in given_way if one is not None}


def test_junction(asked: Asked) -> None:
    for question in asked.kinds["junction"]:
        s, reach = question.f(1, 2)
        found = asked.map.next_junction((question.numbers[0], s), reach)
        answer = [0] if found is None else [1, hash(found[0]) & 0xFFFFFFFFFFFFFFFF, bits(found[1])]
        assert answer == question.answer


def test_region(asked: Asked) -> None:
    for question in asked.kinds["region"]:
        x_min, y_min, x_max, y_max = question.f(0, 1, 2, 3)
        box, numbers = (x_min, y_min, x_max, y_max), iter(question.answer)
        found = asked.map.lanes_in(box)
        assert lanes(found) == some(numbers, 1 + len(found))
        signals = asked.map.signals_in(box)
        assert [len(signals), *map(number, signals)] == some(numbers, 1 + len(signals))
        objects = asked.map.objects_in(box)
        assert len(objects) == next(numbers)
        # Which of its places an object is at is in the answer only.
        assert [number(one) for one in objects] == some(numbers, 2 * len(objects))[::2]


def test_details(asked: Asked) -> None:
    for question in asked.kinds["details"]:
        own, (s,) = asked.map.lane(question.numbers[0]), question.f(1)
        # A pose of the reference line, a time and bans of overtaking have no form here.
        numbers = iter(question.answer[11:])
        assert [bits(height) for height in own.height_at(s)] == some(numbers, 2)
        assert friction(own.material_at(s)) == some(numbers, 2)
        marks = own.road_marks()
        assert len(marks) == next(numbers)
        for one in marks:
            assert [*map(bits, (one.s, one.s_end, one.width)), *mark(one)] == some(numbers, 5)
        objects = own.objects()
        assert len(objects) == next(numbers)
        assert [number(one) for one in objects] == some(numbers, 4 * len(objects))[::4]
        stop = own.movement_stop()
        for all in (own.lines_to_stop_at(), own.crossings(), own.movement_crossings(), [] if stop is None else [stop]):
            assert len(all) == next(numbers)
            for at in all:
                assert line(at)[2:4] == some(numbers, 3)[:2]


def test_earth(asked: Asked) -> None:
    for question in asked.kinds["earth"]:
        latitude, longitude, altitude = question.f(0, 1, 2)
        assert [bits(part) for part in asked.map.from_geodetic((latitude, longitude, altitude))] == question.answer


def test_whole(asked: Asked) -> None:
    contacts = Words()
    (question,) = asked.kinds["whole"]
    numbers = iter(question.answer[1:])
    junctions = asked.map.junctions()
    assert len(junctions) == next(numbers)
    for own in junctions:
        id = hash(own) & 0xFFFFFFFFFFFFFFFF
        assert [id, text(own.id), id] == some(numbers, 3)
        assert asked.map.junction(own.id) == own
        connections = own.connections()
        assert len(connections) == next(numbers)
        for one in connections:
            name, contact = some(numbers, 2)
            assert text(one.id) == name and contacts.code(one.contact_point, contact) == contact
        assert len(own.controllers()) >= len(some(numbers, next(numbers)))
