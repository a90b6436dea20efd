"""Single answers. Lengths are metres, angles radians, times seconds, speeds metres per second, coordinates inertial."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import geopandas

    from ._columns import LaneEdges, LaneNodes, Reached, ReachLinks
    from ._mapd import Junction, Lane, Map, Object, Road, Signal


class Nearest(NamedTuple):
    """The nearest lane and the point in its coordinates."""

    lane: Lane
    """The lane."""
    s: float
    """Along the road's reference line [m]."""
    t: float
    """Lateral on the road [m], positive to the left of the reference line."""
    offset: float
    """From the lane's centre [m], positive to the left as its traffic goes."""
    distance: float
    """In plan view from the lane's area [m]; 0 inside."""
    z: float
    """Height of the plane h = 0 at (s, t) [m]."""
    heading: float
    """The way the lane's traffic goes at s and this offset [rad], in (-pi, pi]: the heading of `pose_at`."""
    clamped: int = 0
    """-1 or 1 where the point lies before or after the lane's section in the direction of s, which has no foot for it; else 0."""
    offset_of_reference_line: float = math.nan
    """From the lane's centre [m], positive to the left of the reference line."""
    heading_of_reference_line: float = math.nan
    """Of the reference line at s [rad], in (-pi, pi]."""


class LanePosition(NamedTuple):
    """A point in a lane's coordinates; as :class:`Nearest`."""

    s: float
    t: float
    offset: float
    distance: float
    z: float
    heading: float
    clamped: int
    """-1 or 1 where the point lies before or after the lane's section in the direction of s, which has no foot for it; else 0."""
    offset_of_reference_line: float = math.nan
    heading_of_reference_line: float = math.nan


class Pose(NamedTuple):
    """A place with the frame there."""

    x: float
    y: float
    z: float
    heading: float
    """[rad], counter-clockwise from x, in (-pi, pi]: of a road that of its reference line, of a lane its own."""
    curvature: float
    """Of the line that runs this way [1/m], positive to the left."""
    slope: float
    """Metres upwards per metre of s ahead."""
    superelevation: float
    """[rad], positive lifts the left side."""
    clamped: int
    """-1 or 1 where s lay before or after the line and was moved to its nearer end; else 0."""


class TrackPosition(NamedTuple):
    """Foot of a point on a road's reference line."""

    s: float
    """[m]"""
    t: float
    """[m], positive to the left."""
    h: float | None
    """Upwards [m]; only where the point had a z."""
    distance: float
    """In plan view from the reference line [m]."""
    clamped: int
    """-1 or 1 where the point lies before or after the road; else 0."""
    exact: bool
    """Whether (s, t, h) is the point: not beyond an end, nor in the wedge beside a kink."""


class Ground(NamedTuple):
    """The ground at a place."""

    z: float
    """Height of the surface [m]."""
    nx: float
    ny: float
    nz: float
    """The surface's unit normal is (nx, ny, nz)."""
    s: float
    """Along the lane's road [m]."""
    t: float
    """Lateral on its road [m]."""
    lane: Lane
    level: int
    """Which level this is, the lowest one 0."""
    levels: int
    """How many levels of lanes there are at the place."""


class Material(NamedTuple):
    """What `<material>` says of a lane's surface."""

    s: float
    """Where it begins [m]."""
    surface: str
    friction: float | None
    roughness: float | None


class Surface(NamedTuple):
    """The surface at a place of a road."""

    x: float
    y: float
    z: float
    """Its place is (x, y, z) [m]."""
    nx: float
    ny: float
    nz: float
    """The surface's unit normal is (nx, ny, nz)."""
    lane: Lane | None
    """The lane that covers it; None beside all lanes."""
    material: Material | None
    clamped: int
    """-1 or 1 where s lay before or after the road and was moved to its nearer end; else 0."""


