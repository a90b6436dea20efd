//! What the crate shows, by what it is about.

/// What the document says beyond the network, where it says it, and what was left out.
pub mod document {
    pub use crate::annotation::{Annotated, Annotation, IncludedFile};
    pub use crate::extents::{HeaderOffset, Revision, SourcePosition};
    pub use crate::file_frame::FileFrame;
    pub use crate::quarantine::Quarantined;
}

/// Parts of roads and lanes: cross-sections, lines, surfaces, road marks.
pub mod roads {
    pub use crate::cross_section::CrossSection;
    pub use crate::extents::LaneRange;
    pub use crate::lane::LaneSpeed;
    pub use crate::lane_length::travel_speed;
    pub use crate::lane_words::{LaneRule, LaneVisibility};
    pub use crate::polyline::{LinePoint, Polyline};
    pub use crate::region::BoundarySegment;
    pub use crate::road::{RoadLink, RoadTypeRecord};
    pub use crate::road_mark::{RoadMark, RoadMarkExtent, RoadMarkLine, RoadMarkSegment};
    pub use crate::surface::{LaneHeight, Material, Surface};
    pub use crate::waypoints::Waypoint;
}

/// Parts of junctions, and groups of them.
pub mod junctions {
    pub use crate::grid::GridHeight;
    pub use crate::junction::{ConnectedLanes, Connection};
    pub use crate::junction_group::{JunctionGroup, JunctionGroupMember};
}

/// Where something is: poses and traces matched to lanes; ground, road marks and landmarks to compare with.
pub mod localisation {
    pub use crate::ground::{Ground, GroundScratch, Stance};
    pub use crate::landmark::{Landmark, LandmarkInView, LandmarkSource, Sensor};
    pub use crate::marks::{MarkFilter, MarkKinds, MarkPoint, MarkSource, NearMark, Side};
    pub use crate::matching::{
        LaneMatch, MatchError, MatchOptions, TraceFix, TraceMatch, TraceOptions, TracePosition,
        TraceScratch, Tracked, Tracker, TrackerFix, TrackerOptions, VehicleOutline, VehiclePose,
    };
}

/// Latitudes and longitudes.
#[cfg(feature = "geodesy")]
pub mod geodesy {
    pub use crate::geodetic::{GeodeticError, GeodeticPoint};
    pub use mapd_geodesy::{
        DefinitionError, EnuFrame, Geodetic, Offset, ProjectionError, Projector, UtmZone,
    };
}

/// The words of the map: types, kinds and classes. Archives of later releases may use words that this one does not know; they
/// read as `Unknown`.
pub mod vocabulary {
    pub use crate::class_set::ClassSet;
    pub use mapd_archive::{
        AnnotationKind, AnnotationOwner, Class, ClassGroup, ConflictKind, ContactPoint, EdgeKind,
        FromSide, GeoReferenceForm, JunctionGroupKind, LaneMethod, LaneType, MarkLaneChange,
        ObjectShape, ObjectSide, Orientation, OutlineFill, PlatformSide, QuarantinedKind, Relation,
        RelationReason, RoadMarkColor, RoadMarkKind, RoadMarkRule, RoadMarkWeight, RoadRules,
        RoadType, SignalPosition, SpeedKind, StructureKind, SwitchPosition, VehicleClass,
    };
}

/// What the compiler and this project's own programs need besides. No part of the public interface: it changes without
/// notice.
#[doc(hidden)]
pub mod compiling {
    pub use crate::begun::begun;
    pub use crate::by_row::{ByRow, position_along};
    pub use crate::cross_section::SectionCutter;
    pub use crate::graph::{extremes_of_joined, is_first_joined};
    pub use crate::index::{SegmentHit, nearest_segment};
    pub use crate::lane_length::{Measures, measures_between};
    pub use crate::lengths_along::{lengths_along, measures_along};
    pub use crate::parallel::{MostBend, Parallel, ParallelFrom};
    pub use crate::polyline::LineReader;
    pub use crate::rules::entry_sign::EntrySign;
    pub use crate::rules::right_of_way::{LightGroup, Movement};
    pub use crate::rules::speed_signs::{SpeedSigns, Zone, is_of_speed};
    pub use crate::signals::lane::signals_of_lanes;
}
