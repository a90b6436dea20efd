//! Traces: the lanes of drives that were simulated with noise, where a trace leaves the map, and what is refused.

use mapd_client::glam::DVec2;
use mapd_client::localisation::{MatchError, TraceFix, TraceMatch, TraceOptions, TraceScratch};
use mapd_tests::{carried, drives, maps};

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
