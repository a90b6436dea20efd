//! What the header says about the map's place (ASAM OpenDRIVE 1.8.1, 8.4).

use crate::draft::StatedGeoreference;
use crate::findings::finding;
use glam::DVec3;
use mapd_archive::GeoReferenceForm;
use mapd_geodesy::{Form, Offset, Reference};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Header, Severity, Text as _, Value as _};

/// What the names of tools that write the turned sign contain, in lower case.
const NEGATING: [&str; 2] = ["sumo", "netconvert"];

impl StatedGeoreference {
    /// Reads what the header says.
    pub(crate) fn read(header: &Header, findings: &mut Vec<Finding>) -> Self {
        let mut placed = Self { header: header.span, ..Self::default() };
        let names = [header.vendor.text(), header.name.text()];
        placed.negating = names
            .iter()
            .map(|name| name.to_ascii_lowercase())
            .any(|name| NEGATING.iter().any(|tool| name.contains(tool)));
        let stated = [&header.south, &header.north, &header.west, &header.east];
        let stated = stated.map(|side| side.value().filter(|side| side.is_finite()));
        placed.bounds = match stated {
            // All zero stands for "not known" in many files.
            [Some(s), Some(n), Some(w), Some(e)] if [s, n, w, e] != [0.0; 4] => Some([s, n, w, e]),
            _ => None,
        };
        if let Some(offset) = &header.offset {
            let number = |value: Option<f64>| value.filter(|v| v.is_finite()).unwrap_or(0.0);
            let [x, y, z] = [&offset.x, &offset.y, &offset.z].map(|v| number(v.value()));
            let heading = number(offset.hdg.value());
            placed.offset = Offset { shift: DVec3::new(x, y, z), heading };
            placed.offset_span = offset.span;
            if heading != 0.0 && (x != 0.0 || y != 0.0) {
                let message = "the standard's texts disagree on whether the offset turns or shifts first; it is applied as their formula has it: turned by hdg, then shifted by x, y, z";
                let hint = "write an offset with hdg=\"0\"";
                findings.push(placed.about_offset(
                    &building::OFFSET_ORDER,
                    Severity::Warning,
                    message.into(),
                    hint,
                ));
            }
        }
        let Some(written) = &header.geo_reference else { return placed };
        let path = "OpenDRIVE/header/geoReference";
        let Some(reference) = Reference::read(written.content.text()) else { return placed };
        placed.form = form(reference.form);
        for doubt in &reference.warnings {
            let severity = if doubt.is_grave() { Severity::Warning } else { Severity::Info };
            let message = doubt.to_string();
            findings.push(finding(
                &building::GEO_REFERENCE,
                severity,
                written.span,
                path.into(),
                message,
                "",
            ));
        }
        placed.warnings = reference.warnings;
        match reference.definition {
            Ok(definition) => placed.definition = definition,
            Err(error) => {
                let message = format!("the georeference cannot be used: {error}");
                let hint = "state PROJ parameters, such as +proj=utm +zone=32 +datum=WGS84";
                let severity = Severity::Warning;
                findings.push(finding(
                    &building::GEO_REFERENCE,
                    severity,
                    written.span,
                    path.into(),
                    message,
                    hint,
                ));
            }
        }
        placed
    }
}

fn form(form: Form) -> GeoReferenceForm {
    match form {
        Form::Absent => GeoReferenceForm::Absent,
        Form::Proj => GeoReferenceForm::Proj,
        Form::Parameters => GeoReferenceForm::Parameters,
        Form::Epsg => GeoReferenceForm::Epsg,
        Form::Wkt1 => GeoReferenceForm::Wkt1,
        Form::Wkt2 => GeoReferenceForm::Wkt2,
        Form::Other => GeoReferenceForm::Other,
    }
}
