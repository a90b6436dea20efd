"""Answers to batches: named columns, a row for each question."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas
    import polars

    from ._mapd import Memory

_Self = TypeVar("_Self", bound="Columns")

_ROWS_SHOWN = 5

Numbers = NDArray[np.float64]
Ids = NDArray[np.uint64]
Codes = NDArray[np.int8]
Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]
_DTYPES: dict[str, type[np.generic]] = {
    "Numbers": np.float64,
    "Ids": np.uint64,
    "Codes": np.int8,
    "Counts": np.int64,
    "Flags": np.bool_,
}


class Columns:
    """Named columns of one length: attributes, ``columns["s"]``, ``dict(columns)``, ``to_pandas()``, ``to_polars()``.

    ``Class(n)`` makes one with room for n rows, to be given as ``out=`` to calls that fill it again and again. It keeps the memory that a call needs, two to three times
    that of the columns, so that from the second call on nothing is allocated that grows with n. An error leaves the columns as they were.
    """

    _dtypes: ClassVar[dict[str, type[np.generic]]] = {}
    __slots__ = ("_arrays", "_memory")
    _arrays: dict[str, NDArray[Any]]
    _memory: Memory | None

    def __init_subclass__(cls) -> None:
        """A class is its annotations: its own columns, then those that it inherits."""
        own = {name: _DTYPES[kind] for name, kind in cls.__annotations__.items()}
        cls._dtypes = {**own, **cls._dtypes}

    def __init__(self, rows: int) -> None:
        self._arrays = {name: np.empty(rows, dtype) for name, dtype in self._dtypes.items()}
        self._memory = None

    @classmethod
    def _of(cls: type[_Self], arrays: Sequence[NDArray[Any]]) -> _Self:
        made = cls.__new__(cls)
        made._arrays = dict(zip(cls._dtypes, arrays, strict=True))
        made._memory = None
        return made

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the columns."""
        return tuple(self._dtypes)

    def keys(self) -> Iterator[str]:
        """Names of the columns, so that ``dict(columns)`` works."""
        return iter(self._dtypes)

    def __iter__(self) -> Iterator[str]:
        """Names of the columns, as of a dict or a data frame; ``len`` is the number of rows."""
        return self.keys()

    def __contains__(self, name: object) -> bool:
        return name in self._dtypes

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._arrays[name]

    def __getattr__(self, name: str) -> NDArray[Any]:
        try:
            return object.__getattribute__(self, "_arrays")[name]  # type: ignore[no-any-return]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no column {name!r}; it has {list(self._dtypes)}") from None

    def __len__(self) -> int:
        return len(next(iter(self._arrays.values())))

    def __getstate__(self) -> dict[str, NDArray[Any]]:
        return self._arrays

    def __setstate__(self, arrays: dict[str, NDArray[Any]]) -> None:
        self._arrays = arrays
        self._memory = None

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """The columns by name, not copied."""
        return dict(self._arrays)

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame; needs pandas."""
        import pandas

        return pandas.DataFrame(self.to_dict())

    def to_polars(self) -> polars.DataFrame:
        """A data frame; needs polars."""
        import polars

        return polars.DataFrame(self.to_dict())

    def __repr__(self) -> str:
        rows = len(self)
        head = ", ".join(f"{name}={np.array2string(self[name][:_ROWS_SHOWN], precision=3)}" for name in self.names)
        return f"<mapd.{type(self).__name__} {rows} rows: {head}{' …' if rows > _ROWS_SHOWN else ''}>"

    def _repr_html_(self) -> str:
        cells = "".join(f"<th>{name}</th>" for name in self.names)
        rows = [f"<tr>{cells}</tr>"]
        for row in range(min(len(self), _ROWS_SHOWN)):
            rows.append("<tr>" + "".join(f"<td>{self[name][row]:g}</td>" for name in self.names) + "</tr>")
        return f"<table>{''.join(rows)}</table><p>{len(self)} rows</p>"


class _Positions(Columns):
    __slots__ = ()
    lane: Ids
    s: Numbers
    t: Numbers
    offset: Numbers
    distance: Numbers
    z: Numbers
    heading: Numbers
    clamped: Codes
    offset_of_reference_line: Numbers
    heading_of_reference_line: Numbers


class NearestLanes(_Positions):
    """Lanes and the points in their coordinates; columns as of :class:`mapd.Nearest`.

    Where no lane is near enough, ``lane`` is :data:`mapd.NONE`, ``distance`` infinite, the rest NaN.
    """

    __slots__ = ()


class LanesNear(_Positions):
    """All lanes near points: a row for each lane of each point, nearest first; ``point`` is the point's row."""

    __slots__ = ()
    point: Counts


