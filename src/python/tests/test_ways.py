"""As test_answers: what a path comes by, what is laid over a map, drives and sensors."""

from __future__ import annotations

from typing import Any

import numpy as np
from test_answers import ENTER, NOTHING, Asked, bits, column_place, lane, node_of_piece, number, option, place_of, route_of, text
from test_answers import asked as asked  # a fixture

import mapd

TURNS = {"left": 1, "straight": 2, "right": 4, "back": 8}
FACTS = ["junction", "signal", "line", "road_type", "lane_type", "structure", "hole", "country", "access"]
CHANGE = 15.0
WHEELS = np.array([[2.0, 0.8], [2.0, -0.8], [-1.0, 0.8], [-1.0, -0.8]])


def steps_of(steps: tuple[mapd.RouteStep, ...]) -> list[int]:
    out = [len(steps)]
    for step in steps:
        out += [step.lane.id, int(step.forward), ENTER[step.enter]]
        out += [bits(step.s_from), bits(step.s_to), bits(step.s_latest)]
    return out


def line(one: mapd.LaneLine) -> list[int]:
    return [number(one.signal), number(one.object), one.lane.id, bits(one.s), text(one.meaning)]


def fact(one: mapd.PathFact) -> list[int]:
    out = [bits(one.start), bits(one.end), one.lane.id, FACTS.index(one.kind)]
    if one.kind == "junction":
        return [*out, text(one.junction or ""), TURNS[one.name or ""]]
    if one.kind == "signal":
        return [*out, number(one.signal), int(one.governs or False)]
    if one.kind == "line":
        assert one.line is not None and one.left is not None and one.right is not None
        return [*out, *line(one.line), *map(bits, one.left + one.right)]
    if one.kind == "hole":
        return [*out, one.number or 0]
    if one.kind == "access":
        return [*out, sum(map(text, one.vehicles or ())) % 2**64]
    out.append(text(one.name or ""))
    return [*out, one.number or 0] if one.kind == "structure" else out


def test_along(asked: Asked) -> None:
    for question in asked.kinds["along"]:
        route = route_of(asked, question)
        assert route is not None
        start, end, reach = question.f(5, 6, 7)
        path = asked.map.path(route)
        facts, speeds, segments, crossings = path.facts(), path.speeds(), path.segments(), path.crossings()
        answer = [len(facts), *(part for one in facts for part in fact(one)), len(speeds)]
        for speed in speeds:
            answer += [bits(speed.start), bits(speed.end), *option(speed.rule.max), number(speed.rule.signal)]
        answer += map(bits, path.travel_time(start, end))
        answer.append(len(segments))
        for row in range(len(segments)):
            answer += [bits(segments.start[row]), bits(segments.end[row]), int(segments.lane[row])]
            answer += [bits(segments.last_change[row]), bits(segments.lane_end[row]), int(segments.changes[row])]
            answer += [int(segments.forward[row]), int(segments.driven[row])]
        try:
            answer += steps_of(path.steps_between(start, end))
        except mapd.PathError:
            answer.append(0)
        answer.append(len(crossings))
        for crossing in crossings:
            answer += [bits(crossing.start), bits(crossing.end), bits(crossing.wait)]
            answer += [*line(crossing.line), text(crossing.yields)]
        conflicts = path.conflicts()
        comes = asked.map.approaches(conflicts[0], reach) if conflicts else mapd.Approaches(0)
        answer.append(len(comes))
        for row in range(len(comes)):
            answer += [int(comes.lane[row]), bits(comes.s_from[row]), bits(comes.s_to[row])]
            answer += [bits(comes.distance_from[row]), bits(comes.distance_to[row]), int(comes.forward[row])]
        rebased = path.rebase(asked.map)
        answer += [int(rebased.route is not None), bits(rebased.route.cost if rebased.route else 0.0)]
        answer += [*steps_of(rebased.route.steps if rebased.route else ()), len(rebased.changes)]
        curved = asked.map.path(route, change_length=CHANGE)
        joints = curved.joints()
        answer += [bits(curved.length), len(joints)]
        for joint in joints:
            answer += [bits(joint.along), bits(joint.gap), bits(joint.kink), ENTER[joint.enter]]
            answer += [int(joint.broken), int(joint.short)]
        assert answer == question.answer


