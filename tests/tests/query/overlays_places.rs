//! Overlays: places by latitude and longitude, and feeds of road authorities.

use mapd_archive::open_overlay;
use mapd_client::{Map, Snapshot};
use mapd_overlay::{Document, Limits, Policy, read_feed, resolve};
use mapd_query::geodesy::{Geodetic, Projector};
use mapd_query::view::{OverlayKind, View};
use mapd_query::vocabulary::VehicleClass;
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::open_text;
use mapd_tests::overlays::over;
use std::time::{Duration, UNIX_EPOCH};

const HEADER: &str = "<header revMajor=\"1\" revMinor=\"8\"><geoReference><![CDATA[+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=0 +y_0=0 +datum=WGS84]]></geoReference></header>";

/// Road A of 100 m eastwards and B of 100 m behind it, of two lanes each way; C crosses A at 50 m.
fn crossing() -> Snapshot {
    let two = |links: &str| lane(-1, links) + &lane(-2, links);
    let left = |links: &str| lane(2, links) + &lane(1, links);
    let one = |id: &str, x: f64, y: f64, hdg: f64, link: &str| {
        let line = Line(x, y, hdg, 100.0, 0.0);
        road(id, "", line, link, &section(0.0, &left(""), &two("")))
    };
    let next = r#"<successor elementType="road" elementId="B" contactPoint="start"/>"#;
    let before = r#"<predecessor elementType="road" elementId="A" contactPoint="end"/>"#;
    let text = document(
        &(one("A", 0.0, 0.0, 0.0, next)
            + &one("B", 100.0, 0.0, 0.0, before)
            + &one("C", 50.0, -50.0, std::f64::consts::FRAC_PI_2, "")),
    );
    open_text(&text.replace("<header revMajor=\"1\" revMinor=\"8\"/>", HEADER))
}

/// Points of the map's plane as they are written in an overlay.
fn points(projector: &Projector, all: &[[f64; 2]]) -> String {
    let all = all.iter().map(|[x, y]| {
        let Geodetic { latitude, longitude, .. } =
            projector.to_geodetic([*x, *y, 0.0].into()).expect("on Earth");
        format!("[{latitude},{longitude}]")
    });
    format!("[{}]", all.collect::<Vec<_>>().join(","))
}

