//! Areas beside the lanes: where vehicles park, islands, buildings, plants. Those that are lanes share borders with lanelets beside them.

use super::model::{Area, BorderLine, Edge, Model};
use super::network::is_wide;
use super::report::Report;
use super::stretches::borders;
use super::tags::Tag;
use mapd_client::glam::DVec3;
use mapd_client::objects::ObjectPlacement;
use mapd_client::vocabulary::{Class, LaneType, ObjectShape};
use mapd_client::{Lane, Map};
use std::ops::Range;

/// Adds an area for each lane section of a kind that Lanelet2 has as an area, unless somebody drives there, and for each place of such an
/// object.
pub(super) fn add<'a>(map: Map<'a>, model: &mut Model<'a>, report: &mut Report) {
    for strip in model.strips(report) {
        model.add_strip(&strip);
    }
    for object in map.objects().filter(|object| !object.is_temporary()) {
        let Some(subtype) = of_object(object.class()) else { continue };
        for place in object.placements() {
            let tag = ("object_id", object.id().into());
            model.add_area(&rings(&place), subtype, tag, report);
        }
    }
}

/// A lane that is an area, along pieces of its stretch on which it has a width.
struct Strip<'a> {
    lane: Lane<'a>,
    subtype: &'static str,
    stretch: u32,
    /// Borders to the left and right of the reference line's direction.
    borders: [u32; 2],
    pieces: Range<u32>,
}

fn of_lane(kind: LaneType) -> Option<&'static str> {
    match kind {
        LaneType::Parking => Some("parking"),
        LaneType::Median => Some("traffic_island"),
        _ => None,
    }
}

/// The subtype of the area that an object is; none of others.
pub(super) fn of_object(class: Class) -> Option<&'static str> {
    match class {
        Class::ParkingSpace => Some("parking"),
        Class::TrafficIsland => Some("traffic_island"),
        Class::Building => Some("building"),
        Class::Vegetation => Some("vegetation"),
        _ => None,
    }
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
    /// Lanes of a kind that Lanelet2 has as an area, unless somebody drives there; the report counts those that nowhere have a width.
    fn strips(&self, report: &mut Report) -> Vec<Strip<'a>> {
        let mut strips = Vec::new();
        for (number, stretch) in self.network.kept() {
            let lanes = stretch.lanes.iter().enumerate();
            for (at, lane) in lanes.filter(|(_, lane)| lane.number() != 0 && !lane.is_temporary()) {
                let Some(subtype) = of_lane(lane.kind()) else { continue };
                if !self.network.lanelets_of(lane).is_empty() {
                    continue;
                }
                let last = stretch.cuts.len().saturating_sub(1) as u32;
                let wide: Vec<u32> = (0..last).filter(|at| is_wide(lane, stretch, *at)).collect();
                if wide.is_empty() {
                    report.unsaid("areas without an extent");
                }
                for run in wide.chunk_by(|a, b| a + 1 == *b) {
                    let (lane, borders) = (*lane, borders(lane, at));
                    let pieces = run[0]..run[0] + run.len() as u32;
                    strips.push(Strip { lane, subtype, stretch: number, borders, pieces });
                }
            }
        }
        strips
    }

    /// Adds the area of a lane: between its borders, which it shares with lanelets beside it, and chords at both ends.
    fn add_strip(&mut self, strip: &Strip<'a>) {
        let Range { start, end } = strip.pieces.clone();
        let [left, right] = strip.borders;
        let along = |border| {
            let stretch = strip.stretch;
            strip
                .pieces
                .clone()
                .map(move |piece| Edge::Border(BorderLine { stretch, border, piece }))
        };
        let mut outer: Vec<Edge> = along(left).collect();
        outer.extend(self.end_of_strip(strip, end, strip.borders));
        outer.extend(along(right).rev());
        outer.extend(self.end_of_strip(strip, start, [right, left]));
        let tag = ("lane_key", strip.lane.key().to_string().into());
        self.areas.push(Area { outer, inner: Vec::new(), tags: tags(strip.subtype, tag) });
    }

    /// The chord from one border to the other at a cut; none where both have one point there.
    fn end_of_strip(&mut self, strip: &Strip<'a>, cut: u32, borders: [u32; 2]) -> Option<Edge> {
        let stretch = self.network.stretches.all.get(strip.stretch as usize)?;
        let corners = borders.map(|border| stretch.corner(border, cut));
        let [from, to] = corners.map(|corner| self.network.joints.point(corner));
        (from != to).then(|| Edge::Line(self.add_chord(corners, vec![("type", "virtual".into())])))
    }

    /// Adds an area with its outer ring and its holes; the report counts those without an extent.
    fn add_area(
        &mut self,
        rings: &[Vec<DVec3>],
        subtype: &'static str,
        tag: Tag<'a>,
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
        let (outer, inner) = (vec![Edge::Line(*outer)], inner.to_vec());
        self.areas.push(Area { outer, inner, tags: tags(subtype, tag) });
    }
}

/// The tags of an area.
fn tags<'a>(subtype: &'static str, tag: Tag<'a>) -> Vec<Tag<'a>> {
    vec![
        ("type", "multipolygon".into()),
        ("subtype", subtype.into()),
        ("location", "urban".into()),
        tag,
    ]
}
