//! Elements of `profiles`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/profiles.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Heights along the reference line (`t_road_elevationProfile`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElevationProfile {
    /// The start tag.
    pub span: Span,
    /// `elevation`: Height of the reference line, a cubic of the distance from s.
    pub elevation: Vec<Elevation>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Height of the reference line, a cubic of the distance from s (`t_road_elevationProfile_elevation`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Elevation {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Shape of the surface across the road (`t_road_lateralProfile`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LateralProfile {
    /// The start tag.
    pub span: Span,
    /// `superelevation`: Roll of the road, a cubic of the distance from s.
    pub superelevation: Vec<Superelevation>,
    /// `crossfall`: Angle of the surface per side, a cubic of the distance from s. Until 1.5.
    pub crossfall: Vec<Crossfall>,
    /// `shape`: Height across the road at s, a cubic of the distance from t.
    pub shape: Vec<Shape>,
    /// `crossSectionSurface`: Surface across the road, as strips. Since 1.8.
    pub cross_section_surface: Option<Box<CrossSectionSurface>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Roll of the road, a cubic of the distance from s (`t_road_lateralProfile_superelevation`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Superelevation {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@a` `[rad]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[rad/m]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[rad/m²]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[rad/m³]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Angle of the surface per side, a cubic of the distance from s (`t_road_lateralProfile_crossfall`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crossfall {
    /// The start tag.
    pub span: Span,
    /// `@side`: Side. Required in 1.5. Until 1.5.
    pub side: Option<Attribute<CrossfallSide>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@a`: Coefficient of the polynomial: constant. Required in 1.5. Until 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b`: Coefficient of the polynomial: linear. Required in 1.5. Until 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c`: Coefficient of the polynomial: quadratic. Required in 1.5. Until 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d`: Coefficient of the polynomial: cubic. Required in 1.5. Until 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Height across the road at s, a cubic of the distance from t (`t_road_lateralProfile_shape`; section 10.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance at which the polynomial begins. Required since 1.5.
    pub t: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface across the road, as strips (`t_road_lateralProfile_crossSectionSurface`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossSectionSurface {
    /// The start tag.
    pub span: Span,
    /// `tOffset`: Lateral offset of the surface.
    pub t_offset: Option<Box<SurfaceOffset>>,
    /// `surfaceStrips`: The strips of a surface.
    pub surface_strips: Option<Box<SurfaceStrips>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lateral offset of the surface (`t_road_lateralProfile_crossSectionSurface_tOffset`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceOffset {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A cubic of the distance from s (`t_road_lateralProfile_crossSectionSurface_coefficients`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// The start tag.
    pub span: Span,
    /// `@a` `[m]`: Coefficient of the polynomial: constant.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[m/m]`: Coefficient of the polynomial: linear.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[m/m²]`: Coefficient of the polynomial: quadratic.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[m/m³]`: Coefficient of the polynomial: cubic.
    pub d: Option<Attribute<f64>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0. Required by the text since 1.8.
    pub s: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The strips of a surface (`t_road_lateralProfile_crossSectionSurface_surfaceStrip`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceStrips {
    /// The start tag.
    pub span: Span,
    /// `strip`: A strip of the cross section.
    pub strip: Vec<Strip>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A strip of the cross section (`t_road_lateralProfile_crossSectionSurface_strip`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Strip {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required by the text since 1.8.
    pub id: Option<Attribute<i32>>,
    /// `@mode`: How it is applied.
    pub mode: Option<Attribute<StripMode>>,
    /// `width`: Width of a strip.
    pub width: Option<Box<StripWidth>>,
    /// `constant`: Constant part of the height over a strip.
    pub constant: Option<Box<StripConstant>>,
    /// `linear`: Linear part of the height over a strip.
    pub linear: Option<Box<StripLinear>>,
    /// `quadratic`: Quadratic part of the height over a strip.
    pub quadratic: Option<Box<StripQuadratic>>,
    /// `cubic`: Cubic part of the height over a strip.
    pub cubic: Option<Box<StripCubic>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Width of a strip (`t_road_lateralProfile_crossSectionSurface_strip_width`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripWidth {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Constant part of the height over a strip (`t_road_lateralProfile_crossSectionSurface_strip_constant`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripConstant {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Linear part of the height over a strip (`t_road_lateralProfile_crossSectionSurface_strip_linear`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripLinear {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Quadratic part of the height over a strip (`t_road_lateralProfile_crossSectionSurface_strip_quadratic`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripQuadratic {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Cubic part of the height over a strip (`t_road_lateralProfile_crossSectionSurface_strip_cubic`; section 10.5; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StripCubic {
    /// The start tag.
    pub span: Span,
    /// `coefficients`: A cubic of the distance from s.
    pub coefficients: Vec<Coefficients>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
