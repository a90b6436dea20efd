//! The lane graph: nodes, edges, conflicts as they are stored, and the cost of routes.

use super::line::Lines;
use super::{at, key};
use mapd_client::Map;
use mapd_query::graph::LaneNode;
use mapd_query::route::{PositionOnLane, RouteCost, RouteScratch, ShortestLength, ShortestTime};
use mapd_query::vocabulary::{ConflictKind, Relation, RelationReason, VehicleClass};

/// Where a route begins and ends, as a share of its lane's section.
const MIDDLE: f64 = 0.5;

/// Lanes between which routes are asked for: each so many-th, from the first on.
const ROUTED: usize = 14;

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    for node in map.lane_nodes() {
        of_node(node, lines);
    }
    conflicts(map, lines);
    routes(map, lines, "length", &ShortestLength::default());
    routes(map, lines, "time", &ShortestTime::default());
}

fn name(node: LaneNode<'_>) -> String {
    let lane = node.lane().map(|lane| lane.key().to_string()).unwrap_or_default();
    let way = if node.is_forward() { "with s" } else { "against s" };
    format!("{lane} {:.3} {way}", node.s_range().low)
}

fn of_node(node: LaneNode<'_>, lines: &mut Lines) {
    let beside = [node.left(), node.right(), node.change_left(), node.change_right()];
    let classes = VehicleClass::ALL.iter().filter(|class| node.allows(**class));
    lines
        .about(format_args!("node {}", name(node)))
        .with("s", node.s_range())
        .with("length", node.length())
        .with("time", node.travel_time())
        .with("component", node.component())
        .with("open", node.is_open())
        .with("access", classes.map(|class| class.name()).collect::<Vec<_>>())
        .with("beside", beside.map(|node| node.map(name)))
        .with("from", node.predecessors().map(name).collect::<Vec<_>>());
    // As recorded: which limit holds is an answer, which may become better.
    let range = node.s_range();
    let end = if node.is_forward() { range.high } else { range.low };
    let limit = node.lane().and_then(|lane| lane.recorded_speed_limit_at(end));
    for edge in node.edges() {
        lines
            .about(format_args!("edge {}", edge.kind().name()))
            .with("to", edge.target().map(name))
            .with("loop", edge.closes_loop())
            .with("limit", limit)
            .with("at", edge.source_position().map(at))
            .with("file", edge.source_file());
    }
}

/// As the rows have them: who goes first by a rule of the road is an answer, which may become better.
fn conflicts(map: Map<'_>, lines: &mut Lines) {
    let lane = |row| map.lanes().find(|lane| lane.lane_id().row() == row);
    for row in map.tables().conflicts {
        let lanes = [lane(row.lane()), lane(row.other())];
        lines
            .about("conflict")
            .with("lanes", lanes.map(|lane| lane.map(|lane| lane.key().to_string())))
            .word("kind", ConflictKind::from_code(row.kind()).name())
            .word("relation", Relation::from_code(row.relation()).name())
            .word("reason", RelationReason::from_code(row.reason()).name());
    }
    for lane in map.lanes() {
        for conflict in lane.conflicts() {
            lines
                .about(format_args!("meets {}", conflict.kind().name()))
                .with("lane", lane.key().to_string())
                .with("other", conflict.other().map(|other| other.key().to_string()))
                .with("s", conflict.s_range())
                .with("other_s", conflict.other_range());
        }
    }
}

fn routes(map: Map<'_>, lines: &mut Lines, what: &str, cost: &impl RouteCost) {
    let drivable = map.lanes().filter(|lane| lane.nodes().any(|node| node.is_open()));
    let drivable: Vec<_> = drivable.collect();
    let places: Vec<_> = drivable.iter().step_by(drivable.len() / ROUTED + 1).collect();
    let place = |lane: &mapd_query::Lane<'_>| {
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        PositionOnLane { lane: lane.lane_id(), s: from + MIDDLE * (to - from) }
    };
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (from, to) in places.iter().flat_map(|a| places.iter().map(move |b| (place(a), place(b)))) {
        let car = VehicleClass::PassengerCar;
        let found = map.route(from, to, car, cost, &mut scratch, &mut steps);
        let Ok(Some(route)) = found else { continue };
        lines
            .about(format_args!("route by {what}"))
            .with("cost", route.cost)
            .with("length", route.length)
            .with("time", route.travel_time)
            .with("changes", route.lane_changes)
            .with("lanes", steps.iter().map(|step| key(map, step.lane)).collect::<Vec<_>>())
            .with("s", steps.iter().map(|step| [step.s_from, step.s_to]).collect::<Vec<_>>());
    }
}
