"""Maps, their parts, routes and views."""

from __future__ import annotations

import copy
import gc
import pickle
import re
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import MAPS

import mapd
from mapd import _errors
from mapd._layout import TABLES


def test_what_does_not_change_is_its_own_copy(town: mapd.Map) -> None:
    route = town.route(("1:0:-1", 38.0), ("1:0:-1", 60.0))
    parts = [town, town.lane("1:0:-1"), town.road("1"), town.junctions()[0], town.view(0.0)]
    parts += [*town.signals()[:1], *town.objects()[:1]]
    assert route is not None
    parts.append(town.path(route))
    for part in parts:
        assert copy.copy(part) is part and copy.deepcopy({"part": [part]})["part"][0] is part


def test_parts_say_what_they_are(town: mapd.Map) -> None:
    lane = town.lane("1:0:-1")
    assert lane.key == "1:0:-1" and lane.road.id == "1" and lane.number == -1 and lane.kind == "driving"
    assert repr(lane) == "<mapd.Lane 1:0:-1 driving s 0.00 to 76.00 m>"
    assert repr(lane.road) == '<mapd.Road 1 "Street 1" 76.00 m>'
    assert repr(town).startswith('<mapd.Map "town" generation 0: 56 roads')
    assert lane == town.lane(lane.id) == town.lane(np.uint64(lane.id)) and hash(lane) == hash(town.lane(lane.id))
    assert lane != town.lane("1:0:1") and lane != "1:0:-1"
    assert lane.opposite() == town.lane("1:0:1")
    assert [one.predecessors()[0] for one in lane.successors()] == [lane] * len(lane.successors())
    assert lane.speed_rule_at(1.0).max == pytest.approx(50 / 3.6)
    assert set(town.lanes()) == {lane for road in town.roads() for lane in road.lanes()}


def test_signals_and_objects(other: mapd.Map) -> None:
    thing = other.objects()[0]
    assert other.object(thing.id) == thing and thing.id in repr(thing)
    assert thing.footprint().shape[1] == 3
    assert any(near == thing for near, _ in other.objects_near(thing.position[:2], 1.0))
    for signal in other.signals():
        assert other.signal(signal.id) == signal and signal.id in repr(signal)
        assert (signal, 0.0) in other.signals_near(signal.position[:2], 1.0)


def test_frenet_there_and_back(town: mapd.Map) -> None:
    road = town.road("1")
    tracks = np.column_stack([np.linspace(0.5, 75.5, 50), np.linspace(-3.0, 3.0, 50)])
    poses = road.to_inertial(tracks)
    back = road.to_track(np.column_stack([poses.x, poses.y]))
    assert np.allclose(np.column_stack([back.s, back.t]), tracks, atol=1e-9) and back.exact.all()
    one = road.to_inertial((0.5, -3.0))
    assert (one.x, one.y, one.heading) == (poses.x[0], poses.y[0], poses.heading[0])


def test_positions_and_poses_of_lanes(town: mapd.Map) -> None:
    lanes = np.array([lane.id for lane in town.lanes()], np.uint64)
    starts = np.array([lane.s_range[0] for lane in town.lanes()])
    poses = town.pose_at(lanes, starts + 0.5, 0.25)
    back = town.position_of(lanes, np.column_stack([poses.x, poses.y]))
    assert np.allclose(back.s, starts + 0.5, atol=1e-6) and np.allclose(back.offset, 0.25, atol=1e-6)


def test_ground_is_the_surface() -> None:
    surfaces = mapd.open(MAPS / "surfaces.xodr")
    lane = surfaces.lanes()[0]
    middle = lane.pose_at(sum(lane.s_range) / 2)
    ground = surfaces.ground_at((middle.x, middle.y))
    assert ground is not None and np.hypot(np.hypot(ground.nx, ground.ny), ground.nz) == pytest.approx(1)
    many = surfaces.ground_at(np.array([[middle.x, middle.y], [1e5, 1e5]]))
    assert many.z[0] == ground.z and np.isnan(many.z[1]) and many.lane[1] == mapd.NONE


