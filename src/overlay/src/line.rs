//! Lines on Earth: the lanes that one runs along.
//!
//! ```text
//!  line ── a place each 2 m ──► lanes near it ── the cheapest way through them, by links ──► lanes, each from where to where
//! ```
//!
//! At each place the nearest lane counts that is driven the line's way. Where several lie on each other, as in junctions, the one counts that continues
//! the lane before: an unlinked lane must be nearer. Between two places all lanes count that links lead through, however short they are.

mod links;
mod walk;

use crate::on_earth::ResolvedPlace;
use crate::place::{Across, EarthPlace};
use crate::placements::LINES_TOGETHER;
use crate::places::{PlaceError, SHORTEST, Stretch};
use mapd_query::glam::DVec2;
use mapd_query::{Lane, LaneTypes, Map};
use std::cell::{Cell, RefCell};
use std::f64::consts::FRAC_PI_4;
use std::rc::Rc;
use walk::Walk;

/// How far apart a line is looked at `[m]`.
const STEP: f64 = 2.0;

/// A line that goes on beyond a lane to one that is not linked with it, and was last seen on it this near to its end, reaches its end `[m]`: a step of
/// it, in a bend.
const NEAR_END: f64 = 1.5 * STEP;

/// Longest line `[m]`.
const LONGEST_LINE: f64 = 1e6;

/// How far from a line a lane may lie, where nothing is said `[m]`.
const LINE_TOLERANCE: f64 = 3.0;

/// Largest difference between a line and the way a lane is driven `[rad]`: what crosses it is not meant.
const HEADING_TOLERANCE: f64 = FRAC_PI_4;

/// A line that reaches this near to both ends of a lane means all of it `[m]`: degrees are written rounded.
const ROUNDED: f64 = 1e-3;

/// Places lines on a map.
pub(crate) struct Lines<'a> {
    map: Map<'a>,
    /// What is left of [`LINES_TOGETHER`] `[m]`.
    left: Cell<f64>,
    /// The line before: entries of one work zone share theirs.
    last: RefCell<Option<Known<'a>>>,
}

/// A line that was followed.
struct Known<'a> {
    points: Vec<DVec2>,
    tolerance: f64,
    followed: Rc<Followed<'a>>,
}

/// The lanes that a line runs along, in its order, and what of it lies on none.
#[derive(Default)]
struct Followed<'a> {
    passed: Vec<Stretch<'a>>,
    off: UnplacedPart,
    /// What of it lies within the map `[m]`.
    within: f64,
}

/// A part of a line that could not be placed.
#[derive(Clone, Default)]
struct UnplacedPart {
    /// The first reason.
    why: Option<String>,
    /// How long it is `[m]`.
    length: f64,
}

impl UnplacedPart {
    fn add(&mut self, length: f64, why: impl FnOnce() -> String) {
        self.why.get_or_insert_with(why);
        self.length += length;
    }

    fn error(&self, field: &str) -> Option<PlaceError> {
        let why = self.why.as_ref()?;
        Some(PlaceError::new(field, format!("{why}; over {:.0} m in all", self.length)))
    }
}

impl<'a> Lines<'a> {
    pub(crate) fn new(map: Map<'a>) -> Self {
        Self { map, left: Cell::new(LINES_TOGETHER), last: RefCell::new(None) }
    }

    pub(crate) fn left(&self) -> f64 {
        self.left.get()
    }

