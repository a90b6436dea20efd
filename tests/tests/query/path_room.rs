//! The room along a path: marks, what lies beyond, speed, surface, outline.

use crate::paths::each_path;
use mapd_client::QueryError;
use mapd_client::glam::DVec2;
use mapd_client::vocabulary::{RoadMarkKind, VehicleClass};
use mapd_query::path::{
    Corridor, CorridorEdges, EdgeKind, PathBuffer, PathOptions, steps_of_lanes,
};
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::open_text;
use std::cell::Cell;

const CAR: VehicleClass = VehicleClass::PassengerCar;

#[test]
fn a_stations_facts_are_those_of_its_place() {
    let compared = Cell::new(0);
    each_path(|map, path, _, name, _| {
        let mut room = Corridor::default();
        path.corridor(0.0, 400.0, 1.7, CAR, &mut room).expect("a corridor");
        assert!(room.surface.is_empty());
        path.corridor_surface(&mut room).expect("surfaces");
        assert_eq!(room.surface.len(), room.len(), "{name}");
        for i in 0..room.len() {
            assert_eq!(path.speed_at(room.along[i]), Some(room.speed[i]), "{name}: station {i}");
            let lane = map.lane(room.lane[i]).expect("its lane");
            let s = room.s[i];
            let inner = lane.inner().and_then(|inner| inner.road_mark_at(s));
            let mut known =
                [lane.road_mark_at(s), inner].map(|m| m.map_or(RoadMarkKind::None, |m| m.kind()));
            let mut told = [room.left_mark[i].kind, room.right_mark[i].kind];
            known.sort_by_key(|kind| kind.code());
            told.sort_by_key(|kind| kind.code());
            assert_eq!(told, known, "{name}: lane {}", lane.key());
            let end = [room.left_mark[i], room.right_mark[i]].map(|mark| mark.edge);
            if end.contains(&EdgeKind::RoadEnd) && lane.width_at(s) > 0.1 {
                let edges = lane.edges_at(s);
                let beyond = [edges.inner, edges.outer].map(|t| {
                    let out = if (t == edges.outer) == (edges.outer > edges.inner) {
                        0.02
                    } else {
                        -0.02
                    };
                    lane.section().lane_at(s, t + out)
                });
                let none = beyond.iter().any(|b| b.is_none_or(|b| b.lane_id() == lane.lane_id()));
                assert!(none, "{name}: lane {} at {s}", lane.key());
            }
            let (left, right, on) = (room.left[i], room.right[i], room.surface[i]);
            let middle = 0.5 * (left + right);
            let apart = on.position.truncate().distance(middle.truncate());
            assert!(apart < 0.5, "{name}: {apart} m at lane {}", lane.key());
            assert!((on.normal.length() - 1.0).abs() < 1e-9, "{name}");
            let edges = lane.edges_at(s);
            let there = lane.road().surface_at(s, 0.5 * (edges.inner + edges.outer));
            let there = there.expect("a surface");
            // Lanes without width, and those that lie over others, are not what the road finds there.
            if there.lane == Some(lane.lane_id()) {
                let friction = there.material.and_then(|material| material.friction);
                assert_eq!((on.position, on.normal), (there.position, there.normal), "{name}");
                assert_eq!(on.friction, friction, "{name}");
                compared.set(compared.get() + 1);
            }
        }
    });
    assert!(compared.get() > 1_000, "{} surfaces", compared.get());
}

/// Whether no two sides of a ring meet but neighbours: each pair is looked at.
fn is_simple(ring: &[DVec2]) -> bool {
    let n = ring.len();
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let on = |a: DVec2, b: DVec2, p: DVec2| {
        turn(a, b, p) == 0.0 && a.min(b).cmple(p).all() && p.cmple(a.max(b)).all()
    };
    for i in 0..n {
        for j in i + 1..n {
            let (a, b, c, d) = (ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]);
            let meets = if b == c {
                on(a, b, d) || on(c, d, a)
            } else if d == a {
                on(a, b, c) || on(c, d, b)
            } else {
                let (p, q) = (turn(a, b, c), turn(a, b, d));
                let (r, s) = (turn(c, d, a), turn(c, d, b));
                let cross = p * q < 0.0 && r * s < 0.0;
                cross || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)
            };
            if meets {
                return false;
            }
        }
    }
    n > 2
}

