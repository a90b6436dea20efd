//! Road marks: what the file says of them is what the map answers.

use mapd_archive::NONE;
use mapd_client::compiling::ByRow as _;
use mapd_client::glam::DVec2;
use mapd_client::vocabulary::{
    MarkLaneChange, RoadMarkColor, RoadMarkKind, RoadMarkRule, RoadMarkWeight,
};
use mapd_client::{LaneTypes, Map, Region};
use mapd_tests::carried;
use mapd_tests::literal::Element;
use mapd_tests::maps::{carried_and, open};
use std::collections::HashMap;
use std::path::Path;

#[test]
fn every_form_of_mark_answers_as_written() {
    let snapshot = open(&carried("marks.xodr"));
    let map = snapshot.map();
    let lane = |number: i32| {
        let section = map.road_by_id("1").expect("a road").section(0).expect("a section");
        section.lane(number).expect("a lane")
    };
    let kinds = |number| -> Vec<_> {
        lane(number).road_marks().map(|m| (m.s(), m.s_end(), m.kind())).collect()
    };
    assert_eq!(kinds(2), [(0.0, 100.0, RoadMarkKind::Edge)]);
    let [solid, dots, none] = [RoadMarkKind::Solid, RoadMarkKind::BottsDots, RoadMarkKind::None];
    assert_eq!(kinds(1), [(0.0, 40.0, solid), (40.0, 70.0, dots), (70.0, 100.0, none)]);
    let (broken, custom) = (RoadMarkKind::Broken, RoadMarkKind::Custom);
    assert_eq!(kinds(0), [(0.0, 50.0, RoadMarkKind::SolidBroken), (50.0, 100.0, broken)]);
    assert_eq!(kinds(-1), [(0.0, 60.0, broken), (60.0, 100.0, custom)]);

    let center = lane(0).road_mark_at(10.0).expect("a mark");
    assert_eq!((center.color(), center.width()), (RoadMarkColor::Yellow, Some(0.15)));
    assert_eq!((center.height(), center.material()), (Some(0.01), "paint"));
    assert_eq!(center.lane_change(), MarkLaneChange::Increase);
    let bold = lane(1).road_mark_at(0.0).expect("a mark");
    assert_eq!((bold.weight(), bold.width()), (RoadMarkWeight::Bold, None));
    assert_eq!((bold.width_or_default(), bold.height()), (0.25, None));
    // The same words twice are one style.
    assert_eq!(map.tables().road_mark_styles.len(), 8);

    let pattern = lane(-1).road_mark_at(59.0).expect("a mark");
    assert_eq!(pattern.pattern_name(), "1:2 m");
    let lines: Vec<_> = pattern.lines().collect();
    assert_eq!((lines.len(), lines[0].length, lines[0].space), (1, 1.0, Some(2.0)));
    assert_eq!((lines[0].rule, lines[0].color), (RoadMarkRule::Caution, RoadMarkColor::White));
    let explicit = lane(-1).road_mark_at(60.0).expect("a mark");
    let lines: Vec<_> = explicit.lines().map(|l| (l.s_offset, l.t_offset, l.space)).collect();
    assert_eq!(lines, [(2.0, 0.2, None), (10.0, -0.2, None)]);

    // Sway from s = 50 on: 0.002 ds², from ds = 20 on 0.8 + 0.08 (ds − 20) − 0.002 (ds − 20)².
    let swaying = lane(0).road_mark_at(50.0).expect("a mark");
    for (s, t) in [(50.0, 0.0), (60.0, 0.2), (70.0, 0.8), (80.0, 0.8 + 0.8 - 0.2)] {
        assert!((swaying.t_at(s) - t).abs() < 1e-12, "{s}: {}", swaying.t_at(s));
    }
}

