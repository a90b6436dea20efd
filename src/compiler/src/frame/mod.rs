//! Compiling into another frame than the file's (docs/coordinates.md).
//!
//! What the file has in x and y is moved before anything is sampled: reference lines, elevation grids, places of signals.
//! s and t stay as written, and all that lies in them follows by itself. Deliberately absent: the lanes' widths and lateral
//! offsets, which stay metres as written although the plane has a scale; the scale is told instead.

mod charts;
mod georeference;
mod move_rows;

use crate::draft::Draft;
use crate::draft::StatedGeoreference;
use crate::findings::finding;
use crate::options::CompileOptions;
use crate::resolve::Resolved;
use charts::{Charts, Local, Way};
use georeference::AppliedOffset;
pub(crate) use georeference::complete;
use glam::{DVec2, DVec3};
use mapd_archive::{FileFrameRow, GeometryRow, Rows};
use mapd_geodesy::{DefinitionWarning, Offset, Projector, Target};
use mapd_geometry::normalize_angle;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use move_rows::edge;

/// Path of what it concerns.
const PATH: &str = "OpenDRIVE/header/geoReference";
/// A scale farther from 1 deserves a warning: UTM's stay within 0.0004 in their zone and 0.001 in the next.
const SCALE_DEVIATION: f64 = 0.002;
/// Height over which the effect of heights on a datum's shift is measured `[m]`.
const HEIGHT_PROBE: f64 = 100.0;

/// Heights that a map may have on average, before and after `[m]`; what is higher is none of a road.
const HIGHEST: f64 = 1e6;
/// How exact projections are `[m]`: those computed here, and those of proj4rs, whose inverse is corrected to 0.1 µm.
const EXACT: [f64; 2] = [1e-8, 2e-7];
/// What the largest difference seen is multiplied by to bound those that are not.
const UNSEEN: f64 = 1.5;

/// The frame that a map is compiled into.
pub(crate) struct TargetFrame {
    /// PROJ parameters.
    pub(crate) definition: String,
    target: String,
    /// What brought the file's frame into the plane of its own projection.
    pub(crate) file_offset: Offset,
    /// Whether its sign is turned.
    pub(crate) is_negated: bool,
    charts: Charts,
    /// Its inverse.
    back: Charts,
    pub(crate) height_shift: f64,
    height_error: f64,
    error: f64,
    scale: [f64; 2],
    /// The file's projection and the target as asked for, in the table of strings.
    strings: [u32; 2],
}

/// Smallest and largest of what is read from the file: x, y and z `[m]`.
struct Extent {
    low: DVec3,
    high: DVec3,
}

impl Extent {
    fn of(rows: &Rows) -> Option<Self> {
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for g in rows.geometries.iter() {
            let end = move_rows::curve(g, &rows.coefficients).map(|curve| curve.tangent(g.length));
            let start = DVec2::new(g.x, g.y);
            for at in [start, end.map_or(start, |end| DVec2::new(end.x, end.y))] {
                (low, high) = (low.min(at), high.max(at));
            }
        }
        let (mut bottom, mut top) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |z: f64| (bottom, top) = (bottom.min(z), top.max(z));
        for road in rows.roads.iter() {
            let records = road.elevations.of(&rows.cubics);
            if records.first().is_none_or(|first| first.s > 0.0) {
                add(0.0);
            }
            for (i, r) in records.iter().enumerate() {
                let end = records.get(i + 1).map_or(road.length, |next| next.s);
                let ds = (end - r.s).max(0.0);
                // A cubic stays within its Bézier points.
                let (b, c, d) = (r.b * ds, r.c * ds * ds, r.d * ds * ds * ds);
                for z in [0.0, b / 3.0, (2.0 * b + c) / 3.0, b + c + d] {
                    add(r.a + z);
                }
            }
        }
        if bottom > top {
            (bottom, top) = (0.0, 0.0);
        }
        let extent = Self { low: low.extend(bottom), high: high.extend(top) };
        (extent.low.is_finite() && extent.high.is_finite()).then_some(extent)
    }

    /// Where the map is, by one more measure: the median start of its geometries. A road that lies astray does not move it.
    fn median(&self, rows: &Rows) -> DVec3 {
        let median = |of: fn(&GeometryRow) -> f64| {
            let mut all: Vec<f64> = rows.geometries.iter().map(of).collect();
            let half = all.len() / 2;
            if all.is_empty() { 0.0 } else { *all.select_nth_unstable_by(half, f64::total_cmp).1 }
        };
        DVec3::new(median(|g| g.x), median(|g| g.y), self.middle().z)
    }

