//! Damaged archives: typed errors or merely wrong answers, never a panic or a read outside.

use mapd_archive::{AlignedBytes, HEADER_LENGTH, OpenError, VerifyError, encode, open, verify};
use mapd_client::{NearestOptions, Snapshot, Track, glam::DVec2};
use mapd_compiler::{CompileOptions, compile};

fn archive(name: &str) -> AlignedBytes {
    let file = std::fs::File::open(mapd_tests::carried(name)).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
}

/// Asks everything of a map that may be damaged; only the absence of a panic counts.
fn ask_everything(bytes: AlignedBytes) {
    let Ok(snapshot) = Snapshot::from_bytes(bytes) else { return };
    let map = snapshot.map();
    for x in [-5.0, 20.0, 120.0] {
        let _ = map.nearest_lane(DVec2::new(x, 1.0), &NearestOptions::default());
    }
    for road in map.roads() {
        let _ = (
            road.id(),
            road.name(),
            road.junction().map(|j| j.id()),
            road.predecessor(),
            road.successor(),
        );
        let _ = road.to_inertial(Track { s: 10.0, t: 1.0, h: 0.0 });
        let _ = road.to_track(DVec2::new(3.0, 4.0));
        let _ = (road.section_at(5.0).map(|s| s.lane_at(5.0, 1.0).is_some()), road.types().count());
    }
    for lane in map.lanes() {
        let _ = (
            lane.key().to_string(),
            lane.left_bound().positions().count(),
            lane.right_bound().len(),
        );
        let _ = (
            lane.successors().count(),
            lane.left().is_some(),
            lane.right().is_some(),
            lane.speeds().count(),
        );
        let _ = lane.pose_at(1.0, 0.0);
    }
    for junction in map.junctions() {
        let _ = junction.connections().map(|c| c.lane_links().count()).sum::<usize>();
    }
    let _ = map.road_by_id("1");
    let _ = snapshot.verify();
}

#[test]
fn every_flipped_byte_of_the_header_is_an_error() {
    let good = archive("one_road.xodr");
    for at in 0..HEADER_LENGTH {
        for bit in 0..8 {
            let mut bad = good.clone();
            bad[at] ^= 1 << bit;
            assert!(open(&bad).is_err(), "byte {at} bit {bit} of the header does not matter");
        }
    }
}

#[test]
fn every_truncation_is_an_error() {
    let good = archive("one_road.xodr");
    for length in 0..good.len() {
        let error = open(&good[..length]).err().expect("a cut archive is refused");
        assert!(
            matches!(error, OpenError::TooShort { .. } | OpenError::Length { .. }),
            "{length}: {error}"
        );
    }
}

#[test]
fn verify_finds_every_flip_and_queries_survive_it() {
    let good = archive("one_road.xodr");
    for at in (HEADER_LENGTH..good.len()).step_by(7) {
        let mut bad = good.clone();
        bad[at] ^= 0x55;
        let error = verify(&bad).err().unwrap_or_else(|| panic!("a flip at {at} is not found"));
        assert!(
            matches!(error, VerifyError::ContentHash { .. } | VerifyError::Open(_)),
            "{at}: {error}"
        );
        ask_everything(bad);
    }
    // The table of contents lies at the end: every byte of it, every value that is likely to hurt.
    for at in good.len() - 700..good.len() {
        for value in [0, 1, 0x7f, 0x80, 0xff] {
            let mut bad = good.clone();
            bad[at] = value;
            ask_everything(bad);
        }
    }
}

#[test]
fn other_files_are_refused_by_name() {
    let mut aligned = AlignedBytes::new();
    aligned.extend_from_slice(&[b'x'; 300]);
    assert!(matches!(open(&aligned).err(), Some(OpenError::NotAnArchive { .. })));
    let good = archive("one_road.xodr");
    let mut shifted = AlignedBytes::new();
    shifted.push(0);
    shifted.extend_from_slice(&good);
    assert!(matches!(open(&shifted[1..]).err(), Some(OpenError::Alignment { .. })));
}
