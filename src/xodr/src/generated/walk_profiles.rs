//! Walks over the elements of `profiles`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/profiles.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, child, children};

impl Written for ElevationProfile {
    fn kind(&self) -> &'static str {
        "ElevationProfile"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("elevation", &self.elevation, visit);
    }
}

impl Written for Elevation {
    fn kind(&self) -> &'static str {
        "Elevation"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LateralProfile {
    fn kind(&self) -> &'static str {
        "LateralProfile"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("superelevation", &self.superelevation, visit);
        children("crossfall", &self.crossfall, visit);
        children("shape", &self.shape, visit);
        child("crossSectionSurface", &self.cross_section_surface, visit);
    }
}

impl Written for Superelevation {
    fn kind(&self) -> &'static str {
        "Superelevation"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Crossfall {
    fn kind(&self) -> &'static str {
        "Crossfall"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Shape {
    fn kind(&self) -> &'static str {
        "Shape"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for CrossSectionSurface {
    fn kind(&self) -> &'static str {
        "CrossSectionSurface"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("tOffset", &self.t_offset, visit);
        child("surfaceStrips", &self.surface_strips, visit);
    }
}

impl Written for SurfaceOffset {
    fn kind(&self) -> &'static str {
        "SurfaceOffset"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}

impl Written for Coefficients {
    fn kind(&self) -> &'static str {
        "Coefficients"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SurfaceStrips {
    fn kind(&self) -> &'static str {
        "SurfaceStrips"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("strip", &self.strip, visit);
    }
}

impl Written for Strip {
    fn kind(&self) -> &'static str {
        "Strip"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("width", &self.width, visit);
        child("constant", &self.constant, visit);
        child("linear", &self.linear, visit);
        child("quadratic", &self.quadratic, visit);
        child("cubic", &self.cubic, visit);
    }
}

impl Written for StripWidth {
    fn kind(&self) -> &'static str {
        "StripWidth"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}

impl Written for StripConstant {
    fn kind(&self) -> &'static str {
        "StripConstant"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}

impl Written for StripLinear {
    fn kind(&self) -> &'static str {
        "StripLinear"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}

impl Written for StripQuadratic {
    fn kind(&self) -> &'static str {
        "StripQuadratic"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}

impl Written for StripCubic {
    fn kind(&self) -> &'static str {
        "StripCubic"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("coefficients", &self.coefficients, visit);
    }
}
