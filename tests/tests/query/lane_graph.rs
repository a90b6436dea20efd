//! The lane graph against a slow, literal reader of the links; its own mirror; independence of the file's order.

use mapd_client::glam::DVec3;
use mapd_client::{Map, Snapshot};
use mapd_compiler::{CompileOptions, Diagnostic, compile};
use mapd_query::graph::LaneNode;
use mapd_query::vocabulary::{EdgeKind, VehicleClass};
use mapd_query::{NodeId, Track};
use mapd_tests::ends;
use mapd_tests::literal::{Element, Node, successors};
use mapd_tests::maps::Random;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Distance of linked lanes that is a finding `[m]`.
const GAP: f64 = 0.1;
/// Findings of one rule that are told one by one.
const NAMED: usize = 100;

fn open(text: &str) -> Option<Snapshot> {
    open_with_findings(text).map(|(snapshot, _)| snapshot)
}

fn open_with_findings(text: &str) -> Option<(Snapshot, Vec<Diagnostic>)> {
    let compiled =
        compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let archive = mapd_archive::encode(&compiled.rows?, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).expect("verifies");
    Some((Snapshot::from_bytes(archive).expect("opens"), compiled.diagnostics))
}

fn name(node: &LaneNode<'_>) -> Node {
    let lane = node.lane().expect("a lane");
    let key = lane.key();
    (key.road.into_owned(), key.section as usize, key.lane, node.is_forward())
}

/// Whether an edge joins two pieces of one lane.
fn is_within(edge: &mapd_query::graph::LaneEdge<'_>) -> bool {
    edge.kind() == EdgeKind::Within
}

fn graph(map: Map<'_>) -> BTreeMap<Node, BTreeSet<Node>> {
    let mut out: BTreeMap<Node, BTreeSet<Node>> = BTreeMap::new();
    for node in map.lane_nodes() {
        let to = node.edges().filter(|edge| !is_within(edge));
        // Edges over places inside roads are looked at on maps of their own.
        let to = to.filter(|e| !matches!(e.kind(), EdgeKind::Virtual | EdgeKind::CrossPath));
        let names = to.map(|edge| name(&edge.target().expect("a node")));
        out.entry(name(&node)).or_default().extend(names);
    }
    out
}

fn check_literal(what: &str, text: &str, map: Map<'_>) {
    let (found, expected) = (graph(map), successors(&Element::parse(text)));
    for (node, to) in &expected {
        assert_eq!(found.get(node), Some(to), "{what}: successors of {node:?}");
    }
    assert_eq!(found.len(), expected.len(), "{what}: nodes");
}

/// Forward and backward rows say the same, and so do lanes and nodes.
fn check_mirror(what: &str, map: Map<'_>) {
    let id = |node: LaneNode<'_>| node.node_id();
    let mut forward: Vec<(NodeId, NodeId)> = Vec::new();
    let mut backward: Vec<(NodeId, NodeId)> = Vec::new();
    for node in map.lane_nodes() {
        forward.extend(node.edges().map(|edge| (id(node), id(edge.target().expect("a node")))));
        backward.extend(node.predecessors().map(|from| (id(from), id(node))));
        for (to, is_left) in [(node.left(), true), (node.right(), false)] {
            let Some(to) = to else { continue };
            let back = if is_left { to.right() } else { to.left() };
            assert_eq!(back.map(id), Some(id(node)), "{what}: beside {:?}", name(&node));
            assert_eq!(to.s_range(), node.s_range(), "{what}: pieces beside {:?}", name(&node));
        }
    }
    forward.sort();
    backward.sort();
    assert!(forward == backward, "{what}: forward and backward edges differ");
    for lane in map.lanes() {
        let own: BTreeSet<_> = lane
            .nodes()
            .filter(|node| node.is_forward() == lane.is_forward())
            .flat_map(|node| node.edges().filter(|e| !is_within(e)).collect::<Vec<_>>())
            .map(|edge| edge.target().and_then(|n| n.lane()).expect("a lane").lane_id())
            .collect();
        assert_eq!(own, lane.successors().collect(), "{what}: {}", lane.key());
        for to in lane.predecessors() {
            let before = map.lane(to).expect("known");
            let mut all = before.nodes().flat_map(|n| n.edges().collect::<Vec<_>>());
            let leads = all.any(|e| {
                e.target().and_then(|n| n.lane()).map(|l| l.lane_id()) == Some(lane.lane_id())
            });
            assert!(leads, "{what}: {} before {}", before.key(), lane.key());
        }
    }
}

