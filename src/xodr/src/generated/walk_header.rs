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
    fn kept(&self, to: Keep<'_>) {
        keep("type", &self.r#type, to);
        keep("subtype", &self.subtype, to);
    }
    fn children(&self, visit: Visit<'_>) {
        child("semantics", &self.semantics, visit);
    }
}
