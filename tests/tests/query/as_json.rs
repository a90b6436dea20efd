//! Results and options as JSON, with the feature `serde`.

use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::glam::DVec2;
use mapd_client::rules::{SpeedOrigin, SpeedRule};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, Nearest, NearestOptions};
use mapd_tests::carried;
use mapd_tests::maps::open;
use mapd_tests::workspace;
use serde_json::{from_str, from_value, to_value};

#[test]
fn results_are_written_and_read_back() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let at = DVec2::new(50.0, -1.75);
    let hit = map.nearest_lane(at, &NearestOptions::default()).expect("finite").expect("a lane");
    let json = to_value(hit).expect("writable");
    assert_eq!(json["lane"], format!("{:032x}", hit.lane.to_bits()));
    assert_eq!(json["position"]["clamped"], "no");
    assert_eq!(from_value::<Nearest>(json).expect("readable"), hit);
    let pose = map.lane(hit.lane).expect("a lane").pose_at(0.0, 0.0).expect("finite");
    assert!(to_value(pose).expect("writable")["position"].is_array());
}

#[test]
fn options_that_are_left_out_have_their_defaults() {
    let read: NearestOptions = from_str(r#"{"radius": 3.0, "vehicle": "bus"}"#).expect("options");
    let vehicle = Some(VehicleClass::Bus);
    assert_eq!(read, NearestOptions { radius: 3.0, vehicle, ..NearestOptions::default() });
}

#[test]
fn unknown_words_and_ids_are_refused() {
    let vehicle = from_str::<VehicleClass>(r#""tram of old""#).expect_err("no vehicle");
    assert!(vehicle.to_string().contains("tram of old"), "{vehicle}");
    let id = from_str::<LaneId>(r#""1:0:-1""#).expect_err("no id");
    assert!(id.to_string().contains("1:0:-1"), "{id}");
}

#[test]
fn numbers_that_json_lacks_come_back() {
    for max in [None, Some(13.5), Some(f64::INFINITY)] {
        let rule = SpeedRule { max, origin: SpeedOrigin::Lane, signal: None };
        let json = to_value(rule).expect("writable");
        assert_eq!(from_value::<SpeedRule>(json).expect("readable"), rule);
    }
    let snapshot = open(&carried("town.xodr"));
    let places = Places { x: &[50.0, 1e6], y: &[-1.75, 1e6], ..Places::default() };
    let (mut scratch, mut out) = (BatchScratch::default(), NearestLanes::default());
    let options = NearestOptions::default();
    snapshot.map().nearest_lanes(places, &options, &mut scratch, &mut out).expect("finite");
    let json = to_value(&out).expect("writable");
    assert!(json["s"][1].is_null(), "{json}");
    let read: NearestLanes = from_value(json).expect("readable");
    assert_eq!(read.lane, out.lane);
    assert!(read.s[0] == out.s[0] && read.s[1].is_nan(), "{read:?}");
}

/// Structs that cannot be written, and why.
const NOT_WRITTEN: &[(&str, &str)] = &[
    ("BatchScratch", "buffers without an answer"),
    ("EntrySignal", "it has cursors into the map"),
    ("ForeignOverlay", "an error"),
    ("GroundScratch", "buffers without an answer"),
    ("ParseLaneKeyError", "an error"),
    ("PathBuffer", "buffers; the path on them has the answers"),
    ("PlatformSegment", "it has cursors into the map"),
    ("PoseError", "an error"),
    ("RouteRequest", "it borrows a cost function"),
    ("RouteScratch", "buffers without an answer"),
    ("SignalLink", "it has cursors into the map"),
    ("SwitchTrack", "it has cursors into the map"),
    ("TraceScratch", "buffers without an answer"),
    ("Tracker", "the state of a filter"),
    ("YieldsTo", "it has cursors into the map"),
];

/// Structs that can be written and not read back, and why; besides those that borrow.
const NOT_READ: &[(&str, &str)] = &[
    ("ConflictApproach", "it has numbers of rows"),
    ("LaneSequences", "buffers of a query, written as the network"),
    ("PathSegment", "it has numbers of rows"),
    ("PoseMatches", "buffers of a query, written as lists"),
    ("Reach", "buffers of a query, written as lists"),
    ("Reached", "it has the number of a row"),
    ("Routes", "buffers of a query, written as lists"),
    ("SignalAhead", "it has the number of a row"),
    ("SignalsAhead", "buffers of a query, written as lists"),
];

/// Every struct of the public list that is no cursor can be written, and what owns all of itself can be read, or has a reason here.
#[test]
fn all_results_and_options_are_data() {
    let list = std::fs::read_to_string(workspace().join("docs/api/mapd-query.txt"));
    let list = list.expect("the list");
    let mut wrong = Vec::new();
    for line in list.lines() {
        let Some((_, path)) = line.split_once("pub struct ") else { continue };
        let whole = path.split('(').next().unwrap_or(path);
        let bare = whole.split('<').next().unwrap_or(whole);
        let name = bare.rsplit("::").next().unwrap_or(bare);
        let borrows = whole.contains("<'");
        let shows = list.lines().any(|line| {
            line.strip_prefix("pub ").is_some_and(|line| {
                line.strip_prefix(bare).is_some_and(|rest| {
                    // Of this type, not of one whose name begins with its name.
                    rest.starts_with(['<', ':']) && rest.contains("::") && rest.contains(": ")
                })
            })
        });
        let has = |what: &str| {
            list.lines().any(|line| {
                let of = line.split_once(what).map(|(_, of)| of);
                of.is_some_and(|of| {
                    of.strip_prefix(bare)
                        .is_some_and(|rest| rest.is_empty() || rest.starts_with(['<', ' ']))
                })
            })
        };
        let excused = |list: &[(&str, &str)]| list.iter().any(|(other, _)| *other == name);
        let is_cursor = borrows && !shows;
        let (written, read) = (has("ser::Serialize for "), has("de::Deserialize<'de> for "));
        if !written && !is_cursor && !excused(NOT_WRITTEN) {
            wrong.push(format!("{name} cannot be written"));
        }
        if written && !read && !borrows && !excused(NOT_READ) {
            wrong.push(format!("{name} cannot be read"));
        }
        if written && excused(NOT_WRITTEN) || read && excused(NOT_READ) {
            wrong.push(format!("{name} needs no excuse"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
