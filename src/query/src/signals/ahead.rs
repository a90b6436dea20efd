//! Signals ahead: along all ways that lanes lead, on a map or under an overlay, or along a route.

use super::Signal;
use super::lane::LaneSignal;
use crate::error::QueryError;
use crate::extents::SRange;
use crate::ids::{LaneId, SignalId};
use crate::lane::Lane;
use crate::map::Map;
use crate::route::{PositionOnLane, RouteStep, Ways};
use mapd_archive::VehicleClass;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Pieces of lanes that are looked at at most.
const MOST_NODES: usize = 4096;

/// A signal ahead.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SignalAhead {
    /// The signal.
    pub signal: SignalId,
    /// Distance along the lanes' centre lines `[m]`.
    pub distance: f64,
    /// The lane on which it counts.
    pub lane: LaneId,
    /// Its place on that lane's road `[m]`.
    pub s: f64,
    /// Number of the place among all places of signals.
    place: u32,
}

/// Buffers for signals ahead, to be used again.
#[derive(Clone, Default)]
pub struct SignalsAhead {
    found: Vec<SignalAhead>,
    /// Pieces to go on from: distance to their beginning, as bits that sort as the number does, and their number.
    open: BinaryHeap<Reverse<(u64, u32)>>,
    /// Pieces that have been looked at, sorted.
    done: Vec<u32>,
}

impl SignalsAhead {
    /// Buffers that need not grow for these numbers of signals and pieces of lanes.
    pub fn with_capacity(places: usize) -> Self {
        Self {
            found: Vec::with_capacity(places),
            open: BinaryHeap::with_capacity(places),
            done: Vec::with_capacity(places),
        }
    }

    /// What was found, the nearest first; a signal that counts at several places stands several times.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &SignalAhead> {
        self.found.iter()
    }

    fn begin(&mut self) {
        self.found.clear();
        self.open.clear();
        self.done.clear();
    }

    /// Sorts by distance; of one place on one lane the nearest stays.
    fn finish(&mut self) {
        self.found.sort_unstable_by(|a, b| {
            (a.place, a.lane).cmp(&(b.place, b.lane)).then(a.distance.total_cmp(&b.distance))
        });
        self.found.dedup_by_key(|one| (one.place, one.lane));
        self.found.sort_unstable_by(|a, b| {
            a.distance.total_cmp(&b.distance).then((a.place, a.lane).cmp(&(b.place, b.lane)))
        });
    }

    fn add(&mut self, one: &LaneSignal<'_>, lane: LaneId, s: f64, distance: f64) {
        let (signal, place) = (one.signal().signal_id(), one.place_number());
        self.found.push(SignalAhead { signal, distance, lane, s, place });
    }
}

impl<'a> Map<'a> {
    /// Signals for traffic that goes on from a place without changing lanes, up to a distance along any way. `out` holds
    /// them.
    ///
    /// Errors: ids of another map; numbers that are not finite.
    pub fn signals_ahead(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        out: &mut SignalsAhead,
    ) -> Result<(), QueryError> {
        ahead(*self, from, distance, vehicle, out)
    }

    /// Signals along a route, with distances from its start. `out` holds them.
    ///
    /// Errors: ids of another map.
    pub fn signals_along(
        &self,
        steps: &[RouteStep],
        out: &mut SignalsAhead,
    ) -> Result<(), QueryError> {
        out.begin();
        let mut passed = 0.0;
        for (i, step) in steps.iter().enumerate() {
            let lane = self.lane(step.lane)?;
            let last = i + 1 == steps.len();
            for one in lane.signals().filter(|one| one.is_for(step.forward)) {
                let at = one.s_on(&lane);
                if let Some(distance) = met(&lane, step, at, last) {
                    out.add(&one, step.lane, at, passed + distance);
                }
            }
            passed += lane.length_between(step.s_from, step.s_to);
        }
        out.finish();
        Ok(())
    }

    /// The signal of one that is ahead.
    pub fn signal_of(&self, ahead: &SignalAhead) -> Option<Signal<'a>> {
        self.signal(ahead.signal).ok()
    }
}

/// Signals along all ways from a place, as [`Map::signals_ahead`] has them.
pub(crate) fn ahead<'a>(
    ways: impl Ways<'a>,
    from: PositionOnLane,
    distance: f64,
    vehicle: VehicleClass,
    out: &mut SignalsAhead,
) -> Result<(), QueryError> {
    out.begin();
    let lane = ways.map().lane(from.lane)?;
    if !(from.s.is_finite() && distance.is_finite()) {
        return Err(QueryError::NotFinite);
    }
    let section = lane.section();
    let (low, high) = (section.s_start(), section.s_end());
    let s = mapd_geometry::clamp(from.s, low, high.max(low));
    let Some(first) = ways.at(&lane, s, lane.is_forward()) else { return Ok(()) };
    let look = AheadSearch { ways, reach: distance, vehicle };
    look.pass(first, Some(s), 0.0, out);
    while let Some(Reverse((bits, number))) = out.open.pop() {
        let Err(at) = out.done.binary_search(&number) else { continue };
        if out.done.len() >= MOST_NODES {
            break;
        }
        out.done.insert(at, number);
        look.pass(number, None, f64::from_bits(bits), out);
    }
    out.finish();
    Ok(())
}

/// How far is looked, for whom.
struct AheadSearch<W> {
    ways: W,
    reach: f64,
    vehicle: VehicleClass,
}

impl<'a, W: Ways<'a>> AheadSearch<W> {
    /// Adds the signals of a piece from s on, or from its beginning, and the pieces that it leads to.
    fn pass(&self, number: u32, from: Option<f64>, before: f64, out: &mut SignalsAhead) {
        let Some(node) = self.ways.node(number) else { return };
        let Some(lane) = node.lane() else { return };
        let forward = node.is_forward();
        let SRange { low, high } = node.s_range();
        let [begin, end] = if forward { [low, high] } else { [high, low] };
        let s = from.unwrap_or(begin);
        for one in lane.signals().filter(|one| one.is_for(forward)) {
            let at = one.s_on(&lane);
            let ahead = if forward { at >= s } else { at <= s };
            let here = self.ways.at(&lane, at, forward) == Some(number);
            let distance = before + lane.length_between(s, at);
            if ahead && here && distance <= self.reach {
                out.add(&one, lane.lane_id(), at, distance);
            }
        }
        let end = before + lane.length_between(s, end);
        if end <= self.reach {
            self.ways.ahead(number, |next| {
                if self.ways.node(next).is_some_and(|to| node.leads_into(&to, self.vehicle)) {
                    // Bits of numbers that are not negative sort as the numbers do.
                    out.open.push(Reverse((end.max(0.0).to_bits(), next)));
                }
            });
        }
    }
}

/// Distance from where a step of a route begins to a place on its lane `[m]`; none where the step does not come by it.
pub(crate) fn met(lane: &Lane<'_>, step: &RouteStep, at: f64, is_last: bool) -> Option<f64> {
    let behind = if step.forward { at < step.s_from } else { at > step.s_from };
    let beyond = if step.forward { at > step.s_to } else { at < step.s_to };
    // What stands where a change of lane happens counts once, on the lane that is driven on.
    let changed = at == step.s_to && step.s_from == step.s_to && !is_last;
    (!(behind || beyond || changed)).then(|| lane.length_between(step.s_from, at))
}

#[cfg(feature = "serde")]
impl serde::Serialize for SignalsAhead {
    /// The list of [`Self::iter`].
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.iter())
    }
}
