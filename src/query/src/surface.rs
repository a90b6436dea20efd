//! The road's surface: where it lies, how it is inclined and what it is made of.

use crate::error::QueryError;
use crate::grid;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::profile::{self, At, Slope};
use crate::road::{JOINT, Road};
use crate::types::{Clamped, is_coordinate};
use glam::{DVec2, DVec3};
use mapd_archive::{
    ArchivedCubicRow, ArchivedShapeStationRow, ArchivedSurfaceRow, ArchivedSurfaceStripRow, Range,
    lane_flags, string,
};
use mapd_geometry::surface::{self, Along, Height, LaneRise, Station, StripProfile};
use mapd_geometry::{Cubic, clamp};

/// A point of the road's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Surface<'a> {
    /// Inertial position `[m]`.
    pub position: DVec3,
    /// Unit normal, upwards.
    pub normal: DVec3,
    /// The lane there; `None` beside all lanes.
    pub lane: Option<LaneId>,
    /// What the lane is made of, where the map says so.
    pub material: Option<Material<'a>>,
    /// Whether s lay outside the road and was moved to its nearer end.
    pub clamped: Clamped,
}

/// A `lane/material` record.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Material<'a> {
    /// Start on the road `[m]`.
    pub s: f64,
    /// Surface code as written; its meaning is the map maker's.
    pub surface: &'a str,
    /// Friction coefficient.
    pub friction: Option<f64>,
    /// Roughness as written.
    pub roughness: Option<f64>,
}

/// What a lane lies above the road's surface.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneHeight {
    /// At the edge nearer to lane 0 `[m]`.
    pub inner: f64,
    /// At the edge away from lane 0 `[m]`.
    pub outer: f64,
}

/// A point with its derivatives by s and t.
#[derive(Clone, Copy, Debug)]
struct Patch {
    position: DVec3,
    by_s: DVec3,
    by_t: DVec3,
}

impl Patch {
    /// Unit normal, upwards.
    fn normal(&self) -> DVec3 {
        self.by_s.cross(self.by_t).normalize_or(DVec3::Z)
    }

    /// Slopes by x and y of a height whose slopes by s and t are known.
    fn slope_of(&self, height: Height) -> DVec2 {
        let (s, t) = (self.by_s.truncate(), self.by_t.truncate());
        let area = s.perp_dot(t);
        if area == 0.0 {
            return DVec2::ZERO;
        }
        DVec2::new(height.by_s * t.y - height.by_t * s.y, height.by_t * s.x - height.by_s * t.x)
            / area
    }
}

/// Slopes of z by x and y where the normal is this.
fn slope_of(normal: DVec3) -> DVec2 {
    -normal.truncate() / normal.z
}

/// The unit normal, upwards, where z has these slopes by x and y.
fn normal_of(slope: DVec2) -> DVec3 {
    (-slope).extend(1.0).normalize_or(DVec3::Z)
}

/// The frame of the reference line at an s (see [`Road::to_inertial`]): origin, axes and their derivatives by s.
struct FrenetFrame {
    origin: DVec3,
    origin_by_s: DVec3,
    tangent: DVec3,
    lateral: DVec3,
    curvature: f64,
    roll: (f64, f64),
    roll_by_s: f64,
}

impl FrenetFrame {
    /// The point at t and a height above the rolled plane. With T the tangent, N the rolled lateral axis, U its normal:
    /// N′ = −κ cos σ T + σ′ U and U′ = κ sin σ T − σ′ N.
    fn patch(&self, t: f64, height: Height) -> Patch {
        let (cos, sin) = self.roll;
        let n = self.lateral * cos + DVec3::Z * sin;
        let u = self.lateral * -sin + DVec3::Z * cos;
        let n_by_s = self.tangent * (-self.curvature * cos) + u * self.roll_by_s;
        let u_by_s = self.tangent * (self.curvature * sin) - n * self.roll_by_s;
        Patch {
            position: self.origin + n * t + u * height.h,
            by_s: self.origin_by_s + n_by_s * t + u * height.by_s + u_by_s * height.h,
            by_t: n + u * height.by_t,
        }
    }

    /// As [`Self::patch`] up to `edge`, and horizontally from there to t.
    fn level_patch(&self, edge: Slope, at_edge: Height, t: f64, rise: Height) -> Patch {
        let start = self.patch(edge.value, at_edge);
        let beyond = t - edge.value;
        let along_edge = start.by_s + start.by_t * edge.derivative;
        Patch {
            position: start.position + self.lateral * beyond + DVec3::Z * rise.h,
            by_s: along_edge
                - self.lateral * edge.derivative
                - self.tangent * (self.curvature * beyond)
                + DVec3::Z * rise.by_s,
            by_t: self.lateral + DVec3::Z * rise.by_t,
        }
    }
}

