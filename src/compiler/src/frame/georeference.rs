//! Where the map lies on Earth: georeference, header offset, stated bounds.
//!
//! ASAM OpenDRIVE 1.8.1, 8.4. Nothing is moved here: that is [`crate::frame`]'s. What is stored lets a projector be built.

use super::{TargetFrame, edge};
use crate::draft::StatedGeoreference;
use crate::findings::finding;
use crate::options::{CompileOptions, OffsetSign};
use glam::DVec3;
use mapd_archive::Rows;
use mapd_geodesy::{Offset, Projector};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};

/// How far the map may reach beyond the stated bounds `[m]`: many tools state those of the reference lines, to which a
/// carriageway is added.
const BOUNDS_TOLERANCE: f64 = 50.0;
/// Eastings that a zone of UTM has `[m]`, with room for maps that go on beyond it.
const UTM_EASTINGS: std::ops::RangeInclusive<f64> = 100_000.0..=900_000.0;
/// Northings that there are `[m]`.
const UTM_NORTHINGS: std::ops::RangeInclusive<f64> = 0.0..=10_000_000.0;
/// Latitudes and longitudes of bounds are rounded to multiples of this `[deg]`, a tenth of a millimetre: functions of the C
/// library, which some projections need, differ by less than a millionth of it between machines.
const STEP: f64 = 1e-9;
/// The offset of a header as it is applied.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AppliedOffset {
    pub(crate) offset: Offset,
    /// Whether its sign is the opposite of the one written.
    pub(crate) is_negated: bool,
}

impl StatedGeoreference {
    /// The offset as it is applied.
    pub(crate) fn applied(
        &self,
        middle: DVec3,
        sign: OffsetSign,
        findings: &mut Vec<Finding>,
    ) -> AppliedOffset {
        let has_shift = self.offset.shift.truncate() != glam::DVec2::ZERO;
        let turned = match sign {
            OffsetSign::Standard => false,
            OffsetSign::Negated => true,
            OffsetSign::Auto if !has_shift => false,
            OffsetSign::Auto => {
                let reason = self.reason_to_turn(middle);
                if let Some(reason) = &reason {
                    let message = format!("the offset's sign is negated: {reason}");
                    let hint = "set --offset-sign standard or negated to decide";
                    let severity = Severity::Warning;
                    findings.push(self.about_offset(
                        &building::OFFSET_SIGN,
                        severity,
                        message,
                        hint,
                    ));
                }
                reason.is_some()
            }
        };
        let offset = if turned { self.offset.negated() } else { self.offset };
        AppliedOffset { offset, is_negated: turned }
    }

    /// Why the offset must be subtracted rather than added.
    fn reason_to_turn(&self, middle: DVec3) -> Option<String> {
        let (written, turned) = (self.offset.apply(middle), self.offset.negated().apply(middle));
        let is_utm = self.definition.contains("+proj=utm ");
        if is_utm && !is_in_utm(written) && is_in_utm(turned) {
            return Some(format!(
                "as written, the map lies at easting {:.0} m, northing {:.0} m, where UTM has none; subtracted, at {:.0} m, {:.0} m",
                written.x, written.y, turned.x, turned.y
            ));
        }
        // Even such a tool is not believed where only the sign as written makes sense.
        let contradicted = is_utm && is_in_utm(written) && !is_in_utm(turned);
        (self.negating && !contradicted)
            .then(|| "the tool that wrote the file states what it has added itself".to_owned())
    }

    /// Compares the stated bounds with the real ones, both in the file's frame.
    fn compare(&self, [low, high]: [DVec3; 2], findings: &mut Vec<Finding>) {
        let Some([south, north, west, east]) = self.bounds else { return };
        let beyond = [south - low.y, high.y - north, west - low.x, high.x - east];
        let most = beyond.into_iter().fold(0.0, f64::max);
        if most <= BOUNDS_TOLERANCE {
            return;
        }
        let message = format!(
            "the map reaches {most:.1} m beyond the bounds that the header states (south {south}, north {north}, west {west}, east {east}): it goes from ({:.1}, {:.1}) to ({:.1}, {:.1})",
            low.x, low.y, high.x, high.y
        );
        let path = "OpenDRIVE/header".to_owned();
        findings.push(finding(
            &building::STATED_BOUNDS,
            Severity::Warning,
            self.header,
            path,
            message,
            "",
        ));
    }
}

