//! Repeated objects: instances at distances, or one shape swept along the road (OpenDRIVE 1.8.1, 13.4).

use super::line::Line;
use super::outline::point;
use super::place::stand_at;
use super::{Copy, Shape};
use crate::draft::{Object, Repeat, linear, shape, single};
use crate::sample::{Fault, Sample, flatten};
use glam::DVec3;
use mapd_archive::{
    NONE, ObjectCopyRow, ObjectOutlineRow, ObjectPointRow, ObjectShape, Range, copy_flags,
    object_flags, outline_flags,
};
use mapd_geometry::{atan2, normalize_angle};

/// Copies that one `repeat` makes at most: a post every metre of 100 km.
pub(crate) const MOST_COPIES: usize = 100_000;
/// Copies of all objects of a map: some 180 MB of table.
pub(crate) const MOST_COPIES_OF_A_MAP: usize = 2_000_000;
/// A last copy that lies beyond the repetition's end or the road's by no more than this `[m]` counts: written numbers are
/// rounded.
const END: f64 = 1e-6;

/// What is left out of a repetition.
pub(super) enum LeftOutCopies {
    /// Some of it or all, and why.
    Out(String),
    /// All, because its edges would have too many points.
    TooManyPoints,
}

impl From<Fault> for LeftOutCopies {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::NotFinite => Self::out(
                "the repetition's places are not numbers, or farther away than a map can be; it is left out",
            ),
            Fault::TooManyPoints => Self::TooManyPoints,
        }
    }
}

impl LeftOutCopies {
    fn out(message: &str) -> Self {
        Self::Out(message.to_owned())
    }
}

/// Copies that a repetition asks for, by its numbers alone: those beyond the line's end and beyond [`MOST_COPIES`] are not
/// counted.
pub(super) fn count(line: &Line<'_>, repeat: &Repeat) -> usize {
    if !begins_on(line.end(), repeat) {
        return 0;
    }
    if repeat.distance <= 0.0 {
        return 1;
    }
    let intervals = intervals(line.end(), repeat);
    if intervals < MOST_COPIES as f64 { intervals as usize + 1 } else { MOST_COPIES }
}

fn begins_on(road_end: f64, repeat: &Repeat) -> bool {
    repeat.s >= -END && repeat.s <= road_end + END
}

/// Distances between copies that fit on the line.
fn intervals(road_end: f64, repeat: &Repeat) -> f64 {
    let end = (repeat.s + repeat.length).min(road_end);
    ((end - repeat.s + END) / repeat.distance).floor().max(0.0)
}

/// What limits a repetition's copies.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// Tolerance of what is swept along the road `[m]`.
    pub(super) tolerance: f64,
    /// Copies at most.
    pub(super) copies: usize,
}

/// Adds the copies that a repetition makes on the road; what would stand beyond its end is left out.
///
/// Errors: why some of them or all are left out, but for want of room.
pub(super) fn copies(
    line: &Line<'_>,
    object: &Object,
    repeat: &Repeat,
    bounds: Bounds,
    out: &mut Vec<Copy>,
) -> Result<(), LeftOutCopies> {
    let road_end = line.end();
    let end = (repeat.s + repeat.length).min(road_end);
    if !begins_on(road_end, repeat) {
        return Err(LeftOutCopies::Out(format!(
            "the repetition begins at s = {}, the road ends at {road_end}; it is left out",
            repeat.s
        )));
    }
    let count = count(line, repeat).min(bounds.copies);
    if repeat.distance <= 0.0 {
        if count == 0 {
            return Ok(());
        }
        let swept = if repeat.is_detached {
            straight(line, repeat, end).ok_or(Fault::NotFinite)
        } else {
            sweep(line, repeat, end, bounds.tolerance)
        };
        out.push(swept?);
        return Ok(());
    }
    for i in 0..count {
        let ds = i as f64 * repeat.distance;
        let copy = instance(line, object, repeat, ds);
        let why = "a repetition's place is no number; the others are left out";
        out.push(copy.ok_or_else(|| LeftOutCopies::out(why))?);
    }
    let wanted = intervals(road_end, repeat);
    if wanted >= MOST_COPIES as f64 {
        return Err(LeftOutCopies::Out(format!(
            "the object is repeated {wanted:.0} times; those after {MOST_COPIES} are left out"
        )));
    }
    Ok(())
}

/// Position on the straight line between both ends of a repetition, and its heading; z is that of the line.
fn detached(line: &Line<'_>, repeat: &Repeat, ds: f64) -> Option<(DVec3, f64)> {
    let at = |ds: f64| Some(line.at(repeat.s + ds, repeat.t.at(ds, repeat.length))?.position);
    let (start, end) = (at(0.0)?, at(repeat.length)?);
    let along = end - start;
    let heading = atan2(along.y, along.x);
    let share = if repeat.length > 0.0 { ds / repeat.length } else { 0.0 };
    Some((start + along * share, heading))
}

