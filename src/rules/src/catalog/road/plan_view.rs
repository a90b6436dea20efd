//! The reference line in the plane.

use crate::example::Example::PlanView;
use crate::line::Piece;
use crate::place::RoadIn;
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_geometry::normalize_angle;
use mapd_xodr::{Geometry, Severity};

/// Differences of places along s that come from rounding in the file.
pub(crate) const S_ROUNDING: Tolerance =
    Tolerance { name: "difference of s that counts as rounding", value: 1e-3, unit: "m" };
/// Differences of places along s beyond which the reference line is not what its author meant.
const S_BROKEN: Tolerance =
    Tolerance { name: "difference of s that is an error", value: 0.1, unit: "m" };
/// Differences of lengths that come from rounding in the file: many geometries of 4 decimals each.
const LENGTH: Tolerance = Tolerance { name: "difference of lengths", value: 0.01, unit: "m" };
/// Gaps that come from rounding in the file.
pub(crate) const GAP: Tolerance = Tolerance { name: "gap", value: 0.01, unit: "m" };
/// Gaps beyond which the reference line is broken: more than a lane marking is wide.
const GAP_BROKEN: Tolerance = Tolerance { name: "gap that is an error", value: 1.0, unit: "m" };
/// Kinks that come from rounding in the file.
pub(crate) const KINK: Tolerance = Tolerance { name: "kink", value: 1e-3, unit: "rad" };
/// Kinks beyond which borders cross one another: an eighth of a full turn. Road data of polygons have smaller ones at every
/// corner and can be driven.
const KINK_BROKEN: Tolerance =
    Tolerance { name: "kink that is an error", value: std::f64::consts::FRAC_PI_4, unit: "rad" };
/// Steps of curvature that come from rounding in the file.
const CURVATURE: Tolerance = Tolerance { name: "step of curvature", value: 1e-3, unit: "1/m" };

pub(super) static RULES: &[Rule] = &[
    Rule::error(
        "mapd:xodr:1.4.0:geometry.s_monotonic",
        [
            "The first geometry begins at s = 0, each other one at the end of the one before it.",
            "beyond rounding (warning), some s has no point, or two",
        ],
        Road(s_monotonic),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="41" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
        ],
    )
    .within(&[S_ROUNDING, S_BROKEN]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.geometry.s-value_sum",
        "s of a geometry is the sum of the lengths before it.",
        Road(s_is_sum),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40.02" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
        ],
    )
    .within(&[LENGTH]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.length_sum_geometries",
        "The length of a road is the sum of the lengths of its geometries.",
        Road(length_is_sum),
        [
            PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry>"#),
            PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="99"><line/></geometry>"#),
        ],
    )
    .also(&["mapd:xodr:1.4.0:geometry.length_agreement"])
    .within(&[LENGTH]),
    Rule::error(
        "asam.net:xodr:1.4.0:road.geometry.refline_no_gaps",
        [
            "A geometry begins at the end point of the one before it.",
            "beyond 1 m (below: warning) the road is interrupted; nobody can drive along it",
        ],
        Road(gaps),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="5" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
        ],
    )
    .also(&["mapd:xodr:1.4.0:geometry.g0_gap"])
    .within(&[GAP, GAP_BROKEN]),
    Rule::error(
        "asam.net:xodr:1.4.0:road.geometry.refline_no_kinks",
        [
            "A geometry begins with the end heading of the one before it.",
            "beyond 45° (below: warning) lanes fold on the inside of the turn",
        ],
        Road(kinks),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="1.57" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
        ],
    )
    .also(&["mapd:xodr:1.4.0:geometry.g1_heading"])
    .within(&[KINK, KINK_BROKEN]),
    Rule::info(
        "mapd:xodr:1.4.0:geometry.g2_curvature",
        "Curvature has no steps; the standard allows a line to join an arc.",
        Road(curvature_steps),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><spiral curvStart="0" curvEnd="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>
<geometry s="40" x="40" y="0" hdg="0" length="60"><arc curvature="0.01"/></geometry>"#,
            ),
        ],
    )
    .within(&[CURVATURE]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.geometry.arc.no_zero_curvature",
        "An arc has a curvature other than 0; use a line otherwise.",
        Road(straight_arcs),
        [
            PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><arc curvature="0.01"/></geometry>"#),
            PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><arc curvature="0"/></geometry>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.geometry.spiral.curvature_change",
        "A spiral begins and ends with different curvatures; use an arc or line otherwise.",
        Road(even_spirals),
        [
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><spiral curvStart="0" curvEnd="0.01"/></geometry>"#,
            ),
            PlanView(
                r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><spiral curvStart="0.01" curvEnd="0.01"/></geometry>"#,
            ),
        ],
    )
    .advisory(),
];

