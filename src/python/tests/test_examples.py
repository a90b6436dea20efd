"""The examples run, and the types are complete."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from conftest import WORKSPACE, Daemon

EXAMPLES = sorted((WORKSPACE / "examples" / "python").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_example(example: object, daemon: Daemon) -> None:
    daemon.client().close()
    ran = subprocess.run(
        [sys.executable, "-W", "error", str(example)], env=daemon.environment, capture_output=True, text=True, timeout=120, cwd=WORKSPACE
    )
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.strip()


def test_the_trajectory_is_plotted(tmp_path: Path) -> None:
    picture = tmp_path / "trajectory.png"
    command = [sys.executable, "-W", "error", str(WORKSPACE / "examples" / "python" / "trajectory.py"), str(picture)]
    ran = subprocess.run(command, env=dict(os.environ, MPLBACKEND="agg"), capture_output=True, text=True, timeout=120, cwd=WORKSPACE)
    assert ran.returncode == 0, ran.stderr
    pixels = matplotlib.image.imread(picture)
    # Lanes and points are drawn: it is not all one colour.
    assert pixels.shape[0] > 100 and pixels.shape[1] > 100 and len(np.unique(pixels[..., 0])) > 10


def test_the_page_begins_with_a_program_that_runs() -> None:
    page = (WORKSPACE / "docs" / "python.md").read_text()
    program = page.split("```python\n")[1].split("```")[0]
    ran = subprocess.run([sys.executable, "-W", "error", "-c", program], capture_output=True, text=True, timeout=120, cwd=WORKSPACE)
    assert ran.returncode == 0, ran.stderr


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 3
