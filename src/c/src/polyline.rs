//! Centre lines and borders as they are stored.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::List;
use crate::lookup::lane_of;
use crate::point::mapd_vec3;
use crate::snapshot::mapd_snapshot;

/// `line` of `mapd_lane_line`: the centre line. Empty for lane 0.
pub const MAPD_LINE_CENTER: u32 = 0;
/// `line` of `mapd_lane_line`: the border on the left of the lane's traffic.
pub const MAPD_LINE_LEFT: u32 = 1;
/// `line` of `mapd_lane_line`: the border on the right of the lane's traffic.
pub const MAPD_LINE_RIGHT: u32 = 2;
/// `line` of `mapd_lane_line`: the border away from lane 0; for lane 0 the shifted reference line.
pub const MAPD_LINE_BORDER: u32 = 3;

/// A point of a polyline.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_line_point {
    /// On the road \[m\]. Points of equal s are both sides of a jump.
    pub s: f64,
    /// Inertial position \[m\].
    pub position: mapd_vec3,
}

/// Points of a lane's centre line or of one of its borders, in ascending s: a polyline of bounded error, as it is stored. `line` is
/// a `MAPD_LINE_…`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown line.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_line(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    line: u32,
    out: *mut mapd_line_point,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            let line = match line {
                MAPD_LINE_CENTER => lane.center_line(),
                MAPD_LINE_LEFT => lane.left_bound(),
                MAPD_LINE_RIGHT => lane.right_bound(),
                MAPD_LINE_BORDER => lane.border(),
                _ => return Err(Failure::argument(format!("{line} is no line"))),
            };
            let points = line.points();
            let points = points.map(|at| mapd_line_point { s: at.s, position: at.position.into() });
            List { out, capacity, count }.write(points)
        })
    }
}