def written(value: float) -> int:
    """What is not given is negative."""
    return bits(-1.0 if np.isnan(value) else value)


def test_room(asked: Asked) -> None:
    for question in asked.kinds["room"]:
        route = route_of(asked, question)
        assert route is not None
        (step,) = question.f(5)
        path = asked.map.path(route)
        room, surface = path.corridor(step), path.corridor_surface(step)
        answer = [len(room)]
        for row in range(len(room)):
            answer += [bits(room.s[row]), *option(room.speed[row])]
            answer += [text(mapd.EDGES[room[f"{side}_edge"][row]]) for side in ("left", "right")]
            for side in ("outer_left", "outer_right"):
                answer += [int(room[f"{side}_{what}"][row]) & 0xFF for what in ("mark", "color", "may_cross")]
                answer.append(text(mapd.EDGES[room[f"{side}_edge"][row]]))
            answer += [bits(surface[name][row]) for name in ("x", "y", "z", "nx", "ny", "nz")]
            answer += [written(surface.friction[row]), written(surface.roughness[row])]
        for points, is_simple in (room.outline("driven"), room.outline("open")):
            answer += [int(is_simple), len(points), *(bits(number) for number in points.ravel())]
        assert answer == question.answer


def test_comes(asked: Asked) -> None:
    for question in asked.kinds["comes"]:
        s, limit = question.f(1, 2)
        found = asked.map.reachable_to((question.numbers[0], s), limit)
        pieces = [number for row in range(len(found)) for number in node_of_piece(asked, found, row)]
        assert [len(found), *pieces] == question.answer


def pieces(found: mapd.Reached) -> list[int]:
    out = [len(found)]
    for row in range(len(found)):
        low, high = sorted((found.s_from[row], found.s_to[row]))
        out += [int(found.lane[row]), int(found.forward[row]), bits(low), bits(high), bits(found.cost[row])]
    return out


def restriction(one: mapd.Restriction | None) -> list[int]:
    return [NOTHING] if one is None else [one.entry.number, one.lane.id, bits(one.s_from), bits(one.s_to)]


def restrictions(all: list[mapd.Restriction]) -> list[int]:
    return [len(all), *(number for one in all for number in restriction(one))]


def on_path(view: mapd.View, path: mapd.Path) -> list[int]:
    met = view.restrictions_on_path(path)
    out = [len(met)]
    for one in met:
        out += [bits(one.start), bits(one.end), *restriction(one.restriction)]
    middle = view.speed_on_path(path, 0.5 * path.length)
    assert option(view.speed_on_path(path, np.array([0.5 * path.length])).max[0]) == option(middle.max)
    out += [*option(middle.max), *restriction(middle.restriction)]
    room = view.corridor(path, path.length / 4.0)
    out.append(len(room))
    for row in range(len(room)):
        out += [bits(room[f"{side}_{axis}"][row]) for side in ("outer_left", "outer_right") for axis in "xyz"]
        out.append(int(room.left_may_cross[row]))
        out += option(room.speed[row])
        out.append(int(mapd.SPEED_ORIGINS[room.speed_origin[row]] == "overlay"))
    speeds = view.speeds_on_path(path)
    out.append(len(speeds))
    for stretch in speeds:
        out += [bits(stretch.start), bits(stretch.end), *option(stretch.speed.max)]
        out += restriction(stretch.speed.restriction)
    time = view.travel_time_on_path(path)
    out += [bits(time.time), bits(time.unlimited)]
    segments = view.segments_on_path(path)
    out.append(len(segments))
    for row in range(len(segments)):
        out += [bits(segments.start[row]), bits(segments.end[row]), int(segments.lane[row])]
        out += [int(segments.changes[row]), bits(segments.last_change[row])]
    return out