    fn middle(&self) -> DVec3 {
        self.low.midpoint(self.high)
    }

    /// The middle and the corners of the rectangle, at middle height.
    fn probes(&self) -> [DVec3; 5] {
        let (low, high, middle) = (self.low, self.high, self.middle());
        [
            middle,
            low.with_z(middle.z),
            high.with_z(middle.z),
            DVec3::new(low.x, high.y, middle.z),
            DVec3::new(high.x, low.y, middle.z),
        ]
    }
}

/// A finding about the header.
fn about(placed: &StatedGeoreference, severity: Severity, message: String, hint: &str) -> Finding {
    finding(&building::TARGET_FRAME, severity, placed.header, PATH.to_owned(), message, hint)
}

impl TargetFrame {
    /// What the map is to be moved by; none where it cannot be, which is an error among the findings.
    pub(crate) fn new(
        target: &Target,
        (placed, rows): (&StatedGeoreference, &Rows),
        options: &CompileOptions,
        findings: &mut Vec<Finding>,
    ) -> Option<Self> {
        let mut refuse = |message: String| {
            let hint = "state a georeference in the file, or compile without --crs";
            findings.push(about(placed, Severity::Error, message, hint));
        };
        if placed.definition.is_empty() {
            refuse(format!(
                "the map cannot be transformed into {target}: it has no georeference that can be used"
            ));
            return None;
        }
        if rows.geometries.is_empty() {
            return None;
        }
        let Some(extent) = Extent::of(rows) else {
            refuse(format!("the map cannot be transformed into {target}: it reaches to infinity"));
            return None;
        };
        let mut why = String::new();
        for middle in [extent.middle(), extent.median(rows)] {
            let mut told = Vec::new();
            let applied = placed.applied(middle, options.offset_sign, &mut told);
            match Self::about_place(target, placed, &extent, middle, applied) {
                Ok(frame) => {
                    findings.append(&mut told);
                    return Some(frame);
                }
                // What is wrong with where most of the map is tells more.
                Err(error) => why = error,
            }
        }
        refuse(format!("the map cannot be transformed into {target}: {why}"));
        None
    }

    /// The frame for a map with this middle and offset. Errors: why there is none.
    fn about_place(
        target: &Target,
        placed: &StatedGeoreference,
        extent: &Extent,
        middle: DVec3,
        applied: AppliedOffset,
    ) -> Result<Self, String> {
        let AppliedOffset { offset: file_offset, is_negated } = applied;
        let of_file = Projector::new(&placed.definition, file_offset).map_err(|e| e.to_string())?;
        let place = of_file.to_geodetic(middle).map_err(|_| {
            format!(
                "its middle ({:.1}, {:.1}) lies outside the area of its own projection",
                middle.x, middle.y
            )
        })?;
        let definition = target.definition(place);
        let of_target =
            Projector::new(&definition, Offset::default()).map_err(|e| e.to_string())?;
        let way = Way { from: of_file.clone(), to: of_target.clone() };
        let image = way.image(middle).ok_or_else(|| {
            format!(
                "its middle (latitude {:.6}, longitude {:.6}) lies outside that frame's area",
                place.latitude, place.longitude
            )
        })?;
        let height_shift = image.z - middle.z;
        let shifts = extent.probes().map(|p| way.image(p).map(|image| image.z - p.z));
        let off = shifts.iter().flatten().map(|shift| UNSEEN * (shift - height_shift).abs());
        let height_error = off.fold(0.0, f64::max);
        // Where a datum is shifted, points above each other do not stay above each other.
        let lean = way
            .image(middle + DVec3::Z * HEIGHT_PROBE)
            .map_or(0.0, |above| above.truncate().distance(image.truncate()) / HEIGHT_PROBE);
        let lean_error = UNSEEN * lean * 0.5 * (extent.high.z - extent.low.z);
        let is_sane = lean_error.is_finite() && height_error.is_finite();
        if !is_sane || image.z.abs().max(middle.z.abs()) > HIGHEST {
            return Err("its heights are none on Earth".to_owned());
        }
        let both = of_file.is_reproducible() && of_target.is_reproducible();
        let exact = EXACT[usize::from(!both)];
        let back = Way { from: of_target, to: of_file };
        Ok(Self {
            definition,
            target: target.text().to_owned(),
            file_offset,
            is_negated,
            charts: Charts::new(way, middle.z),
            back: Charts::new(back, image.z),
            height_shift,
            height_error,
            error: lean_error + exact,
            scale: [f64::INFINITY, f64::NEG_INFINITY],
            strings: [0; 2],
        })
    }

