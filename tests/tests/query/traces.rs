//! Traces: the lanes of drives that were simulated with noise, where a trace leaves the map, and what is refused.

use mapd_client::glam::DVec2;
use mapd_client::localisation::{MatchError, TraceFix, TraceMatch, TraceOptions, TraceScratch};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::{carried, drives, maps};
use std::f64::consts::PI;

/// Shares of right lanes on the carried town: at least `whole`, and better than the nearest lanes by `more`.
fn check_accuracy(noise: f64, every: usize, whole: f64, more: f64) {
    let snapshot = maps::open(&carried("town.xodr"));
    let [found, nearest] = drives::accuracy(snapshot.map(), noise, every, 3);
    assert!(found >= whole, "{noise} m, every {every}: {found}");
    assert!(found >= nearest + more, "{noise} m, every {every}: {found}, nearest lane {nearest}");
}

#[test]
fn whole_traces_find_more_lanes_than_the_nearest_does() {
    check_accuracy(0.3, 10, 0.9, 0.02);
    check_accuracy(1.0, 10, 0.9, 0.05);
    check_accuracy(5.0, 10, 0.7, 0.2);
    // Ten seconds and several corners from fix to fix.
    check_accuracy(0.3, 100, 0.9, 0.0);
    check_accuracy(5.0, 100, 0.6, 0.1);
}

fn fix(time: f64, x: f64, y: f64) -> TraceFix {
    TraceFix { time, position: DVec2::new(x, y).into(), heading: None }
}

fn on_one_road(fixes: &[TraceFix], options: &TraceOptions) -> Result<Vec<TraceMatch>, MatchError> {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let mut out = Vec::new();
    snapshot.map().match_trace(fixes, options, &mut TraceScratch::default(), &mut out)?;
    Ok(out)
}

/// Lane −1 runs along x; from the fourth fix on the trace leaves the road to the side.
#[test]
fn where_a_trace_leaves_the_map_it_is_on_no_lane() {
    let ys = [-1.7, -1.8, -1.6, -30.0, -60.0, -30.0, -1.7, -1.8];
    let fixes: Vec<_> =
        ys.iter().zip(0u8..).map(|(y, i)| fix(i.into(), 6.0 * f64::from(i), *y)).collect();
    let out = on_one_road(&fixes, &TraceOptions::default()).expect("an answer");
    let on_lane: Vec<bool> = out.iter().map(|one| one.place.is_some()).collect();
    assert_eq!(on_lane, [true, true, true, false, false, false, true, true]);
    for one in &out {
        assert!(one.probability > 0.5 && one.probability <= 1.0, "{one:?}");
        assert!(
            one.place.is_none_or(|at| one.forward && at.position.offset.abs() < 0.2),
            "{one:?}"
        );
    }
    assert_eq!(on_one_road(&[], &TraceOptions::default()), Ok(vec![]));
}

/// Without a heading the order of the fixes says which way the vehicle goes.
#[test]
fn the_way_a_trace_goes_tells_lanes_apart() {
    for (speed, forward) in [(8.0, true), (-8.0, false)] {
        // In the middle between both ways.
        let fixes: Vec<_> =
            (0u8..8).map(|i| fix(i.into(), 30.0 + speed * (f64::from(i) - 3.5), 0.0)).collect();
        let out = on_one_road(&fixes, &TraceOptions::default()).expect("an answer");
        assert!(out.iter().all(|one| one.place.is_some() && one.forward == forward), "{out:?}");
    }
}

/// Fixes of simulated drives without those of a minute, or half: before and behind, lanes are found as they are of whole traces.
#[test]
fn a_gap_breaks_no_trace() {
    let snapshot = maps::open(&carried("town.xodr"));
    let (map, options) =
        (snapshot.map(), TraceOptions { deviation: 1.0, ..TraceOptions::default() });
    let (mut scratch, mut out) = (TraceScratch::default(), Vec::new());
    for missing in [30, 60, 90] {
        let (mut right, mut all) = (0, 0);
        for seed in 1..=6 {
            let random = &mut maps::Random(seed * 7919);
            let truth = drives::drive(map, 120.0, random);
            let mut fixes = drives::receive(&truth, 10, 1.0, random);
            let mut lanes: Vec<_> = truth.iter().step_by(10).map(|place| place.lane).collect();
            let gap = 15..(15 + missing).min(fixes.len());
            if gap.len() < missing {
                continue;
            }
            fixes.drain(gap.clone());
            lanes.drain(gap);
            map.match_trace(&fixes, &options, &mut scratch, &mut out).expect("an answer");
            for (found, lane) in out.iter().zip(&lanes) {
                all += 1;
                right += usize::from(found.place.is_some_and(|place| place.lane == *lane));
            }
        }
        assert!(all > 60 && right * 100 >= 93 * all, "{missing} s missing: {right} of {all}");
    }
}