def test_today(asked: Asked) -> None:
    signals = {number(one): one for one in asked.map.signals()}
    for question in asked.kinds["today"]:
        at, s, goal_s, limit, x, y, heading = question.f(0, 2, 4, 5, 7, 8, 9)
        start, goal = (question.numbers[1], s), (question.numbers[3], goal_s)
        view = asked.under.view(at)
        entries = view.entries()
        answer = [len(entries)]
        for entry in entries:
            answer += [text(entry.id), text(entry.kind), text(entry.source), bits(-1.0 if entry.value is None else entry.value)]
            answer += [bits(entry.confidence), int("pedestrian" in entry.vehicles), int(entry.holds)]
        answer.append(len(view.restrictions()))
        permission, speed = view.allows(start), view.speed_rule_at(start)
        many = np.array([question.numbers[1]], np.uint64), np.array([s])
        assert bool(view.allows(*many).is_allowed[0]) == permission.is_allowed
        assert option(view.speed_rule_at(*many).max[0]) == option(speed.max)
        answer += [int(permission.is_allowed), *restriction(permission.restriction)]
        answer += [*option(speed.max), *option(speed.map.max), *restriction(speed.restriction)]
        answer += restrictions(view.restrictions_at(start))
        signal = signals.get(question.numbers[6])
        off = view.signal_out_of_service(signal) if signal else None
        answer.append(NOTHING if off is None else off.number)
        route = view.route(start, goal)
        steps = route.steps if route else ()
        answer += [int(route is not None), bits(route.cost if route else 0.0), *steps_of(steps)]
        answer += restrictions(view.restrictions_along(steps))
        try:
            path: mapd.Path | None = asked.under.path(steps)
        except mapd.PathError:
            path = None
        answer += [0] if path is None else [1, *on_path(view, path)]
        answer += pieces(view.reachable(start, limit))
        ahead = view.signals_ahead(start, limit)
        answer.append(len(ahead))
        for one in ahead:
            answer += [number(one.signal), one.lane.id, bits(one.distance), bits(one.s)]
        covariance = np.diag([0.5, 0.5, 0.01])
        found = view.match_pose((x, y), heading, covariance, vehicle="passengerCar")
        answer += [bits(found.none), len(found.lanes)]
        for match in found.lanes:
            answer += [lane(match.lane), int(match.forward), bits(match.probability)]
        assert answer == question.answer


def test_tracker(asked: Asked) -> None:
    covariance = np.diag([0.5, 0.5, 0.02])
    for question in asked.kinds["tracker"]:
        own, *numbers = question.numbers
        tracker, many = mapd.Tracker(), mapd.Tracker()
        answer: list[int] = []
        want: list[int] = []
        rest = iter(question.answer)
        fixes = []
        for k in range(0, len(numbers), 6):
            time, x, y, heading, _, odometer = (np.uint64(number).view(np.float64) for number in numbers[k : k + 6])
            way = float(odometer) if numbers[k + 4] == 1 else None
            fixes.append((time, x, y, heading, np.nan if way is None else way))
            found = tracker.update(asked.map, float(time), (float(x), float(y)), float(heading), covariance, odometer=way)
            answer.append(mapd.TRACKED.index(found.state))
            want.append(state := next(rest))
            if found.found is not None:
                answer += [int(found.found.forward), bits(found.found.probability), found.found.lane.id, *place_of(found.found._asdict())]
            if state == 0:
                want += [next(rest), next(rest)]
                want += [next(rest) for _ in range(10)]
            known = tracker.hypotheses()
            answer += [bits(known.none), len(known.lanes), bits(tracker.probability_in([own]))]
            want += [next(rest) for _ in range(3)]
        assert answer == want
        columns = np.array(fixes).T.copy()
        batch: Any = many.update(asked.map, columns[0], columns[1:3].T, columns[3], covariance, odometer=columns[4])
        assert bits(batch.none[-1]) == bits(tracker.hypotheses().none)
        if batch.state[-1] == 0:
            assert column_place(batch, len(batch) - 1)[0] == int(batch.lane[-1]) == tracker.hypotheses().lanes[0].lane.id


