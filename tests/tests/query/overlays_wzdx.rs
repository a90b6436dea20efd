//! Feeds of work zones: every word that the specification of WZDx 4.2 lists becomes an entry or a finding.

use mapd_overlay::{Document, Feed, Kind, Limits, read_feed};
use serde_json::{Value, json};

const IMPACTS: [&str; 12] = [
    "all-lanes-closed",
    "some-lanes-closed",
    "all-lanes-open",
    "alternating-one-way",
    "some-lanes-closed-merge-left",
    "some-lanes-closed-merge-right",
    "all-lanes-open-shift-left",
    "all-lanes-open-shift-right",
    "some-lanes-closed-split",
    "flagging",
    "temporary-traffic-signal",
    "unknown",
];
const STATUSES: [&str; 7] = [
    "open",
    "closed",
    "shift-left",
    "shift-right",
    "merge-left",
    "merge-right",
    "alternating-flow",
];
/// Types of lanes, and whether traffic drives on them.
const LANES: [(&str, bool); 12] = [
    ("general", true),
    ("exit-lane", true),
    ("exit-ramp", true),
    ("entrance-lane", true),
    ("entrance-ramp", true),
    ("two-way-center-turn-lane", true),
    ("center-left-turn-lane", true),
    ("sidewalk", false),
    ("bike-lane", false),
    ("shoulder", false),
    ("parking", false),
    ("median", false),
];
/// Types of restrictions, with the unit of their value, and what they become.
const RESTRICTIONS: [(&str, Option<&str>, Kind); 15] = [
    ("no-trucks", None, Kind::Closed),
    ("local-access-only", None, Kind::Closed),
    ("hov-2", None, Kind::Only),
    ("hov-3", None, Kind::Only),
    ("no-passing", None, Kind::NoOvertaking),
    ("travel-peak-hours-only", None, Kind::Warning),
    ("no-parking", None, Kind::Warning),
    ("towing-prohibited", None, Kind::Warning),
    ("permitted-oversize-loads-prohibited", None, Kind::Warning),
    ("reduced-width", Some("feet"), Kind::Warning),
    ("reduced-height", Some("inches"), Kind::Warning),
    ("reduced-length", Some("centimeters"), Kind::Warning),
    ("reduced-weight", Some("pounds"), Kind::Warning),
    ("axle-load-limit", Some("tons"), Kind::Warning),
    ("gross-weight-limit", Some("kilograms"), Kind::Warning),
];

/// Reads a feed of one work zone with these properties beside the required ones.
fn read(properties: &Value) -> Feed {
    read_as("feed_info", "LineString", "work-zone", properties)
}

fn read_as(info: &str, geometry: &str, event: &str, properties: &Value) -> Feed {
    let mut own = json!({
        "core_details": {
            "event_type": event, "data_source_id": "works", "direction": "unknown", "road_names": ["A"],
            "related_road_events": [{"type": "first-in-sequence", "id": "other"}], "name": "Paving",
        },
        "start_date": "2026-05-04T06:00:00Z", "end_date": "2026-05-04T18:00:00Z",
        "is_start_date_verified": true, "end_date_accuracy": "estimated",
    });
    let required = json!({
        "beginning_accuracy": "verified", "is_end_position_verified": false,
        "location_method": "channel-device-method", "vehicle_impact": "unknown",
    });
    let mut add = |more: &Value| {
        for (name, value) in more.as_object().expect("an object") {
            own[name] = value.clone();
        }
    };
    if event == "work-zone" {
        add(&required);
    }
    add(properties);
    let feed = json!({
        info: {
            "update_date": "2026-05-04T05:00:00Z", "version": "4.2", "publisher": "mapd tests",
            "data_sources": [{"data_source_id": "works", "organization_name": "mapd tests"}],
        },
        "type": "FeatureCollection",
        "features": [{
            "id": "zone", "type": "Feature", "bbox": [11.0, 48.0, 11.1, 48.1], "properties": own,
            "geometry": {"type": geometry, "coordinates": [[11.0, 48.0], [11.1, 48.1]]},
        }],
    });
    read_feed(&feed.to_string(), 15.0, &Limits::default()).expect("a feed")
}

/// Ids, kinds and texts of a feed's entries.
fn said(feed: &Feed) -> Vec<(&str, Kind, &str)> {
    let entries = feed.document.entries.iter();
    entries.map(|entry| (entry.id.as_str(), entry.kind, entry.text.as_str())).collect()
}

fn findings(feed: &Feed) -> Vec<&str> {
    feed.findings.iter().map(|finding| finding.place.as_str()).collect()
}

