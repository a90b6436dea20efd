//! Walks over the elements of `object_outlines`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/object_outlines.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Outline {
    fn kind(&self) -> &'static str {
        "Outline"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("cornerRoad", &self.corner_road, visit);
        children("cornerLocal", &self.corner_local, visit);
        children("curveLocal", &self.curve_local, visit);
        child("markings", &self.markings, visit);
    }
}

impl Written for CornerRoad {
    fn kind(&self) -> &'static str {
        "CornerRoad"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for CornerLocal {
    fn kind(&self) -> &'static str {
        "CornerLocal"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for CurveLocal {
    fn kind(&self) -> &'static str {
        "CurveLocal"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("arc", &self.arc, visit);
        child("line", &self.line, visit);
        child("paramPoly3", &self.param_poly3, visit);
    }
}

impl Written for CurveLocalArc {
    fn kind(&self) -> &'static str {
        "CurveLocalArc"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for CurveLocalLine {
    fn kind(&self) -> &'static str {
        "CurveLocalLine"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for CurveLocalParamPoly3 {
    fn kind(&self) -> &'static str {
        "CurveLocalParamPoly3"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Markings {
    fn kind(&self) -> &'static str {
        "Markings"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("marking", &self.marking, visit);
    }
}

impl Written for Marking {
    fn kind(&self) -> &'static str {
        "Marking"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("cornerReference", &self.corner_reference, visit);
    }
}

impl Written for CornerReference {
    fn kind(&self) -> &'static str {
        "CornerReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Outlines {
    fn kind(&self) -> &'static str {
        "Outlines"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("outline", &self.outline, visit);
    }
}

impl Written for ObjectBorders {
    fn kind(&self) -> &'static str {
        "ObjectBorders"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("border", &self.border, visit);
    }
}

impl Written for ObjectBorder {
    fn kind(&self) -> &'static str {
        "ObjectBorder"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("cornerReference", &self.corner_reference, visit);
    }
}

impl Written for Skeleton {
    fn kind(&self) -> &'static str {
        "Skeleton"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("polyline", &self.polyline, visit);
    }
}

impl Written for Polyline {
    fn kind(&self) -> &'static str {
        "Polyline"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("id", &self.id, to);
    }
    fn children(&self, visit: Visit<'_>) {
        children("vertexRoad", &self.vertex_road, visit);
        children("vertexLocal", &self.vertex_local, visit);
    }
}

impl Written for VertexRoad {
    fn kind(&self) -> &'static str {
        "VertexRoad"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("id", &self.id, to);
    }
}

impl Written for VertexLocal {
    fn kind(&self) -> &'static str {
        "VertexLocal"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("id", &self.id, to);
    }
}
