//! Both edges of a lane, from the widths of all lanes between it and lane 0.

use crate::lane::Lane;
use crate::profile::{self, At, Bend, Slope};
use crate::types::LaneEdges;
use mapd_archive::{ArchivedCubicRow, ArchivedLaneRow, lane_flags};

/// t of both edges with their derivatives by s.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct EdgeSlopes {
    pub(crate) inner: Slope,
    pub(crate) outer: Slope,
}

impl EdgeSlopes {
    /// That of the lane's centre.
    #[inline]
    pub(crate) fn center(&self) -> Slope {
        Slope {
            value: 0.5 * (self.inner.value + self.outer.value),
            derivative: 0.5 * (self.inner.derivative + self.outer.derivative),
        }
    }
}

/// A width of at most this is none `[m]`.
const NO_WIDTH: f64 = 1e-9;

/// What a width comes to that is not positive: none. Where it begins or ends at 0 it has the growth of the stretch that holds.
#[cold]
fn closed(width: Slope, at: At) -> Slope {
    let opens = if at.hold < at.s { width.derivative < 0.0 } else { width.derivative > 0.0 };
    let derivative = if opens && width.value > -NO_WIDTH { width.derivative } else { 0.0 };
    Slope { value: 0.0, derivative }
}

/// As [`closed`], with the second derivative.
#[cold]
fn closed_bend(width: Bend, at: At) -> Bend {
    let slope = closed(width.slope, at);
    Bend { slope, second: if slope.derivative == 0.0 { 0.0 } else { width.second } }
}

/// What lies beside an edge by a width, each with whether it is steady.
#[inline]
fn beside(edge: (f64, bool), sign: f64, width: (f64, bool)) -> (f64, bool) {
    (edge.0 + sign * if width.0 > 0.0 { width.0 } else { 0.0 }, edge.1 && width.1)
}

impl<'a> Lane<'a> {
    /// Tells of the section's lanes from the one beside lane 0 outwards to this one.
    #[inline(always)]
    pub(crate) fn walk_outwards(&self, mut lane: impl FnMut(&'a ArchivedLaneRow)) {
        let number = self.number();
        let lanes = self.section.rows();
        let own = (self.row_number().wrapping_sub(self.section.row.lanes().first)) as usize;
        // Numbers fall one by one in nearly every section.
        let guess = own.wrapping_add_signed(number as isize);
        let center = if lanes.get(guess).is_some_and(|lane| lane.number() == 0) {
            guess
        } else {
            match lanes.binary_search_by(|lane| 0.cmp(&lane.number())) {
                Ok(center) => center,
                Err(_) => return,
            }
        };
        let steps = own.abs_diff(center);
        for step in 1..=steps {
            let row = if number > 0 { center.wrapping_sub(step) } else { center + step };
            let Some(row) = lanes.get(row) else { return };
            lane(row);
        }
    }

    /// Lane offsets of the layer that the lane is of.
    pub(crate) fn own_lane_offsets(&self) -> &'a [ArchivedCubicRow] {
        if self.is_temporary() {
            self.road.temporary_lane_offsets()
        } else {
            self.road.lane_offsets()
        }
    }

