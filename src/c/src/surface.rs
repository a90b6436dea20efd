//! The road's surface.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_road_id};
use crate::list::{finite, put, put_some};
use crate::lookup::{junction_of, lane_of, road_of};
use crate::point::{clamped_code, mapd_vec2, mapd_vec3};
use crate::snapshot::mapd_snapshot;
use crate::text::mapd_text;
use mapd_client::QueryError;
use mapd_client::junctions::GridHeight;
use mapd_client::roads::Material;

/// What a lane is made of.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_material {
    /// Start on the road \[m\].
    pub s: f64,
    /// Surface code as written; its meaning is the map maker's.
    pub surface: mapd_text,
    /// Friction coefficient; negative where not given.
    pub friction: f64,
    /// Roughness as written; negative where not given.
    pub roughness: f64,
}

/// A point of the road's surface.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_surface {
    /// Inertial position \[m\].
    pub position: mapd_vec3,
    /// Unit normal, upwards.
    pub normal: mapd_vec3,
    /// The lane there, if any.
    pub lane: mapd_lane_id,
    /// What the lane is made of; counts only with `has_material`.
    pub material: mapd_material,
    /// 1: the map says what the lane is made of.
    pub has_material: u8,
    /// Whether s lay outside the road and was moved to its nearer end.
    pub clamped: u8,
}

/// What a lane lies above the road's surface \[m\].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_height {
    /// At the edge nearer to lane 0.
    pub inner: f64,
    /// At the edge away from lane 0.
    pub outer: f64,
}

/// Height of a junction's elevation grid.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_grid_height {
    /// Inertial \[m\].
    pub z: f64,
    /// Slope by x.
    pub by_x: f64,
    /// Slope by y.
    pub by_y: f64,
}

/// What stands where the map does not say what a lane is made of.
pub(crate) fn material_or_none(one: Option<Material<'_>>) -> mapd_material {
    material(one.unwrap_or(Material { s: 0.0, surface: "", friction: None, roughness: None }))
}

fn material(one: Material<'_>) -> mapd_material {
    mapd_material {
        s: one.s,
        surface: one.surface.into(),
        friction: one.friction.unwrap_or(-1.0),
        roughness: one.roughness.unwrap_or(-1.0),
    }
}

/// The surface at (s, t), with lateral shape, crossfall or cross-section surface, lane heights, and in a junction its elevation grid. s beyond
/// the reference line is moved to its end and flagged.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_surface_at(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    t: f64,
    out: *mut mapd_surface,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let surface = road_of(snapshot, road)?.surface_at(s, t)?;
            put(
                out,
                mapd_surface {
                    position: surface.position.into(),
                    normal: surface.normal.into(),
                    lane: surface.lane.into(),
                    material: material_or_none(surface.material),
                    has_material: surface.material.is_some().into(),
                    clamped: clamped_code(surface.clamped),
                },
            )
        })
    }
}

/// What a lane lies above the road's surface at s.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_height_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_lane_height,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let height = lane_of(snapshot, lane)?.height_at(finite(s)?);
            put(out, mapd_lane_height { inner: height.inner, outer: height.outer })
        })
    }
}

/// What a lane is made of at s. `MAPD_CODE_NONE` where the map does not say.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_material_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_material,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            put_some(out, lane_of(snapshot, lane)?.material_at(finite(s)?).map(material))
        })
    }
}

/// Height of a junction's elevation grid at a point in plan view, its edge held beyond it. `MAPD_CODE_NONE` without a grid.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_grid_height_at(
    snapshot: *const mapd_snapshot,
    junction: mapd_junction_id,
    point: mapd_vec2,
    out: *mut mapd_grid_height,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            if !(point.x.is_finite() && point.y.is_finite()) {
                return Err(QueryError::NotFinite.into());
            }
            let height = junction_of(snapshot, junction)?.grid_height_at(point.into());
            let of = |grid: GridHeight| mapd_grid_height {
                z: grid.height,
                by_x: grid.slope.x,
                by_y: grid.slope.y,
            };
            put_some(out, height.map(of))
        })
    }
}
