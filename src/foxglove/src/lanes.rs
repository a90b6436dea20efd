//! Lanes as areas, coloured by type.

use crate::scene::{Frame, color, entity};
use foxglove::messages::{Color, SceneEntity, Timestamp, TriangleListPrimitive};
use mapd_client::glam::DVec3;
use mapd_client::roads::LinePoint;
use mapd_client::vocabulary::LaneType;
use mapd_client::{Lane, Map};
use mapd_web::Paint;

/// An entity for each road, with the keys of its lanes.
pub(crate) fn entities(map: Map<'_>, frame: &Frame, stamp: Option<Timestamp>) -> Vec<SceneEntity> {
    let road = |road: mapd_client::Road<'_>| {
        let sections = road.sections();
        let lanes: Vec<Lane<'_>> =
            sections.flat_map(|section| section.lanes()).filter(|one| one.number() != 0).collect();
        let keys: Vec<String> = lanes.iter().map(|lane| lane.key().to_string()).collect();
        let junction = road.junction();
        let mut entity = entity(
            format!("road {}", road.id()),
            stamp,
            &[
                ("road", road.id()),
                ("name", road.name()),
                ("junction", junction.as_ref().map_or("", |junction| junction.id())),
                ("lanes", &keys.join(" ")),
            ],
        );
        let mut area = TriangleListPrimitive::default();
        for lane in &lanes {
            add(lane, frame, &mut area);
        }
        if !area.points.is_empty() {
            entity.triangles.push(area);
        }
        entity
    };
    map.roads().map(road).collect()
}

fn paint(kind: LaneType) -> Color {
    color(
        match Paint::from(kind) {
            Paint::NoLane => 0x3a_3f42,
            Paint::Edge => 0x5a_6066,
            Paint::Green => 0x4e_7a52,
            Paint::Walking => 0xc9_b994,
            Paint::Biking => 0xb0_6a52,
            Paint::Parking => 0x5f_7fae,
            Paint::Rail => 0x7a_6853,
            Paint::Bus => 0x84_74a0,
            Paint::Works => 0xd0_9a35,
            Paint::Driving => 0x7b_828b,
            _ => 0x65_6a6e,
        },
        1.0,
    )
}

/// Adds the strip between a lane's borders.
fn add(lane: &Lane<'_>, frame: &Frame, to: &mut TriangleListPrimitive) {
    let sides = [lane.left_bound_of_reference_line(), lane.right_bound_of_reference_line()];
    let pair = |at: LinePoint| (at.s, at.position);
    let [left, right] = sides.map(|side| side.points().map(pair).collect::<Vec<_>>());
    if left.len() < 2 || right.len() < 2 {
        return;
    }
    let first = to.points.len() as u32;
    let points = left.iter().chain(&right);
    to.points.extend(points.map(|(_, point): &(f64, DVec3)| frame.point(*point)));
    to.colors.extend(std::iter::repeat_n(paint(lane.kind()), left.len() + right.len()));
    let (mut l, mut r) = (0, 0);
    while l + 1 < left.len() || r + 1 < right.len() {
        // The side whose next point comes first goes on.
        let is_left = match (left.get(l + 1), right.get(r + 1)) {
            (Some((a, _)), Some((b, _))) => a <= b,
            (next, _) => next.is_some(),
        };
        let next = if is_left { l + 1 } else { left.len() + r + 1 };
        // Seen from above, counter-clockwise.
        to.indices.extend([l, left.len() + r, next].map(|at| first + at as u32));
        if is_left { l += 1 } else { r += 1 }
    }
}
