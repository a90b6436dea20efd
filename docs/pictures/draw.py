#!/usr/bin/env python3
"""The pictures of docs/export.md, each drawn by a program that knows nothing of mapd from a file that mapd wrote.

    pip install geopandas lanelet2==1.2.3 matplotlib mcap mcap-protobuf-support
    docs/pictures/draw.py target/debug/mapd target/foxglove/debug/mapd-foxglove

Needs GDAL's ogr2ogr, too. The page's picture is taken by `look` (docs/view.md).
"""

import pathlib
import subprocess
import sys
import tempfile

import geopandas
import lanelet2
import matplotlib.collections
import matplotlib.pyplot as plot
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

HERE = pathlib.Path(__file__).parent
MAPS = HERE.parent.parent / "examples/maps"
ORIGIN = "49.01", "8.43"


def save(figure, name):
    for axes in figure.axes:
        axes.set_aspect("equal" if name != "geojson" else 1 / 0.656)
        axes.tick_params(labelsize=6)
        axes.ticklabel_format(useOffset=False)
    figure.savefig(HERE / f"{name}.png", dpi=90, bbox_inches="tight", pil_kwargs={"optimize": True})
    plot.close(figure)


def export(mapd, source, kind, file, *more):
    subprocess.run([mapd, "export", MAPS / source, "--format", kind, "-o", file, "--quiet", *more], check=True, stderr=subprocess.DEVNULL)


def features(mapd, folder):
    """geopandas, which reads by GDAL: GeoJSON by type, a GeoPackage that ogr2ogr made of FlatGeobuf by layer."""
    figure, axes = plot.subplots(figsize=(5, 4.6))
    export(mapd, "town.xodr", "geojson", folder / "town.geojson", "--origin", ",".join(ORIGIN))
    town = geopandas.read_file(folder / "town.geojson")
    town[town.layer == "lanes"].plot(ax=axes, column="type", legend=True, cmap="tab20c", legend_kwds={"fontsize": 6})
    town[town.layer == "center_lines"].plot(ax=axes, color="white", linewidth=0.5)
    axes.set_title("town.geojson, lanes by type, in degrees: geopandas", fontsize=8)
    save(figure, "geojson")

    figure, axes = plot.subplots(figsize=(6, 2.6))
    export(mapd, "objects.xodr", "flatgeobuf", folder / "map.fgb")
    for layer, kind in {"lanes": "POLYGON", "borders": "LINESTRING", "objects": "POLYGON", "edges": "LINESTRING"}.items():
        more = ["-append"] if layer != "lanes" else []
        asked = ["-nln", layer, "-nlt", f"{kind}25D", "-where", f"layer = '{layer}'"]
        subprocess.run(["ogr2ogr", *more, folder / "map.gpkg", folder / "map.fgb", *asked], check=True, stderr=subprocess.DEVNULL)
    for layer, style in {
        "lanes": {"color": "#c9ced3"},
        "borders": {"color": "#5d6168", "linewidth": 0.6},
        "edges": {"color": "#1f77b4", "linewidth": 1},
        "objects": {"color": "#7a5cc0", "alpha": 0.6},
    }.items():
        rows = geopandas.read_file(folder / "map.gpkg", layer=layer)
        if len(rows):
            rows.plot(ax=axes, **style)
    axes.set(xlabel="x [m]", ylabel="y [m]")
    axes.set_title("objects.gpkg by ogr2ogr from objects.fgb, in metres: geopandas", fontsize=8)
    save(figure, "flatgeobuf")


def lanelets(mapd, folder):
    """Lanelet2's own library: borders of lanelets by type, directions, areas."""
    export(mapd, "town.xodr", "lanelet2", folder / "town.osm", "--origin", ",".join(ORIGIN))
    projector = lanelet2.projection.UtmProjector(lanelet2.io.Origin(*map(float, ORIGIN)))
    town = lanelet2.io.load(str(folder / "town.osm"), projector)
    figure, axes = plot.subplots(figsize=(5, 4.6))
    points = lambda line: [(point.x, point.y) for point in line]
    for one in town.laneletLayer:
        ring = points(one.leftBound) + points(one.rightBound)[::-1]
        is_turn = "turn_direction" in one.attributes and one.attributes["turn_direction"] != "straight"
        color = {"walkway": "#e3d5b8"}.get(one.attributes["subtype"], "#f0c27b" if is_turn else "#b9c4d0")
        axes.fill(*zip(*ring), color=color, linewidth=0, alpha=0.8)
        center = points(one.centerline)
        if one.attributes["subtype"] == "road" and len(center) > 1:
            (x, y), (to_x, to_y) = center[len(center) // 2 - 1], center[len(center) // 2]
            axes.annotate("", (to_x, to_y), (x, y), arrowprops={"arrowstyle": "->", "color": "#333333", "lw": 0.5})
    lines = [points(line) for one in town.laneletLayer for line in (one.leftBound, one.rightBound)]
    axes.add_collection(matplotlib.collections.LineCollection(lines, colors="#5d6168", linewidths=0.5))
    axes.set_title("town.osm, turns in orange: read by Lanelet2, drawn by matplotlib", fontsize=8)
    save(figure, "lanelet2")


def scene(foxglove, folder):
    """The reader of MCAP: the triangles, lines and boards that Foxglove gets."""
    file = folder / "marks.mcap"
    subprocess.run([foxglove, MAPS / "marks.xodr", "-o", file], check=True, stderr=subprocess.DEVNULL)
    figure, axes = plot.subplots(figsize=(6, 2.6))
    axes.set_facecolor("#15181c")
    with open(file, "rb") as stream:
        for _, channel, _, decoded in make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            for entity in getattr(decoded, "entities", []):
                for part in entity.triangles:
                    corners = [(part.points[i].x, part.points[i].y) for i in part.indices]
                    colors = [(c.r, c.g, c.b) for c in (part.colors[i] for i in part.indices[::3])]
                    pieces = [corners[i : i + 3] for i in range(0, len(corners), 3)]
                    axes.add_collection(matplotlib.collections.PolyCollection(pieces, facecolors=colors, edgecolors=colors, linewidths=0.2))
                for line in entity.lines:
                    places = [(point.x, point.y) for point in line.points]
                    color = (line.color.r, line.color.g, line.color.b)
                    pieces = list(zip(places[::2], places[1::2]))
                    axes.add_collection(matplotlib.collections.LineCollection(pieces, colors=[color], linewidths=8 * line.thickness))
    axes.autoscale()
    axes.set_title("marks.mcap, lanes and marks: read by mcap, drawn by matplotlib", fontsize=8)
    save(figure, "mcap")


def main():
    mapd, foxglove = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        features(mapd, folder)
        lanelets(mapd, folder)
        scene(foxglove, folder)


if __name__ == "__main__":
    main()