class RoadMark(NamedTuple):
    """A road mark of a lane."""

    s: float
    """Where it begins [m]."""
    s_end: float
    """Where it ends [m]."""
    kind: str
    """As OpenDRIVE names it."""
    color: str
    width: float
    """[m]; that of its kind where none is written."""


class RightOfWay(NamedTuple):
    """Who goes first where a lane of a junction meets another."""

    other: Lane | None
    relation: str
    """What this lane's traffic does: "yields", "priority", ... (docs/signals.md)."""
    reason: str
    """What says so; where nothing is written, which rule of the road would have to."""
    basis: Literal["written", "rule", "unknown"]
    """Whether the file says so, or the rules of the country that is named."""


class Connection(NamedTuple):
    """A connection of a junction."""

    id: str
    incoming_road: Road | None
    connecting_road: Road | None
    contact_point: str
    """Which end of the connecting road the incoming one meets, "start" or "end"."""
    lane_links: list[tuple[int, int]]
    """Numbers of lanes: of the incoming road, of the connecting road."""


class NearMark(NamedTuple):
    """The place of a road mark that is nearest to a point."""

    lane: Lane
    """The lane on whose outer border the mark lies; lane 0 for marks of the centre."""
    s: float
    """On the road [m]."""
    x: float
    y: float
    """The nearest place of the middle of the mark's line [m]."""
    distance: float
    """In plan view [m]."""
    width: float
    """Of the line [m]."""
    side: Literal["left", "right"]
    """The side of the point on which the mark is, looking along the road's reference line."""
    kind: str
    color: str
    painted: bool | None
    """Whether there is paint or a gap at this s; None where the file does not say."""


class LaneMatch(NamedTuple):
    """A lane that a vehicle may be in, in one of its directions."""

    lane: Lane
    forward: bool
    """Whether the vehicle travels towards +s."""
    probability: float
    """Among all hypotheses."""
    mahalanobis: float
    """Distance of the pose from the lane's centre line and direction, by the covariance of the model."""
    heading_difference: float
    """The given heading less the driving direction at the pose's s and offset [rad], in (-pi, pi]."""
    s: float
    t: float
    offset: float
    distance: float
    z: float
    heading: float
    clamped: int = 0
    offset_of_reference_line: float = math.nan
    heading_of_reference_line: float = math.nan
    """The place with respect to the lane is as of :class:`Nearest`."""


class PoseMatch(NamedTuple):
    """The lanes that a vehicle may be in, the most probable first."""

    none: float
    """Probability that it is in none."""
    lanes: tuple[LaneMatch, ...]


class SpeedRule(NamedTuple):
    """The speed limit at a place."""

    max: float | None
    """[m/s]; infinite where there is none, None where the map says nothing."""
    origin: Literal["written", "sign", "entry", "default", "depends", "unknown"]
    """The source of the limit."""
    signal: Signal | None
    """The sign, if a sign states the limit."""


class OvertakingRule(NamedTuple):
    """Which signs forbid overtaking at a place. A sign holds from its place on, in driving direction, until another one ends it, and not beyond a junction."""

    all: Signal | None
    """The sign that forbids it to all motor vehicles."""
    trucks: Signal | None
    """The sign that forbids it to trucks."""


class RouteStep(NamedTuple):
    """A lane of a route."""

    lane: Lane
    forward: bool
    """Whether it is travelled towards +s."""
    enter: Literal["start", "ahead", "left", "right"]
    """How it is entered: the route starts on it, from behind, or by a change of lane."""
    s_from: float
    """s at which it is entered [m]; of a change, the first place where it may happen."""
    s_to: float
    """s at which it is left [m]."""
    s_latest: float
    """Of a change, the last place where it may happen [m]."""


