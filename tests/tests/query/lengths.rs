//! Lengths of lanes, and S of paths: exact ones, and those of chords between places that lie close together.

use mapd_client::glam::DVec2;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map};
use mapd_compiler::CompileOptions;
use mapd_query::path::{PathBuffer, PathOptions, steps_of_lanes};
use mapd_query::route::{PositionOnLane, Reached, RouteScratch, ShortestLength};
use mapd_tests::carried;
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::{carried_and, open, open_text, open_text_with};

/// Maps besides the carried ones: tight cubics, cubics of another length than written, widths below 0, superelevation.
const MAPS: [&str; 7] = [
    "SMARTS/od_newmarket_map",
    "Scenic/Issue189",
    "carla/Town05",
    "esmini/multi_intersections",
    "esmini/velodrome",
    "maliput_malidrive/ParametricCubicCurveComplexRoad",
    "sumo/adlershof_dlr_netconvert",
];
/// Chords of a stretch on which a lane is smooth.
const CHORDS: usize = 512;
/// By how much a corner between the ends of two chords may shorten a lane, per metre.
const CORNER: f64 = 1e-6;
/// Allowed difference of two lengths `[m]`.
const TOLERANCE: f64 = 1e-6;
/// Allowed difference of an exact length `[m]`.
const EXACT: f64 = 2e-9;
/// Allowed difference between S and what is driven, within a span `[m]`.
const ALONG: f64 = 2e-4;
/// What stations in single precision may be off `[m]`.
const STATION: f64 = 1e-4;
/// Places of a lane at which S is compared.
const PLACES: u32 = 40;

/// Length of the centre line between two s that no record begins between, and how sure that is `[m]`.
fn by_chords(lane: &Lane<'_>, from: f64, to: f64) -> [f64; 2] {
    let place = |s: f64| -> DVec2 {
        lane.pose_of_reference_line(s, 0.0).expect("a pose").position.truncate()
    };
    let sum = |parts: usize| -> f64 {
        let at = |i: usize| match i {
            0 => from.next_up(),
            _ if i == parts => to.next_down(),
            _ => from + (to - from) * (i as f64 / parts as f64),
        };
        let places: Vec<DVec2> = (0..=parts).map(|i| place(at(i))).collect();
        places.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    };
    let (coarse, fine) = (sum(CHORDS), sum(2 * CHORDS));
    // Chords fall short with the square of their length.
    let better = fine + (fine - coarse) / 3.0;
    [better, (better - fine).abs()]
}

