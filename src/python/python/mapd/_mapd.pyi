"""The compiled part of mapd."""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from types import TracebackType
from typing import Any, Literal, final, overload

import numpy as np
from numpy.typing import NDArray

from ._columns import (
    Approaches,
    BoundarySegments,
    Corridor,
    CorridorSurface,
    Geodetics,
    Grounds,
    Inertials,
    LaneMatches,
    LanesNear,
    MarkPoints,
    NearMarks,
    NearestLanes,
    PathPoints,
    PathPositions,
    PathSegments,
    Permissions,
    Poses,
    Reached,
    Restrictions,
    RoadMarkSegments,
    SpeedRules,
    SpeedsToday,
    Stances,
    TraceMatches,
    TrackedFixes,
    Tracks,
    Waypoints,
)
from ._results import (
    Annotation,
    Connection,
    Controller,
    Decision,
    Event,
    Ground,
    JunctionGroup,
    Landmark,
    LandmarkInView,
    LaneChangeAhead,
    LaneConflict,
    LaneGraph,
    LaneLine,
    LanePosition,
    LaneSignal,
    LineAhead,
    Lines,
    Material,
    NearMark,
    Nearest,
    ObjectLane,
    ObjectReference,
    OverlayEntry,
    OvertakingRule,
    OvertakingToday,
    PathConflict,
    PathCrossing,
    PathFact,
    PathJoint,
    PathPoint,
    PathPosition,
    PathRestriction,
    PathSpeed,
    PathSpeedToday,
    PathTime,
    Permission,
    Placement,
    Pose,
    PoseMatch,
    QuarantinedPart,
    Reach,
    Rebased,
    Report,
    Restriction,
    RightOfWay,
    RoadMark,
    Route,
    RouteEnd,
    RouteStep,
    SignalAhead,
    SignalLink,
    SpeedRule,
    SpeedStretch,
    SpeedToday,
    Stance,
    Structure,
    Surface,
    TrackPosition,
    Tracked,
    Waypoint,
)

_Point = tuple[float, float] | tuple[float, float, float]
_Points = NDArray[np.float64]
_Track = tuple[float, float] | tuple[float, float, float]
_Region = tuple[float, float, float, float]
_Types = str | Iterable[str]
_LaneRef = Lane | str | int | np.uint64
_Place = Nearest | RouteEnd | tuple[_LaneRef, float]
_By = Literal["length", "time"]

__all__ = [
    "Client",
    "Events",
    "Map",
    "Lane",
    "Road",
    "Junction",
    "Signal",
    "Object",
    "Path",
    "View",
    "Tracker",
    "LaneSequences",
    "Memory",
    "open_archive",
    "read_file",
    "outline",
    "propose",
    "NONE",
    "LANE_TYPES",
    "MARK_KINDS",
    "MARK_COLORS",
    "SPEED_ORIGINS",
    "EDGES",
    "TRACKED",
    "WORDS",
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

EDGES: list[str]
"""Words of what lies beyond an edge of a corridor, in the order of the codes in columns."""
TRACKED: list[str]
"""Words of what a tracker says, in the order of the codes in columns."""

WORDS: dict[str, dict[int, str]]
"""Words by their codes, of every vocabulary of which tables have codes and answers words, such as "class", "relation" and "edge_kind"."""

def propose(map: str, source: str, entry: str | Mapping[str, object], *, timeout: float = 1.0, prefix: str | None = None) -> Decision:
    """Proposes an entry of an overlay to the daemon that serves a map, and waits for its decision (docs/overlay.md).

    `source` is what this process calls itself: the daemon's policy names it. `entry` is JSON, or what becomes JSON, by
    schemas/overlay.schema.json; one of the same id is replaced, and so goes on to hold. A refusal raises
    `ProposalRefusedError`, with the daemon's reason.
    """

def open_archive(path: str | os.PathLike[str], key: str | os.PathLike[str] | None = None) -> Map:
    """Opens an archive in place, if it was signed with a key where one is given; what `mapd.open` calls."""

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
) -> tuple[Map | None, Report]:
    """Compiles a file, or only checks it: a map, if one was built, and a report; what `mapd.compile` and `mapd.check` call."""

def outline(left: NDArray[np.float64], right: NDArray[np.float64]) -> tuple[NDArray[np.float64], bool]:
    """The room between left and right edges (N, 2) as one polygon (M, 2) [m], and whether it is simple."""