#[test]
fn an_outline_is_simple_where_it_says_so() {
    let counts = std::cell::Cell::new([0, 0]);
    each_path(|_, path, _, name, _| {
        let (mut room, mut ring) = (Corridor::default(), Vec::new());
        path.corridor(0.0, 200.0, 1.3, CAR, &mut room).expect("a corridor");
        for edges in [CorridorEdges::Driven, CorridorEdges::Open] {
            let simple = room.outline(edges, &mut ring);
            assert_eq!(simple, is_simple(&ring), "{name}: {edges:?}");
            // Where it is one line that bends less than it is wide, it only fails to be simple by meeting itself.
            let jumps = path.joints().iter().any(|joint| joint.along < 200.0 && joint.gap > 0.1);
            let bends = (0..room.len()).any(|i| {
                let at = path.at(room.along[i]).expect("a place");
                at.curvature.abs() * at.left.max(at.right) > 0.9
            });
            if edges == CorridorEdges::Driven && !jumps && !bends {
                let mut all = counts.get();
                all[usize::from(simple)] += 1;
                counts.set(all);
            }
            // Counter-clockwise.
            let area: f64 =
                (0..ring.len()).map(|i| ring[i].perp_dot(ring[(i + 1) % ring.len()])).sum();
            assert!(!simple || area > 0.0, "{name}: {area}");
        }
    });
    let [crossed, simple] = counts.get();
    assert!(simple > 10 * crossed.max(1), "{simple} simple outlines, {crossed} others");
}

/// The right edge of a lane 4 m wide, right of a line that bends to the right, folds where the line's radius is smaller.
#[test]
fn a_bend_tighter_than_the_lane_is_told() {
    for (radius, simple) in [(10.0, true), (4.5, true), (3.5, false), (2.5, false)] {
        let own = wide(-1, "", "", "a=\"4\" b=\"0\" c=\"0\" d=\"0\"", "");
        let line = Line(0.0, 0.0, 0.0, 3.0, -1.0 / radius);
        let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &own)));
        let snapshot = open_text(&text);
        let map = snapshot.map();
        let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
        let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
        steps_of_lanes(map, &[lane.lane_id()], [0.0, 3.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        let (mut room, mut ring) = (Corridor::default(), Vec::new());
        path.corridor(0.0, 100.0, 0.1, CAR, &mut room).expect("a corridor");
        assert_eq!(room.outline(CorridorEdges::Driven, &mut ring), simple, "radius {radius}");
    }
}

/// Beyond the lane: another one, a kerb by its type, by its mark, by its height, nothing.
#[test]
fn what_lies_beyond_an_edge() {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let sidewalk = |more: &str| {
        lane(-2, "")
            .replace("type=\"driving\"", "type=\"sidewalk\"")
            .replace("</lane>", &format!("{more}</lane>"))
    };
    let raised = "<height sOffset=\"0\" inner=\"0.12\" outer=\"0.12\"/>";
    let kerb = lane(-2, "").replace("type=\"driving\"", "type=\"curb\"");
    let marked = wide(-1, "", "", width, "<roadMark sOffset=\"0\" type=\"curb\"/>");
    let cases = [
        (lane(-1, ""), String::new(), EdgeKind::RoadEnd),
        (lane(-1, ""), sidewalk(""), EdgeKind::Lane),
        (lane(-1, ""), sidewalk(raised), EdgeKind::Kerb),
        (lane(-1, ""), kerb, EdgeKind::Kerb),
        (marked, String::new(), EdgeKind::Kerb),
    ];
    for (own, beyond, edge) in cases {
        let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
        let lanes = format!("{own}{beyond}");
        let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
        let snapshot = open_text(&text);
        let map = snapshot.map();
        let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
        let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
        steps_of_lanes(map, &[lane.lane_id()], [10.0, 20.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        let mut room = Corridor::default();
        path.corridor(0.0, 10.0, 5.0, CAR, &mut room).expect("a corridor");
        let told = [room.left_mark[1].edge, room.right_mark[1].edge];
        assert_eq!(told, [EdgeKind::RoadEnd, edge], "{lanes}");
    }
}

/// Stations are counted up to where the path ends: a length that means "to the end" is not refused for what lies beyond.
#[test]
fn stations_are_counted_on_the_path_alone() {
    each_path(|_, path, _, name, _| {
        let (mut whole, mut room) = (Corridor::default(), Corridor::default());
        let step = path.length() / 20.0;
        path.corridor(0.0, path.length(), step, CAR, &mut whole).expect("a corridor");
        path.corridor(0.0, f64::MAX, step, CAR, &mut room).expect("a corridor");
        assert_eq!(room.along, whole.along, "{name}");
        let refused = path.corridor(0.0, f64::MAX, path.length() * 1e-9, CAR, &mut room);
        assert_eq!(refused, Err(QueryError::Option("step")), "{name}");
    });
}
