"""Answers to batches: named columns, a row for each question."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas
    import polars

_Self = TypeVar("_Self", bound="Columns")

_ROWS_SHOWN = 5


class Columns:
    """Named columns of one length: attributes, ``columns["s"]``, ``dict(columns)``, ``to_pandas()``, ``to_polars()``.

    ``Class(n)`` makes one with room for n rows, to be given as ``out=`` to calls that fill it again and again.
    """

    _dtypes: ClassVar[dict[str, type[np.generic]]] = {}
    __slots__ = ("_arrays",)
    _arrays: dict[str, NDArray[Any]]

    def __init__(self, rows: int) -> None:
        self._arrays = {name: np.empty(rows, dtype) for name, dtype in self._dtypes.items()}

    @classmethod
    def _of(cls: type[_Self], arrays: Sequence[NDArray[Any]], out: _Self | None) -> _Self:
        if out is None:
            made = cls.__new__(cls)
            made._arrays = dict(zip(cls._dtypes, arrays, strict=True))
            return made
        if type(out) is not cls:
            raise TypeError(f"out: expected {cls.__name__}, found {type(out).__name__}")
        if len(out) != len(arrays[0]):
            raise ValueError(f"out: expected {len(arrays[0])} rows, found {len(out)}")
        for own, array in zip(out._arrays.values(), arrays, strict=True):
            np.copyto(own, array, casting="no")
        return out

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the columns."""
        return tuple(self._dtypes)

    def keys(self) -> Iterator[str]:
        """Names of the columns, so that ``dict(columns)`` works."""
        return iter(self._dtypes)

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


_NUMBER, _ID, _CODE = np.float64, np.uint64, np.int8


class NearestLanes(Columns):
    """Lanes and the points in their coordinates; columns as of :class:`mapd.Nearest`.

    Where no lane is near enough, ``lane`` is :data:`mapd.NONE`, ``distance`` infinite, the rest NaN.
    """

    _dtypes = {
        "lane": _ID, "s": _NUMBER, "t": _NUMBER, "offset": _NUMBER, "distance": _NUMBER, "z": _NUMBER, "heading": _NUMBER, "clamped": _CODE,
    }  # fmt: skip
    __slots__ = ()
    if TYPE_CHECKING:
        lane: NDArray[np.uint64]
        s: NDArray[np.float64]
        t: NDArray[np.float64]
        offset: NDArray[np.float64]
        distance: NDArray[np.float64]
        z: NDArray[np.float64]
        heading: NDArray[np.float64]
        clamped: NDArray[np.int8]


class LanesNear(Columns):
    """All lanes near points: a row for each lane of each point, nearest first; ``point`` is the point's row."""

    _dtypes = {"point": np.int64, **NearestLanes._dtypes}
    __slots__ = ()
    if TYPE_CHECKING:
        point: NDArray[np.int64]
        lane: NDArray[np.uint64]
        s: NDArray[np.float64]
        t: NDArray[np.float64]
        offset: NDArray[np.float64]
        distance: NDArray[np.float64]
        z: NDArray[np.float64]
        heading: NDArray[np.float64]
        clamped: NDArray[np.int8]


class Poses(Columns):
    """Places with the frame there; columns as of :class:`mapd.Pose`."""

    _dtypes = {
        "x": _NUMBER, "y": _NUMBER, "z": _NUMBER, "heading": _NUMBER, "curvature": _NUMBER, "slope": _NUMBER,
        "superelevation": _NUMBER, "clamped": _CODE,
    }  # fmt: skip
    __slots__ = ()
    if TYPE_CHECKING:
        x: NDArray[np.float64]
        y: NDArray[np.float64]
        z: NDArray[np.float64]
        heading: NDArray[np.float64]
        curvature: NDArray[np.float64]
        slope: NDArray[np.float64]
        superelevation: NDArray[np.float64]
        clamped: NDArray[np.int8]


class Tracks(Columns):
    """Feet on a road's reference line; columns as of :class:`mapd.TrackPosition`. ``h`` is NaN for points without z."""

    _dtypes = {"s": _NUMBER, "t": _NUMBER, "h": _NUMBER, "distance": _NUMBER, "clamped": _CODE, "exact": np.bool_}
    __slots__ = ()
    if TYPE_CHECKING:
        s: NDArray[np.float64]
        t: NDArray[np.float64]
        h: NDArray[np.float64]
        distance: NDArray[np.float64]
        clamped: NDArray[np.int8]
        exact: NDArray[np.bool_]


class Heights(Columns):
    """The road's surface; columns as of :class:`mapd.Height`. Beside all lanes NaN, and ``lane`` is :data:`mapd.NONE`."""

    _dtypes = {"z": _NUMBER, "nx": _NUMBER, "ny": _NUMBER, "nz": _NUMBER, "lane": _ID}
    __slots__ = ()
    if TYPE_CHECKING:
        z: NDArray[np.float64]
        nx: NDArray[np.float64]
        ny: NDArray[np.float64]
        nz: NDArray[np.float64]
        lane: NDArray[np.uint64]