def test_matches_add_up_to_one(town: mapd.Map) -> None:
    points = np.array([[50.0, -1.75], [1e5, 1e5]])
    covariance = np.diag([0.3, 0.3, 0.1]) ** 2
    found = town.match_pose(points, 0.0, covariance)
    assert found.lane[0] == town.lane("1:0:-1").id and found.probability[0] > 0.9
    assert np.bincount(found.point, found.probability) == pytest.approx(np.ones(2), abs=1e-6)
    assert found.lane[-1] == mapd.NONE and found.probability[-1] == pytest.approx(1.0)
    one = town.match_pose((50.0, -1.75), 0.0, covariance, expected=["1:0:1"])
    assert one.lanes[0].lane == town.lane("1:0:-1") and one.none > 0.0
    # A third of the vehicle beyond the line, which it heads along; nothing is known of the heading, so that both ways count.
    blind = np.diag([0.0, 0.0, 1e6])
    wide = town.match_pose((50.0, 0.0), 0.0, blind, outline=(2.0, 1.0, 0.6, 1.2))
    share = {one.lane: one.probability for one in wide.lanes}
    assert share[town.lane("1:0:-1")] / share[town.lane("1:0:1")] == pytest.approx(2.0, abs=1e-3)
    with pytest.raises(ValueError, match=r"outline\.left"):
        town.match_pose(points, 0.0, covariance, outline=(1.0, 1.0, -1.0, 1.0))
    with pytest.raises(ValueError, match=r"outline\.front"):
        mapd.Tracker(outline=(-1.0, 1.0, 1.0, 1.0)).update(town, 0.0, (50.0, 0.0), 0.0, covariance)
    for wrong, says in ((-covariance, "negative"), (np.zeros((2, 2)), "(3, 3)"), (np.zeros((3, 3, 3)), "(2, 3, 3)")):
        with pytest.raises(ValueError, match=re.escape(says)):
            town.match_pose(points, 0.0, wrong)
    with pytest.raises(mapd.NotFiniteError, match=r"row 1.*covariance\[0\]\[0\]"):
        town.match_pose(points, 0.0, np.stack([covariance, covariance * np.nan]))
    with pytest.raises(ValueError, match="none"):
        town.match_pose(points, 0.0, covariance, none=0.0)


def test_traces_follow_the_lane(town: mapd.Map) -> None:
    time, points = np.arange(5.0), np.column_stack([np.linspace(20.0, 60.0, 5), np.full(5, -1.75)])
    out = mapd.TraceMatches(5)
    assert town.match_trace(time, points, out=out) is out
    assert (out.lane == town.lane("1:0:-1").id).all() and (out.probability > 0.5).all()
    with pytest.raises(ValueError, match="fix 1 is earlier"):
        town.match_trace(time[::-1].copy(), points)


def test_marks_have_words() -> None:
    marks = mapd.open(MAPS / "marks.xodr")
    lane = marks.lanes()[0]
    pose = lane.pose_at(sum(lane.s_range) / 2)
    one = marks.nearest_mark((pose.x, pose.y))
    assert one is not None and one.kind in mapd.MARK_KINDS.values()
    many = marks.nearest_mark(np.array([[pose.x, pose.y], [1e5, 1e5]]))
    assert mapd.MARK_KINDS[int(many.kind[0])] == one.kind and many.lane[1] == mapd.NONE
    assert marks.nearest_mark((pose.x, pose.y), radius=1e-6) is None
    with pytest.raises(ValueError, match="kinds"):
        marks.nearest_mark((0.0, 0.0), kinds=["nonsense"])

