#!/usr/bin/env python3
"""The picture of docs/export.md that QGIS draws, from layers that mapd wrote.

    apt-get install python3-qgis
    QT_QPA_PLATFORM=offscreen docs/pictures/draw_in_qgis.py target/debug/mapd
"""

import pathlib
import subprocess
import sys
import tempfile

from qgis.core import (
    QgsApplication,
    QgsCategorizedSymbolRenderer,
    QgsFillSymbol,
    QgsLineSymbol,
    QgsMapRendererParallelJob,
    QgsMapSettings,
    QgsMarkerSymbol,
    QgsRendererCategory,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QSize

HERE = pathlib.Path(__file__).parent
TOWN = HERE.parent.parent / "examples/maps/town.xodr"
COLORS = {"driving": "#c9ced3", "sidewalk": "#e3d5b8", "shoulder": "#dfe3e6", "": "#d9ead3"}


def by_type():
    def category(kind, color):
        return QgsRendererCategory(kind, QgsFillSymbol.createSimple({"color": color, "outline_style": "no"}), kind)

    return QgsCategorizedSymbolRenderer("type", [category(kind, color) for kind, color in COLORS.items()])


def simple(symbol, **properties):
    return lambda: QgsSingleSymbolRenderer(symbol.createSimple(properties))


# From the lowest to the highest.
STYLES = {
    "lanes": by_type,
    "borders": simple(QgsLineSymbol, color="#5d6168", width="0.2"),
    "edges": simple(QgsLineSymbol, color="#1f77b4", width="0.3"),
    "crosswalks": simple(QgsFillSymbol, color="#ffffff", outline_color="#5d6168"),
    "stop_lines": simple(QgsLineSymbol, color="#b22222", width="0.6"),
    "signals": simple(QgsMarkerSymbol, color="#7a5cc0", size="2"),
}


def layer(mapd, folder, name):
    file = folder / f"{name}.fgb"
    command = [mapd, "export", TOWN, "--format", "flatgeobuf", "--layers", name, "-o", file, "--quiet"]
    subprocess.run(command, check=True)
    drawn = QgsVectorLayer(str(file), name, "ogr")
    if not drawn.isValid():
        sys.exit(f"QGIS refuses {file}")
    drawn.setRenderer(STYLES[name]())
    print(name, drawn.featureCount(), drawn.crs().description() or "no coordinate system")
    return drawn


def main():
    application = QgsApplication([], False)
    application.initQgis()
    with tempfile.TemporaryDirectory() as folder:
        layers = [layer(sys.argv[1], pathlib.Path(folder), name) for name in STYLES]
        settings = QgsMapSettings()
        settings.setLayers(layers[::-1])
        extent = layers[0].extent()
        extent.scale(1.05)
        settings.setExtent(extent)
        settings.setOutputSize(QSize(560, 480))
        job = QgsMapRendererParallelJob(settings)
        job.start()
        job.waitForFinished()
        job.renderedImage().save(str(HERE / "qgis.png"))
        del layers, settings, job
    application.exitQgis()


if __name__ == "__main__":
    main()
