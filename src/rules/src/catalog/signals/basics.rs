//! What a signal is.

use crate::example::Example::Signals as In;
use crate::place::{SignalIn, number, text, value};
use crate::rule::Check::Signal;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Attribute, StaticBoard};

/// How far behind the end of a road a signal may stand.
const BEHIND: Tolerance = Tolerance { name: "reach behind the road's end", value: 0.01, unit: "m" };

/// Boards on boards that are followed at most.
const DEEPEST_BOARD: usize = 8;

/// What becomes of a value without unit.
const NO_UNIT: &str =
    "none; read in the unit of the country's catalogue, without a country in SI units";

pub(super) static RULES: &[Rule] = &[
    Rule::info(
        "asam.net:xodr:1.7.0:road.signal.use_country_code",
        "A signal names the country of the catalog that defines its type.",
        Signal(country),
        [
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/>"#),
            In(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" hOffset="0" pitch="0" roll="0"/>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:signal.on_road",
        "A signal's s is within its road.",
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
    ),
];

fn country(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let kind = text(&of.signal.r#type);
    let has_type = !matches!(kind, "" | "-1" | "none");
    if has_type && text(&of.signal.country).is_empty() {
        sink.add(of.signal.span, "@country", "none");
    }
}

fn on_road(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let Some(length) = of.road.length else { return };
    let (s, length) = (number(&of.signal.s), length.value);
    if s < -BEHIND.value || s > length + BEHIND.value {
        sink.add(of.signal.span, format_args!("s from 0 to {length}, the road's length"), s);
    }
}

fn unit(of: &SignalIn<'_>, sink: &mut Sink<'_>) {
    let signal = of.signal;
    if let Some(given) = without_unit(&signal.value, signal.unit.is_some()) {
        sink.add(signal.span, format_args!("the unit of the value {given}"), NO_UNIT);
    }
    units_of_signs("staticBoard/sign", &signal.static_board, DEEPEST_BOARD, sink);
}

/// The same of signs on boards, and of those on their boards.
fn units_of_signs(part: &str, boards: &[StaticBoard], deep: usize, sink: &mut Sink<'_>) {
    let Some(deeper) = deep.checked_sub(1) else { return };
    for sign in boards.iter().flat_map(|board| &board.sign) {
        if let Some(given) = without_unit(&sign.value, sign.unit.is_some()) {
            sink.add_within(
                part,
                sign.span,
                format_args!("the unit of the value {given}"),
                NO_UNIT,
            );
        }
        if !sign.static_board.is_empty() {
            units_of_signs(&format!("{part}/staticBoard/sign"), &sign.static_board, deeper, sink);
        }
    }
}

/// A value that has no unit. Writers put 0 and -1 where there is no value.
fn without_unit(given: &Option<Attribute<f64>>, has_unit: bool) -> Option<f64> {
    value(given).filter(|given| !has_unit && *given != 0.0 && *given != -1.0)
}
