//! What lies above or below the plane of elevation and superelevation, and what lanes are made of.

use super::need::{ElementContext, ElementPath};
use crate::draft::{Draft, between};
use mapd_archive::{
    CubicRow, LaneHeightRow, LaneMaterialRow, Range, ShapeStationRow, SurfaceRow, SurfaceStripRow,
};
use mapd_rules::catalog::building;
use mapd_xodr::{
    self as xodr, Coefficients, Crossfall, CrossfallSide, Finding, Road, Severity, Shape,
    StripMode, Text as _, Value as _,
};

/// In the rows of materials: not given.
const NOT_GIVEN: f64 = -1.0;

impl Draft {
    /// Appends a road's lateral profiles, if it has any besides superelevation.
    pub(super) fn surface(
        &mut self,
        road: &Road,
        number: u32,
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        for crg in road.surface.iter().flat_map(|surface| &surface.crg) {
            let mut part = ElementContext {
                span: crg.span,
                path: ElementPath::new(path, "surface/CRG"),
                findings,
            };
            let message = format!(
                "the OpenCRG file {:?} is not built into the map: surface heights of this road lack it",
                crg.file.text()
            );
            part.add(&building::UNSUPPORTED, Severity::Info, message);
        }
        let Some(profile) = road.lateral_profile.as_deref() else { return };
        let surface = profile.cross_section_surface.as_deref();
        if profile.shape.is_empty() && profile.crossfall.is_empty() && surface.is_none() {
            return;
        }
        let mut crossfall = |keep: CrossfallSide| {
            let side = |record: &&Crossfall| {
                let side = record.side.value().unwrap_or(CrossfallSide::Both);
                side == keep || side == CrossfallSide::Both
            };
            let records: Vec<Crossfall> = profile.crossfall.iter().filter(side).cloned().collect();
            self.cubics(&records, 0.0, ElementPath::new(path, "lateralProfile/crossfall"), findings)
        };
        let crossfall_left = crossfall(CrossfallSide::Left);
        let crossfall_right = crossfall(CrossfallSide::Right);
        let shapes = self.shapes(&profile.shape, path, findings);
        let strips = surface.and_then(|surface| surface.surface_strips.as_deref());
        let strips = strips.map_or(&[][..], |strips| &strips.strip);
        let strips = self.strips(strips, path, findings);
        let offset = surface.and_then(|surface| surface.t_offset.as_deref());
        let strip_offset = self.over_s(offset.map_or(&[], |offset| &offset.coefficients));
        self.rows.surfaces.push(SurfaceRow {
            road: number,
            shapes,
            crossfall_left,
            crossfall_right,
            strip_offset,
            strips,
        });
    }

    /// Shape records, by station and t.
    fn shapes(&mut self, records: &[Shape], path: &str, findings: &mut Vec<Finding>) -> Range {
        let before = self.rows.shape_stations.len();
        let mut placed: Vec<(f64, CubicRow)> = Vec::with_capacity(records.len());
        for record in records {
            let mut part = ElementContext {
                span: record.span,
                path: ElementPath::new(path, "lateralProfile/shape"),
                findings,
            };
            let written = [
                ("s", &record.s),
                ("t", &record.t),
                ("a", &record.a),
                ("b", &record.b),
                ("c", &record.c),
                ("d", &record.d),
            ];
            let [Some(s), Some(t), Some(a), Some(b), Some(c), Some(d)] =
                written.map(|(name, attribute)| part.need(attribute.value(), name))
            else {
                continue;
            };
            placed.push((s, CubicRow { s: t, a, b, c, d }));
        }
        for station in placed.chunk_by(|(s, _), (z, _)| s == z) {
            let first = self.rows.cubics.len();
            self.rows.cubics.extend(station.iter().map(|(_, row)| *row));
            let records = self.cubics.add_apart(&self.rows.cubics, first);
            let s = station.first().map_or(0.0, |(s, _)| *s);
            self.rows.shape_stations.push(ShapeStationRow { s, records });
        }
        between(before, self.rows.shape_stations.len())
    }

    /// Strips of a cross-section surface.
    fn strips(&mut self, strips: &[xodr::Strip], path: &str, findings: &mut Vec<Finding>) -> Range {
        let before = self.rows.surface_strips.len();
        for strip in strips {
            let tail = "lateralProfile/crossSectionSurface/surfaceStrips/strip";
            let mut part =
                ElementContext { span: strip.span, path: ElementPath::new(path, tail), findings };
            let Some(id) = part.need(strip.id.value(), "id") else { continue };
            macro_rules! over_s {
                ($name:ident) => {
                    self.over_s(strip.$name.as_deref().map_or(&[], |part| &part.coefficients))
                };
            }
            let row = SurfaceStripRow {
                width: over_s!(width),
                constant: over_s!(constant),
                linear: over_s!(linear),
                quadratic: over_s!(quadratic),
                cubic: over_s!(cubic),
                id,
                mode: u32::from(strip.mode.value() == Some(StripMode::Relative)),
            };
            self.rows.surface_strips.push(row);
        }
        between(before, self.rows.surface_strips.len())
    }

    /// Coefficients over s; what is not written is 0, as the schema of 1.8 allows.
    fn over_s(&mut self, records: &[Coefficients]) -> Range {
        let before = self.rows.cubics.len();
        self.rows.cubics.extend(records.iter().map(|record| {
            let [s, a, b, c, d] = [&record.s, &record.a, &record.b, &record.c, &record.d]
                .map(|attribute| attribute.value().unwrap_or(0.0));
            CubicRow { s, a, b, c, d }
        }));
        self.cubics.add(&mut self.rows.cubics, before)
    }

    /// Appends heights and materials of the lane whose row comes next.
    pub(super) fn lane_surface(
        &mut self,
        heights: &[xodr::LaneHeight],
        materials: &[xodr::LaneMaterial],
        section_s: f64,
        road: &str,
        findings: &mut Vec<Finding>,
    ) {
        let lane = self.rows.lanes.len() as u32;
        for record in heights {
            let path = ElementPath::new(road, "lanes/laneSection/lane/height");
            let mut part = ElementContext { span: record.span, path, findings };
            let Some(s) = place(record.s_offset.value(), "sOffset", &mut part) else { continue };
            self.rows.lane_heights.push(LaneHeightRow {
                s: section_s + s,
                inner: record.inner.value().unwrap_or(0.0),
                outer: record.outer.value().unwrap_or(0.0),
                lane,
                reserved: 0,
            });
        }
        for record in materials {
            let path = ElementPath::new(road, "lanes/laneSection/lane/material");
            let mut part = ElementContext { span: record.span, path, findings };
            let Some(s) = place(record.s_offset.value(), "sOffset", &mut part) else { continue };
            let number = |value: Option<f64>| value.filter(|n| *n >= 0.0).unwrap_or(NOT_GIVEN);
            self.rows.lane_materials.push(LaneMaterialRow {
                s: section_s + s,
                friction: number(record.friction.value()),
                roughness: number(record.roughness.value()),
                lane,
                surface: self.strings.add(record.surface.text()),
            });
        }
    }
}

/// What a record needs that nothing else is built from: without it, the record alone is left out.
pub(super) fn place<T>(value: Option<T>, name: &str, part: &mut ElementContext<'_>) -> Option<T> {
    if value.is_none() {
        let message = format!("expected @{name}, found none that can be used; it is left out");
        part.add(&building::RECORD, Severity::Warning, message);
    }
    value
}