/// Stretches of an entry of this place, to the centimetre: road, lane, from, to.
fn closed(map: Map<'_>, place: &str) -> Result<Vec<(String, i32, f64, f64)>, String> {
    let text = format!(r#"{{"entries":[{{"id":"a","kind":"closed","places":[{place}]}}]}}"#);
    let document =
        Document::read(text.as_bytes(), &Limits::default()).map_err(|e| e.to_string())?;
    let resolved = resolve(map, &document, Policy::default());
    if let Some(unfit) = resolved.unplaced.iter().find(|unfit| !unfit.is_part) {
        return Err(format!("{}: {}", unfit.field, unfit.why));
    }
    let (bytes, _) = over(map, &text, false);
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
    let mut found = Vec::new();
    for lane in map.lanes().filter(|lane| lane.number() != 0) {
        let section = lane.section();
        let (mut s, end) = (section.s_start() + 0.01, section.s_end());
        while s < end {
            let one = view.restrictions_at(lane.lane_id(), s).expect("an answer").next();
            let Some(one) = one else {
                s += 0.1;
                continue;
            };
            let cm = |s: f64| (s * 100.0).round() / 100.0;
            let id = lane.road().id().to_owned();
            match found.last_mut() {
                // What another lane cuts is one stretch.
                Some((road, number, _, end))
                    if (&*road, *number, *end) == (&id, lane.number(), cm(one.s_from)) =>
                {
                    *end = cm(one.s_to);
                }
                _ => found.push((id, lane.number(), cm(one.s_from), cm(one.s_to))),
            }
            s = one.s_to + 0.01;
        }
    }
    Ok(found)
}

fn is(found: Result<Vec<(String, i32, f64, f64)>, String>, expected: &[(&str, i32, f64, f64)]) {
    let found = found.expect("placed");
    let found: Vec<_> = found.iter().map(|(id, lane, a, b)| (id.as_str(), *lane, *a, *b)).collect();
    assert_eq!(found, expected);
}

/// Lines mean the lane that they run along, or those beside it; what crosses is not meant.
#[test]
fn lines() {
    let snapshot = crossing();
    let map = snapshot.map();
    let projector = map.projector().expect("a projector");
    let line = |all: &[[f64; 2]], more: &str| {
        closed(map, &format!(r#"{{"line":{}{more}}}"#, points(&projector, all)))
    };
    is(line(&[[20.0, -5.0], [80.0, -5.0]], ""), &[("A", -2, 20.0, 80.0)]);
    is(line(&[[80.0, 2.0], [20.0, 2.0]], ""), &[("A", 1, 20.0, 80.0)]);
    // Against the traffic there, the nearest lane that is driven that way: 2 m off.
    is(line(&[[80.0, -2.0], [20.0, -2.0]], ""), &[("A", 1, 20.0, 80.0)]);
    assert!(line(&[[80.0, -5.0], [20.0, -5.0]], "").is_err());
    // Beside the road.
    is(line(&[[20.0, -9.0], [40.0, -9.0]], ""), &[("A", -2, 20.0, 40.0)]);
    assert!(line(&[[20.0, -9.0], [40.0, -9.0]], r#","tolerance":1"#).is_err());
    // Over the end of a road, all lanes, or some by number.
    let far = [[70.0, 0.5], [130.0, 0.5]];
    let all = [
        ("A", -1, 70.0, 100.0),
        ("A", -2, 70.0, 100.0),
        ("B", -1, 0.0, 30.0),
        ("B", -2, 0.0, 30.0),
    ];
    is(line(&far, r#","lanes":"all""#), &all);
    is(line(&far, r#","lanes":[2],"of":2"#), &[all[1], all[3]]);
    is(
        line(&[far[1], far[0]], r#","lanes":[1],"of":2"#),
        &[("A", 1, 70.0, 100.0), ("B", 1, 0.0, 30.0)],
    );
    let why = line(&far, r#","lanes":[2],"of":3"#).expect_err("two lanes");
    assert!(why.starts_with("places[0].lanes: road A") && why.contains("2 lanes, not 3"), "{why}");
    // Beyond the map.
    is(line(&[[180.0, -1.0], [500.0, -1.0]], ""), &[("B", -1, 80.0, 100.0)]);
    assert!(line(&[[300.0, -1.0], [500.0, -1.0]], "").is_err());
}

/// Areas mean each lane where its cross-section meets them.
#[test]
fn areas() {
    let snapshot = crossing();
    let map = snapshot.map();
    let projector = map.projector().expect("a projector");
    let area = |all: &[[f64; 2]], more: &str| {
        closed(map, &format!(r#"{{"area":{}{more}}}"#, points(&projector, all)))
    };
    let square = |x: f64, y: f64, half: f64| {
        [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
    };
    is(area(&square(20.0, -5.0, 1.0), ""), &[("A", -2, 19.0, 21.0)]);
    is(
        area(&square(20.0, -5.0, 1.0), r#","tolerance":1"#),
        &[("A", -1, 18.13, 21.87), ("A", -2, 18.0, 22.0)],
    );
    // Not all of a lane's width need be in it, nor a corner of it in a lane.
    is(area(&square(20.0, -8.0, 2.0), ""), &[("A", -2, 18.0, 22.0)]);
    is(
        area(&square(20.0, 0.0, 10.0), ""),
        &[("A", 2, 10.0, 30.0), ("A", 1, 10.0, 30.0), ("A", -1, 10.0, 30.0), ("A", -2, 10.0, 30.0)],
    );
    is(area(&square(80.0, -5.0, 0.01), ""), &[("A", -2, 79.85, 80.15)]);
    assert_eq!(
        area(&square(50.0, 0.0, 1.0), "").expect("placed").len(),
        4,
        "the road that crosses too"
    );
    assert!(area(&square(20.0, 50.0, 1.0), "").is_err());
}

/// Of an area with many corners a cross-section is compared with the sides near it alone.
#[test]
fn areas_of_many_corners() {
    let snapshot = crossing();
    let map = snapshot.map();
    let projector = map.projector().expect("a projector");
    let corner = |i: u16| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 3000.0).sin_cos();
        [20.0 + 10.0 * cos, 10.0 * sin]
    };
    let ring = points(&projector, &(0..3000).map(corner).collect::<Vec<_>>());
    let lanes = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
        [("A", 2, c, d), ("A", 1, a, b), ("A", -1, a, b), ("A", -2, c, d)]
    };
    is(closed(map, &format!(r#"{{"area":{ring}}}"#)), &lanes([10.0, 30.0], [10.63, 29.37]));
    is(
        closed(map, &format!(r#"{{"area":{ring},"tolerance":2}}"#)),
        &lanes([8.0, 32.0], [8.52, 31.48]),
    );
}

/// What cannot be.
#[test]
fn wrong_places() {
    let snapshot = crossing();
    let check = |place: &str, expected: &str| {
        let why = closed(snapshot.map(), place).expect_err(place);
        assert!(why.contains(expected), "{place}: {why}");
    };
    let line = |more: &str| format!(r#"{{"line":[[48,11],[48.001,11]]{more}}}"#);
    check("{}", "places[0].line: names neither");
    check(r#"{"line":[[48,11]]}"#, "places[0].line: expected two");
    check(r#"{"area":[[48,11],[48,11]]}"#, "places[0].area: expected three");
    check(&line(r#","area":[[48,11],[48,12],[47,11]]"#), "places[0].area: stands");
    check(r#"{"line":[[48,11],[95,11]]}"#, "places[0].line[1]: expected latitude");
    check(r#"{"line":[[48,11],[48]]}"#, "places[0].line[1]");
    check(r#"{"line":[[48,11],[48,11]]}"#, "places[0].line: 0.0 m long");
    check(r#"{"line":[[48,11],[-48,11]]}"#, "places[0]");
    check(&line(r#","tolerance":-1"#), "places[0].tolerance");
    check(&line(r#","tolerance":101"#), "places[0].tolerance");
    check(&line(r#","lanes":[1]"#), "places[0].of");
    check(&line(r#","of":1"#), "places[0].of");
    check(&line(r#","lanes":[3],"of":2"#), "places[0].lanes");
    check(&line(r#","lanes":[],"of":2"#), "places[0].lanes");
    check(&line(r#","lanes":"some""#), "places[0].lanes");
    check(r#"{"area":[[48,11],[48,12],[47,11]],"lanes":"all"}"#, "places[0].lanes");
    let plain = open_text(&mapd_tests::town::town(2, 2));
    let why = closed(plain.map(), &line("")).expect_err("no georeference");
    assert!(why.starts_with("places[0]: "), "{why}");
}

/// A feed of ours by the public specification: what it says of each lane, and what it says that has no place.
#[test]
fn work_zones() {
    let snapshot = crossing();
    let map = snapshot.map();
    let text = include_str!("../../data/wzdx.geojson");
    let feed = read_feed(text, 15.0, &Limits::default()).expect("a feed");
    let resolved = resolve(map, &feed.document, Policy::default());
    let findings: Vec<_> = feed.findings.iter().map(|finding| finding.place.as_str()).collect();
    assert_eq!(
        findings,
        [
            "features[0].properties.lanes[0]",
            "features[1].properties.vehicle_impact",
            "features[2].properties.core_details.event_type",
            "features[3].properties.start_date",
            "features[5]",
        ],
        "{:?}",
        feed.findings
    );
    let unplaced: Vec<_> = resolved
        .unplaced
        .iter()
        .map(|unfit| (feed.places[unfit.number].as_str(), unfit.is_part))
        .collect();
    assert_eq!(
        unplaced,
        [("features[1].properties.lanes[0]", false), ("features[4]", false)],
        "{:?}",
        resolved.unplaced
    );
    let (bytes, _) = over(map, &feed.document.to_json(), false);
    let overlay = open_overlay(&bytes).expect("opens");
    // 2026-05-04 12:00:00 UTC.
    let moment = UNIX_EPOCH + Duration::from_secs(1_777_896_000);
    let view = View::new(map, Some(&overlay), moment).expect("its own");
    let mut said = Vec::new();
    let road = map.road_by_id("A").expect("a road");
    for number in [-1, -2] {
        let lane = road.section(0).and_then(|s| s.lane(number)).expect("a lane").lane_id();
        let at = view.restrictions_at(lane, 50.0).expect("an answer");
        said.extend(at.map(|one| (number, one.entry.id().to_owned(), one.entry.kind())));
        for (vehicle, allowed) in
            [(VehicleClass::PassengerCar, number == -1), (VehicleClass::Truck, false)]
        {
            let answer = view.allows(lane, 50.0, vehicle).expect("an answer");
            assert_eq!(answer.is_allowed, allowed, "{number} {}", vehicle.name());
        }
        let limit = view.speed_rule_at(lane, 50.0, VehicleClass::PassengerCar).expect("an answer");
        assert_eq!(limit.max, Some(60.0 / 3.6));
    }
    let said: Vec<_> = said.iter().map(|(lane, id, kind)| (*lane, id.as_str(), *kind)).collect();
    assert_eq!(
        said,
        [
            (-1, "wz-1", OverlayKind::Warning),
            (-1, "wz-1/speed", OverlayKind::Speed),
            (-1, "wz-1/lane-1-no-trucks", OverlayKind::Closed),
            (-1, "wz-1/lane-1-reduced-height", OverlayKind::Warning),
            (-1, "wz-1/lane-1-reduced-height-2", OverlayKind::Warning),
            (-2, "wz-1", OverlayKind::Warning),
            (-2, "wz-1/speed", OverlayKind::Speed),
            (-2, "wz-1/lane-2", OverlayKind::Closed),
        ]
    );
}
