//! The lane graph.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::{mapd_lane_id, mapd_node_id};
use crate::list::{List, finite, put, put_some};
use crate::lookup::lane_of;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::SRange;
use mapd_client::graph::{LaneEdge, LaneNode};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map, NodeId};

/// A node of the lane graph.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_node_facts {
    /// The node itself.
    pub node: mapd_node_id,
    /// Its lane.
    pub lane: mapd_lane_id,
    /// Smaller s of both ends on the road \[m\].
    pub s_low: f64,
    /// Larger s of both ends on the road \[m\].
    pub s_high: f64,
    /// Length of the centre line in plan view \[m\].
    pub length: f64,
    /// Time to pass it at the speed limit \[s\].
    pub travel_time: f64,
    /// The node beside it to the left that travels the same way, if any.
    pub left: mapd_node_id,
    /// The node beside it to the right that travels the same way, if any.
    pub right: mapd_node_id,
    /// Where a change of lane to the left leads, if the road marks allow one.
    pub change_left: mapd_node_id,
    /// Where a change of lane to the right leads, if the road marks allow one.
    pub change_right: mapd_node_id,
    /// Strongly connected component, in topological order.
    pub component: u32,
    /// Classes of vehicles that may use it: the bit of each is `1 << code` of its `MAPD_VEHICLE_CLASS_…`.
    pub access: u32,
    /// 1: it travels towards +s.
    pub is_forward: u8,
}

/// An edge of the lane graph: from one node into the next, in driving direction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_edge {
    /// The node that is entered.
    pub target: mapd_node_id,
    /// Where it comes from: a `MAPD_EDGE_KIND_…`.
    pub kind: u8,
    /// 1: it closes a loop; the graph without such edges has no cycle.
    pub closes_loop: u8,
    /// Line of the link in the file, from 1; 0 where no link is needed.
    pub line: u32,
    /// Column of the link in the file, from 1.
    pub column: u32,
}

/// A place where two lanes of a junction meet.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_conflict {
    /// The lane that is met.
    pub other: mapd_lane_id,
    /// The common area on the lane itself: smaller s \[m\].
    pub s_low: f64,
    /// The common area on the lane itself: larger s \[m\].
    pub s_high: f64,
    /// The common area on the other lane: smaller s \[m\].
    pub other_low: f64,
    /// The common area on the other lane: larger s \[m\].
    pub other_high: f64,
    /// How the two meet: a `MAPD_CONFLICT_KIND_…`.
    pub kind: u8,
}

/// A class of vehicles of a code.
pub(crate) fn vehicle_of(code: u8) -> Result<VehicleClass, Failure> {
    match VehicleClass::from_code(code) {
        VehicleClass::Unknown => Err(Failure::argument(format!("{code} is no class of vehicles"))),
        class => Ok(class),
    }
}

fn node_of(map: Map<'_>, node: mapd_node_id) -> Result<LaneNode<'_>, Failure> {
    Ok(map.lane_node(NodeId::from(node))?)
}

fn node_id(node: Option<LaneNode<'_>>) -> mapd_node_id {
    node.map(|node| node.node_id()).into()
}

fn facts(node: &LaneNode<'_>) -> mapd_node_facts {
    let SRange { low: s_low, high: s_high } = node.s_range();
    let classes = VehicleClass::ALL.iter().filter(|class| node.allows(**class));
    mapd_node_facts {
        node: node.node_id().into(),
        lane: node.lane().map(|lane| lane.lane_id()).into(),
        s_low,
        s_high,
        length: node.length(),
        travel_time: node.travel_time(),
        left: node_id(node.left()),
        right: node_id(node.right()),
        change_left: node_id(node.change_left()),
        change_right: node_id(node.change_right()),
        component: node.component(),
        access: classes.fold(0, |bits, class| bits | 1 << class.code()),
        is_forward: node.is_forward().into(),
    }
}

fn edge(edge: LaneEdge<'_>) -> mapd_edge {
    let place = edge.source_position();
    let (line, column) = place.map_or((0, 0), |place| (place.line, place.column));
    mapd_edge {
        target: node_id(edge.target()),
        kind: edge.kind().code(),
        closes_loop: edge.closes_loop().into(),
        line,
        column,
    }
}

/// Number of nodes of the lane graph; their rows count from 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_node_count(
    snapshot: *const mapd_snapshot,
    out: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, map_of(snapshot)?.lane_nodes().len())) }
}

/// What a node is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_node_facts_of(
    snapshot: *const mapd_snapshot,
    node: mapd_node_id,
    out: *mut mapd_node_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, facts(&node_of(map_of(snapshot)?, node)?))) }
}

/// Edges that leave a node, by road id, section and lane of their targets.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_node_edges(
    snapshot: *const mapd_snapshot,
    node: mapd_node_id,
    out: *mut mapd_edge,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let edges = node_of(map_of(snapshot)?, node)?.edges().map(edge);
            List { out, capacity, count }.write(edges)
        })
    }
}

/// Nodes from which a node is entered.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_node_predecessors(
    snapshot: *const mapd_snapshot,
    node: mapd_node_id,
    out: *mut mapd_node_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let before = node_of(map_of(snapshot)?, node)?.predecessors();
            List { out, capacity, count }.write(before.map(|one| one.node_id().into()))
        })
    }
}

/// A lane's nodes in driving order; of a lane travelled both ways then those of the other way.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_nodes(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_node_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let nodes = lane_of(snapshot, lane)?.nodes().map(|one| one.node_id().into());
            List { out, capacity, count }.write(nodes)
        })
    }
}

/// The node that holds s, towards +s (`forward` not 0) or −s; at a cut the later one in that direction. s outside the lane's section
/// counts as its nearer end. `MAPD_CODE_NONE` where the lane is not travelled that way.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_node_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    forward: u8,
    out: *mut mapd_node_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let node = lane_of(snapshot, lane)?.node_at(finite(s)?, forward != 0);
            put_some(out, node.map(|node| node.node_id().into()))
        })
    }
}

/// Whether a class of vehicles may use the lane at s in its own direction: 1 or 0. `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_allows_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    vehicle: u8,
    out: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (s, vehicle) = (finite(s)?, vehicle_of(vehicle)?);
            put(out, lane_of(snapshot, lane)?.allows_at(s, vehicle).into())
        })
    }
}

fn conflicts<'a>(lane: &Lane<'a>) -> impl Iterator<Item = mapd_conflict> + use<'a> {
    lane.conflicts().map(|one| {
        let SRange { low: s_low, high: s_high } = one.s_range();
        let SRange { low: other_low, high: other_high } = one.other_range();
        let (other, kind) = (one.other().map(|lane| lane.lane_id()).into(), one.kind().code());
        mapd_conflict { other, s_low, s_high, other_low, other_high, kind }
    })
}

/// Lanes of the same junction whose areas meet this one's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_conflicts(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_conflict,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || List { out, capacity, count }.write(conflicts(&lane_of(snapshot, lane)?)))
    }
}
