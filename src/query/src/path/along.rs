//! Places along a path.

use super::change::{Displacement, ShiftAt};
use super::{Path, Span};
use crate::beside::{self, Beside};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::profile::{At, Slope};
use crate::types::Clamped;
use glam::{DVec2, DVec3};
use mapd_geometry::{CurvePoint, normalize_angle};
use std::f64::consts::PI;

/// Half the stretch over which curvature, its rate and grade are taken `[m]`: short against all that roads do, long against rounding.
const REACH: f64 = 0.05;

/// A position on a path, as seen by a vehicle that drives along it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathPoint {
    /// S `[m]`.
    pub along: f64,
    /// Inertial position on the plane h = 0 `[m]`.
    pub position: DVec3,
    /// Heading of the driven line `[rad]`, in (−π, π].
    pub heading: f64,
    /// Curvature of the driven line in plan view `[1/m]`, positive to the left.
    pub curvature: f64,
    /// Its change along the line `[1/m²]`.
    pub curvature_rate: f64,
    /// Metres upwards per metre of S.
    pub grade: f64,
    /// Superelevation `[rad]`; positive lifts the driver's left side.
    pub superelevation: f64,
    /// Distance to the driven lane's left edge `[m]`, across the road's plane; negative where a change of lane has not yet entered it.
    pub left: f64,
    /// Distance to the driven lane's right edge `[m]`, as on the left.
    pub right: f64,
    /// The driven lane.
    pub lane: LaneId,
    /// s on its road `[m]`.
    pub s: f64,
    /// Whether it is driven towards +s.
    pub forward: bool,
    /// Whether S lay outside the path and was moved to its nearer end.
    pub clamped: Clamped,
}

/// A place on the driven line.
#[derive(Clone, Copy)]
pub(super) struct Center {
    pub(super) position: DVec3,
    /// The way it is driven `[rad]`, in (−π, π].
    pub(super) heading: f64,
    /// Metres of line per metre of s.
    pub(super) growth: f64,
    pub(super) edges: EdgeSlopes,
    /// How far it lies beside the lane's centre, to the left of the reference line `[m]`.
    pub(super) shift: f64,
    pub(super) superelevation: f64,
}

/// Most that a curve may lead to the side per metre of S: at 1 it would run straight across.
const STEEPEST: f64 = 0.97;

/// How the driven line runs beside the reference line.
struct Course {
    /// The reference line, relative to the local origin.
    point: CurvePoint,
    /// Of the place `[m]`.
    t: f64,
    edges: EdgeSlopes,
    shift: f64,
    /// Cosine and sine of the superelevation, and the angle.
    roll: (f64, f64, f64),
    /// Metres ahead and to the left per metre of s, in plan view.
    run: [f64; 2],
}

impl Course {
    fn new(lane: &Lane<'_>, at: At, forward: bool, shift: Option<&ShiftAt>) -> Option<Self> {
        let road = lane.road();
        let piece = road.piece_at(at)?;
        let point = piece.curve.evaluate(at.s - piece.s);
        let [speed, _] = piece.speed_and_curvature(at.s);
        let edges = lane.edge_slopes(at);
        let shift =
            shift.map_or_else(Displacement::default, |shift| shift.beside(lane, at, &edges));
        let center = edges.center();
        let t = Slope {
            value: center.value + shift.value,
            derivative: center.derivative + shift.growth,
        };
        let roll = road.roll_angle(at);
        let line = Beside::new(&road, at, (roll.0, roll.1), t);
        let mut run = line.driven([speed, point.curvature]);
        if shift.per_along != 0.0 {
            let is_folded = line.run([speed, point.curvature])[0] < 0.0;
            let per_along = if forward == is_folded { -shift.per_along } else { shift.per_along };
            run[1] += aside(run, per_along * roll.0);
        }
        Some(Self { point, t: t.value, edges, shift: shift.value, roll, run })
    }

    /// Relative to the local origin.
    fn place(&self) -> DVec2 {
        let lateral = self.t * self.roll.0;
        let Self { point, .. } = self;
        DVec2::new(point.x - point.sin * lateral, point.y + point.cos * lateral)
    }
}

/// What a curve that leads to the side by the length of the line itself adds to the metres to the left per metre of s of a line that runs like this.
fn aside([ahead, left]: [f64; 2], per_along: f64) -> f64 {
    // The length g per metre of s: g² = ahead² + (left + per_along·g)².
    let slope = mapd_geometry::clamp(per_along, -STEEPEST, STEEPEST);
    let (rest, square) = (1.0 - slope * slope, ahead * ahead + left * left);
    let growth = (left * slope + (left * left * slope * slope + rest * square).sqrt()) / rest;
    slope * growth
}

