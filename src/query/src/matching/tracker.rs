//! The lane of a vehicle that drives, from fix to fix: a filter whose hypotheses are lanes, moved along the lane graph.
//!
//! Each fix has two parts. Between fixes the probability of each lane spreads over the graph as far as was driven (`spread`); some
//! of it goes to `none`, and a little anywhere, for maps have gaps and fixes are wrong. Then each lane's is multiplied by what the
//! fix says of it, as [`Map::match_pose`] weighs it without its priors, and all are made to add up to 1.

use super::spread::{Drive, MOST_OPEN, Visit, spread};
use super::{LaneMatch, MatchError, MatchOptions, VehiclePose, error, match_at_most};
use crate::ids::LaneId;
use crate::map::Map;
use crate::nearest::LaneTypes;
use crate::route::share_before;
use glam::{DMat3, DVec2};
use mapd_archive::NONE;

/// Hypotheses that are kept, the most probable ones.
const MOST_HYPOTHESES: usize = 32;
/// Lanes that a fix is compared with, the most probable ones by the fix alone.
const MOST_CANDIDATES: usize = 128;
/// Mean difference between the way along the lanes and the way driven `[m]`, of exact fixes.
const DETOUR: f64 = 1.0;
/// The same as a share of the way: of one measured by an odometer, and of the straight way between two fixes.
const ODOMETER_SHARE: f64 = 0.05;
const STRAIGHT_SHARE: f64 = 0.25;
/// An odometer that goes faster has jumped `[m/s]`: no vehicle on a road does. One that is reset does so backwards.
const MOST_SPEED: f64 = 100.0;
/// By how much it may go farther between two fixes at one time `[m]`: it is read at other moments.
const MOST_STEP: f64 = 10.0;
/// Density of places of a vehicle on no lane, where one in a lane has 1: it may be anywhere.
const ANYWHERE: f64 = 0.25;
/// Mean times `[s]` between leaving all lanes; of staying away from them; and between places where the graph or the fixes are wrong.
const LEAVE_INTERVAL: f64 = 300.0;
const RETURN_INTERVAL: f64 = 10.0;
const ERROR_INTERVAL: f64 = 1e3;
/// The share of a short time between fixes that counts at least `[s]`: what may happen between two fixes at once.
const LEAST_TIME: f64 = 1e-3;
/// Hypotheses less probable than this are forgotten.
const LEAST_PROBABILITY: f64 = 1e-9;

/// What is known of a vehicle at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrackerFix {
    /// When `[s]`; does not fall from fix to fix.
    pub time: f64,
    /// Where it is measured to be.
    pub pose: VehiclePose,
    /// Covariance of (x, y, heading) in `[m²]`, `[m·rad]` and `[rad²]`, as for [`Map::match_pose`].
    pub covariance: DMat3,
    /// Way driven since any beginning `[m]`, if known; it falls while a vehicle reverses. Without one, and where it jumps by more than any vehicle drives, the
    /// straight way from the last fix counts.
    pub odometer: Option<f64>,
}

/// How a running drive is matched.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct TrackerOptions<'a> {
    /// How fixes are weighed. The priors of lanes (`vehicle`, `expected`) weigh the lanes of the first fix, and then the ways at forks. Default that of
    /// [`MatchOptions`] with the types that motor vehicles travel on.
    pub matching: MatchOptions<'a>,
    /// Mean time between changes of lane `[s]`, positive. Default 30.
    pub change_interval: f64,
    /// Time `[s]` over which errors of fixes are alike, not negative: fixes nearer to each other count for less, in proportion. Receivers of
    /// satellites have seconds. Default 0, errors are independent.
    pub correlation_time: f64,
    /// Time without a fix `[s]`, after which the tracker begins anew; positive. Default 30.
    pub memory: f64,
    /// Probability from which a lane, or none, is the answer; in (0, 1]. Default 0.5.
    pub enough: f64,
}

impl Default for TrackerOptions<'_> {
    fn default() -> Self {
        let types = LaneTypes::routable();
        Self {
            matching: MatchOptions { types, ..MatchOptions::default() },
            change_interval: 30.0,
            correlation_time: 0.0,
            memory: 30.0,
            enough: 0.5,
        }
    }
}

impl TrackerOptions<'_> {
    /// Errors: by name, an option out of its domain.
    fn check(&self) -> Result<(), MatchError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let rules = [
            ("change_interval", positive(self.change_interval)),
            ("correlation_time", self.correlation_time >= 0.0 && self.correlation_time.is_finite()),
            ("memory", positive(self.memory)),
            ("enough", self.enough > 0.0 && self.enough <= 1.0),
        ];
        match rules.iter().find(|(_, holds)| !holds) {
            Some((name, _)) => Err(MatchError::Option(name)),
            None => error::check_options(&self.matching),
        }
    }
}

