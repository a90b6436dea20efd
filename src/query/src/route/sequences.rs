//! Lanes one after the other: all sequences ahead or behind, and the next junction.

use super::ends::{lane_of, price};
use super::{PositionOnLane, ShortestLength};
use crate::error::QueryError;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::{JunctionId, LaneId};
use crate::lane::edges_of;
use crate::map::Map;
use crate::route::RouteCost;
use mapd_archive::VehicleClass;

/// Sequences that are listed at most: behind many forks they double and double again.
const MOST_SEQUENCES: usize = 1024;
/// Lanes that one sequence follows at most: a loop of no length would never reach its distance.
const MOST_LANES: usize = 4096;

/// Sequences of lanes, in buffers that are used again.
#[derive(Clone, Default)]
pub struct LaneSequences {
    lanes: Vec<LaneId>,
    /// End of each sequence in `lanes`.
    ends: Vec<usize>,
    /// Whether there are more sequences than the 1,024 that are listed. [`Map::reach`] has each lane once, however many ways lead over it.
    pub truncated: bool,
    /// Nodes of the sequence that is being followed, with the distance at their end and the next edge to try.
    open: Vec<(u32, f64, usize)>,
}

/// The next junction on a lane's way.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NextJunction {
    /// The junction.
    pub junction: JunctionId,
    /// Distance to its first connecting road, along centre lines `[m]`.
    pub distance: f64,
}

impl LaneSequences {
    /// Buffers that need not grow for this number of lanes in all sequences.
    pub fn with_capacity(lanes: usize) -> Self {
        Self {
            lanes: Vec::with_capacity(lanes),
            ends: Vec::with_capacity(lanes),
            open: Vec::with_capacity(lanes),
            truncated: false,
        }
    }

    /// The sequences, each from the lane of the start on, in the direction in which it was followed.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[LaneId]> {
        (0..self.ends.len()).map(|i| {
            let from = i.checked_sub(1).and_then(|i| self.ends.get(i)).copied().unwrap_or(0);
            self.ends.get(i).and_then(|to| self.lanes.get(from..*to)).unwrap_or(&[])
        })
    }

    fn begin(&mut self) {
        self.lanes.clear();
        self.ends.clear();
        self.open.clear();
        self.truncated = false;
    }
}

impl<'a> Map<'a> {
    /// All sequences of lanes that a vehicle can follow from a place without changing lanes, until each is `distance` long
    /// or ends. At most 1,024 are listed, and [`LaneSequences::truncated`] says whether there are more: their number doubles with each
    /// fork. [`Map::reach`] merges what they have in common.
    ///
    /// Errors: ids of another map; numbers that are not finite.
    pub fn lane_sequences_ahead(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        self.sequences(from, distance, vehicle, true, out)
    }

    /// All sequences of lanes on which a vehicle can have come to a place without changing lanes, nearest first, until each
    /// is `distance` long or begins.
    ///
    /// Errors: as [`Map::lane_sequences_ahead`].
    pub fn lane_sequences_behind(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        self.sequences(from, distance, vehicle, false, out)
    }

    fn sequences(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        ahead: bool,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        out.begin();
        self.lane(from.lane)?;
        if !(from.s.is_finite() && distance.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        let Some((lane, s)) = lane_of(*self, from) else { return Ok(()) };
        for way in [true, false] {
            let Some(node) = lane.node_at(s, way) else { continue };
            let SRange { low, high } = node.s_range();
            let end = if node.is_forward() == ahead { high } else { low };
            out.open.push((node.number, lane.length_between(s, end), 0));
            self.follow(distance, vehicle, ahead, out);
        }
        Ok(())
    }

    /// Depth first from the one node that is open.
    fn follow(&self, distance: f64, vehicle: VehicleClass, ahead: bool, out: &mut LaneSequences) {
        let tables = self.tables();
        let (offsets, targets) = if ahead {
            (tables.successor_offsets, tables.successors)
        } else {
            (tables.predecessor_offsets, tables.predecessors)
        };
        while let Some((node, length, edge)) = out.open.last_mut() {
            let (node, length, at) = (*node, *length, *edge);
            *edge += 1;
            let edges = edges_of(offsets, targets, node);
            let allowed = |n: &LaneNode<'_>| n.allows(vehicle);
            let next =
                LaneNode::new(*self, edges.get(at).copied().unwrap_or(u32::MAX)).filter(allowed);
            let over = length >= distance || out.open.len() >= MOST_LANES;
            if !over && at < edges.len() {
                if let Some(next) = next {
                    let passed = price(ShortestLength::default().pass(&next));
                    out.open.push((next.number, length + passed, 0));
                }
                continue;
            }
            let goes_on = |node: &u32| LaneNode::new(*self, *node).is_some_and(|n| allowed(&n));
            if over || !edges.iter().any(goes_on) {
                if out.ends.len() >= MOST_SEQUENCES {
                    out.truncated = true;
                    out.open.clear();
                    return;
                }
                self.list(out);
            }
            out.open.pop();
        }
    }

    /// Lists the open nodes' lanes, pieces of one lane as one.
    fn list(&self, out: &mut LaneSequences) {
        let mut last: Option<u32> = None;
        for (node, ..) in &out.open {
            let Some(own) = LaneNode::new(*self, *node) else { continue };
            let lane = LaneId::new(own.row.lane(), self.content());
            let piece = last.is_some_and(|last| last.abs_diff(*node) == 1)
                && last.and_then(|last| LaneNode::new(*self, last)).is_some_and(|before| {
                    before.row.lane() == own.row.lane() && before.is_forward() == own.is_forward()
                });
            if !piece {
                out.lanes.push(lane);
            }
            last = Some(*node);
        }
        out.ends.push(out.lanes.len());
    }

    /// The next junction ahead of a place within a distance, following the lanes as long as there is but one way on, or all
    /// ways lead into one junction. On a connecting road the distance is 0.
    ///
    /// Errors: ids of another map; numbers that are not finite.
    pub fn next_junction(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
    ) -> Result<Option<NextJunction>, QueryError> {
        let lane = self.lane(from.lane)?;
        if !(from.s.is_finite() && distance.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        let s = super::ends::inside(&lane, from.s);
        let Some(mut node) = lane.node_at(s, lane.is_forward()) else { return Ok(None) };
        if let Some(junction) = lane.road().junction() {
            return Ok(Some(NextJunction { junction: junction.junction_id(), distance: 0.0 }));
        }
        let SRange { low, high } = node.s_range();
        let mut passed = lane.length_between(s, if node.is_forward() { high } else { low });
        for _ in 0..MOST_LANES {
            if passed > distance {
                break;
            }
            let mut ways = node.edges().filter_map(|e| e.target()).filter(|n| n.allows(vehicle));
            let Some(next) = ways.next() else { break };
            let junction = |n: &LaneNode<'_>| Some(n.lane()?.road().junction()?.junction_id());
            if let Some(own) = junction(&next) {
                return Ok(Some(NextJunction { junction: own, distance: passed }));
            }
            if ways.next().is_some() {
                break;
            }
            passed += next.length();
            node = next;
        }
        Ok(None)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for LaneSequences {
    /// `sequences`, each a list of lanes, and `truncated`.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut out = to.serialize_struct("LaneSequences", 2)?;
        out.serialize_field("sequences", &self.iter().collect::<Vec<_>>())?;
        out.serialize_field("truncated", &self.truncated)?;
        out.end()
    }
}