@dataclass(frozen=True)
class Route:
    """A way from one place to another."""

    cost: float
    """What was kept small: [m] by length, [s] by time, lane changes included."""
    length: float
    """Along centre lines [m]."""
    travel_time: float
    """What the graph counts as time [s]: at recorded limits, at assumed speeds where there is none. Path.travel_time has the time at the limits that hold."""
    assumed_time: float
    """What of it is at assumed speeds [s]."""
    lane_changes: int
    steps: tuple[RouteStep, ...]
    start: int = 0
    """Of several starts, the number of the one from which it leads."""
    goal: int = 0
    """Of several goals, the number of the one to which it leads."""

    def __repr__(self) -> str:
        return f"<mapd.Route {self.length:.1f} m, {self.travel_time:.1f} s, {self.lane_changes} lane changes, {len(self.steps)} lanes>"

    def _repr_html_(self) -> str:
        from ._pictures import route_html

        return route_html(self)


class Waypoint(NamedTuple):
    """A place on a lane's centre line."""

    s: float
    """On the road [m]."""
    x: float
    y: float
    z: float
    heading: float
    """Of the centre line in driving direction [rad], in (-pi, pi]."""
    width: float
    """Of the lane [m]."""
    clamped: int
    """-1 or 1 where s lay before or after the lane's section and was moved to its nearer end; else 0."""


class LaneConflict(NamedTuple):
    """A place where the area of another lane of the same junction meets a lane's."""

    other: Lane | None
    kind: str
    relation: str
    """Who goes first; as of :class:`RightOfWay`."""
    reason: str
    basis: Literal["written", "unknown"]
    """Whether the file says so."""
    s_from: float
    s_to: float
    """The common place on the lane's road [m], the smaller s first."""
    other_from: float
    other_to: float
    """The common place on the other lane's road [m]."""


class LaneGraph(NamedTuple):
    """The lane graph."""

    nodes: LaneNodes
    edges: LaneEdges


class LaneSignal(NamedTuple):
    """A signal on a lane on which it counts."""

    signal: Signal
    lane: Lane
    s: float
    """On the lane's road [m], within its section."""
    distance: float
    """Of the signal from the lane's area [m]."""


class ObjectLane(NamedTuple):
    """An object on a lane that it is on or belongs to."""

    object: Object
    lane: Lane
    s_from: float
    s_to: float
    """Where it is on the lane's road [m]."""
    distance: float
    """From the lane's area [m]; 0 on it."""


class Placement(NamedTuple):
    """A place of an object."""

    object: Object
    copy: int | None
    """Which of the object's copies; None for the object itself."""
    x: float
    y: float
    z: float
    """Its origin [m]."""
    heading: float
    pitch: float
    roll: float
    """[rad], inertial."""
    length: float
    width: float
    height: float
    radius: float
    """[m]; 0 where not given."""
    footprint: NDArray[np.float64]
    """Corners (M, 3) of what it covers [m]."""


class SignalLink(NamedTuple):
    """A signal or object that a signal names."""

    id: str
    """As written."""
    kind: str
    """Its type as written."""
    is_object: bool
    signal: Signal | None
    object: Object | None
    """What it is, where the map has it."""


class Controller(NamedTuple):
    """A controller of signals."""

    number: int
    """Its place among the map's controllers, from 0."""
    id: str
    name: str
    sequence: int | None
    signals: tuple[Signal, ...]
    junctions: tuple[Junction, ...]


class JunctionGroup(NamedTuple):
    """Junctions that belong together, such as those of a roundabout."""

    id: str
    name: str
    kind: str
    junctions: tuple[Junction, ...]
    """Those that the map has."""
    ring: tuple[Lane, ...]
    """Of a roundabout the lanes around it."""


class Structure(NamedTuple):
    """A bridge or tunnel."""

    kind: str
    id: str
    name: str
    type: str
    """As written."""
    road: Road | None
    s_from: float
    s_to: float
    """On its road [m]."""


class ObjectReference(NamedTuple):
    """What a road says of an object of another road."""

    id: str
    """The object's, as written."""
    object: Object | None
    road: Road | None
    """The road that refers to it."""
    s: float
    t: float
    """On that road [m]."""
    z_offset: float
    """Above its reference line [m]."""
    valid_length: float
    """[m]"""
    orientation: str


