//! `mapd query … signals`.

use super::kinds::{number, numbers, text};
use super::route::Router;
use mapd_query::route::PositionOnLane;
use mapd_query::signals::{LightStates, SignalsAhead};

/// Columns of the answer.
pub(super) const COLUMNS: &[&str] = &[
    "id",
    "class",
    "distance",
    "road_id",
    "s",
    "t",
    "x",
    "y",
    "z",
    "state_machine",
    "method",
    "value",
    "out_of_service",
];

/// Signals ahead of a place, a row of columns each, the nearest first. A signal that counts for several lanes ahead stands
/// once, where it is met first.
pub(super) fn answer(
    router: &Router<'_>,
    from: PositionOnLane,
    distance: f64,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let (view, mut ahead) = (router.view(), SignalsAhead::default());
    view.signals_ahead(from, distance, router.vehicle(), &mut ahead).map_err(text)?;
    let map = view.map();
    let mut seen = std::collections::HashSet::new();
    for one in ahead.iter().filter(|one| seen.insert(one.signal)) {
        let signal = map.signal(one.signal).map_err(text)?;
        let own = map.lane(one.lane).map_err(text)?;
        let place = own
            .signals()
            .find(|on| on.signal().signal_id() == one.signal && on.s_on(&own) == one.s);
        out.push(signal.id().to_owned());
        out.push(signal.class().name().to_owned());
        out.push(number(one.distance));
        out.push(own.road().id().to_owned());
        let p = signal.position();
        let t = place.map_or(signal.track()[1], |on| on.place().t());
        numbers(out, &[one.s, t, p.x, p.y, p.z]);
        out.push(signal.light().map(states).unwrap_or_default());
        out.push(place.map_or("", |on| on.method().name()).to_owned());
        out.push(signal.value().map(number).unwrap_or_default());
        let off = view.signal_out_of_service(one.signal).map_err(text)?;
        out.push(off.map(|entry| entry.id().to_owned()).unwrap_or_default());
    }
    Ok(())
}

/// `red yellow green:red,red_yellow,…:left`: lamps, phases and, for lights with arrows, movements.
fn states(light: LightStates) -> String {
    let names = |bits: u8, names: &[&str], between: &str| {
        let set = names.iter().enumerate().filter(|(i, _)| bits >> i & 1 == 1);
        set.map(|(_, name)| *name).collect::<Vec<_>>().join(between)
    };
    let mut out = names(light.bulbs, &LightStates::BULBS, " ");
    out.push(':');
    out.push_str(&names(light.phases, &LightStates::PHASES, " "));
    if light.arrows != 0 {
        out.push(':');
        out.push_str(&names(light.arrows, &LightStates::ARROWS, " "));
    }
    out
}
