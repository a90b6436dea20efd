//! Where the map lies on Earth, as the header says it, kept until its extent is known.

use crate::findings::finding;
use mapd_archive::GeoReferenceForm;
use mapd_geodesy::{DefinitionWarning, Offset};
use mapd_rules::Rule;
use mapd_xodr::{Finding, Severity, Span};

/// What the header says about the map's place, kept until its extent is known.
#[derive(Clone, Debug)]
pub(crate) struct StatedGeoreference {
    /// How the georeference is written.
    pub(crate) form: GeoReferenceForm,
    /// PROJ parameters; empty without a usable georeference.
    pub(crate) definition: String,
    /// As written.
    pub(crate) offset: Offset,
    pub(crate) header: Span,
    /// What is understood of the georeference only in part.
    pub(crate) warnings: Vec<DefinitionWarning>,
    pub(crate) offset_span: Span,
    /// Written by a tool that turns the sign.
    pub(crate) negating: bool,
    /// South, north, west, east, where all are stated.
    pub(crate) bounds: Option<[f64; 4]>,
}

impl Default for StatedGeoreference {
    fn default() -> Self {
        Self {
            form: GeoReferenceForm::Absent,
            definition: String::new(),
            offset: Offset::default(),
            header: Span::default(),
            warnings: Vec::new(),
            offset_span: Span::default(),
            negating: false,
            bounds: None,
        }
    }
}

impl StatedGeoreference {
    /// A finding about the offset.
    pub(crate) fn about_offset(
        &self,
        rule: &'static Rule,
        severity: Severity,
        message: String,
        hint: &str,
    ) -> Finding {
        let path = "OpenDRIVE/header/offset".to_owned();
        finding(rule, severity, self.offset_span, path, message, hint)
    }
}
