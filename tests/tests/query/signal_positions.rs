//! Positions and facing of signals across vendors and versions, each worked out by hand from what the file says.
//!
//! On a straight piece from (x₀, y₀) with heading ψ: (x, y) = (x₀ + u·cos ψ − t·sin ψ, y₀ + u·sin ψ + t·cos ψ), u the
//! distance from the piece's start; z = elevation + zOffset; facing = ψ + π + hOffset for `+`, ψ + hOffset for `−` and `none`, and by π more of what
//! would show its back to all of its lanes.

use mapd_archive::{Archive, Header, Rows};
use mapd_compiler::{CompileOptions, ReadOptions, compile, compile_from};
use mapd_query::Map;
use mapd_query::vocabulary::SignalPosition;
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Largest difference of a coordinate `[m]` and of an angle `[rad]`: the digits that the working keeps.
const TOLERANCE: f64 = 1e-6;

/// Map, road, signal id, x, y, z, facing.
type Case = (&'static str, &'static str, &'static str, [f64; 4]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // ψ = 0 from (0, 0): x = s, y = t. `−`: faces along s. `+`: against it.
    ("esmini/straight_500m_signs", "1", "5", [100.0, -3.57, 1.7, 0.0]),
    ("esmini/straight_500m_signs", "1", "6", [200.0, 3.57, 1.7, PI]),
    ("esmini/straight_500m_signs", "1", "10", [500.0, 3.57, 1.7, 0.0]),
    // netconvert: s is rounded to 440.89 and lies beyond the road's end at 440.88896702, where it is put: u = 257.62139946,
    // ψ = −0.12228106 from (215.90800499, 153.3540111), t = −4.8: 215.908005 + 257.621399·0.992533 + 4.8·(−0.121977),
    // 153.354011 + 257.621399·(−0.121977) − 4.8·0.992533; ψ + π.
    ("sumo/adlershof_dlr_netconvert", "871", "32266935_13", [471.020253501, 117.166083286, 5.0, 3.019311593590]),
    // Left-hand traffic, ψ = 3.14159265 from (200, 93.6): 200 − 89.6, 93.6 + 4.8; ψ + π = 2π − 3.6e-9.
    ("sumo/lefthand_netconvert", "54", "C_5", [110.400000017, 98.400000322, 5.0, -3.589793e-9]),
    // VTD, at the road's start: (198.510796 − 8.8·sin ψ, −448.186692 + 8.8·cos ψ), ψ = −1.62167518: sin −0.998706,
    // cos −0.050857; elevation 27.7289118 + 4.5.
    ("Scenic/Issue189", "715", "357", [207.299407915, -448.634232363, 32.2289118, -1.621675179701]),
    // 1.8, ψ = −π from (340, 1000): (340, 1000 + 6.75); elevation 8 + 1.78; ψ + π = 0.
    ("qc-opendrive/positive18", "18", "29", [340.0, 1006.74999991, 9.780000013, 0.0]),
    // 52 m on: 340 − 52, 1000 − 4.75; elevation 6.88625 + 1.78.
    ("qc-opendrive/positive18", "18", "27", [288.0, 995.24999991, 8.666250013, -PI]),
    // RoadRunner (CARLA), ψ = 3.1410614169: 384.589996 − 35.840466·0.99999986 + 4.479790·0.000531; zOffset below the road. It is for lanes that travel along ψ, to which
    // its face would show its back: turned by π.
    ("ad_map_access/Town01", "0", "362", [348.751914641, 4.478828902, -0.699043274, -0.000531272133]),
    // `+` with hOffset −π: ψ + π − π.
    ("ad_map_access/Town01", "1", "360", [323.478085359, -4.979828947, -0.546643287, 3.141061567901]),
    // u = 16.141312, ψ = −1.85185802: sin −0.960753, cos −0.277395; elevation −1.930353 + 6.963968; ψ + π.
    ("Scenic/borregasave", "0", "44", [5.975840671, -7.822042432, 5.033614635, 1.289734633761]),
    // ψ = 5π/4 from (−7.071068, −7.071068): −7.071068 − 0.1·0.707107 + 5.6·0.707107, −7.071068 − 0.070711 − 3.959798.
    ("maliput_malidrive/Crossing8Course", "514", "40", [-3.181980943, -11.101577477, 0.0, -2.356194596274]),
    // VTD writes hOffset far beyond a turn: π/2 + 43.8077642 − 14π = 1.3962634.
    ("esmini/multi_intersections", "196", "293", [284.7, 11.0, 3.0, 1.396263401599]),
    // 1.8 board: ψ = −1.43636932 from (133.098044, 145.007854), u = 4, t = 1; elevation 0.9 + 5.
    ("qc-opendrive/rule_341_road_signal_boards_multi_board_have_sub_boards_valid", "82", "534", [134.625112701, 141.177963423, 5.9, 1.705223331108]),
    // ψ = 6.9356 from (136.0431, −132.298), u = 3.9174, t = −4.7039; facing 6.9356 − 2π.
    ("ivsg/scenario1_3_WithObjects_WithSigns", "0", "1", [142.011715258, -133.657532959, 0.0, 0.652414692820]),
    // RoadRunner 1.4: ψ = 3.13291942, u = 30.743148, t = −4.170162; ψ + 0.00867328 + π, turned as above.
    ("Scenic/Town07", "1", "983", [-188.973728146, -45.869999616, 2.359866156, 4.3473e-8]),
];

