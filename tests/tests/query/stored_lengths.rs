//! Lanes of very many records have their lengths up to some of these stored: lengths along them are the same with and without.

use mapd_archive::{LaneLengthRow, Rows, encode, verify};
use mapd_client::Snapshot;
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::long_lane::{long_lane, many_lanes};
use mapd_tests::maps::Random;

/// Allowed difference of two sums of the same lengths `[m]`, or times `[s]`.
const EXACT: f64 = 1e-9;

/// Lengths between many places of all lanes with and without the stored ones, of which there are so many; they differ by no more than rounding.
fn check(what: &str, text: &str, stored: usize) {
    let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
    let mut compiled = compiled.expect("reading works");
    let mut rows = compiled.rows.take().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let open = |rows: &Rows| {
        let bytes = encode(rows, &compiled.provenance).expect("encodes");
        verify(&bytes).expect("verifies");
        Snapshot::from_bytes(bytes).expect("opens")
    };
    let with = open(&rows);
    assert_eq!(rows.lane_lengths.len(), stored, "{what}");
    rows.lane_lengths = Vec::new().into();
    let without = open(&rows);
    let mut random = Random(0x1e_7465);
    let road = with.map().road_by_id("1").expect("the road");
    let ids = road.section(0).into_iter().flat_map(|section| section.lanes());
    for id in ids.map(|lane| lane.number()) {
        let [lane, plain] = [&with, &without].map(|map| {
            let road = map.map().road_by_id("1").expect("the road");
            road.section(0).and_then(|section| section.lane(id)).expect("the lane")
        });
        let end = lane.section().s_end();
        let at_records = |i: u32| [end * f64::from(i) / 40.0, end * f64::from(i + 3) / 40.0];
        let places =
            (0..300).map(|_| [random.between(-5.0, end + 5.0), random.between(-5.0, end + 5.0)]);
        for [a, b] in places.chain((0..38).map(at_records)).chain([[0.0, end], [end, 0.0]]) {
            let [found, expected] = [&lane, &plain].map(|lane| lane.length_between(a, b));
            assert!(
                (found - expected).abs() <= EXACT,
                "{what}, {id}, {a} to {b}: {found}, not {expected}"
            );
            assert!(expected > 0.0 || a == b || (a.max(b) <= 0.0) || a.min(b) >= end, "{what}");
            let time = lane.time_between(a, b) - plain.time_between(a, b);
            assert!(time.abs() <= EXACT, "{what}, {id}, {a} to {b}: {time}");
        }
        assert!(lane.length_between(f64::NAN, 1.0).is_nan(), "{what}");
    }
}

#[test]
fn stored_lengths_are_those_of_the_records() {
    // Each of three lanes has a record for each geometry; that with widths of its own has another for each of them, but for the first.
    for (geometries, stored) in
        [(1, 0), (32, 0), (33, 3 * 2), (64, 3 * 3), (65, 3 * 4), (400, 3 * 24)]
    {
        check(&format!("{geometries} arcs"), &long_lane(geometries, false), stored);
    }
    for (geometries, stored) in [(16, 0), (17, 2), (40, 2 * 2 + 4), (400, 2 * 24 + 49)] {
        check(&format!("{geometries} arcs with widths"), &long_lane(geometries, true), stored);
    }
}

/// Edges that are added up once for all lanes are those of each lane by itself, also where widths close, and beside borders.
#[test]
fn stored_lengths_are_those_of_many_lanes() {
    for (lanes, records, close, stored) in [
        (1, 40, false, 2 * 2),
        (4, 30, false, 2 * (3 + 5 + 7)),
        (3, 40, true, 31),
        (6, 25, true, 68),
    ] {
        let text = many_lanes(lanes, records, close);
        check(&format!("{lanes} lanes of {records} records"), &text, stored);
    }
}

#[test]
fn damaged_lengths_are_found_and_do_no_harm() {
    let compiled =
        compile(long_lane(100, false).as_bytes(), &CompileOptions::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    let mut rows = compiled.rows.expect("accepted");
    let sound = rows.lane_lengths.to_vec();
    type Damage = fn(&mut [LaneLengthRow]);
    let damages: [(&str, Damage); 4] = [
        ("lanes that fall", |rows| rows.reverse()),
        ("an s twice", |rows| rows[1].s = rows[0].s),
        ("a length that falls", |rows| rows[1].length = 0.0),
        ("a lane that is not there", |rows| rows[1].lane = 77),
    ];
    for (what, damage) in damages {
        let mut stored = sound.clone();
        damage(&mut stored);
        rows.lane_lengths = stored.into();
        let bytes = encode(&rows, &compiled.provenance).expect("encodes");
        let told = verify(&bytes).err().expect(what).to_string();
        assert!(told.contains("lane_lengths"), "{what}: {told}");
        let snapshot = Snapshot::from_bytes(bytes).expect("opens: rows are not looked at");
        for lane in
            snapshot.map().road_by_id("1").expect("a road").section(0).expect("a section").lanes()
        {
            let end = lane.section().s_end();
            for i in 0..100 {
                let (a, b) = (end * f64::from(i) / 100.0, end * f64::from(i * 7 % 100) / 100.0);
                assert!(!lane.length_between(a, b).is_nan(), "{what}");
            }
        }
    }
}