def test_stance(asked: Asked) -> None:
    for question in asked.kinds["stance"]:
        x, y, z, heading = question.f(0, 1, 2, 4)
        at = (x, y, z) if question.numbers[3] == 1 else (x, y)
        expected = asked.expected(question.numbers[5])
        one = asked.map.stance(at, heading, WHEELS, expected=expected)
        many = asked.map.stance(np.array([at]), heading, WHEELS, expected=expected)
        if one is None:
            assert question.answer == [0] and np.isnan(many.z[0])
            continue
        wheels = [number for wheel in one.wheels for number in option(wheel)]
        assert [1, bits(one.z), bits(one.roll), bits(one.pitch), *wheels] == question.answer
        assert bits(many.z[0]) == bits(one.z) and bits(many.pitch[0]) == bits(one.pitch)


def test_sees(asked: Asked) -> None:
    for question in asked.kinds["sees"]:
        x, y, heading, range_, angle = question.f(0, 1, 2, 3, 4)
        seen = asked.map.landmarks_in_view((x, y), heading, range_, angle)
        answer = [len(seen)]
        for one in seen:
            copy = NOTHING if one.landmark.copy is None else one.landmark.copy
            answer += [number(one.landmark.signal), number(one.landmark.object), copy]
            answer += [bits(one.landmark.distance), bits(one.bearing), bits(one.facing)]
        assert answer == question.answer


def test_paint(asked: Asked) -> None:
    for question in asked.kinds["paint"]:
        x_min, y_min, x_max, y_max, spacing = question.f(0, 1, 2, 3, 4)
        found = asked.map.mark_points((x_min, y_min, x_max, y_max), spacing)
        answer = [len(found)]
        for row in range(len(found)):
            lane, owner = (NOTHING if found[name][row] == 2**64 - 1 else int(found[name][row]) for name in ("lane", "object"))
            copy = NOTHING if found["copy"][row] < 0 else int(found["copy"][row])
            answer += [*(bits(found[name][row]) for name in "xyz"), lane, owner, copy, int(found.outline[row])]
            answer += [bits(found.s[row]), bits(found.width[row]), int(found.kind[row]) & 0xFF, int(found.color[row]) & 0xFF]
        assert answer == question.answer


def pieces_and_links(found: mapd.Reach) -> list[int]:
    all, links = found.pieces, found.links
    out = [len(all)]
    for row in range(len(all)):
        low, high = sorted((all.s_from[row], all.s_to[row]))
        out += [int(all.lane[row]), int(all.forward[row]), bits(all.cost[row]), bits(low), bits(high), int(all.lane_changes[row])]
        own = np.flatnonzero(links.start == row)
        out += [len(own), *(int(number) for link in own for number in (links.end[link], links.enter[link]))]
    return out


def test_request(asked: Asked) -> None:
    for question in asked.kinds["request"]:
        ends = []
        for k in range(0, 16, 4):
            s, cost = question.f(k + 1, k + 2)
            forward = {0: None, 1: True, 2: False}[question.numbers[k + 3]]
            ends.append(mapd.RouteEnd(question.numbers[k], s, forward, cost))
        turn, limit = question.f(17, 18)
        starts, goals = ends[:2], ends[2:]
        more: dict[str, Any] = {"avoid": [question.numbers[16]], "turns": [turn, 0.5 * turn, 90.0]}
        route = asked.map.find_route(starts, goals, **more)
        answer = [int(route is not None)]
        if route is not None:
            answer += [bits(route.cost), bits(route.length), route.start, route.goal, *steps_of(route.steps)]
        assert asked.map.view().find_route(starts, goals, **more) == route
        routes = asked.map.alternatives(starts, goals, **more)
        answer.append(len(routes))
        for one in routes:
            answer += [bits(one.cost), *steps_of(one.steps)]
        answer += pieces_and_links(asked.map.reach(limit, starts=starts, **more))
        answer += pieces_and_links(asked.map.reach(limit, goals=goals, **more))
        assert answer == question.answer