class Annotation(NamedTuple):
    """Something that the file says besides, such as user data."""

    kind: str
    owner_kind: str
    """What it belongs to."""
    owner: Road | Lane | Junction | Object | Signal | None
    """None for the document, and for parts that have no class here."""
    path: str
    """Where it stands below the owner; empty for the owner itself."""
    name: str
    value: str
    text: str
    file: str
    """The included file that it stands in; empty for the document itself."""
    line: int
    column: int


class LineAhead(NamedTuple):
    """A line that a route passes."""

    line: LaneLine
    distance: float
    """Along centre lines from the route's start [m]."""


class LaneChangeAhead(NamedTuple):
    """The next change of lane on a route."""

    step: int
    """Number of the step that is entered by it."""
    side: Literal["left", "right"]
    start: float
    end: float
    """Distance to the first and the last place where it may happen [m]."""


class PathPoint(NamedTuple):
    """A position on a path, as seen by a vehicle that drives along it."""

    along: float
    """S: the sum of the lengths driven along centre lines [m]."""
    x: float
    y: float
    z: float
    heading: float
    """Of the driven line [rad], in (-pi, pi]."""
    curvature: float
    """Of the driven line [1/m], positive to the left."""
    curvature_rate: float
    """[1/m^2]"""
    grade: float
    """Metres upwards per metre of S."""
    superelevation: float
    """[rad], positive lifts the driver's left side."""
    left: float
    """Distance to the driven lane's left edge [m]."""
    right: float
    """Distance to its right edge [m]."""
    s: float
    """On the lane's road [m]."""
    lane: Lane
    clamped: int
    """-1 or 1 where S lay before or after the path; else 0."""


class PathPosition(NamedTuple):
    """A point in a path's coordinates."""

    along: float
    """S of the foot [m]."""
    d: float
    """Offset to the left of the driven line [m]."""
    distance: float
    """In plan view from the driven line [m]."""
    heading: float
    """Of the driven line at the foot [rad], in (-pi, pi]."""
    s: float
    lane: Lane
    clamped: int
    """-1 or 1 where the point lies before or after the path; else 0."""


class ConflictLane(NamedTuple):
    """A lane whose traffic meets a path."""

    start: float
    """S of the first common place [m]."""
    end: float
    """S of the last common place [m]."""
    other: Lane
    other_start: float
    other_end: float
    """The common place on the lane's road [m], the smaller s first."""
    kind: str
    yields: Literal["yields", "priority", "lights", "unknown"]
    """Who has priority, according to the file, else to the rules of the country that is named."""
    reason: str
    basis: Literal["written", "rule", "unknown"]
    """What that rests on."""
    wait: float
    """S at which to wait [m]."""


class PathConflict(NamedTuple):
    """A place where the traffic of other lanes meets a path: of one lane, or of several that lead into each other."""

    start: float
    """S of the first common place [m]."""
    end: float
    """S of the last common place [m]."""
    other: Lane
    """The other lane, of several the one that meets the path first."""
    other_start: float
    other_end: float
    """The common place on its road [m], the smaller s first."""
    kind: str
    """"merge" where one of the lanes merges, else "cross" where one crosses."""
    yields: Literal["yields", "priority", "lights", "unknown"]
    """Who has priority, according to the file, else to the rules of the country that is named: "yields" where the path yields to one of the lanes, else "unknown" where
    nothing says so of one."""
    reason: str
    basis: Literal["written", "rule", "unknown"]
    """What that rests on."""
    wait: float
    """S at which to wait [m]: the earliest of the lanes."""
    lanes: list[ConflictLane]


class Decision(NamedTuple):
    """What becomes of a proposal that is not refused."""

    accepted: bool
    """It is laid over the map, and readers see it. Otherwise, others must say the same first."""
    agree: int
    """Where it is not: sources that have said so, with this one."""
    needed: int
    """Where it is not: sources that must."""


