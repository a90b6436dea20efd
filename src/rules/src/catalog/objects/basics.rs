//! What an object is.

use crate::example::Example::Objects as In;
use crate::place::{ObjectIn, RoadIn, number};
use crate::rule::Check::{Object, Road};
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
        "An object states the direction of travel that it applies to.",
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
        "An object's s is within its road.",
        Object(on_road),
        [
            In(r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"/>"#),
            In(r#"<object id="1" type="pole" s="110" t="4" zOffset="0" orientation="none"/>"#),
        ],
    )
    .within(&[BEHIND]),
    Rule::warning(
        "mapd:xodr:1.4.0:object.size",
        "Length, width and radius of an object are not negative.",
        Object(size),
        [
            In(
                r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" length="1" width="1" height="3"/>"#,
            ),
            In(
                r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" length="1" width="-1" height="3"/>"#,
            ),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:structure.on_road",
        "A bridge or tunnel is within its road.",
        Road(structures),
        [
            In(r#"<bridge id="1" s="10" length="20" type="steel"/>"#),
            In(r#"<bridge id="1" s="10" length="200" type="steel"/>"#),
        ],
    )
    .within(&[BEHIND]),
];

fn size(of: &ObjectIn<'_>, sink: &mut Sink<'_>) {
    let object = of.object;
    for (name, size) in
        [("length", &object.length), ("width", &object.width), ("radius", &object.radius)]
    {
        let size = number(size);
        if size < 0.0 {
            sink.add(object.span, format_args!("@{name} of 0 or more"), size);
        }
    }
}

fn structures(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let Some(objects) = of.road.objects.as_deref() else { return };
    let Some(end) = of.road.length.map(|length| length.value) else { return };
    let bridges = objects.bridge.iter().map(|b| (b.span, &b.s, &b.length));
    let tunnels = objects.tunnel.iter().map(|t| (t.span, &t.s, &t.length));
    for (span, s, length) in bridges.chain(tunnels) {
        let (from, length) = (number(s), number(length));
        if from < -BEHIND.value || from + length > end + BEHIND.value {
            let expected = format_args!("a stretch from 0 to {end}, the road's length");
            sink.add(span, expected, format_args!("{from} to {}", from + length));
        }
    }
}

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
    let Some(length) = of.road.and_then(|road| road.length) else { return };
    let (s, length) = (number(&of.object.s), length.value);
    if s < -BEHIND.value || s > length + BEHIND.value {
        sink.add(of.object.span, format_args!("s from 0 to {length}, the road's length"), s);
    }
}