def test_routes_and_what_can_be_reached(town: mapd.Map) -> None:
    start, goal = town.nearest_lane((50.0, -1.75)), town.nearest_lane((150.0, 101.75))
    assert start is not None and goal is not None
    route = town.route(start, goal)
    assert route is not None and route.steps[0].lane == start.lane and route.steps[-1].lane == goal.lane
    assert route.length == pytest.approx(sum(abs(step.s_to - step.s_from) for step in route.steps), rel=0.2)
    assert repr(route).startswith("<mapd.Route ")
    assert town.route(("1:0:-1", 1.0), (goal.lane.id, goal.s), by="time", lane_change=1.0) is not None
    reached = town.reachable(start, route.length + 100.0)
    assert goal.lane.id in reached.lane and (np.diff(reached.cost) >= 0).all()
    for sequence in town.lane_sequences_ahead(start, 200.0):
        assert sequence[0] == start.lane
    with pytest.raises(TypeError, match="place"):
        town.route("1:0:-1", goal)  # type: ignore[arg-type]


def test_paths(town: mapd.Map) -> None:
    start, goal = town.nearest_lane((50.0, -1.75)), town.nearest_lane((150.0, 101.75))
    assert start is not None and goal is not None
    route = town.route(start, goal)
    assert route is not None
    path = town.path(route)
    assert path.length == pytest.approx(route.length, abs=1.0) and path.lanes()[0] == start.lane
    along = np.linspace(0.0, path.length, 40)
    points = path.at(along)
    back = path.project(np.column_stack([points.x, points.y]))
    assert np.allclose(back.along, along, atol=1e-6) and np.allclose(back.d, 0, atol=1e-6)
    assert path.at(float(along[3])).x == points.x[3]
    assert len(path.corridor(2.0)) == len(path.corridor(2.0).left_x) > 10
    assert path.along_of(start) == pytest.approx(0.0, abs=1e-6)
    assert all(conflict.start <= conflict.end for conflict in path.conflicts())
    with pytest.raises(mapd.PathError):
        town.path([])
    with pytest.raises(mapd.PathError, match="step 1"):
        town.path([route.steps[0], route.steps[0]])


