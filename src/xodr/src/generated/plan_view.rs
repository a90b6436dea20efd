//! Elements of `plan_view`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/plan_view.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// The reference line in the plane (`t_road_planView`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlanView {
    /// The start tag.
    pub span: Span,
    /// `geometry`: A piece of the reference line.
    pub geometry: Vec<Geometry>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A piece of the reference line (`t_road_planView_geometry`; section 9.2).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Where the geometry begins along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@x` `[m]`: Inertial x of the start. Required since 1.5.
    pub x: Option<Attribute<f64>>,
    /// `@y` `[m]`: Inertial y of the start. Required since 1.5.
    pub y: Option<Attribute<f64>>,
    /// `@hdg` `[rad]`: Heading at the start. Required since 1.5.
    pub hdg: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length of the reference line over this geometry. At least 0 in 1.5. Above 0 since 1.7. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `line`: Straight.
    pub line: Option<Box<Line>>,
    /// `spiral`: Curvature that changes linearly.
    pub spiral: Option<Box<Spiral>>,
    /// `arc`: Constant curvature.
    pub arc: Option<Box<Arc>>,
    /// `poly3`: v as a cubic of u.
    pub poly3: Option<Box<Poly3>>,
    /// `paramPoly3`: u and v as cubics of a parameter.
    pub param_poly3: Option<Box<ParamPoly3>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Straight (`t_road_planView_geometry_line`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Curvature that changes linearly (`t_road_planView_geometry_spiral`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spiral {
    /// The start tag.
    pub span: Span,
    /// `@curvStart` `[1/m]`: Curvature at the start, positive to the left. Required since 1.5.
    pub curv_start: Option<Attribute<f64>>,
    /// `@curvEnd` `[1/m]`: Curvature at the end, positive to the left. Required since 1.5.
    pub curv_end: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Constant curvature (`t_road_planView_geometry_arc`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arc {
    /// The start tag.
    pub span: Span,
    /// `@curvature` `[1/m]`: Curvature, positive to the left. Required since 1.5.
    pub curvature: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// v as a cubic of u (`t_road_planView_geometry_poly3`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Poly3 {
    /// The start tag.
    pub span: Span,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5. Deprecated since 1.8.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1/m]`: Coefficient of the polynomial: linear. Required since 1.5. Deprecated since 1.8.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m²]`: Coefficient of the polynomial: quadratic. Required since 1.5. Deprecated since 1.8.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m³]`: Coefficient of the polynomial: cubic. Required since 1.5. Deprecated since 1.8.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// u and v as cubics of a parameter (`t_road_planView_geometry_paramPoly3`; section 9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParamPoly3 {
    /// The start tag.
    pub span: Span,
    /// `@aU` `[m]`: Coefficient of u: constant. Required since 1.5.
    pub a_u: Option<Attribute<f64>>,
    /// `@bU` `[1]`: Coefficient of u: linear. Required since 1.5.
    pub b_u: Option<Attribute<f64>>,
    /// `@cU` `[1/m]`: Coefficient of u: quadratic. Required since 1.5.
    pub c_u: Option<Attribute<f64>>,
    /// `@dU` `[1/m²]`: Coefficient of u: cubic. Required since 1.5.
    pub d_u: Option<Attribute<f64>>,
    /// `@aV` `[m]`: Coefficient of v: constant. Required since 1.5.
    pub a_v: Option<Attribute<f64>>,
    /// `@bV` `[1]`: Coefficient of v: linear. Required since 1.5.
    pub b_v: Option<Attribute<f64>>,
    /// `@cV` `[1/m]`: Coefficient of v: quadratic. Required since 1.5.
    pub c_v: Option<Attribute<f64>>,
    /// `@dV` `[1/m²]`: Coefficient of v: cubic. Required since 1.5.
    pub d_v: Option<Attribute<f64>>,
    /// `@pRange`: Range of the curve parameter. Required since 1.5.
    pub p_range: Option<Attribute<ParamPoly3Range>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
