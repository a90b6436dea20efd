//! Objects that are repeated along the road.

use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, number};
use crate::rule::Check::Object;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// How far behind the end of a road a repetition may reach.
const BEHIND: Tolerance = Tolerance { name: "reach behind the road's end", value: 0.01, unit: "m" };

/// An object with a repetition and what else stands in it.
macro_rules! repeated {
    ($size:literal, $repeat:literal, $inner:literal) => {
        In(concat!(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" "#, $size,
            r#"><repeat s="10" length="20" distance="5" tStart="4" tEnd="4" zOffsetStart="0" zOffsetEnd="0" "#,
            $repeat, "/>", $inner, "</object>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.repeating.attributes_with_outline_skeleton",
        "Where an object has outlines or a skeleton, its repetitions have no sizes.",
        Object(sizes),
        [
            repeated!(r#"radius="0.1""#, r#"heightStart="1" heightEnd="1" radiusStart="0.1" radiusEnd="0.1""#, ""),
            repeated!(
                r#"length="2" width="2" height="1""#,
                r#"heightStart="1" heightEnd="1" widthStart="2" widthEnd="2""#,
                r#"<outlines><outline id="0"><cornerLocal id="0" u="-1" v="-1" z="0" height="1"/><cornerLocal id="1" u="1" v="-1" z="0" height="1"/><cornerLocal id="2" u="1" v="1" z="0" height="1"/></outline></outlines>"#
            ),
        ],
    )
    .since(9),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.repeating.no_widthstart_end_with_radius",
        "Repetitions of a round object have no widths.",
        Object(widths),
        [
            repeated!(r#"radius="0.1""#, r#"heightStart="1" heightEnd="1""#, ""),
            repeated!(r#"radius="0.1""#, r#"heightStart="1" heightEnd="1" widthStart="1" widthEnd="1""#, ""),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.repeating.outline_use_cornerlocal",
        "The outlines of a repeated object are in its own frame.",
        Object(own_frame),
        [
            repeated!(
                r#"length="2" width="2" height="1""#, r#"heightStart="1" heightEnd="1""#,
                r#"<outlines><outline id="0"><cornerLocal id="0" u="-1" v="-1" z="0" height="1"/><cornerLocal id="1" u="1" v="-1" z="0" height="1"/><cornerLocal id="2" u="1" v="1" z="0" height="1"/></outline></outlines>"#
            ),
            repeated!(
                r#"length="2" width="2" height="1""#, r#"heightStart="1" heightEnd="1""#,
                r#"<outlines><outline id="0"><cornerRoad id="0" s="9" t="3" dz="0" height="1"/><cornerRoad id="1" s="11" t="3" dz="0" height="1"/><cornerRoad id="2" s="11" t="5" dz="0" height="1"/></outline></outlines>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.object.repeating.valid_s_length",
        "A repetition begins and ends on the road.",
        Object(on_road),
        [
            repeated!(r#"radius="0.1""#, r#"heightStart="1" heightEnd="1""#, ""),
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" radius="0.1"><repeat s="10" length="200" distance="5" tStart="4" tEnd="4" zOffsetStart="0" zOffsetEnd="0" heightStart="1" heightEnd="1"/></object>"#),
        ],
    )
    .within(&[BEHIND]),
];

fn sizes(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let object = of.object;
    let has_outlines = object.outlines.is_some() || object.outline.is_some();
    if !has_outlines && object.skeleton.is_none() {
        return;
    }
    for repeat in &object.repeat {
        for (name, given) in [
            ("widthStart", &repeat.width_start),
            ("widthEnd", &repeat.width_end),
            ("lengthStart", &repeat.length_start),
            ("lengthEnd", &repeat.length_end),
            ("radiusStart", &repeat.radius_start),
            ("radiusEnd", &repeat.radius_end),
        ] {
            if given.is_some() {
                sink.add_within(
                    "repeat",
                    repeat.span,
                    format_args!("no {name} beside outlines or a skeleton"),
                    "one",
                );
            }
        }
    }
}

fn widths(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if number(&of.object.radius) <= 0.0 {
        return;
    }
    for repeat in &of.object.repeat {
        for (name, given) in [("widthStart", &repeat.width_start), ("widthEnd", &repeat.width_end)]
        {
            if number(given) != 0.0 {
                sink.add_within(
                    "repeat",
                    repeat.span,
                    format_args!("no {name} beside a radius"),
                    "one",
                );
            }
        }
    }
}

fn own_frame(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if of.object.repeat.is_empty() {
        return;
    }
    for outline in super::outlines::all(of.object) {
        if let Some(corner) = outline.corner_road.first() {
            sink.add_within(
                "outlines/outline/cornerRoad",
                corner.span,
                "corners in the object's own frame",
                "corners along the road",
            );
        }
    }
}

fn on_road(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let Some(length) = of.road.and_then(|road| road.length) else { return };
    let length = length.value;
    for repeat in &of.object.repeat {
        // What is missing is told of as such; the object then stands alone.
        let (Some(s), Some(own)) = (repeat.s, repeat.length) else { continue };
        let (start, end) = (s.value, s.value + own.value);
        if start < -BEHIND.value || end > length + BEHIND.value {
            let expected = format_args!("a repetition within the road's {length} m");
            sink.add_within(
                "repeat",
                repeat.span,
                expected,
                format_args!("one from {start} to {end}"),
            );
        }
    }
}