/// Ends of the stretches on which a lane is smooth.
fn cuts(lane: &Lane<'_>) -> Vec<f64> {
    let (start, end) = (lane.section().s_start(), lane.section().s_end());
    let inner = lane.shape_breaks().filter(|s| *s > start && *s < end);
    let mut all: Vec<f64> = inner.chain([start, end]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The lane is as long as told, and S along it is what is driven at every place.
fn check(map: Map<'_>, lane: &Lane<'_>, expected: f64, tolerance: f64, context: &str) {
    let cuts = cuts(lane);
    let (start, end) = (cuts[0], cuts[cuts.len() - 1]);
    let own = lane.length_between(start, end);
    let key = lane.key();
    assert!((own - expected).abs() <= tolerance, "{context} {key}: {own}, not {expected}");
    let ends = if lane.is_forward() { [start, end] } else { [end, start] };
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    steps_of_lanes(map, &[lane.lane_id()], ends, &mut steps).expect("a step");
    let Ok(path) = map.path(&steps, &PathOptions::default(), &mut buffer) else {
        // No centre line at all.
        assert!(own <= tolerance, "{context} {key}: no path over {own} m");
        return;
    };
    for place in 0..=PLACES {
        let s = start + (end - start) * (f64::from(place) / f64::from(PLACES));
        let Some(along) = path.along_of(lane.lane_id(), s) else {
            // Behind the end of its line nothing of a lane is driven, nor where records hold for less than a station tells apart.
            let is_behind = s > lane.road().reference_end() || end - s < STATION;
            assert!(is_behind, "{context} {key}: no S at {s}");
            continue;
        };
        let driven = lane.length_between(ends[0], s);
        assert!((along - driven).abs() <= ALONG, "{context} {key} at {s}: {along}, not {driven}");
    }
}

/// What is reached of a lane is as long as what is left for it. Lengths of nodes have single precision.
fn check_reach(map: Map<'_>, lane: &Lane<'_>, limit: f64, context: &str) {
    let (start, end) = (lane.section().s_start(), lane.section().s_end());
    let s = if lane.is_forward() { start } else { end };
    let from = PositionOnLane { lane: lane.lane_id(), s };
    let (mut scratch, mut out) = (RouteScratch::default(), Vec::new());
    let (car, cost) = (VehicleClass::PassengerCar, ShortestLength::default());
    map.reachable(from, limit, car, &cost, &mut scratch, &mut out).expect("an answer");
    let on_it = |own: &&Reached| own.lane == from.lane && own.forward == lane.is_forward();
    let own = out.iter().filter(on_it);
    let driven: f64 = own.clone().map(|own| lane.length_between(own.s_from, own.s_to)).sum();
    let key = lane.key();
    assert!(
        (driven - limit).abs() < 1e-7 * (1.0 + 2.0 * limit),
        "{context} {key}: {driven}, not {limit}"
    );
    assert!(limit > 0.0 || own.clone().all(|own| own.s_from == own.s_to), "{context} {key}");
}

#[test]
fn lengths_are_those_of_many_chords() {
    for path in carried_and(&MAPS) {
        let snapshot = open(&path);
        let map = snapshot.map();
        for lane in map.lanes().filter(|lane| lane.number() != 0) {
            let parts = cuts(&lane);
            let parts = parts.windows(2).map(|pair| by_chords(&lane, pair[0], pair[1]));
            let [sum, doubt] =
                parts.fold([0.0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
            let tolerance = TOLERANCE + doubt + CORNER * sum;
            let context = path.display().to_string();
            check(map, &lane, sum, tolerance, &context);
            if lane.nodes().next().is_some() {
                check_reach(map, &lane, 0.0, &context);
                check_reach(map, &lane, 0.37 * lane.length_between(0.0, f64::MAX), &context);
            }
        }
    }
}

/// A road with a lane beside it.
struct Beside {
    shape: &'static str,
    length: f64,
    /// Lane offset and superelevation.
    offset: &'static str,
    roll: &'static str,
    width: &'static str,
    expected: f64,
}

/// A turn of 8.115 m (by mpmath), to be written with any length.
const TURN: &str = "<paramPoly3 aU=\"0\" bU=\"12\" cU=\"-10\" dU=\"0\" aV=\"0\" bV=\"0\" cV=\"5\" dV=\"0\" pRange=\"normalized\"/>";
const LEVEL: &str = "a=\"0\" b=\"0\" c=\"0\" d=\"0\"";
const LINE: Beside = Beside {
    shape: "<line/>",
    length: 50.0,
    offset: LEVEL,
    roll: LEVEL,
    width: "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"",
    expected: 50.0,
};

/// What was off by up to 3.5 %, where two places per piece of the stored line were looked at. Integrals by mpmath.
#[test]
fn lengths_are_exact() {
    let turn = Beside { shape: TURN, length: 8.115_451_281_390_06, ..LINE };
    let all = [
        LINE,
        // Opens evenly, and closes at s = 30, from where it runs along lane 0.
        Beside {
            width: "a=\"3\" b=\"0.1\" c=\"0\" d=\"0\"",
            expected: 50.0 * 1.0025_f64.sqrt(),
            ..LINE
        },
        Beside {
            width: "a=\"3\" b=\"-0.1\" c=\"0\" d=\"0\"",
            expected: 30.0 * 1.0025_f64.sqrt() + 20.0,
            ..LINE
        },
        // As before, a hand's breadth before the end.
        Beside {
            width: "a=\"4.99\" b=\"-0.1\" c=\"0\" d=\"0\"",
            expected: 49.9 * 1.0025_f64.sqrt() + 0.1,
            ..LINE
        },
        Beside {
            width: "a=\"3\" b=\"0\" c=\"0.006\" d=\"-0.00008\"",
            expected: 50.074_919_831_927_615,
            ..LINE
        },
        Beside {
            roll: "a=\"0\" b=\"0.004\" c=\"0\" d=\"0\"",
            expected: 50.000_016_203_158_63,
            ..LINE
        },
        Beside {
            shape: "<arc curvature=\"0.05\"/>",
            length: 20.0,
            width: "a=\"4\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 22.0,
            ..LINE
        },
        Beside {
            shape: "<spiral curvStart=\"0\" curvEnd=\"0.05\"/>",
            length: 40.0,
            width: "a=\"4\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 42.0,
            ..LINE
        },
        Beside {
            width: "a=\"3.2\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 11.708_310_911_821_95,
            ..turn
        },
        // On the inner side of the bend, without and with a stretch beyond its centre.
        Beside {
            offset: "a=\"2.1\" b=\"0\" c=\"0\" d=\"0\"",
            width: "a=\"3.2\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 6.992_682_646_880_836,
            ..turn
        },
        Beside {
            offset: "a=\"3.2\" b=\"0\" c=\"0\" d=\"0\"",
            width: "a=\"3.2\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 4.843_454_642_125_986,
            ..turn
        },
        // Its length is written as another one.
        Beside {
            length: 8.2,
            width: "a=\"3.2\" b=\"0\" c=\"0\" d=\"0\"",
            expected: 11.708_310_911_821_95,
            ..turn
        },
    ];
    for own in all {
        let Beside { shape, length, offset, roll, width, expected } = own;
        let lanes = section(0.0, "", &wide(-1, "", "", width, ""));
        let text = document(&format!(
            "<road id=\"1\" length=\"{length}\" junction=\"-1\">\n\
             <planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"{length}\">{shape}</geometry></planView>\n\
             <lateralProfile><superelevation s=\"0\" {roll}/></lateralProfile>\n\
             <lanes><laneOffset s=\"0\" {offset}/>\n{lanes}</lanes>\n</road>\n"
        ));
        let snapshot = open_text(&text);
        let map = snapshot.map();
        let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
        let context = format!("{shape} {length} {width} {offset}");
        check(map, &lane, expected, EXACT, &context);
        check_reach(map, &lane, 0.37 * expected, &context);
    }
}

/// A road that is written as longer than its reference line: behind that there is nothing to drive.
#[test]
fn lanes_end_with_the_reference_line() {
    let lanes = section(0.0, "", &lane(-1, ""));
    let line = road("1", "junction=\"-1\"", Line(0.0, 0.0, 0.0, 90.0, 0.0), "", &lanes);
    let longer = line.replacen("length=\"90\"", "length=\"100\"", 1);
    let snapshot = open_text(&document(&longer));
    let map = snapshot.map();
    let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    assert_eq!(lane.section().s_end(), 100.0);
    check(map, &lane, 90.0, 0.0, "a short line");
    assert_eq!(lane.nodes().map(|node| node.length()).sum::<f64>(), 90.0);
}

/// In another frame lengths are those of the lines in that frame.
#[test]
fn lengths_are_those_of_a_maps_own_frame() {
    let crs = Some("utm".parse().expect("a target"));
    let text = std::fs::read_to_string(carried("one_road.xodr")).expect("the map");
    let snapshot = open_text_with(&text, &CompileOptions { crs, ..CompileOptions::default() });
    let map = snapshot.map();
    for lane in map.lanes().filter(|lane| lane.number() != 0) {
        let parts = cuts(&lane);
        let parts = parts.windows(2).map(|pair| by_chords(&lane, pair[0], pair[1]));
        let [sum, doubt] = parts.fold([0.0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
        check(map, &lane, sum, TOLERANCE + doubt, "one road in UTM");
    }
}
