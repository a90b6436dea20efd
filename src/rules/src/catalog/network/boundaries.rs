//! Boundaries of junctions.

use crate::example::Example::{self, Document};
use crate::network::Network;
use crate::place::{number, text, value};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_xodr::{BoundarySegment, Junction, PositionOrEnd, SegmentType, Span};
use std::collections::HashSet;

/// Gaps that come from rounding and from borders that are drawn straight between places.
const GAP: Tolerance = Tolerance { name: "gap", value: 0.1, unit: "m" };
/// Points along a lane's border are this far apart at most `[m]`, but for boundaries of more than [`POINTS`] such steps.
const STEP: f64 = 2.0;
/// Steps along the borders of one boundary at most, beside one for each of its segments.
const POINTS: f64 = 2000.0;

/// A road into junction 9 and out of it, with a boundary and more behind.
macro_rules! bounded {
    ($segments:literal, $more:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/><successor elementType="road" elementId="3" contactPoint="start"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="3" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="70" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#,
            $more, "<boundary>", $segments, "</boundary></junction>"
        ))
    };
}

const SOUND: Example = bounded!(
    r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
    r#"<planView><geometry s="0" x="45" y="-1.5" hdg="0" length="30"><line/></geometry></planView>"#
);

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.boundary.segments_close_boundry",
        "The segments of a boundary form one closed line.",
        All(closed),
        [
            SOUND,
            bounded!(
                r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="10"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
                ""
            ),
        ],
    )
    .also(&["asam.net:xodr:1.8.0:junctions.boundary.close_gap_with_new_roads"])
    .within(&[GAP]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.boundary.segments_counter_clockwise_order",
        "A boundary runs counter-clockwise.",
        All(counter_clockwise),
        [
            SOUND,
            bounded!(
                r#"<segment type="joint" roadId="1" contactPoint="end" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="start" sEnd="end"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="0" jointLaneEnd="-1"/><segment type="lane" roadId="2" boundaryLane="-1" sStart="end" sEnd="start"/>"#,
                ""
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.boundary.segments_for_each_conn_road",
        "Each road that leads into a junction has a segment of its boundary.",
        All(each_road),
        [
            SOUND,
            bounded!(
                r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
                ""
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.geometry.correct_junction_boundry",
        "The reference line of a junction crosses or touches its boundary.",
        All(line_crosses),
        [
            SOUND,
            bounded!(
                r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
                r#"<planView><geometry s="0" x="40" y="30" hdg="0" length="40"><line/></geometry></planView>"#
            ),
        ],
    )
    .within(&[GAP]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.geometry.ref_line_definition",
        "The reference line of a junction extends along the whole junction.",
        All(line_spans),
        [
            SOUND,
            bounded!(
                r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
                r#"<planView><geometry s="0" x="45" y="-1.5" hdg="0" length="10"><line/></geometry></planView>"#
            ),
        ],
    )
    .within(&[GAP]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.elevation_grid.valid_for_entire_boundry",
        "An elevation grid covers the whole junction.",
        All(grid_covers),
        [
            bounded!(
                r#"<segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="joint" roadId="3" contactPoint="start" jointLaneStart="-1" jointLaneEnd="0"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/>"#,
                r#"<planView><geometry s="0" x="45" y="-1.5" hdg="0" length="30"><line/></geometry></planView>"#
            ),
            Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><planView><geometry s="0" x="45" y="-1.5" hdg="0" length="30"><line/></geometry></planView><boundary><segment type="lane" roadId="2" boundaryLane="-1" sStart="start" sEnd="end"/><segment type="lane" roadId="2" boundaryLane="0" sStart="end" sEnd="start"/><segment type="joint" roadId="1" contactPoint="end" jointLaneStart="0" jointLaneEnd="-1"/></boundary><elevationGrid sStart="0" gridSpacing="5"><elevation left="0" center="0" right="0"/><elevation left="0" center="0" right="0"/></elevationGrid></junction>"#),
        ],
    )
    .within(&[GAP]),
];

type Point = [f64; 2];

/// The border of a lane: its outer edge; of lane 0 the reference line as shifted.
fn border(network: &Network, road: &crate::network::RoadFacts, s: f64, lane: i32) -> Option<Point> {
    let section = network.section_over(road, s, lane)?;
    let t = match lane {
        // The inner border of the first lane of either side.
        0 => [1, -1]
            .iter()
            .find_map(|id| network.lane(section, *id))
            .map_or(0.0, |lane| Network::borders_over(section, lane, s)[0]),
        id => Network::borders_over(section, network.lane(section, id)?, s)[1],
    };
    Some(network.station_at(road, s)?.at(t))
}

fn place(value: &PositionOrEnd, length: f64) -> f64 {
    match value {
        PositionOrEnd::At(s) => *s,
        PositionOrEnd::Start => 0.0,
        PositionOrEnd::End => length,
    }
}

/// Where a segment along a lane's border begins and ends on a road of this length `[m]`.
fn along_lane(segment: &BoundarySegment, length: f64) -> Option<[f64; 2]> {
    Some([place(&value(&segment.s_start)?, length), place(&value(&segment.s_end)?, length)])
}

/// The points of a segment in the order of the boundary, this far apart at most; none where something that it names is missing.
fn points(network: &Network, segment: &BoundarySegment, step: f64) -> Option<Vec<Point>> {
    let road = network.road(text(&segment.road_id))?;
    if value(&segment.r#type) == Some(SegmentType::Joint) {
        let s = place(&value(&segment.contact_point)?, road.length);
        let lanes = |side| Some(network.lanes_of(network.section_over(road, s, side)?));
        let first = value(&segment.joint_lane_start)
            .or_else(|| lanes(1)?.first().map(|lane| lane.id.max(0)))?;
        let last = value(&segment.joint_lane_end)
            .or_else(|| lanes(-1)?.last().map(|lane| lane.id.min(0)))?;
        return Some(vec![border(network, road, s, first)?, border(network, road, s, last)?]);
    }
    let lane = value(&segment.boundary_lane)?;
    let [start, end] = along_lane(segment, road.length)?;
    let steps = (((end - start).abs() / step).ceil() as usize).clamp(1, POINTS as usize);
    let at = |step: usize| start + (end - start) * step as f64 / steps as f64;
    (0..=steps).map(|step| border(network, road, at(step), lane)).collect()
}

/// The lines of a junction's segments, with their tags; none where one cannot be built.
fn ring(network: &Network, junction: &Junction) -> Option<Vec<(Span, Vec<Point>)>> {
    let segments = &junction.boundary.as_ref()?.segment;
    let lengths = segments.iter().filter_map(|segment| {
        let [start, end] = along_lane(segment, network.road(text(&segment.road_id))?.length)?;
        Some((end - start).abs())
    });
    let step = STEP.max(lengths.sum::<f64>() / POINTS);
    let line = |segment| points(network, segment, step);
    segments.iter().map(|segment| Some((segment.span, line(segment)?))).collect()
}

fn distance(a: Point, b: Point) -> f64 {
    mapd_geometry::hypot(a[0] - b[0], a[1] - b[1])
}

fn closed(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        let Some(ring) = ring(network, junction) else { continue };
        for (rank, (span, line)) in ring.iter().enumerate() {
            let before = &ring[(rank + ring.len() - 1) % ring.len()].1;
            let (Some(&end), Some(&start)) = (before.last(), line.first()) else { continue };
            let gap = distance(end, start);
            if gap > GAP.value {
                let part = PartOf::junction(text(&junction.id), "boundary/segment");
                sink.add_in(
                    part,
                    *span,
                    "a segment that begins where the one before ends",
                    format_args!("a gap of {gap:.3} m"),
                );
            }
        }
    }
}

/// The points of a junction's boundary.
fn outline(network: &Network, junction: &Junction) -> Option<Vec<Point>> {
    Some(ring(network, junction)?.into_iter().flat_map(|(_, line)| line).collect())
}

fn counter_clockwise(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        let Some(points) = outline(network, junction).filter(|points| points.len() > 2) else {
            continue;
        };
        let [x0, y0] = points[0];
        let next = points.iter().skip(1).chain(points.first());
        let area: f64 = points
            .iter()
            .zip(next)
            .map(|(a, b)| (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0))
            .sum();
        if area < 0.0 {
            let span = junction.boundary.as_ref().map_or(junction.span, |boundary| boundary.span);
            let part = PartOf::junction(text(&junction.id), "boundary");
            sink.add_in(
                part,
                span,
                "a boundary that runs counter-clockwise",
                "one that runs clockwise",
            );
        }
    }
}

fn each_road(network: &Network, sink: &mut Sink<'_>) {
    // Of junctions with one id, which is an error, the first: roads lead into all of them.
    let mut seen = HashSet::new();
    for junction in network.junctions_as_written() {
        let Some(boundary) = &junction.boundary else { continue };
        let id = text(&junction.id);
        if !seen.insert(id) {
            continue;
        }
        let named: HashSet<&str> =
            boundary.segment.iter().map(|segment| text(&segment.road_id)).collect();
        let roads = network.name_of(id).into_iter().flat_map(|id| network.roads_into(id));
        for own in roads.map(|road| network.name(road.id)).filter(|own| !named.contains(own)) {
            let expected = format_args!("a segment at road {own}");
            sink.add_in(PartOf::junction(id, "boundary"), boundary.span, expected, "none");
        }
    }
}

/// The reference line of a junction: start, direction, length.
fn line(junction: &Junction) -> Option<(Span, Point, Point, f64)> {
    let geometry = junction.plan_view.as_ref()?.geometry.first()?;
    let (cos, sin) = mapd_geometry::cos_sin(number(&geometry.hdg));
    let start = [number(&geometry.x), number(&geometry.y)];
    Some((geometry.span, start, [cos, sin], number(&geometry.length)))
}

/// Along and beside a line: s and t of a point.
fn along(start: Point, direction: Point, point: Point) -> (f64, f64) {
    let (dx, dy) = (point[0] - start[0], point[1] - start[1]);
    (dx * direction[0] + dy * direction[1], dy * direction[0] - dx * direction[1])
}

fn line_crosses(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        let Some((span, start, direction, length)) = line(junction) else { continue };
        let Some(points) = outline(network, junction).filter(|points| !points.is_empty()) else {
            continue;
        };
        let track: Vec<(f64, f64)> =
            points.iter().map(|point| along(start, direction, *point)).collect();
        let next = track.iter().skip(1).chain(track.first());
        let meets = track.iter().zip(next).any(|(a, b)| {
            let touches = a.1.abs() <= GAP.value && a.0 >= -GAP.value && a.0 <= length + GAP.value;
            let crosses = (a.1 < 0.0) != (b.1 < 0.0) && {
                let s = a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1);
                s >= -GAP.value && s <= length + GAP.value
            };
            touches || crosses
        });
        if !meets {
            let part = PartOf::junction(text(&junction.id), "planView");
            sink.add_in(part, span, "a line that meets the boundary", "one beside it");
        }
    }
}

