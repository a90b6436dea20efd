//! Walks over the elements of `road_mark`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road_mark.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, child, children};

impl Written for RoadMark {
    fn kind(&self) -> &'static str {
        "RoadMark"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("sway", &self.sway, visit);
        child("type", &self.type_element, visit);
        child("explicit", &self.explicit, visit);
    }
}

impl Written for Sway {
    fn kind(&self) -> &'static str {
        "Sway"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for RoadMarkPattern {
    fn kind(&self) -> &'static str {
        "RoadMarkPattern"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("line", &self.line, visit);
    }
}

impl Written for RoadMarkLine {
    fn kind(&self) -> &'static str {
        "RoadMarkLine"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for ExplicitRoadMark {
    fn kind(&self) -> &'static str {
        "ExplicitRoadMark"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("line", &self.line, visit);
    }
}

impl Written for ExplicitLine {
    fn kind(&self) -> &'static str {
        "ExplicitLine"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
