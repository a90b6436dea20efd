"""Views, trackers and sensors: what they take, what they refuse, and who may share them."""

from __future__ import annotations

import json
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import MAPS, PATIENCE, Daemon, program

import mapd

COVARIANCE = np.diag([0.3, 0.3, 0.02])
WHEELS = np.array([[2.0, 0.8], [2.0, -0.8], [-1.0, 0.8], [-1.0, -0.8]])


def test_a_view_without_an_overlay_is_the_map(town: mapd.Map) -> None:
    lanes = np.array([lane.id for lane in town.lanes()], np.uint64)
    s = np.array([lane.s_range[0] for lane in town.lanes()])
    view = town.view()
    assert view.entries() == [] and len(view.restrictions()) == 0 and town.overlay_revision == 0
    assert view.map.content_hash == town.content_hash
    allowed = view.allows(lanes, s)
    assert allowed.is_allowed.tolist() == [lane.allows_at(lane.s_range[0]) for lane in town.lanes()]
    assert (allowed.entry == -1).all()
    out = mapd.SpeedsToday(len(lanes))
    assert view.speed_rule_at(lanes, s, out=out) is out
    assert np.array_equal(out.max, town.speed_rule_at(lanes, s).max, equal_nan=True)
    start, goal = (town.lanes()[0], 5.0), ("12:0:-1", 20.0)
    assert repr(view.route(start, goal)) == repr(town.route(start, goal))


def test_signs_forbid_overtaking(tmp_path: Path) -> None:
    text = (MAPS / "town.xodr").read_text()
    signs = (
        f'<signal s="{s}" t="-5" id="{name}" name="" dynamic="no" orientation="+" zOffset="2" country="DE" type="{kind}" subtype="-1"/>'
        for name, s, kind in (("cars", 20, "276"), ("trucks", 40, "277"))
    )
    end = text.index("</road>")
    file = tmp_path / "signs.xodr"
    file.write_text(f"{text[:end]}<signals>{''.join(signs)}</signals>{text[end:]}")
    map = mapd.compile(file).map
    assert map is not None
    lane, view = map.lane("1:0:-1"), map.view()
    for s, vehicle, forbidden, by in (
        (10.0, "passengerCar", False, (None, None)),
        (30.0, "passengerCar", True, ("cars", None)),
        (30.0, "bicycle", False, ("cars", None)),
        (50.0, "truck", True, ("cars", "trucks")),
    ):
        today = view.overtaking_rule_at((lane, s), vehicle=vehicle)
        rule = lane.overtaking_rule_at(s)
        for own in (today.map, rule):
            assert tuple(sign and sign.id for sign in own) == by
        assert (today.is_forbidden, today.restriction) == (forbidden, None)
    with pytest.raises(mapd.NotFiniteError):
        lane.overtaking_rule_at(float("nan"))
    with pytest.raises(mapd.NotFiniteError):
        view.overtaking_rule_at((lane, float("inf")))
    with pytest.raises(ValueError, match="passengerCar"):
        view.overtaking_rule_at((lane, 0.0), vehicle="nonsense")


def test_moments(town: mapd.Map) -> None:
    at = datetime(2026, 5, 4, 7, tzinfo=timezone.utc)
    assert town.view(at).at == at.timestamp() and town.view(-1.5).at == -1.5
    for moment in (float("nan"), float("inf"), 1e300):
        with pytest.raises(ValueError, match="no moment"):
            town.view(moment)
    with pytest.raises(AttributeError):
        town.view("today")  # type: ignore[arg-type]


def test_overlays_that_are_none(town: mapd.Map, other: mapd.Map) -> None:
    for overlay in (b"", b"no overlay", bytes(4096)):
        with pytest.raises(mapd.ArchiveError):
            town.with_overlay(overlay)
    view, ids = town.view(), np.array([lane.id for lane in other.lanes()], np.uint64)
    with pytest.raises(mapd.ForeignIdError, match="row 0"):
        view.allows(ids, 0.0)
    with pytest.raises(mapd.ForeignIdError):
        view.allows((other.lanes()[0], 0.0))
    with pytest.raises(mapd.NotFiniteError, match="row 0"):
        view.allows(np.array([town.lanes()[0].id], np.uint64), np.nan)
    with pytest.raises(TypeError, match="uint64"):
        view.allows(np.zeros(2), 0.0)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="shape"):
        view.speed_rule_at(np.zeros(2, np.uint64), np.zeros(3))
    with pytest.raises(ValueError, match="passengerCar"):
        view.allows((town.lanes()[0], 0.0), vehicle="nonsense")