#[test]
fn segments_in_a_rectangle_are_cut_where_marks_change() {
    let snapshot = open(&carried("marks.xodr"));
    let (mut lanes, mut borders, mut out) = (Vec::new(), Vec::new(), Vec::new());
    let region = Region { low: DVec2::new(45.0, 3.0), high: DVec2::new(95.0, 5.1) };
    snapshot
        .map()
        .road_mark_segments(region, LaneTypes::ALL, &mut lanes, &mut borders, &mut out)
        .expect("an answer");
    let found: Vec<_> = out.iter().map(|m| (m.kind, m.segment.s, m.width)).collect();
    // Lane 1's solid mark ends at 40, before the rectangle; from 70 on it has none.
    assert_eq!(
        found,
        [(RoadMarkKind::Edge, [0.0, 100.0], 0.3), (RoadMarkKind::BottsDots, [40.0, 70.0], 0.1)]
    );
    assert_eq!(out[1].segment.ends.map(|p| (p.x, p.y)), [(40.0, 3.5), (70.0, 3.5)]);
}

/// Marks as written: number and kind by road, s (as bits) and lane.
type Marks = HashMap<(String, i32, u64), (usize, String)>;

/// What the file says, read by a DOM that shares nothing with the compiler.
fn written(path: &Path) -> Marks {
    let mut marks = Marks::new();
    let document = Element::parse(&std::fs::read_to_string(path).expect("opens"));
    for road in document.all("road") {
        for section in road.all("lanes").flat_map(|lanes| lanes.all("laneSection")) {
            let sides = ["left", "center", "right"].map(|side| section.all(side));
            for lane in sides.into_iter().flatten().flat_map(|side| side.all("lane")) {
                for mark in lane.all("roadMark") {
                    let number = |of: &Element, name| of.get(name).map(|n| n.parse::<f64>());
                    let s = [number(section, "s"), number(mark, "sOffset")]
                        .map(|n| n.expect("a number"));
                    let [Ok(s), Ok(offset)] = s else { panic!("{}: not a number", path.display()) };
                    let lane = lane.get("id").expect("an id").parse().expect("a number");
                    let place =
                        (road.get("id").expect("an id").to_owned(), lane, (s + offset).to_bits());
                    let known = marks.entry(place).or_insert((0, String::new()));
                    *known = (known.0 + 1, mark.get("type").unwrap_or_default().to_owned());
                }
            }
        }
    }
    marks
}

/// What the map's tables hold.
fn stored(map: Map<'_>) -> Marks {
    let mut marks = Marks::new();
    let tables = map.tables();
    for (lane, row) in (0u32..).zip(tables.lanes) {
        let lane = map.lane_by_row(lane).expect("a lane");
        let written = row.section() - u32::from(row.continues());
        let start = tables.sections[written as usize].s_start();
        let mut at = row.first_mark();
        while at != NONE {
            let mark = &tables.road_marks[at as usize];
            let style = &tables.road_mark_styles[mark.style() as usize];
            let kind = RoadMarkKind::from_code(style.kind()).name().to_owned();
            let s = (start + mark.s_offset()).to_bits();
            let place = (lane.road().id().to_owned(), lane.number(), s);
            let known = marks.entry(place).or_insert((0, String::new()));
            *known = (known.0 + 1, kind);
            at = if mark.last() == 1 { NONE } else { at + 1 };
        }
    }
    marks
}

#[test]
fn no_mark_of_a_map_is_lost() {
    let corpus = ["carla/Town05", "esmini/multi_intersections", "esmini/soderleden"];
    let mut seen = 0;
    for path in carried_and(&corpus).into_iter().chain([carried("marks.xodr")]) {
        let (written, stored) = (written(&path), stored(open(&path).map()));
        for (place, expected) in &written {
            assert_eq!(stored.get(place), Some(expected), "{}: {place:?}", path.display());
        }
        assert_eq!(written.len(), stored.len(), "{}", path.display());
        seen += written.len();
    }
    assert!(seen > 8, "no marks to compare");
}
