//! A stretch of a lane with the records that hold in it looked up once, for many places in it.

use crate::area::{Cross, Slab};
use crate::lane::Lane;
use crate::profile::{self, At, Record};
use crate::types::LaneEdges;
use mapd_archive::{ArchivedLaneRow, lane_flags};

/// Lanes from lane 0 outwards that are kept; stretches farther out are not made ready.
const MOST_LANES: usize = 8;

/// The records of a stretch.
pub(crate) struct Ready {
    offset: Record,
    /// Widths or borders of the lanes from lane 0 outwards.
    lanes: [Record; MOST_LANES],
    count: usize,
    /// Which of them are borders, as bits.
    borders: u32,
    /// 1 to the left of lane 0, −1 to the right.
    side: f64,
    elevation: Record,
    superelevation: Record,
    /// Whether the edges keep their t along s.
    is_steady: bool,
}

impl Ready {
    /// None for a lane too far out.
    pub(crate) fn new(lane: &Lane<'_>, slab: &Slab<'_>) -> Option<Self> {
        let (at, road) = (slab.at(slab.s_lo), lane.road);
        let cubics = lane.map.tables().cubics;
        let mut ready = Self {
            offset: profile::held(road.lane_offsets(), at),
            lanes: [Record::NONE; MOST_LANES],
            count: 0,
            borders: 0,
            side: if lane.number() > 0 { 1.0 } else { -1.0 },
            elevation: profile::held(road.elevations(), at),
            superelevation: profile::held(road.superelevations(), at),
            is_steady: false,
        };
        ready.is_steady = lane.edges_and_steady(at).1;
        let mut fits = true;
        lane.walk_outwards(|row: &ArchivedLaneRow| {
            let Some(place) = ready.lanes.get_mut(ready.count) else {
                fits = false;
                return;
            };
            *place = profile::held(row.widths().of(cubics), at);
            ready.borders |= u32::from(row.flags() & lane_flags::BORDER != 0) << ready.count;
            ready.count += 1;
        });
        fits.then_some(ready)
    }

    /// Height of the reference line `[m]`.
    #[inline]
    pub(crate) fn elevation(&self, s: f64) -> f64 {
        self.elevation.value(s)
    }
}

impl Cross for Ready {
    #[inline]
    fn roll(&self, at: At) -> (f64, f64) {
        profile::roll(self.superelevation.value(at.s))
    }

    /// As [`Lane::edge_slopes`] adds up.
    #[inline]
    fn edges(&self, at: At) -> (LaneEdges, bool) {
        let mut outer = self.offset.value(at.s);
        let mut inner = outer;
        for (k, lane) in self.lanes.iter().take(self.count).enumerate() {
            let value = lane.value(at.s);
            inner = outer;
            outer = if self.borders & 1 << k != 0 {
                value
            } else {
                outer + self.side * if value > 0.0 { value } else { 0.0 }
            };
        }
        (LaneEdges { inner, outer }, self.is_steady)
    }
}
