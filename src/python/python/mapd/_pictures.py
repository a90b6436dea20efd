"""Small pictures for notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._mapd import Junction, Lane, Map, Path, Road, Signal
    from ._results import Route

_WIDTH = 480
# Lines of a picture: a notebook is no place for a whole city.
_MOST_LINES = 4000
_STYLE = {"bound": "stroke:#888", "center": "stroke:#06c", "signal": "stroke:#c00"}
# How far around a signal its picture reaches [m].
_AROUND = 30.0
# Stations of a path [m].
_STEP = 1.0


def _svg(lines: Iterable[tuple[str, NDArray[np.float64]]]) -> str:
    """Lines (M, 2 or more) [m] with the names of their styles; north is up."""
    drawn = [(style, line[:, :2]) for style, line in lines if len(line) > 1]
    if not drawn:
        return ""
    every = np.concatenate([line for _, line in drawn])
    low, high = every.min(axis=0), every.max(axis=0)
    size = np.maximum(high - low, 1e-3)
    margin = 0.02 * size.max()
    x, y = low[0] - margin, -high[1] - margin
    width, height = size + 2 * margin
    paths = (
        f'<polyline style="{_STYLE[style]}" points="{" ".join(f"{px:.2f},{-py:.2f}" for px, py in line)}"/>'
        for style, line in drawn
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" viewBox="{x:.2f} {y:.2f} {width:.2f} {height:.2f}">'
        f'<g fill="none" stroke-width="{size.max() / _WIDTH:.3f}">{"".join(paths)}</g></svg>'
    )


def map_html(map: Map) -> str:
    """What it is, with the bounds of its lanes."""
    sides = map.lines(which="left"), map.lines(which="right")
    lines = [("bound", side[k]) for side in sides for k in range(len(side))]
    more = f"<p>{_MOST_LINES} of {len(lines)} lines</p>" if len(lines) > _MOST_LINES else ""
    return f"<p>{escape(repr(map))}</p>{_svg(lines[:_MOST_LINES])}{more}"


def lane_html(lane: Lane) -> str:
    """What it is, with its bounds and its centre line."""
    lines = [("bound", lane.left_bound()), ("bound", lane.right_bound()), ("center", lane.center_line())]
    return f"<p>{escape(repr(lane))}</p>{_svg(lines)}"


def _lanes_html(what: object, lanes: Iterable[Lane], more: Iterable[tuple[str, NDArray[np.float64]]] = ()) -> str:
    """What it is, with the bounds of lanes and other lines."""
    bounds = [("bound", line) for lane in lanes for line in (lane.left_bound(), lane.right_bound())]
    return f"<p>{escape(repr(what))}</p>{_svg([*bounds[:_MOST_LINES], *more])}"


def road_html(road: Road) -> str:
    """What it is, with the bounds of its lanes."""
    return _lanes_html(road, road.lanes())


def junction_html(junction: Junction) -> str:
    """What it is, with the bounds of the lanes of its connecting roads."""
    roads = {one.connecting_road: None for one in junction.connections() if one.connecting_road is not None}
    return _lanes_html(junction, (lane for road in roads for lane in road.lanes()))


def route_html(route: Route) -> str:
    """What it is, with the bounds of its lanes and their centre lines."""
    lanes = [step.lane for step in route.steps]
    return _lanes_html(route, lanes, [("center", lane.center_line()) for lane in lanes])


def path_html(path: Path) -> str:
    """What it is, with the driven line between the edges of its lanes."""
    room = path.corridor(_STEP)
    edges = (np.column_stack([room[f"{side}_x"], room[f"{side}_y"]]) for side in ("left", "right"))
    line = path.at(room.along)
    lines = [*(("bound", edge) for edge in edges), ("center", np.column_stack([line.x, line.y]))]
    return f"<p>{escape(repr(path))}</p>{_svg(lines)}"


def signal_html(signal: Signal, map: Map) -> str:
    """What it is, with the lanes around it and the way it faces."""
    x, y, _ = signal.position
    lanes = map.lanes_in((x - _AROUND, y - _AROUND, x + _AROUND, y + _AROUND))
    ahead = 0.1 * _AROUND * np.array([np.cos(signal.facing), np.sin(signal.facing)])
    across = 0.5 * np.array([-ahead[1], ahead[0]])
    place = np.array([x, y])
    face = [("signal", np.array([place - across, place + across])), ("signal", np.array([place, place + ahead]))]
    return _lanes_html(signal, lanes, face)