    /// The stretches that a line means, by its points on the map.
    ///
    /// Errors: none can be told; the first reason.
    pub(crate) fn stretches(
        &self,
        points: &[DVec2],
        place: &EarthPlace,
    ) -> Result<ResolvedPlace<'a>, PlaceError> {
        let tolerance = place.tolerance.unwrap_or(LINE_TOLERANCE);
        let followed = self.followed(points, tolerance)?;
        let (mut other, mut stretches) = (UnplacedPart::default(), Vec::new());
        for passed in &followed.passed {
            let Stretch { lane, s_from, s_to } = *passed;
            match meant(place, lane) {
                Err(why) => other.add(s_to - s_from, || why),
                Ok(lanes) => {
                    stretches.extend(lanes.into_iter().map(|lane| Stretch { lane, s_from, s_to }));
                }
            }
        }
        let stretches = joined(stretches);
        let mut unplaced: Vec<PlaceError> =
            [followed.off.error("line"), other.error("lanes")].into_iter().flatten().collect();
        if stretches.is_empty() {
            let nothing = || PlaceError::new("line", "lies on no lane");
            return Err(unplaced.pop().unwrap_or_else(nothing));
        }
        Ok(ResolvedPlace { stretches, unplaced })
    }

    fn followed(&self, points: &[DVec2], tolerance: f64) -> Result<Rc<Followed<'a>>, PlaceError> {
        let unfit = |why: String| PlaceError::new("line", why);
        if let Some(known) = &*self.last.borrow()
            && known.points == points
            && known.tolerance == tolerance
        {
            self.left.set(self.left.get() - known.followed.within);
            return Ok(Rc::clone(&known.followed));
        }
        let length: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        // Also false of what is no number.
        if !(SHORTEST..=LONGEST_LINE).contains(&length) {
            return Err(unfit(format!(
                "{length:.1} m long; lines are taken from {SHORTEST} m to {} km",
                LONGEST_LINE / 1e3
            )));
        }
        let mut walk = Walk::new(self.map, tolerance);
        walk.along(points, self.left.get());
        self.left.set(self.left.get() - walk.out.within);
        if self.left.get() < 0.0 {
            return Err(unfit(format!(
                "all lines together are longer than {} km within the map",
                LINES_TOGETHER / 1e3
            )));
        }
        let followed = Rc::new(walk.out);
        *self.last.borrow_mut() =
            Some(Known { points: points.to_vec(), tolerance, followed: Rc::clone(&followed) });
        Ok(followed)
    }
}

/// The lanes that are meant where a line runs along this one.
fn meant<'a>(place: &EarthPlace, near: Lane<'a>) -> Result<Vec<Lane<'a>>, String> {
    if place.lanes == Across::default() {
        return Ok(vec![near]);
    }
    let forward = near.is_forward();
    let driven = |lane: &Lane<'a>| {
        lane.lane_id() == near.lane_id()
            || (LaneTypes::routable().contains(lane.kind())
                && lane.nodes().any(|node| node.is_forward() == forward))
    };
    let mut lanes: Vec<Lane<'a>> = near.section().lanes().filter(driven).collect();
    // From the left as traffic goes.
    lanes.sort_by_key(|lane| if forward { -lane.number() } else { lane.number() });
    let (Across::Order(order), Some(of)) = (&place.lanes, place.of) else {
        return Ok(lanes);
    };
    if lanes.len() != of as usize {
        let (road, s) = (near.road(), near.section().s_start());
        let count = lanes.len();
        return Err(format!("road {} from {s:.1} m on has {count} lanes, not {of}", road.id()));
    }
    let wanted = order.iter().map(|number| *number as usize - 1);
    Ok(wanted.filter_map(|number| lanes.get(number).copied()).collect())
}

/// Stretches by lane and s; those that touch are one, and what is too short to be cut out of a lane is left out.
fn joined(mut stretches: Vec<Stretch<'_>>) -> Vec<Stretch<'_>> {
    stretches.sort_by(|a, b| {
        let key = |one: &Stretch<'_>| one.lane.lane_id().row();
        key(a).cmp(&key(b)).then(a.s_from.total_cmp(&b.s_from))
    });
    let mut out: Vec<Stretch<'_>> = Vec::new();
    for one in stretches {
        match out.last_mut() {
            Some(last) if last.lane.lane_id() == one.lane.lane_id() && one.s_from <= last.s_to => {
                last.s_to = last.s_to.max(one.s_to);
            }
            _ => out.push(one),
        }
    }
    out.retain(|one| {
        let section = one.lane.section();
        let is_whole =
            one.s_from <= section.s_start() + ROUNDED && one.s_to >= section.s_end() - ROUNDED;
        is_whole || one.s_to - one.s_from >= SHORTEST
    });
    out
}
