//! Conflicts against looking at points: where two lanes of a junction both cover a point, they conflict there.

use mapd_client::glam::DVec2;
use mapd_client::{Lane, Map, NearestOptions};
use mapd_query::SRange;
use mapd_tests::maps::{Random, carried_and, open};

/// Points on each map.
const POINTS: usize = 4000;
/// A point this far `[m]` inside both lanes lies in more than the strip that two lanes may share.
const INSIDE: f64 = 0.1;

/// Lanes of connecting roads that somebody travels and that cover a point with some room, with s there.
fn covering<'a>(
    map: Map<'a>,
    point: DVec2,
    near: &mut Vec<mapd_query::Nearest>,
) -> Vec<(Lane<'a>, f64)> {
    let options = NearestOptions { radius: 0.01, ..NearestOptions::default() };
    map.lanes_near(point, &options, near).expect("an answer");
    near.iter()
        .filter_map(|hit| {
            let lane = map.lane(hit.lane).expect("known");
            lane.road().junction()?;
            let p = hit.position;
            let edges = lane.edges_at(p.s);
            let room = (p.t - edges.inner).abs().min((p.t - edges.outer).abs());
            let section = lane.section();
            let ends = (p.s - section.s_start()).min(section.s_end() - p.s);
            let covers = p.distance == 0.0 && room >= INSIDE && ends >= INSIDE;
            (covers && lane.nodes().any(|node| node.is_open())).then_some((lane, p.s))
        })
        .collect()
}

#[test]
fn where_two_lanes_cover_a_point_they_conflict() {
    let mut random = Random(17);
    let mut seen = 0;
    for path in carried_and(&[
        "carla/Town01",
        "carla/Town05",
        "esmini/multi_intersections",
        "bark/4way_intersection",
    ]) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let inside: Vec<Lane<'_>> =
            map.lanes().filter(|lane| lane.road().junction().is_some()).collect();
        let mut near = Vec::new();
        for _ in 0..if inside.is_empty() { 0 } else { POINTS } {
            let lane = &inside[(random.unit() * inside.len() as f64) as usize];
            let s = random.between(lane.section().s_start(), lane.section().s_end());
            let pose = lane.pose_at(s, random.between(-1.5, 1.5)).expect("a pose");
            let covering = covering(map, pose.position.truncate(), &mut near);
            for (a, s_a) in &covering {
                for (b, s_b) in &covering {
                    let junction =
                        |lane: &Lane<'_>| lane.road().junction().map(|j| j.junction_id());
                    let shares = |x: &[_], y: &[_]| x.iter().any(|lane| y.contains(lane));
                    let all = |lanes: &dyn Fn(&Lane<'_>) -> Vec<_>| shares(&lanes(a), &lanes(b));
                    let merge = all(&|lane| lane.successors().collect());
                    let part = all(&|lane| lane.predecessors().collect());
                    let apart = (a.pose_at(*s_a, 0.0).expect("a pose").position.z
                        - b.pose_at(*s_b, 0.0).expect("a pose").position.z)
                        .abs()
                        > 1.5;
                    if a.road().road_id() == b.road().road_id()
                        || junction(a) != junction(b)
                        || (part && !merge)
                        || apart
                    {
                        continue;
                    }
                    seen += 1;
                    let conflict = a
                        .conflicts()
                        .find(|c| c.other().is_some_and(|other| other.lane_id() == b.lane_id()));
                    let conflict = conflict.unwrap_or_else(|| {
                        panic!(
                            "{}: {} and {} both cover {}",
                            path.display(),
                            a.key(),
                            b.key(),
                            pose.position
                        )
                    });
                    // Cells end at chords: a little beyond counts too.
                    let within = |s: f64, on: SRange| s >= on.low - 0.1 && s <= on.high + 0.1;
                    assert!(
                        within(*s_a, conflict.s_range()) && within(*s_b, conflict.other_range()),
                        "{} at {s_a} of {:?}, {} at {s_b} of {:?}",
                        a.key(),
                        conflict.s_range(),
                        b.key(),
                        conflict.other_range()
                    );
                }
            }
        }
        // Seen from the other side a conflict is the same.
        for lane in map.lanes() {
            for conflict in lane.conflicts() {
                let other = conflict.other().expect("a lane");
                let back = other
                    .conflicts()
                    .find(|c| c.other().map(|l| l.lane_id()) == Some(lane.lane_id()));
                let back = back.expect("both sides");
                assert_eq!(
                    (back.kind(), back.s_range(), back.other_range()),
                    (conflict.kind(), conflict.other_range(), conflict.s_range())
                );
            }
        }
    }
    assert!(seen > 1000, "only {seen} pairs were seen");
}
