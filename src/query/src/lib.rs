//! What planners and localisers ask of an HD map, answered in place on a borrowed mapd archive.
//!
//! [`Map`] is a small `Copy` view; [`Road`], [`LaneSection`], [`Lane`], [`Junction`] and [`Object`] are cursors into it.
//!
//! Invariants: a query never allocates, locks, prints, panics or does I/O, also on a damaged archive; there is no global
//! state; the compiler evaluates geometry through the same functions, bit for bit. Deliberately absent: how the bytes
//! came here (see `mapd-client`).
//!
//! Of a lane, left, right and ahead are those of its traffic unless a name says `of_reference_line`; of a road, those of its
//! reference line. An s that is no finite number has no answer: [`QueryError::NotFinite`], `None`, or NaN where the answer is a bare
//! number. One that lies outside is moved to the nearer end of the road, or of the lane's section: answers that say where they are
//! tell so ([`Clamped`]), bare numbers are those of the end.
//!
//! ```
//! use mapd_query::{Map, NearestOptions, glam::DVec2};
//!
//! fn lane_under(map: Map<'_>, x: f64, y: f64) -> Option<String> {
//!     let hit = map.nearest_lane(DVec2::new(x, y), &NearestOptions::default()).ok()??;
//!     Some(map.lane(hit.lane).ok()?.key().to_string())
//! }
//! ```

mod annotation;
mod area;
mod class_set;
mod cross_section;
mod error;
mod fetch;
mod file_frame;
#[cfg(feature = "geodesy")]
mod geodetic;
mod graph;
mod grid;
mod ground;
mod ids;
mod index;
mod junction;
mod junction_group;
mod key;
mod landmark;
mod lane;
mod lane_length;
mod lane_words;
mod map;
mod marks;
mod matching;
mod near;
mod nearest;
mod objects;
mod packed;
mod path;
mod polyline;
mod profile;
mod quarantine;
mod railway;
mod region;
mod road;
mod road_mark;
mod route;
mod section;
mod signals;
mod structures;
mod surface;
mod types;
mod view;
mod waypoints;

pub use annotation::{Annotated, Annotation, IncludedFile};
pub use class_set::ClassSet;
pub use cross_section::{CrossSection, SectionCutter};
pub use error::QueryError;
pub use file_frame::FileFrame;
#[cfg(feature = "geodesy")]
pub use geodetic::GeodeticError;
pub use glam;
pub use graph::{Conflict, LaneEdge, LaneNode};
pub use ground::{Ground, GroundScratch};
pub use ids::{
    ControllerId, JunctionId, LaneId, LaneSectionId, NodeId, ObjectId, RoadId, SignalId,
};
pub use index::{SegmentHit, nearest_segment};
pub use junction::{Connection, Junction};
pub use junction_group::{JunctionGroup, JunctionGroupMember};
pub use key::{LaneKey, LaneLayer, ParseLaneKeyError};
pub use landmark::{Landmark, LandmarkSource};
pub use lane::{Lane, LaneSpeed};
pub use lane_length::travel_speed;
pub use lane_words::{LaneRule, LaneVisibility};
pub use map::Map;
pub use mapd_archive::{
    AnnotationKind, AnnotationOwner, Class, ClassGroup, ConflictKind, ContactPoint, EdgeKind,
    FromSide, GeoReferenceForm, JunctionGroupKind, LaneMethod, LaneType, MarkLaneChange,
    ObjectShape, ObjectSide, Orientation, OutlineFill, Overlay, OverlayKind, PlatformSide,
    QuarantinedKind, Relation, RelationReason, RoadMarkColor, RoadMarkKind, RoadMarkRule,
    RoadMarkWeight, RoadRules, RoadType, SignalPosition, SpeedKind, StructureKind, SwitchPosition,
    VehicleClass,
};
#[cfg(feature = "geodesy")]
pub use mapd_geodesy::{DefinitionError, Geodetic, Offset, ProjectionError, Projector};
pub use marks::{MarkFilter, MarkKinds, NearMark, Side};
pub use matching::{
    LaneMatch, MatchError, MatchOptions, TraceFix, TraceMatch, TraceOptions, TraceScratch,
    VehiclePose,
};
pub use nearest::{LaneTypes, Nearest, NearestOptions};
pub use objects::{
    NearObject, Object, ObjectBorder, ObjectLane, ObjectMarking, ObjectMaterial, ObjectOutline,
    ObjectPlacement, ParkingSpace, PlacementId, Skeleton, SkeletonVertex,
};
pub use path::{
    Corridor, EdgeMark, Path, PathBuffer, PathChange, PathChangeKind, PathConflict, PathError,
    PathFact, PathFactKind, PathJoint, PathLane, PathOptions, PathPoint, PathPosition, PathSegment,
    PathSpeed, Yields, steps_of_lanes,
};
pub use polyline::Polyline;
pub use quarantine::Quarantined;
pub use railway::{Platform, PlatformSegment, Station, Switch, SwitchTrack};
pub use region::{BoundarySegment, Region};
pub use road::{Road, RoadLink, RoadTypeRecord};
pub use road_mark::{RoadMark, RoadMarkLine, RoadMarkSegment};
pub use route::{
    CostBound, Enter, LaneChangeAhead, LanePlace, LaneSequences, NextJunction, Reached, Route,
    RouteCost, RouteScratch, RouteStep, ShortestLength, ShortestTime, WithFactors,
    next_lane_change,
};
pub use section::LaneSection;
pub use signals::{
    Basis, BoardGroupMember, Controller, DisplayArea, JunctionController, LaneLine, LaneSignal,
    LightStates, LineAhead, LineSource, NearSignal, OvertakingRule, RightOfWay, Signal,
    SignalAhead, SignalBoard, SignalLink, SignalPlace, SignalSemantics, SignalsAhead, SpeedOrigin,
    SpeedRule, Turn,
};
#[doc(hidden)]
pub use signals::{SpeedSigns, Zone, is_of_speed};
pub use structures::{ObjectReference, Structure};
pub use surface::{LaneHeight, Material, Surface};
pub use types::{Clamped, LaneEdges, LanePosition, Point, Pose, Track, TrackPosition};
pub use view::{
    ForeignOverlay, OverlayEntry, Permission, ReachedPiece, Restriction, SpeedToday, View,
};
pub use waypoints::Waypoint;