class LaneMatches(_Positions):
    """Lanes that vehicles may be in: a row for each lane of each pose, the most probable first, then one for none with the lane :data:`mapd.NONE`.

    ``point`` is the pose's row; other columns as of :class:`mapd.LaneMatch`.
    """

    __slots__ = ()
    point: Counts
    forward: Flags
    probability: Numbers
    mahalanobis: Numbers
    heading_difference: Numbers


class TraceMatches(_Positions):
    """Where the fixes of a trace were, each with its probability given the whole trace; ``lane`` is :data:`mapd.NONE` on no lane."""

    __slots__ = ()
    forward: Flags
    probability: Numbers


class Poses(Columns):
    """Places with the frame there; columns as of :class:`mapd.Pose`."""

    __slots__ = ()
    x: Numbers
    y: Numbers
    z: Numbers
    heading: Numbers
    curvature: Numbers
    slope: Numbers
    superelevation: Numbers
    clamped: Codes


class Tracks(Columns):
    """Feet on a road's reference line; columns as of :class:`mapd.TrackPosition`. ``h`` is NaN for points without z."""

    __slots__ = ()
    s: Numbers
    t: Numbers
    h: Numbers
    distance: Numbers
    clamped: Codes
    exact: Flags


class Grounds(Columns):
    """The ground below places; columns as of :class:`mapd.Ground`. Beside all lanes NaN, and ``lane`` is :data:`mapd.NONE`."""

    __slots__ = ()
    z: Numbers
    nx: Numbers
    ny: Numbers
    nz: Numbers
    s: Numbers
    t: Numbers
    lane: Ids
    level: Counts
    levels: Counts


class NearMarks(Columns):
    """Road marks; columns as of :class:`mapd.NearMark`. Where none is near enough, ``lane`` is :data:`mapd.NONE`, ``distance`` infinite, the rest NaN.

    ``side`` is 1 to the left, -1 to the right; ``kind`` and ``color`` are codes (:data:`mapd.MARK_KINDS`, :data:`mapd.MARK_COLORS`);
    ``painted`` is 1, in a gap 0, and -1 where the file does not say.
    """

    __slots__ = ()
    lane: Ids
    s: Numbers
    x: Numbers
    y: Numbers
    distance: Numbers
    width: Numbers
    side: Codes
    kind: Codes
    color: Codes
    painted: Codes


class SpeedRules(Columns):
    """Speed limits: ``max`` [m/s] is infinite where there is none, NaN where the map says nothing; ``origin`` counts in :data:`mapd.SPEED_ORIGINS`."""

    __slots__ = ()
    max: Numbers
    origin: Codes


class Waypoints(Columns):
    """Places on a lane's centre line in driving direction; ``heading`` is that of the centre line, ``width`` the lane's [m]."""

    __slots__ = ()
    s: Numbers
    x: Numbers
    y: Numbers
    z: Numbers
    heading: Numbers
    width: Numbers


class BoundarySegments(Columns):
    """Pieces of lanes' outer borders, by their lanes; lane 0 for the line between left and right lanes. s of both ends [m], ascending, and both ends, inertial [m]."""

    __slots__ = ()
    lane: Ids
    s_from: Numbers
    s_to: Numbers
    x_from: Numbers
    y_from: Numbers
    z_from: Numbers
    x_to: Numbers
    y_to: Numbers
    z_to: Numbers


class RoadMarkSegments(BoundarySegments):
    """Pieces of borders that carry a road mark; ``kind`` and ``color`` are codes (:data:`mapd.MARK_KINDS`, :data:`mapd.MARK_COLORS`), ``width`` the mark's [m]."""

    __slots__ = ()
    kind: Codes
    color: Codes
    width: Numbers


