//! Sections that replace the lanes of one side only, borders instead of widths, widths that reach zero.

use mapd_client::glam::DVec2;
use mapd_client::{LaneKey, NearestOptions, Snapshot};
use mapd_tests::maps::open_text;

fn open(sections: &str) -> Snapshot {
    let text = format!(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\" length=\"100\" junction=\"-1\">\
         <planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\"><line/></geometry></planView>\
         <lanes>{sections}</lanes></road></OpenDRIVE>"
    );
    open_text(&text)
}

/// A lane whose content is written out.
fn lane(id: i32, inside: &str) -> String {
    format!("<lane id=\"{id}\" type=\"driving\">{inside}</lane>")
}

fn width(s_offset: f64, a: f64, b: f64) -> String {
    format!("<width sOffset=\"{s_offset}\" a=\"{a}\" b=\"{b}\" c=\"0\" d=\"0\"/>")
}

fn section(s: f64, single: bool, left: &str, right: &str) -> String {
    let side = |name: &str, lanes: &str| match lanes {
        "" => String::new(),
        lanes => format!("<{name}>{lanes}</{name}>"),
    };
    format!(
        "<laneSection s=\"{s}\" singleSide=\"{single}\">{}<center><lane id=\"0\" type=\"none\"/></center>{}</laneSection>",
        side("left", left),
        side("right", right)
    )
}

/// Left sections begin at 0 and 40, right ones at 0 and 70: three stretches.
fn three_stretches() -> Snapshot {
    let linked = |to: &str, id: i32| format!("<link><{to} id=\"{id}\"/></link>");
    open(
        &[
            section(
                0.0,
                false,
                &lane(1, &(linked("successor", 2) + &width(0.0, 3.0, 0.0))),
                &lane(-1, &(linked("successor", -2) + &width(0.0, 3.0, 0.01))),
            ),
            section(
                40.0,
                true,
                &(lane(2, &(linked("predecessor", 1) + &width(0.0, 3.0, 0.0)))
                    + &lane(1, &width(0.0, 2.0, 0.0))),
                "",
            ),
            section(
                70.0,
                true,
                "",
                &(lane(-1, &width(0.0, 1.0, 0.0))
                    + &lane(-2, &(linked("predecessor", -1) + &width(0.0, 3.0, 0.0)))),
            ),
        ]
        .concat(),
    )
}

#[test]
fn each_side_has_its_own_sections() {
    let snapshot = three_stretches();
    let road = snapshot.map().road_by_id("1").expect("the road");
    // By s: numbers of the lanes there, from left to right.
    for (s, expected) in
        [(20.0, &[1, 0, -1][..]), (50.0, &[2, 1, 0, -1]), (90.0, &[2, 1, 0, -1, -2])]
    {
        let section = road.section_at(s).expect("a section");
        let numbers: Vec<i32> = section.lanes().map(|lane| lane.number()).collect();
        assert_eq!(numbers, expected, "s = {s}");
    }
    // A width of section 0 goes on counting from there: 3 + 0.01·s.
    for s in [10.0, 45.0, 69.0] {
        let lane = road.section_at(s).and_then(|section| section.lane(-1)).expect("the lane");
        assert!((lane.width_at(s) - (3.0 + 0.01 * s)).abs() < 1e-12, "s = {s}");
    }
}

#[test]
fn a_lane_that_goes_on_has_one_name() {
    let snapshot = three_stretches();
    let map = snapshot.map();
    let options = NearestOptions::default();
    for (x, y, expected) in [
        (20.0, -1.0, "1:0:-1"),
        (50.0, -1.0, "1:0:-1"),
        (80.0, -0.5, "1:2:-1"),
        (20.0, 1.0, "1:0:1"),
        (50.0, 3.0, "1:1:2"),
        (80.0, 3.0, "1:1:2"),
    ] {
        let hit = map.nearest_lane(DVec2::new(x, y), &options).expect("an answer").expect("a lane");
        let lane = map.lane(hit.lane).expect("the map's own");
        assert_eq!(
            (lane.key().to_string().as_str(), hit.position.distance),
            (expected, 0.0),
            "{x}, {y}"
        );
        let first = map.lane_by_key(&lane.key()).expect("its key is known");
        assert_eq!(first.number(), lane.number());
        assert!(!first.continues());
    }
    // No piece of a lane can be had by the number of the section in which it goes on.
    let key: LaneKey<'_> = "1:1:-1".parse().expect("a key");
    assert!(map.lane_by_key(&key).is_none());
    assert!(map.lane_by_key(&"1:2:-2".parse().expect("a key")).is_some());
}

