//! What an object is.

use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, number};
use crate::rule::Check::Object;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// How far behind the end of a road an object may stand.
const BEHIND: Tolerance = Tolerance { name: "reach behind the road's end", value: 0.01, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.circular_vs_angular",
        "An object is either round, with a radius, or has length and width.",
        Object(round_or_angular),
        [
            In(
                r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" radius="0.1" height="3"/>"#,
            ),
            In(
                r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" radius="0.1" length="1" width="1" height="3"/>"#,
            ),
        ],
    ),
    Rule::info(
        "asam.net:xodr:1.7.0:road.object.orientation",
        "An object says for which direction of travel it is.",
        Object(orientation),
        [
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/>"#),
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0"/>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.object.type_attr",
        "An object has a type.",
        Object(kind),
        [
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/>"#),
            In(r#"<object id="1" s="10" t="4" zOffset="0" orientation="none"/>"#),
        ],
    )
    .since(5),
    Rule::warning(
        "mapd:xodr:1.4.0:object.on_road",
        "An object stands along its road.",
        Object(on_road),
        [
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/>"#),
            In(r#"<object id="1" type="pole" s="110" t="4" zOffset="0" orientation="none"/>"#),
        ],
    )
    .within(&[BEHIND]),
];

fn round_or_angular(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let is = |value: &Option<mapd_xodr::Attribute<f64>>| number(value) > 0.0;
    let object = of.object;
    if is(&object.radius) && (is(&object.length) || is(&object.width)) {
        sink.add(object.span, "either a radius or length and width", "both");
    }
}

fn orientation(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if of.object.orientation.is_none() {
        sink.add(of.object.span, "@orientation", "none; taken as for both directions");
    }
}

fn kind(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    if of.object.r#type.is_none() {
        sink.add(of.object.span, "@type", "none");
    }
}

fn on_road(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let Some(road) = of.road else { return };
    let (s, length) = (number(&of.object.s), number(&road.length));
    if s < -BEHIND.value || s > length + BEHIND.value {
        sink.add(of.object.span, format_args!("s from 0 to {length}, the road's length"), s);
    }
}
