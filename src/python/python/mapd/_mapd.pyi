"""The compiled part of mapd."""

import os
from collections.abc import Iterable, Iterator, Sequence
from types import TracebackType
from typing import Literal, final, overload

import numpy as np
from numpy.typing import NDArray

from ._columns import (
    Corridor,
    Geodetics,
    Grounds,
    Inertials,
    LaneMatches,
    LanesNear,
    NearestLanes,
    NearMarks,
    PathPoints,
    PathPositions,
    Poses,
    Reached,
    SpeedRules,
    TraceMatches,
    Tracks,
    Waypoints,
)
from ._results import (
    Event,
    Ground,
    LanePosition,
    Lines,
    Nearest,
    NearMark,
    PathConflict,
    PathPoint,
    PathPosition,
    Pose,
    PoseMatch,
    Report,
    Route,
    RouteStep,
    SignalAhead,
    SpeedRule,
    TrackPosition,
)

_Point = tuple[float, float] | tuple[float, float, float]
_Points = NDArray[np.float64]
_Track = tuple[float, float] | tuple[float, float, float]
_Region = tuple[float, float, float, float]
_Types = str | Iterable[str]
_LaneRef = Lane | str | int | np.uint64
_Place = Nearest | tuple[_LaneRef, float]
_By = Literal["length", "time"]

__all__ = [
    "Client",
    "Events",
    "Map",
    "Lane",
    "Road",
    "Signal",
    "Object",
    "Path",
    "open_archive",
    "read_file",
    "NONE",
    "LANE_TYPES",
    "MARK_KINDS",
    "MARK_COLORS",
    "SPEED_ORIGINS",
    "__version__",
]

__version__: str
NONE: int
"""Stands for "no lane" in columns of ids."""
LANE_TYPES: dict[int, str]
"""Lane types in the words of OpenDRIVE, by their codes."""
MARK_KINDS: dict[int, str]
"""Words of road marks' kinds by the codes in columns."""
MARK_COLORS: dict[int, str]
"""Words of road marks' colours by the codes in columns."""
SPEED_ORIGINS: list[str]
"""Words of speed limits' origins, in the order of the codes in columns."""

def open_archive(path: str | os.PathLike[str]) -> Map: ...
def read_file(
    path: str | os.PathLike[str],
    *,
    build: bool,
    profile: str,
    on_error: str,
    index_tolerance: float | None,
    bound_tolerance: float | None,
    lane_reach: float | None,
    landmarks: int | None,
    threads: int,
) -> tuple[Map | None, Report]: ...

@final
class Client:
    """A connection to one served map. Threads may share it; a forked process connects again.

    Connects in the domain of `prefix` (else of the environment variable MAPD_PREFIX) and pins the newest generation. Daemon and client may
    start in any order; `timeout` is in seconds. `with` closes it.
    """

    def __new__(cls, name: str, *, timeout: float = 5.0, prefix: str | None = None) -> Client: ...
    @property
    def name(self) -> str:
        """Name of the map."""
    @property
    def closed(self) -> bool:
        """Whether it was closed."""
    def map(self) -> Map:
        """The newest generation seen so far, without looking for another."""
    def refresh(self) -> Map:
        """Looks for a newer generation without waiting and returns the newest."""
    def wait(self, timeout: float = 5.0) -> Map:
        """Waits [s] for a generation newer than the newest seen so far; NoGenerationError if none comes."""
    def require(self, generation: int, timeout: float = 5.0) -> Map:
        """Waits [s] for the generation of this number; SupersededError if a newer one is served already."""
    @property
    def pending(self) -> int | None:
        """The generation that is staged and waits to be activated."""
    @property
    def served_by(self) -> int | None:
        """Process id of the daemon that serves the map now; None if none does."""
    def populate(self) -> None:
        """Has every page of this and later generations mapped before they are handed out."""
    def events(self) -> Events:
        """Follows the map from now on."""
    def close(self) -> None:
        """Gives the connection back. Maps that are held stay readable."""
    def __enter__(self) -> Client: ...
    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> Literal[False]: ...

@final
class Events:
    """What becomes of a map, as it happens; an iterator that waits."""

    def wait(self, timeout: float = 5.0) -> Event | None:
        """The next event, or None if nothing happens in time [s]."""
    def __iter__(self) -> Iterator[Event]: ...
    def __next__(self) -> Event: ...

