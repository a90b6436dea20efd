//! What stands on and beside lanes, and what is known of the map itself.

use super::{middle, parts, place};
use crate::drawing::{Drawing, Pen, TILE, level};
use crate::paint::Paint;
use crate::signs::SignalSign;
use mapd_archive::packed_index::WIDTH;
use mapd_query::Region;
use mapd_query::SRange;
use mapd_query::glam::{DVec2, DVec3};
use mapd_query::objects::{Object, ObjectPlacement};
use mapd_query::vocabulary::{Class, ObjectShape};
use mapd_query::{Lane, Map};

/// Radius of the mark of an object without extent `[m]`.
const MARK: f64 = 0.3;
/// Corners of a round object.
const ROUND: usize = 12;
/// Width of a line at which traffic stops, for which files give none `[m]`.
const STOP_LINE: f64 = 0.4;
/// Length of the stroke from a signal to where it faces `[m]`.
const FACE: f64 = 1.0;
/// Distance between points of a stretch on which lanes meet `[m]`.
const CONFLICT_STEP: f64 = 2.0;

fn is_crosswalk(object: &Object<'_>) -> bool {
    matches!(object.class(), Class::Crosswalk | Class::BicycleCrossing)
}

/// Square by square, so that what lies near each other is one chunk.
pub(super) fn in_tiles<T>(mut things: Vec<(DVec3, T)>) -> impl Iterator<Item = (DVec3, T)> {
    let tile = |place: &DVec3| {
        let tile = (place.truncate() / TILE).floor();
        (tile.y as i64, tile.x as i64)
    };
    things.sort_by_key(|(place, _)| tile(place));
    things.into_iter()
}

fn placements<'a>(
    map: Map<'a>,
    wanted: impl Fn(&Object<'a>) -> bool,
) -> impl Iterator<Item = (DVec3, ObjectPlacement<'a>)> {
    let places = map.objects().filter(wanted).flat_map(|object| object.placements());
    in_tiles(places.map(|place| (place.position(), place)).collect())
}

pub(super) fn crosswalks(map: Map<'_>, drawing: &mut Drawing) {
    for (at, place) in placements(map, is_crosswalk) {
        drawing.near(at.truncate());
        object(map, &place, [Paint::Crosswalk, Paint::CrosswalkLine], drawing);
    }
}

pub(super) fn objects(map: Map<'_>, drawing: &mut Drawing) {
    for (at, place) in placements(map, |object| !is_crosswalk(object)) {
        drawing.near(at.truncate());
        object(map, &place, [Paint::Object, Paint::ObjectLine], drawing);
    }
}

/// What an object covers where it stands.
pub(crate) fn object(
    map: Map<'_>,
    place: &ObjectPlacement<'_>,
    [area, line]: [Paint; 2],
    drawing: &mut Drawing,
) {
    let level = level(place.position().z - middle(map).z);
    let pen = Pen { paint: line as u8, level, ..Pen::default() };
    let mut corners = Vec::new();
    match place.shape() {
        ObjectShape::Outlines => {
            for outline in place.outlines() {
                let points: Vec<DVec3> = outline.positions().collect();
                if !outline.is_closed() {
                    drawing.line(points.into_iter(), &pen);
                    continue;
                }
                if outline.is_outer() {
                    drawing.area(&points, area as u8, level);
                }
                drawing.ring(&points, &pen);
            }
            return;
        }
        ObjectShape::Box => place.footprint(&mut corners),
        shape => {
            let radius = if shape == ObjectShape::Cylinder { place.radius() } else { MARK };
            let corner = |i: usize| {
                let angle = std::f64::consts::TAU * i as f64 / ROUND as f64;
                DVec2::new(libm::cos(angle), libm::sin(angle)).extend(0.0)
            };
            corners.extend((0..ROUND).map(|i| place.position() + radius.max(MARK) * corner(i)));
        }
    }
    drawing.area(&corners, area as u8, level);
    drawing.ring(&corners, &pen);
}