#[test]
fn impacts_and_events() {
    for impact in IMPACTS {
        let feed = read(&json!({"vehicle_impact": impact}));
        let text = format!("{impact}: Paving");
        let mut expected = vec![("zone", Kind::Warning, text.as_str())];
        if impact == "all-lanes-closed" {
            expected.push(("zone/closed", Kind::Closed, text.as_str()));
        }
        assert_eq!(said(&feed), expected);
        // Which lanes are closed is not said.
        let unnamed = impact.starts_with("some-lanes-closed");
        let found = vec!["features[0].properties.vehicle_impact"];
        assert_eq!(findings(&feed), if unnamed { found } else { vec![] }, "{impact}");
    }
    for event in ["detour", "restriction"] {
        let feed = read_as("feed_info", "LineString", event, &json!({}));
        assert_eq!(said(&feed), []);
        assert_eq!(findings(&feed), ["features[0].properties.core_details.event_type"], "{event}");
    }
    for (status, holds) in [
        ("planned", true),
        ("pending", true),
        ("active", true),
        ("completed", false),
        ("cancelled", false),
    ] {
        let feed = read(&json!({"event_status": status}));
        assert_eq!((said(&feed).len(), findings(&feed).len()), (usize::from(holds), 0), "{status}");
    }
}

#[test]
fn lanes() {
    for (kind, is_travelled) in LANES {
        for status in STATUSES {
            let lane = json!({"order": 2, "type": kind, "status": status, "lane_number": 2});
            let other = json!({"order": 1, "type": "general", "status": "open"});
            let feed = read(&json!({"lanes": [other, lane]}));
            let what = format!("{kind} {status}");
            let text = format!("lane: {status}");
            let expected = match status {
                "open" => None,
                "closed" => Some(("zone/lane-2", Kind::Closed, "unknown: Paving")),
                _ => Some(("zone/lane-2", Kind::Warning, text.as_str())),
            };
            let entry = expected.filter(|_| is_travelled);
            assert_eq!(said(&feed)[1..], entry.into_iter().collect::<Vec<_>>(), "{what}");
            let is_told = expected.is_some() && !is_travelled;
            let place = vec!["features[0].properties.lanes[1]"];
            assert_eq!(findings(&feed), if is_told { place } else { vec![] }, "{what}");
        }
    }
}

#[test]
fn restrictions() {
    for (name, unit, kind) in RESTRICTIONS {
        let one = match unit {
            Some(unit) => json!({"type": name, "value": 12.5, "unit": unit}),
            None => json!({"type": name}),
        };
        let text = match (kind, unit) {
            (Kind::Warning, Some(unit)) => format!("{name} 12.5 {unit}"),
            (Kind::Warning, None) => name.to_owned(),
            _ => "unknown: Paving".to_owned(),
        };
        let lane = json!({"order": 1, "type": "general", "status": "open", "restrictions": [one]});
        let feed = read(&json!({"restrictions": [one], "lanes": [lane]}));
        let (own, on_lane) = (format!("zone/{name}"), format!("zone/lane-1-{name}"));
        let expected =
            [(own.as_str(), kind, text.as_str()), (on_lane.as_str(), kind, text.as_str())];
        assert_eq!(said(&feed)[1..], expected);
        assert_eq!(findings(&feed), [""; 0], "{name}");
    }
}

/// What may be there or not, what earlier versions wrote, and what other programs write beside it.
#[test]
fn what_else_a_feed_may_have() {
    for info in ["feed_info", "road_event_feed_info"] {
        for geometry in ["LineString", "MultiPoint"] {
            let feed = read_as(info, geometry, "work-zone", &json!({}));
            assert_eq!(
                said(&feed),
                [("zone", Kind::Warning, "unknown: Paving")],
                "{info} {geometry}"
            );
            assert_eq!(feed.document.entries[0].places[0].line, [[48.0, 11.0], [48.1, 11.1]]);
            assert_eq!(findings(&feed), [""; 0]);
        }
    }
    let more = json!({
        "types_of_work": [{"type_name": "maintenance", "is_architectural_change": false}],
        "worker_presence": {
            "are_workers_present": true, "method": "camera-monitoring", "confidence": "high",
            "definition": ["workers-in-work-zone-working"],
        },
        "beginning_milepost": 1.5, "ending_cross_street": "B", "impacted_cds_curb_zones": [], "of_ours": {"a": 1},
        "lanes": null, "restrictions": null, "reduced_speed_limit_kph": null,
    });
    let feed = read(&more);
    assert_eq!(said(&feed), [("zone", Kind::Warning, "unknown, workers present: Paving")]);
    assert_eq!(findings(&feed), [""; 0]);
    for presence in [
        json!(null),
        json!("yes"),
        json!(true),
        json!({}),
        json!({"are_workers_present": null}),
        json!({"are_workers_present": "yes"}),
    ] {
        let feed = read(&json!({"worker_presence": presence}));
        assert_eq!(said(&feed), [("zone", Kind::Warning, "unknown: Paving")], "{presence}");
    }
    let feed = read(&json!({"reduced_speed_limit_kph": 36}));
    assert_eq!(feed.document.entries[1].value, Some(10.0));
    // What cannot be said is told.
    for limit in [0, -5] {
        let feed = read(&json!({"reduced_speed_limit_kph": limit}));
        assert_eq!(said(&feed), [("zone", Kind::Warning, "unknown: Paving")], "{limit}");
        assert_eq!(findings(&feed), ["features[0].properties.reduced_speed_limit_kph"], "{limit}");
    }
    let feed = read_as("feed_info", "Point", "work-zone", &json!({}));
    assert_eq!((said(&feed), findings(&feed)), (vec![], vec!["features[0].geometry.type"]));
}

