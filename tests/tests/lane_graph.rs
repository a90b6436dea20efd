//! The lane graph against a slow, literal reader of the links; its own mirror; independence of the file's order.

use mapd_client::{Map, Snapshot};
use mapd_compiler::{CompileOptions, compile};
use mapd_query::{EdgeKind, LaneNode, NodeId};
use mapd_tests::literal::{Element, Node, successors};
use mapd_tests::maps::Random;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

fn open(text: &str) -> Option<Snapshot> {
    let compiled =
        compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let archive = mapd_archive::encode(&compiled.rows?, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).expect("verifies");
    Some(Snapshot::from_bytes(archive).expect("opens"))
}

fn name(node: &LaneNode<'_>) -> Node {
    let lane = node.lane().expect("a lane");
    let key = lane.key();
    (key.road.into_owned(), key.section as usize, key.lane, node.is_forward())
}

/// Whether an edge joins two pieces of one lane.
fn is_within(edge: &mapd_query::LaneEdge<'_>) -> bool {
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
        if let Some(snapshot) = open(text) {
            check_literal(what, text, snapshot.map());
            check_mirror(what, snapshot.map());
            check_order(what, text, snapshot.map());
        }
    });
}
