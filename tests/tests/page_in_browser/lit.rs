//! What is chosen stands out: a lane, those that it leads to, comes from and gives way to, and a route with its room and its tables.

use crate::{browser, town_with_everything};
use mapd_client::glam::DVec2;
use mapd_client::path::{PathBuffer, PathOptions};
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestTime};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, LaneId, Map, NearestOptions};
use mapd_tests::browser::Browser;
use mapd_web::Question;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::time::UNIX_EPOCH;

/// Red, green and blue may differ by so much `[of 255]`: the graphics card rounds.
const SAME: f64 = 4.0;

/// Pixels a metre: the driven line is thirty wide.
const SCALE: f64 = 60.0;

/// The colours at some places of the map, of lanes and what is laid over them only.
pub(crate) fn pixels(browser: &mut Browser, places: &[DVec2]) -> Vec<[f64; 3]> {
    let places: Vec<[f64; 2]> = places.iter().map(|place| place.to_array()).collect();
    let answer = browser.evaluate(&format!(
        "(() => {{ viewer.shown = new Set(['lanes']);
        const {{ gl, canvas }} = viewer.painter;
        return {}.map(place => {{
            [viewer.camera.x, viewer.camera.y] = viewer.near(...place);
            viewer.camera.scale = {SCALE};
            viewer.painter.changes++;
            viewer.paint();
            const pixel = new Uint8Array(4);
            gl.readPixels(canvas.width >> 1, canvas.height >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            return [...pixel.slice(0, 3)];
        }}); }})()",
        json!(places)
    ));
    serde_json::from_value(answer).expect("colours")
}

/// A paint of the light page and its opacity, as the page has them.
pub(crate) fn paint(browser: &mut Browser, name: &str) -> [f64; 4] {
    serde_json::from_value(browser.evaluate(&format!("rgba('{name}', viewer.dark)")))
        .expect("four numbers")
}

fn over([r, g, b, a]: [f64; 4], below: [f64; 3]) -> [f64; 3] {
    let mixed = |i: usize| 255.0 * a * [r, g, b][i] + (1.0 - a) * below[i];
    [0, 1, 2].map(mixed)
}

pub(crate) fn is_same(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME)
}

/// A place on a lane on which none of the others lies that are lit.
fn own_place(map: Map<'_>, lane: LaneId, lit: &BTreeSet<u32>) -> Option<DVec2> {
    let one = map.lane(lane).expect("a lane");
    let (from, to) = (one.section().s_start(), one.section().s_end());
    let places =
        (1..10).filter_map(|i| one.pose_at(from + (to - from) * 0.1 * f64::from(i), 0.0).ok());
    places.map(|pose| pose.position.truncate()).find(|place| {
        let mut near = Vec::new();
        let options = NearestOptions { radius: 0.5, ..NearestOptions::default() };
        map.lanes_near(*place, &options, &mut near).expect("finite");
        near.iter().all(|found| found.lane == lane || !lit.contains(&found.lane.row()))
    })
}

/// Each lane of a click has the colour of what it is to the one that is chosen, and no other lane has one.
#[test]
fn a_chosen_lane_and_those_around_it_are_lit() {
    let snapshot = town_with_everything();
    let map = snapshot.map();
    let Some(mut browser) = browser(&snapshot) else { return };
    browser.evaluate("viewer.painter.frames.samples = 0");
    let yields =
        |lane: &Lane<'_>| lane.yields_to().map(|one| one.lane.lane_id()).collect::<Vec<_>>();
    let lanes = || map.lanes().filter(|lane| lane.kind().is_drivable());
    let chosen = [
        lanes().find(|lane| lane.road().junction().is_none() && lane.successors().count() > 1),
        lanes().find(|lane| !yields(lane).is_empty()),
    ];
    let mut seen = BTreeSet::new();
    for lane in chosen.map(|lane| lane.expect("such a lane")) {
        // What is painted last counts.
        let mut names = BTreeMap::new();
        names.extend(lane.predecessors().map(|id| (id.row(), (id, "before"))));
        names.extend(lane.successors().map(|id| (id.row(), (id, "next"))));
        names.extend(yields(&lane).into_iter().map(|id| (id.row(), (id, "other"))));
        names.insert(lane.lane_id().row(), (lane.lane_id(), "chosen"));
        let lit: BTreeSet<u32> = names.keys().copied().collect();
        let mut places: Vec<(DVec2, Option<&str>)> = names
            .values()
            .filter_map(|(id, name)| Some((own_place(map, *id, &lit)?, Some(*name))))
            .collect();
        let far = lanes().filter(|one| !lit.contains(&one.lane_id().row()));
        places.extend(
            far.take(20).filter_map(|one| Some((own_place(map, one.lane_id(), &lit)?, None))),
        );
        let at: Vec<DVec2> = places.iter().map(|(place, _)| *place).collect();
        browser.evaluate("viewer.clear()");
        let before = pixels(&mut browser, &at);
        browser
            .evaluate(&format!("viewer.choose({{ kind: 'lane', row: {} }})", lane.lane_id().row()));
        let after = pixels(&mut browser, &at);
        for (((place, name), before), after) in places.iter().zip(before).zip(after) {
            let expected = name.map_or(before, |name| over(paint(&mut browser, name), before));
            assert!(
                is_same(after, expected),
                "{name:?} of {} at {place}: {after:?}, not {expected:?}",
                lane.key()
            );
            seen.extend(*name);
        }
    }
    assert_eq!(seen, ["before", "chosen", "next", "other"].into());
    assert_eq!(browser.complaints, [""; 0]);
}

