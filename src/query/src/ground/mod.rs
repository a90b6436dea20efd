//! The ground below a place: the surface of the lane that holds it, on the level that a height says.

mod stance;

pub use stance::Stance;

use crate::error::QueryError;
use crate::ids::LaneId;
use crate::map::Map;
use crate::nearest::{Nearest, NearestOptions};
use crate::surface::Material;
use crate::types::Point;
use glam::DVec3;

/// Heights `[m]` that are farther apart than this are levels of their own: no vehicle fits between nearer ones, and kerbs and
/// the lanes of one junction differ by less.
const LEVEL_GAP: f64 = 2.0;

/// The ground at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ground<'a> {
    /// Height of the surface at the place `[m]`.
    pub z: f64,
    /// Unit normal of the surface, upwards.
    pub normal: DVec3,
    /// The lane that holds the place.
    pub lane: LaneId,
    /// Along its road `[m]`.
    pub s: f64,
    /// Lateral on its road `[m]`.
    pub t: f64,
    /// What the lane is made of, where the map says so.
    pub material: Option<Material<'a>>,
    /// Which level this is, the lowest one 0.
    pub level: u32,
    /// How many levels of lanes there are at the place.
    pub levels: u32,
}

/// Room to work in; used again, it does not allocate.
#[derive(Clone, Debug, Default)]
pub struct GroundScratch {
    near: Vec<Nearest>,
    /// Height, and which of `near` it is of.
    heights: Vec<(f64, usize)>,
}

impl GroundScratch {
    /// Room for places that lie on this many lanes at once.
    pub fn with_capacity(lanes: usize) -> Self {
        Self { near: Vec::with_capacity(lanes), heights: Vec::with_capacity(lanes) }
    }
}

impl<'a> Map<'a> {
    /// The ground at a place, on the level whose height is nearest to the point's z. A point without z is on the lowest level with an expected lane, such as the one
    /// that the vehicle was in and those that it can reach from there ([`Map::reachable`]); with none of them, on the lowest one. `None` beside all
    /// lanes. Of several lanes of a level (they overlap in junctions) it is that of an expected one, then of the one in whose middle the place lies
    /// most, then by key, as [`Map::nearest_lane`] has it.
    ///
    /// Heights that are more than 2 m apart are levels of their own, as those of a bridge and the road below it.
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    pub fn ground_at(
        &self,
        point: impl Into<Point>,
        expected: &[LaneId],
        scratch: &mut GroundScratch,
    ) -> Result<Option<Ground<'a>>, QueryError> {
        self.ground_of_place(point.into(), expected, scratch)
    }

    /// As [`Map::ground_at`], whose code would else be there for each form of a point.
    fn ground_of_place(
        &self,
        point: Point,
        expected: &[LaneId],
        scratch: &mut GroundScratch,
    ) -> Result<Option<Ground<'a>>, QueryError> {
        if !point.is_place() {
            return Err(QueryError::NotFinite);
        }
        let GroundScratch { near, heights } = scratch;
        let options = NearestOptions { radius: 0.0, ..NearestOptions::default() };
        self.lanes_near(point.xy, &options, near)?;
        heights.clear();
        for (i, found) in near.iter().enumerate() {
            heights.push((self.ground_of(found, point)?.z, i));
        }
        heights.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let ends_below = |i: usize| i == 0 || heights[i].0 - heights[i - 1].0 > LEVEL_GAP;
        let levels = (0..heights.len()).filter(|i| ends_below(*i)).count() as u32;
        let is_expected =
            |i: usize| near.get(i).is_some_and(|found| expected.contains(&found.lane));
        let nearest = match point.z {
            Some(z) => nearest_height(heights, z),
            None => heights.iter().position(|(_, i)| is_expected(*i)).or(Some(0)),
        };
        let Some(nearest) = nearest else { return Ok(None) };
        let first = (0..=nearest).rev().find(|i| ends_below(*i)).unwrap_or(0);
        let level = (1..=first).filter(|i| ends_below(*i)).count() as u32;
        let after = (first + 1..heights.len()).find(|i| ends_below(*i)).unwrap_or(heights.len());
        // Lanes near a point come in the order that is preferred.
        let level_lanes = heights.get(first..after).unwrap_or_default().iter().map(|(_, i)| *i);
        let best = level_lanes.min_by_key(|i| (!is_expected(*i), *i));
        let Some(found) = best.and_then(|i| near.get(i)) else { return Ok(None) };
        Ok(Some(Ground { level, levels, ..self.ground_of(found, point)? }))
    }

    /// [`Map::ground_at`] of many places, in their order. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: coordinates that are not finite, by the number of the place; a damaged archive.
    pub fn ground_below(
        &self,
        points: &[Point],
        expected: &[LaneId],
        scratch: &mut GroundScratch,
        out: &mut Vec<Option<Ground<'a>>>,
    ) -> Result<(), QueryError> {
        out.clear();
        for (i, point) in points.iter().enumerate() {
            let ground = self.ground_at(*point, expected, scratch).map_err(|error| error.at(i))?;
            out.push(ground);
        }
        Ok(())
    }

    /// The surface of a lane that holds a point, at the point.
    fn ground_of(&self, found: &Nearest, point: Point) -> Result<Ground<'a>, QueryError> {
        let lane = self.lane(found.lane)?;
        let (s, t) = (found.position.s, found.position.t);
        let surface = lane.road().surface_at(s, t)?;
        // What lies above a banked plane is shifted sideways: from there on along the surface's own slope.
        let away = point.xy - surface.position.truncate();
        let rise = match surface.normal.z {
            0.0 => 0.0,
            up => -surface.normal.truncate().dot(away) / up,
        };
        Ok(Ground {
            z: surface.position.z + rise,
            normal: surface.normal,
            lane: found.lane,
            s,
            t,
            material: lane.material_at(s),
            level: 0,
            levels: 1,
        })
    }
}

/// The place of the height that is nearest to z, of equal ones the lower.
fn nearest_height(heights: &[(f64, usize)], z: f64) -> Option<usize> {
    let away = |i: &usize| (heights[*i].0 - z).abs();
    (0..heights.len()).min_by(|a, b| away(a).total_cmp(&away(b)))
}