impl<'a> Road<'a> {
    /// The surface at (s, t): elevation and superelevation with lateral shape, crossfall (OpenDRIVE 1.4, 1.5) or
    /// cross-section surface, lane heights, level lanes, and in a junction its elevation grid (OpenDRIVE 1.8.1, 10.5,
    /// 10.6, 11.7.4, 12.8). s beyond the reference line is moved to its end and flagged.
    ///
    /// Heights above the plane h = 0 are measured along its normal; from a level lane's inner edge outwards the surface
    /// keeps that edge's height. Beside all lanes the lateral profiles go on.
    ///
    /// Errors: coordinates that are not finite, or a t beyond 10⁹ m; a damaged archive.
    pub fn surface_at(&self, s: f64, t: f64) -> Result<Surface<'a>, QueryError> {
        self.surface_on(s, t, None)
    }

    /// As [`Self::surface_at`] on a lane that is known to hold the place, which then is not looked for.
    pub(crate) fn surface_on(
        &self,
        s: f64,
        t: f64,
        lane: Option<Lane<'a>>,
    ) -> Result<Surface<'a>, QueryError> {
        if !(s.is_finite() && is_coordinate(t)) {
            return Err(QueryError::NotFinite);
        }
        let end = self.reference_end().max(0.0);
        let inside = clamp(s, 0.0, end);
        let at = At::new(inside);
        let frame = self.frame(at)?;
        let lane = lane.or_else(|| self.lane_at(inside, t));
        let rise = lane.map_or_else(Height::default, |lane| rise(&lane, at, t));
        let profile = self.row_of_surface();
        let height =
            |t: f64| profile.map_or_else(Height::default, |row| lateral(&self.map, row, at, t));
        let grid = self.grid();
        // A grid replaces everything but what the lane itself adds, which then counts along z.
        let (below, above) =
            if grid.is_some() { (Height::default(), rise) } else { (rise, Height::default()) };
        let patch = match self.level_edge(inside, at, t) {
            Some(edge) => frame.level_patch(edge, height(edge.value), t, below),
            None => frame.patch(t, height(t) + below),
        };
        let (mut position, mut normal) = (patch.position, patch.normal());
        if let Some(row) = grid {
            let slope;
            (position, slope) = grid::replace(&self.map, row, position, slope_of(normal));
            position.z += above.h;
            normal = normal_of(slope + patch.slope_of(above));
        }
        let origin = self.map.origin();
        Ok(Surface {
            position: position + origin.extend(0.0),
            normal,
            lane: lane.map(|lane| lane.lane_id()),
            material: lane.and_then(|lane| lane.material_at(inside)),
            clamped: Clamped::of(s, 0.0, end + JOINT),
        })
    }

    fn frame(&self, at: At) -> Result<FrenetFrame, QueryError> {
        let point = self.reference_at(at).ok_or(QueryError::Corrupt)?;
        let elevation = self.elevation_slope(at);
        let tangent = DVec3::new(point.cos, point.sin, 0.0);
        Ok(FrenetFrame {
            origin: DVec3::new(point.x, point.y, elevation.value),
            origin_by_s: tangent + DVec3::Z * elevation.derivative,
            tangent,
            lateral: DVec3::new(-point.sin, point.cos, 0.0),
            curvature: point.curvature,
            roll: self.roll(at),
            roll_by_s: self.superelevation_slope(at),
        })
    }

    fn row_of_surface(&self) -> Option<&'a ArchivedSurfaceRow> {
        let rows = self.map.tables().surfaces;
        let number = self.road_id().row();
        rows.binary_search_by(|row| row.road().cmp(&number)).ok().and_then(|i| rows.get(i))
    }

    fn grid(&self) -> Option<&'a mapd_archive::ArchivedElevationGridRow> {
        grid::of_junction(&self.map, self.junction_row()?)
    }

    /// The inner edge of the first level lane on t's side, if t lies beyond it.
    fn level_edge(&self, s: f64, at: At, t: f64) -> Option<Slope> {
        let section = self.section_at(s)?;
        let left = t > self.lane_offset_at(s);
        let level = section
            .lanes()
            .filter(|lane| lane.row.flags() & lane_flags::LEVEL != 0)
            .filter(|lane| if left { lane.number() > 0 } else { lane.number() < 0 })
            .min_by_key(|lane| lane.number().unsigned_abs())?;
        let edge = level.edge_slopes(at).inner;
        let beyond = if left { t > edge.value } else { t < edge.value };
        beyond.then_some(edge)
    }

    /// The lane that covers t at s.
    fn lane_at(&self, s: f64, t: f64) -> Option<Lane<'a>> {
        self.section_at(s)?.lane_at(s, t)
    }
}

