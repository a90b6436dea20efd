"""Calls with ``out=`` allocate nothing that grows with the number of rows, from the second time on."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import mapd

HERE = Path(__file__).parent


def with_out() -> set[str]:
    """Methods of the compiled part that take ``out``, as its stub says."""
    stub = ast.parse(Path(mapd.__file__).with_name("_mapd.pyi").read_text())
    found = set()
    for owner in (node for node in stub.body if isinstance(node, ast.ClassDef)):
        for node in (node for node in owner.body if isinstance(node, ast.FunctionDef)):
            if any(argument.arg == "out" for argument in node.args.kwonlyargs):
                found.add(f"{owner.name}.{node.name}")
    return found


def test_out_is_filled_without_allocating(tmp_path: Path) -> None:
    library = tmp_path / "allocations.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, HERE / "allocations.c"], check=True)
    environment = dict(os.environ, LD_PRELOAD=str(library))
    ran = subprocess.run([sys.executable, HERE / "allocations.py"], env=environment, capture_output=True, text=True, timeout=300)
    assert ran.returncode == 0, ran.stderr
    counts = {name: (int(without), int(again)) for name, without, again in (line.split() for line in ran.stdout.splitlines())}
    assert set(counts) == with_out()
    assert all(without > 0 for without, _ in counts.values()), f"nothing is counted: {counts}"
    assert {name: again for name, (_, again) in counts.items() if again} == {}
