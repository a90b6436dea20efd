"""As test_answers: roads, junctions, and what a lane is made of, leads to and gives way to."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from test_answers import CLASSES, NOTHING, Asked, bits, clamped, columns_of, lane, lanes, number, text
from test_answers import asked as asked  # a fixture
from test_ways import TURNS

import mapd

KINDS = {name: code for code, name in mapd.MARK_KINDS.items()}
COLORS = {name: code for code, name in mapd.MARK_COLORS.items()}


def code(vocabulary: str, word: str) -> int:
    """The code that a word stands for."""
    (found,) = (code for code, own in mapd.WORDS[vocabulary].items() if own == word)
    return found


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
        assert answer + lanes([one for one in road.lanes(center=True) if one.section == 0]) == question.answer
        assert all(one.number != 0 for one in road.lanes())


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
        at = own.waypoint_at(s)
        answer += map(bits, (at.s, at.x, at.y, at.z, at.heading, at.width))
        answer += [*(bits(part) for side in bounds for part in side), bits(own.length_between(s, own.s_range[1]))]
        answer.append(number(own.speed_rule_at(s).signal))
        found = own.road_mark_at(s)
        answer += [0] if found is None else [1, *mark(found), bits(found.width)]
        assert answer == question.answer


def test_movement(asked: Asked) -> None:
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
            assert code("relation", one.relation) == relation and code("relation_reason", one.reason) == reason
        assert all(one.basis != "rule" for one in ways)
        by_rule = [one for one in own.right_of_way("DE") if one.basis == "rule"]
        assert all(one.relation in ("yields", "priority") for one in by_rule)
        written = [one.relation for one in ways if one.basis == "written"]
        assert written == [one.relation for one in own.right_of_way("DE") if one.basis == "written"]
        with pytest.raises(ValueError, match="XX"):
            own.right_of_way("XX")
        lights = own.movement_lights()
        assert len(lights) == next(numbers)
        assert lights == [one.signal for one in own.movement_lights_on()]
        on = [part for one in own.movement_lights_on() for part in (number(one.signal), one.lane.id)]
        assert on == list(numbers)
        given_way = [one.other for one in ways if one.relation == "yields"]
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
        places = asked.map.placements_in(box)
        assert [place.object for place in places] == objects
        for place in places:
            assert [number(place.object), NOTHING if place.copy is None else place.copy] == some(numbers, 2)
        answer: list[int] = []
        landmarks = asked.map.landmarks_in(box)
        answer.append(len(landmarks))
        for one in landmarks:
            answer += map(bits, (one.x, one.y, one.z, one.distance))
        bounds = asked.map.boundary_segments(box)
        answer.append(len(bounds))
        for row in range(len(bounds)):
            answer += columns_of(bounds, row)
        marks = asked.map.road_mark_segments(box)
        answer.append(len(marks))
        for row in range(len(marks)):
            answer += columns_of(marks, row, ["lane", "s_from", "width", "kind", "color"])
        assert answer == list(numbers)


def test_details(asked: Asked) -> None:
    for question in asked.kinds["details"]:
        own, (s,) = asked.map.lane(question.numbers[0]), question.f(1)
        pose = own.pose_of_reference_line(s, 0.5)._asdict()
        end = clamped(pose.pop("clamped"))
        rule = own.overtaking_rule_at(s)
        answer = [*map(bits, pose.values()), end, bits(own.time_between(s, own.s_range[1]))]
        answer += [number(rule.all), number(rule.trucks), *map(bits, own.height_at(s)), *friction(own.material_at(s))]
        marks = own.road_marks()
        answer.append(len(marks))
        for one in marks:
            answer += [*map(bits, (one.s, one.s_end, one.width)), *mark(one)]
        objects = own.objects_on()
        assert [thing.object for thing in objects] == own.objects()
        answer.append(len(objects))
        for thing in objects:
            answer += [number(thing.object), *map(bits, (thing.s_from, thing.s_to, thing.distance))]
        stop = own.movement_stop()
        for all in (own.lines_to_stop_at(), own.crossings(), own.movement_crossings(), [] if stop is None else [stop]):
            answer.append(len(all))
            for at in all:
                answer += [at.lane.id, bits(at.s), CLASSES[at.meaning]]
        node = own.node_at(s)
        content = own.id & ~NOTHING
        before = [] if node is None else asked.edges.start[asked.edges.end == node].tolist()
        answer += [NOTHING if node is None else content | node, len(before)]
        # The order of what comes before a node is the archive's.
        assert answer == question.answer[: len(answer)]
        assert sorted(content | one for one in before) == sorted(question.answer[len(answer) :])


def link(one: mapd.SignalLink) -> list[int]:
    return [text(one.id), text(one.kind), number(one.signal), number(one.object), int(one.is_object)]


def test_sign(asked: Asked) -> None:
    signals = {number(one): one for one in asked.map.signals()}
    for question in asked.kinds["sign"]:
        own = signals[question.numbers[0]]
        answer = [len(signals), text(asked.map.signal(own.id).id)]
        for links in (own.dependencies(), own.links()):
            answer += [len(links), *(part for one in links for part in link(one))]
        controllers = own.controllers()
        answer += [*lanes(own.movements()), len(controllers), *(one.number for one in controllers)]
        assert answer == question.answer


def test_thing(asked: Asked) -> None:
    objects = {number(one): one for one in asked.map.objects()}
    for question in asked.kinds["thing"]:
        own = objects[question.numbers[0]]
        answer = [len(objects), number(asked.map.object(own.id)), len(own.lanes())]
        for at in own.lanes():
            answer += [at.lane.id, bits(at.s_from), bits(at.distance)]
        answer.append(len(own.placements()))
        for place in own.placements():
            answer += map(bits, (place.x, place.y, place.z, place.heading, place.length, place.height))
            answer += [len(place.footprint), *map(bits, place.footprint.ravel())]
        assert answer == question.answer


def test_earth(asked: Asked) -> None:
    for question in asked.kinds["earth"]:
        latitude, longitude, altitude = question.f(0, 1, 2)
        point = asked.map.from_geodetic((latitude, longitude, altitude))
        assert [bits(part) for part in point] == question.answer
        assert asked.map.nearest_lane_geodetic((latitude, longitude, altitude)) == asked.map.nearest_lane(point)


def test_whole(asked: Asked) -> None:
    (question,) = asked.kinds["whole"]
    answer = [len(asked.nodes)]
    junctions, controllers = asked.map.junctions(), asked.map.controllers()
    answer.append(len(junctions))
    for own in junctions:
        assert asked.map.junction(own.id) == own
        answer += [number(own), text(own.id), number(own), len(own.connections())]
        for one in own.connections():
            answer += [text(one.id), code("contact_point", one.contact_point)]
        numbers = [part.number for id in own.controllers() for part in controllers if part.id == id]
        answer += [len(numbers), *numbers]
    answer.append(len(controllers))
    for controller in controllers:
        answer += [text(controller.id), text(controller.name)]
    groups = asked.map.junction_groups()
    answer.append(len(groups))
    for group in groups:
        answer += [text(group.id), code("junction_group_kind", group.kind), len(group.junctions), *lanes(list(group.ring))]
    structures = asked.map.structures()
    answer.append(len(structures))
    for structure in structures:
        answer += [text(structure.id), bits(structure.s_from), bits(structure.s_to), code("structure_kind", structure.kind)]
    references = asked.map.object_references()
    answer.append(len(references))
    for reference in references:
        answer += [text(reference.id), bits(reference.s), bits(reference.t)]
    bounds = asked.map.geodetic_bounds
    answer += [len(asked.map.quarantined()), int(bounds is not None), *map(bits, bounds or ())]
    assert answer == question.answer
