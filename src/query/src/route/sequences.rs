//! Lanes one after the other: all sequences ahead or behind, and the next junction.

use super::ends::{lane_of, price};
use super::reach::ReachedPart;
use super::scratch::{Open, RouteScratch};
use super::{Enter, PositionOnLane, Reach, ReachLink, Reached, ShortestLength};
use crate::error::QueryError;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::{JunctionId, LaneId};
use crate::lane::edges_of;
use crate::map::Map;
use crate::route::RouteCost;
use mapd_archive::VehicleClass;

/// Lanes that are followed to the next junction at most: a damaged archive might lead round in a circle.
const MOST_LANES: usize = 4096;
/// Pieces of a sequence at most: round a cycle, a distance alone would not limit it.
const MOST_PIECES: usize = 1 << 16;
/// A cycle of lanes this long at most is not followed round `[m]`: no network may have one (`mapd:graph.no_progress`), and nobody would get far on it.
const NO_PROGRESS: f64 = 1.0;

/// Sequences of lanes: as a network in which what they have in common stands once, and one by one. In buffers that are used again.
#[derive(Clone, Default)]
pub struct LaneSequences {
    network: Reach,
    /// What is driven of each piece of the network `[m]`.
    lengths: Vec<f64>,
    /// Pieces from which sequences start, the first ones of the network.
    starts: usize,
    /// How far the sequences lead `[m]`.
    distance: f64,
    /// Whether they are followed in driving direction.
    ahead: bool,
    /// Starts that are done or being followed.
    begun: usize,
    /// The sequence that is being followed.
    followed: Vec<Followed>,
    /// Length of the followed sequence where it enters each piece for the last time; −∞ where it does not.
    entered: Vec<f64>,
    /// Lanes of the sequence that was found last.
    lanes: Vec<LaneId>,
}

/// A piece of the sequence that is being followed.
#[derive(Clone, Copy)]
struct Followed {
    piece: usize,
    /// Of the sequence up to its end `[m]`.
    length: f64,
    /// Links that have been tried.
    tried: usize,
    /// Whether a sequence goes on from here.
    goes_on: bool,
    /// What `entered` said before.
    entered: f64,
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
    /// Buffers that need not grow for this many pieces of lanes that lie within the distance, with as many links, where no sequence goes round a cycle.
    pub fn with_capacity(pieces: usize) -> Self {
        Self {
            network: Reach::with_capacity(pieces),
            lengths: Vec::with_capacity(pieces),
            followed: Vec::with_capacity(pieces),
            entered: Vec::with_capacity(pieces),
            lanes: Vec::with_capacity(pieces),
            ..Self::default()
        }
    }

    /// What all sequences lead over, each piece of a lane once, however many of them do, nearest first; and the links by which they lead on, in the
    /// direction in which they are followed. Its size grows with the map ahead, not with the number of sequences.
    pub fn network(&self) -> &Reach {
        &self.network
    }

    /// The next sequence, from the lane of the start on, in the direction in which it is followed; none after the last one. At a fork that leads on by
    /// the first link comes before that by the second.
    ///
    /// Sequences are made while they are asked for: their number doubles with each fork, and there is no limit to it. One of more than 65,536 pieces of lanes ends there.
    pub fn next_sequence(&mut self) -> Option<&[LaneId]> {
        loop {
            let is_short = self.followed.len() < MOST_PIECES;
            let Some(last) = self.followed.last_mut() else {
                if self.begun >= self.starts {
                    self.lanes.clear();
                    return None;
                }
                self.begun += 1;
                self.enter(self.begun - 1, 0.0);
                continue;
            };
            let Followed { piece, length, tried, .. } = *last;
            let links = self.network.links(piece);
            if let Some(link) = links.get(tried).filter(|_| length < self.distance && is_short) {
                last.tried += 1;
                let next = link.to;
                let before = self.entered.get(next).copied().unwrap_or(length);
                if length > before + NO_PROGRESS {
                    last.goes_on = true;
                    self.enter(next, length);
                }
                continue;
            }
            let ends = !last.goes_on;
            if ends {
                self.list();
            }
            if let Some(last) = self.followed.pop()
                && let Some(own) = self.entered.get_mut(last.piece)
            {
                *own = last.entered;
            }
            if ends {
                return Some(&self.lanes);
            }
        }
    }

    /// The sequence that [`Self::next_sequence`] found last; empty before the first and after the last one.
    pub fn sequence(&self) -> &[LaneId] {
        &self.lanes
    }

    /// Follows the sequence into a piece.
    fn enter(&mut self, piece: usize, at: f64) {
        let length = at + self.lengths.get(piece).copied().unwrap_or(f64::INFINITY);
        let Some(own) = self.entered.get_mut(piece) else { return };
        let entered = std::mem::replace(own, at);
        self.followed.push(Followed { piece, length, tried: 0, goes_on: false, entered });
    }

    /// Lists the followed pieces' lanes, pieces of one lane as one.
    fn list(&mut self) {
        self.lanes.clear();
        let mut last: Option<&Reached> = None;
        for own in self.followed.iter().filter_map(|one| self.network.reached().get(one.piece)) {
            let is_same = last.is_some_and(|last| {
                let [first, second] = if self.ahead { [last, own] } else { [own, last] };
                (first.lane, first.forward) == (second.lane, second.forward)
                    && first.number + 1 == second.number
            });
            if !is_same {
                self.lanes.push(own.lane);
            }
            last = Some(own);
        }
    }

