//! Answers on simulated drives: beside the best that is possible, where there is no doubt, and whether probabilities are what they say.

use mapd_tests::drives::{self, Judgement, Score};
use mapd_tests::{carried, maps, shared};
use std::path::Path;

/// Standard deviations of places `[m]` and headings `[rad]`; one fix a second.
const NOISE: [f64; 2] = [0.3, 0.05];
const EVERY: usize = 10;
/// Drivers are off the middle of their lane by so much `[m]`, and off its direction by what the model assumes `[rad]`.
const WANDER: drives::Wander = [0.3, 0.1];
/// Share of wrong lanes, as a multiple of what is unavoidable.
const NEAR_BEST: f64 = 1.1;
/// Share of wrong lanes where the centre lines of all others are more than 1.2 m away.
const APART: f64 = 0.01;
/// By how much a stated probability may differ from the share of true lanes, in bins with enough hypotheses.
const CALIBRATED: f64 = 0.05;
const ENOUGH: f64 = 200.0;

/// Drives on a map: what each kind of answer must keep to.
fn check(path: &Path, drives: u64) -> Judgement {
    let snapshot = maps::open(path);
    let judged = drives::judge(snapshot.map(), NOISE, EVERY, WANDER, drives);
    let name = path.display();
    let (best, known) = (judged.bayes.wrong(), judged.last_lane.wrong());
    assert!(best > 0.0 && known <= NEAR_BEST * best, "{name}: {known} wrong, unavoidable {best}");
    for (kind, score) in [("pose", &judged.pose), ("tracker", &judged.tracker)] {
        let wrong = score.wrong_apart();
        assert!(score.all_apart > 1000.0 && wrong < APART, "{name}, {kind}: {wrong} wrong apart");
    }
    judged
}

fn check_bins(what: &str, score: &Score, allowed: f64) {
    let judged = score.bins.iter().filter(|bin| bin[0] >= ENOUGH).count();
    assert!(judged >= 4, "{what}: only {judged} bins have enough hypotheses");
    let worst = score.worst_bin(ENOUGH);
    assert!(worst <= allowed, "{what}: off by {worst} in {:?}", score.bins);
}

#[test]
fn answers_on_the_town_are_as_good_as_can_be_and_say_how_sure_they_are() {
    let judged = check(&carried("town.xodr"), 150);
    check_bins("pose", &judged.pose, CALIBRATED);
    // On this map of few junctions the filter is too sure of what it holds to be as likely as not.
    check_bins("tracker", &judged.tracker, 2.0 * CALIBRATED);
}

#[test]
fn answers_on_real_maps_are_as_good_as_can_be_and_say_how_sure_they_are() {
    let Some(folder) = shared("maps") else { return };
    let (mut pose, mut tracker) = (Score::default(), Score::default());
    for name in ["carla/Town05", "carla/Town03"] {
        let judged = check(&folder.join(format!("{name}.xodr")), 50);
        pose.add(&judged.pose);
        tracker.add(&judged.tracker);
    }
    check_bins("pose", &pose, CALIBRATED);
    check_bins("tracker", &tracker, CALIBRATED);
}