/// Where a tracked vehicle is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Tracked {
    /// In this lane.
    Lane(LaneMatch),
    /// In none, or across them.
    NoLane,
    /// Unknown: no hypothesis is probable enough, or the most probable one cannot have been reached from those of the last fix.
    Unknown,
}

/// The fix before.
#[derive(Clone, Copy, Debug)]
struct Last {
    content: u64,
    time: f64,
    position: DVec2,
    odometer: Option<f64>,
    /// Mean of the variances of x and y `[m²]`.
    variance: f64,
}

/// What is known before a fix of a lane that it may be in.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    node: u32,
    /// Length of the node that lies before the fix `[m]`.
    done: f64,
    probability: f64,
}

/// A running filter over poses: the lanes that a vehicle may be in, each fix by all those before it. All memory is taken by
/// [`Tracker::new`]; no more than 32 hypotheses are kept.
///
/// ```
/// use mapd_query::localisation::{Tracked, Tracker, TrackerFix, TrackerOptions};
///
/// fn lane(map: mapd_query::Map<'_>, tracker: &mut Tracker, fix: &TrackerFix) -> String {
///     match tracker.update(map, fix, &TrackerOptions::default()) {
///         Ok(Tracked::Lane(found)) => format!("{:?} {:.2}", found.lane, found.probability),
///         Ok(Tracked::NoLane) => "on no lane".to_owned(),
///         Ok(Tracked::Unknown) => format!("one of {}", tracker.hypotheses().len()),
///         Err(wrong) => wrong.to_string(),
///     }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Tracker {
    last: Option<Last>,
    hypotheses: Vec<LaneMatch>,
    none: f64,
    candidates: Vec<LaneMatch>,
    arrivals: Vec<Arrival>,
    open: Vec<Visit>,
}

impl Default for Tracker {
    fn default() -> Self {
        Self::new()
    }
}

impl Tracker {
    /// A tracker that has seen nothing.
    pub fn new() -> Self {
        Self {
            last: None,
            hypotheses: Vec::with_capacity(MOST_CANDIDATES),
            none: 1.0,
            candidates: Vec::with_capacity(MOST_CANDIDATES),
            arrivals: Vec::with_capacity(MOST_CANDIDATES),
            open: Vec::with_capacity(MOST_OPEN),
        }
    }

    /// Forgets everything.
    pub fn reset(&mut self) {
        self.last = None;
        self.hypotheses.clear();
        self.none = 1.0;
    }

    /// The lanes that the vehicle may be in, the most probable one first.
    pub fn hypotheses(&self) -> &[LaneMatch] {
        &self.hypotheses
    }

    /// Probability that it is in none, or across them; with those of [`Tracker::hypotheses`] it makes 1.
    pub fn none(&self) -> f64 {
        self.none
    }

    /// Probability that the vehicle is in one of these lanes, such as those of its route: when it has left them, this falls.
    pub fn probability_in(&self, lanes: &[LaneId]) -> f64 {
        let within = self.hypotheses.iter().filter(|found| lanes.contains(&found.lane));
        within.map(|found| found.probability).sum()
    }

    /// Takes the next fix. The first one, one after [`TrackerOptions::memory`] without any, and the first on a map of other content begin anew.
    ///
    /// Errors: what is not finite, by name; a covariance that is not symmetric and positive semi-definite; a time before that of the last fix; options out of
    /// their domain. The tracker stays as it was.
    pub fn update(
        &mut self,
        map: Map<'_>,
        fix: &TrackerFix,
        options: &TrackerOptions<'_>,
    ) -> Result<Tracked, MatchError> {
        options.check()?;
        let parts = [("time", fix.time), ("odometer", fix.odometer.unwrap_or(0.0))];
        if let Some((name, _)) = parts.iter().find(|(_, value)| !value.is_finite()) {
            return Err(MatchError::Pose(name));
        }
        if self.last.is_some_and(|last| fix.time < last.time) {
            return Err(MatchError::Earlier);
        }
        let known = self
            .last
            .filter(|last| last.content == map.content() && fix.time - last.time <= options.memory);
        // Priors hold once: those of the first fix, later those of the ways from fix to fix.
        let seen =
            MatchOptions { vehicle: None, expected: &[], none: ANYWHERE, ..options.matching };
        let matching = if known.is_some() { &seen } else { &options.matching };
        let none = match_at_most(
            map,
            MOST_CANDIDATES,
            &fix.pose,
            &fix.covariance,
            matching,
            &mut self.candidates,
        )?;
        let variance = 0.5 * (fix.covariance.x_axis.x + fix.covariance.y_axis.y);
        let mut is_new = false;
        match known {
            Some(last) => {
                let drive = drive(&last, fix, variance, options);
                self.predict(map, &drive, &options.matching);
                is_new = self.correct(none, fix.time - last.time, options);
            }
            None => self.none = none,
        }
        self.keep();
        self.last = Some(Last {
            content: map.content(),
            time: fix.time,
            position: fix.pose.position.xy,
            odometer: fix.odometer,
            variance,
        });
        Ok(self.answer(is_new, options.enough))
    }

