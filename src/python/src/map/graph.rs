//! The lane graph.

use super::Map;
use crate::batch::{columns, fields, result};
use crate::held::{content, id};
use crate::input::NONE_ID;
use crate::room::Column;
use mapd_client::SRange;
use mapd_client::graph::LaneNode;
use pyo3::prelude::*;

/// The row of a node, if any.
fn row(node: Option<LaneNode<'_>>) -> i64 {
    node.map_or(-1, |node| i64::from(node.node_id().row()))
}

#[pymethods]
impl Map {
    /// The graph that routes are searched on: lanes, or pieces of them, travelled in one direction, and how one goes on from each.
    fn lane_graph<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let map = self.map();
        let (nodes, edges) = py.detach(|| {
            let all: Vec<_> = map.lane_nodes().collect();
            let content = content(map);
            let numbers =
                |of: fn(&LaneNode<'_>) -> f64| Column::Numbers(all.iter().map(of).collect());
            let end = |high: bool| {
                let ends = all.iter().map(|node| {
                    let SRange { low: from, high: to } = node.s_range();
                    if node.is_forward() == high { to } else { from }
                });
                Column::Numbers(ends.collect())
            };
            let lane = |node: &LaneNode<'_>| {
                node.lane().map_or(NONE_ID, |lane| id(content, lane.lane_id().row()))
            };
            let nodes = vec![
                Column::Ids(all.iter().map(lane).collect()),
                Column::Flags(all.iter().map(LaneNode::is_forward).collect()),
                end(false),
                end(true),
                numbers(|node| node.length()),
                numbers(|node| node.travel_time()),
                Column::Counts(all.iter().map(|node| row(node.left())).collect()),
                Column::Counts(all.iter().map(|node| row(node.right())).collect()),
                Column::Flags(all.iter().map(|node| node.change_left().is_some()).collect()),
                Column::Flags(all.iter().map(|node| node.change_right().is_some()).collect()),
                Column::Counts(all.iter().map(|node| i64::from(node.component())).collect()),
            ];
            let (mut start, mut to) = (Vec::new(), Vec::new());
            let (mut kind, mut loops) = (Vec::new(), Vec::new());
            for (number, node) in all.iter().enumerate() {
                for edge in node.edges() {
                    start.push(number as i64);
                    to.push(row(edge.target()));
                    kind.push(edge.kind().code() as i8);
                    loops.push(edge.closes_loop());
                }
            }
            let edges = vec![
                Column::Counts(start),
                Column::Counts(to),
                Column::Codes(kind),
                Column::Flags(loops),
            ];
            (nodes, edges)
        });
        let fields = fields!(
            py,
            nodes = columns(py, "LaneNodes", nodes)?,
            edges = columns(py, "LaneEdges", edges)?,
        );
        result(py, "LaneGraph", &fields)
    }
}
