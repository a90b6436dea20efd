//! Walks over the elements of `header`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/header.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Header {
    fn kind(&self) -> &'static str {
        "Header"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.geo_reference.as_deref().is_none_or(Written::is_bare)
            && self.offset.as_deref().is_none_or(Written::is_bare)
            && self.license.as_deref().is_none_or(Written::is_bare)
            && self.default_regulations.as_deref().is_none_or(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        child("geoReference", &self.geo_reference, visit);
        child("offset", &self.offset, visit);
        child("license", &self.license, visit);
        child("defaultRegulations", &self.default_regulations, visit);
    }
}

impl Written for GeoReference {
    fn kind(&self) -> &'static str {
        "GeoReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
    }
}

impl Written for Offset {
    fn kind(&self) -> &'static str {
        "Offset"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
    }
}

impl Written for License {
    fn kind(&self) -> &'static str {
        "License"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.name.is_none()
            && self.spdxid.is_none()
            && self.text.is_none()
            && self.resource.is_none()
    }
    fn kept(&self, to: Keep<'_>) {
        keep("name", &self.name, to);
        keep("spdxid", &self.spdxid, to);
        keep("text", &self.text, to);
        keep("resource", &self.resource, to);
    }
}

impl Written for DefaultRegulations {
    fn kind(&self) -> &'static str {
        "DefaultRegulations"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.road_regulations.iter().all(Written::is_bare)
            && self.signal_regulations.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("roadRegulations", &self.road_regulations, visit);
        children("signalRegulations", &self.signal_regulations, visit);
    }
}

impl Written for RoadRegulation {
    fn kind(&self) -> &'static str {
        "RoadRegulation"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.semantics.as_deref().is_none_or(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        child("semantics", &self.semantics, visit);
    }
}

impl Written for SignalRegulation {
    fn kind(&self) -> &'static str {
        "SignalRegulation"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.semantics.as_deref().is_none_or(Written::is_bare)
            && self.r#type.is_none()
            && self.subtype.is_none()
    }
    fn kept(&self, to: Keep<'_>) {
        keep("type", &self.r#type, to);
        keep("subtype", &self.subtype, to);
    }
    fn children(&self, visit: Visit<'_>) {
        child("semantics", &self.semantics, visit);
    }
}