#[test]
fn pieces_are_linked_in_driving_direction() {
    let snapshot = three_stretches();
    let map = snapshot.map();
    // Right lanes run along s: −1 goes on as itself at 40 and enters −2 of section 2 at 70.
    let mut lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("the lane");
    let mut passed = vec![lane.key().to_string()];
    while let Some(next) = lane.successors().next() {
        lane = map.lane(next).expect("the map's own");
        passed.push(lane.key().to_string());
    }
    assert_eq!(passed, ["1:0:-1", "1:0:-1", "1:2:-2"]);
    // Left lanes run against it: 2 of section 1 ends at 100, goes on back to 40, and enters 1 of section 0.
    let mut lane = map.road_by_id("1").and_then(|road| road.section(2)?.lane(2)).expect("the lane");
    let mut passed = vec![lane.key().to_string()];
    while let Some(next) = lane.successors().next() {
        lane = map.lane(next).expect("the map's own");
        passed.push(lane.key().to_string());
    }
    assert_eq!(passed, ["1:1:2", "1:1:2", "1:0:1"]);
}

/// They counted from the section in which the lanes to the right are written.
#[test]
fn marks_of_the_center_lane_count_from_its_own_section() {
    let center = |marks: [(f64, &str); 2]| {
        let mark = |(s, kind)| {
            format!(
                "<roadMark sOffset=\"{s}\" type=\"{kind}\" color=\"standard\" laneChange=\"both\"/>"
            )
        };
        format!("<lane id=\"0\" type=\"none\">{}</lane>", marks.map(mark).concat())
    };
    let plain = "<lane id=\"0\" type=\"none\"/>";
    let (left, right) = (lane(1, &width(0.0, 3.0, 0.0)), lane(-1, &width(0.0, 3.0, 0.0)));
    let first = section(0.0, false, &left, &right);
    let for_left = section(40.0, true, &left, "");
    let snapshot = open(
        &(first.replace(plain, &center([(0.0, "solid"), (10.0, "broken")]))
            + &for_left.replace(plain, &center([(0.0, "solid"), (20.0, "broken")]))),
    );
    let road = snapshot.map().road_by_id("1").expect("the road");
    for (number, expected) in [(0, [0.0, 10.0]), (1, [40.0, 60.0])] {
        let lane = road.section(number).and_then(|section| section.lane(0)).expect("lane 0");
        assert_eq!(lane.road_marks().map(|mark| mark.s()).collect::<Vec<_>>(), expected);
    }
}

#[test]
fn borders_stand_for_themselves() {
    // A border counts from the reference line, not from the lane inside: from 3 m, growing by 0.02 per metre; from s = 50 on
    // another record, 5 m. The next lane has a width on top.
    let border = |s: f64, a: f64, b: f64| {
        format!("<border sOffset=\"{s}\" a=\"{a}\" b=\"{b}\" c=\"0\" d=\"0\"/>")
    };
    let left = lane(1, &(border(0.0, 3.0, 0.02) + &border(50.0, 5.0, 0.0)))
        + &lane(2, &width(0.0, 1.5, 0.0));
    let snapshot = open(&section(0.0, false, &left, ""));
    let section =
        snapshot.map().road_by_id("1").and_then(|road| road.section(0)).expect("a section");
    for (s, edge) in [(0.0, 3.0), (25.0, 3.5), (50.0, 5.0), (75.0, 5.0)] {
        let (inner, outer) = (section.lane(1).expect("a lane"), section.lane(2).expect("a lane"));
        assert!((inner.edges_at(s).outer - edge).abs() < 1e-12, "s = {s}");
        assert!((outer.edges_at(s).outer - (edge + 1.5)).abs() < 1e-12, "s = {s}");
    }
}

#[test]
fn widths_may_reach_zero() {
    // 2 m at s = 0, nothing at 50, nothing (and not a negative width) until the record at 80, then 3 m at once.
    let right = lane(-1, &(width(0.0, 2.0, -0.04) + &width(80.0, 3.0, 0.0)))
        + &lane(-2, &width(0.0, 3.0, 0.0));
    let snapshot = open(&section(0.0, false, "", &right));
    let map = snapshot.map();
    let section = map.road_by_id("1").and_then(|road| road.section(0)).expect("a section");
    for (s, width) in [(0.0, 2.0), (25.0, 1.0), (50.0, 0.0), (70.0, 0.0), (80.0, 3.0), (90.0, 3.0)]
    {
        assert!((section.lane(-1).expect("a lane").width_at(s) - width).abs() < 1e-12, "s = {s}");
        let outer = section.lane(-2).expect("a lane").edges_at(s);
        assert!(
            (outer.inner + width).abs() < 1e-12 && (outer.width() - 3.0).abs() < 1e-12,
            "s = {s}"
        );
    }
    // Where the first lane has no width, the second one begins at the reference line.
    for (x, y, lane) in [(70.0, -0.5, -2), (25.0, -0.5, -1), (85.0, -0.5, -1), (85.0, -3.5, -2)] {
        let hit = map.nearest_lane(DVec2::new(x, y), &NearestOptions::default());
        let hit = hit.expect("an answer").expect("a lane");
        let found = map.lane(hit.lane).expect("the map's own");
        assert_eq!((found.number(), hit.position.distance), (lane, 0.0), "{x}, {y}");
    }
}