/// The driven line at a place of a lane.
///
/// Errors: a damaged archive.
pub(super) fn center(
    lane: &Lane<'_>,
    at: At,
    forward: bool,
    shift: Option<&ShiftAt>,
) -> Result<Center, QueryError> {
    let own = Course::new(lane, at, forward, shift).ok_or(QueryError::Corrupt)?;
    let z = lane.road().elevation(at) + own.t * own.roll.1;
    let [ahead, left] = own.run;
    let turn = mapd_geometry::atan2(left, ahead);
    let back = if forward { 0.0 } else { PI };
    let superelevation = own.roll.2;
    Ok(Center {
        position: (own.place() + lane.map.origin()).extend(z),
        heading: normalize_angle(normalize_angle(own.point.heading) + turn + back),
        growth: beside::length(own.run),
        edges: own.edges,
        shift: own.shift,
        superelevation: if forward { superelevation } else { -superelevation },
    })
}

/// The driven line's place in plan view, relative to the local origin, and its direction of unit length: [`center`] without angles.
pub(super) fn tangent(
    lane: &Lane<'_>,
    at: At,
    forward: bool,
    shift: Option<&ShiftAt>,
) -> Option<[DVec2; 2]> {
    let own = Course::new(lane, at, forward, shift)?;
    let along = DVec2::new(own.point.cos, own.point.sin);
    let ([ahead, left], growth) = (own.run, beside::length(own.run));
    let growth = if forward { growth } else { -growth };
    Some([own.place(), (along * ahead + along.perp() * left) / growth])
}

impl Span {
    /// The records that hold on the span are those of its middle.
    pub(super) fn place(&self, s: f64) -> At {
        At { s, hold: 0.5 * (self.s[0] + self.s[1]) }
    }
}

impl Path<'_, '_> {
    /// The place at S. S outside the path is moved to its nearer end and flagged; at a joint the later side answers. Curvature, its
    /// rate and grade are those of the driven line on one side of whatever joint is near.
    ///
    /// Errors: an S that is not finite; a damaged archive.
    pub fn at(&self, along: f64) -> Result<PathPoint, QueryError> {
        if !along.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let end = self.length();
        let clamped = Clamped::of(along, 0.0, end);
        let along = mapd_geometry::clamp(along, 0.0, end);
        let span = self.span_at(along).ok_or(QueryError::Corrupt)?;
        let (piece, lane) = self.piece(span).ok_or(QueryError::Corrupt)?;
        let at = |along: f64| {
            let s = span.s_at(along - span.along);
            let shift = self.shift_at(span, along);
            let own = center(&lane, span.place(s), piece.forward, shift.as_ref())?;
            Ok::<_, QueryError>((own, s))
        };
        let (own, s) = at(along)?;
        // A short stretch around the place, all of it on the span.
        let reach = REACH.min(0.5 * span.length);
        let middle = mapd_geometry::clamp(along, span.along + reach, span.end() - reach);
        let (before, after) = (at(middle - reach)?.0, at(middle + reach)?.0);
        let mean = at(middle)?.0;
        let first = normalize_angle(mean.heading - before.heading);
        let second = normalize_angle(after.heading - mean.heading);
        let curvature_rate = (second - first) / (reach * reach);
        let curvature = (first + second) / (2.0 * reach) + curvature_rate * (along - middle);
        let half = 0.5 * (own.edges.outer.value - own.edges.inner.value).abs();
        let to_left = if piece.forward { own.shift } else { -own.shift };
        Ok(PathPoint {
            along,
            position: own.position,
            heading: own.heading,
            curvature,
            curvature_rate,
            grade: (after.position.z - before.position.z) / (2.0 * reach),
            superelevation: own.superelevation,
            left: half - to_left,
            right: half + to_left,
            lane: lane.lane_id(),
            s,
            forward: piece.forward,
            clamped,
        })
    }

    /// As [`Path::at`], for many places; `out` is emptied first.
    ///
    /// Errors: as [`Path::at`], by the number of the place.
    pub fn at_batch(&self, along: &[f64], out: &mut Vec<PathPoint>) -> Result<(), QueryError> {
        out.clear();
        along.iter().enumerate().try_for_each(|(i, along)| {
            out.push(self.at(*along).map_err(|error| error.at(i))?);
            Ok(())
        })
    }
}