class Waypoints(Columns):
    """Places on a lane's centre line in driving direction; ``heading`` is that of the centre line, ``width`` the lane's [m]."""

    _dtypes = {"s": _NUMBER, "x": _NUMBER, "y": _NUMBER, "z": _NUMBER, "heading": _NUMBER, "width": _NUMBER}
    __slots__ = ()
    if TYPE_CHECKING:
        s: NDArray[np.float64]
        x: NDArray[np.float64]
        y: NDArray[np.float64]
        z: NDArray[np.float64]
        heading: NDArray[np.float64]
        width: NDArray[np.float64]


class Reached(Columns):
    """Pieces of lanes that can be reached, nearest first: ``cost`` up to their beginning, [m] by length or [s] by time."""

    _dtypes = {"lane": _ID, "forward": np.bool_, "s_from": _NUMBER, "s_to": _NUMBER, "cost": _NUMBER}
    __slots__ = ()
    if TYPE_CHECKING:
        lane: NDArray[np.uint64]
        forward: NDArray[np.bool_]
        s_from: NDArray[np.float64]
        s_to: NDArray[np.float64]
        cost: NDArray[np.float64]


class Geodetics(Columns):
    """Places on WGS 84: latitude and longitude [deg], altitude [m]."""

    _dtypes = {"latitude": _NUMBER, "longitude": _NUMBER, "altitude": _NUMBER}
    __slots__ = ()
    if TYPE_CHECKING:
        latitude: NDArray[np.float64]
        longitude: NDArray[np.float64]
        altitude: NDArray[np.float64]


class Inertials(Columns):
    """Inertial points [m]."""

    _dtypes = {"x": _NUMBER, "y": _NUMBER, "z": _NUMBER}
    __slots__ = ()
    if TYPE_CHECKING:
        x: NDArray[np.float64]
        y: NDArray[np.float64]
        z: NDArray[np.float64]


class PathPoints(Columns):
    """Places on a path; columns as of :class:`mapd.PathPoint`."""

    _dtypes = {
        "along": _NUMBER, "x": _NUMBER, "y": _NUMBER, "z": _NUMBER, "heading": _NUMBER, "curvature": _NUMBER, "curvature_rate": _NUMBER, "grade": _NUMBER, "superelevation": _NUMBER, "left": _NUMBER, "right": _NUMBER, "s": _NUMBER, "lane": _ID, "clamped": _CODE,
    }  # fmt: skip
    __slots__ = ()
    if TYPE_CHECKING:
        along: NDArray[np.float64]
        x: NDArray[np.float64]
        y: NDArray[np.float64]
        z: NDArray[np.float64]
        heading: NDArray[np.float64]
        curvature: NDArray[np.float64]
        curvature_rate: NDArray[np.float64]
        grade: NDArray[np.float64]
        superelevation: NDArray[np.float64]
        left: NDArray[np.float64]
        right: NDArray[np.float64]
        s: NDArray[np.float64]
        lane: NDArray[np.uint64]
        clamped: NDArray[np.int8]


class PathPositions(Columns):
    """Points in a path's coordinates; columns as of :class:`mapd.PathPosition`."""

    _dtypes = {
        "along": _NUMBER, "d": _NUMBER, "distance": _NUMBER, "heading": _NUMBER, "s": _NUMBER, "lane": _ID, "clamped": _CODE,
    }  # fmt: skip
    __slots__ = ()
    if TYPE_CHECKING:
        along: NDArray[np.float64]
        d: NDArray[np.float64]
        distance: NDArray[np.float64]
        heading: NDArray[np.float64]
        s: NDArray[np.float64]
        lane: NDArray[np.uint64]
        clamped: NDArray[np.int8]


class Corridor(Columns):
    """The room along a path: edges of the driven lane, and of all lanes beside it that have its direction and are open [m]."""

    _dtypes = {
        "along": _NUMBER, "lane": _ID, "left_x": _NUMBER, "left_y": _NUMBER, "left_z": _NUMBER, "right_x": _NUMBER, "right_y": _NUMBER, "right_z": _NUMBER, "outer_left_x": _NUMBER, "outer_left_y": _NUMBER, "outer_left_z": _NUMBER, "outer_right_x": _NUMBER, "outer_right_y": _NUMBER, "outer_right_z": _NUMBER, "left_may_cross": np.bool_, "right_may_cross": np.bool_,
    }  # fmt: skip
    __slots__ = ()
    if TYPE_CHECKING:
        along: NDArray[np.float64]
        lane: NDArray[np.uint64]
        left_x: NDArray[np.float64]
        left_y: NDArray[np.float64]
        left_z: NDArray[np.float64]
        right_x: NDArray[np.float64]
        right_y: NDArray[np.float64]
        right_z: NDArray[np.float64]
        outer_left_x: NDArray[np.float64]
        outer_left_y: NDArray[np.float64]
        outer_left_z: NDArray[np.float64]
        outer_right_x: NDArray[np.float64]
        outer_right_y: NDArray[np.float64]
        outer_right_z: NDArray[np.float64]
        left_may_cross: NDArray[np.bool_]
        right_may_cross: NDArray[np.bool_]
