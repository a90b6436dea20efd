//! Lanes of the temporary layer (OpenDRIVE 1.9): there with geometry and name, apart from the lanes that are there for good.

use mapd_client::glam::DVec2;
use mapd_client::{LaneKey, LaneLayer, NearestOptions, Snapshot};
use mapd_tests::maps::open;

/// A straight road of 100 m whose lane is replaced by a narrower one, shifted to the left, from s = 40 to 60.
const MAP: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<OpenDRIVE>
  <header revMajor="1" revMinor="9" name="" version="1" date="2026-01-01T00:00:00" north="10" south="-10" east="100" west="0"/>
  <road name="" length="100" id="1" junction="-1" rule="RHT">
    <planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>
    <lanes layer="permanent">
      <laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection>
      <laneSection s="40"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection>
      <laneSection s="60"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection>
    </lanes>
    TEMPORARY
  </road>
</OpenDRIVE>
"#;

const LAYER: &str = r#"<lanes layer="temporary">
      <laneOffset s="0" a="0.5" b="0" c="0" d="0"/>
      <laneSection s="40" length="20"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/><roadMark sOffset="0" type="solid" color="yellow" width="0.12"/><speed sOffset="0" max="30" unit="km/h"/></lane></right></laneSection>
    </lanes>"#;

fn compile(temporary: &str) -> Snapshot {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("layers.xodr");
    std::fs::write(&path, MAP.replace("TEMPORARY", temporary)).expect("written");
    open(&path)
}

#[test]
fn temporary_lanes_have_geometry_and_a_name_of_their_own() {
    let snapshot = compile(LAYER);
    snapshot.verify().expect("a sound archive");
    let map = snapshot.map();
    let road = map.road_by_id("1").expect("a road");
    let sections: Vec<_> = road.temporary_sections().map(|s| (s.s_start(), s.s_end())).collect();
    assert_eq!(sections, [(40.0, 60.0)]);
    let key: LaneKey<'_> = "1:0:-1@temporary".parse().expect("a key");
    assert_eq!((key.section, key.lane, key.layer), (0, -1, LaneLayer::Temporary));
    let lane = map.lane_by_key(&key).expect("the lane");
    assert_eq!(lane.key().to_string(), "1:0:-1@temporary");
    assert!(lane.is_temporary());
    // The layer's lane offset is 0.5, the lane 2.5 wide.
    let edges = lane.edges_at(50.0);
    assert_eq!((edges.inner, edges.outer), (0.5, -2.0));
    let ends: Vec<_> = lane.center_line().positions().map(|p| (p.x, p.y)).collect();
    assert_eq!((ends.first(), ends.last()), (Some(&(40.0, -0.75)), Some(&(60.0, -0.75))));
    assert_eq!(lane.road_marks().map(|mark| mark.s()).collect::<Vec<_>>(), [40.0]);
    assert!((lane.recorded_speed_limit_at(50.0).expect("a limit") - 30.0 / 3.6).abs() < 1e-12);
    assert_eq!((lane.nodes().count(), lane.successors().count()), (0, 0));
}

#[test]
fn lanes_that_are_there_for_good_are_the_same_with_and_without_them() {
    let (with, without) = (compile(LAYER), compile(""));
    let lanes = |snapshot: &Snapshot| -> Vec<_> {
        let lanes = snapshot.map().lanes();
        lanes
            .map(|lane| {
                let next: Vec<_> = lane.successors().collect();
                let next = next
                    .iter()
                    .map(|id| snapshot.map().lane(*id).expect("known").key().to_string());
                (lane.key().to_string(), lane.edges_at(50.0), next.collect::<Vec<_>>())
            })
            .collect()
    };
    assert_eq!(lanes(&with).len(), 3);
    assert_eq!(lanes(&with), lanes(&without));
    for (x, section) in [(20.0, 0), (50.0, 1), (80.0, 2)] {
        let near = |snapshot: &Snapshot| {
            let point = DVec2::new(x, -0.75);
            let found = snapshot.map().nearest_lane(point, &NearestOptions::default());
            let found = found.expect("an answer").expect("a lane");
            snapshot.map().lane(found.lane).expect("known").key().to_string()
        };
        assert_eq!((near(&with), near(&without)), (format!("1:{section}:-1"), near(&with)));
    }
    assert!(without.map().road_by_id("1").expect("a road").temporary_sections().next().is_none());
}
