//! Every lane that meets a path is told: those that another way of asking finds.

use crate::path_complete::{MAPS, PAIRS};
use crate::path_meets::lane_by;
use crate::paths::each_path_of;
use mapd_client::{Lane, LaneId, Map, NearestOptions};
use mapd_query::path::{Path, PathBuffer, PathLane, PathOptions, steps_of_lanes};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{carried_and, found, open_text};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

/// Lengths and places may differ by this `[m]`.
const ROUNDING: f64 = 1e-6;

/// Asks for every lane that conflicts with one of a path within a junction, every one that leads into the path's own, and every one of another road that holds the
/// driven line for 3 m; how many there are of each.
fn all_met(map: Map<'_>, path: &Path<'_, '_>, name: &str) -> [usize; 3] {
    let options =
        NearestOptions { radius: 0.0, z_tolerance: Some(1.5), ..NearestOptions::default() };
    let (mut together, mut conflicts, mut held) = (Vec::new(), Vec::new(), Vec::new());
    path.conflicts(&mut together, &mut conflicts);
    let driven: Vec<PathLane> = path.lanes().collect();
    let is_driven = |lane: LaneId| driven.iter().any(|own| own.lane == lane);
    let open = |lane: &Lane<'_>| lane.nodes().any(|node| node.is_open());
    let mut all = [0; 3];
    for (number, own) in driven.iter().enumerate() {
        let lane = map.lane(own.lane).expect("a lane");
        let told = |other: LaneId, along: f64| {
            let [from, to] = [along - 2.0, along + 2.0];
            conflicts
                .iter()
                .any(|one| one.other == other && one.along[0] <= to && one.along[1] >= from)
        };
        for conflict in lane.conflicts() {
            let (other, range) = (conflict.other().expect("a lane"), conflict.s_range());
            let [low, high] = [own.s[0].min(own.s[1]), own.s[0].max(own.s[1])];
            if is_driven(other.lane_id()) || range.high < low || range.low > high {
                continue;
            }
            let within = |one: &&mapd_query::path::ConflictLane| {
                one.other == other.lane_id()
                    && one.along[0] <= own.along[1] + ROUNDING
                    && one.along[1] >= own.along[0] - ROUNDING
            };
            assert!(conflicts.iter().any(|one| within(&one)), "{name}: {}", other.key());
            all[0] += 1;
        }
        let section = lane.section();
        let entry = if own.forward { section.s_start() } else { section.s_end() };
        if number > 0 && own.s[0] == entry {
            for id in lane.predecessors_towards(own.forward) {
                let other = map.lane(id).expect("a lane");
                if !is_driven(id) && open(&other) {
                    assert!(told(id, own.along[0]), "{name}: {} into {}", other.key(), lane.key());
                    all[1] += 1;
                }
            }
        }
    }
    // Lanes that hold the last places on one lane of the path, and how many in a row.
    let mut rows: BTreeMap<LaneId, (LaneId, u32)> = BTreeMap::new();
    let mut along = 0.5;
    while along < path.length().min(1_000.0) {
        let at = path.at(along).expect("a place");
        let lane = map.lane(at.lane).expect("a lane");
        let junction = |lane: &Lane<'_>| lane.road().junction().map(|one| one.junction_id());
        map.lanes_near(at.position, &options, &mut held).expect("an answer");
        let mut next = BTreeMap::new();
        for hit in &held {
            let other = map.lane(hit.lane).expect("a lane");
            let linked = |id| id == hit.lane;
            if other.road().road_id() == lane.road().road_id()
                || is_driven(hit.lane)
                || (junction(&lane).is_some() && junction(&other) == junction(&lane))
                || lane.successors_towards(at.forward).any(linked)
                || lane.predecessors_towards(at.forward).any(linked)
                || !open(&other)
            {
                continue;
            }
            let before = rows.get(&hit.lane).filter(|row| row.0 == at.lane).map_or(0, |row| row.1);
            next.insert(hit.lane, (at.lane, before + 1));
            if before + 1 >= 7 {
                let told = conflicts.iter().any(|one| {
                    one.other == hit.lane && one.along[0] <= along && along - 3.0 <= one.along[1]
                });
                assert!(told, "{name}: {} at {along}", other.key());
                all[2] += 1;
            }
        }
        rows = next;
        along += 0.5;
    }
    all
}

#[test]
fn all_lanes_that_meet_a_path_are_told() {
    let counts = RefCell::new([0usize; 3]);
    let mut files = carried_and(&MAPS);
    files.extend(found("maps/WBeaverAve.xodr"));
    each_path_of(files, PAIRS, &PathOptions::default(), |map, path, _, name, _| {
        let own = all_met(map, path, name);
        counts.borrow_mut().iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    });
    let [inside, merging, _] = counts.into_inner();
    assert!(inside > 0 && merging > 0, "{inside}, {merging}");
    // Roads that cross without a junction, of which the others hold 3.5 and 7 m of the driven line.
    let plain = "junction=\"-1\"";
    let one = section(0.0, "", &lane(-1, ""));
    let two = section(0.0, &lane(1, ""), &lane(-1, ""));
    let across = |id: &str, x: f64, lanes: &str| {
        road(id, plain, Line(x, -50.0, FRAC_PI_2, 100.0, 0.0), "", lanes)
    };
    let own = road("1", plain, Line(0.0, 0.0, 0.0, 200.0, 0.0), "", &one);
    let text = document(&(own + &across("2", 50.0, &one) + &across("3", 120.0, &two)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let lanes = [lane_by(map, "1:0:-1").lane_id()];
    steps_of_lanes(map, &lanes, [0.0, 200.0], &mut steps).expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    assert_eq!(all_met(map, &path, "crossing roads")[..2], [0, 0]);
    assert!(all_met(map, &path, "crossing roads")[2] >= 3);
}