class LaneNodes(Columns):
    """Nodes of the lane graph: lanes, or pieces of them, travelled in one direction, with s where they begin and end in that direction [m].

    ``length`` is the centre line's [m], ``travel_time`` what a route by time counts [s]. ``left`` and ``right`` are the rows of nodes beside them that are travelled the
    same way, -1 where there is none, and ``change_left`` and ``change_right`` say whether road marks allow a change of lane there. ``component`` is the strongly
    connected component; no edge leads from a higher number to a lower one.
    """

    __slots__ = ()
    lane: Ids
    forward: Flags
    s_from: Numbers
    s_to: Numbers
    length: Numbers
    travel_time: Numbers
    left: Counts
    right: Counts
    change_left: Flags
    change_right: Flags
    component: Counts


class LaneEdges(Columns):
    """Edges of the lane graph, by the rows of the nodes from which and into which they lead; ``kind`` is a code of ``mapd.WORDS["edge_kind"]``.

    Without those that close a loop the graph has no cycle.
    """

    __slots__ = ()
    start: Counts
    end: Counts
    kind: Codes
    closes_loop: Flags


class Reached(Columns):
    """Pieces of lanes that can be reached, nearest first: ``cost`` up to their beginning, [m] by length or [s] by time, with so many changes of lane.

    ``s_from`` and ``s_to`` are where the part within the limit begins and ends, in driving direction [m].
    """

    __slots__ = ()
    lane: Ids
    forward: Flags
    s_from: Numbers
    s_to: Numbers
    cost: Numbers
    lane_changes: Counts


class ReachLinks(Columns):
    """How one goes on from one piece that is reached to another, by their rows; ``enter`` is 1 ahead, 2 by a change of lane to the left, 3 to the right."""

    __slots__ = ()
    start: Counts
    end: Counts
    enter: Codes


class Geodetics(Columns):
    """Places on WGS 84: latitude and longitude [deg], altitude [m]."""

    __slots__ = ()
    latitude: Numbers
    longitude: Numbers
    altitude: Numbers


class Inertials(Columns):
    """Inertial points [m]."""

    __slots__ = ()
    x: Numbers
    y: Numbers
    z: Numbers


class PathPoints(Columns):
    """Places on a path; columns as of :class:`mapd.PathPoint`."""

    __slots__ = ()
    along: Numbers
    x: Numbers
    y: Numbers
    z: Numbers
    heading: Numbers
    curvature: Numbers
    curvature_rate: Numbers
    grade: Numbers
    superelevation: Numbers
    left: Numbers
    right: Numbers
    s: Numbers
    lane: Ids
    clamped: Codes


class PathPositions(Columns):
    """Points in a path's coordinates; columns as of :class:`mapd.PathPosition`."""

    __slots__ = ()
    along: Numbers
    d: Numbers
    distance: Numbers
    heading: Numbers
    s: Numbers
    lane: Ids
    clamped: Codes


class Corridor(Columns):
    """The room along a path: edges of the driven lane, and of all lanes beside it that have its direction and are open [m].

    Marks are codes (:data:`mapd.MARK_KINDS`, :data:`mapd.MARK_COLORS`): where there is none, the kind is that of ``none``, 1, and the color -1; ``may_cross`` says whether a change over the edge is allowed; ``edge``
    what lies beyond, in :data:`mapd.EDGES`. ``s`` is that on the driven lane's road [m]; ``speed`` the limit [m/s], infinite where there is none, NaN where the map says
    nothing, and ``speed_origin`` who says so, in :data:`mapd.SPEED_ORIGINS`.
    """

    __slots__ = ()
    along: Numbers
    lane: Ids
    left_x: Numbers
    left_y: Numbers
    left_z: Numbers
    right_x: Numbers
    right_y: Numbers
    right_z: Numbers
    outer_left_x: Numbers
    outer_left_y: Numbers
    outer_left_z: Numbers
    outer_right_x: Numbers
    outer_right_y: Numbers
    outer_right_z: Numbers
    left_mark: Codes
    left_color: Codes
    left_may_cross: Flags
    left_edge: Codes
    right_mark: Codes
    right_color: Codes
    right_may_cross: Flags
    right_edge: Codes
    outer_left_mark: Codes
    outer_left_color: Codes
    outer_left_may_cross: Flags
    outer_left_edge: Codes
    outer_right_mark: Codes
    outer_right_color: Codes
    outer_right_may_cross: Flags
    outer_right_edge: Codes
    s: Numbers
    speed: Numbers
    speed_origin: Codes

    def outline(self, edges: Literal["driven", "open"] = "driven") -> tuple[Numbers, bool]:
        """The room as one polygon (M, 2) [m]: along the right edges, then back along the left ones; and whether no two of its sides meet but neighbours."""
        from ._mapd import outline

        if edges not in ("driven", "open"):
            raise ValueError(f'edges: expected "driven" or "open", found {edges!r}')
        before = "" if edges == "driven" else "outer_"
        left, right = (
            np.column_stack([self[f"{before}{side}_x"], self[f"{before}{side}_y"]]) for side in ("left", "right")
        )
        return outline(left, right)


