//! Parametric cubics of the reference line.

use crate::example::Example::PlanView;
use crate::line::Fault;
use crate::place::{RoadIn, number, value};
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Geometry, ParamPoly3, ParamPoly3Range, Severity};

/// Difference of a curve's true length and the written one, as in ASAM's checker.
const LENGTH: Tolerance = Tolerance { name: "difference of lengths", value: 1e-3, unit: "m" };
/// Coefficients that count as 0.
const ZERO: Tolerance = Tolerance { name: "coefficient that counts as 0", value: 1e-6, unit: "m" };

/// Geometries are curves. Where this is an error, it stands for what building finds about the same.
pub const COMPUTABLE: &str = "mapd:xodr:1.4.0:geometry.computable";

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.geometry.paramPoly3.valid_parameters",
        "A parametric cubic leaves its start along the heading: aU, aV, bV are 0 and bU is above 0.",
        Road(valid_parameters),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="arcLength"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="2" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="arcLength"/></geometry>"#,
            ),
        ],
    )
    .within(&[ZERO]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.geometry.paramPoly3.length_match",
        "A parametric cubic over the range from 0 to 1 (the default) has its stated length.",
        Road(length_match),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="100" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="99" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></geometry>"#,
            ),
        ],
    )
    .asam(Severity::Warning)
    .within(&[LENGTH]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.geometry.paramPoly3.arcLength_range",
        "With the range arcLength, the parameter of a cubic runs from 0 to the geometry's length, and the curve has that length.",
        Road(arc_length_range),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="arcLength"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="100" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="arcLength"/></geometry>"#,
            ),
        ],
    )
    .within(&[LENGTH]),
    Rule::error(
        COMPUTABLE,
        [
            "A geometry is a curve that can be evaluated.",
            "there is no curve for lanes to follow",
        ],
        Road(computable),
        [
            PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry>"#),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" bU="0" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></geometry>"#,
            ),
        ],
    ),
];

const PART: &str = "planView/geometry";

fn cubics<'a>(of: &RoadIn<'a>) -> impl Iterator<Item = (usize, &'a Geometry, &'a ParamPoly3)> {
    let all = of.road.plan_view.iter().flat_map(|plan_view| &plan_view.geometry).enumerate();
    all.filter_map(|(at, geometry)| Some((at, geometry, geometry.param_poly3.as_deref()?)))
}

fn valid_parameters(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (_, geometry, cubic) in cubics(of) {
        for (name, coefficient) in [("aU", &cubic.a_u), ("aV", &cubic.a_v), ("bV", &cubic.b_v)] {
            let value = number(coefficient);
            if value.abs() > ZERO.value {
                sink.add_within(PART, geometry.span, format_args!("{name} = 0"), value);
            }
        }
        if let Some(b_u) = cubic.b_u.filter(|b_u| b_u.value <= 0.0) {
            sink.add_within(PART, geometry.span, "bU above 0", b_u.value);
        }
    }
}

/// By how much a geometry's curve is longer than it says `[m]`; none where it cannot be evaluated.
fn mismatch(of: &RoadIn<'_>, at: usize) -> Option<f64> {
    Some(of.line.piece(at)?.compiled.length_mismatch)
}

/// Cubics whose curve is longer or shorter than they say, by how much `[m]`: those over arc length, or the others.
fn mismatched<'a>(
    of: &RoadIn<'a>,
    over_arc_length: bool,
) -> impl Iterator<Item = (&'a Geometry, f64)> {
    cubics(of).filter_map(move |(at, geometry, cubic)| {
        let is_over = value(&cubic.p_range) == Some(ParamPoly3Range::ArcLength);
        let longer = mismatch(of, at).filter(|longer| longer.abs() > LENGTH.value)?;
        (is_over == over_arc_length).then_some((geometry, longer))
    })
}

fn length_match(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (geometry, longer) in mismatched(of, false) {
        let length = number(&geometry.length);
        let expected = format_args!("a curve of the length {length} m");
        let found = format_args!("one that is {longer:.6} m longer; scaled to the written length");
        sink.add_within(PART, geometry.span, expected, found);
    }
}

fn arc_length_range(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (geometry, longer) in mismatched(of, true) {
        let length = number(&geometry.length);
        let expected = format_args!("a parameter from 0 to {length} that is the arc length");
        let found = format_args!("a curve {longer:.6} m longer; scaled to the written length");
        sink.add_within(PART, geometry.span, expected, found);
    }
}

fn computable(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = of.road.plan_view.as_deref().map_or(&[][..], |plan_view| &plan_view.geometry);
    for (at, fault) in &of.line.faults {
        if let (Fault::Curve(error), Some(geometry)) = (fault, all.get(*at)) {
            let said = error.to_string();
            let bound = said.strip_prefix("expected ").and_then(|said| said.split_once(", found "));
            let (expected, found) = match bound {
                Some((expected, found)) => (expected, found.to_owned()),
                None => ("a curve that can be evaluated", format!("that {said}")),
            };
            sink.add_within(PART, geometry.span, expected, found);
        }
    }
}
