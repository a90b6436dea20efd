//! Lanes that lie beyond the centre of their road's bend.

use crate::example::Example::Document;
use crate::line::{Piece, Walk};
use crate::place::{RoadIn, SectionIn, Side, lane_part, number};
use crate::profile::{borders_at, superelevation_at};
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Lane, Severity};
use std::collections::BTreeMap;

/// Places that are looked at lie this far apart, or farther where a road is longer than 1,000 of them.
const STEP: Tolerance = Tolerance { name: "step", value: 1.0, unit: "m" };
/// How many places are looked at along a road and in each section at most.
const PLACES: f64 = 1000.0;
/// So far from the end of a short bend it is looked at, as a part of its length: at its end the next geometry holds.
const INSIDE: f64 = 1e-6;
/// Bends that are gentler fold no lane: none lies as far off its road as their centre.
const GENTLE: Tolerance =
    Tolerance { name: "curvature that is looked at", value: 0.01, unit: "1/m" };
/// Centers that run back less than this turn about the centre of the bend as its author meant.
const FOLD: Tolerance =
    Tolerance { name: "metres back per metre that count as none", value: 0.01, unit: "" };

/// A road that bends to the left with a lane on that side: its curvature.
macro_rules! bend {
    ($curvature:literal) => {
        Document(concat!(
            r#"<road id="1" length="5" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="5"><arc curvature=""#,
            $curvature,
            r#""/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="6" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "mapd:xodr:1.4.0:lane.folded",
    "The center line of a lane runs in its road's direction: the lane does not reach beyond the centre of a bend.",
    Road(folded),
    [bend!("0.2"), bend!("0.5")],
)
.strict(Severity::Warning)
.within(&[STEP, GENTLE, FOLD])];

/// Where a lane is folded most: how the center goes on there, and where that is.
struct Fold<'a> {
    lane: &'a Lane,
    section: f64,
    /// Metres of the center per metre of the reference line; negative.
    along: f64,
    /// `[m]`
    s: f64,
    /// Radius of the bend, and t of the lane's center `[m]`.
    bend: [f64; 2],
}

/// Whether a geometry may bend so sharply that lanes fold.
fn bends(piece: &Piece) -> bool {
    let even = piece.curve().map(|curve| curve.even_curvature_up_to(piece.length));
    even.is_some_and(|even| even.is_none_or(|curvature| curvature.abs() >= GENTLE.value))
}

fn folded(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    // Most roads have no such bend.
    if !of.line.pieces.iter().any(bends) {
        return;
    }
    let step = STEP.value.max(number(&of.road.length) / PLACES);
    for section in of.sections() {
        let mut worst = BTreeMap::new();
        for side in [Side::Left, Side::Right] {
            if !section.side(side).is_empty() {
                look(of, &section, side, step, &mut worst);
            }
        }
        for fold in worst.values() {
            let Fold { lane, section, along, s, bend: [radius, t] } = fold;
            let part = format!("lanes/laneSection[@s={section}]/{}", lane_part(lane, ""));
            let found = format_args!(
                "its center at t = {t:.3} m in a bend of radius {radius:.3} m at s = {s:.3}, where it runs back {:.3} m per metre",
                -along
            );
            sink.add_within(&part, lane.span, "a lane that goes on along its road", found);
        }
    }
}

/// Places in bends that are shorter than a step, so that steps may miss them: the middle and the end of each that a section has, from its start `[m]`.
fn short_bends<'a>(
    of: &RoadIn<'a>,
    start: f64,
    length: f64,
    step: f64,
) -> impl Iterator<Item = f64> + use<'a> {
    let pieces = &of.line.pieces;
    let first = pieces.partition_point(|piece| piece.s + piece.length <= start);
    let rest = pieces.get(first..).unwrap_or_default().iter();
    let own = rest.take_while(move |piece| piece.s < start + length);
    own.filter(move |piece| piece.length < step && bends(piece))
        .take(PLACES as usize)
        .flat_map(|piece| [0.5, 1.0 - INSIDE].map(|part| piece.s + part * piece.length))
        .map(move |s| s - start)
        .filter(move |ds| (0.0..=length).contains(ds))
}

/// Looks along a side of a section.
fn look<'a>(
    of: &RoadIn<'a>,
    section: &SectionIn<'a>,
    side: Side,
    step: f64,
    worst: &mut BTreeMap<i32, Fold<'a>>,
) {
    let length = section.length_of(side);
    let count = mapd_geometry::clamp((length / step).ceil(), 1.0, PLACES) as u32;
    let mut walk = Walk::new(of.line);
    let even = (0..=count).map(|place| length * f64::from(place) / f64::from(count));
    for ds in even.chain(short_bends(of, section.s(), length, step)) {
        let s = section.s() + ds;
        let Some(curvature) = walk.curvature_at(s) else { return };
        if curvature.abs() < GENTLE.value {
            continue;
        }
        let roll = mapd_geometry::cos_sin(superelevation_at(of.road, s)).0;
        for (id, inner, outer) in borders_at(section, side, ds) {
            let t = 0.5 * (inner + outer);
            let along = 1.0 - curvature * t * roll;
            if along < -FOLD.value && worst.get(&id).is_none_or(|fold| along < fold.along) {
                let Some(lane) = section.lane(id) else { continue };
                let bend = [1.0 / curvature.abs(), t];
                worst.insert(id, Fold { lane, section: section.s(), along, s, bend });
            }
        }
    }
}
