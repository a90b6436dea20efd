//! Access by rows of the archive's tables, for programs that have them.

use crate::area;
use crate::graph::LaneNode;
use crate::junction::Junction;
use crate::lane::Lane;
use crate::map::Map;
use crate::objects::Object;
use crate::road::Road;
use crate::section::LaneSection;
use crate::signals::Signal;
use crate::types::LanePosition;
use glam::DVec2;

/// Access by row of the archive's tables; `None` if there is no such row. For the compiler and this project's own programs: hidden,
/// so that the documentation of [`Map`] does not show it either.
#[doc(hidden)]
pub trait ByRow<'a> {
    /// The lane, lane 0 included.
    fn lane_by_row(&self, row: u32) -> Option<Lane<'a>>;
    /// The lane section.
    fn section_by_row(&self, row: u32) -> Option<LaneSection<'a>>;
    /// The road.
    fn road_by_row(&self, row: u32) -> Option<Road<'a>>;
    /// The junction.
    fn junction_by_row(&self, row: u32) -> Option<Junction<'a>>;
    /// The object.
    fn object_by_row(&self, row: u32) -> Option<Object<'a>>;
    /// The node of the lane graph.
    fn lane_node_by_row(&self, row: u32) -> Option<LaneNode<'a>>;
    /// The signal.
    fn signal_by_row(&self, row: u32) -> Option<Signal<'a>>;
}

impl<'a> ByRow<'a> for Map<'a> {
    fn lane_by_row(&self, row: u32) -> Option<Lane<'a>> {
        Lane::new(*self, row)
    }

    fn section_by_row(&self, row: u32) -> Option<LaneSection<'a>> {
        LaneSection::new(*self, row)
    }

    fn road_by_row(&self, row: u32) -> Option<Road<'a>> {
        Road::new(*self, row)
    }

    fn junction_by_row(&self, row: u32) -> Option<Junction<'a>> {
        Junction::new(*self, row)
    }

    fn object_by_row(&self, row: u32) -> Option<Object<'a>> {
        Object::new(*self, row)
    }

    fn signal_by_row(&self, row: u32) -> Option<Signal<'a>> {
        Signal::new(*self, row)
    }

    fn lane_node_by_row(&self, row: u32) -> Option<LaneNode<'a>> {
        LaneNode::new(*self, row)
    }
}

/// As [`Lane::position_of`], within the stretch of one segment of the centre line, for a caller that has found the segment. None
/// for a segment without area, or where the point is farther than `limit` `[m]` and that is cheap to tell.
pub fn position_along(
    lane: &Lane<'_>,
    segment: usize,
    point: DVec2,
    limit: f64,
) -> Option<LanePosition> {
    let slab = area::slab(lane, segment)?;
    let local = point - lane.map.origin();
    let place = match limit {
        0.0 => area::place_inside(lane, lane, &slab, local)?,
        _ => area::place(lane, &slab, local),
    };
    Some(place.position(lane))
}