fn rows(open: impl FnMut() -> std::io::Result<Box<dyn std::io::Read + Send>>) -> Rows {
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
    compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics))
}

fn view(rows: &Rows) -> Archive<'_> {
    Archive { header: Header::default(), tables: rows.as_tables() }
}

fn check(map: Map<'_>, road: &str, id: &str, expected: [f64; 4]) {
    let mut of = map.signals().filter(|s| s.id() == id && s.road().is_some_and(|r| r.id() == road));
    let signal = of.next().unwrap_or_else(|| panic!("road {road} has no signal {id}"));
    let found = signal.position().extend(signal.facing()).to_array();
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        let mut difference = found - expected;
        if i == 3 {
            difference = mapd_geometry::normalize_angle(difference);
        }
        assert!(difference.abs() < TOLERANCE, "road {road} signal {id}: {found} for {expected}");
    }
}

#[test]
fn signals_of_many_vendors_stand_where_worked_out() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    for case in CASES.chunk_by(|a, b| a.0 == b.0) {
        let (_, path) = corpus.iter().find(|(name, _)| name == case[0].0).expect("a map");
        let rows = rows(|| Ok(Box::new(std::fs::File::open(path)?)));
        let archive = view(&rows);
        for (_, road, id, expected) in case {
            check(Map::new(&archive, 0), road, id, *expected);
        }
    }
}

const BASE: &str = "zOffset=\"2\" dynamic=\"no\" country=\"DE\" type=\"206\" subtype=\"-1\"";

/// A road to the north from (100, 50), and one to the east from (0, 0), with these signals on the first.
fn own(signals: &str) -> Rows {
    let lanes = section(0.0, &lane(1, ""), &lane(-1, ""));
    let north = road("n", "junction=\"-1\"", Line(100.0, 50.0, FRAC_PI_2, 40.0, 0.0), "", &lanes);
    let east = road("e", "junction=\"-1\"", Line(0.0, 0.0, 0.0, 40.0, 0.0), "", &lanes);
    let with = north.replace("</road>", &format!("<signals>{signals}</signals></road>"));
    let text = document(&(with + &east)).into_bytes();
    rows(move || Ok(Box::new(std::io::Cursor::new(text.clone()))))
}

#[test]
fn physical_positions_and_boards() {
    let rows = own(&format!(
        "<signal id=\"i\" s=\"10\" t=\"-2\" orientation=\"+\" {BASE}><positionInertial x=\"7\" y=\"8\" z=\"9\" hdg=\"-1\" pitch=\"0.1\" roll=\"0.2\"/></signal>\
         <signal id=\"r\" s=\"10\" t=\"-2\" orientation=\"-\" {BASE}><positionRoad roadId=\"e\" s=\"5\" t=\"-3\" zOffset=\"4\" hOffset=\"0.5\"/></signal>\
         <signal id=\"b\" s=\"10\" t=\"-2\" orientation=\"+\" {BASE}><staticBoard><sign id=\"w\" v=\"1.5\" z=\"0.5\" orientation=\"+\" dynamic=\"no\" country=\"DE\" type=\"274\" subtype=\"55\"/></staticBoard></signal>"
    ));
    let archive = view(&rows);
    let map = Map::new(&archive, 0);
    check(map, "n", "i", [7.0, 8.0, 9.0, -1.0]);
    check(map, "n", "r", [5.0, -3.0, 4.0, 0.5]);
    // On the road: (100 + 2, 50 + 10, 2), facing south. Its left is east: the sign hangs 1.5 m to the east, 0.5 m higher.
    check(map, "n", "b", [102.0, 60.0, 2.0, -FRAC_PI_2]);
    check(map, "n", "w", [103.5, 60.0, 2.5, -FRAC_PI_2]);
    let sources = ["i", "r", "b"].map(|id| map.signal_by_id(id).expect("known").position_source());
    assert_eq!(sources, [SignalPosition::Inertial, SignalPosition::Road, SignalPosition::Track]);
    let signal = map.signal_by_id("i").expect("known");
    assert_eq!((signal.pitch(), signal.roll()), (0.1, 0.2));
    let sign = map.signal_by_id("w").expect("known");
    assert_eq!(sign.carrier().map(|carrier| carrier.id()), Some("b"));
    assert!((sign.value().expect("a speed") - 50.0 / 3.6).abs() < 1e-12);
    // They count on the lanes of their own road, whatever stands elsewhere.
    for place in map.signal_places() {
        assert_eq!(place.road().map(|road| road.id()), Some("n"));
        let numbers: Vec<i32> =
            place.lanes().filter_map(|one| Some(one.lane()?.number())).collect();
        assert_eq!(numbers.len(), 1, "{numbers:?}");
    }
}