/// The copy at a distance from the repetition's start.
fn instance(line: &Line<'_>, object: &Object, repeat: &Repeat, ds: f64) -> Option<Copy> {
    let (s, t) = (repeat.s + ds, repeat.t.at(ds, repeat.length));
    let value = |pair| linear(pair, ds, repeat.length);
    let mut station = line.at(s, t)?;
    if repeat.is_detached {
        (station.position, station.heading) = detached(line, repeat, ds)?;
    }
    let is_perpendicular = object.row.flags & object_flags::PERPENDICULAR != 0;
    let z_offset = value(repeat.z_offset);
    let standing = stand_at(&station, z_offset, object.angles, is_perpendicular)?;
    let [length, width, radius] = [repeat.length_of_copy, repeat.width, repeat.radius]
        .map(|pair| single(value(pair)).max(0.0));
    let shape = if object.outlines.is_empty() {
        shape([length, width, radius])
    } else {
        ObjectShape::Outlines
    };
    let (x, y, z) = standing.origin.into();
    let row = ObjectCopyRow {
        x,
        y,
        z,
        s,
        t,
        heading: standing.angles[0],
        pitch: single(standing.angles[1]),
        roll: single(standing.angles[2]),
        length,
        width,
        height: single(value(repeat.height)),
        radius,
        object: 0,
        outlines: Range::default(),
        shape: shape.code(),
        flags: 0,
        reserved: 0,
    };
    Some(Copy { row, shape: None })
}

/// The width of what is swept `[m]`: that of a round object is its diameter.
fn width(repeat: &Repeat, ds: f64) -> f64 {
    let value = |pair| linear(pair, ds, repeat.length).max(0.0);
    let width = value(repeat.width);
    if width > 0.0 { width } else { 2.0 * value(repeat.radius) }
}

/// The area that the object covers along the reference line up to `end`.
fn sweep(line: &Line<'_>, repeat: &Repeat, end: f64, tolerance: f64) -> Result<Copy, Fault> {
    let breaks = line.breaks(repeat.s, end.max(repeat.s));
    let breaks = if breaks.len() > 1 { breaks } else { vec![repeat.s; 2] };
    let edge = |side: f64| {
        let mut at = |s: f64| {
            let ds = s - repeat.s;
            let t = repeat.t.at(ds, repeat.length) + 0.5 * side * width(repeat, ds);
            let z_offset = linear(repeat.z_offset, ds, repeat.length);
            let p = line.at(s, t)?.position + DVec3::Z * z_offset;
            p.is_finite().then_some(p)
        };
        let mut samples = Vec::new();
        flatten(&breaks, tolerance, &mut at, &mut samples)?;
        Ok(samples)
    };
    let has_width = repeat.width != [0.0; 2] || repeat.radius != [0.0; 2];
    let mut samples = edge(if has_width { 1.0 } else { 0.0 })?;
    if has_width {
        samples.extend(edge(-1.0)?.into_iter().rev());
    }
    swept(line, repeat, end, &samples, has_width).ok_or(Fault::NotFinite)
}

/// As [`sweep`], along the straight line between both ends.
fn straight(line: &Line<'_>, repeat: &Repeat, end: f64) -> Option<Copy> {
    let length = end - repeat.s;
    let mut samples = Vec::new();
    let has_width = width(repeat, 0.0) > 0.0 || width(repeat, repeat.length) > 0.0;
    for (side, order) in [(1.0, [0.0, length]), (-1.0, [length, 0.0])] {
        for ds in order.into_iter().filter(|_| side > 0.0 || has_width) {
            let (middle, heading) = detached(line, repeat, ds)?;
            let (cos, sin) = mapd_geometry::cos_sin(normalize_angle(heading));
            let left = DVec3::new(-sin, cos, 0.0);
            let up = DVec3::Z * linear(repeat.z_offset, ds, repeat.length);
            let position = middle + left * (0.5 * side * width(repeat, ds)) + up;
            samples.push(Sample { s: repeat.s + ds, position });
        }
    }
    swept(line, repeat, end, &samples, has_width)
}

/// A copy with the area inside an outline; relative to its start, in inertial directions.
fn swept(
    line: &Line<'_>,
    repeat: &Repeat,
    end: f64,
    samples: &[Sample],
    is_closed: bool,
) -> Option<Copy> {
    let t = repeat.t.at(0.0, repeat.length);
    let origin = line.at(repeat.s, t)?.position + DVec3::Z * repeat.z_offset[0];
    let height = |s: f64| linear(repeat.height, s - repeat.s, repeat.length);
    let points: Vec<ObjectPointRow> =
        samples.iter().map(|p| point(p.position - origin, height(p.s))).collect();
    let (x, y, z) = origin.is_finite().then_some(origin)?.into();
    let closed = if is_closed { outline_flags::CLOSED } else { 0 };
    let outline = ObjectOutlineRow {
        points: Range::default(),
        id: NONE,
        fill: 0,
        lane_type: 0,
        flags: outline_flags::OUTER | closed,
        reserved: 0,
    };
    let row = ObjectCopyRow {
        x,
        y,
        z,
        s: repeat.s,
        t,
        heading: 0.0,
        pitch: 0.0,
        roll: 0.0,
        length: single(end - repeat.s),
        width: single(width(repeat, 0.0)),
        height: single(repeat.height[0]),
        radius: single(repeat.radius[0]).max(0.0),
        object: 0,
        outlines: Range::default(),
        shape: ObjectShape::Outlines.code(),
        flags: copy_flags::SWEPT,
        reserved: 0,
    };
    let made = points.len();
    let shape = Shape { row: outline, points, made, corners: Vec::new() };
    Some(Copy { row, shape: Some(Box::new(shape)) })
}
