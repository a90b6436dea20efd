//! The reference line that objects are placed along: a road's, or that of a junction.

use crate::draft::Objects;
use glam::{DVec2, DVec3};
use mapd_archive::{ArchivedGeometryRow, NONE, ObjectRow};
use mapd_geometry::{Attitude, Curve, CurveKind, Start, atan2, clamp};
use mapd_query::compiling::ByRow as _;
use mapd_query::junctions::GridHeight;
use mapd_query::{Junction, Map, Road, Track};

/// A reference line.
pub(super) enum Line<'a> {
    Road(Map<'a>, Road<'a>),
    /// A junction's line, as high as the junction's elevation grid there; without one it has no height.
    Junction(Junction<'a>, Map<'a>, &'a [ArchivedGeometryRow]),
}

/// A place beside a reference line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    /// Relative to the local origin `[m]`; z is that of the reference line.
    pub(super) position: DVec3,
    /// Heading of the line `[rad]`.
    pub(super) heading: f64,
    /// Axes of the line, inclined as the road is.
    pub(super) inclined: Attitude,
    /// Whether s lies beyond the line.
    pub(super) clamped: bool,
}

impl<'a> Line<'a> {
    /// The line that an object is written along.
    pub(super) fn of(map: Map<'a>, written: &Objects, row: &ObjectRow) -> Option<Self> {
        if row.road != NONE {
            let road = map.road_by_row(row.road)?;
            return Some(Self::Road(map, road));
        }
        // In order of the junctions' rows.
        let lines = &written.junction_lines;
        let found = lines.partition_point(|(of, _)| *of < row.junction);
        let (_, range) = lines.get(found).filter(|(of, _)| *of == row.junction)?;
        let junction = map.junction_by_row(row.junction)?;
        Some(Self::Junction(junction, map, range.of(map.tables().geometries)))
    }

    /// Largest s of the line `[m]`.
    pub(super) fn end(&self) -> f64 {
        match self {
            Self::Road(_, road) => road.reference_end(),
            Self::Junction(_, _, rows) => rows.last().map_or(0.0, |g| g.s() + g.length()),
        }
    }

    /// A place t to the left of the line (shortened by the road's superelevation: OpenDRIVE 1.8.1, 8.3), at the height of
    /// the line itself (1.9, 13.1); none where no number can hold it.
    pub(super) fn at(&self, s: f64, t: f64) -> Option<Station> {
        let inside = clamp(s, 0.0, self.end().max(0.0));
        let clamped = inside != s;
        let station = match self {
            Self::Road(map, road) => {
                let pose = road.to_inertial(Track { s: inside, t, h: 0.0 }).ok()?;
                let origin = map.local_origin().extend(0.0);
                let pitch = -atan2(pose.slope, 1.0);
                Station {
                    position: (pose.position - origin).with_z(road.elevation_at(inside)),
                    heading: pose.heading,
                    inclined: Attitude::new(pose.heading, pitch, pose.superelevation),
                    clamped,
                }
            }
            Self::Junction(junction, map, rows) => {
                let after = rows.partition_point(|g| g.s() <= inside);
                let g = rows.get(after.saturating_sub(1))?;
                let start =
                    Start { x: g.x(), y: g.y(), heading: g.hdg(), cos: g.cos(), sin: g.sin() };
                let coefficients = g.coefficients().of(map.tables().coefficients);
                let kind = CurveKind::from_code(g.kind())?;
                let point =
                    Curve::new(kind, start, g.length(), coefficients)?.evaluate(inside - g.s());
                let on_line = map.local_origin() + DVec2::new(point.x, point.y);
                let GridHeight { height: z, slope } =
                    junction.grid_height_at(on_line).unwrap_or_else(|| {
                        // 0 in the file's own frame.
                        let height = map.file_frame().map_or(0.0, |frame| frame.height_shift());
                        GridHeight { height, slope: DVec2::ZERO }
                    });
                let along = DVec2::new(point.cos, point.sin);
                let pitch = -atan2(slope.dot(along), 1.0);
                let roll = atan2(slope.dot(along.perp()), 1.0);
                Station {
                    position: DVec3::new(point.x - t * point.sin, point.y + t * point.cos, z),
                    heading: point.heading,
                    inclined: Attitude::new(point.heading, pitch, roll),
                    clamped,
                }
            }
        };
        station.position.is_finite().then_some(station)
    }

    /// Every s between two at which the line or its height may bend, with both, ascending.
    pub(super) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let mut breaks: Vec<f64> = match self {
            Self::Road(_, road) => road.shape_breaks().collect(),
            Self::Junction(junction, _, rows) => {
                rows.iter().map(|g| g.s()).chain(junction.grid_stations()).collect()
            }
        };
        breaks.retain(|s| *s > from && *s < to);
        breaks.extend([from, to]);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}