def test_the_daemons_overlay_is_seen(daemon: Daemon, tmp_path: Path) -> None:
    client = daemon.client()
    map = client.map()
    assert not client.wait_change(0.0)
    entries = [
        {"id": "works", "kind": "closed", "lanes": [{"road": "1", "lane": -1, "s": [10, 30]}]},
        {"id": "narrow", "kind": "no-overtaking", "vehicles": ["truck"], "lanes": [{"road": "1", "lane": 1}]},
    ]
    file = tmp_path / "works.json"
    file.write_text(json.dumps({"entries": entries}))
    command = [str(program()), "overlay", "town", "apply", str(file)]
    subprocess.run(command, env=daemon.environment, check=True, capture_output=True, timeout=PATIENCE)
    assert client.wait_change(PATIENCE)
    under = client.map()
    assert under.overlay_revision > map.overlay_revision == 0
    permission = under.view().allows(("1:0:-1", 20.0))
    assert not permission.is_allowed and permission.restriction is not None
    assert (permission.restriction.entry.id, permission.restriction.s_from, permission.restriction.s_to) == ("works", 10.0, 30.0)
    assert under.view().allows(("1:0:-1", 40.0)).is_allowed and map.view().allows(("1:0:-1", 20.0)).is_allowed
    view = under.view()
    today = view.overtaking_rule_at(("1:0:1", 20.0), vehicle="truck")
    assert today.is_forbidden and today.map == (None, None) and today.restriction is not None
    assert today.restriction.entry.id == "narrow" and not view.overtaking_rule_at(("1:0:1", 20.0)).is_forbidden
    daemon.kill()
    del client, under, map
    assert [entry.id for entry in view.entries()] == ["works", "narrow"] and "2 of 2" in repr(view)


def test_what_is_proposed_is_decided(daemon: Daemon) -> None:
    client = daemon.client()
    client.map()
    cones = {"id": "cones", "kind": "closed", "lanes": [{"road": "1", "lane": -1, "s": [10, 30]}]}
    options: dict[str, Any] = {"timeout": PATIENCE, "prefix": daemon.prefix}
    deadline = time.monotonic() + PATIENCE
    while True:
        try:
            decision = mapd.propose("town", "camera", cones, **options)
            break
        except mapd.NoDaemonError:  # A map is served a moment before its daemon listens.
            assert time.monotonic() < deadline
            time.sleep(0.01)
    assert decision == mapd.Decision(True, 0, 0)
    assert client.wait_change(PATIENCE)
    assert not client.map().view().allows(("1:0:-1", 20.0)).is_allowed
    wet = json.dumps({**cones, "id": "rain", "kind": "wet"})
    assert mapd.propose("town", "rain sensor", wet, **options) == mapd.Decision(False, 1, 2)
    with pytest.raises(mapd.ProposalRefusedError, match="wet"):
        mapd.propose("town", "camera", wet, **options)
    with pytest.raises(mapd.NoDaemonError, match="overlay-from"):
        mapd.propose("elsewhere", "camera", cones, **options)
    with pytest.raises(ValueError, match="one line"):
        mapd.propose("town", "two\nlines", cones, **options)
    with pytest.raises(TypeError):
        mapd.propose("town", "camera", {"id": object()}, **options)


def drive(town: mapd.Map, rows: int = 20) -> tuple[Any, ...]:
    lane = town.lane("1:0:-1")
    s = np.linspace(5.0, 60.0, rows)
    poses = town.pose_at(np.full(rows, lane.id, np.uint64), s)
    return np.arange(rows, dtype=float), np.column_stack([poses.x, poses.y]), poses.heading, s