impl<'a> Lane<'a> {
    /// The `material` record that holds at s.
    pub fn material_at(&self, s: f64) -> Option<Material<'a>> {
        let tables = self.map.tables();
        let rows = tables.lane_materials;
        let number = self.lane_id().row();
        let after = rows
            .partition_point(|row| row.lane() < number || (row.lane() == number && row.s() <= s));
        let row = rows.get(after.checked_sub(1)?).filter(|row| row.lane() == number)?;
        let given = |value: f64| (value >= 0.0).then_some(value);
        Some(Material {
            s: row.s(),
            surface: string(tables, row.surface()),
            friction: given(row.friction()),
            roughness: given(row.roughness()),
        })
    }

    /// What the lane lies above the road's surface at s. Of an s that is not finite: NaN.
    pub fn height_at(&self, s: f64) -> LaneHeight {
        let LaneRise { inner, outer } = match s.is_finite() {
            true => self.rise_at(s),
            false => LaneRise { inner: f64::NAN, outer: f64::NAN },
        };
        LaneHeight { inner, outer }
    }

    fn rise_at(&self, s: f64) -> LaneRise {
        let rows = self.map.tables().lane_heights;
        let number = self.lane_id().row();
        let after = rows
            .partition_point(|row| row.lane() < number || (row.lane() == number && row.s() <= s));
        let row = after.checked_sub(1).and_then(|i| rows.get(i)).filter(|row| row.lane() == number);
        row.map_or_else(LaneRise::default, |row| LaneRise {
            inner: row.inner(),
            outer: row.outer(),
        })
    }
}

fn rise(lane: &Lane<'_>, at: At, t: f64) -> Height {
    let rise = lane.rise_at(at.hold);
    if rise == LaneRise::default() {
        return Height::default();
    }
    let edges = lane.edge_slopes(at);
    surface::lane_height(rise, along(edges.inner), along(edges.outer), t)
}

fn along(slope: Slope) -> Along {
    Along { value: slope.value, by_s: slope.derivative }
}

/// Height of the lateral profiles above the plane h = 0.
fn lateral(map: &Map<'_>, row: &ArchivedSurfaceRow, at: At, t: f64) -> Height {
    let tables = map.tables();
    let over_s = |range: Range| along(profile::slope(range.of(tables.cubics), at));
    let shape = shape(map, row.shapes().of(tables.shape_stations), at, t);
    let side = if t < 0.0 { row.crossfall_right() } else { row.crossfall_left() };
    let crossfall = if side.of(tables.cubics).is_empty() {
        Height::default()
    } else {
        surface::crossfall(over_s(side), t)
    };
    let strips = row.strips().of(tables.surface_strips);
    if strips.is_empty() {
        return shape + crossfall;
    }
    let offset = over_s(row.strip_offset());
    let side = if t < offset.value { -1 } else { 1 };
    let strip = |number: i32| {
        let row: &ArchivedSurfaceStripRow = strips.iter().find(|row| row.id() == side * number)?;
        Some(StripProfile {
            width: (row.width().count > 0).then(|| over_s(row.width())),
            coefficients: [row.constant(), row.linear(), row.quadratic(), row.cubic()].map(over_s),
            relative: row.mode() == 1,
        })
    };
    shape + crossfall + surface::strip_heights(offset, strip(1), strip(2), t)
}

/// Height of the lateral shape.
fn shape(map: &Map<'_>, stations: &[ArchivedShapeStationRow], at: At, t: f64) -> Height {
    let station = |i: usize| -> Option<Station> {
        let row = stations.get(i)?;
        let records: &[ArchivedCubicRow] = row.records().of(map.tables().cubics);
        let after = records.partition_point(|record| record.s() <= t);
        let record = records.get(after.saturating_sub(1))?;
        let cubic = Cubic { a: record.a(), b: record.b(), c: record.c(), d: record.d() };
        Some(Station { s: row.s(), t: record.s(), cubic })
    };
    let after = stations.partition_point(|row| row.s() <= at.hold);
    match station(after.saturating_sub(1)) {
        Some(before) => surface::shape(before, station(after.max(1)), at.s, t),
        None => Height::default(),
    }
}
