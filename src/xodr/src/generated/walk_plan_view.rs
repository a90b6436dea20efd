//! Walks over the elements of `plan_view`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/plan_view.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, child, children};

impl Written for PlanView {
    fn kind(&self) -> &'static str {
        "PlanView"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("geometry", &self.geometry, visit);
    }
}

impl Written for Geometry {
    fn kind(&self) -> &'static str {
        "Geometry"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("line", &self.line, visit);
        child("spiral", &self.spiral, visit);
        child("arc", &self.arc, visit);
        child("poly3", &self.poly3, visit);
        child("paramPoly3", &self.param_poly3, visit);
    }
}

impl Written for Line {
    fn kind(&self) -> &'static str {
        "Line"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Spiral {
    fn kind(&self) -> &'static str {
        "Spiral"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Arc {
    fn kind(&self) -> &'static str {
        "Arc"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Poly3 {
    fn kind(&self) -> &'static str {
        "Poly3"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for ParamPoly3 {
    fn kind(&self) -> &'static str {
        "ParamPoly3"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
