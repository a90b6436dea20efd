//! One test for each defect that was found after the fact.

use mapd_archive::encode;
use mapd_client::{LaneEdges, Snapshot, glam::DVec2};
use mapd_compiler::{CompileOptions, compile};

/// Compiles a map of these roads.
fn map(roads: &str) -> Snapshot {
    let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{roads}</OpenDRIVE>");
    let compiled =
        compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    Snapshot::from_bytes(encode(&rows, &compiled.provenance).expect("encodes")).expect("opens")
}

/// A lane was evaluated at its end with the lane offset that begins with the next section: its area reached 3.5 m too far,
/// and points beyond its end were too near to it.
#[test]
fn a_lane_ends_with_what_holds_in_its_section() {
    let lane = |id: i32| {
        format!(
            "<lane id=\"{id}\" type=\"driving\"><width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/></lane>"
        )
    };
    let section = |s: f64, right: &str| {
        format!(
            "<laneSection s=\"{s}\"><center><lane id=\"0\" type=\"none\"/></center><right>{right}</right></laneSection>"
        )
    };
    let snapshot = map(&format!(
        "<road id=\"1\" length=\"20\" junction=\"-1\"><planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"20\"><line/></geometry></planView>\
         <lanes><laneOffset s=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/><laneOffset s=\"10\" a=\"0\" b=\"0\" c=\"0\" d=\"0\"/>{}{}</lanes></road>",
        section(0.0, &(lane(-1) + &lane(-2))),
        section(10.0, &lane(-1)),
    ));
    let map = snapshot.map();
    let lane = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
    assert_eq!(lane("1:0:-2").edges_at(10.0), LaneEdges { inner: 0.0, outer: -3.5 });
    assert_eq!(lane("1:1:-1").edges_at(10.0), LaneEdges { inner: 0.0, outer: -3.5 });
    // One metre beyond the end of the first section: both lanes of it end at x = 10.
    let point = DVec2::new(11.0, 2.0);
    assert_eq!(lane("1:0:-1").position_of(point).expect("a position").distance, 1.0);
    assert_eq!(lane("1:0:-2").position_of(point).expect("a position").distance, 5f64.sqrt());
    assert_eq!(lane("1:0:-1").pose_at(10.0, 0.0).expect("a pose").position.y, 1.75);
}
