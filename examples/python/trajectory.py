"""Matches a trajectory in one call, routes between its ends, and follows the route as one line; plots where matplotlib is installed."""

import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import mapd

TOWN = Path(__file__).resolve().parents[1] / "maps" / "town.xodr"


def main(picture: str | None) -> None:
    map = mapd.compile(TOWN).map
    start, goal = map.nearest_lane((50.0, -1.75)), map.nearest_lane((150.0, 101.75))
    assert start is not None and goal is not None
    route = map.route(start, goal)
    assert route is not None
    path = map.path(route)
    print(route, path)

    # A drive along the route, half a metre to the left of the middle, with some noise.
    noise = np.random.default_rng(1)
    driven = path.at(np.arange(0.0, path.length, 1.0))
    left = np.column_stack([-np.sin(driven.heading), np.cos(driven.heading)])
    points = np.column_stack([driven.x, driven.y]) + 0.5 * left + noise.normal(0.0, 0.1, (len(driven), 2))

    hits = map.nearest_lane(points, heading=driven.heading, heading_tolerance=1.0)
    print(hits)
    print(f"{np.mean(hits.lane == driven.lane):.0%} of the points are matched to the lane that was driven")
    placed = path.project(points)
    print(f"beside the path: {placed.d.mean():+.2f} m on average")

    if picture and find_spec("matplotlib"):
        from matplotlib import pyplot
        from matplotlib.collections import LineCollection

        figure, axes = pyplot.subplots()
        for which, colour in (("left", "0.6"), ("right", "0.6"), ("center", "0.85")):
            lines = map.lines(which=which)  # type: ignore[arg-type]
            axes.add_collection(LineCollection([lines[k][:, :2] for k in range(len(lines))], colors=colour))
        axes.plot(points[:, 0], points[:, 1], ".", markersize=2)
        axes.set_aspect("equal")
        figure.savefig(picture)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
