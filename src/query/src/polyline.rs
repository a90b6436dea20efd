//! Polylines as they lie in the archive.

use glam::{DVec2, DVec3};
use mapd_archive::{
    ArchivedLaneRow, ArchivedSectionRow, PackedPoint, PointCode, PointReader, Tables,
};

/// The points of a line, from the frame of their section.
#[derive(Clone, Copy)]
pub(crate) struct Points<'a> {
    code: PointCode,
    count: usize,
    /// The points' bytes and those behind.
    bytes: &'a [u8],
    /// Stations of the section and of those after it.
    stations: &'a [f32],
}

impl<'a> Points<'a> {
    /// A lane's centre line.
    #[inline]
    pub(crate) fn center(
        tables: &Tables<'a>,
        section: &ArchivedSectionRow,
        lane: &ArchivedLaneRow,
    ) -> Self {
        Self::new(tables, section, lane.first_byte() as usize, lane.center_count().into())
    }

    /// A lane's outer border.
    pub(crate) fn border(
        tables: &Tables<'a>,
        section: &ArchivedSectionRow,
        lane: &ArchivedLaneRow,
    ) -> Self {
        let before = usize::from(lane.center_count()) * section.point_code().bytes();
        let count = lane.border_count().into();
        Self::new(tables, section, lane.first_byte() as usize + before, count)
    }

    #[inline]
    fn new(tables: &Tables<'a>, section: &ArchivedSectionRow, from: usize, count: usize) -> Self {
        let code = section.point_code();
        let bytes = tables.points.get(from..).unwrap_or(&[]);
        // Fewer are there only in a damaged archive.
        let count = if bytes.len() < count * code.bytes() { 0 } else { count };
        let stations = tables.point_stations.get(section.first_station() as usize..);
        Self { code, count, bytes, stations: stations.unwrap_or(&[]) }
    }

    /// Number of points.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// The bytes from a point on.
    #[inline]
    fn point(&self, i: usize) -> Option<&'a [u8]> {
        if i < self.count { self.bytes.get(i * self.code.bytes()..) } else { None }
    }

    /// s of a point, from the section's start `[m]`.
    #[inline]
    pub(crate) fn station(&self, i: usize) -> Option<f32> {
        // Beyond the table only in a damaged archive.
        let station = |bytes| self.stations.get(self.code.station(bytes) as usize).copied();
        self.point(i).map(|bytes| station(bytes).unwrap_or_default())
    }

    #[inline]
    fn offset(&self, i: usize) -> Option<DVec3> {
        self.point(i).map(|bytes| DVec3::from_array(self.code.offset(bytes)))
    }

    /// The points in plan view, from the section's frame `[m]`: some of them from one on.
    #[inline]
    pub(crate) fn in_plan(&self, i: usize) -> impl Iterator<Item = DVec2> + use<'a> {
        let (reader, bytes) = (self.code.reader(), self.code.bytes());
        let from = self.bytes.get(i * bytes..).unwrap_or(&[]);
        (0..self.count.saturating_sub(i)).map(move |i| {
            let [x, y, _] = reader.read(from.get(i * bytes..).unwrap_or(&[])).offset;
            DVec2::new(x, y)
        })
    }

    /// Number of points before the first one whose s is not `before` this.
    pub(crate) fn partition_point(&self, before: impl Fn(f32) -> bool) -> usize {
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = low.midpoint(high);
            if self.station(middle).is_some_and(&before) { low = middle + 1 } else { high = middle }
        }
        low
    }
}

/// s of both ends of a segment of a lane's centre line, from the section's start `[m]`; none if it has no such segment. As
/// [`Points`], without what queries for the nearest lane do not need: they read each segment that may be the nearest.
#[inline]
pub(crate) fn segment_ends(
    tables: &Tables<'_>,
    section: &ArchivedSectionRow,
    lane: &ArchivedLaneRow,
    segment: usize,
) -> Option<[f32; 2]> {
    if segment + 1 >= lane.center_count().into() {
        return None;
    }
    let code = section.point_code();
    let a = tables.points.get(lane.first_byte() as usize + segment * code.bytes()..)?;
    let b = a.get(code.bytes()..)?;
    let first = section.first_station() as usize;
    let station = |point| tables.point_stations.get(first + code.station(point) as usize).copied();
    Some([station(a)?, station(b)?])
}

