//! The lanes that lead to where another lane meets a path.

use super::conflicts::{ConflictLane, leads};
use super::overlaps::STEP;
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// Lanes of one answer at most.
const MOST: usize = 4_096;

/// A lane, or a piece of one, on which traffic comes towards a conflict.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ConflictApproach {
    /// The lane.
    pub lane: LaneId,
    /// Whether it is travelled towards +s.
    pub forward: bool,
    /// s where the part within the distance begins and where it ends `[m]`, in driving direction.
    pub s: [f64; 2],
    /// Distance of both from the conflict's first place along the centre lines `[m]`, the larger one first.
    pub distance: [f64; 2],
    #[cfg_attr(feature = "serde", serde(skip))]
    node: u32,
    #[cfg_attr(feature = "serde", serde(skip))]
    settled: bool,
}

/// Whether traffic comes to where a lane meets a path, travelling it in a direction, from where another meets it, or the same at another stretch.
fn comes_from(map: Map<'_>, from: &ConflictLane, to: &ConflictLane, forward: bool) -> bool {
    let ([low, high], [begin, end]) = (from.other_s, to.other_s);
    if from.other == to.other {
        let s = if forward { begin } else { end };
        let is_before = if forward { low < s } else { high > s };
        return is_before && (low - STEP..=high + STEP).contains(&s);
    }
    leads(map, from, to, Some(forward), STEP)
}

impl<'a> Map<'a> {
    /// The lanes on which traffic comes to a conflict of a path, back to a distance `[m]` from its first place on the other lanes, each by the shortest way, nearest
    /// first. `lanes` are those of the conflict ([`PathConflict::lanes_of`](super::PathConflict::lanes_of)), of which those come first that none of the others leads to. Changes of lane are not
    /// among the ways. `vehicle` is the class of who comes, not of who drives the path: lanes that are closed to it bring none, the other lanes neither. Who heeds bicycles asks
    /// for them, too. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: a conflict of another map, a distance that is not finite.
    pub fn approaches(
        &self,
        lanes: &[ConflictLane],
        distance: f64,
        vehicle: VehicleClass,
        out: &mut Vec<ConflictApproach>,
    ) -> Result<(), QueryError> {
        out.clear();
        if !distance.is_finite() {
            return Err(QueryError::NotFinite);
        }
        // On a ring each may lead to the next.
        for is_first in [true, false] {
            if !is_first && !out.is_empty() {
                break;
            }
            for lane in lanes.iter().take(MOST) {
                let (other, [low, high]) = (self.lane(lane.other)?, lane.other_s);
                for forward in [true, false] {
                    let begin = if forward { low } else { high };
                    let node = other.node_at(begin, forward);
                    let Some(node) = node.filter(|node| node.allows(vehicle)) else { continue };
                    let comes = |before| comes_from(*self, before, lane, forward);
                    if !is_first || !lanes.iter().take(MOST).any(comes) {
                        self.approach(&node, begin, 0.0, out);
                    }
                }
            }
        }
        let mut done = 0;
        while done < out.len() && out.len() < MOST {
            // The nearest that is left: few lanes lie within the reach of an eye.
            let rest = out.iter().enumerate().skip(done);
            let nearest = rest.min_by(|(_, a), (_, b)| a.distance[0].total_cmp(&b.distance[0]));
            let Some((at, _)) = nearest else { break };
            out.swap(done, at);
            let Some(own) = out.get_mut(done) else { break };
            done += 1;
            let ([far, near], number) = (own.distance, own.node);
            own.settled = true;
            if far > distance {
                // What lies beyond is cut off.
                if let Ok(lane) = self.lane(own.lane) {
                    own.s[0] = lane.s_after(own.s[1], own.s[0], (distance - near).max(0.0));
                }
                own.distance[0] = distance.max(near);
                continue;
            }
            let Some(node) = LaneNode::new(*self, number) else { continue };
            for before in node.predecessors().filter(|node| node.allows(vehicle)) {
                let range = before.s_range();
                let exit = if before.is_forward() { range.high } else { range.low };
                self.approach(&before, exit, far, out);
            }
        }
        out.retain(|own| own.settled);
        out.sort_unstable_by(|a, b| {
            let key = |own: &ConflictApproach| (own.distance[1], own.distance[0]);
            let ((a_near, a_far), (b_near, b_far)) = (key(a), key(b));
            a_near.total_cmp(&b_near).then(a_far.total_cmp(&b_far)).then(a.node.cmp(&b.node))
        });
        Ok(())
    }

    /// Notes that a node leads to a conflict from an s on, which is so far from it.
    fn approach(&self, node: &LaneNode<'a>, exit: f64, near: f64, out: &mut Vec<ConflictApproach>) {
        let Some(lane) = node.lane() else { return };
        let (range, forward) = (node.s_range(), node.is_forward());
        let entry = if forward { range.low } else { range.high };
        let far = near + lane.length_between(entry, exit);
        match out.iter_mut().find(|known| known.node == node.number) {
            Some(known) if known.settled || known.distance[0] <= far => {}
            Some(known) => (known.s, known.distance) = ([entry, exit], [far, near]),
            None => out.push(ConflictApproach {
                lane: lane.lane_id(),
                forward,
                s: [entry, exit],
                distance: [far, near],
                node: node.number,
                settled: false,
            }),
        }
    }
}
