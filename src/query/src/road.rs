//! Roads: the reference line and what lies along it.

use crate::begun::begun;
use crate::error::QueryError;
use crate::extents::SourcePosition;
use crate::ids::RoadId;
use crate::junction::Junction;
use crate::map::Map;
use crate::profile::{self, At};
use crate::section::LaneSection;
use crate::types::{Clamped, Point, Pose, Track, TrackPosition, is_coordinate};
use glam::{DVec2, DVec3};
use mapd_archive::{
    ArchivedCubicRow, ArchivedGeometryRow, ArchivedLaneLayerRow, ArchivedRoadRow,
    ArchivedRoadTypeRow, ContactPoint, LinkKind, NONE, Range, RoadType, SpeedKind, string,
};
use mapd_geometry::{Curve, CurveKind, CurvePoint, CurveRates, Start, clamp, normalize_angle};

/// Two geometries that meet may miss each other by the rounding of their written coordinates: a unit in the last place of
/// 8,000 km `[m]`. An s beyond the end by no more is not said to be moved. Of two feet whose distances differ by less, the
/// perpendicular one is the foot.
pub(crate) const JOINT: f64 = 1e-9;

/// A foot at an end of a piece is exact if its place is as near to the point as this `[m]`: what evaluating and projecting round.
const EXACT: f64 = 1e-9;

/// A road.
#[derive(Clone, Copy)]
pub struct Road<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    pub(crate) row: &'a ArchivedRoadRow,
}

/// What a road is linked to at one of its ends.
#[derive(Clone, Copy)]
pub enum RoadLink<'a> {
    /// A road, and which of its ends.
    Road(Road<'a>, ContactPoint),
    /// A junction.
    Junction(Junction<'a>),
    /// Something that the map does not have.
    Unresolved,
}

/// A `road/type` record.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoadTypeRecord {
    /// Start on the road `[m]`.
    pub s: f64,
    /// The type.
    pub kind: RoadType,
    /// What the speed record says.
    pub speed_kind: SpeedKind,
    /// Speed limit `[m/s]` if `speed_kind` is `Value`, else 0.
    pub speed: f64,
    /// The country whose rules hold, where the file gives one: a number for [`Map::country`].
    pub country: Option<u32>,
}

/// A plan-view geometry with its place on the road.
#[derive(Clone, Copy)]
pub(crate) struct GeometryPiece<'a> {
    pub(crate) s: f64,
    pub(crate) curve: Curve<'a>,
}

impl GeometryPiece<'_> {
    /// Metres per metre of s, which differ from 1 on cubics that are written with another length, and the curvature `[1/m]`, at s on the road.
    #[inline]
    pub(crate) fn speed_and_curvature(&self, s: f64) -> [f64; 2] {
        self.curve.speed_and_curvature(s - self.s)
    }

    /// As [`Self::speed_and_curvature`], with the change of both per metre of s.
    pub(crate) fn rates(&self, s: f64) -> CurveRates {
        self.curve.rates(s - self.s)
    }
}

/// Number of the geometry that holds at s, among those of a road: the last that starts at or before it, else the first.
// Never inlined: it is called in many places, and there once.
#[inline(never)]
pub(crate) fn geometry_at(rows: &[ArchivedGeometryRow], s: f64) -> usize {
    begun(rows, s, |g| g.s()).saturating_sub(1)
}

/// An s moved onto the reference line, and whether it was.
#[inline(always)]
pub(crate) fn kept(s: f64, end: f64) -> Result<(f64, Clamped), QueryError> {
    let on_line = clamp(s, 0.0, end);
    // An s that did not move is finite.
    if on_line == s {
        Ok((on_line, Clamped::No))
    } else if s.is_finite() {
        Ok((on_line, Clamped::of(s, 0.0, end + JOINT)))
    } else {
        Err(QueryError::NotFinite)
    }
}