fn line_spans(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        let Some((span, start, direction, length)) = line(junction) else { continue };
        let Some(points) = outline(network, junction) else { continue };
        let outside = points.iter().map(|point| along(start, direction, *point).0);
        let beyond = outside.map(|s| (-s).max(s - length)).fold(0.0, f64::max);
        if beyond > GAP.value {
            let part = PartOf::junction(text(&junction.id), "planView");
            let found = format_args!("{beyond:.2} m of the junction beyond it");
            sink.add_in(part, span, "a line as long as the junction", found);
        }
    }
}

fn grid_covers(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        let Some((_, start, direction, _)) = line(junction) else { continue };
        let (Some(grid), Some(points)) = (&junction.elevation_grid, outline(network, junction))
        else {
            continue;
        };
        let parse = |text: &str| text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
        let (Some(s_start), Some(spacing)) =
            (parse(text(&grid.s_start)), parse(text(&grid.grid_spacing)))
        else {
            continue;
        };
        let s_end = s_start + spacing * (grid.elevation.len().saturating_sub(1)) as f64;
        let most = |side: fn(&mapd_xodr::GridElevation) -> &str| {
            grid.elevation
                .iter()
                .map(|row| side(row).split_ascii_whitespace().count())
                .max()
                .unwrap_or(0) as f64
        };
        let (left, right) =
            (most(|row| text(&row.left)) * spacing, most(|row| text(&row.right)) * spacing);
        let outside = |point: &Point| {
            let (s, t) = along(start, direction, *point);
            (s_start - s).max(s - s_end).max(t - left).max(-right - t)
        };
        let beyond = points.iter().map(outside).fold(0.0, f64::max);
        if beyond > GAP.value {
            let part = PartOf::junction(text(&junction.id), "elevationGrid");
            sink.add_in(
                part,
                grid.span,
                "a grid that covers the junction",
                format_args!("{beyond:.2} m of it beyond"),
            );
        }
    }
}