class RouteEnd(NamedTuple):
    """A start or goal."""

    lane: Lane | str | int | np.uint64
    s: float
    """On the road [m]."""
    forward: bool | None = None
    """Whether the lane is travelled towards +s there; None for either way."""
    cost: float = 0.0
    """What it costs to start or end there, beside the way."""


class Reach(NamedTuple):
    """What can be reached: the network of lanes ahead, or behind."""

    pieces: Reached
    links: ReachLinks
    """How one goes on from each piece to others; against driving direction where goals were given."""


class LaneLine(NamedTuple):
    """A stop line or crossing on a lane."""

    signal: Signal | None
    """The signal that says so, or else the object does."""
    object: Object | None
    lane: Lane
    s: float
    """Where the lane's traffic meets it first [m]."""
    meaning: str


class PathFact(NamedTuple):
    """A fact along a path. Fields that its kind does not have are None."""

    start: float
    """S of its beginning [m]."""
    end: float
    """S of its end [m]; that of its beginning for what has a place alone."""
    lane: Lane
    """The driven lane at its beginning."""
    kind: Literal["junction", "signal", "line", "road_type", "lane_type", "country", "access", "structure", "hole", "other"]
    name: str | None = None
    """Where the movement through a junction leads ("left", "straight", "right", "back"), what a line means, a type in OpenDRIVE's words, a country as the file
    writes it."""
    junction: str | None = None
    """OpenDRIVE's id."""
    signal: Signal | None = None
    governs: bool | None = None
    """Whether a signal is for what the path does."""
    line: LaneLine | None = None
    left: tuple[float, float, float] | None = None
    """Left end of a line on the driven lane [m]."""
    right: tuple[float, float, float] | None = None
    number: int | None = None
    """Of a bridge, tunnel or hole: its number in the map."""
    vehicles: tuple[str, ...] | None = None
    """Of access: classes of vehicles that may use the driven lane in its driven direction."""


class SpeedStretch(NamedTuple):
    """A stretch of a lane on which one speed limit holds."""

    s_from: float
    s_to: float
    """s of both ends [m]."""
    rule: SpeedRule
    lowest: float | None
    """The limit, or where it depends on the way the lowest that may hold [m/s]; infinite where there is none, None where nothing is known."""


class PathSpeed(NamedTuple):
    """A stretch of a path on which one speed limit holds."""

    start: float
    end: float
    """S of both ends [m]."""
    rule: SpeedRule


class PathTime(NamedTuple):
    """How long a path or a part of it takes at the speed limits."""

    time: float
    """Where a limit is known and above 0 [s]."""
    unlimited: float
    """Length of the rest, where no limit is known or there is none [m]: its time is the caller's to say."""


class PathCrossing(NamedTuple):
    """A crosswalk or bicycle crossing over a path."""

    start: float
    end: float
    """S of both ends [m]."""
    line: LaneLine
    yields: Literal["lights", "unknown"]
    """Whether a light for vehicles stands before it; else a rule of the road decides."""
    wait: float
    """S at which to wait [m]."""


class PathJoint(NamedTuple):
    """A place where the driven line is not continuous, or changes lanes."""

    along: float
    """S [m]."""
    gap: float
    """How far apart the line's two sides lie [m]."""
    kink: float
    """By how much the line turns [rad], positive to the left."""
    enter: Literal["start", "ahead", "left", "right"]
    broken: bool
    """Whether gap or kink are larger than a path should have."""
    short: bool
    """Whether it is a change of lane that jumps because there is no room for a curve."""


class PathChange(NamedTuple):
    """How a stretch of a path differs on another map."""

    start: float
    end: float
    """S of both ends on the old path [m]."""
    kind: Literal["moved", "replaced", "gone"]
    """Whether its lane has moved, another lane lies there, or none does."""
    distance: float | None
    """How far away the lane lies now [m]."""


class Rebased(NamedTuple):
    """The way of a path on another map."""

    route: Route | None
    """None if no way leads along what is left of the path."""
    changes: tuple[PathChange, ...]


