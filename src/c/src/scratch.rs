//! Memory of queries that need some.

use crate::code::{answer, mapd_code, mapd_error};
use crate::list::{close, hand_out};
use mapd_client::batch::{BatchScratch, NearestLanes, PoseMatches};
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{
    GroundScratch, Landmark, LandmarkInView, LaneMatch, MarkPoint, TraceFix, TraceMatch,
    TraceScratch, VehiclePose,
};
use mapd_client::objects::{NearObject, PlacementId};
use mapd_client::path::{
    ConflictApproach, ConflictLane, Corridor, PathChange, PathConflict, PathCrossing, PathFact,
    PathSegment, PathSpeed,
};
use mapd_client::roads::{BoundarySegment, RoadMarkSegment};
use mapd_client::route::{
    LaneSequences, PositionOnLane, Reach, Reached, RouteScratch, RouteStep, Routes,
};
use mapd_client::rules::LineAhead;
use mapd_client::signals::{NearSignal, SignalsAhead};
use mapd_client::{LaneId, Nearest, SignalId};

/// Memory of searches and lists, to be used again: it grows with the largest answer and is then enough. It belongs to one thread
/// at a time and to no map.
#[derive(Default)]
pub struct mapd_scratch {
    pub(crate) route: RouteScratch,
    pub(crate) steps: Vec<RouteStep>,
    pub(crate) places: Vec<PositionOnLane>,
    pub(crate) reached: Vec<Reached>,
    pub(crate) sequences: LaneSequences,
    /// Whether the caller still has to get the sequence that was found last: its list was too small.
    pub(crate) sequence_is_due: bool,
    pub(crate) signals_ahead: SignalsAhead,
    pub(crate) lines: Vec<LineAhead>,
    pub(crate) near: Vec<Nearest>,
    pub(crate) lanes: Vec<LaneId>,
    pub(crate) signals: Vec<SignalId>,
    pub(crate) near_signals: Vec<NearSignal>,
    pub(crate) near_objects: Vec<NearObject>,
    pub(crate) objects: Vec<PlacementId>,
    pub(crate) landmarks: Vec<Landmark>,
    pub(crate) bounds: Vec<BoundarySegment>,
    pub(crate) marks: Vec<RoadMarkSegment>,
    pub(crate) corners: Vec<DVec3>,
    pub(crate) matches: Vec<LaneMatch>,
    pub(crate) fixes: Vec<TraceFix>,
    pub(crate) trace: TraceScratch,
    pub(crate) traced: Vec<TraceMatch>,
    pub(crate) ground: GroundScratch,
    pub(crate) corridor: Corridor,
    pub(crate) outline: Vec<DVec2>,
    pub(crate) conflicts: Vec<PathConflict>,
    pub(crate) conflict_lanes: Vec<ConflictLane>,
    pub(crate) approaches: Vec<ConflictApproach>,
    pub(crate) crossings: Vec<PathCrossing>,
    pub(crate) facts: Vec<PathFact>,
    pub(crate) segments: Vec<PathSegment>,
    pub(crate) speeds: Vec<PathSpeed>,
    pub(crate) part: Vec<RouteStep>,
    pub(crate) changes: Vec<PathChange>,
    pub(crate) poses: Vec<VehiclePose>,
    pub(crate) covariances: Vec<DMat3>,
    pub(crate) batch: BatchScratch,
    pub(crate) batch_matches: PoseMatches,
    /// x, y and z of the points of a batch.
    pub(crate) columns: [Vec<f64>; 3],
    pub(crate) nearest_lanes: NearestLanes,
    pub(crate) in_view: Vec<LandmarkInView>,
    pub(crate) mark_points: Vec<MarkPoint>,
    pub(crate) routes: Routes,
    pub(crate) reach: Reach,
}

/// Makes a scratch. Close it with `mapd_scratch_close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_scratch_new(
    out: *mut *mut mapd_scratch,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || hand_out(out, mapd_scratch::default())) }
}

/// Closes a scratch and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_scratch_close(scratch: *mut *mut mapd_scratch) {
    unsafe { close(scratch) }
}