/// Without the edges that close loops the graph can be put in order, and components ascend along every edge.
fn check_order_of_travel(what: &str, map: Map<'_>) {
    let edges = || map.lane_nodes().flat_map(|node| node.edges());
    let row = |node: Option<LaneNode<'_>>| node.expect("a node").node_id().row() as usize;
    let mut waiting = vec![0usize; map.lane_nodes().len()];
    for edge in edges() {
        let (from, to) = (edge.source().expect("a node"), edge.target().expect("a node"));
        assert!(from.component() <= to.component(), "{what}: {:?}", name(&from));
        waiting[row(Some(to))] += usize::from(!edge.closes_loop());
    }
    let all: Vec<LaneNode<'_>> = map.lane_nodes().collect();
    let mut open: Vec<usize> = (0..all.len()).filter(|node| waiting[*node] == 0).collect();
    let mut done = 0;
    while let Some(node) = open.pop() {
        done += 1;
        for edge in all[node].edges().filter(|edge| !edge.closes_loop()) {
            let to = row(edge.target());
            waiting[to] -= 1;
            if waiting[to] == 0 {
                open.push(to);
            }
        }
    }
    assert_eq!(done, all.len(), "{what}: a cycle without an edge that closes it");
}

/// What an edge says of itself is what its node and lane say.
fn check_edges(what: &str, map: Map<'_>) {
    for node in map.lane_nodes() {
        let (lane, (from, to)) = (node.lane().expect("a lane"), ends(node.s_range()));
        let end = if node.is_forward() { to } else { from };
        for edge in node.edges() {
            let target = edge.target().expect("a node");
            assert_eq!(edge.source().map(|n| n.node_id()), Some(node.node_id()), "{what}");
            assert_eq!(edge.length(), node.length(), "{what}");
            assert_eq!(edge.speed_limit(), lane.speed_rule_at(end).max, "{what}");
            let classes = VehicleClass::ALL.iter();
            for class in classes {
                let both = node.allows(*class) && target.allows(*class);
                assert_eq!(edge.allows(*class), both, "{what}");
            }
            assert_eq!(
                edge.source_position().is_none(),
                is_within(&edge),
                "{what}: {:?}",
                name(&node)
            );
        }
    }
}

/// Distance of the nearest corners of two cross-sections from each other, seen from the corners of either.
fn gap(a: [DVec3; 2], b: [DVec3; 2]) -> f64 {
    // The nearest of many places on one to many on the other: slow, and not how the compiler does it.
    let places = |[from, to]: [DVec3; 2]| (0..=200).map(move |i| from.lerp(to, i as f64 / 200.0));
    places(a).flat_map(|p| places(b).map(move |q| p.distance(q))).fold(f64::INFINITY, f64::min)
}

/// Lanes that are linked meet, or there is a finding at the link.
fn check_gaps(what: &str, map: Map<'_>, findings: &[Diagnostic]) {
    let told: BTreeSet<(u32, u32)> = findings
        .iter()
        .filter(|d| d.finding.rule == "mapd:graph.gap")
        .map(|d| (d.line, d.column))
        .collect();
    let end = |node: &LaneNode<'_>, exit: bool| {
        let (lane, (from, to)) = (node.lane()?, ends(node.s_range()));
        let s = if node.is_forward() == exit { to } else { from };
        let edges = lane.edges_at(s);
        let at = |t| Some(lane.road().to_inertial(Track { s, t, h: 0.0 }).ok()?.position);
        Some([at(edges.inner)?, at(edges.outer)?])
    };
    for node in map.lane_nodes() {
        let joints =
            node.edges().filter(|e| !matches!(e.kind(), EdgeKind::Within | EdgeKind::CrossPath));
        for edge in joints {
            let target = edge.target().expect("a node");
            let (Some(a), Some(b)) = (end(&node, true), end(&target, false)) else { continue };
            // Corners that meet are the rule; only others are worth a closer look.
            let corners = a.iter().flat_map(|p| b.iter().map(move |q| p.distance(*q)));
            let near = corners.fold(f64::INFINITY, f64::min) <= GAP;
            let lane = node.lane().expect("a lane");
            let walks_back = !lane.is_bidirectional() && lane.is_forward() != node.is_forward();
            if near || walks_back || told.len() >= NAMED || gap(a, b) <= GAP {
                continue;
            }
            let place = edge.source_position().expect("a place");
            let place = (place.line, place.column);
            assert!(told.contains(&place), "{what}: {:?} to {:?}", name(&node), name(&target));
        }
    }
}