class CorridorSurface(Columns):
    """The road's surface at the stations of a path: place of the lane's middle [m], unit normal upwards, friction and roughness (NaN where not given)."""

    __slots__ = ()
    along: Numbers
    x: Numbers
    y: Numbers
    z: Numbers
    nx: Numbers
    ny: Numbers
    nz: Numbers
    friction: Numbers
    roughness: Numbers


class PathSegments(Columns):
    """Lanes from which a path's goal is reached along the path's own roads, stretch by stretch, from left to right.

    ``changes`` of lane are left at least; ``last_change`` is the largest S at which one can still be on the lane and come to the goal [m]; ``lane_end`` the S at which the
    lane leads on along the path no more [m].
    """

    __slots__ = ()
    start: Numbers
    end: Numbers
    lane: Ids
    forward: Flags
    driven: Flags
    changes: Counts
    last_change: Numbers
    lane_end: Numbers


class Approaches(Columns):
    """Lanes on which traffic comes to a conflict: s where the part within the distance begins and ends, and how far both are from it along centre lines [m]."""

    __slots__ = ()
    lane: Ids
    forward: Flags
    s_from: Numbers
    s_to: Numbers
    distance_from: Numbers
    distance_to: Numbers


class Restrictions(Columns):
    """Stretches of lanes on which an overlay's entry holds [m]; ``entry`` is its number among the view's entries."""

    __slots__ = ()
    lane: Ids
    s_from: Numbers
    s_to: Numbers
    entry: Counts


class Permissions(Columns):
    """Whether lanes may be used; ``entry`` is the number of the overlay's entry that decides so, -1 where the map does."""

    __slots__ = ()
    is_allowed: Flags
    entry: Counts


class SpeedsToday(Columns):
    """Speed limits of today [m/s] and those of the map; ``entry`` is the number of the entry that says otherwise, -1 where none does."""

    __slots__ = ()
    max: Numbers
    map_max: Numbers
    entry: Counts


class TrackedFixes(_Positions):
    """Where a tracked vehicle was: ``state`` counts in :data:`mapd.TRACKED`; without a lane ``lane`` is :data:`mapd.NONE` and ``probability`` NaN; ``none`` is the probability of no lane."""

    __slots__ = ()
    state: Codes
    forward: Flags
    probability: Numbers
    none: Numbers


class Stances(Columns):
    """How vehicles stand: height of the ground's plane below the reference point [m], roll and pitch [rad], heights below the wheels [m]; NaN where there is none."""

    __slots__ = ()
    z: Numbers
    roll: Numbers
    pitch: Numbers
    wheel_0: Numbers
    wheel_1: Numbers
    wheel_2: Numbers
    wheel_3: Numbers


class MarkPoints(Columns):
    """Painted places [m] of marks on a lane's outer border, or of objects (`object`, its `copy` or −1), on their lines or, with `outline` 1, around what is painted as a whole.

    `s` and the line's width are in [m]; kind and color are codes.
    """

    __slots__ = ()
    x: Numbers
    y: Numbers
    z: Numbers
    lane: Ids
    s: Numbers
    width: Numbers
    kind: Codes
    color: Codes
    object: Ids
    copy: Counts
    outline: Codes