/// A feed of a work zone whose feature is changed so.
fn changed(change: impl FnOnce(&mut Value)) -> Feed {
    let mut feed = json!({"type": "FeatureCollection", "features": [{
        "id": "zone", "type": "Feature",
        "properties": {
            "core_details": {"event_type": "work-zone", "data_source_id": "works"},
            "start_date": "2026-05-04T06:00:00Z", "end_date": "2026-05-04T18:00:00Z",
            "vehicle_impact": "all-lanes-closed",
        },
        "geometry": {"type": "LineString", "coordinates": [[11.0, 48.0], [11.1, 48.1]]},
    }]});
    change(&mut feed["features"][0]);
    read_feed(&feed.to_string(), 15.0, &Limits::default()).expect("a feed")
}

/// An unreadable date took the zone, and its closure of before, off the road.
#[test]
fn what_cannot_be_read_keeps_what_it_said() {
    let wrong_date = json!("2026-11-31T00:00:00Z");
    let cases: [(&str, Value, Option<&str>); 8] = [
        ("/properties/end_date", wrong_date.clone(), Some("zone")),
        ("/properties/end_date", json!("2026-05-04T05:00:00Z"), Some("zone")),
        ("/geometry", json!(null), Some("zone")),
        ("/properties/core_details/event_type", json!(5), Some("zone")),
        ("/id", json!(7), Some("")),
        ("", json!(null), Some("")),
        ("/properties/core_details/event_type", json!("detour"), None),
        ("/geometry/coordinates", json!([]), Some("zone")),
    ];
    for (place, value, unread) in cases {
        let feed = changed(|feature| {
            *feature.pointer_mut(place).expect("there") = value;
        });
        assert_eq!(feed.unread.first().map(String::as_str), unread, "{place}");
        assert_eq!((feed.findings.is_empty(), said(&feed)), (false, vec![]), "{place}");
    }
    let ended = changed(|feature| {
        feature["properties"]["end_date"] = wrong_date;
        feature["properties"]["event_status"] = json!("cancelled");
    });
    assert_eq!((ended.findings.len(), ended.unread.len()), (1, 0));

    let mut laid = changed(|_| {}).document;
    laid.set_feed("works");
    let left = |unread: &[&str]| {
        let mut laid = laid.clone();
        let unread: Vec<String> = unread.iter().map(|&name| name.to_owned()).collect();
        laid.forget_of_feed("works", &Document::default(), &unread);
        laid.entries.iter().map(|entry| entry.id.clone()).collect::<Vec<_>>()
    };
    assert_eq!(left(&[]), [""; 0]);
    assert_eq!(left(&["zone"]), ["zone", "zone/closed"]);
    assert_eq!(left(&["zone/closed"]), ["zone/closed"]);
    assert_eq!(left(&["zon"]), [""; 0]);
    assert_eq!(left(&[""]), ["zone", "zone/closed"]);
}

/// Version 3.1 was read as if it were 4.2, without a word.
#[test]
fn other_versions_are_told() {
    for (version, is_told) in [("3.1", true), ("4.0", false), ("4.2", false), ("5.0", true)] {
        let feed =
            json!({"feed_info": {"version": version}, "type": "FeatureCollection", "features": []});
        let feed = read_feed(&feed.to_string(), 15.0, &Limits::default()).expect("a feed");
        let place = vec!["feed_info.version"];
        assert_eq!(findings(&feed), if is_told { place } else { vec![] }, "{version}");
    }
}