@final
class Client:
    """A connection to one served map. Threads may share it; a forked process connects again.

    Connects in the domain of `prefix` (else of the environment variable MAPD_PREFIX) and pins the newest generation. Daemon and client may
    start in any order; `timeout` is in seconds, `math.inf` for as long as it takes. `with` closes it. The environment variable MAPD_OWNER names the
    user whose daemon is trusted, whatever the prefix.
    """

    def __new__(cls, name: str, *, timeout: float = 5.0, prefix: str | None = None) -> Client: ...
    @property
    def name(self) -> str:
        """Name of the map."""
    @property
    def closed(self) -> bool:
        """Whether it was closed."""
    def map(self) -> Map:
        """The newest generation that this client has seen. Does not look for a newer one."""
    def refresh(self) -> Map:
        """Looks for a newer generation without waiting and returns the newest."""
    def wait(self, timeout: float = 5.0) -> Map:
        """Waits [s] for a generation newer than the newest that this client has seen; NoGenerationError if none comes."""
    def wait_change(self, timeout: float = 5.0) -> bool:
        """Waits [s] for another generation or another overlay. Returns whether one has come; map() then returns it."""
    def require(self, generation: int, timeout: float = 5.0) -> Map:
        """Waits [s] for the generation of this number; SupersededError if a newer one is served already."""
    @property
    def pending(self) -> int | None:
        """The generation that is staged and waits to be activated."""
    @property
    def served_by(self) -> int | None:
        """Process id of the daemon that serves the map now; None if none does."""
    @property
    def heartbeat_age(self) -> float | None:
        """Time since the daemon's last heartbeat [s], of which it writes one about once a second; None if the map is no longer served."""
    def populate(self) -> None:
        """Maps every page of this and later generations before they are returned."""
    def events(self) -> Events:
        """Follows the map from now on."""
    def close(self) -> None:
        """Closes the connection. Maps stay readable."""
    def __enter__(self) -> Client: ...
    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> Literal[False]: ...

@final
class Events:
    """Events of a map; an iterator that waits for them."""

    def wait(self, timeout: float = 5.0) -> Event | None:
        """The next event; None if there is none within the timeout [s]."""
    def __iter__(self) -> Iterator[Event]: ...
    def __next__(self) -> Event: ...