def test_trackers_stay_in_the_lane(town: mapd.Map) -> None:
    time, points, heading, odometer = drive(town)
    tracker = mapd.Tracker(vehicle="passengerCar")
    found = tracker.update(town, time, points, heading, COVARIANCE, odometer=odometer)
    assert (found.lane == town.lane("1:0:-1").id).all() and {mapd.TRACKED[code] for code in found.state} == {"lane"}
    assert np.allclose(found.s, odometer, atol=0.5) and tracker.probability_in(["1:0:-1"]) > 0.9
    known = tracker.hypotheses()
    assert abs(sum(one.probability for one in known.lanes) + known.none - 1.0) < 1e-9
    assert "lanes" in repr(tracker)
    tracker.reset()
    assert tracker.hypotheses() == mapd.PoseMatch(1.0, ()) and tracker.probability_in(["1:0:-1"]) == 0.0
    out = mapd.TrackedFixes(len(time))
    assert tracker.update(town, time, points[::1], heading, COVARIANCE, odometer=odometer, out=out) is out
    assert np.array_equal(out.probability, found.probability)


def test_trackers_refuse(town: mapd.Map) -> None:
    time, points, heading, _ = drive(town)
    tracker = mapd.Tracker()
    with pytest.raises(ValueError, match="row 1.*earlier"):
        tracker.update(town, time[::-1], points, heading, COVARIANCE)
    with pytest.raises(mapd.NotFiniteError, match="row 0"):
        mapd.Tracker().update(town, time + np.nan, points, heading, COVARIANCE)
    with pytest.raises(ValueError, match="shape"):
        tracker.update(town, time[:3], points, heading, COVARIANCE)
    with pytest.raises(TypeError, match="float32"):
        tracker.update(town, time, points.astype(np.float32), heading, COVARIANCE)
    with pytest.raises(ValueError, match="covariance"):
        tracker.update(town, time, points, heading, np.eye(2))
    with pytest.raises(ValueError, match="enough"):
        mapd.Tracker(enough=2.0).update(town, time, points, heading, COVARIANCE)


def test_threads_share_a_tracker_and_a_view(town: mapd.Map) -> None:
    time, points, heading, _ = drive(town)
    tracker, view = mapd.Tracker(), town.view()
    ids = np.array([lane.id for lane in town.lanes()], np.uint64)
    want = view.allows(ids, 1.0).is_allowed

    def ask(_: int) -> bool:
        tracker.reset()
        tracker.hypotheses()
        try:
            tracker.update(town, time, points, heading, COVARIANCE)
        except ValueError:
            pass  # another thread's fixes were later
        return np.array_equal(view.allows(ids, 1.0).is_allowed, want)

    with ThreadPoolExecutor(8) as threads:
        assert all(threads.map(ask, range(64)))


def test_what_sensors_and_wheels_refuse(town: mapd.Map) -> None:
    with pytest.raises(mapd.NotFiniteError):
        town.landmarks_in_view((0.0, 0.0), np.nan, 10.0, 1.0)
    with pytest.raises(mapd.NotFiniteError):
        town.mark_points((0.0, 0.0, np.inf, 1.0), 1.0)
    with pytest.raises(ValueError, match=r"\(4, 2\)"):
        town.stance((50.0, -1.75), 0.0, WHEELS[:3])
    with pytest.raises(mapd.NotFiniteError):
        town.stance(np.array([[0.0, 0.0]]), 0.0, WHEELS * np.nan)
    out = mapd.Stances(2)
    points = np.array([[50.0, -1.75], [1e4, 1e4]])
    assert town.stance(np.asfortranarray(points), np.zeros(2), WHEELS, out=out) is out
    assert np.isfinite(out.z[0]) and np.isnan(out.z[1])


def test_factors_close_lanes(town: mapd.Map) -> None:
    start, goal = ("1:0:-1", 38.0), ("12:0:-1", 20.0)
    route = town.route(start, goal)
    assert route is not None
    rows = mapd.raw.rows(np.array([lane.id for lane in town.lanes()], np.uint64))
    factors = np.ones(int(rows.max()) + 1)
    assert town.route(start, goal, factors=factors) == route
    between = mapd.raw.rows(np.array([step.lane.id for step in route.steps[1:-1]], np.uint64))
    factors[between] = np.inf
    around = town.route(start, goal, factors=factors)
    assert around is None or {step.lane for step in around.steps}.isdisjoint(step.lane for step in route.steps[1:-1])
    with pytest.raises(TypeError, match="factors"):
        town.route(start, goal, factors=[1.0])  # type: ignore[arg-type]