class OverlayEntry(NamedTuple):
    """An entry of an overlay."""

    number: int
    """Its place among the overlay's entries, from 0."""
    id: str
    kind: str
    """A kind of docs/overlay.md."""
    value: float | None
    """Of a speed, the limit [m/s]."""
    source: str
    text: str
    confidence: float
    """From 0 to 1."""
    vehicles: tuple[str, ...]
    """Classes that are concerned."""
    holds: bool
    """Whether it holds at the view's moment."""


class Restriction(NamedTuple):
    """An entry that holds on a stretch of a lane."""

    entry: OverlayEntry
    lane: Lane
    s_from: float
    s_to: float
    """On the road [m], the smaller one first."""


class PathRestriction(NamedTuple):
    """An entry that holds on a stretch of a path."""

    start: float
    end: float
    """S of both ends [m]."""
    restriction: Restriction


class Permission(NamedTuple):
    """Whether a lane may be used at a place."""

    is_allowed: bool
    restriction: Restriction | None
    """The entry that decides so; None where the map does."""


class SpeedToday(NamedTuple):
    """The speed limit at a place, with what is said of it today."""

    max: float | None
    """[m/s]; infinite if there is no limit, None if neither map nor overlay states one."""
    map: SpeedRule
    """What the map says."""
    restriction: Restriction | None
    """The entry that says otherwise."""


class PathSpeedToday(NamedTuple):
    """A stretch of a path on which one speed limit holds today."""

    start: float
    end: float
    """S of both ends [m]."""
    speed: SpeedToday
    """What holds there. Where an entry states it, the stretch is on one lane."""


class OvertakingToday(NamedTuple):
    """Whether a class of vehicles may overtake at a place, with what is said of it today."""

    is_forbidden: bool
    """Whether a sign or an entry forbids it to the class."""
    map: OvertakingRule
    """The map's signs."""
    restriction: Restriction | None
    """The first entry that forbids it to the class."""


class Tracked(NamedTuple):
    """Where a tracked vehicle is."""

    state: Literal["lane", "no_lane", "unknown"]
    found: LaneMatch | None
    """The lane, where the state is "lane"."""


class Stance(NamedTuple):
    """How a vehicle stands on the ground below its wheels."""

    z: float
    """Height of the ground's plane below the reference point [m]."""
    roll: float
    """[rad], positive lifts the left side (ISO 8855)."""
    pitch: float
    """[rad], positive lowers the front (ISO 8855)."""
    wheels: tuple[float | None, float | None, float | None, float | None]
    """Height of the ground below each wheel [m]; None beside all lanes."""


class Landmark(NamedTuple):
    """A landmark for localisation."""

    signal: Signal | None
    """The signal that it is, or else it is an object."""
    object: Object | None
    copy: int | None
    """Which of an object's copies."""
    meaning: str
    x: float
    y: float
    z: float
    """Where it stands [m]."""
    heading: float
    """Of a signal the direction of its face's normal, of an object that of its u axis [rad]."""
    length: float
    width: float
    height: float
    """[m]; 0 where not given."""
    distance: float
    """In plan view from the point that was asked about [m]."""


class LandmarkInView(NamedTuple):
    """A landmark as a sensor sees it."""

    landmark: Landmark
    """Its distance is the range from the sensor [m]."""
    bearing: float
    """Direction from the sensor's heading [rad], positive to the left."""
    facing: float
    """How far it is turned away from the sensor [rad]: 0 looks at it."""


class SignalAhead(NamedTuple):
    """A signal ahead."""

    signal: Signal
    distance: float
    """Along centre lines [m]."""
    lane: Lane
    """The lane on which it counts."""
    s: float
    """Its place on that lane's road [m]."""