@final
class Map:
    """One generation of a map, pinned: immutable, shared by threads, readable as long as it or anything that came from it lives."""

    @property
    def generation(self) -> int:
        """Number of the generation; 0 for a file."""
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
        """Verifies the whole archive, its content hash included; linear in its size."""
    def populate(self) -> None:
        """Maps every page of the archive into this process now."""
    def lanes(self) -> list[Lane]:
        """All lanes, lane 0 of each section left out."""
    def roads(self) -> list[Road]:
        """All roads in file order."""
    def junctions(self) -> list[Junction]:
        """All junctions."""
    def signals(self) -> list[Signal]:
        """All signals."""
    def objects(self) -> list[Object]:
        """All objects."""
    def lane(self, lane: _LaneRef) -> Lane:
        """The lane of a key such as "12:0:-1", or of an id."""
    def road(self, id: str) -> Road:
        """The road with OpenDRIVE's id."""
    def junction(self, id: str) -> Junction:
        """The junction with OpenDRIVE's id."""
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
        vehicle: str | None = None,
        hint: Nearest | None = None,
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
        vehicle: str | None = None,
        out: NearestLanes | None = None,
    ) -> NearestLanes:
        """The lane whose area is nearest in plan view, at most `radius` [m] away; of several, by heading difference, height, offset.

        `types` are the lane types that count ("drivable", or OpenDRIVE's names). `z_tolerance` [m] tells levels apart and needs points
        with z; `heading` [rad] of travel breaks ties, and excludes places by `heading_tolerance` [rad]. Of a `vehicle` ("bicycle"), only places that it may use count.
        `hint` is an answer nearby, such as the last one: the search for one point begins there, and its answer is the same. A batch needs none.
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
        vehicle: str | None = None,
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
        vehicle: str | None = None,
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
        """Poses on lanes as their traffic has them, at s [m], `offset` [m] to the left of the lane's centre. Heading and curvature are those of the line that keeps this offset."""
    def speed_rule_at(
        self, lanes: NDArray[np.uint64], s: float | NDArray[np.float64], *, out: SpeedRules | None = None
    ) -> SpeedRules:
        """Speed limits on lanes at s [m], signs included."""
    @overload
    def ground_at(self, points: _Point, *, expected: Sequence[_LaneRef] | None = None) -> Ground | None: ...
    @overload
    def ground_at(self, points: _Points, *, expected: Sequence[_LaneRef] | None = None, out: Grounds | None = None) -> Grounds:
        """The surface below points [m], on the level whose height is nearest to z; on the lowest one of points without z, with `expected` on the lowest that has one of these lanes.

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
        outline: Sequence[float] | None = None,
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
        outline: Sequence[float] | None = None,
    ) -> LaneMatches:
        """The lanes that vehicles may be in, and the probability that they are in none (docs/localisation.md).

        `heading` [rad]; `covariance` of (x, y, heading) [m^2, m rad, rad^2], one (3, 3) for all or (N, 3, 3). `drive_deviation` [rad] is
        how drivers deviate from their lane's direction, `none` the prior of no lane; `closed` and `unexpected` are the shares of the
        prior that lanes have which `vehicle` may not use, and which are not among `expected`. With `outline`, how far the vehicle reaches
        ahead, back, left and right of the point [m], a lane counts by the share of the vehicle that lies in it.
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
    def signals_in(self, region: _Region) -> list[Signal]:
        """Signals that stand in a rectangle (x_min, y_min, x_max, y_max) [m]."""
    def objects_in(self, region: _Region) -> list[Object]:
        """Objects whose area meets a rectangle (x_min, y_min, x_max, y_max) [m]; once for each of their places."""
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
    @overload
    def north_at(self, points: _Point) -> float: ...
    @overload
    def north_at(self, points: _Points) -> NDArray[np.float64]:
        """Heading of true north [rad] at a point, or at each of many, counter-clockwise from x.

        A heading that a receiver gives clockwise from true north is this minus that one.
        """
    @overload
    def to_enu(self, points: _Point, origin: _Point) -> tuple[float, float, float]: ...
    @overload
    def to_enu(self, points: _Points, origin: _Point) -> Inertials:
        """East, north and up [m] of points, from `origin`, a point of the map: the topocentric frame, in the plane that touches the Earth there."""
    @overload
    def from_enu(self, places: _Point, origin: _Point) -> tuple[float, float, float]: ...
    @overload
    def from_enu(self, places: _Points, origin: _Point) -> Inertials:
        """Inertial points [m] of easts, norths and, if given, ups [m] from `origin`, a point of the map."""
    def route(
        self,
        start: _Place,
        goal: _Place,
        *,
        via: Sequence[_Place] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Route | None:
        """The cheapest way in driving direction, by allowed changes of lane only; None if there is none.

        A place is (lane, s) or what nearest_lane found. `lane_change` is what a change costs: default 20 m, or 2 s by time. `factors`
        multiply the cost of each lane, by its row (mapd.raw.rows): infinity closes it; lanes beyond their end have the factor 1.
        """
    def find_route(
        self,
        starts: _Place | Sequence[_Place],
        goals: _Place | Sequence[_Place],
        *,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> Route | None:
        """The cheapest way from any of some starts to any of some goals, which may be `RouteEnd`; lanes to avoid are not entered.

        `turns` are what turns to the left, to the right and back at junctions cost beside the way, in its unit; other options are those of route.
        """
    def alternatives(
        self,
        starts: _Place | Sequence[_Place],
        goals: _Place | Sequence[_Place],
        *,
        count: int = 3,
        share: float = 0.3,
        longest: float = 1.5,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> list[Route]:
        """The cheapest way and alternatives to it, cheapest first: `count` at most, each on other roads for a `share` of its length, none `longest` times as expensive."""
    def reach(
        self,
        limit: float,
        *,
        starts: _Place | Sequence[_Place] | None = None,
        goals: _Place | Sequence[_Place] | None = None,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> Reach:
        """The network that can be reached from starts within a limit [m, or s by time], or from which goals can be, with the ways on."""
    def path(
        self,
        steps: Route | Iterable[RouteStep],
        *,
        change_length: float | None = None,
        shortest_change: float | None = None,
        change_delay: float = 0.0,
        vehicle: str = "passengerCar",
        broken_gap: float = 0.1,
        broken_kink: float = 0.3,
    ) -> Path:
        """A route, or steps made by hand, as one line; PathError names the step that does not follow.

        `change_length` [m] makes each change of lane a smooth curve of that length, over lanes that follow as far as the `vehicle` may change there; without room the line
        jumps. With `shortest_change` [m], less room makes it shorter, and what has even less is a broken joint. `change_delay` [m] is how far behind the first place where it
        can be it begins, as far as there is room: `math.inf` for as late as can be. Joints with a larger gap than `broken_gap` [m] or kink than `broken_kink` [rad] are broken.
        """
    @property
    def overlay_revision(self) -> int:
        """Revision of what is laid over it, which rises with each change; 0 where nothing is."""
    def view(self, at: float | datetime | None = None) -> View:
        """The map under what is laid over it, at a moment: seconds since 1970 in UTC [s], a datetime, or now."""
    def with_overlay(self, overlay: bytes) -> Map:
        """The same map under an overlay that mapd encoded for it. What a client attaches to is under the daemon's without this."""
    def approaches(self, conflict: PathConflict, distance: float, *, vehicle: str = "passengerCar") -> Approaches:
        """The lanes on which traffic comes to a conflict of a path, back to a distance [m], nearest first; the other lane itself comes first.

        `vehicle` is the class of who comes, not of who drives the path: lanes that are closed to it bring none, the other lane neither.
        """
    def landmarks_near(
        self, point: tuple[float, float], radius: float, *, classes: Sequence[str] | None = None
    ) -> list[Landmark]:
        """Signals and objects that localisers find again, or those of these `classes` ("pole"), within a radius [m], nearest first."""
    def landmarks_in_view(
        self,
        point: tuple[float, float],
        heading: float,
        range: float,
        field_of_view: float,
        *,
        classes: Sequence[str] | None = None,
    ) -> list[LandmarkInView]:
        """What a sensor at a point that looks along `heading` [rad] sees of them: up to `range` [m], half of `field_of_view` [rad] to either side, nearest first.

        Signals are seen from the front only, and nothing hides anything.
        """
    def mark_points(
        self,
        region: _Region,
        spacing: float,
        *,
        kinds: Sequence[str] | None = None,
        types: _Types | None = None,
        objects: bool = True,
    ) -> MarkPoints:
        """Painted places of road marks and, with `objects`, of painted objects in a rectangle, at every multiple of `spacing` [m] along each; gaps have none."""
    @overload
    def stance(
        self, points: _Point, heading: float, wheels: NDArray[np.float64], *, expected: Sequence[_LaneRef] | None = None
    ) -> Stance | None: ...
    @overload
    def stance(
        self,
        points: _Points,
        heading: float | NDArray[np.float64],
        wheels: NDArray[np.float64],
        *,
        expected: Sequence[_LaneRef] | None = None,
        out: Stances | None = None,
    ) -> Stances:
        """How vehicles stand on the ground below their wheels: places (4, 2) ahead of and to the left of the reference point [m]. `heading` [rad]; z [m] tells levels apart, or `expected` lanes.

        Nothing with ground below fewer than three wheels.
        """
    def reachable(
        self,
        start: _Place,
        limit: float,
        *,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Reached:
        """Pieces of lanes whose beginning can be reached within a limit [m, or s by time], nearest first."""
    def reachable_to(
        self,
        goal: _Place,
        limit: float,
        *,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Reached:
        """Pieces of lanes from whose beginning a place can be reached within a limit [m, or s by time], nearest first."""
    def lane_sequences_ahead(
        self, start: _Place, distance: float, *, vehicle: str = "passengerCar"
    ) -> LaneSequences:
        """All sequences of lanes that one can follow without a change of lane, until each is `distance` [m] long or ends."""
    def next_junction(self, start: _Place, distance: float, *, vehicle: str = "passengerCar") -> tuple[Junction, float] | None:
        """The next junction ahead of a place and the distance to it [m]; 0 on a connecting road, None if there is none within `distance` [m].

        Follows the lanes as long as there is but one way on, or all ways lead into one junction.
        """
    def signals_ahead(
        self, start: _Place, distance: float, *, vehicle: str = "passengerCar"
    ) -> list[SignalAhead]:
        """Signals for traffic that goes on without a change of lane, up to a distance [m]."""
    def landmarks_in(self, region: _Region, *, classes: Sequence[str] | None = None) -> list[Landmark]:
        """As landmarks_near, of those in a rectangle (x_min, y_min, x_max, y_max) [m]: signals first, then objects, and no distance."""
    def boundary_segments(self, region: _Region, *, types: _Types | None = None) -> BoundarySegments:
        """Pieces of the borders of lanes in a rectangle (x_min, y_min, x_max, y_max) [m], by their lanes."""
    def road_mark_segments(self, region: _Region, *, types: _Types | None = None) -> RoadMarkSegments:
        """As boundary_segments, where they carry road marks: cut where one mark ends and another begins."""
    def placements_near(self, point: tuple[float, float], radius: float) -> list[tuple[Placement, float]]:
        """As objects_near, with the place of each instead of the object."""
    def placements_in(self, region: _Region) -> list[Placement]:
        """As objects_in, with the place of each instead of the object."""
    def lane_graph(self) -> LaneGraph:
        """The graph that routes are searched on: lanes, or pieces of them, travelled in one direction, and how one goes on from each."""
    def controllers(self) -> list[Controller]:
        """All controllers of signals, in file order."""
    def junction_groups(self) -> list[JunctionGroup]:
        """All groups of junctions, such as roundabouts, in file order."""
    def structures(self) -> list[Structure]:
        """All bridges and tunnels, by road."""
    def object_references(self) -> list[ObjectReference]:
        """All references of roads to objects of other roads, by the road that refers."""
    def quarantined(self) -> list[QuarantinedPart]:
        """Parts of the file that are not in the map as written, in file order; none where it was accepted whole."""
    def left_out(self, kind: str, id: str) -> QuarantinedPart | None:
        """Why the map has no part of this kind ("road", "junction", "object", "signal", ...) and id; None where the file has no such part either."""
    def annotations(self) -> list[Annotation]:
        """What the file says besides, such as user data: the document's first, then those of roads, lanes, junctions and so on."""
    @property
    def geodetic_bounds(self) -> tuple[float, float, float, float] | None:
        """South, north, west and east [deg] as the file's header writes them; None where it does not."""
    def steps_of_lanes(self, lanes: Sequence[_LaneRef], s_from: float, s_to: float) -> tuple[RouteStep, ...]:
        """The steps over lanes that follow each other, such as those of a sequence, from s on the first to s on the last [m], each moved to its lane's nearer end.

        Each lane is driven in its own direction; one for both directions in the one that links ask for, and alone in the one from s to s. PathError names the
        lane that does not follow.
        """
    def lines_along(self, steps: Route | Iterable[RouteStep]) -> list[LineAhead]:
        """Lines to stop or give way at, crosswalks and bicycle crossings along a route, nearest first; one over several lanes stands once for each that is driven on."""
    def signals_along(self, steps: Route | Iterable[RouteStep]) -> list[SignalAhead]:
        """Signals for traffic along a route, nearest first."""
    def next_lane_change(self, steps: Route | Iterable[RouteStep], at: int, place: _Place) -> LaneChangeAhead | None:
        """The next change of lane on a route, seen from a place on its step number `at`; None if it needs no more."""
    def lane_sequences_behind(self, goal: _Place, distance: float, *, vehicle: str = "passengerCar") -> LaneSequences:
        """As lane_sequences_ahead, of ways that lead to a place: each sequence begins with its lane and goes back against driving direction."""
    def nearest_lane_geodetic(
        self,
        place: _Point,
        *,
        radius: float = 10.0,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        heading: float | None = None,
        heading_tolerance: float | None = None,
        vehicle: str | None = None,
    ) -> Nearest | None:
        """As nearest_lane, from latitude, longitude [deg] and, if given, altitude [m] on WGS 84."""
    def _repr_html_(self) -> str: ...
    def _bytes(self) -> NDArray[np.uint8]: ...
    def _tables(self) -> list[tuple[int, int, int, int, int]]: ...
    def __copy__(self) -> Map: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Map: ...

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
    def speed_rules(self) -> list[SpeedStretch]:
        """The speed limits along it, in ascending s without gaps."""
    def overtaking_rule_at(self, s: float) -> OvertakingRule:
        """The signs that forbid overtaking at s [m]."""
    def allows_at(self, s: float, vehicle: str = "passengerCar") -> bool:
        """Whether a class of vehicles may use it at s."""
    @property
    def turn(self) -> Literal["left", "straight", "right", "back"]:
        """Where the movement through this lane of a junction leads: "left", "straight", "right" or "back"."""
    def entries(self) -> list[Lane]:
        """Lanes from which the junction is entered on the way through this one."""
    def movement_lanes(self) -> list[Lane]:
        """Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction."""
    def right_of_way(self, country: str | None = None) -> list[RightOfWay]:
        """Who goes first where this lane of a junction meets others, by what the file says; where that says nothing, by the rules of a `country` ("DE"), if it is named.

        That these hold there is for the caller to know.
        """
    def yields_to(self) -> list[Lane]:
        """Lanes to which this lane of a junction gives way by what the file says; such as are closed to every vehicle are left out."""
    def traffic_lights(self) -> list[Signal]:
        """Lights for the traffic of this lane."""
    def movement_lights(self) -> list[Signal]:
        """Lights that govern the movement through this lane of a junction."""
    def movement_stop(self) -> LaneLine | None:
        """Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before it.

        Without one at its light; under a stop or yield sign without marking at the last place before the movement meets another lane, or where it
        enters the junction. None where none of these is known.
        """
    def movement_crossings(self) -> list[LaneLine]:
        """Crosswalks and bicycle crossings that the movement through this lane passes: up to 30 m before it, on its own lanes, and up to 30 m behind it."""
    def lines_to_stop_at(self) -> list[LaneLine]:
        """Lines at which the lane's traffic stops or gives way: signals first, then objects."""
    def crossings(self) -> list[LaneLine]:
        """Crosswalks and bicycle crossings over the lane: signals first, then objects."""
    def edges_at(self, s: float) -> tuple[float, float]:
        """t [m] of the inner and of the outer edge at s [m], on its road."""
    def bounds_at(self, s: float) -> tuple[tuple[float, float, float], tuple[float, float, float]] | None:
        """Left and right edge at s [m] as its traffic has them; None where it has no area."""
    def height_at(self, s: float) -> tuple[float, float]:
        """How far the inner and the outer edge lie above the road [m] at s [m], as `<height>` writes it."""
    def length_between(self, s_from: float, s_to: float) -> float:
        """Length of the centre line between two places [m] in plan view."""
    def material_at(self, s: float) -> Material | None:
        """The surface at s [m] as `<material>` writes it; None where nothing is written."""
    def road_marks(self) -> list[RoadMark]:
        """Marks on its outer border, or on the centre line for lane 0, by s."""
    def road_mark_at(self, s: float) -> RoadMark | None:
        """The mark on its outer border at s [m]."""
    def objects(self) -> list[Object]:
        """Objects that are on the lane or belong to it."""
    def pose_at(self, s: float, offset: float = 0.0) -> Pose:
        """Pose at s [m] as its traffic has it, `offset` [m] to the left of its centre. Heading and curvature are those of the line that keeps this offset."""
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
    def waypoint_at(self, s: float) -> Waypoint:
        """The centre line's exact place at s [m], with its own direction; s outside the lane's section is moved to its nearer end and flagged."""
    def pose_of_reference_line(self, s: float, offset: float = 0.0) -> Pose:
        """As pose_at, in the road's frame: heading and curvature of the reference line, ahead towards +s, `offset` [m] to the left of that."""
    def recorded_speed_limit_at(self, s: float) -> float | None:
        """The limit [m/s] that lane or road record at s [m]; infinite where there is none, None where nothing is recorded. What holds may be another: speed_rule_at."""
    def time_between(self, s_from: float, s_to: float) -> float:
        """What a route by time counts from one place to another [m]: at recorded limits, at 50 km/h where there is none [s]."""
    def conflicts(self) -> list[LaneConflict]:
        """Where its area meets those of other lanes of its junction."""
    def node_at(self, s: float, forward: bool | None = None) -> int | None:
        """The row among the nodes of Map.lane_graph that holds s [m], towards +s or not; of the lane's own direction where that is not said. None where it is not travelled so."""
    def objects_on(self) -> list[ObjectLane]:
        """As objects, with where each is on the lane."""
    def movement_lights_on(self) -> list[LaneSignal]:
        """As movement_lights, with the lane before the junction on which each counts."""
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Lane: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Lane: ...

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
    def lanes(self, *, center: bool = False) -> list[Lane]:
        """Lanes of all sections, by s and from left to right; with `center` also lane 0 of each, which has no area."""
    def elevation_at(self, s: float) -> float:
        """Elevation of the reference line at s [m]."""
    def superelevation_at(self, s: float) -> float:
        """Superelevation at s [rad]; positive lifts the left side."""
    def lane_offset_at(self, s: float) -> float:
        """Lane offset at s [m]; positive to the left."""
    def surface_at(self, s: float, t: float) -> Surface:
        """The surface at (s, t) [m]; s beyond the reference line is moved to its end and flagged. Beside all lanes the lateral profiles go on."""
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
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Road: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Road: ...

@final
class Junction:
    """A junction: roads, and which lanes lead from one to another."""

    @property
    def id(self) -> str:
        """OpenDRIVE's id."""
    @property
    def name(self) -> str:
        """OpenDRIVE's name."""
    def connections(self) -> list[Connection]:
        """Connections in file order."""
    def controllers(self) -> list[str]:
        """Ids of the controllers of its lights."""
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Junction: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Junction: ...

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
    def links(self) -> list[SignalLink]:
        """Objects and signals that belong to it, such as the pole that it hangs from."""
    def dependencies(self) -> list[SignalLink]:
        """Signals that it controls or depends on."""
    def movements(self) -> list[Lane]:
        """Lanes of junctions whose movements it governs, where it is a light."""
    def controllers(self) -> list[Controller]:
        """Its controllers."""
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Signal: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Signal: ...

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
    def placements(self) -> list[Placement]:
        """Where it stands: itself, or each of its copies."""
    def lanes(self) -> list[ObjectLane]:
        """Lanes that it is on or belongs to."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Object: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Object: ...

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
    def conflicts(self, country: str | None = None) -> list[PathConflict]:
        """Where other traffic meets it, in ascending S. Who yields is what the file says; where that says nothing, what the rules of a `country` say ("DE"), if it is named."""
    def corridor_surface(
        self, step: float = 1.0, *, start: float = 0.0, length: float | None = None, out: CorridorSurface | None = None
    ) -> CorridorSurface:
        """The road's surface at the stations that corridor has for the same numbers [m]."""
    def facts(self) -> list[PathFact]:
        """What it comes by, in ascending S: junctions, signals, lines, types of roads and lanes, countries, access, bridges, tunnels, holes."""
    def speeds(self) -> list[PathSpeed]:
        """The speed limits along it, in ascending S without gaps."""
    def travel_time(self, start: float = 0.0, end: float | None = None) -> PathTime:
        """How long a vehicle takes from one S to another [m] at the speed limits."""
    def segments(self, *, vehicle: str = "passengerCar") -> PathSegments:
        """From which lanes its goal is reached along the same roads, and until where a change of lane may wait."""
    def crossings(self) -> list[PathCrossing]:
        """Crosswalks and bicycle crossings over it, in ascending S."""
    def joints(self) -> list[PathJoint]:
        """Gaps, overlaps and kinks, and changes of lane, in ascending S."""
    def steps_between(self, start: float, end: float) -> tuple[RouteStep, ...]:
        """The part of its steps from one S to another [m], for a path over that part."""
    def rebase(
        self,
        map: Map,
        *,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Rebased:
        """Its way on another map, such as the next version of its own, and what has changed."""
    def _repr_html_(self) -> str: ...
    def __copy__(self) -> Path: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Path: ...

@final
class View:
    """A map under what is laid over it, at a moment: what is closed, slower or told of. Without an overlay it is the map."""

    @property
    def at(self) -> float:
        """The moment: seconds since 1970 in UTC [s]."""
    @property
    def map(self) -> Map:
        """The map below."""
    def entries(self) -> list[OverlayEntry]:
        """Everything that the overlay says, whether it holds now or not; entry k has the number k."""
    def restrictions(self) -> Restrictions:
        """What holds now, wherever it does."""
    def restrictions_at(self, place: _Place) -> list[Restriction]:
        """Entries that hold now at a place, in the lane's own direction."""
    def restrictions_along(
        self, steps: Route | Iterable[RouteStep], *, vehicle: str = "passengerCar"
    ) -> list[Restriction]:
        """What holds now along a route."""
    def restrictions_on_path(self, path: Path, *, vehicle: str = "passengerCar") -> list[PathRestriction]:
        """What holds now along a path, in ascending S."""
    @overload
    def allows(self, place: _Place, s: None = None, *, vehicle: str = "passengerCar") -> Permission: ...
    @overload
    def allows(
        self,
        place: NDArray[np.uint64],
        s: float | NDArray[np.float64],
        *,
        vehicle: str = "passengerCar",
        out: Permissions | None = None,
    ) -> Permissions:
        """Whether a class of vehicles may use a lane at a place, or many lanes, by their ids, each at its s [m]."""
    @overload
    def speed_rule_at(self, place: _Place, s: None = None, *, vehicle: str = "passengerCar") -> SpeedToday: ...
    @overload
    def speed_rule_at(
        self,
        place: NDArray[np.uint64],
        s: float | NDArray[np.float64],
        *,
        vehicle: str = "passengerCar",
        out: SpeedsToday | None = None,
    ) -> SpeedsToday:
        """The speed limit at a place, or of many lanes, by their ids, each at its s [m]: the lowest that an entry states, else the map's."""
    def overtaking_rule_at(self, place: _Place, *, vehicle: str = "passengerCar") -> OvertakingToday:
        """Whether a class of vehicles may overtake at a place: what signs forbid, and entries. What road marks forbid is with the lane graph's lane changes."""
    @overload
    def speed_on_path(self, path: Path, along: float, *, vehicle: str = "passengerCar") -> SpeedToday: ...
    @overload
    def speed_on_path(
        self, path: Path, along: NDArray[np.float64], *, vehicle: str = "passengerCar", out: SpeedsToday | None = None
    ) -> SpeedsToday:
        """The speed limit at S of a path [m]."""
    def speeds_on_path(self, path: Path, *, vehicle: str = "passengerCar") -> list[PathSpeedToday]:
        """The speed limits along a path, in ascending S without gaps."""
    def travel_time_on_path(
        self, path: Path, start: float = 0.0, end: float | None = None, *, vehicle: str = "passengerCar"
    ) -> PathTime:
        """How long a vehicle takes from one S of a path to another [m] at these limits. What is closed takes as long as if it were open."""
    def segments_on_path(self, path: Path, *, vehicle: str = "passengerCar") -> PathSegments:
        """From which lanes a path's goal is reached, none of them through what is closed now, and until where a change of lane may wait."""
    def conflicts(self, path: Path, country: str | None = None) -> list[PathConflict]:
        """As Path.conflicts, with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then the rules of a `country`."""
    def crossings(self, path: Path) -> list[PathCrossing]:
        """As Path.crossings, with lights that are out of service now left out."""
    def facts(self, path: Path) -> list[PathFact]:
        """As Path.facts, with today's permissions; a light that is out of service now governs nothing."""
    def signal_out_of_service(self, signal: Signal) -> OverlayEntry | None:
        """The entry by which a signal is out of service now."""
    def route(
        self,
        start: _Place,
        goal: _Place,
        *,
        via: Sequence[_Place] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Route | None:
        """As Map.route, with the overlay's current entries applied."""
    def find_route(
        self,
        starts: _Place | Sequence[_Place],
        goals: _Place | Sequence[_Place],
        *,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> Route | None:
        """The cheapest way from any of some starts to any of some goals, which may be `RouteEnd`; lanes to avoid are not entered.

        `turns` are what turns to the left, to the right and back at junctions cost beside the way, in its unit; other options are those of route.
        """
    def alternatives(
        self,
        starts: _Place | Sequence[_Place],
        goals: _Place | Sequence[_Place],
        *,
        count: int = 3,
        share: float = 0.3,
        longest: float = 1.5,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> list[Route]:
        """The cheapest way and alternatives to it, cheapest first: `count` at most, each on other roads for a `share` of its length, none `longest` times as expensive."""
    def reach(
        self,
        limit: float,
        *,
        starts: _Place | Sequence[_Place] | None = None,
        goals: _Place | Sequence[_Place] | None = None,
        avoid: Sequence[_LaneRef] | None = None,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
        turns: Sequence[float] = ...,
    ) -> Reach:
        """The network that can be reached from starts within a limit [m, or s by time], or from which goals can be, with the ways on."""
    def reachable(
        self,
        start: _Place,
        limit: float,
        *,
        vehicle: str = "passengerCar",
        by: _By = "length",
        lane_change: float | None = None,
        factors: NDArray[np.float64] | None = None,
    ) -> Reached:
        """As Map.reachable, with the overlay's current entries applied [m, or s by time]."""
    def corridor(
        self,
        path: Path,
        step: float = 1.0,
        *,
        start: float = 0.0,
        length: float | None = None,
        vehicle: str = "passengerCar",
        out: Corridor | None = None,
    ) -> Corridor:
        """As Path.corridor [m], under the overlay's current entries, beside the path too; speeds are today's."""
    def signals_ahead(self, start: _Place, distance: float, *, vehicle: str = "passengerCar") -> list[SignalAhead]:
        """As Map.signals_ahead [m]: ways through closed lanes are not followed."""
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
        outline: Sequence[float] | None = None,
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
        outline: Sequence[float] | None = None,
    ) -> LaneMatches:
        """As Map.match_pose: a lane that is closed to the vehicle now has the prior of closed ones."""
    def __copy__(self) -> View: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> View: ...

@final
class LaneSequences:
    """All sequences of lanes ahead of a place, or behind it, without changes of lane. Iterate over it to get one by one, each a list of lanes; their number doubles with each fork."""

    def __iter__(self) -> LaneSequences: ...
    def __next__(self) -> list[Lane]: ...
    @property
    def network(self) -> Reach:
        """What all of them lead over, each piece of a lane once, nearest first; its size grows with the map ahead, not with the number of sequences."""

@final
class Tracker:
    """The lane of a vehicle that drives, from fix to fix (docs/localisation.md). Threads that share it wait for each other.

    `change_interval` [s] is the mean time between changes of lane, `correlation_time` [s] that over which errors of fixes are alike, `memory` [s] the time without a fix after
    which it begins anew, `enough` the probability from which a lane, or none, is the answer. Other options are those of Map.match_pose; `types` are those that motor vehicles
    travel on.
    """

    def __new__(
        cls,
        *,
        types: _Types | None = None,
        z_tolerance: float | None = None,
        drive_deviation: float = 0.1,
        none: float = 0.01,
        vehicle: str | None = None,
        closed: float = 0.05,
        unexpected: float = 0.05,
        change_interval: float = 30.0,
        correlation_time: float = 0.0,
        memory: float = 30.0,
        enough: float = 0.5,
        outline: Sequence[float] | None = None,
    ) -> Tracker: ...
    @overload
    def update(
        self,
        map: Map,
        time: float,
        points: _Point,
        heading: float,
        covariance: NDArray[np.float64],
        *,
        odometer: float | None = None,
        expected: Sequence[_LaneRef] | None = None,
    ) -> Tracked: ...
    @overload
    def update(
        self,
        map: Map,
        time: NDArray[np.float64],
        points: _Points,
        heading: float | NDArray[np.float64],
        covariance: NDArray[np.float64],
        *,
        odometer: NDArray[np.float64] | None = None,
        expected: Sequence[_LaneRef] | None = None,
        out: TrackedFixes | None = None,
    ) -> TrackedFixes:
        """Takes the next fix, or many in their order: time [s] that does not fall, heading [rad], covariance as of Map.match_pose.

        `odometer` is the way driven since any beginning [m], NaN where it is not known.
        """
    def hypotheses(self) -> PoseMatch:
        """The lanes that the vehicle may be in, the most probable first, and the probability that it is in none."""
    def probability_in(self, lanes: Sequence[_LaneRef]) -> float:
        """Probability that the vehicle is in one of these lanes, such as those of its route."""
    def reset(self) -> None:
        """Forgets everything."""

@final
class Memory:
    """What `out` keeps for the next call that fills it."""
