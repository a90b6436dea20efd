"""What `help` shows of the compiled part is what its stub says."""

from __future__ import annotations

import ast
import inspect
import types
from pathlib import Path

import mapd
from mapd import _mapd


def stub() -> dict[str, str]:
    """Docstrings of the stub by qualified name; of an overloaded function the one that has a text."""
    found: dict[str, str] = {}

    def walk(body: list[ast.stmt], prefix: str) -> None:
        for node in body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                text = ast.get_docstring(node)
                if text is not None:
                    found[prefix + node.name] = text
            if isinstance(node, ast.ClassDef):
                walk(node.body, f"{node.name}.")

    walk(ast.parse(Path(mapd.__file__).with_name("_mapd.pyi").read_text()).body, "")
    return found


def compiled() -> dict[str, str]:
    """Docstrings of the extension's public classes, functions, methods and properties; empty where there is none."""
    parts = {name: part for name, part in vars(_mapd).items() if callable(part)}
    for name, owner in list(parts.items()):
        if isinstance(owner, type):
            members = vars(owner).items()
            parts |= {f"{name}.{member}": part for member, part in members if callable(part) or isinstance(part, types.GetSetDescriptorType)}
    public = {name: part for name, part in parts.items() if not name.rpartition(".")[2].startswith("_")}
    return {name: inspect.cleandoc(part.__doc__ or "") for name, part in public.items()}


def test_help_says_what_the_stub_says() -> None:
    assert compiled() == stub()
    assert "nearest" in compiled()["Map.nearest_lane"]
