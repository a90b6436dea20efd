//! Road marks: what the file says of them is what the map answers.

use mapd_archive::NONE;
use mapd_client::compiling::ByRow as _;
use mapd_client::glam::DVec2;
use mapd_client::localisation::MarkFilter;
use mapd_client::vocabulary::{
    MarkLaneChange, RoadMarkColor, RoadMarkKind, RoadMarkRule, RoadMarkWeight,
};
use mapd_client::{LaneTypes, Map, Region};
use mapd_tests::carried;
use mapd_tests::literal::Element;
use mapd_tests::maps::{carried_and, open, open_text};
use mapd_web::{Layer, MarkStroke};
use std::collections::HashMap;
use std::path::Path;
use std::time::UNIX_EPOCH;

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

/// A road of a line and a bend, one side of which goes on where the other has a new section, with broken and explicit lines on that side.
fn goes_on(side: &str) -> String {
    let broken = r#"<roadMark sOffset="1" type="broken" weight="standard" color="white" width="0.12"><type name="b" width="0.12"><line length="3" space="6" tOffset="0" sOffset="0.5" rule="none" width="0.12"/></type></roadMark>"#;
    let explicit = r#"<roadMark sOffset="0" type="custom" weight="standard" color="white" width="0.12"><explicit><line length="5" tOffset="0.1" sOffset="10" rule="none" width="0.12"/><line length="20" tOffset="0" sOffset="44" rule="none" width="0.12"/></explicit></roadMark>"#;
    let lanes = |first: i32, second: i32, marks: [&str; 2]| {
        let lane = |id: i32, mark: &str| {
            format!(
                r#"<lane id="{id}" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/>{mark}</lane>"#
            )
        };
        lane(first, marks[0]) + &lane(second, marks[1])
    };
    let [left, right] = match side {
        "left" => [lanes(2, 1, [explicit, broken]), lanes(-1, -2, ["", ""])],
        _ => [lanes(2, 1, ["", ""]), lanes(-1, -2, [broken, explicit])],
    };
    let center = r#"<center><lane id="0" type="none"/></center>"#;
    let other = match side {
        "left" => format!("{center}<right>{right}</right>"),
        _ => format!("<left>{left}</left>{center}"),
    };
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="120" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry><geometry s="40" x="40" y="0" hdg="0" length="80"><arc curvature="0.02"/></geometry></planView><lanes><laneSection s="0"><left>{left}</left>{center}<right>{right}</right></laneSection><laneSection s="50" singleSide="true">{other}</laneSection></lanes></road></OpenDRIVE>"#
    )
}

/// What the page and files draw of a mark is what queries say is painted: also where a lane goes on from another section, and in a bend, where no dash is as long as its s.
#[test]
fn drawn_dashes_are_those_that_queries_answer() {
    /// As near to the end of a dash rounding to single precision decides `[m]`.
    const ENDS: f64 = 0.01;
    for side in ["left", "right"] {
        let snapshot = open_text(&goes_on(side));
        let map = snapshot.map();
        let filter = MarkFilter::default();
        let painted = |place: DVec2| {
            let near = map.nearest_mark(place, &filter).expect("finite").expect("a mark");
            assert!(near.distance < 0.05, "{side}: {near:?}");
            near.painted
        };
        let (bounds, mut counts) = (map.bounds(), [0; 2]);
        let middle = 0.5 * (bounds.low + bounds.high).truncate();
        let drawing = Layer::Marks.draw(snapshot.view(UNIX_EPOCH));
        for stroke in &drawing.strokes {
            let [from, to] = [stroke.from, stroke.to].map(|at| DVec2::from(at.map(f64::from)));
            let [along, dash, gap] = [stroke.along, stroke.dash, stroke.gap].map(f64::from);
            for share in (0..50).map(|i| (f64::from(i) + 0.5) / 50.0) {
                let period = dash + gap;
                let phase = (along + share * from.distance(to)) % period;
                if [phase, phase - dash, phase - period].iter().any(|off| off.abs() < ENDS) {
                    continue;
                }
                let is_drawn = gap == 0.0 || phase < dash;
                let place = middle + from.lerp(to, share);
                assert_eq!(painted(place), Some(is_drawn), "{side} {place} {stroke:?}");
                counts[usize::from(is_drawn)] += 1;
            }
        }
        assert!(counts.iter().all(|count| *count > 100), "{side}: {counts:?}");
        let mut dashes = 0;
        for lane in map.lanes() {
            for mark in lane.road_marks() {
                for stroke in MarkStroke::of(&mark, lane.number()) {
                    let line = stroke.line(&lane, &mark);
                    for dash in stroke.painted(&line) {
                        let ends = [dash[0], dash[dash.len() - 1]];
                        for share in [0.02, 0.98] {
                            let place = ends[0].lerp(ends[1], share).truncate();
                            // A chord of three metres leaves the bend by two centimetres.
                            assert_eq!(painted(place), Some(true), "{side} {place} {stroke:?}");
                        }
                        dashes += 1;
                    }
                }
            }
        }
        // From 1.5 m on every 9 m; the first line, and the second in two parts.
        assert_eq!(dashes, 14 + 1 + 2, "{side}");
    }
}
