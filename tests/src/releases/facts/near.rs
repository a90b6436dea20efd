//! What lies near a point or in a region: the answers of the spatial indexes.

use super::key;
use super::line::{Fine, Lines};
use mapd_client::{LaneTypes, Map, NearestOptions, Region, glam::DVec2};
use mapd_query::Bounds;
use mapd_query::localisation::MarkFilter;
use mapd_query::vocabulary::ClassSet;

/// Points to ask about along each axis of a map.
const POINTS: usize = 3;
/// How far around a point \[m\].
const RADIUS: f64 = 25.0;
/// How far in height \[m\].
const LEVEL: f64 = 1.0;

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    let Bounds { low, high } = map.bounds();
    for i in 0..POINTS * POINTS {
        let share = DVec2::new((i % POINTS) as f64, (i / POINTS) as f64) / (POINTS - 1) as f64;
        let point = low.truncate() + (high - low).truncate() * share;
        lines.about("near").with("point", point);
        lanes(map, point, lines);
        signals(map, point, lines);
        objects(map, point, lines);
    }
}

fn lanes(map: Map<'_>, point: DVec2, lines: &mut Lines) {
    let options =
        NearestOptions { radius: RADIUS, types: LaneTypes::ALL, ..NearestOptions::default() };
    let mut found = Vec::new();
    let _ = map.lanes_near(point, &options, &mut found);
    for one in &found {
        let at = one.position;
        lines
            .about(format_args!("near lane {}", key(map, one.lane)))
            .with("s", at.s)
            .with("t", at.t)
            .with("distance", at.distance)
            .with("z", at.z)
            .with("offset", at.offset)
            .with("heading", Fine(at.heading))
            .with("clamped", at.clamped);
    }
    // On the map's lowest level alone.
    let options = NearestOptions { z_tolerance: Some(LEVEL), ..options };
    let low = point.extend(map.bounds().low.z);
    if let Ok(Some(one)) = map.nearest_lane(low, &options) {
        lines
            .about(format_args!("near lane below {}", key(map, one.lane)))
            .with("s", one.position.s);
    }
    if let Ok(Some(mark)) = map.nearest_mark(point, &MarkFilter::default()) {
        lines
            .about(format_args!("near mark {}", mark.kind.name()))
            .with("lane", key(map, mark.lane))
            .with("place", mark.place)
            .with("distance", mark.distance)
            .with("painted", mark.painted);
    }
    for junction in map.junctions() {
        if let Some(grid) = junction.grid_height_at(point) {
            lines
                .about(format_args!("grid of junction {:?}", junction.id()))
                .with("height", grid.height)
                .with("slope", grid.slope.to_array().map(Fine));
        }
    }
}

fn signals(map: Map<'_>, point: DVec2, lines: &mut Lines) {
    let (mut near, mut inside) = (Vec::new(), Vec::new());
    let _ = map.signals_near(point, RADIUS, &mut near);
    let _ = map.signals_in(Region::around(point, RADIUS), &mut inside);
    let id = |id| map.signal(id).map(|signal| signal.id()).unwrap_or_default();
    for one in &near {
        lines
            .about(format_args!("near signal {:?}", id(one.signal)))
            .with("distance", one.distance);
    }
    // A region answers in the index's order, which is no promise.
    let mut inside: Vec<_> = inside.into_iter().map(id).collect();
    inside.sort_unstable();
    lines.about("signals in region").with("ids", inside);
    let mut landmarks = Vec::new();
    let _ = map.landmarks_near(point, RADIUS, ClassSet::LANDMARKS, &mut landmarks);
    for one in &landmarks {
        lines
            .about(format_args!("near landmark {}", one.class.name()))
            .with("place", one.position)
            .with("distance", one.distance)
            .with("size", one.size)
            .with("angles", [one.heading, one.pitch, one.roll].map(Fine));
    }
}

fn objects(map: Map<'_>, point: DVec2, lines: &mut Lines) {
    let (mut near, mut inside) = (Vec::new(), Vec::new());
    let _ = map.objects_near(point, RADIUS, &mut near);
    let _ = map.objects_in(Region::around(point, RADIUS), &mut inside);
    let id = |place| {
        let placement = map.placement(place).ok()?;
        Some((placement.object().id(), placement.item()))
    };
    for one in &near {
        lines.about(format_args!("near object {:?}", id(one.place))).with("distance", one.distance);
    }
    let mut inside: Vec<_> = inside.into_iter().filter_map(id).collect();
    inside.sort_unstable();
    lines.about(format_args!("objects in region {inside:?}"));
}