/// A minute beside the map, with fixes and without: on no lane meanwhile, and on one at once when it is back.
#[test]
fn a_trace_that_comes_back_is_on_its_lane_again() {
    let there = [(0.0, 5.0, -1.7), (1.0, 13.0, -1.8), (2.0, 21.0, -1.7)];
    let away = (0..30u8).map(|i| (3.0 + 2.0 * f64::from(i), 25.0, -40.0 - f64::from(i)));
    let back = [(65.0, 40.0, -1.7), (66.0, 48.0, -1.9), (67.0, 55.0, -1.7)];
    let fixes: Vec<_> =
        there.into_iter().chain(away).chain(back).map(|(t, x, y)| fix(t, x, y)).collect();
    let out = on_one_road(&fixes, &TraceOptions::default()).expect("an answer");
    let on_lane: Vec<bool> = out.iter().map(|one| one.place.is_some()).collect();
    assert_eq!(on_lane, [vec![true; 3], vec![false; 30], vec![true; 3]].concat());
    assert!(out.iter().filter(|one| one.place.is_some()).all(|one| one.forward), "{out:?}");
}

/// Out in lane −1, and back in lane 1 without a place to turn on.
#[test]
fn a_turn_on_the_spot_is_one() {
    let out_way = (0..6u8).map(|i| (f64::from(i), 8.0 * f64::from(i), -1.7, 0.0));
    let back = (0..6u8).map(|i| (8.0 + f64::from(i), 40.0 - 8.0 * f64::from(i), 1.7, PI));
    for with_heading in [true, false] {
        let fixes: Vec<_> = out_way
            .clone()
            .chain(back.clone())
            .map(|(time, x, y, heading)| TraceFix {
                heading: with_heading.then_some(heading),
                ..fix(time, x, y)
            })
            .collect();
        let out = on_one_road(&fixes, &TraceOptions::default()).expect("an answer");
        let ways: Vec<Option<bool>> =
            out.iter().map(|one| one.place.map(|_| one.forward)).collect();
        assert_eq!(
            ways,
            [vec![Some(true); 6], vec![Some(false); 6]].concat(),
            "heading {with_heading}"
        );
    }
}

/// From lane −2 to lane −1 over a broken line: once, when it crosses the line, and not to and fro.
#[test]
fn a_change_of_lane_is_one() {
    let sections = section(0.0, "", &(lane(-1, "") + &lane(-2, "")));
    let line = Line(0.0, 0.0, 0.0, 300.0, 0.0);
    let snapshot = maps::open_text(&document(&road("a", "", line, "", &sections)));
    let random = &mut maps::Random(5);
    let fixes: Vec<_> = (0..24u8)
        .map(|i| {
            let share = mapd_geometry::clamp((f64::from(i) - 10.0) / 4.0, 0.0, 1.0);
            let noise = DVec2::new(drives::normal(random), drives::normal(random)) * 0.3;
            fix(f64::from(i), 5.0 + 12.0 * f64::from(i) + noise.x, -5.25 + 3.5 * share + noise.y)
        })
        .collect();
    let options = TraceOptions { deviation: 0.3, ..TraceOptions::default() };
    let mut out = Vec::new();
    snapshot
        .map()
        .match_trace(&fixes, &options, &mut TraceScratch::default(), &mut out)
        .expect("an answer");
    let number = |one: &TraceMatch| {
        snapshot.map().lane(one.place.expect("a lane").lane).expect("a lane").number()
    };
    let numbers: Vec<i32> = out.iter().map(number).collect();
    let changed = numbers.iter().position(|number| *number == -1).expect("a change");
    assert!((11..=13).contains(&changed), "{numbers:?}");
    assert!(numbers[changed..].iter().all(|number| *number == -1), "{numbers:?}");
}

/// A vehicle that waits, fixes at one time, and two that are alike: no step is too short.
#[test]
fn times_and_places_that_stand_still_are_fine() {
    let check = |fixes: &[TraceFix]| {
        let out = on_one_road(fixes, &TraceOptions::default()).expect("an answer");
        assert!(
            out.iter().all(|one| one.place.is_some() && one.probability > 0.9 && one.forward),
            "{out:?}"
        );
    };
    let moving: Vec<_> = (0..4u8).map(|i| fix(f64::from(i), 8.0 * f64::from(i), -1.7)).collect();
    // A minute at one place.
    let waits: Vec<_> = (0..60u8).map(|i| fix(4.0 + f64::from(i), 32.0, -1.7)).collect();
    check(&[moving.clone(), waits].concat());
    // All at one time, each fix twice.
    check(&moving.iter().map(|one| TraceFix { time: 3.0, ..*one }).collect::<Vec<_>>());
    check(&moving.iter().flat_map(|one| [*one, *one]).collect::<Vec<_>>());
    // One fix, and the same again.
    let heading = TraceFix { heading: Some(0.0), ..moving[1] };
    check(&[heading]);
    check(&[heading, heading]);
}

#[test]
fn what_is_wrong_with_a_trace_is_named() {
    let good = TraceOptions::default();
    let check = |fixes: &[TraceFix], options: &TraceOptions, expected| {
        assert_eq!(on_one_road(fixes, options), Err(expected));
    };
    check(&[fix(0.0, 1.0, 1.0), fix(1.0, f64::NAN, 1.0)], &good, MatchError::Fix(1));
    check(&[fix(0.0, 1.0, 1.0), fix(-1.0, 1.0, 1.0)], &good, MatchError::Time(1));
    let none = TraceOptions { deviation: 0.0, ..good };
    check(&[], &none, MatchError::Option("deviation"));
}
