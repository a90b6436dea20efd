//! The surface across the road: shape, superelevation, strips.

use crate::example::Example::Road as In;
use crate::place::{RoadIn, Side, number, value};
use crate::profile::borders_at;
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Coefficients, Span, Strip};

/// How far lanes may reach beyond the shapes.
const COVER: Tolerance = Tolerance { name: "reach beyond the shapes", value: 0.01, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:road.cross_section_surface.no_shape_superelevation",
        "A cross-section surface replaces shape and superelevation; it does not occur together with them.",
        Road(alone),
        [
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
            In(r#"<lateralProfile><superelevation s="0" a="0.01" b="0" c="0" d="0"/><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.cross_section_surface.start_end_match_with_refline",
        "The coefficients of a cross-section surface begin at the start of the road.",
        Road(whole_road),
        [
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="20" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.cross_section_surface.use_strip",
        "The only strip on its side has the id 1 or -1 and no width.",
        Road(lone_strip),
        [
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-2"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:road.cross_section_surface.use_width",
        "Of two strips on a side, the inner one has a width.",
        Road(inner_width),
        [
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><width><coefficients s="0" a="2" b="0" c="0" d="0"/></width><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip><strip id="-2"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
            In(r#"<lateralProfile><crossSectionSurface><surfaceStrips><strip id="-1"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip><strip id="-2"><constant><coefficients s="0" a="0" b="0" c="0" d="0"/></constant></strip></surfaceStrips></crossSectionSurface></lateralProfile>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.use_cases.shape_elements_start_right",
        "The shapes of one s begin on the right side or at the reference line.",
        Road(starts_right),
        [
            In(r#"<lateralProfile><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#),
            In(r#"<lateralProfile><shape s="0" t="1" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#),
        ],
    )
    .within(&[COVER]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.shape.t_definition_coverage",
        "Shapes cover the road where it is widest to the right; the last one goes on to the left.",
        Road(coverage),
        [
            In(r#"<lateralProfile><shape s="0" t="-5" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#),
            In(r#"<lateralProfile><shape s="0" t="-2" a="0" b="0.01" c="0" d="0"/></lateralProfile>"#),
        ],
    )
    .within(&[COVER]),
];

fn alone(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let Some(profile) = &of.road.lateral_profile else { return };
    let Some(surface) = &profile.cross_section_surface else { return };
    for (name, is_there) in [
        ("superelevation", !profile.superelevation.is_empty()),
        ("shape", !profile.shape.is_empty()),
    ] {
        if is_there {
            let expected = format_args!("no {name} beside it");
            sink.add_within("lateralProfile/crossSectionSurface", surface.span, expected, "one");
        }
    }
}

fn strips<'a>(of: &RoadIn<'a>) -> impl Iterator<Item = &'a Strip> + use<'a> {
    let surface = of.road.lateral_profile.iter().filter_map(|p| p.cross_section_surface.as_ref());
    surface.filter_map(|surface| surface.surface_strips.as_ref()).flat_map(|strips| &strips.strip)
}

const STRIP: &str = "lateralProfile/crossSectionSurface/surfaceStrips/strip";

fn whole_road(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for strip in strips(of) {
        let lists: [Option<(Span, &[Coefficients])>; 5] = [
            strip.width.as_ref().map(|list| (list.span, &*list.coefficients)),
            strip.constant.as_ref().map(|list| (list.span, &*list.coefficients)),
            strip.linear.as_ref().map(|list| (list.span, &*list.coefficients)),
            strip.quadratic.as_ref().map(|list| (list.span, &*list.coefficients)),
            strip.cubic.as_ref().map(|list| (list.span, &*list.coefficients)),
        ];
        for (span, list) in lists.into_iter().flatten() {
            let first = list.first().map(|first| number(&first.s));
            if first != Some(0.0) {
                let found = first.map_or("none".to_owned(), |s| s.to_string());
                sink.add_within(STRIP, span, "first coefficients at s = 0", found);
            }
        }
    }
}

/// Strips of each side.
fn by_side<'a>(of: &RoadIn<'a>) -> [Vec<(i32, &'a Strip)>; 2] {
    let mut sides = [Vec::new(), Vec::new()];
    for strip in strips(of) {
        let id = value(&strip.id).unwrap_or(0);
        sides[usize::from(id < 0)].push((id, strip));
    }
    sides
}

fn lone_strip(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for side in by_side(of) {
        if let [(id, strip)] = side[..] {
            if id.unsigned_abs() != 1 {
                sink.add_within(
                    STRIP,
                    strip.span,
                    "the id 1 or -1 of the only strip of a side",
                    id,
                );
            }
            if strip.width.is_some() {
                sink.add_within(STRIP, strip.span, "no width of the only strip of a side", "one");
            }
        }
    }
}

fn inner_width(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for side in by_side(of).iter().filter(|side| side.len() > 1) {
        let inner = side.iter().find(|(id, strip)| id.unsigned_abs() == 1 && strip.width.is_none());
        if let Some((_, strip)) = inner {
            sink.add_within(STRIP, strip.span, "a width of the inner strip", "none");
        }
    }
}

/// The first shape of each station: s, t, place.
fn first_shapes(of: &RoadIn<'_>) -> Vec<(f64, f64, Span)> {
    let mut firsts: Vec<(f64, f64, Span)> = Vec::new();
    for shape in of.road.lateral_profile.iter().flat_map(|profile| &profile.shape) {
        let (s, t) = (number(&shape.s), number(&shape.t));
        match firsts.last_mut() {
            Some(last) if last.0 == s => last.1 = last.1.min(t),
            _ => firsts.push((s, t, shape.span)),
        }
    }
    firsts
}

fn starts_right(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (s, t, span) in first_shapes(of) {
        if t > COVER.value {
            let expected = format_args!("the first shape at s = {s} with t of at most 0");
            sink.add_within("lateralProfile/shape", span, expected, t);
        }
    }
}

fn coverage(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (s, t, span) in first_shapes(of) {
        let Some(section) = of.sections().filter(|section| section.s() <= s).last() else {
            continue;
        };
        let borders = borders_at(&section, Side::Right, s - section.s());
        let Some(outermost) = borders.last().map(|border| border.2) else { continue };
        if outermost < t - COVER.value {
            let expected =
                format_args!("shapes from t = {outermost:.3}, where the lanes end, at s = {s}");
            sink.add_within("lateralProfile/shape", span, expected, t);
        }
    }
}
