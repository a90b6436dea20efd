#!/usr/bin/env python3
"""The pictures of docs/localisation.md: a piece of what `mapd export --format svg` draws, with what `mapd query` and `mapd match` answer drawn over it.

docs/pictures/where_am_i.py target/debug/mapd [FOLDER]

They are written beside this file, or into FOLDER. Needs nothing but Python. The same program writes the same files.
"""

import csv
import io
import math
import pathlib
import random
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
MAPS = HERE.parent.parent / "examples/maps"
NUMBERS = re.compile(r"-?\d+\.?\d*")
# Lanes that the answers name.
COLOURS = ["#e8833a", "#3f8fd2", "#55a868", "#c44e52", "#8172b3", "#ccb974"]


def mapd(*words, text=None):
    return subprocess.run([PROGRAM, *words], input=text, check=True, capture_output=True, text=True).stdout


def table(*words, rows):
    """Rows of answers, each by the names of its columns."""
    head, *body = rows
    text = "\n".join(",".join(str(value) for value in row) for row in [head, *body]) + "\n"
    return list(csv.DictReader(io.StringIO(mapd(*words, text=text))))


class Drawing:
    """An exported map, cut to a rectangle, in metres with y upwards."""

    def __init__(self, source, corners, *options):
        svg = mapd("export", str(MAPS / source), "--format", "svg", "--quiet", *options)
        self.lines = svg.splitlines()
        # The first line that is drawn begins where the first road does.
        line = next(line for line in self.lines if 'class="reference"' in line)
        (x, y), *_ = self.numbers(line)
        self.left, self.top = START[source][0] - x, START[source][1] + y
        self.low, self.high = corners
        self.over = []

    def at(self, x, y):
        return x - self.left, self.top - y

    def numbers(self, line):
        path = re.search(r' d="([^"]*)"', line)
        values = [float(one) for one in NUMBERS.findall(path.group(1))] if path else []
        return list(zip(values[::2], values[1::2]))

    def keeps(self, line):
        if not line.startswith("<path"):
            return line.startswith(("<?xml", "<style", "</svg"))
        corners = self.numbers(line)
        (x0, y1), (x1, y0) = self.at(*self.low), self.at(*self.high)
        xs, ys = [x for x, _ in corners], [y for _, y in corners]
        return bool(xs) and min(xs) <= x1 and max(xs) >= x0 and min(ys) <= y1 and max(ys) >= y0

    def colour(self, key, colour, opacity):
        """Paints a lane over all others."""
        line = next(line for line in self.lines if f"<title>{key} " in line)
        path = re.search(r' d="[^"]*"', line).group(0)
        self.over.append(f'<path{path} fill="{colour}" fill-opacity="{opacity:.2f}" stroke="{colour}" stroke-width="0.15"/>')

    def dot(self, x, y, radius, colour):
        x, y = self.at(x, y)
        self.over.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}" fill="{colour}"/>')

    def circle(self, x, y, radius, colour):
        x, y = self.at(x, y)
        self.over.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:.3f}" fill="none" stroke="{colour}" stroke-width="0.06"/>')

    def arrow(self, x, y, heading, length, colour):
        (x0, y0), (x1, y1) = self.at(x, y), self.at(x + length * math.cos(heading), y + length * math.sin(heading))
        self.over.append(f'<path d="M{x0:.2f},{y0:.2f} {x1:.2f},{y1:.2f}" stroke="{colour}" stroke-width="0.3"/>')

    def label(self, x, y, text, colour="#111", size=1.6):
        x, y = self.at(x, y)
        self.over.append(
            f'<text x="{x:.2f}" y="{y:.2f}" font-size="{size}" font-family="sans-serif" fill="{colour}" stroke="#fff" stroke-width="0.25" paint-order="stroke">{text}</text>'
        )

    def save(self, name):
        (x0, y1), (x1, y0) = self.at(*self.low), self.at(*self.high)
        kept = [line for line in self.lines if self.keeps(line)]
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x0:.2f} {y0:.2f} {x1 - x0:.2f} {y1 - y0:.2f}">'
        ground = f'<rect class="ground" x="{x0:.2f}" y="{y0:.2f}" width="{x1 - x0:.2f}" height="{y1 - y0:.2f}"/>'
        (FOLDER / f"{name}.svg").write_text("\n".join([kept[0], head, kept[1], ground, *kept[2:-1], *self.over, kept[-1]]) + "\n")