/// The line of a route is painted where its path lies, its room beside it; the tables say what the native build says.
#[test]
fn a_route_is_lit_and_told() {
    let snapshot = town_with_everything();
    let map = snapshot.map();
    let Some(mut browser) = browser(&snapshot) else { return };
    browser.evaluate("viewer.painter.frames.samples = 0");
    let middle = |key: &str| {
        let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
        (
            PositionOnLane { lane: lane.lane_id(), s },
            lane.pose_at(s, 0.0).expect("a place").position.truncate(),
        )
    };
    let car = VehicleClass::PassengerCar;
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    // The first of the streets, from which a way of several lanes leads.
    let keys: Vec<String> = map
        .lanes()
        .filter(|lane| lane.kind().is_drivable() && lane.road().junction().is_none())
        .map(|lane| lane.key().to_string())
        .collect();
    let (from, to) = keys
        .iter()
        .flat_map(|from| keys.iter().map(move |to| (middle(from), middle(to))))
        .find(|(from, to)| {
            let way =
                map.route(from.0, to.0, car, &ShortestTime::default(), &mut scratch, &mut steps);
            matches!(way, Ok(Some(_))) && steps.len() >= 3
        })
        .expect("a way");
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    let along: Vec<f64> = (1..40).map(|i| path.length() * f64::from(i) / 40.0).collect();
    // The line is half a metre wide, and lanes are wider than 2 m.
    let beside = |along: &f64, d: f64| {
        let at = path.at(*along).expect("on the path");
        at.position.truncate() + d * DVec2::from_angle(at.heading).perp()
    };
    let line: Vec<DVec2> = along.iter().map(|along| beside(along, 0.0)).collect();
    let room: Vec<DVec2> = along.iter().map(|along| beside(along, 0.8)).collect();
    let before = pixels(&mut browser, &room);
    let asked = format!(
        "viewer.setMode('route'); viewer.routeTo(viewer.near({}, {})); viewer.routeTo(viewer.near({}, {}))",
        from.1.x, from.1.y, to.1.x, to.1.y
    );
    browser.evaluate(&asked);
    let [r, g, b, _] = paint(&mut browser, "route");
    for (place, found) in line.iter().zip(pixels(&mut browser, &line)) {
        let expected = [r, g, b].map(|part| 255.0 * part);
        assert!(is_same(found, expected), "at {place}: {found:?}, not {expected:?}");
    }
    let corridor = paint(&mut browser, "corridor");
    let found = pixels(&mut browser, &room);
    for ((place, found), before) in room.iter().zip(found).zip(before) {
        let expected = over(corridor, before);
        assert!(is_same(found, expected), "beside {place}: {found:?}, not {expected:?}");
    }

    let answer =
        Question::Way(from.1.to_array(), to.1.to_array()).answer(snapshot.view(UNIX_EPOCH)).json;
    let way: Value = serde_json::from_str(&answer).expect("JSON");
    let told = browser.evaluate(
        "[...document.querySelectorAll('#panel table')].map(table => [...table.tBodies[0].rows].map(row => [...row.cells].map(cell => cell.textContent)))",
    );
    let number = |value: &Value| json!(format!("{:.1}", value.as_f64().expect("a number")));
    let lanes = way["steps"].as_array().expect("steps").iter();
    let lanes: Vec<Value> = lanes
        .map(|step| {
            json!([
                step["lane"]["text"],
                step["enter"],
                number(&step["s"][0]),
                number(&step["s"][1])
            ])
        })
        .collect();
    let meets = way["conflicts"].as_array().expect("conflicts").iter();
    let meets: Vec<Value> = meets
        .map(|one| {
            json!([
                number(&one["along"][0]),
                number(&one["along"][1]),
                one["other"]["text"],
                one["yields"],
                one["reason"]
            ])
        })
        .collect();
    assert!(!meets.is_empty() && lanes.len() == steps.len(), "{answer}");
    assert_eq!(told, json!([lanes, meets]));
    assert_eq!(browser.complaints, [""; 0]);
}
