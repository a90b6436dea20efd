//! Counts of the lane graph for `mapd inspect`.

use mapd_client::Map;
use mapd_query::Lane;
use mapd_query::vocabulary::{EdgeKind, VehicleClass};
use serde::Serialize;
use std::io::Write;

/// Counts of the lane graph.
#[derive(Serialize)]
pub(crate) struct GraphFacts {
    nodes: usize,
    /// By where they come from.
    edges: Vec<(&'static str, usize)>,
    lane_changes_left: usize,
    lane_changes_right: usize,
    /// Lanes that have one beside them which is travelled the other way.
    opposite_lanes: usize,
    conflicts: usize,
    components: u32,
    /// Components of more than one node: lawful loops.
    loops: usize,
    edges_that_close_loops: usize,
    /// Nodes open to passenger cars from which no way leads on.
    dead_ends: usize,
    landmarks: u32,
    bytes_per_lane: f64,
}

impl GraphFacts {
    pub(crate) fn of(map: Map<'_>) -> Self {
        let tables = map.tables();
        let graph = tables.graph.first();
        let components = graph.map_or(0, |row| row.components());
        let mut sizes = vec![0u32; components as usize];
        for node in map.lane_nodes() {
            if let Some(size) = sizes.get_mut(node.component() as usize) {
                *size += 1;
            }
        }
        let edges = || map.lane_nodes().flat_map(|node| node.edges());
        let count = |kind: EdgeKind| edges().filter(|edge| edge.kind() == kind).count();
        let bytes: usize = tables
            .infos()
            .iter()
            .filter(|t| {
                let graph = ["lane_nodes", "successor_offsets", "successors", "edges"];
                let more = ["predecessor_offsets", "predecessors", "conflicts"];
                let landmarks = ["graph", "landmark_lengths", "landmark_times"];
                graph.contains(&t.name) || more.contains(&t.name) || landmarks.contains(&t.name)
            })
            .map(|t| t.count * t.element_bytes)
            .sum();
        let car = |node: &mapd_query::graph::LaneNode<'_>| node.allows(VehicleClass::PassengerCar);
        Self {
            nodes: tables.lane_nodes.len(),
            edges: EdgeKind::ALL.iter().map(|kind| (kind.name(), count(*kind))).collect(),
            lane_changes_left: map.lane_nodes().filter(|n| n.change_left().is_some()).count(),
            lane_changes_right: map.lane_nodes().filter(|n| n.change_right().is_some()).count(),
            opposite_lanes: map.lanes().filter(|lane| lane.opposite().is_some()).count(),
            conflicts: tables.conflicts.len() / 2,
            components,
            loops: sizes.iter().filter(|size| **size > 1).count(),
            edges_that_close_loops: edges().filter(|edge| edge.closes_loop()).count(),
            dead_ends: map.lane_nodes().filter(|n| car(n) && n.edges().len() == 0).count(),
            landmarks: graph.map_or(0, |row| row.landmarks()),
            bytes_per_lane: bytes as f64 / map.lanes().count().max(1) as f64,
        }
    }

    pub(crate) fn print(&self, out: &mut dyn Write) -> std::io::Result<()> {
        let kinds: Vec<String> = self
            .edges
            .iter()
            .filter(|(_, count)| *count > 0)
            .map(|(name, count)| format!("{count} {name}"))
            .collect();
        writeln!(out, "lane graph    {} nodes; edges: {}", self.nodes, kinds.join(", "))?;
        writeln!(
            out,
            "              {} lane changes to the left, {} to the right; {} lanes with an opposite one; {} conflicts",
            self.lane_changes_left, self.lane_changes_right, self.opposite_lanes, self.conflicts
        )?;
        writeln!(
            out,
            "              {} components, {} of them loops, closed by {} edges; {} dead ends",
            self.components, self.loops, self.edges_that_close_loops, self.dead_ends
        )?;
        writeln!(
            out,
            "              {} landmarks; {:.0} bytes per lane",
            self.landmarks, self.bytes_per_lane
        )
    }
}

/// Longitudinal edges between lanes: what `successors` lists, over all lanes.
pub(crate) fn lane_links(map: Map<'_>) -> usize {
    map.lanes().map(|lane: Lane<'_>| lane.successors().count()).sum()
}