# Where the first road of a map begins.
START = {"town.xodr": (12.0, 0.0), "marks.xodr": (0.0, 0.0)}


def candidates():
    """The lanes that a pose in a junction may be in, by their probability."""
    drawing = Drawing("town.xodr", ((82, -12), (112, 12)))
    x, y, heading, deviations = 91.0, -1.2, 0.05, (1.0, 1.0, 0.3)
    rows = [("x", "y", "hdg", "sx", "sy", "shdg"), (x, y, heading, *deviations)]
    found = [row for row in table("query", str(MAPS / "town.xodr"), "match", rows=rows) if float(row["probability"]) > 0.01]
    for i, row in enumerate(found):
        name, share = row["lane"] or "none", float(row["probability"])
        if row["lane"]:
            drawing.colour(row["lane"], COLOURS[i % len(COLOURS)], 0.3 + 0.4 * share)
        drawing.label(82.6, 10.4 - 1.7 * i, f"{name}: {100 * share:.0f} %", COLOURS[i % len(COLOURS)] if row["lane"] else "#111", 1.4)
    for number in (1, 2):
        drawing.circle(x, y, number * deviations[0], "#c0272d")
    drawing.arrow(x, y, heading, 3.0, "#c0272d")
    drawing.dot(x, y, 0.3, "#c0272d")
    drawing.save("candidates")


def trace():
    """Fixes along a route, three metres off, and the lanes that they are matched to."""
    drawing = Drawing("town.xodr", ((30, -12), (112, 62)), "--route", ROUTE)
    line = next(line for line in drawing.lines if 'class="route"' in line)
    course = [(drawing.left + px, drawing.top - py) for px, py in drawing.numbers(line)]
    chance, fixes, gone = random.Random(7), [], 0.0
    for (x0, y0), (x1, y1) in zip(course, course[1:]):
        way = math.hypot(x1 - x0, y1 - y0)
        while gone < way:
            share = gone / way
            fixes.append((x0 + share * (x1 - x0) + chance.gauss(0, 3), y0 + share * (y1 - y0) + chance.gauss(0, 3)))
            gone += 6.0
        gone -= way
    rows = [("time", "x", "y"), *((i * 0.6, f"{x:.2f}", f"{y:.2f}") for i, (x, y) in enumerate(fixes))]
    found = table("match", str(MAPS / "town.xodr"), "--deviation", "3", rows=rows)
    lanes = list(dict.fromkeys(row["lane"] for row in found if row["lane"]))
    for i, lane in enumerate(lanes):
        drawing.colour(lane, COLOURS[i % len(COLOURS)], 0.6)
    drawing.lines.remove(line)
    for (x, y), row in zip(fixes, found):
        drawing.dot(x, y, 0.55, COLOURS[lanes.index(row["lane"]) % len(COLOURS)] if row["lane"] else "#111")
        drawing.circle(x, y, 0.6, "#111")
    drawing.save("trace")


def marks():
    """Circles around places that end at the nearest road mark."""
    drawing = Drawing("marks.xodr", ((48, -6.5), (96, 7)))
    places = [(50 + 4.7 * i, y) for i in range(10) for y in (-2.2, 2.1)]
    rows = [("x", "y"), *places]
    for (x, y), row in zip(places, table("query", str(MAPS / "marks.xodr"), "nearest-marks", rows=rows)):
        if row["distance"]:
            gap = row["painted"] == "0"
            drawing.circle(x, y, float(row["distance"]), "#8a4fc0" if gap else "#c0272d")
        drawing.dot(x, y, 0.12, "#c0272d")
    drawing.save("nearest_marks")


if __name__ == "__main__":
    PROGRAM, ROUTE = sys.argv[1], "1,20,-1:4,50,-1"
    FOLDER = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else HERE
    candidates()
    trace()
    marks()