/// Everything about the graph by names: what must not depend on the order of elements.
fn by_name(map: Map<'_>) -> Vec<String> {
    let piece = |node: LaneNode<'_>| format!("{:?}{:?}", name(&node), node.s_range());
    let beside = |node: Option<LaneNode<'_>>| node.map(|n| format!("{:?}", name(&n)));
    let mut out: Vec<String> = map
        .lane_nodes()
        .map(|node| {
            let edges: Vec<String> = node
                .edges()
                .map(|e| {
                    let to = piece(e.target().expect("a node"));
                    format!("{to} {:?} {}", e.kind(), e.closes_loop())
                })
                .collect();
            let lane = node.lane().expect("a lane");
            let conflicts: BTreeSet<String> = lane
                .conflicts()
                .map(|c| {
                    let other = c.other().expect("a lane").key().to_string();
                    format!("{other} {:?} {:?} {:?}", c.kind(), c.s_range(), c.other_range())
                })
                .collect();
            format!(
                "{} {edges:?} left {:?} {:?} right {:?} {:?} {} {} component {} {conflicts:?}",
                piece(node),
                beside(node.left()),
                beside(node.change_left()),
                beside(node.right()),
                beside(node.change_right()),
                node.length(),
                node.travel_time(),
                node.component(),
            )
        })
        .collect();
    out.sort();
    out
}

/// The document with its roads and junctions in another order.
fn shuffled(text: &str, seed: u64) -> String {
    let mut random = Random(seed);
    let (mut rest, mut parts, mut frame) = (text, Vec::new(), String::new());
    let next = |rest: &str| {
        let starts = [("<road ", "</road>"), ("<junction ", "</junction>")];
        starts.iter().filter_map(|(a, z)| Some((rest.find(a)?, *z))).min()
    };
    let mut place = None;
    while let Some((start, end)) = next(rest) {
        let Some(length) = rest[start..].find(end).map(|at| at + end.len()) else { break };
        frame += &rest[..start];
        place = place.or(Some(frame.len()));
        parts.push(&rest[start..start + length]);
        rest = &rest[start + length..];
    }
    for i in (1..parts.len()).rev() {
        parts.swap(i, (random.unit() * (i + 1) as f64) as usize);
    }
    let place = place.unwrap_or(0);
    let (head, tail) = frame.split_at(place);
    format!("{head}{}{tail}{rest}", parts.concat())
}

fn check_order(what: &str, text: &str, map: Map<'_>) {
    let expected = by_name(map);
    let other = open(&shuffled(text, 5)).unwrap_or_else(|| panic!("{what} is accepted shuffled"));
    let found = by_name(other.map());
    for (a, b) in expected.iter().zip(&found) {
        assert_eq!(a, b, "{what}: shuffled");
    }
    assert_eq!(expected.len(), found.len(), "{what}: shuffled");
}

fn all_maps(mut check: impl FnMut(&str, &str)) {
    let folder = mapd_tests::workspace().join("examples/maps");
    let read = |path: &Path| {
        String::from_utf8_lossy(&std::fs::read(path).expect("the map can be read")).into_owned()
    };
    let mut carried: Vec<_> =
        std::fs::read_dir(folder).expect("maps").flatten().map(|entry| entry.path()).collect();
    carried.sort();
    for path in carried {
        check(&path.display().to_string(), &read(&path));
    }
    for map in mapd_tests::graph_maps::all() {
        check(map.name, &map.text);
    }
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace");
        return;
    };
    for (name, path) in corpus {
        check(&name, &read(&path));
    }
}

#[test]
fn as_a_literal_reader_finds_it_mirrored_and_in_any_order() {
    all_maps(|what, text| {
        // Maps that are rejected have no graph.
        if let Some((snapshot, findings)) = open_with_findings(text) {
            check_order_of_travel(what, snapshot.map());
            check_edges(what, snapshot.map());
            check_gaps(what, snapshot.map(), &findings);
            check_literal(what, text, snapshot.map());
            check_mirror(what, snapshot.map());
            check_order(what, text, snapshot.map());
        }
    });
}