/// Completes the map's row, whose bounds are known, and the row of the file's own frame where the map is in another.
pub(crate) fn complete(
    rows: &mut Rows,
    placed: &StatedGeoreference,
    frame: Option<&TargetFrame>,
    options: &CompileOptions,
    findings: &mut Vec<Finding>,
) {
    let file_frame = frame.map(|frame| frame.row(rows));
    rows.file_frames.extend(file_frame);
    let has_lanes = !rows.lanes.is_empty();
    let Some(map) = rows.map.first_mut() else { return };
    let low = DVec3::new(map.min_x, map.min_y, map.min_z);
    let high = DVec3::new(map.max_x, map.max_y, map.max_z);
    let middle = low.midpoint(high);
    let AppliedOffset { offset, is_negated } = match frame {
        Some(frame) => AppliedOffset { offset: Offset::default(), is_negated: frame.is_negated },
        None => placed.applied(middle, options.offset_sign, findings),
    };
    (map.offset_x, map.offset_y, map.offset_z) = offset.shift.into();
    map.offset_hdg = offset.heading;
    map.offset_sign = u8::from(is_negated);
    if !has_lanes {
        return;
    }
    placed.compare(
        file_frame.map_or([low, high], |f| {
            [DVec3::new(f.min_x, f.min_y, f.min_z), DVec3::new(f.max_x, f.max_y, f.max_z)]
        }),
        findings,
    );
    let definition = frame.map_or(&placed.definition, |frame| &frame.definition);
    let Ok(projector) = Projector::new(definition, offset) else { return };
    if let Some([south, north, west, east]) = geodetic_bounds(&projector, low, high) {
        (map.south, map.north, map.west, map.east) = (south, north, west, east);
        map.has_geodetic_bounds = 1;
    }
    if projector.to_geodetic(middle).is_err() {
        let message = format!(
            "the map's middle ({:.1}, {:.1}) lies outside the area of its projection",
            middle.x, middle.y
        );
        let path = "OpenDRIVE/header/geoReference".to_owned();
        findings.push(finding(
            &building::GEO_REFERENCE,
            Severity::Warning,
            placed.header,
            path,
            message,
            "",
        ));
    }
}

/// South, north, west and east `[deg]` of the edge of a rectangle; none where some of it lies outside the projection's area.
fn geodetic_bounds(projector: &Projector, low: DVec3, high: DVec3) -> Option<[f64; 4]> {
    let z = 0.5 * (low.z + high.z);
    let mut bounds: Option<[f64; 4]> = None;
    for at in edge(low.truncate(), high.truncate()) {
        let place = projector.to_geodetic(at.extend(z)).ok()?;
        let [south, north, west, east] =
            bounds.unwrap_or([place.latitude, place.latitude, place.longitude, place.longitude]);
        // The shorter way from what is known: a map across the antimeridian goes on beyond 180 degrees.
        let longitude = place.longitude + 360.0 * ((west - place.longitude) / 360.0).round();
        bounds = Some([
            south.min(place.latitude),
            north.max(place.latitude),
            west.min(longitude),
            east.max(longitude),
        ]);
    }
    let [south, north, west, east] = bounds?;
    let turn = if west < -180.0 { 360.0 } else { 0.0 };
    Some([south, north, west + turn, east + turn].map(|angle| (angle / STEP).round() * STEP))
}

fn is_in_utm(point: DVec3) -> bool {
    UTM_EASTINGS.contains(&point.x) && UTM_NORTHINGS.contains(&point.y)
}