    /// Moves the hypotheses' probability to the lanes that the fix may be in.
    fn predict(&mut self, map: Map<'_>, drive: &Drive, options: &MatchOptions<'_>) {
        self.arrivals.clear();
        for found in &self.candidates {
            let lane = map.lane(found.lane).ok();
            let node = lane.and_then(|lane| lane.node_at(found.position.s, found.forward));
            let done = |node| share_before(&node, found.position.s) * node.length();
            let number = node.map_or(NONE, |node| node.number);
            let done = node.map_or(0.0, done);
            self.arrivals.push(Arrival { node: number, done, probability: 0.0 });
        }
        let arrivals = &mut self.arrivals;
        for from in &self.hypotheses {
            spread(map, from, drive, options, &mut self.open, |visit| {
                for to in arrivals.iter_mut().filter(|to| to.node == visit.node) {
                    let away = (visit.begin + to.done - drive.way).abs();
                    let fits = libm::exp(-away / drive.deviation);
                    to.probability += from.probability * visit.share * fits;
                }
            });
        }
    }

    /// Multiplies by what the fix says; whether the most probable lane cannot have been reached.
    fn correct(&mut self, none: f64, time: f64, options: &TrackerOptions<'_>) -> bool {
        let time = time.max(LEAST_TIME);
        let within = |interval: f64| 1.0 - libm::exp(-time / interval);
        let [left, back, wrong] = [LEAVE_INTERVAL, RETURN_INTERVAL, ERROR_INTERVAL].map(within);
        let counts =
            if options.correlation_time > time { time / options.correlation_time } else { 1.0 };
        let seen = |says: f64| if counts < 1.0 { libm::pow(says, counts) } else { says };
        let on_lanes = 1.0 - self.none;
        let anew = wrong + self.none * back;
        let (mut best, mut best_is_new) = (0.0, false);
        for (found, known) in self.candidates.iter_mut().zip(&self.arrivals) {
            let reached = known.probability * (1.0 - left);
            found.probability = (reached + anew) * seen(found.probability);
            if found.probability > best {
                (best, best_is_new) = (found.probability, reached + self.none * back < wrong);
            }
        }
        let stays = self.none * (1.0 - back) + on_lanes * left + wrong * options.matching.none;
        self.none = stays * seen(none);
        best_is_new
    }

    /// Keeps the most probable candidates as hypotheses, which add up to 1.
    fn keep(&mut self) {
        self.candidates.sort_unstable_by(|a, b| {
            let order = b.probability.total_cmp(&a.probability);
            order.then((a.lane, a.forward).cmp(&(b.lane, b.forward)))
        });
        self.candidates.truncate(MOST_HYPOTHESES);
        let sum = |all: &[LaneMatch]| all.iter().map(|found| found.probability).sum::<f64>();
        let all = self.none + sum(&self.candidates);
        self.candidates.retain(|found| found.probability > LEAST_PROBABILITY * all);
        let all = self.none + sum(&self.candidates);
        if all > 0.0 {
            self.none /= all;
            self.candidates.iter_mut().for_each(|found| found.probability /= all);
        } else {
            // Nothing that is known explains the fix.
            self.none = 1.0;
        }
        std::mem::swap(&mut self.candidates, &mut self.hypotheses);
    }

    fn answer(&self, is_new: bool, enough: f64) -> Tracked {
        match self.hypotheses.first() {
            Some(best) if best.probability >= enough && !is_new => Tracked::Lane(*best),
            _ if self.none >= enough => Tracked::NoLane,
            _ => Tracked::Unknown,
        }
    }
}

/// What was driven since the last fix.
fn drive(last: &Last, fix: &TrackerFix, variance: f64, options: &TrackerOptions<'_>) -> Drive {
    // Of two places with noise the square of the distance is greater by the sum of all four variances.
    let squared = last.position.distance_squared(fix.pose.position.xy);
    let straight = || (squared - 2.0 * (last.variance + variance)).max(0.0).sqrt();
    let time = (fix.time - last.time).max(LEAST_TIME);
    let measured = last.odometer.zip(fix.odometer).map(|(before, now)| now - before);
    // One that has jumped says nothing of the way.
    let measured = measured.filter(|way| way.abs() <= MOST_STEP + MOST_SPEED * time);
    let share = if measured.is_some() { ODOMETER_SHARE } else { STRAIGHT_SHARE };
    let way = measured.unwrap_or_else(straight);
    let noise = last.variance.max(variance).sqrt();
    Drive {
        way,
        deviation: DETOUR + noise + share * way.abs(),
        change: 1.0 - libm::exp(-time / options.change_interval),
    }
}
