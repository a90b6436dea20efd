//! Which of several lanes that are equally near is the nearest.

use mapd_client::NearestOptions;
use mapd_client::glam::DVec2;
use mapd_tests::maps::open_text;

/// A lane of 3 m to the right of lane 0, and one without width on each of its edges.
const LINES_BESIDE_A_LANE: &str = r#"<OpenDRIVE><header revMajor="1" revMinor="8"/>
<road id="1" length="50" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0">
<left><lane id="1" type="driving"><width sOffset="0" a="0" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving"><width sOffset="0" a="0" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road></OpenDRIVE>"#;

#[test]
fn a_lane_without_width_comes_after_the_one_on_whose_edge_it_lies() {
    let snapshot = open_text(LINES_BESIDE_A_LANE);
    let map = snapshot.map();
    let options = NearestOptions::default();
    for (y, distance) in [(-5.0, 2.0), (-3.0, 0.0), (-1.0, 0.0), (0.0, 0.0), (2.0, 2.0)] {
        let point = DVec2::new(20.0, y);
        let found = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
        assert_eq!(map.lane(found.lane).expect("a lane").number(), -1, "at y = {y}");
        assert_eq!(found.position.distance, distance, "at y = {y}");
        let mut near = Vec::new();
        map.lanes_near(point, &options, &mut near).expect("an answer");
        assert_eq!(near.first(), Some(&found), "at y = {y}");
        assert_eq!(near.len(), 3, "at y = {y}");
    }
}