/// A polyline of bounded error, borrowed from the archive. Its points are decoded as they are asked for.
#[derive(Clone, Copy)]
pub struct Polyline<'a> {
    /// Inertial position that the points count from `[m]`.
    origin: DVec3,
    /// s of the section's start.
    s_start: f64,
    points: Points<'a>,
}

/// A point of a line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LinePoint {
    /// s on the road `[m]`.
    pub s: f64,
    /// Inertial position `[m]`.
    pub position: DVec3,
}

/// A line, with what is the same for all its points.
#[derive(Clone, Copy)]
pub struct LineReader<'a> {
    /// The line.
    pub line: Polyline<'a>,
    reader: PointReader,
}

impl<'a> LineReader<'a> {
    /// That of another line of the same section.
    #[inline]
    pub fn beside(&self, line: Polyline<'a>) -> Self {
        Self { line, reader: self.reader }
    }

    /// A point as [`Polyline::points`] has it; none where the line has no such point.
    #[inline]
    pub fn point(&self, i: usize) -> Option<LinePoint> {
        (i < self.line.len()).then(|| self.read(i))
    }

    /// A point that the line has.
    #[inline(always)]
    fn read(&self, i: usize) -> LinePoint {
        let Polyline { origin, s_start, points } = &self.line;
        let bytes = points.bytes.get(i * points.code.bytes()..).unwrap_or(&[]);
        let PackedPoint { station, offset } = self.reader.read(bytes);
        let station = points.stations.get(station as usize).copied().unwrap_or_default();
        LinePoint { s: s_start + f64::from(station), position: *origin + DVec3::from_array(offset) }
    }
}

impl<'a> Polyline<'a> {
    pub(crate) fn new(origin: DVec3, section: &ArchivedSectionRow, points: Points<'a>) -> Self {
        let frame = DVec3::new(section.x().into(), section.y().into(), section.z().into());
        Self { origin: origin + frame, s_start: section.s_start(), points }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no points (lane 0 has no centre line).
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Inertial position of a point `[m]`.
    #[inline]
    pub fn position(&self, i: usize) -> Option<DVec3> {
        self.points.offset(i).map(|offset| self.origin + offset)
    }

    /// s of a point on the road `[m]`. Points of equal s are both sides of a jump.
    #[inline]
    pub fn station(&self, i: usize) -> Option<f64> {
        self.points.station(i).map(|s| self.s_start + f64::from(s))
    }

    /// s of the points on the road `[m]`.
    pub fn stations(&self) -> impl ExactSizeIterator<Item = f64> + use<'a> {
        let line = *self;
        (0..self.len()).map(move |i| line.station(i).unwrap_or_default())
    }

    /// Inertial positions in ascending s `[m]`.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = DVec3> + use<'a> {
        let line = *self;
        (0..self.len()).map(move |i| line.position(i).unwrap_or_default())
    }

    /// Every point in ascending s: s and position as [`Self::stations`] and [`Self::positions`] have
    /// them, for callers that need all.
    #[inline]
    pub fn points(&self) -> impl ExactSizeIterator<Item = LinePoint> + use<'a> {
        let reader = self.reader();
        (0..self.len()).map(move |i| reader.read(i))
    }

    /// For callers that read many points one by one: for the compiler.
    #[doc(hidden)]
    #[inline]
    pub fn reader(&self) -> LineReader<'a> {
        LineReader { line: *self, reader: self.points.code.reader() }
    }

    /// Number of points whose s on the road is less than this `[m]`.
    pub fn points_before(&self, s: f64) -> usize {
        self.points.partition_point(|station| self.s_start + f64::from(station) < s)
    }

    /// Bound on the distance of each point from where the exact line has it `[m]`: what writing it in few bits costs.
    pub fn rounding(&self) -> f64 {
        self.points.code.error()
    }
}
