"""Small pictures for notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._mapd import Lane, Map

_WIDTH = 480
# Lines of a picture: a notebook is no place for a whole city.
_MOST_LINES = 4000
_STYLE = {"bound": "stroke:#888", "center": "stroke:#06c"}


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