    /// Walks from lane 0 outwards: widths add up from the lane offset; a border stands for itself. Inner edge and outer edge, by what is
    /// read of records and what lies beside an edge by a sign and a width.
    #[inline(always)]
    fn add_up<T: Copy>(
        &self,
        read: impl Fn(&'a [ArchivedCubicRow]) -> T,
        beside: impl Fn(T, f64, T) -> T,
    ) -> [T; 2] {
        let mut edge = read(self.own_lane_offsets());
        let mut inner = edge;
        let sign = if self.number() > 0 { 1.0 } else { -1.0 };
        let cubics = self.map.tables().cubics;
        self.walk_outwards(|lane| {
            let record = read(lane.widths().of(cubics));
            let is_border = lane.flags() & lane_flags::BORDER != 0;
            inner = edge;
            edge = if is_border { record } else { beside(edge, sign, record) };
        });
        [inner, edge]
    }

    /// Both edges at a place.
    // There once, as the next one: many places ask.
    #[inline(never)]
    pub(crate) fn edges(&self, at: At) -> LaneEdges {
        let read = |records| profile::value(records, at);
        let beside = |edge, sign, width| edge + sign * if width > 0.0 { width } else { 0.0 };
        let [inner, outer] = self.add_up(read, beside);
        LaneEdges { inner, outer }
    }

    /// As [`Self::edges`], and whether no record that tells of them changes along s.
    #[inline(never)]
    pub(crate) fn edges_and_steady(&self, at: At) -> (LaneEdges, bool) {
        let read = |records| profile::value_and_steady(records, at);
        let [inner, outer] = self.add_up(read, beside);
        (LaneEdges { inner: inner.0, outer: outer.0 }, inner.1 && outer.1)
    }

    /// Both edges at s, where no record that tells of them begins within `margin` `[m]` of it, and whether none of those changes along s; none otherwise.
    #[inline]
    pub(crate) fn edges_apart(&self, s: f64, margin: f64) -> Option<(LaneEdges, bool)> {
        let read = |records| profile::apart_and_steady(records, s, margin);
        let [inner, outer] =
            self.add_up(read, |edge, sign, width| Some(beside(edge?, sign, width?)));
        let (inner, outer) = (inner?, outer?);
        Some((LaneEdges { inner: inner.0, outer: outer.0 }, inner.1 && outer.1))
    }

    /// The lane's centre at a place with both derivatives along s, the value and the first one as [`Self::edge_slopes`] has them.
    pub(crate) fn center_bend(&self, at: At) -> Bend {
        let read = |records| profile::bend(records, at);
        let beside = |edge: Bend, sign, width: Bend| {
            let own = if width.slope.value > 0.0 { width } else { closed_bend(width, at) };
            Bend {
                slope: Slope {
                    value: edge.slope.value + sign * own.slope.value,
                    derivative: edge.slope.derivative + sign * own.slope.derivative,
                },
                second: edge.second + sign * own.second,
            }
        };
        let [inner, outer] = self.add_up(read, beside);
        let edges = EdgeSlopes { inner: inner.slope, outer: outer.slope };
        Bend { slope: edges.center(), second: 0.5 * (inner.second + outer.second) }
    }

    /// Both edges at a place with their growth along s.
    #[inline(never)]
    pub(crate) fn edge_slopes(&self, at: At) -> EdgeSlopes {
        let read = |records| profile::slope(records, at);
        let beside = |edge: Slope, sign, width: Slope| {
            let own = if width.value > 0.0 { width } else { closed(width, at) };
            Slope {
                value: edge.value + sign * own.value,
                derivative: edge.derivative + sign * own.derivative,
            }
        };
        let [inner, outer] = self.add_up(read, beside);
        EdgeSlopes { inner, outer }
    }

    /// t of the outer edge at a place, with its growth along s, where it grows evenly from there to another s, by the records that hold at the place. None
    /// where it does not, or that is not plain.
    pub(crate) fn even_outer(&self, at: At, to: f64) -> Option<Slope> {
        let mut edge = profile::even(self.own_lane_offsets(), at)?;
        let sign = if self.number() > 0 { 1.0 } else { -1.0 };
        let cubics = self.map.tables().cubics;
        let mut is_even = true;
        self.walk_outwards(|lane| {
            let Some(record) = profile::even(lane.widths().of(cubics), at) else {
                is_even = false;
                return;
            };
            if lane.flags() & lane_flags::BORDER != 0 {
                edge = record;
                return;
            }
            let last = record.value + record.derivative * (to - at.s);
            if record.value > 0.0 && last > 0.0 {
                edge.value += sign * record.value;
                edge.derivative += sign * record.derivative;
            } else {
                // Nothing where it has no width all along; where it closes or opens on the way the edge has a corner.
                is_even &= record.value <= 0.0 && last <= 0.0;
            }
        });
        is_even.then_some(edge)
    }
}
