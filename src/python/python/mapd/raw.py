"""Tables of the archive as read-only structured arrays, in place.

The fields follow the archive's layout (docs/format.md), which is promised to nobody: a release may change it. A view keeps the map's
memory alive, whatever becomes of the map, the client and the daemon. Rows of ``lanes``, ``roads`` and so on are the low 32 bits of
ids: see :func:`rows`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import ArchiveError
from ._layout import TABLES
from ._mapd import Map


def names() -> tuple[str, ...]:
    """Names of all tables that this release knows."""
    return tuple(TABLES)


def dtype(name: str) -> np.dtype[Any]:
    """What a row of a table is.

    Raises:
        KeyError: no such table.
    """
    kind: np.dtype[Any] = np.dtype(TABLES[name][2])
    return kind


def table(map: Map, name: str) -> NDArray[Any]:
    """A table, in place and read-only; empty where the map has none.

    Raises:
        KeyError: no such table.
        ArchiveError: the map's rows are those of another release.
    """
    number, row_id, _ = TABLES[name]
    kind = dtype(name)
    for entry_number, row_bytes, entry_id, offset, count in map._tables():
        if entry_number == number:
            if entry_id != row_id or row_bytes != kind.itemsize:
                raise ArchiveError(f"table {name} of this map has rows of another release")
            return map._bytes()[offset : offset + count * row_bytes].view(kind)
    return np.empty(0, kind)


def tables(map: Map) -> dict[str, NDArray[Any]]:
    """All tables that the map has, by name."""
    there = {entry[0] for entry in map._tables()}
    return {name: table(map, name) for name, (number, _, _) in TABLES.items() if number in there}


def rows(ids: NDArray[np.uint64]) -> NDArray[np.uint32]:
    """Rows of ids, such as those of a column ``lane``."""
    return (ids & np.uint64(0xFFFF_FFFF)).astype(np.uint32)


def string(map: Map, number: int) -> str:
    """The string of a number, as fields like ``id`` of ``roads`` hold it."""
    offsets = table(map, "string_offsets")
    return bytes(table(map, "string_bytes")[offsets[number] : offsets[number + 1]]).decode()
