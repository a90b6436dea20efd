//! Overlays: a line along lanes that links join means all of them, however short they are and whatever lies over them.

use mapd_archive::open_overlay;
use mapd_query::geodesy::{Geodetic, Projector};
use mapd_query::glam::DVec2;
use mapd_query::view::View;
use mapd_query::{Lane, LaneTypes, Map, NearestOptions};
use mapd_tests::maps::{Random, carried_and, open};
use mapd_tests::overlays::over;
use mapd_tests::say;
use std::time::UNIX_EPOCH;

/// Hundreds of lanes below a decimetre, roundabouts, junctions in which lanes lie on each other.
const MAPS: [&str; 5] =
    ["carla/Town05", "carla/Town03", "carla/Town01", "Scenic/Town10HD", "SMARTS/od_newmarket_map"];
/// Ways on each map.
const WAYS: usize = 60;
/// Length of a way `[m]`, and most lanes of one.
const LENGTH: f64 = 400.0;
const LANES: usize = 60;
/// Lanes at which a line begins and ends are at least so long `[m]`.
const END: f64 = 2.0;
/// Lanes that are told to be short are shorter `[m]`.
const SHORT: f64 = 0.1;
/// Lanes that are linked meet to this `[m]`.
const GAP: f64 = 0.5;
/// A lane narrower than this need not be the nearest to its own centre `[m]`.
const NO_WIDTH: f64 = 0.2;

/// Where the centre of a lane begins, or ends, as its traffic goes.
fn end(lane: &Lane<'_>, begins: bool) -> DVec2 {
    let section = lane.section();
    let s = if lane.is_forward() == begins { section.s_start() } else { section.s_end() };
    lane.pose_at(s, 0.0).expect("a place").position.truncate()
}

/// Lanes one behind the other, from a random one on.
fn way<'a>(map: Map<'a>, lanes: &[Lane<'a>], random: &mut Random) -> Vec<Lane<'a>> {
    let mut lane = lanes[(random.unit() * lanes.len() as f64) as usize];
    let (mut way, mut length) = (Vec::new(), 0.0);
    loop {
        let section = lane.section();
        length += section.s_end() - section.s_start();
        way.push(lane);
        let next: Vec<Lane<'a>> = lane
            .successors()
            .filter_map(|id| map.lane(id).ok())
            .filter(|next| lanes.iter().any(|one| one.lane_id() == next.lane_id()))
            // A line over a gap in the map lies on what lies there.
            .filter(|next| {
                let [from, to] = [end(&lane, false), end(next, true)];
                from.distance(to) < GAP
            })
            .collect();
        if next.is_empty() || length > LENGTH || way.len() == LANES {
            return way;
        }
        lane = next[(random.unit() * next.len() as f64) as usize];
    }
}

fn center(way: &[Lane<'_>]) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::new();
    for lane in way {
        let mut own: Vec<DVec2> =
            lane.center_line().points().map(|point| point.position.truncate()).collect();
        if !lane.is_forward() {
            own.reverse();
        }
        points.extend(own);
    }
    points
}

fn place(projector: &Projector, points: &[DVec2]) -> String {
    let points = points.iter().map(|point| {
        let Geodetic { latitude, longitude, .. } =
            projector.to_geodetic(point.extend(0.0)).expect("on Earth");
        format!("[{latitude},{longitude}]")
    });
    format!(r#"{{"line":[{}]}}"#, points.collect::<Vec<_>>().join(","))
}

/// Whether no other lane lies over a lane, as far as its ends and its middle tell.
fn is_alone(map: Map<'_>, lane: &Lane<'_>) -> bool {
    let (low, high) = (lane.section().s_start(), lane.section().s_end());
    let options =
        NearestOptions { radius: 0.0, types: LaneTypes::routable(), ..NearestOptions::default() };
    let mut near = Vec::new();
    [low + 0.5, 0.5 * (low + high), high - 0.5].iter().all(|s| {
        let point = lane.pose_at(*s, 0.0).expect("a place").position.truncate();
        map.lanes_near(point, &options, &mut near).expect("an answer");
        near.len() <= 1
    })
}

/// Where a lane is not closed, if there is such a place.
fn hole(view: &View<'_>, lane: &Lane<'_>) -> Option<f64> {
    let (mut s, end) = (lane.section().s_start(), lane.section().s_end());
    while s < end {
        let middle_of_rest = 0.5 * (s + end.min(s + 0.02));
        let one = view.restrictions_at(lane.lane_id(), middle_of_rest).expect("an answer").next();
        match one {
            Some(one) => s = one.s_to.max(middle_of_rest + 1e-6),
            // Of a lane that has as good as no width, the one beside it is as near.
            None if lane.width_at(middle_of_rest) < NO_WIDTH => s = middle_of_rest + 1e-2,
            None => return Some(s),
        }
    }
    None
}

#[test]
fn a_line_along_lanes_means_all_of_them() {
    let (mut ways, mut lanes_passed, mut short) = (0, 0, 0);
    for file in carried_and(&MAPS) {
        let snapshot = open(&file);
        let map = snapshot.map();
        let Ok(projector) = map.projector() else { continue };
        let is_way = |lane: &Lane<'_>| {
            LaneTypes::routable().contains(lane.kind())
                && lane.nodes().next().is_some()
                && !lane.is_bidirectional()
        };
        let lanes: Vec<Lane<'_>> = map.lanes().filter(is_way).collect();
        let mut random = Random(26);
        for _ in 0..WAYS {
            let way = way(map, &lanes, &mut random);
            let length = |lane: &Lane<'_>| lane.section().s_end() - lane.section().s_start();
            // Where a line ends on a lane over which another lies, nothing that follows decides between them.
            let is_sure = |lane: &Lane<'_>| length(lane) > END && is_alone(map, lane);
            let Some(first) = way.iter().position(is_sure) else { continue };
            let last = way.iter().rposition(is_sure).unwrap_or(first);
            let way = &way[first..=last];
            let line = center(way);
            let text = format!(
                r#"{{"entries":[{{"id":"a","kind":"closed","places":[{}]}}]}}"#,
                place(&projector, &line)
            );
            let (bytes, resolved) = over(map, &text, false);
            let overlay = open_overlay(&bytes).expect("opens");
            let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
            for (i, lane) in way.iter().enumerate() {
                let section = lane.section();
                let keys: Vec<_> = way.iter().map(|lane| lane.key().to_string()).collect();
                assert_eq!(
                    hole(&view, lane),
                    None,
                    "{}: lane {} ({i}, {:?} m) of {keys:?}; {:?}",
                    file.display(),
                    lane.key(),
                    [section.s_start(), section.s_end()],
                    resolved.unplaced,
                );
                short += usize::from(length(lane) < SHORT);
            }
            (ways, lanes_passed) = (ways + 1, lanes_passed + way.len());
        }
    }
    say(&format!("{ways} lines along {lanes_passed} lanes, {short} of them below 0.1 m"));
}
