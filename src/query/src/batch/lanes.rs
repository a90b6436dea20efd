//! The nearest lanes to many points.

use super::tile::{Around, Cut, Tile};
use super::{BatchScratch, Places};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::map::Map;
use crate::nearest::{Best, Nearest, NearestOptions};
use crate::types::{Clamped, LanePosition, Point};
use glam::DVec2;
use mapd_geometry::normalize_angle;
use std::f64::consts::FRAC_PI_2;

/// Nearest lanes, a column for each part of [`Nearest`]; without a lane numbers are NaN, and `distance` is infinite.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearestLanes {
    /// The lane, if one is near enough.
    pub lane: Vec<Option<LaneId>>,
    /// Along the road's reference line `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub s: Vec<f64>,
    /// Lateral coordinate on the road `[m]`, positive to the left of the reference line.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub t: Vec<f64>,
    /// From the lane's centre `[m]`, positive to the left as its traffic goes.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub offset: Vec<f64>,
    /// Plan-view distance from the lane's area `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub distance: Vec<f64>,
    /// Height of the plane h = 0 at (s, t) `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub z: Vec<f64>,
    /// The way the lane's traffic goes at s and this offset `[rad]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub heading: Vec<f64>,
    /// Heading of the reference line at s `[rad]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub heading_of_reference_line: Vec<f64>,
    /// Whether the point lies before or after the lane's section.
    pub clamped: Vec<Clamped>,
}

impl NearestLanes {
    /// Answers for how many points there are.
    pub fn len(&self) -> usize {
        self.lane.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.lane.is_empty()
    }

    /// The answer for a point, by its number: what [`Map::nearest_lane`] gives.
    pub fn get(&self, i: usize) -> Option<Nearest> {
        let lane = (*self.lane.get(i)?)?;
        let position = LanePosition {
            s: *self.s.get(i)?,
            t: *self.t.get(i)?,
            offset: *self.offset.get(i)?,
            offset_of_reference_line: self.offset_of_reference_line(i)?,
            distance: *self.distance.get(i)?,
            z: *self.z.get(i)?,
            heading: *self.heading.get(i)?,
            heading_of_reference_line: *self.heading_of_reference_line.get(i)?,
            clamped: *self.clamped.get(i)?,
        };
        Some(Nearest { lane, position })
    }

    /// As [`LanePosition::offset_of_reference_line`], of a point by its number; NaN without a lane.
    pub fn offset_of_reference_line(&self, i: usize) -> Option<f64> {
        let turn = *self.heading.get(i)? - *self.heading_of_reference_line.get(i)?;
        let offset = *self.offset.get(i)?;
        // Traffic goes with the line or against it, at an angle of less than a right one.
        Some(if normalize_angle(turn).abs() <= FRAC_PI_2 { offset } else { -offset })
    }

    fn reset(&mut self, count: usize) {
        self.lane.clear();
        self.lane.resize(count, None);
        self.clamped.clear();
        self.clamped.resize(count, Clamped::No);
        self.distance.clear();
        self.distance.resize(count, f64::INFINITY);
        let rest = [
            &mut self.s,
            &mut self.t,
            &mut self.offset,
            &mut self.z,
            &mut self.heading,
            &mut self.heading_of_reference_line,
        ];
        for column in rest {
            column.clear();
            column.resize(count, f64::NAN);
        }
    }

    #[inline]
    fn set(&mut self, i: usize, found: &Nearest) {
        let at = &found.position;
        put(&mut self.lane, i, Some(found.lane));
        put(&mut self.s, i, at.s);
        put(&mut self.t, i, at.t);
        put(&mut self.offset, i, at.offset);
        put(&mut self.distance, i, at.distance);
        put(&mut self.z, i, at.z);
        put(&mut self.heading, i, at.heading);
        put(&mut self.heading_of_reference_line, i, at.heading_of_reference_line);
        put(&mut self.clamped, i, at.clamped);
    }
}

#[inline]
fn put<T>(column: &mut [T], i: usize, value: T) {
    if let Some(place) = column.get_mut(i) {
        *place = value;
    }
}

impl Map<'_> {
    /// [`Map::nearest_lane`] of many points, in their order, bit for bit: for thousands of particles. Points near each other, in
    /// whatever order, cost a fraction of single calls. Headings, where the places have them, stand for the options' heading. `out` is emptied first;
    /// it and `scratch` grow only if they are too small.
    ///
    /// Errors: a column that is not as long as the others, by its name; coordinates that are not finite, by the number of the
    /// point; options that are not finite.
    pub fn nearest_lanes(
        &self,
        places: Places<'_>,
        options: &NearestOptions,
        scratch: &mut BatchScratch,
        out: &mut NearestLanes,
    ) -> Result<(), QueryError> {
        out.reset(0);
        places.check()?;
        options.check(Point::from(DVec2::ZERO))?;
        out.reset(places.len());
        let (origin, xy) = (self.origin(), |i| places.xy(i));
        let (mut tile, mut own) = (Tile::new(*self), *options);
        let mut last = None;
        scratch.order.each_part(places.len(), xy, |part| {
            let mut from = 0;
            while from < part.len() {
                let cut = Cut::first(part, from, xy);
                let is_tile = tile.fill(&cut, options.types);
                for i in part.numbers(from, cut.count) {
                    let point = places.point(i);
                    let local = point.xy - origin;
                    own.heading = places.heading(i).or(options.heading);
                    let around = match is_tile {
                        true => tile.around(point, local, &own),
                        false => {
                            let mut best = Best::default();
                            self.lane_around(&mut best, point, local, &own);
                            Around::Open(best)
                        }
                    };
                    let found = match around {
                        Around::Held(found) => Some(found),
                        Around::Open(mut best) => {
                            // The last point lies near this one: it changes the cost alone.
                            own.hint = last.and_then(|last| out.get(last)).or(options.hint);
                            self.nearest_of(&mut best, point, local, &own)
                        }
                    };
                    if let Some(found) = found {
                        out.set(i, &found);
                        last = Some(i);
                    }
                }
                from += cut.count;
            }
            Ok(())
        })
    }
}
