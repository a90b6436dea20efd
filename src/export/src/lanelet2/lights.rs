//! Traffic lights, and where traffic waits for them.

use super::model::{Member, Model, Rule};
use super::report::Report;
use super::tags::{Tag, number};
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::rules::LaneLine;
use mapd_client::signals::{LaneSignal, LightStates, Signal};
use mapd_client::{Map, SignalId};
use std::collections::{BTreeSet, HashMap};

/// Size of a light for which the file gives none: three lamps of 0.3 m, one above the other `[m]`.
const WIDTH: f64 = 0.3;
/// As [`WIDTH`] `[m]`.
const HEIGHT: f64 = 0.9;

/// Numbers of what lights already have in the model.
#[derive(Default)]
struct LightNumbers {
    lines: HashMap<SignalId, usize>,
    /// By the lights and the line at which traffic waits for them.
    rules: HashMap<(BTreeSet<SignalId>, Option<usize>), usize>,
}

/// Adds a rule for each set of lights that traffic waits for at one line. It holds on the first lanelet behind the junction's edge of each
/// movement that they govern; of lights elsewhere, on the lanelet they stand at.
pub(super) fn add<'a>(map: Map<'a>, model: &mut Model<'a>, report: &mut Report) {
    let (mut known, mut governed) = (LightNumbers::default(), BTreeSet::new());
    let lanes = || map.lanes().filter(|lane| lane.number() != 0 && !lane.is_temporary());
    for lane in lanes().filter(|lane| lane.road().junction().is_some()) {
        if lane.movement_start().lane_id() != lane.lane_id() {
            continue;
        }
        let lights: Vec<Signal<'a>> = lane.movement_lights().map(|one| one.signal()).collect();
        governed.extend(lights.iter().map(Signal::signal_id));
        let Some(lanelet) = model.network.lanelets_of(&lane).first().copied() else { continue };
        let stop = lane.movement_stop().filter(|_| !lights.is_empty());
        let stop = stop.and_then(|stop| model.stop_line(&stop));
        known.add_rule(&lights, stop, lanelet, model, report);
    }
    for lane in lanes().filter(|lane| lane.road().junction().is_none()) {
        let is_own = |one: &LaneSignal<'a>| {
            one.is_vehicle_light() && !governed.contains(&one.signal().signal_id())
        };
        for light in lane.traffic_lights().filter(is_own) {
            let s = light.s_on(&lane);
            let Some(lanelet) = model.network.lanelet_at(&lane, s) else { continue };
            let away = |line: &LaneLine| (line.s - s).abs();
            let stop = lane.lines_to_stop_at().min_by(|a, b| away(a).total_cmp(&away(b)));
            let stop = stop.and_then(|stop| model.stop_line(&stop));
            known.add_rule(&[light.signal()], stop, lanelet, model, report);
        }
    }
}

impl LightNumbers {
    fn add_rule<'a>(
        &mut self,
        lights: &[Signal<'a>],
        stop: Option<usize>,
        lanelet: u32,
        model: &mut Model<'a>,
        report: &mut Report,
    ) {
        let ids: BTreeSet<SignalId> = lights.iter().map(Signal::signal_id).collect();
        if ids.is_empty() {
            return;
        }
        let lines = &mut self.lines;
        let number = *self.rules.entry((ids, stop)).or_insert_with(|| {
            let mut members = Vec::new();
            for light in lights {
                let line = *lines.entry(light.signal_id()).or_insert_with(|| {
                    if light.light().is_some_and(|states| states.arrows != 0) {
                        report.unsaid("arrows of lights: their lanelets say where they lead");
                    }
                    model.add_line(board(light, WIDTH), tags(light))
                });
                let member = ("refers", Member::Line(line));
                if !members.contains(&member) {
                    members.push(member);
                }
            }
            members.extend(stop.map(|stop| ("ref_line", Member::Line(stop))));
            let tags =
                vec![("type", "regulatory_element".into()), ("subtype", "traffic_light".into())];
            model.rules.push(Rule { tags, members, lanelets: Vec::new() });
            model.rules.len() - 1
        });
        if let Some(rule) = model.rules.get_mut(number) {
            rule.lanelets.push(lanelet);
        }
    }
}

/// The lower edge of a sign or light from left to right, as those see it whom it faces.
pub(super) fn board(signal: &Signal<'_>, default_width: f64) -> Vec<DVec3> {
    let [width, ..] = signal.size();
    let width = width.filter(|width| *width > 0.0).unwrap_or(default_width);
    let to_the_right = DVec2::from_angle(signal.facing()).perp();
    let half = (0.5 * width * to_the_right).extend(0.0);
    vec![signal.position() - half, signal.position() + half]
}

fn tags<'a>(light: &Signal<'a>) -> Vec<Tag<'a>> {
    let [_, height, _] = light.size();
    let height = height.filter(|height| *height > 0.0).unwrap_or(HEIGHT);
    let mut tags: Vec<Tag<'a>> = vec![("type", "traffic_light".into())];
    let lamps = light.light().map(|states| lamps(&states)).filter(|lamps| !lamps.is_empty());
    tags.extend(lamps.map(|lamps| ("subtype", lamps.into())));
    tags.push(("height", number(height, 3).into()));
    tags.push(("signal_id", light.id().into()));
    tags
}

/// Colours of the lamps, as Lanelet2 names them.
fn lamps(states: &LightStates) -> String {
    let names = LightStates::BULBS.iter().enumerate();
    let own = names.filter(|(bit, _)| states.bulbs & (1 << bit) != 0).map(|(_, name)| *name);
    own.collect::<Vec<_>>().join("_")
}