    /// Image of a place of the file and its direction `[rad]`; none outside the area of a projection.
    pub(crate) fn standing(&self, at: DVec3, heading: f64) -> Option<(DVec3, f64)> {
        let chart = self.charts.at(at.truncate())?;
        let position = chart.whole(at.truncate()).extend(at.z + self.height_shift);
        Some((position, heading + turn(&chart, at.truncate(), heading)))
    }

    /// The row that tells of the frame, once lanes are sampled, and the bounds of the map in the file's frame.
    pub(crate) fn row(&self, rows: &Rows) -> FileFrameRow {
        let [low, high] = move_rows::file_bounds(self, rows).unwrap_or_default();
        let [projection, target] = self.strings;
        let offset = self.file_offset;
        FileFrameRow {
            offset_x: offset.shift.x,
            offset_y: offset.shift.y,
            offset_z: offset.shift.z,
            offset_hdg: offset.heading,
            min_x: low.x,
            min_y: low.y,
            min_z: low.z,
            max_x: high.x,
            max_y: high.y,
            max_z: high.z,
            height_shift: self.height_shift,
            error: self.error,
            height_error: self.height_error,
            scale_min: self.scale[0],
            scale_max: self.scale[1],
            projection,
            target,
        }
    }
}

/// Moves a map that has been read into the frame that is asked for. None where none is, which tells what lies too far away, where the map has no roads, and where
/// it cannot be, which is an error among the findings.
pub(crate) fn apply(
    draft: &mut Draft,
    signals: &mut Resolved,
    options: &CompileOptions,
    findings: &mut Vec<Finding>,
) -> Option<TargetFrame> {
    let Some(target) = &options.crs else {
        findings.append(&mut draft.too_far);
        return None;
    };
    let placed = draft.placed.clone();
    let mut frame = TargetFrame::new(target, (&placed, &draft.rows), options, findings)?;
    move_rows::all(&mut frame, draft, signals, findings);
    frame.strings = draft.retarget(&frame.definition, &frame.target);
    tell(&frame, target, &placed, findings);
    Some(frame)
}

/// How much a direction turns on its way `[rad]`.
fn turn(chart: &Local, at: DVec2, heading: f64) -> f64 {
    let (cos, sin) = mapd_geometry::cos_sin(heading);
    let [by_x, by_y] = chart.slopes_at(at);
    let image = by_x * cos + by_y * sin;
    normalize_angle(mapd_geometry::atan2(image.y, image.x) - heading)
}

/// Smallest and largest length of the image of a unit vector: the singular values.
fn scales([by_x, by_y]: [DVec2; 2]) -> [f64; 2] {
    let conformal = DVec2::new(by_x.x + by_y.y, by_x.y - by_y.x).length();
    let rest = DVec2::new(by_x.x - by_y.y, by_x.y + by_y.x).length();
    [0.5 * (conformal - rest), 0.5 * (conformal + rest)]
}

/// What is to be told of a frame besides errors.
fn tell(
    frame: &TargetFrame,
    target: &Target,
    placed: &StatedGeoreference,
    findings: &mut Vec<Finding>,
) {
    for doubt in target.warnings() {
        let severity = if doubt.is_grave() { Severity::Warning } else { Severity::Info };
        findings.push(about(placed, severity, format!("target frame {target}: {doubt}"), ""));
    }
    // A shift that is not known on one side is none at all.
    let unknown = [("the map", &placed.warnings[..]), ("the target frame", target.warnings())];
    for (whose, warnings) in unknown {
        if warnings.contains(&DefinitionWarning::Datum) {
            let message = format!(
                "the datum of {whose} is unknown: the map is transformed into {target} as if it were WGS 84 and may be hundreds of metres off"
            );
            let hint = "state the datum by +towgs84 or +datum";
            findings.push(about(placed, Severity::Warning, message, hint));
        }
    }
    let [low, high] = frame.scale;
    if (low - 1.0).abs().max((high - 1.0).abs()) > SCALE_DEVIATION {
        let message = format!(
            "in {target} distances are {low:.6} to {high:.6} of what they are in the file; lengths along roads and widths stay as written"
        );
        let hint = "choose a frame nearer to the map, such as utm or enu";
        findings.push(about(placed, Severity::Warning, message, hint));
    }
}
