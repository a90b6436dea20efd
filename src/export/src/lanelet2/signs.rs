//! Traffic signs, speed limits among them.

use super::lights::board;
use super::model::{Member, Model, Rule};
use super::report::Report;
use super::tags::{Tag, speed};
use mapd_client::signals::Signal;
use mapd_client::vocabulary::{Class, ClassGroup};
use mapd_client::{Map, SignalId};
use std::collections::{BTreeMap, HashMap};

/// Width of a sign for which the file gives none `[m]`: usual on town roads.
const WIDTH: f64 = 0.6;
/// Names of Germany, whose signs Lanelet2 knows by their codes.
const GERMANY: [&str; 3] = ["DE", "DEU", "OpenDRIVE"];
/// German sign of a speed limit.
const GERMAN_SPEED_LIMIT: &str = "274";
/// Limits on German signs that Lanelet2 knows by their codes `[km/h]`.
const GERMAN_SPEEDS: [u32; 14] = [5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130];

/// What Autoware calls a stop sign of any country.
const AUTOWARE_STOP: &str = "stop_sign";

/// Adds a rule for each sign that is for a lane: a speed limit on all lanelets where it holds, other signs where they stand.
pub(super) fn add<'a>(map: Map<'a>, autoware: bool, model: &mut Model<'a>, report: &mut Report) {
    let mut limited: BTreeMap<SignalId, Vec<u32>> = BTreeMap::new();
    for (number, lanelet) in (0..).zip(&model.network.lanelets) {
        let stretch = model.network.stretches.all.get(lanelet.stretch as usize);
        let piece = stretch.and_then(|stretch| stretch.piece(lanelet.piece));
        let rule = piece.map(|(from, to)| lanelet.lane.speed_rule_at(0.5 * (from + to)));
        let is_finite = |max: Option<f64>| max.is_some_and(f64::is_finite);
        let sign = rule.filter(|rule| is_finite(rule.max)).and_then(|rule| rule.signal);
        limited
            .extend(sign.filter(|sign| !limited.contains_key(sign)).map(|sign| (sign, Vec::new())));
        if let Some(own) = sign.and_then(|sign| limited.get_mut(&sign)) {
            own.push(number);
        }
    }
    let mut standing: HashMap<SignalId, Vec<u32>> = HashMap::new();
    for lane in map.lanes().filter(|lane| lane.number() != 0 && !lane.is_temporary()) {
        for one in lane.signals() {
            let lanelet = model.network.lanelet_at(&lane, one.s_on(&lane));
            let own = standing.entry(one.signal().signal_id()).or_default();
            own.extend(lanelet.filter(|lanelet| !own.contains(lanelet)));
        }
    }
    for signal in map.signals().filter(|signal| is_sign(signal)) {
        let limit = limited.remove(&signal.signal_id()).filter(|_| signal.value().is_some());
        let is_limit = limit.is_some();
        let here = standing.remove(&signal.signal_id());
        let lanelets = limit.or(here).unwrap_or_default();
        if lanelets.is_empty() {
            report.unsaid("signs that are for no lanelet");
            continue;
        }
        let line = model.add_line(board(&signal, WIDTH), tags(&signal, is_limit, autoware));
        let subtype = if is_limit { "speed_limit" } else { "traffic_sign" };
        let tags = vec![("type", "regulatory_element".into()), ("subtype", subtype.into())];
        let members = vec![("refers", Member::Line(line))];
        model.rules.push(Rule { tags, members, lanelets });
    }
}

/// Whether a signal is a sign, and holds.
fn is_sign(signal: &Signal<'_>) -> bool {
    use ClassGroup::{Ban, Direction, Information, RightOfWay, Speed, Warning};
    let is_carrier = matches!(signal.class(), Class::Board | Class::VariableMessageBoard);
    let holds = !signal.is_invalidated() && !signal.is_temporary() && !is_carrier;
    let groups = [RightOfWay, Speed, Ban, Direction, Warning, Information];
    holds && groups.contains(&signal.class().group())
}

fn tags<'a>(signal: &Signal<'a>, is_limit: bool, autoware: bool) -> Vec<Tag<'a>> {
    let limit = signal.value().filter(|_| is_limit).map(|value| limit(signal, value));
    let stop = (autoware && signal.class() == Class::Stop).then(|| AUTOWARE_STOP.to_owned());
    let mut tags: Vec<Tag<'a>> = vec![("type", "traffic_sign".into())];
    tags.push(("subtype", limit.or(stop).unwrap_or_else(|| code(signal)).into()));
    tags.push(("class", signal.class().name().into()));
    tags.push(("code", code(signal).into()));
    tags.push(("signal_id", signal.id().into()));
    tags
}

/// Country and code in one word, as Lanelet2 writes them; what the sign means where there is no code.
fn code(signal: &Signal<'_>) -> String {
    let [country, _, code, subcode] = signal.code();
    let is_given = |text: &str| !matches!(text, "" | "-1" | "none");
    if !is_given(code) {
        return signal.class().name().to_owned();
    }
    let country = if GERMANY.contains(&country) { "de".to_owned() } else { country.to_lowercase() };
    if is_given(subcode) {
        format!("{country}{code}-{subcode}")
    } else {
        format!("{country}{code}")
    }
}

/// What Lanelet2 reads a speed from: the code of a German sign, or the speed itself.
fn limit(signal: &Signal<'_>, value: f64) -> String {
    let [country, _, code, _] = signal.code();
    let is_german = code == GERMAN_SPEED_LIMIT && GERMANY.contains(&country);
    let speed = speed(value);
    match speed.parse::<u32>() {
        Ok(known) if is_german && GERMAN_SPEEDS.contains(&known) => format!("de274-{known}"),
        _ => format!("{speed} km/h"),
    }
}