    fn begin(&mut self, distance: f64, ahead: bool) {
        self.network.clear();
        self.lengths.clear();
        self.followed.clear();
        self.entered.clear();
        self.lanes.clear();
        (self.starts, self.begun, self.distance, self.ahead) = (0, 0, distance, ahead);
    }

    /// Adds a node that is entered at an end after a length, and of which another length is driven.
    fn add(&mut self, node: &LaneNode<'_>, from: f64, passed: f64, length: f64) {
        let SRange { low, high } = node.s_range();
        let s = [from, if node.is_forward() == self.ahead { high } else { low }];
        let cost = if self.ahead { passed } else { passed + length };
        let part = ReachedPart { node, number: node.number, s, cost, lane_changes: 0 };
        let Some(mut own) = part.cut(self.distance - passed, length) else { return };
        if !self.ahead {
            (own.s_from, own.s_to) = (own.s_to, own.s_from);
        }
        self.network.reached.push(own);
        self.lengths.push(length);
        self.entered.push(f64::NEG_INFINITY);
    }
}

impl<'a> Map<'a> {
    /// All sequences of lanes that a vehicle can follow from a place without changing lanes, until each is `distance` long or ends:
    /// [`LaneSequences::next_sequence`] tells them one by one, and [`LaneSequences::network`] is what they have in common.
    ///
    /// The lane of the place may be any; every other one must be open to the vehicle.
    ///
    /// Errors: ids of another map; numbers that are not finite.
    pub fn lane_sequences_ahead(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        scratch: &mut RouteScratch,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        out.begin(distance, true);
        self.sequences(from, vehicle, scratch, out)
    }

    /// All sequences of lanes on which a vehicle can have come to a place without changing lanes, each from the place's lane back, until it
    /// is `distance` long or begins.
    ///
    /// Errors: as [`Map::lane_sequences_ahead`].
    pub fn lane_sequences_behind(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        scratch: &mut RouteScratch,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        out.begin(distance, false);
        self.sequences(from, vehicle, scratch, out)
    }

    /// Finds the network: nodes in the order of their least distance.
    fn sequences(
        &self,
        from: PositionOnLane,
        vehicle: VehicleClass,
        scratch: &mut RouteScratch,
        out: &mut LaneSequences,
    ) -> Result<(), QueryError> {
        self.lane(from.lane)?;
        let (distance, ahead) = (out.distance, out.ahead);
        if !(from.s.is_finite() && distance.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        let tables = self.tables();
        let (offsets, targets) = if ahead {
            (tables.successor_offsets, tables.successors)
        } else {
            (tables.predecessor_offsets, tables.predecessors)
        };
        // A closed lane is followed only over its further pieces.
        let leads = |node: u32, next: u32| {
            let both = LaneNode::new(*self, node).zip(LaneNode::new(*self, next));
            both.is_some_and(|(node, next)| {
                let [first, second] = if ahead { [&node, &next] } else { [&next, &node] };
                next.allows(vehicle) || first.stays_on_closed(second, vehicle)
            })
        };
        let go_on = |scratch: &mut RouteScratch, node: u32, length: f64| {
            for next in edges_of(offsets, targets, node) {
                if length < distance && leads(node, *next) && scratch.improve(*next, length, 0) {
                    scratch.heap.push(Open::new(length, length, *next));
                }
            }
        };
        let Some((lane, s)) = lane_of(*self, from) else { return Ok(()) };
        scratch.begin(tables.lane_nodes.len());
        for way in [true, false] {
            let Some(node) = lane.node_at(s, way) else { continue };
            let SRange { low, high } = node.s_range();
            let end = if node.is_forward() == ahead { high } else { low };
            let length = lane.length_between(s, end);
            out.add(&node, s, 0.0, length);
            go_on(scratch, node.number, length);
        }
        out.starts = out.lengths.len();
        while let Some(open) = scratch.heap.pop() {
            let (number, passed) = (open.node, open.key());
            if scratch.label(number).is_none_or(|label| passed > label.cost) {
                continue;
            }
            let Some(node) = LaneNode::new(*self, number) else { continue };
            // From here on the label's parent is the number among what is found.
            scratch.set_parent(number, out.lengths.len() as u32);
            let SRange { low, high } = node.s_range();
            let begin = if node.is_forward() == ahead { low } else { high };
            let length = price(ShortestLength::default().pass(&node));
            out.add(&node, begin, passed, length);
            go_on(scratch, number, passed + length);
        }
        let LaneSequences { network: Reach { reached, links, first }, lengths, .. } = out;
        for (own, length) in reached.iter().zip(lengths.iter()) {
            first.push(links.len() as u32);
            let end = if ahead { own.cost + length } else { own.cost };
            if end < distance {
                let next = edges_of(offsets, targets, own.number).iter();
                let known = next.filter(|next| leads(own.number, **next));
                let known = known.filter_map(|next| scratch.label(*next));
                links.extend(
                    known.map(|to| ReachLink { to: to.parent as usize, enter: Enter::Ahead }),
                );
            }
        }
        first.push(links.len() as u32);
        Ok(())
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
            let from = node;
            let ahead = from.edges().filter_map(|edge| edge.target());
            let mut ways = ahead.filter(|next| from.leads_into(next, vehicle));
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
    /// The network.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        self.network.serialize(to)
    }
}
