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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.error.as_deref().is_none_or(Written::is_bare)
            && self.raw_data.as_deref().is_none_or(Written::is_bare)
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.xy_absolute.is_none()
            && self.z_absolute.is_none()
            && self.xy_relative.is_none()
            && self.z_relative.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.date.is_none()
            && self.source.is_none()
            && self.source_comment.is_none()
            && self.post_processing.is_none()
            && self.post_processing_comment.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.file.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.code.is_none() && self.value.is_none()
    }
    fn kept(&self, to: Keep<'_>) {
        keep("code", &self.code, to);
        keep("value", &self.value, to);
    }
}
