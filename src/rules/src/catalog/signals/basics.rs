//! What a signal is.

use crate::example::Example::Signals as In;
use crate::place::{SignalIn, number, text, value};
use crate::rule::Check::Signal;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// How far behind the end of a road a signal may stand.
const BEHIND: Tolerance = Tolerance { name: "reach behind the road's end", value: 0.01, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::info(
        "asam.net:xodr:1.7.0:road.signal.use_country_code",
        "A signal names the country whose catalog its type is from.",
        Signal(country),
        [
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/>"#),
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" hOffset="0" pitch="0" roll="0"/>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:signal.on_road",
        "A signal stands along its road.",
        Signal(on_road),
        [
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/>"#),
            In(r#"<signal id="1" s="110" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/>"#),
        ],
    )
    .within(&[BEHIND]),
    Rule::warning(
        "mapd:xodr:1.4.0:signal.value_unit",
        "A value other than 0 has a unit.",
        Signal(unit),
        [
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" value="50" unit="km/h" hOffset="0" pitch="0" roll="0"/>"#),
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" value="50" hOffset="0" pitch="0" roll="0"/>"#),
        ],
    )
    .since(5),
];

fn country(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let kind = text(&of.signal.r#type);
    let has_type = !matches!(kind, "" | "-1" | "none");
    if has_type && text(&of.signal.country).is_empty() {
        sink.add(of.signal.span, "@country", "none");
    }
}

fn on_road(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let (s, length) = (number(&of.signal.s), number(&of.road.length));
    if s < -BEHIND.value || s > length + BEHIND.value {
        sink.add(of.signal.span, format_args!("s from 0 to {length}, the road's length"), s);
    }
}

fn unit(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    // Writers put 0 and -1 where there is no value.
    let given = value(&of.signal.value).filter(|value| *value != 0.0 && *value != -1.0);
    if let Some(given) = given.filter(|_| of.signal.unit.is_none()) {
        sink.add(of.signal.span, format_args!("the unit of the value {given}"), "none");
    }
}