/// What would show its back to all of its lanes is turned round, with a finding; what faces one of them, or looks aside, stays as it is written.
#[test]
fn signals_face_their_traffic() {
    const BEYOND: &str = "<signalReference id=\"x\" s=\"0\" t=\"0\" orientation=\"-\"><validity fromLane=\"-1\" toLane=\"-1\"/></signalReference>";
    let right_hand = section(0.0, &lane(1, ""), &lane(-1, ""));
    let two_way = right_hand.replace("id=\"-1\"", "id=\"-1\" direction=\"both\"");
    let walks = right_hand.replace("type=\"driving\"", "type=\"walking\"");
    let check =
        |sections: &str, rule: &str, written: &str, beyond: &str, facing: f64, turned: usize| {
            // To the north; the reference is on a road that goes on to the north-east.
            let line = Line(0.0, 0.0, FRAC_PI_2, 40.0, 0.0);
            let further = Line(0.0, 40.0, 1.2, 40.0, 0.0);
            let attributes = format!("junction=\"-1\" rule=\"{rule}\"");
            let ends = |text: String, signals: &str| {
                text.replace("</road>", &format!("<signals>{signals}</signals></road>"))
            };
            let validity = match beyond {
                "" => String::new(),
                _ => "<validity fromLane=\"0\" toLane=\"0\"/>".to_owned(),
            };
            let signal =
                format!("<signal id=\"x\" s=\"30\" t=\"-4\" {written} {BASE}>{validity}</signal>");
            let text = ends(road("1", &attributes, line, "", sections), &signal)
                + &ends(road("2", &attributes, further, "", sections), beyond);
            let text = document(&text);
            let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
            let compiled = compiled.expect("reading works");
            let told = compiled.diagnostics.iter();
            let told = told.filter(|d| d.finding.rule == "mapd:compile.signal_facing").count();
            let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
            let archive = view(&rows);
            let found = Map::new(&archive, 0).signal_by_id("x").expect("known").facing();
            let difference = mapd_geometry::normalize_angle(found - facing);
            assert!(
                difference.abs() < TOLERANCE,
                "{rule} {written} {beyond}: {found} for {facing}"
            );
            assert_eq!(told, turned, "{rule} {written} {beyond}");
        };
    let (north, south) = (FRAC_PI_2, -FRAC_PI_2);
    for rule in ["RHT", "LHT"] {
        let own = |written: &str, facing, turned| {
            check(&right_hand, rule, written, "", facing, turned);
        };
        own("orientation=\"+\"", south, 0);
        own("orientation=\"-\"", north, 0);
        own("orientation=\"+\" hOffset=\"3.141592653589793\"", south, 1);
        own("orientation=\"-\" hOffset=\"3.141592653589793\"", north, 1);
        // By 40°, and by 50°.
        own(
            "orientation=\"+\" hOffset=\"-2.44346095279206\"",
            south + FRAC_PI_4 - 0.087266462599716,
            1,
        );
        own("orientation=\"+\" hOffset=\"-2.26892802759263\"", north + 0.872664625997165, 0);
        // For both ways.
        own("orientation=\"none\"", north, 0);
        // RoadRunner's form, with and without the turn by half.
        let of_right = if rule == "RHT" { 1 } else { 0 };
        let back = if rule == "RHT" { south } else { north };
        check(&right_hand, rule, "orientation=\"-\"", BEYOND, back, of_right);
        check(
            &right_hand,
            rule,
            "orientation=\"+\"",
            BEYOND,
            [north, south][of_right],
            1 - of_right,
        );
        // A lane of both directions, and one that nobody drives on.
        let turned = "orientation=\"+\" hOffset=\"3.141592653589793\"";
        check(
            &two_way.replace("id=\"1\"", "id=\"1\" direction=\"both\""),
            rule,
            turned,
            "",
            north,
            0,
        );
        check(&walks, rule, turned, "", north, 0);
    }
}
