//! Areas beside the lanes: where vehicles park, islands, buildings, plants.

use super::model::{Area, Model};
use super::report::Report;
use mapd_client::glam::DVec3;
use mapd_client::objects::ObjectPlacement;
use mapd_client::vocabulary::{Class, LaneType, ObjectShape};
use mapd_client::{Lane, Map};

/// Adds an area for each lane section of a kind that Lanelet2 has as an area, unless somebody drives there, and for each place of such an
/// object.
pub(super) fn add<'a>(map: Map<'a>, model: &mut Model<'a>, report: &mut Report) {
    let lanes = map.lanes().filter(|lane| lane.number() != 0 && !lane.is_temporary());
    for lane in lanes {
        let Some(subtype) = of_lane(lane.kind()) else { continue };
        if model.network.lanelets_of(&lane).is_empty() {
            let tag = ("lane_key", lane.key().to_string().into());
            model.add_area(&[around(&lane)], subtype, tag, report);
        }
    }
    for object in map.objects().filter(|object| !object.is_temporary()) {
        let Some(subtype) = of_object(object.class()) else { continue };
        for place in object.placements() {
            let tag = ("object_id", object.id().into());
            model.add_area(&rings(&place), subtype, tag, report);
        }
    }
}

fn of_lane(kind: LaneType) -> Option<&'static str> {
    match kind {
        LaneType::Parking => Some("parking"),
        LaneType::Median => Some("traffic_island"),
        _ => None,
    }
}

fn of_object(class: Class) -> Option<&'static str> {
    match class {
        Class::ParkingSpace => Some("parking"),
        Class::TrafficIsland => Some("traffic_island"),
        Class::Building => Some("building"),
        Class::Vegetation => Some("vegetation"),
        _ => None,
    }
}

/// Around a lane: along its left border by the reference line, back along the right one.
fn around(lane: &Lane<'_>) -> Vec<DVec3> {
    let mut ring: Vec<DVec3> = lane.left_bound_of_reference_line().positions().collect();
    let right: Vec<DVec3> = lane.right_bound_of_reference_line().positions().collect();
    ring.extend(right.into_iter().rev());
    ring
}

/// The outline of an object where it stands, and those of holes in it.
fn rings(place: &ObjectPlacement<'_>) -> Vec<Vec<DVec3>> {
    let mut corners = Vec::new();
    if place.shape() != ObjectShape::Outlines {
        place.footprint(&mut corners);
        return vec![corners];
    }
    let closed = || place.outlines().filter(|outline| outline.is_closed());
    let outer = closed().find(|outline| outline.is_outer());
    let inner = closed().filter(|outline| !outline.is_outer());
    outer.into_iter().chain(inner).map(|outline| outline.positions().collect()).collect()
}

/// A ring that runs clockwise, as Lanelet2 has the outer ones, without points that are one.
pub(super) fn clockwise(mut ring: Vec<DVec3>, distinct: f64) -> Vec<DVec3> {
    ring.dedup_by(|a, b| a.distance(*b) <= distinct);
    while let (true, [first, .., last]) = (ring.len() > 1, &ring[..]) {
        if first.distance(*last) > distinct {
            break;
        }
        ring.pop();
    }
    let next = ring.iter().cycle().skip(1);
    let twice: f64 = ring.iter().zip(next).map(|(a, b)| a.truncate().perp_dot(b.truncate())).sum();
    if twice > 0.0 {
        ring.reverse();
    }
    ring
}

impl<'a> Model<'a> {
    /// Adds an area with its outer ring and its holes; the report counts those without an extent.
    fn add_area(
        &mut self,
        rings: &[Vec<DVec3>],
        subtype: &'static str,
        tag: super::tags::Tag<'a>,
        report: &mut Report,
    ) {
        let mut lines = Vec::new();
        for ring in rings {
            let ring = clockwise(ring.clone(), super::model::DISTINCT);
            if ring.len() > 2 {
                lines.push(self.add_ring(ring, vec![("type", "virtual".into())]));
            }
        }
        let Some((outer, inner)) = lines.split_first() else {
            return report.unsaid("areas without an extent");
        };
        let tags = vec![
            ("type", "multipolygon".into()),
            ("subtype", subtype.into()),
            ("location", "urban".into()),
            tag,
        ];
        self.areas.push(Area { outer: *outer, inner: inner.to_vec(), tags });
    }
}
