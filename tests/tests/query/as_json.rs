//! Results and options as JSON, with the feature `serde`.

use mapd_client::glam::DVec2;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, Nearest, NearestOptions};
use mapd_tests::carried;
use mapd_tests::maps::open;
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