def test_all_lines_at_once(town: mapd.Map) -> None:
    for which, one in (("center", mapd.Lane.center_line), ("left", mapd.Lane.left_bound), ("right", mapd.Lane.right_bound)):
        lines = town.lines(which=which)  # type: ignore[arg-type]
        assert len(lines) == len(town.lanes())
        for k in (0, len(lines) // 2, -1):
            assert np.array_equal(lines[k], one(town.lane(int(lines.lane[k]))))
    (x, y, _), (x2, y2, _) = town.bounds
    part = town.lines((x, y, (x + x2) / 2, (y + y2) / 2), types="drivable")
    assert 0 < len(part) < len(lines)
    with pytest.raises(IndexError):
        lines[len(lines)]


def test_lines_become_a_geodataframe(town: mapd.Map) -> None:
    geopandas = pytest.importorskip("geopandas")
    lines = town.lines()
    frame = lines.to_geopandas()
    assert isinstance(frame, geopandas.GeoDataFrame) and len(frame) == len(lines)
    assert np.array_equal(np.array(frame.geometry.iloc[3].coords), lines[3]) and frame.lane[3] == lines.lane[3]


def test_signals_name_what_belongs_to_them(lights: mapd.Map) -> None:
    light, sign = lights.signals()
    (controller,) = lights.controllers()
    assert light.controllers() == [controller] and sign.controllers() == [] and light.movements() == []
    assert controller.id == "c" and controller.sequence == 2 and controller.signals == (light,)
    assert [(one.id, one.kind, one.signal, one.is_object) for one in light.dependencies()] == [("6", "with", sign, False)]
    assert [(one.id, one.kind, one.signal, one.object) for one in light.links()] == [("6", "pole", sign, None)]
    assert {(one.name, one.value, one.owner) for one in lights.annotations()} >= {("says", "this", None)}
    assert lights.quarantined() == [] and lights.left_out("road", "nowhere") is None
    with pytest.raises(ValueError, match="kind"):
        lights.left_out("nonsense", "1")


def test_steps_of_lanes_are_those_of_a_route(town: mapd.Map) -> None:
    lane = next(lane for lane in town.lanes() if lane.successors())
    after = lane.successors()[0]
    start, goal = lane.s_range[0] if lane.is_forward else lane.s_range[1], sum(after.s_range) / 2
    steps = town.steps_of_lanes([lane, after], start, goal)
    assert [step.lane for step in steps] == [lane, after] and (steps[0].s_from, steps[-1].s_to) == (start, goal)
    assert town.next_lane_change(steps, 0, (lane, start)) is None and town.signals_along(steps) == []
    assert [after, lane] in [one[:2] for one in town.lane_sequences_behind((after, goal), after.length + 1.0)]
    with pytest.raises(mapd.PathError, match="1"):
        town.steps_of_lanes([after, lane], goal, start)
    with pytest.raises(mapd.NotTrustedError):
        mapd.open(MAPS / "town.xodr", key=MAPS / "town.xodr")


def test_the_lane_graph_is_what_lanes_say(town: mapd.Map) -> None:
    graph = town.lane_graph()
    for lane in town.lanes():
        s = sum(lane.s_range) / 2
        node = lane.node_at(s)
        if node is None:
            continue
        assert graph.nodes.lane[node] == lane.id and graph.nodes.forward[node] == lane.is_forward
        on = graph.nodes.lane[graph.edges.end[graph.edges.start == node]]
        assert set(on.tolist()) <= {lane.id, *(one.id for one in lane.successors())}
        for conflict in lane.conflicts():
            assert conflict.other is not None and lane in [one.other for one in conflict.other.conflicts()]


def test_notebooks_get_pictures(town: mapd.Map, lights: mapd.Map) -> None:
    lane = next(lane for lane in town.lanes() if lane.successors())
    route = town.route((lane, lane.s_range[0]), (lane.successors()[0], 1.0))
    assert route is not None
    path = town.path(route)
    pictures: list[tuple[Any, str]] = [(town, "56 roads"), (lane, lane.key)]
    for own in (lane.road, town.junctions()[0], lights.signals()[0], path, route):
        pictures.append((own, escape(repr(own))))
    for one, says in pictures:
        html = one._repr_html_()
        assert says in html and html.count("<polyline") >= 3 and html.endswith("</svg>")


def test_raw_views_are_read_only_and_keep_the_memory(tmp_path: Path) -> None:
    compiled = mapd.compile(MAPS / "town.xodr")
    compiled.save(tmp_path / "town.mapd")
    map = mapd.open(tmp_path / "town.mapd")
    assert map.content_hash == compiled.map.content_hash
    roads, again = mapd.raw.table(map, "roads"), mapd.raw.table(map, "roads")
    assert np.shares_memory(roads, again) and not roads.flags.owndata
    assert [mapd.raw.string(map, number) for number in roads["id"]] == [road.id for road in map.roads()]
    assert np.array_equal(roads["length"], [road.length for road in map.roads()])
    for view in (roads, roads["length"], map._bytes()):
        with pytest.raises(ValueError, match="WRITEABLE|writeable"):
            view.flags.writeable = True
        with pytest.raises(ValueError, match="read-only"):
            view[0] = 0
    lengths = roads["length"]
    want = lengths.copy()
    (tmp_path / "town.mapd").unlink()
    del map, roads, again, compiled
    gc.collect()
    assert np.array_equal(lengths, want)


def test_raw_knows_every_table(town: mapd.Map) -> None:
    there = mapd.raw.tables(town)
    assert {number for number, *_ in town._tables()} == {TABLES[name][0] for name in there}
    assert set(there) <= set(mapd.raw.names())
    hits = town.nearest_lane(np.array([[50.0, -1.75]]))
    assert mapd.raw.rows(hits.lane)[0] < len(there["lanes"])


def test_findings_are_objects(tmp_path: Path) -> None:
    broken = tmp_path / "broken.xodr"
    broken.write_text((MAPS / "town.xodr").read_text().replace('length="76"', 'length="-76"', 1))
    report = mapd.check(broken)
    assert report.verdict == "quarantined" and report.quarantined[0].owner == "1"
    error = report.errors[0]
    assert error.line > 1 and error.rule in str(error) and error.rejects
    assert mapd.compile(broken).report.verdict == "quarantined"
    with pytest.raises(mapd.RejectedError) as rejected:
        mapd.compile(broken, on_error="reject")
    assert rejected.value.report.errors and str(broken) in str(rejected.value)
    # As a worker process hands it to its pool.
    again = pickle.loads(pickle.dumps(rejected.value))
    assert type(again) is mapd.RejectedError and str(again) == str(rejected.value) and again.report == rejected.value.report
    assert pickle.loads(pickle.dumps(report)) == report and report.to_dict()["verdict"] == "quarantined"


@pytest.mark.parametrize("kind", [kind for kind in vars(_errors).values() if isinstance(kind, type) and issubclass(kind, mapd.MapdError)])
def test_every_error_can_be_pickled(kind: type[mapd.MapdError]) -> None:
    report = mapd.Report("rejected", (), (0, 0, 0), (), "1.7", "1.7.0")
    error = mapd.RejectedError("why", report) if kind is mapd.RejectedError else kind("why")
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is kind and str(again) == str(error) and vars(again) == vars(error)


def test_files_that_are_none(tmp_path: Path) -> None:
    with pytest.raises(mapd.FileError) as missing:
        mapd.open(tmp_path / "no.mapd")
    assert missing.value.errno == 2 and isinstance(missing.value, OSError)
    with pytest.raises(mapd.FileError):
        mapd.compile(tmp_path / "no.xodr")
    with pytest.raises(mapd.FileError, match="folder"):
        mapd.compile(tmp_path)
    (tmp_path / "bad.mapd").write_bytes(b"nonsense" * 100)
    with pytest.raises(mapd.ArchiveError):
        mapd.open(tmp_path / "bad.mapd")
    with pytest.raises(mapd.RejectedError):
        mapd.open((tmp_path / "bad.mapd").rename(tmp_path / "bad.xodr"))
    for option in ({"profile": "no"}, {"on_error": "no"}, {"index_tolerance": -1.0}):
        with pytest.raises(ValueError):
            mapd.compile(MAPS / "town.xodr", **option)


def test_places_on_earth(town: mapd.Map) -> None:
    road = mapd.open(MAPS / "one_road.xodr")
    points = np.array([[0.0, 0.0, 5.0], [100.0, 20.0, 0.0]])
    places = road.to_geodetic(points)
    back = road.from_geodetic(np.column_stack([places.latitude, places.longitude, places.altitude]))
    assert np.allclose(np.column_stack([back.x, back.y, back.z]), points, atol=1e-6)
    assert road.to_geodetic((0.0, 0.0, 5.0)) == (places.latitude[0], places.longitude[0], places.altitude[0])
    with pytest.raises(mapd.ProjectionError):
        town.to_geodetic(points)
    north = road.north_at(points)
    assert np.all(np.abs(north - np.pi / 2) < 0.06) and road.north_at(tuple(points[1])) == north[1]
    origin = tuple(points[0])
    there = road.to_enu(points, origin)
    assert np.allclose([there.x[0], there.y[0], there.z[0]], 0.0, atol=1e-6)
    apart = np.column_stack([there.x, there.y, there.z])
    again = road.from_enu(apart, origin)
    assert np.allclose(np.column_stack([again.x, again.y, again.z]), points, atol=1e-6)
    assert road.to_enu(tuple(points[1]), origin) == tuple(apart[1])
    with pytest.raises(mapd.ProjectionError):
        road.to_enu(points, (np.nan, 0.0))