@dataclass(frozen=True, eq=False)
class Lines:
    """One line of each of many lanes: line k is ``points[offsets[k]:offsets[k + 1]]``, in ascending s."""

    points: NDArray[np.float64]
    """(M, 3), inertial [m]."""
    s: NDArray[np.float64]
    """(M,), on the road [m]."""
    offsets: NDArray[np.int64]
    """(L + 1,)"""
    lane: NDArray[np.uint64]
    """(L,), ids of the lanes."""

    def __len__(self) -> int:
        return len(self.lane)

    def __getitem__(self, line: int) -> NDArray[np.float64]:
        k = range(len(self))[line]
        return self.points[self.offsets[k] : self.offsets[k + 1]]

    def to_geopandas(self, crs: str | None = None) -> geopandas.GeoDataFrame:
        """A frame with a line in each row and its lane's id; ``crs`` is the map's, such as ``map.projection``. Needs geopandas."""
        import geopandas
        import shapely

        of = np.repeat(np.arange(len(self)), np.diff(self.offsets))
        geometry = shapely.linestrings(self.points, indices=of)
        return geopandas.GeoDataFrame({"lane": self.lane}, geometry=geometry, crs=crs or None)

    def __repr__(self) -> str:
        return f"<mapd.Lines {len(self)} lines, {len(self.points)} points>"


@dataclass(frozen=True)
class Generation:
    """A newer generation is served."""

    map: Map


@dataclass(frozen=True)
class Pending:
    """A generation waits to be activated."""

    generation: int


@dataclass(frozen=True)
class DaemonGone:
    """The daemon has ended or was killed. Maps stay readable; new subscribers cannot attach."""


@dataclass(frozen=True)
class DaemonBack:
    """A daemon serves the map again."""

    pid: int


@dataclass(frozen=True)
class OtherEvent:
    """An event that this release of the bindings has no class for."""


Event = Generation | Pending | DaemonGone | DaemonBack | OtherEvent


@dataclass(frozen=True)
class Finding:
    """A finding about a file."""

    rule: str
    """Id of the rule; see docs/rules.md."""
    severity: Literal["info", "warning", "error"]
    message: str
    """What was expected and what was found."""
    hint: str
    """What to do about it; may be empty."""
    path: str
    """Path of elements."""
    subject: str
    """The attribute or child that it is about; empty for the element itself."""
    file: str
    """The included file that it stands in; empty for the document itself."""
    line: int
    """From 1."""
    column: int
    """In bytes, from 1."""
    rejects: bool
    """Whether the map is rejected, or some part of it left out, because of it."""

    def __str__(self) -> str:
        place = f"{self.file}:" if self.file else ""
        return f"{place}{self.line}:{self.column}: {self.severity}[{self.rule}]: {self.message}"


@dataclass(frozen=True)
class QuarantinedPart:
    """A part that is not in the map as the file has it."""

    kind: str
    id: str
    owner: str
    """Id of the road or junction that it belongs to."""
    owner_kind: str
    dropped: bool
    """False for a road that stays as its bare reference line."""
    length: float
    """Of a road [m]; else 0."""
    rule: str
    message: str
    file: str
    line: int
    column: int


@dataclass(frozen=True)
class Report:
    """The findings about a file, and the verdict."""

    verdict: Literal["accepted", "quarantined", "rejected"]
    findings: tuple[Finding, ...]
    """In the order of the file."""
    dropped: tuple[int, int, int]
    """How many more findings there are than `findings` lists: information, warnings, errors."""
    quarantined: tuple[QuarantinedPart, ...]
    version: str
    """The revision that the file states; empty where it states none."""
    checked_against: str
    """The revision that it was checked against."""

    @property
    def errors(self) -> tuple[Finding, ...]:
        """Findings that are errors."""
        return tuple(f for f in self.findings if f.severity == "error")

    def __repr__(self) -> str:
        return f"<mapd.Report {self.verdict}: {len(self.findings)} findings, {len(self.quarantined)} parts in quarantine>"

    def to_dict(self) -> dict[str, Any]:
        """Plain dictionaries and lists, as ``json.dump`` takes them."""
        from dataclasses import asdict

        return asdict(self)
