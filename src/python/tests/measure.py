"""How long Python's nearest lanes take in batches, against Rust's: no test, for times differ from run to run.

``python tests/measure.py [ARCHIVE [COUNT]]`` in the wheel's environment; needs ``cargo build --release -p mapd-python --example batch``.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import mapd

WORKSPACE = Path(__file__).resolve().parents[3]
RUNS = 15


def main() -> None:
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20_000
    with tempfile.TemporaryDirectory() as folder:
        archive = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(folder, "town.mapd")
        if not archive.exists():
            mapd.compile(WORKSPACE / "examples" / "maps" / "town.xodr").save(archive)
        target = Path(os.environ.get("CARGO_TARGET_DIR", WORKSPACE / "target"))
        command = [str(target / "release" / "examples" / "batch"), str(archive), str(count)]
        rust = float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        map = mapd.open(archive)
        low, high = map.bounds
        shares = np.outer(np.arange(count), [0.7548776662466928, 0.5698402909980532]) % 1.0
        points = np.array(low[:2]) + (np.array(high[:2]) - np.array(low[:2])) * shares
        out = mapd.NearestLanes(count)
        best = np.inf
        for _ in range(RUNS):
            begun = time.perf_counter()
            map.nearest_lane(points, out=out)
            best = min(best, time.perf_counter() - begun)
        python = best * 1e9 / count
        print(f"{count} points: Rust {rust:.0f} ns a point, Python {python:.0f} ns: {python / rust:.2f} times")


if __name__ == "__main__":
    main()