const PART: &str = "planView/geometry";

fn geometries<'a>(of: &RoadIn<'a>) -> &'a [Geometry] {
    of.road.plan_view.as_ref().map_or(&[], |plan_view| &plan_view.geometry)
}

fn s_monotonic(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let mut due = 0.0;
    for (rank, geometry) in geometries(of).iter().enumerate() {
        // What is missing is told of as such; where the next one should begin is then not known.
        let (Some(s), Some(length)) = (geometry.s, geometry.length) else { return };
        let (s, length) = (s.value, length.value);
        let difference = (s - due).abs();
        if difference > S_ROUNDING.value {
            let severity = grade(difference, S_BROKEN);
            let what = if rank == 0 { "s =" } else { "s where the geometry before ends, at" };
            sink.add_milder(severity, PART, geometry.span, format_args!("{what} {due}"), s);
        }
        due = s + length;
    }
}

fn s_is_sum(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let mut sum = 0.0;
    for geometry in geometries(of) {
        let (Some(s), Some(length)) = (geometry.s, geometry.length) else { return };
        let (s, length) = (s.value, length.value);
        if (s - sum).abs() > LENGTH.value {
            sink.add_within(
                PART,
                geometry.span,
                format_args!("s = {sum}, the lengths before it"),
                s,
            );
            return;
        }
        sum += length;
    }
}

fn length_is_sum(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = geometries(of);
    // A length that is missing or cannot be read is told of as such.
    let lengths = all.iter().map(|geometry| Some(geometry.length?.value));
    let (Some(length), Some(sum)) = (of.road.length, lengths.sum::<Option<f64>>()) else { return };
    let length = length.value;
    if !all.is_empty() && (length - sum).abs() > LENGTH.value {
        let expected = format_args!("a length of {sum} m, that of the geometries together");
        sink.add_within("@length", of.road.span, expected, format_args!("{length} m"));
    }
}

/// Shows each joint: the geometry behind it, and what is told of the ends of the pieces that meet there, the first one's end first.
fn joints<T>(
    of: &RoadIn<'_>,
    tell: impl Fn(&Piece, f64) -> Option<T>,
    mut show: impl FnMut(&Geometry, [T; 2]),
) {
    let all = geometries(of);
    for pair in of.line.pieces.windows(2).filter(|pair| pair[0].index + 1 == pair[1].index) {
        let (Some(end), Some(start)) = (tell(&pair[0], pair[0].length), tell(&pair[1], 0.0)) else {
            continue;
        };
        let Some(geometry) = all.get(pair[1].index) else { continue };
        show(geometry, [end, start]);
    }
}

/// A warning up to the second bound.
fn grade(value: f64, broken: Tolerance) -> Severity {
    if value > broken.value { Severity::Error } else { Severity::Warning }
}

fn gaps(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    joints(of, Piece::place, |geometry, [[end_x, end_y], [x, y]]| {
        let gap = mapd_geometry::hypot(x - end_x, y - end_y);
        if gap > GAP.value {
            let found = format_args!("one {gap:.3} m away; kept as written");
            let expected = "a start where the geometry before ends";
            sink.add_milder(grade(gap, GAP_BROKEN), PART, geometry.span, expected, found);
        }
    });
}

fn kinks(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    joints(of, Piece::heading, |geometry, [end, start]| {
        let kink = normalize_angle(start - end).abs();
        if kink > KINK.value {
            let found = format_args!("one that differs by {kink:.6} rad");
            let expected = "the heading that the geometry before ends with";
            sink.add_milder(grade(kink, KINK_BROKEN), PART, geometry.span, expected, found);
        }
    });
}

fn curvature_steps(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    joints(of, Piece::curvature, |geometry, [end, start]| {
        let step = (start - end).abs();
        if step > CURVATURE.value {
            let found = format_args!("a step by {step:.6} 1/m");
            sink.add_within(PART, geometry.span, "a steady curvature", found);
        }
    });
}

fn straight_arcs(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for geometry in geometries(of) {
        let curvature = geometry.arc.as_ref().and_then(|arc| arc.curvature);
        if curvature.is_some_and(|curvature| curvature.value == 0.0) {
            sink.add_within(PART, geometry.span, "an arc with a curvature", "0");
        }
    }
}

fn even_spirals(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for geometry in geometries(of) {
        let Some(spiral) = &geometry.spiral else { continue };
        // What is missing is told of as such.
        let (Some(start), Some(end)) = (spiral.curv_start, spiral.curv_end) else { continue };
        let (start, end) = (start.value, end.value);
        if start == end {
            let found = format_args!("{start} at both ends");
            sink.add_within(PART, geometry.span, "a spiral whose curvature changes", found);
        }
    }
}
