"""Errors: a class per kind. Each is a :class:`MapdError`, and what Python's own code expects besides."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._results import Report


class MapdError(Exception):
    """Base class of all errors of mapd."""


class AttachError(MapdError):
    """A served map cannot be attached to, or a generation is not available."""


class NoDaemonError(AttachError, ConnectionError):
    """No daemon is running in the domain, or none came in time."""


class NoSuchMapError(AttachError, LookupError):
    """Daemons are running, but none serves a map of this name."""


class NoGenerationError(AttachError, TimeoutError):
    """No newer generation, or none of this number, came in time."""


class SupersededError(AttachError):
    """A newer generation than the one that was asked for is served already."""


class WrongTransportError(AttachError):
    """The daemon is of a release with another transport."""


class ExhaustedError(AttachError):
    """A limit is reached: subscriptions, held generations, shared memory or file descriptors."""


class NotPermittedError(AttachError, PermissionError):
    """The domain belongs to another user."""


class BusyError(AttachError, TimeoutError):
    """A lock was not released in time, a killed process left a file that a daemon has to remove, or a decision did not come in time."""


class BadNameError(AttachError, ValueError):
    """The name of a map or the prefix of a domain is invalid."""


class ProposalRefusedError(MapdError, PermissionError):
    """The daemon refuses what was proposed; the message has its reason."""


class ClosedError(MapdError):
    """The client was closed."""


class ForkedError(MapdError):
    """The connection belongs to the process that was forked; connect again in this one."""


class ArchiveError(MapdError):
    """The bytes are not an archive that this release can read, or the archive failed verification."""


class NotTrustedError(MapdError, PermissionError):
    """The archive was not signed with the key."""


class FileError(MapdError, OSError):
    """A file cannot be read; ``errno`` and ``filename`` say more."""


class RejectedError(MapdError):
    """A file was rejected: no map can be built from it. ``report`` has the findings."""

    report: Report

    def __init__(self, message: str, report: Report) -> None:
        super().__init__(message)
        self.report = report

    def __reduce__(self) -> tuple[type[RejectedError], tuple[str, Report]]:
        """Pickled with its report: otherwise a worker process that raises it breaks its pool."""
        return type(self), (str(self), self.report)


class QueryError(MapdError):
    """A question has no answer."""


class ForeignIdError(QueryError, LookupError):
    """The id is of another map content; look it up again by its key."""


class NoSuchPartError(QueryError, KeyError):
    """The map has no part of this name."""

    def __str__(self) -> str:
        return Exception.__str__(self)


class PathError(QueryError, ValueError):
    """The steps do not form a path; the message names the step."""


class CorruptError(QueryError):
    """The archive contradicts itself here; ``Map.verify`` names the row."""


class NotFiniteError(QueryError, ValueError):
    """A number that is not finite."""


class ProjectionError(QueryError, ValueError):
    """The map has no projection that can be used, or a place lies outside its area."""
