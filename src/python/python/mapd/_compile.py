"""Compiling and checking OpenDRIVE files, and opening either kind of file."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from . import _mapd
from ._errors import RejectedError
from ._mapd import Map
from ._results import Finding, Report

Profile = Literal["default", "strict", "asam"]
OnError = Literal["quarantine", "reject", "reference-line"]


@dataclass(frozen=True)
class Compilation:
    """A map that was compiled in this process, with the findings about its file."""

    map: Map
    report: Report

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings, in the order of the file."""
        return self.report.findings

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the archive. A file of that name is replaced as a whole: programs that have it open keep the old one.

        Raises:
            OSError: the file cannot be written.
        """
        place = Path(path)
        handle, draft = tempfile.mkstemp(prefix=f".{place.name}.", dir=place.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                self.map._bytes().tofile(file)
                file.flush()
                os.fsync(file.fileno())
            os.chmod(draft, 0o644)
            os.replace(draft, place)
        except BaseException:
            os.unlink(draft)
            raise


def compile(
    path: str | os.PathLike[str],
    *,
    profile: Profile = "default",
    on_error: OnError = "quarantine",
    index_tolerance: float | None = None,
    bound_tolerance: float | None = None,
    lane_reach: float | None = None,
    landmarks: int | None = None,
    threads: int = 0,
) -> Compilation:
    """Compiles an OpenDRIVE file (.xodr, or .xodr.gz) in this process.

    Args:
        path: The file; others are included from its folder.
        profile: Which rules apply, and how bad their findings are.
        on_error: What becomes of a part with errors: it is left out, the map is rejected, or a road stays as its
            bare reference line.
        index_tolerance: Largest distance of a lane's centre line from its polyline [m]. Default 0.05.
        bound_tolerance: Largest distance of a lane's border from its polyline [m]. Default 0.01.
        lane_reach: Largest distance of an object or signal from the lane that it belongs to because it is nearest [m].
            Default 30.
        landmarks: Number of landmarks of the routing, up to 32. Default 16.
        threads: Threads to use; 0 for as many as the machine has.

    Raises:
        RejectedError: no map can be built; its ``report`` has the findings.
        FileError: the file cannot be read.
        ValueError: an option outside its range.
    """
    map, report = _mapd.read_file(
        path,
        build=True,
        profile=profile,
        on_error=on_error,
        index_tolerance=index_tolerance,
        bound_tolerance=bound_tolerance,
        lane_reach=lane_reach,
        landmarks=landmarks,
        threads=threads,
    )
    if map is None:
        why = next((str(f) for f in report.findings if f.rejects), "see the report")
        raise RejectedError(f"{os.fspath(path)} was rejected: {why}", report)
    return Compilation(map, report)


def check(
    path: str | os.PathLike[str],
    *,
    profile: Profile = "default",
    on_error: OnError = "quarantine",
    threads: int = 0,
) -> Report:
    """Reports all that :func:`compile` would report, without building the map. A map that would be rejected is not an error.

    Raises:
        FileError: the file cannot be read.
    """
    _, report = _mapd.read_file(
        path,
        build=False,
        profile=profile,
        on_error=on_error,
        index_tolerance=None,
        bound_tolerance=None,
        lane_reach=None,
        landmarks=None,
        threads=threads,
    )
    return report


def open(path: str | os.PathLike[str], *, key: str | os.PathLike[str] | None = None) -> Map:
    """Opens a ``.mapd`` archive in place, or compiles any other file in memory as :func:`compile` does by default.

    With `key`, a file with a public key (docs/operation.md), only an archive that was signed with its secret key, whose signature lies beside it.

    Raises:
        FileError: the file cannot be read.
        ArchiveError: it is no archive that this release reads.
        NotTrustedError: it was not signed with the key, or has been altered since.
        RejectedError: no map can be built from it.
    """
    if key is not None or Path(path).suffix == ".mapd":
        return _mapd.open_archive(path, key)
    return compile(path).map