impl<'a> Road<'a> {
    #[inline]
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().roads.get(number as usize)? })
    }

    /// Dense id.
    pub fn road_id(&self) -> RoadId {
        RoadId::new(self.number, self.map.content())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// OpenDRIVE's name.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// Length of the reference line as written `[m]`.
    #[inline]
    pub fn length(&self) -> f64 {
        self.row.length()
    }

    /// Whether traffic keeps to the left.
    pub fn is_left_hand_traffic(&self) -> bool {
        self.row.rule() == 1
    }

    /// The junction that this is a connecting road of.
    pub fn junction(&self) -> Option<Junction<'a>> {
        if self.row.junction() == NONE {
            None
        } else {
            Junction::new(self.map, self.row.junction())
        }
    }

    /// Row of the junction that this is a connecting road of.
    pub(crate) fn junction_row(&self) -> Option<u32> {
        Some(self.row.junction()).filter(|row| *row != NONE)
    }

    /// What lies at s = 0.
    pub fn predecessor(&self) -> Option<RoadLink<'a>> {
        self.link(
            self.row.predecessor_kind(),
            self.row.predecessor(),
            self.row.predecessor_contact(),
        )
    }

    /// What lies at s = length.
    pub fn successor(&self) -> Option<RoadLink<'a>> {
        self.link(self.row.successor_kind(), self.row.successor(), self.row.successor_contact())
    }

    fn link(&self, kind: u8, row: u32, contact: u8) -> Option<RoadLink<'a>> {
        match LinkKind::from_code(kind) {
            LinkKind::None => None,
            LinkKind::Road => {
                Some(RoadLink::Road(Road::new(self.map, row)?, ContactPoint::from_code(contact)))
            }
            LinkKind::Junction => Some(RoadLink::Junction(Junction::new(self.map, row)?)),
            _ => Some(RoadLink::Unresolved),
        }
    }

    /// Place of the road in its file: line and column of the start tag, from 1.
    pub fn source_position(&self) -> SourcePosition {
        SourcePosition { line: self.row.line(), column: self.row.column() }
    }

    /// `road/type` records in ascending s.
    pub fn types(&self) -> impl ExactSizeIterator<Item = RoadTypeRecord> + use<'a> {
        let map = self.map;
        self.type_rows().iter().map(move |r| RoadTypeRecord {
            s: r.s(),
            kind: RoadType::from_code(r.kind()),
            speed_kind: SpeedKind::from_code(r.speed_kind()),
            speed: r.speed(),
            country: Some(r.country()).filter(|number| map.country(*number).is_some()),
        })
    }

    /// Rows of its `type` records.
    pub(crate) fn type_rows(&self) -> &'a [ArchivedRoadTypeRow] {
        self.row.types().of(self.map.tables().road_types)
    }

    /// Sections in ascending s.
    pub fn sections(&self) -> impl Iterator<Item = LaneSection<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.sections().rows(map.tables().sections.len());
        rows.filter_map(move |row| LaneSection::new(map, row))
    }

    /// Sections of the road's temporary lanes in ascending s (OpenDRIVE 1.9); most roads have none. There may be gaps.
    pub fn temporary_sections(&self) -> impl Iterator<Item = LaneSection<'a>> + use<'a> {
        let map = self.map;
        let layer = self.temporary_layer();
        let rows = layer.map_or(0..0, |row| row.sections().rows(map.tables().sections.len()));
        rows.filter_map(move |row| LaneSection::new(map, row))
    }

    fn temporary_layer(&self) -> Option<&'a ArchivedLaneLayerRow> {
        let rows = self.map.tables().lane_layers;
        rows.binary_search_by(|row| row.road().cmp(&self.number)).ok().and_then(|i| rows.get(i))
    }

    /// Lane offset records of the temporary layer.
    pub(crate) fn temporary_lane_offsets(&self) -> &'a [ArchivedCubicRow] {
        self.temporary_layer().map_or(&[], |row| self.cubics(row.lane_offsets()))
    }

    /// Section by its number, from 0.
    pub fn section(&self, number: u32) -> Option<LaneSection<'a>> {
        let range = self.row.sections();
        if number >= range.count {
            return None;
        }
        LaneSection::new(self.map, range.first.checked_add(number)?)
    }

    /// Section at s; at a boundary the later one, beyond the ends the first or last. None for an s that is not finite.
    pub fn section_at(&self, s: f64) -> Option<LaneSection<'a>> {
        if !s.is_finite() {
            return None;
        }
        let range = self.row.sections();
        let rows = range.of(self.map.tables().sections);
        let after = rows.partition_point(|section| section.s_start() <= s);
        LaneSection::new(self.map, range.first.checked_add(after.saturating_sub(1) as u32)?)
    }

    #[inline]
    fn cubics(&self, range: Range) -> &'a [ArchivedCubicRow] {
        range.of(self.map.tables().cubics)
    }

    /// Elevation of the reference line at s `[m]`. s outside the road counts as its nearer end; of an s that is not finite: NaN.
    pub fn elevation_at(&self, s: f64) -> f64 {
        self.place(s).map_or(f64::NAN, |at| self.elevation(at))
    }

    /// Superelevation at s `[rad]`; positive lifts the left side. As [`Road::elevation_at`] otherwise.
    pub fn superelevation_at(&self, s: f64) -> f64 {
        self.place(s).map_or(f64::NAN, |at| profile::value(self.superelevations(), at))
    }

    /// The place that an s means: on the reference line. None for an s that is not finite.
    fn place(&self, s: f64) -> Option<At> {
        s.is_finite().then(|| At::new(clamp(s, 0.0, self.reference_end().max(0.0))))
    }

    /// Change of the superelevation by s `[rad/m]`.
    pub(crate) fn superelevation_slope(&self, at: At) -> f64 {
        profile::slope(self.superelevations(), at).derivative
    }

    #[inline]
    pub(crate) fn elevations(&self) -> &'a [ArchivedCubicRow] {
        self.cubics(self.row.elevations())
    }

    #[inline]
    pub(crate) fn superelevations(&self) -> &'a [ArchivedCubicRow] {
        self.cubics(self.row.superelevations())
    }

    #[inline]
    pub(crate) fn lane_offsets(&self) -> &'a [ArchivedCubicRow] {
        self.cubics(self.row.lane_offsets())
    }

    #[inline]
    pub(crate) fn elevation(&self, at: At) -> f64 {
        profile::value(self.elevations(), at)
    }

    /// Elevation with its slope.
    pub(crate) fn elevation_slope(&self, at: At) -> profile::Slope {
        profile::slope(self.elevations(), at)
    }

    /// Lane offset at s `[m]`; positive to the left. As [`Road::elevation_at`] otherwise.
    pub fn lane_offset_at(&self, s: f64) -> f64 {
        self.place(s).map_or(f64::NAN, |at| self.lane_offset_slope(at).value)
    }

    #[inline]
    pub(crate) fn lane_offset_slope(&self, at: At) -> profile::Slope {
        profile::slope(self.lane_offsets(), at)
    }

    /// Cosine and sine of the superelevation; (1, 0) without any trigonometry where the road has none.
    #[inline]
    pub(crate) fn roll(&self, at: At) -> (f64, f64) {
        let (cos, sin, _) = self.roll_angle(at);
        (cos, sin)
    }

    /// As [`Self::roll`], and the angle itself.
    #[inline]
    pub(crate) fn roll_angle(&self, at: At) -> (f64, f64, f64) {
        let angle = profile::value(self.superelevations(), at);
        let (cos, sin) = profile::roll(angle);
        (cos, sin, angle)
    }

    #[inline]
    pub(crate) fn geometries(&self) -> &'a [ArchivedGeometryRow] {
        self.row.geometries().of(self.map.tables().geometries)
    }

    /// The geometry that holds at s: the last that starts at or before it.
    #[inline(always)]
    pub(crate) fn piece_at(&self, at: At) -> Option<GeometryPiece<'a>> {
        let rows = self.geometries();
        self.piece(rows.get(geometry_at(rows, at.hold))?)
    }

    #[inline(always)]
    pub(crate) fn piece(&self, g: &'a ArchivedGeometryRow) -> Option<GeometryPiece<'a>> {
        let start = Start { x: g.x(), y: g.y(), heading: g.hdg(), cos: g.cos(), sin: g.sin() };
        let coefficients = g.coefficients().of(self.map.tables().coefficients);
        let curve = Curve::new(CurveKind::from_code(g.kind())?, start, g.length(), coefficients)?;
        Some(GeometryPiece { s: g.s(), curve })
    }

    /// As [`Self::piece`], of lines and arcs alone: for less.
    #[inline(always)]
    pub(crate) fn simple_piece(&self, g: &'a ArchivedGeometryRow) -> Option<GeometryPiece<'a>> {
        let kind = CurveKind::from_code(g.kind())?;
        if kind != CurveKind::Line && kind != CurveKind::Arc {
            return None;
        }
        let start = Start { x: g.x(), y: g.y(), heading: g.hdg(), cos: g.cos(), sin: g.sin() };
        let coefficients = g.coefficients().of(self.map.tables().coefficients);
        let curve = if kind == CurveKind::Line {
            Curve::new(CurveKind::Line, start, g.length(), coefficients)?
        } else {
            Curve::new(CurveKind::Arc, start, g.length(), coefficients)?
        };
        Some(GeometryPiece { s: g.s(), curve })
    }

    /// Every s at which a geometry, elevation, superelevation or lane offset record begins, and the reference line's end.
    pub fn shape_breaks(&self) -> impl Iterator<Item = f64> + use<'a> {
        let profiles = [self.row.elevations(), self.row.superelevations(), self.row.lane_offsets()];
        let cubics = self.map.tables().cubics;
        self.geometries()
            .iter()
            .map(|g| g.s())
            .chain(
                profiles.into_iter().flat_map(move |range| range.of(cubics).iter().map(|r| r.s())),
            )
            .chain(std::iter::once(self.reference_end()))
    }

    /// Largest s that the reference line reaches `[m]`: the road's length or the end of its last geometry.
    pub fn reference_end(&self) -> f64 {
        self.geometries().last().map_or(0.0, |last| self.reference_end_on(last))
    }

    /// As [`Self::reference_end`], where the road's last geometry is known.
    #[inline]
    fn reference_end_on(&self, last: &ArchivedGeometryRow) -> f64 {
        self.length().min(last.s() + last.length())
    }

    /// Where a geometry ends, by its number: where the next one begins, or with the reference line.
    #[inline]
    pub(crate) fn geometry_end(&self, at: usize, geometry: &ArchivedGeometryRow) -> f64 {
        match self.geometries().get(at + 1) {
            Some(next) => next.s(),
            None => self.reference_end_on(geometry),
        }
    }

    /// The reference line at s, relative to the local origin.
    #[inline(always)]
    pub(crate) fn reference_at(&self, at: At) -> Option<CurvePoint> {
        let piece = self.piece_at(at)?;
        Some(piece.curve.evaluate(at.s - piece.s))
    }

    /// Inertial pose of a track position: (x, y, e) + t along the rolled lateral axis + h along its normal
    /// (OpenDRIVE 1.8.1, 8.3). s beyond the reference line is moved to its end and flagged.
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    pub fn to_inertial(&self, track: Track) -> Result<Pose, QueryError> {
        let (s, clamped) = kept(track.s, self.reference_end().max(0.0))?;
        let pose = self.pose(At::new(s), track.t, track.h)?;
        Ok(Pose { clamped, ..pose })
    }

    /// As [`Road::to_inertial`], at a place of the reference line.
    // Always: `to_inertial` is what planners ask most, and the compiler and other queries call this too.
    #[inline(always)]
    pub(crate) fn pose(&self, at: At, t: f64, h: f64) -> Result<Pose, QueryError> {
        if !(at.s.is_finite() && is_coordinate(t) && is_coordinate(h)) {
            return Err(QueryError::NotFinite);
        }
        // Before the reference line, which takes longer: what they read is waited for together.
        let elevation = profile::slope(self.elevations(), at);
        let roll = self.roll_angle(at);
        let point = self.reference_at(at).ok_or(QueryError::Corrupt)?;
        Ok(self.pose_beside(&point, elevation, roll, [t, h]))
    }

    /// The pose at t and h beside and above a point of the reference line, with cosine, sine and angle of the superelevation.
    #[inline(always)]
    pub(crate) fn pose_beside(
        &self,
        point: &CurvePoint,
        elevation: profile::Slope,
        (roll_cos, roll_sin, superelevation): (f64, f64, f64),
        [t, h]: [f64; 2],
    ) -> Pose {
        let lateral = t * roll_cos - h * roll_sin;
        let origin = self.map.origin();
        Pose {
            position: DVec3::new(
                origin.x + (point.x - point.sin * lateral),
                origin.y + (point.y + point.cos * lateral),
                elevation.value + t * roll_sin + h * roll_cos,
            ),
            heading: normalize_angle(point.heading),
            curvature: point.curvature,
            slope: elevation.derivative,
            superelevation,
            clamped: Clamped::No,
        }
    }

    /// Track position of a point: the foot on the nearest place of the whole reference line. Without z in plan view
    /// (t then lies on the rolled plane below or above the point, h stays unknown).
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    #[inline]
    pub fn to_track(&self, point: impl Into<Point>) -> Result<TrackPosition, QueryError> {
        self.track_of(point.into())
    }

    /// As [`to_track`](Self::to_track): one function for all kinds of points.
    fn track_of(&self, point: Point) -> Result<TrackPosition, QueryError> {
        if !point.is_place() {
            return Err(QueryError::NotFinite);
        }
        let local: DVec2 = point.xy - self.map.origin();
        let end = self.reference_end();
        let mut best: Option<(f64, f64, mapd_geometry::Projection)> = None;
        let rows = self.geometries();
        for (i, g) in rows.iter().enumerate().filter(|(_, g)| g.s() <= end) {
            let from_start = DVec2::new(local.x - g.x(), local.y - g.y()).length();
            // No point of a line, arc or spiral is farther from its start than its length; parametric and transformed
            // curves are scaled to their stated length and may reach farther.
            let scaled = matches!(
                CurveKind::from_code(g.kind()),
                Some(CurveKind::Poly3 | CurveKind::ParamPoly3 | CurveKind::Transformed)
            );
            let nearest_possible = if scaled { 0.0 } else { from_start - g.length() };
            if best.as_ref().is_some_and(|(d, ..)| nearest_possible > *d + JOINT) {
                continue;
            }
            let piece = self.piece(g).ok_or(QueryError::Corrupt)?;
            // Where geometries overlap, the later one holds.
            let next = rows.get(i + 1).map_or(end, |next| next.s().min(end));
            let limit = (next - piece.s).min(piece.curve.length());
            let foot = piece.curve.project_within(local.x, local.y, limit);
            let distance = foot.distance_squared.sqrt();
            let better = |(d, _, b): &(f64, f64, mapd_geometry::Projection)| {
                // A perpendicular foot has to lose by more than rounding, and wins within it.
                let allowance = f64::from(i8::from(b.clamped) - i8::from(foot.clamped)) * JOINT;
                distance < *d + allowance
            };
            if best.as_ref().is_none_or(better) {
                let s = piece.s + foot.u;
                // At a piece's end s is where the next one begins, which the sum may miss by rounding.
                let s = if foot.u >= limit && (next - s).abs() <= JOINT { next } else { s };
                best = Some((distance, s, foot));
            }
        }
        let (distance, s, foot) = best.ok_or(QueryError::Corrupt)?;
        let s = clamp(s, 0.0, end.max(0.0));
        let (roll_cos, roll_sin) = self.roll(At::new(s));
        let exact = !foot.clamped || self.leads_back(s, foot.lateral, local);
        let clamped = match (exact, s <= 0.0, s >= end) {
            (true, ..) | (_, false, false) => Clamped::No,
            (_, true, _) => Clamped::Before,
            (_, _, true) => Clamped::After,
        };
        let (t, h) = match point.z {
            None => (foot.lateral / roll_cos, None),
            Some(z) => {
                let up = z - self.elevation_at(s);
                (
                    foot.lateral * roll_cos + up * roll_sin,
                    Some(up * roll_cos - foot.lateral * roll_sin),
                )
            }
        };
        Ok(TrackPosition { s, t, h, distance, clamped, exact })
    }

    /// Whether the place beside the reference line at s is a point (relative to the local origin), but for rounding: at an end of a
    /// piece it may not be.
    fn leads_back(&self, s: f64, lateral: f64, local: DVec2) -> bool {
        self.reference_at(At::new(s)).is_some_and(|point| {
            let place = DVec2::new(point.x - point.sin * lateral, point.y + point.cos * lateral);
            place.distance(local) <= EXACT
        })
    }
}
