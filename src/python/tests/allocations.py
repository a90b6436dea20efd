"""What calls with ``out=`` allocate: no test, but the program of one (`test_allocations.py`), under `allocations.c`.

Prints for each call its name, and how many allocations of a column's size it made without ``out``, and with ``out`` from the second time on.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from conftest import MAPS

import mapd

ROWS = 5_000
# The smallest column has a byte for each row.
LEAST = ROWS
AGAIN = 3

counter = ctypes.CDLL(None)
counter.counted.restype = ctypes.c_size_t
counter.count_from.argtypes = [ctypes.c_size_t]


def calls() -> dict[str, tuple[Callable[..., Any], mapd.Columns]]:
    """Every call that takes ``out``, and something for it to fill."""
    map = mapd.open(MAPS / "town.xodr")
    share = np.linspace(0.0, 1.0, ROWS)
    points = np.column_stack([50.0 + 20.0 * share, -1.75 + 0.1 * share, np.zeros(ROWS)])
    heading = np.zeros(ROWS)
    covariance = np.diag([0.25, 0.25, 0.01])
    found = map.nearest_lane(points)
    lanes, s = found.lane, found.s
    road = map.road("1")
    route = map.route(("1:0:-1", 1.0), ("12:0:-1", 20.0))
    assert route is not None
    path = map.path(route)
    along = path.length * share
    step = path.length / (ROWS - 1)
    stations = len(path.corridor(step))
    view = map.view()
    tracks = np.column_stack([100.0 * share, share])
    wheels = np.array([[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]])
    tracker = mapd.Tracker()
    many = np.tile(covariance, (ROWS, 1, 1))
    hours, time, way = iter(range(1_000_000)), share.copy(), 20.0 * share

    def track(**out: Any) -> object:
        # Each trace hours after the one before, in memory that is there.
        np.add(share, 3600.0 * next(hours), out=time)
        return tracker.update(map, time, points, heading, many, odometer=way, **out)

    return {
        "Map.nearest_lane": (lambda **out: map.nearest_lane(points, heading=heading, **out), mapd.NearestLanes(ROWS)),
        "Map.position_of": (lambda **out: map.position_of(lanes, points, **out), mapd.NearestLanes(ROWS)),
        "Map.pose_at": (lambda **out: map.pose_at(lanes, s, 0.5, **out), mapd.Poses(ROWS)),
        "Map.speed_rule_at": (lambda **out: map.speed_rule_at(lanes, s, **out), mapd.SpeedRules(ROWS)),
        "Map.ground_at": (lambda **out: map.ground_at(points, **out), mapd.Grounds(ROWS)),
        "Map.nearest_mark": (lambda **out: map.nearest_mark(points, **out), mapd.NearMarks(ROWS)),
        "Map.match_trace": (lambda **out: map.match_trace(share, points, heading=heading, **out), mapd.TraceMatches(ROWS)),
        "Map.stance": (lambda **out: map.stance(points, heading, wheels, **out), mapd.Stances(ROWS)),
        "Road.to_inertial": (lambda **out: road.to_inertial(tracks, **out), mapd.Poses(ROWS)),
        "Road.to_track": (lambda **out: road.to_track(points, **out), mapd.Tracks(ROWS)),
        "Path.at": (lambda **out: path.at(along, **out), mapd.PathPoints(ROWS)),
        "Path.project": (lambda **out: path.project(points, **out), mapd.PathPositions(ROWS)),
        "Path.speed_at": (lambda **out: path.speed_at(along, **out), mapd.SpeedRules(ROWS)),
        "Path.corridor": (lambda **out: path.corridor(step, **out), mapd.Corridor(stations)),
        "Path.corridor_surface": (lambda **out: path.corridor_surface(step, **out), mapd.CorridorSurface(stations)),
        "View.allows": (lambda **out: view.allows(lanes, s, **out), mapd.Permissions(ROWS)),
        "View.speed_rule_at": (lambda **out: view.speed_rule_at(lanes, s, **out), mapd.SpeedsToday(ROWS)),
        "View.speed_on_path": (lambda **out: view.speed_on_path(path, along, **out), mapd.SpeedsToday(ROWS)),
        "View.corridor": (lambda **out: view.corridor(path, step, **out), mapd.Corridor(stations)),
        "Tracker.update": (track, mapd.TrackedFixes(ROWS)),
    }


def allocations(call: Callable[..., Any], **out: Any) -> int:
    counter.count_from(LEAST)
    call(**out)
    count: int = counter.counted()
    counter.count_from(sys.maxsize)
    return count


def main() -> None:
    for name, (call, out) in calls().items():
        without = allocations(call)
        call(out=out)
        print(name, without, max(allocations(call, out=out) for _ in range(AGAIN)))


if __name__ == "__main__":
    main()