pub(super) fn stop_lines(map: Map<'_>, drawing: &mut Drawing) {
    let lines =
        map.lanes().flat_map(|lane| lane.lines_to_stop_at().map(move |line| (lane, line.s)));
    let lines = lines.filter_map(|(lane, s)| Some((lane.edge_points_at(s)?[0], (lane, s))));
    for (at, (lane, s)) in in_tiles(lines.collect()) {
        drawing.near(at.truncate());
        let level = level_of(map, &lane);
        let pen = Pen { paint: Paint::StopLine as u8, level, width: STOP_LINE };
        drawing.line(lane.edge_points_at(s).into_iter().flatten(), &pen);
    }
}

/// The level on which a lane is drawn: that of its section.
pub(crate) fn level_of(map: Map<'_>, lane: &Lane<'_>) -> i64 {
    level(place(&lane.section()).z - middle(map).z)
}

pub(super) fn signals(map: Map<'_>, drawing: &mut Drawing) {
    let signals = map.signals().map(|signal| (signal.position(), signal)).collect();
    for (at, signal) in in_tiles(signals) {
        drawing.near(at.truncate());
        let facing = DVec2::new(libm::cos(signal.facing()), libm::sin(signal.facing()));
        let level = level(at.z - middle(map).z);
        let pen = Pen { paint: SignalSign::of(&signal) as u8, level, ..Pen::default() };
        drawing.line([at, at + (FACE * facing).extend(0.0)].into_iter(), &pen);
    }
}

/// The middles of lanes where they meet others.
pub(super) fn conflicts(map: Map<'_>, drawing: &mut Drawing) {
    let lanes = map.lanes().filter(|lane| lane.conflicts().next().is_some());
    for (at, lane) in in_tiles(lanes.map(|lane| (place(&lane.section()), lane)).collect()) {
        drawing.near(at.truncate());
        let pen =
            Pen { paint: Paint::Conflict as u8, level: level_of(map, &lane), ..Pen::default() };
        for conflict in lane.conflicts() {
            let SRange { low: from, high: to } = conflict.s_range();
            let steps = parts(to - from, CONFLICT_STEP);
            let s = |i: usize| from + (to - from) * i as f64 / steps as f64;
            let points = (0..=steps).filter_map(|i| lane.pose_at(s(i), 0.0).ok());
            drawing.line(points.map(|pose| pose.position), &pen);
        }
    }
}

/// The boxes of the index's nodes, from the root to the leaves.
pub(super) fn index_boxes(map: Map<'_>, drawing: &mut Drawing) {
    let (origin, pen) =
        (map.local_origin(), Pen { paint: Paint::IndexBox as u8, level: 0, ..Pen::default() });
    for node in map.tables().index_nodes {
        for k in 0..WIDTH {
            let low = DVec2::new(f64::from(node.min_x()[k]), f64::from(node.min_y()[k]));
            let high = DVec2::new(f64::from(node.max_x()[k]), f64::from(node.max_y()[k]));
            // Unused places are empty.
            if low.x > high.x {
                continue;
            }
            drawing.near(origin + low);
            let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
            drawing.ring(&corners.map(|corner| (origin + corner).extend(0.0)), &pen);
        }
    }
}

/// A box around each part that is left out and whose place is known.
pub(super) fn quarantine(map: Map<'_>, drawing: &mut Drawing) {
    for part in map.quarantined() {
        let Some(Region { low, high }) = part.extent() else { continue };
        drawing.near(low);
        // Above everything: what is missing must be seen.
        let level = level(map.bounds().high.z - middle(map).z) + 1;
        let corner = |x: f64, y: f64| DVec3::new(x, y, middle(map).z);
        let corners = [
            corner(low.x, low.y),
            corner(high.x, low.y),
            corner(high.x, high.y),
            corner(low.x, high.y),
        ];
        drawing.area(&corners, Paint::Quarantine as u8, level);
        let pen = Pen { paint: Paint::QuarantineLine as u8, level, ..Pen::default() };
        drawing.ring(&corners, &pen);
    }
}