@final
class Map:
    """One generation of a map, pinned: immutable, shared by threads, readable as long as it or anything that came from it lives."""

    @property
    def generation(self) -> int:
        """What it was published as; 0 for a file."""
    @property
    def name(self) -> str:
        """Name in the file's header."""
    @property
    def content_hash(self) -> bytes:
        """BLAKE3 of the archive's body."""
    @property
    def source_hash(self) -> bytes:
        """BLAKE3 of the OpenDRIVE file that it was compiled from."""
    @property
    def revision(self) -> tuple[int, int]:
        """OpenDRIVE's version: revMajor, revMinor."""
    @property
    def bounds(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Smallest and largest x, y, z of all lanes [m]."""
    @property
    def road_length(self) -> float:
        """Sum of the roads' lengths [m]."""
    @property
    def geo_reference(self) -> str:
        """The georeference as written."""
    @property
    def projection(self) -> str:
        """The georeference as PROJ parameters; empty if there is none that can be used."""
    def verify(self) -> None:
        """Proves the whole archive, content hash included; linear in its size."""
    def populate(self) -> None:
        """Has every page of the archive mapped in this process now."""
    def lanes(self) -> list[Lane]:
        """All lanes, lane 0 of each section left out."""
    def roads(self) -> list[Road]:
        """All roads in file order."""
    def signals(self) -> list[Signal]:
        """All signals."""
    def objects(self) -> list[Object]:
        """All objects."""
    def lane(self, lane: _LaneRef) -> Lane:
        """The lane of a key such as "12:0:-1", or of an id."""
    def road(self, id: str) -> Road:
        """The road with OpenDRIVE's id."""
    def signal(self, id: str) -> Signal:
        """The signal with OpenDRIVE's id."""
    def object(self, id: str) -> Object:
        """The object with OpenDRIVE's id."""
    @overload
    def nearest_lane(
        self,
        points: _Point,
        *,
        radius: float = 10.0,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        heading: float | None = None,
        heading_tolerance: float | None = None,
    ) -> Nearest | None: ...
    @overload
    def nearest_lane(
        self,
        points: _Points,
        *,
        radius: float = 10.0,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        heading: float | NDArray[np.float64] | None = None,
        heading_tolerance: float | None = None,
        out: NearestLanes | None = None,
    ) -> NearestLanes:
        """The lane whose area is nearest in plan view, at most `radius` [m] away; of several, by heading difference, height, offset.

        `types` are the lane types that count ("drivable", or OpenDRIVE's names). `z_tolerance` [m] tells levels apart and needs points
        with z; `heading` [rad] of travel breaks ties, and excludes lanes by `heading_tolerance` [rad].
        """
    @overload
    def lanes_near(
        self,
        points: _Point,
        *,
        radius: float = 10.0,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        heading: float | None = None,
        heading_tolerance: float | None = None,
    ) -> list[Nearest]: ...
    @overload
    def lanes_near(
        self,
        points: _Points,
        *,
        radius: float = 10.0,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        heading: float | NDArray[np.float64] | None = None,
        heading_tolerance: float | None = None,
    ) -> LanesNear:
        """Every lane within `radius` [m], nearest first; options as of nearest_lane."""
    def position_of(
        self, lanes: NDArray[np.uint64], points: _Points, *, out: NearestLanes | None = None
    ) -> NearestLanes:
        """Each point in the coordinates of its lane."""
    def pose_at(
        self,
        lanes: NDArray[np.uint64],
        s: float | NDArray[np.float64],
        offset: float | NDArray[np.float64] | None = None,
        *,
        out: Poses | None = None,
    ) -> Poses:
        """Poses on lanes as their traffic has them, at s [m], `offset` [m] to the left of the lane's centre."""
    def speed_rule_at(
        self, lanes: NDArray[np.uint64], s: float | NDArray[np.float64], *, out: SpeedRules | None = None
    ) -> SpeedRules:
        """Speed limits on lanes at s [m], signs included."""
    @overload
    def ground_at(self, points: _Point) -> Ground | None: ...
    @overload
    def ground_at(self, points: _Points, *, out: Grounds | None = None) -> Grounds:
        """The surface below points [m], on the level whose height is nearest to z; on the lowest one of points without z.

        Heights more than 2 m apart are levels of their own. Nothing beside all lanes.
        """
    @overload
    def nearest_mark(
        self, points: _Point, *, radius: float = 5.0, kinds: Sequence[str] | None = None, types: _Types | None = None
    ) -> NearMark | None: ...
    @overload
    def nearest_mark(
        self,
        points: _Points,
        *,
        radius: float = 5.0,
        kinds: Sequence[str] | None = None,
        types: _Types | None = None,
        out: NearMarks | None = None,
    ) -> NearMarks:
        """The nearest road mark on its exact course, at most `radius` [m] away; lines count along their whole length, gaps included.

        `kinds` are the kinds that count, `types` the types of the lanes beside them.
        """
    @overload
    def match_pose(
        self,
        points: _Point,
        heading: float,
        covariance: NDArray[np.float64],
        *,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        drive_deviation: float = 0.1,
        none: float = 0.01,
        vehicle: str | None = None,
        closed: float = 0.05,
        expected: Sequence[_LaneRef] | None = None,
        unexpected: float = 0.05,
    ) -> PoseMatch: ...
    @overload
    def match_pose(
        self,
        points: _Points,
        heading: float | NDArray[np.float64],
        covariance: NDArray[np.float64],
        *,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        drive_deviation: float = 0.1,
        none: float = 0.01,
        vehicle: str | None = None,
        closed: float = 0.05,
        expected: Sequence[_LaneRef] | None = None,
        unexpected: float = 0.05,
    ) -> LaneMatches:
        """The lanes that vehicles may be in, and the probability that they are in none (docs/localisation.md).

        `heading` [rad]; `covariance` of (x, y, heading) [m^2, m rad, rad^2], one (3, 3) for all or (N, 3, 3). `drive_deviation` [rad] is
        how drivers deviate from their lane's direction, `none` the prior of no lane; `closed` and `unexpected` are the shares of the
        prior that lanes have which `vehicle` may not use, and which are not among `expected`.
        """
    def match_trace(
        self,
        time: NDArray[np.float64],
        points: _Points,
        *,
        heading: float | NDArray[np.float64] | None = None,
        deviation: float = 1.0,
        heading_deviation: float = 0.1,
        change_interval: float = 30.0,
        vehicle: str = "passengerCar",
        types: _Types | None = None,
        out: TraceMatches | None = None,
    ) -> TraceMatches:
        """The most probable way through a trace, a place for each fix.

        `time` [s] does not fall; `heading` [rad] is NaN where it is not known; `deviation` [m] is that of x and y, `heading_deviation` [rad] that of headings, `change_interval` [s]
        the mean time between changes of lane.
        """
    def lanes_in(self, region: _Region, *, types: _Types | None = None) -> list[Lane]:
        """Lanes whose area meets a rectangle (x_min, y_min, x_max, y_max) [m]."""
    def signals_near(self, point: tuple[float, float], radius: float) -> list[tuple[Signal, float]]:
        """Signals within a radius [m] with their distances [m], nearest first."""
    def objects_near(self, point: tuple[float, float], radius: float) -> list[tuple[Object, float]]:
        """Objects whose area comes within a radius [m], with their distances [m], nearest first; once for each of their places."""
    def lines(
        self,
        region: _Region | None = None,
        *,
        types: _Types | None = None,
        which: Literal["center", "left", "right"] = "center",
    ) -> Lines:
        """Centre lines, or left or right bounds, of all lanes, or of those in a rectangle, decoded at once."""
    @overload
    def to_geodetic(self, points: _Point) -> tuple[float, float, float]: ...
    @overload
    def to_geodetic(self, points: _Points) -> Geodetics:
        """Latitude and longitude [deg] and altitude [m] on WGS 84."""
    @overload
    def from_geodetic(self, places: _Point) -> tuple[float, float, float]: ...
    @overload
    def from_geodetic(self, places: _Points) -> Inertials:
        """Inertial points [m] of latitude, longitude [deg] and, if given, altitude [m] on WGS 84."""
    def route(
        self,
        start: _Place,
        goal: _Place,
        *,
        via: Sequence[_Place] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
    ) -> Route | None:
        """The cheapest way in driving direction, by allowed changes of lane only; None if there is none.

        A place is (lane, s) or what nearest_lane found. `lane_change` is what a change costs: default 20 m, or 2 s by time.
        """
    def path(self, steps: Route | Iterable[RouteStep]) -> Path:
        """A route, or steps made by hand, as one line; PathError names the step that does not follow."""
    def reachable(
        self,
        start: _Place,
        limit: float,
        *,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
    ) -> Reached:
        """Pieces of lanes whose beginning can be reached within a limit [m, or s by time], nearest first."""
    def lane_sequences_ahead(
        self, start: _Place, distance: float, *, vehicle: str = "passengerCar"
    ) -> list[list[Lane]]:
        """All sequences of lanes that one can follow without a change of lane, until each is `distance` [m] long."""
    def signals_ahead(
        self, start: _Place, distance: float, *, vehicle: str = "passengerCar"
    ) -> list[SignalAhead]:
        """Signals for traffic that goes on without a change of lane, up to a distance [m]."""
    def _repr_html_(self) -> str: ...
    def _bytes(self) -> NDArray[np.uint8]: ...
    def _tables(self) -> list[tuple[int, int, int, int, int]]: ...

@final
class Lane:
    """A lane. Left, right and ahead are those of its traffic. Equal lanes are those of one content."""

    @property
    def id(self) -> int:
        """What columns name it by; bound to the map's content. What may be stored is the key."""
    @property
    def key(self) -> str:
        """Stable name, road:section:lane."""
    @property
    def number(self) -> int:
        """OpenDRIVE's number: positive left of lane 0."""
    @property
    def kind(self) -> str:
        """Lane type in the words of OpenDRIVE."""
    @property
    def road(self) -> Road:
        """Its road."""
    @property
    def section(self) -> int:
        """Number of its section in the road, from 0."""
    @property
    def s_range(self) -> tuple[float, float]:
        """Both ends of its section on the road [m]."""
    @property
    def length(self) -> float:
        """Of the centre line in plan view [m]."""
    @property
    def is_forward(self) -> bool:
        """Whether its traffic goes towards +s."""
    @property
    def is_bidirectional(self) -> bool:
        """Whether it may be travelled both ways."""
    def successors(self) -> list[Lane]:
        """Lanes entered from this one."""
    def predecessors(self) -> list[Lane]:
        """Lanes from which this one is entered."""
    def left(self) -> Lane | None:
        """The next lane to the left, whichever way it is travelled."""
    def right(self) -> Lane | None:
        """The next lane to the right, whichever way it is travelled."""
    def opposite(self) -> Lane | None:
        """The nearest lane beside it that is travelled the other way."""
    def width_at(self, s: float) -> float:
        """Width at s [m]."""
    def speed_rule_at(self, s: float) -> SpeedRule:
        """Speed limit at s, signs included, and who says so."""
    def allows_at(self, s: float, vehicle: str = "passengerCar") -> bool:
        """Whether a class of vehicles may use it at s."""
    def pose_at(self, s: float, offset: float = 0.0) -> Pose:
        """Pose at s [m] as its traffic has it, `offset` [m] to the left of its centre."""
    def position_of(self, point: _Point) -> LanePosition:
        """A point in its coordinates."""
    def center_line(self) -> NDArray[np.float64]:
        """Centre line (M, 3) in ascending s [m]."""
    def left_bound(self) -> NDArray[np.float64]:
        """Left border (M, 3) in ascending s [m]."""
    def right_bound(self) -> NDArray[np.float64]:
        """Right border (M, 3) in ascending s [m]."""
    def waypoints(self, step: float) -> Waypoints:
        """Places on the centre line in driving direction, `step` [m] of s apart."""
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

@final
class Road:
    """A road."""

    @property
    def id(self) -> str:
        """OpenDRIVE's id."""
    @property
    def name(self) -> str:
        """OpenDRIVE's name."""
    @property
    def length(self) -> float:
        """Of the reference line as written [m]."""
    @property
    def is_left_hand_traffic(self) -> bool:
        """Whether traffic keeps to the left."""
    @property
    def junction(self) -> str | None:
        """Id of the junction that it is a connecting road of."""
    def lanes(self) -> list[Lane]:
        """Lanes of all sections, by s and from left to right."""
    def elevation_at(self, s: float) -> float:
        """Elevation of the reference line at s [m]."""
    def lane_at(self, s: float, t: float) -> Lane | None:
        """The lane that covers (s, t); None beside all lanes."""
    @overload
    def to_inertial(self, tracks: _Track) -> Pose: ...
    @overload
    def to_inertial(self, tracks: _Points, *, out: Poses | None = None) -> Poses:
        """Poses of track coordinates s, t and, if given, h [m]."""
    @overload
    def to_track(self, points: _Point) -> TrackPosition: ...
    @overload
    def to_track(self, points: _Points, *, out: Tracks | None = None) -> Tracks:
        """Feet of points on the reference line."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

@final
class Signal:
    """A sign, a light, or a marking across lanes."""

    @property
    def id(self) -> str:
        """OpenDRIVE's id."""
    @property
    def name(self) -> str:
        """OpenDRIVE's name."""
    @property
    def meaning(self) -> str:
        """Its class in mapd's vocabulary (docs/ontology.md)."""
    @property
    def code(self) -> tuple[str, str, str, str]:
        """As written: country, its revision, type, subtype."""
    @property
    def text(self) -> str:
        """Text shown."""
    @property
    def value(self) -> float | None:
        """What the class means by its value: [m/s], [m] or [kg]."""
    @property
    def is_dynamic(self) -> bool:
        """Whether its state changes."""
    @property
    def position(self) -> tuple[float, float, float]:
        """Where it stands [m]."""
    @property
    def facing(self) -> float:
        """Direction of its face's normal [rad], in (-pi, pi]."""
    @property
    def size(self) -> tuple[float | None, float | None, float | None]:
        """Width, height and length [m], where given."""
    @property
    def road(self) -> Road | None:
        """The road that it is written in."""
    @property
    def track(self) -> tuple[float, float]:
        """s and t as written [m]."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

@final
class Object:
    """A pole, a barrier, a building, a parking space."""

    @property
    def id(self) -> str:
        """OpenDRIVE's id."""
    @property
    def name(self) -> str:
        """OpenDRIVE's name."""
    @property
    def meaning(self) -> str:
        """Its class in mapd's vocabulary (docs/ontology.md)."""
    @property
    def kind(self) -> str:
        """Type as written."""
    @property
    def position(self) -> tuple[float, float, float]:
        """Its origin [m]."""
    @property
    def heading(self) -> float:
        """Of its u axis [rad]."""
    @property
    def size(self) -> tuple[float, float, float]:
        """Length, width and height [m]; 0 where not given."""
    @property
    def radius(self) -> float:
        """Of a round object [m]; else 0."""
    @property
    def is_dynamic(self) -> bool:
        """Whether it moves."""
    @property
    def road(self) -> Road | None:
        """The road that it is written in."""
    @property
    def track(self) -> tuple[float, float]:
        """s and t as written [m]."""
    def footprint(self) -> NDArray[np.float64]:
        """Corners (M, 3) of what it covers [m]."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

@final
class Path:
    """A route as one line. S counts the metres driven along centre lines; left and right are the driver's."""

    @property
    def length(self) -> float:
        """The largest S [m]."""
    @property
    def is_broken(self) -> bool:
        """Whether there is a gap of more than 0.1 m or a kink of more than 0.3 rad."""
    def lanes(self) -> list[Lane]:
        """The lanes that are driven on."""
    def along_of(self, place: _Place) -> float | None:
        """S of a place on one of its lanes [m]; None for one that it does not pass."""
    @overload
    def at(self, along: float) -> PathPoint: ...
    @overload
    def at(self, along: NDArray[np.float64], *, out: PathPoints | None = None) -> PathPoints:
        """Places at S [m]; S outside is moved to the nearer end and flagged."""
    @overload
    def project(self, points: _Point, *, hint: float | None = None) -> PathPosition: ...
    @overload
    def project(
        self, points: _Points, *, hint: float | None = None, out: PathPositions | None = None
    ) -> PathPositions:
        """Points in the path's coordinates. `hint` is an S [m] near which to look first."""
    @overload
    def speed_at(self, along: float) -> SpeedRule: ...
    @overload
    def speed_at(self, along: NDArray[np.float64], *, out: SpeedRules | None = None) -> SpeedRules:
        """Speed limits at S [m]; in a junction those that come in on the path."""
    def corridor(
        self,
        step: float = 1.0,
        *,
        start: float = 0.0,
        length: float | None = None,
        vehicle: str = "passengerCar",
        out: Corridor | None = None,
    ) -> Corridor:
        """The room along the path, a station every `step` [m] from `start` [m] on, `length` [m] far."""
    def conflicts(self) -> list[PathConflict]:
        """Where other traffic meets it, in ascending S."""
