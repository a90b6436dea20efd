//! Walks over the elements of `additional_data`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/additional_data.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, keep};

impl Written for DataQuality {
    fn kind(&self) -> &'static str {
        "DataQuality"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("error", &self.error, visit);
        child("rawData", &self.raw_data, visit);
    }
}

impl Written for DataError {
    fn kind(&self) -> &'static str {
        "DataError"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("xyAbsolute", &self.xy_absolute, to);
        keep("zAbsolute", &self.z_absolute, to);
        keep("xyRelative", &self.xy_relative, to);
        keep("zRelative", &self.z_relative, to);
    }
}

impl Written for RawData {
    fn kind(&self) -> &'static str {
        "RawData"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("date", &self.date, to);
        keep("source", &self.source, to);
        keep("sourceComment", &self.source_comment, to);
        keep("postProcessing", &self.post_processing, to);
        keep("postProcessingComment", &self.post_processing_comment, to);
    }
}

impl Written for Include {
    fn kind(&self) -> &'static str {
        "Include"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("file", &self.file, to);
    }
}

impl Written for UserData {
    fn kind(&self) -> &'static str {
        "UserData"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("code", &self.code, to);
        keep("value", &self.value, to);
    }
}
