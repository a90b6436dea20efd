//! Which lanes objects belong to: by what the file names, by place, as the nearest.

use mapd_query::Map;
use mapd_query::SRange;
use mapd_query::objects::Object;
use mapd_query::vocabulary::LaneMethod;
use mapd_tests::maps;
use mapd_tests::object_maps::{PLAIN, compile, document, open};

/// Lanes of the first object: number, method, distance to the centimetre.
fn lanes(map: Map<'_>) -> Vec<(i32, LaneMethod, i64)> {
    let object: Object<'_> = map.objects().next().expect("an object");
    let row = |at: mapd_query::objects::ObjectLane<'_>| {
        let lane = at.lane().expect("a lane").number();
        (lane, at.method(), (at.distance() * 100.0).round() as i64)
    };
    object.lanes().map(row).collect()
}

fn check(object: &str, expected: &[(i32, LaneMethod, i64)]) {
    let snapshot = open(&document(&PLAIN, object));
    assert_eq!(lanes(snapshot.map()), expected, "{object}");
}

use LaneMethod::{Nearest, Track, Validity};

#[test]
fn a_validity_names_lanes_whatever_lies_below() {
    let object = |validity: &str| {
        format!(
            r#"<object id="1" type="pole" s="30" t="7" zOffset="0" radius="0.1" orientation="none">{validity}</object>"#
        )
    };
    // Lane −1 reaches from t = 0 to −3.5, 6.9 m from the pole's edge; lane −2 to −6.
    let right = [(-1, Validity, 690), (-2, Validity, 1040)];
    check(&object(r#"<validity fromLane="-2" toLane="-1"/>"#), &right);
    // The wrong way round, which a rule says.
    check(&object(r#"<validity fromLane="-1" toLane="-2"/>"#), &right);
    // Two of them; lane 0 is no lane that something belongs to.
    check(
        &object(r#"<validity fromLane="-1" toLane="0"/><validity fromLane="2" toLane="2"/>"#),
        &[(2, Validity, 140), (-1, Validity, 690)],
    );
    // Of the lanes that it names, those that lead where it is for; all where none does.
    let both = object(r#"<validity fromLane="-1" toLane="1"/>"#);
    check(&both, &[(1, Validity, 340), (-1, Validity, 690)]);
    let along = both.replace(r#"orientation="none""#, r#"orientation="+""#);
    check(&along, &[(-1, Validity, 690)]);
    let against = object(r#"<validity fromLane="-1" toLane="-1"/>"#);
    let against = against.replace(r#"orientation="none""#, r#"orientation="-""#);
    check(&against, &[(-1, Validity, 690)]);
    // Lanes that the road does not have: what counts is where it stands.
    check(&object(r#"<validity fromLane="-9" toLane="-7"/>"#), &[(2, Nearest, 140)]);
}

#[test]
fn what_lies_on_lanes_belongs_to_them() {
    // A stop line across lane −1.
    let line = r#"<object id="1" type="roadMark" s="90" t="-1.75" zOffset="0" length="0.3" width="3.4" orientation="+"/>"#;
    check(line, &[(-1, Track, 0)]);
    // A crosswalk over everything that is driven on, from t = −6 to 3.5.
    let crosswalk = r#"<object id="1" type="crosswalk" s="50" t="0" zOffset="0" orientation="none"><outlines><outline id="0"><cornerRoad s="48" t="-6" dz="0" height="0"/><cornerRoad s="52" t="-6" dz="0" height="0"/><cornerRoad s="52" t="3.5" dz="0" height="0"/><cornerRoad s="48" t="3.5" dz="0" height="0"/></outline></outlines></object>"#;
    check(crosswalk, &[(1, Track, 0), (-1, Track, 0), (-2, Track, 0)]);
    // The same for one direction.
    let forward = crosswalk.replace(r#"orientation="none""#, r#"orientation="+""#);
    check(&forward, &[(-1, Track, 0), (-2, Track, 0)]);
    // A slanted line over lanes 1 and −1: its box in s and t would reach lane 2 too.
    let slanted = r#"<object id="1" type="roadMark" s="50" t="0" zOffset="0" orientation="none"><outlines><outline id="0" closed="false"><cornerRoad s="45" t="-3" dz="0" height="0"/><cornerRoad s="55" t="3" dz="0" height="0"/></outline></outlines></object>"#;
    check(slanted, &[(1, Track, 0), (-1, Track, 0)]);
    let snapshot = open(&document(&PLAIN, slanted));
    let object = snapshot.map().objects().next().expect("an object");
    for at in object.lanes() {
        let SRange { low: from, high: to } = at.s_range();
        let right = at.lane().expect("a lane").number() < 0;
        let expected = if right { (45.0, 50.0) } else { (50.0, 55.0) };
        assert!((from - expected.0).abs() < 1e-5 && (to - expected.1).abs() < 1e-5, "{from} {to}");
    }
}

#[test]
fn what_lies_on_none_belongs_to_the_nearest() {
    // 5.5 m is the sidewalk's edge, −6 m that of the parking lane.
    let tree = |t: f64| {
        format!(r#"<object id="1" type="tree" s="30" t="{t}" zOffset="0" orientation="none"/>"#)
    };
    check(&tree(8.0), &[(2, Nearest, 250)]);
    check(&tree(-26.0), &[(-2, Nearest, 2000)]);
    // Too far: kept with its road, and said.
    check(&tree(60.0), &[]);
    let far = compile(&document(&PLAIN, &tree(60.0)));
    let said = far.diagnostics.iter().filter(|d| d.finding.rule == "mapd:compile.object_lane");
    assert_eq!(said.count(), 1);
    // For the other direction: lane 1 is the nearest that leads against s and is driven on, but nobody drives on the
    // sidewalk, which is for both.
    let against = r#"<object id="1" type="pole" s="30" t="-9" zOffset="0" orientation="-"/>"#;
    check(against, &[(-2, Nearest, 300)]);
}

#[test]
fn how_far_the_nearest_lane_may_be_is_an_option() {
    use mapd_compiler::CompileOptions;
    let objects = r#"<object id="1" type="tree" s="30" t="-26" zOffset="0" orientation="none"/>"#;
    // A validity that names no lane of the road, so that what counts is where it stands.
    let signals = r#"</objects><signals><signal id="1" s="30" t="-26" zOffset="0" orientation="+" dynamic="no" country="DE" type="206" subtype="-1"><validity fromLane="-9" toLane="-9"/></signal></signals>"#;
    let text = document(&PLAIN, objects).replace("</objects>", signals);
    // Both stand 20 m beside lane −2.
    for (lane_reach, expected) in [(30.0, 1), (20.5, 1), (19.5, 0), (0.0, 0)] {
        let options = CompileOptions { lane_reach, ..CompileOptions::default() };
        options.validate().expect("in range");
        let compiled = mapd_compiler::compile(text.as_bytes(), &options, &mut |_| {});
        let rows = compiled.expect("reading works").rows.expect("rows");
        let found = (rows.object_lanes.len(), rows.signal_lanes.len());
        assert_eq!(found, (expected, expected), "{lane_reach}");
        let is_default = options.hash() == CompileOptions::default().hash();
        assert_eq!(is_default, options == CompileOptions::default(), "{lane_reach}");
    }
    for lane_reach in [-1.0, 2000.0, f64::NAN] {
        let options = CompileOptions { lane_reach, ..CompileOptions::default() };
        let refused = options.validate().expect_err("out of range").to_string();
        assert!(refused.starts_with("lane reach must lie between 0 and 1000 m"), "{refused}");
    }
}

#[test]
fn repeated_parking_spaces_belong_to_the_parking_lane() {
    let spaces = r#"<object id="1" type="parkingSpace" s="10" t="-4.75" zOffset="0" length="5" width="2.4" orientation="none"><repeat s="20" length="30" distance="6" tStart="-4.75" tEnd="-4.75" heightStart="0" heightEnd="0" zOffsetStart="0" zOffsetEnd="0"/><parkingSpace access="all"/></object>"#;
    check(spaces, &[(-2, Track, 0)]);
    let snapshot = open(&document(&PLAIN, spaces));
    let map = snapshot.map();
    let lane = map.lane_by_key(&"1:0:-2".parse().expect("a key")).expect("a lane");
    let at = lane.objects().next().expect("an object");
    // From 20 − 2.5 to 50 + 2.5: six of them.
    let SRange { low: from, high: to } = at.s_range();
    assert!((from - 17.5).abs() < 1e-5 && (to - 52.5).abs() < 1e-5, "{from} {to}");
    assert_eq!(at.object().expect("an object").placements().count(), 6);
}

/// On maps with objects of several vendors: both directions tell the same, and what is said to lie on a lane does.
#[test]
fn both_directions_agree() {
    let names = [
        "Scenic/Town10HD",
        "gdal/5g_living_lab_A39_Wolfsburg-West",
        "esmini/parking_demo",
        "ivsg/workzone_100m_Lane_Offset",
        "Scenic/Town07",
    ];
    let mut counts = [0usize; 4];
    for path in maps::carried_and(&names) {
        let snapshot = maps::open(&path);
        let map = snapshot.map();
        let mut there = vec![];
        for object in map.objects() {
            for at in object.lanes() {
                let lane = at.lane().expect("a lane");
                there.push((lane.lane_id(), object.object_id()));
                counts[usize::from(at.method().code())] += 1;
                let section = lane.section();
                let SRange { low: from, high: to } = at.s_range();
                assert!(
                    from <= to && from > section.s_start() - 1e-3 && to < section.s_end() + 1e-3
                );
                assert!((at.distance() == 0.0) || at.method() != Track);
            }
        }
        let back = |lane: mapd_query::Lane<'_>| {
            let all: Vec<_> = lane
                .objects()
                .map(|at| (lane.lane_id(), at.object().expect("an object").object_id()))
                .collect();
            all
        };
        let mut here: Vec<_> = map.lanes().flat_map(back).collect();
        here.sort();
        there.sort();
        assert_eq!(here, there, "{}", path.display());
    }
    mapd_tests::say(&format!("by validity, -, s and t, as nearest: {counts:?}"));
}
