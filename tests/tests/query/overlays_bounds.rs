//! Bounds of a search on pieces of a lane: a change of lane in the middle of a lane may save more than the lane itself takes.

use mapd_archive::open_overlay;
use mapd_client::Snapshot;
use mapd_query::graph::LaneNode;
use mapd_query::route::{PositionOnLane, RouteCost, RouteScratch, ShortestTime};
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_tests::graph_maps::{Line, document, lane, link, road, section, wide};
use mapd_tests::maps::open_text;
use mapd_tests::overlays::over;
use std::time::UNIX_EPOCH;

const CAR: VehicleClass = VehicleClass::PassengerCar;
const WIDTH: &str = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";

/// Roads S, A and E, one behind the other. On A lane −1 ends, lane −2 beside it leads on, as does lane −3, to which one changes on S only. Each has two speed limits, the second
/// from the middle on.
fn map_of(speeds: [[f64; 2]; 3]) -> Snapshot {
    let lane_of = |id: i32, links: &str, [first, second]: [f64; 2], [mark, change]: [&str; 2]| {
        let more = format!(
            r#"<roadMark sOffset="0" type="{mark}" laneChange="{change}"/><speed sOffset="0" max="{first}" unit="m/s"/><speed sOffset="500" max="{second}" unit="m/s"/>"#
        );
        wide(id, "", links, WIDTH, &more)
    };
    let two = |links: [&str; 2]| section(0.0, "", &(lane(-1, links[0]) + &lane(-2, links[1])));
    let middle = lane_of(-1, "p-1", speeds[0], ["broken", "both"])
        + &lane_of(-2, "s-1", speeds[1], ["solid", "none"])
        + &lane_of(-3, "p-2 s-2", speeds[2], ["solid", "none"]);
    let roads = [
        road(
            "S",
            "",
            Line(0.0, 0.0, 0.0, 50.0, 0.0),
            &link("s road A start"),
            &two(["s-1", "s-3"]),
        ),
        road(
            "A",
            "",
            Line(50.0, 0.0, 0.0, 1000.0, 0.0),
            &(link("p road S end") + &link("s road E start")),
            &section(0.0, "", &middle),
        ),
        road(
            "E",
            "",
            Line(1050.0, 0.0, 0.0, 50.0, 0.0),
            &link("p road A end"),
            &two(["p-2", "p-3"]),
        ),
    ];
    open_text(&document(&roads.concat()))
}

/// The shortest time without a bound.
struct WithoutBound(ShortestTime);

impl RouteCost for WithoutBound {
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        self.0.pass(node)
    }

    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        self.0.change(from, to)
    }
}

/// The cost of the fastest way from S to E under an overlay that cuts A's lanes, which Dijkstra's algorithm finds, too.
fn check(speeds: [[f64; 2]; 3], (closed, cuts): (i32, [f64; 2])) -> f64 {
    let snapshot = map_of(speeds);
    let map = snapshot.map();
    let [from, to] = cuts;
    let text = format!(
        r#"{{"entries":[{{"id":"works","kind":"closed","lanes":[{{"road":"A","s":[{from},{to}],"lane":{closed}}}]}}]}}"#
    );
    let (bytes, resolved) = over(map, &text, false);
    assert_eq!(resolved.unplaced, []);
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(map, Some(&overlay), UNIX_EPOCH).expect("its own");
    let place = |road: &str, s: f64| {
        let section = map.road_by_id(road).expect("a road").section(0).expect("a section");
        PositionOnLane { lane: section.lane(-1).expect("a lane").lane_id(), s }
    };
    let (start, goal) = (place("S", 10.0), place("E", 40.0));
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let cost = ShortestTime::default();
    let found = view.route(start, goal, CAR, &cost, &mut scratch, &mut steps).expect("an answer");
    let found = found.expect("a way").cost;
    let cost = WithoutBound(cost);
    let best = view.route(start, goal, CAR, &cost, &mut scratch, &mut steps).expect("an answer");
    assert_eq!(found, best.expect("a way").cost, "cut at {cuts:?}");
    found
}

#[test]
fn a_change_to_a_slower_lane_far_along_is_found() {
    let speeds = [[50.0; 2], [2.0; 2], [4.0; 2]];
    let cuts = [[100.0, 200.0], [300.0, 500.0], [500.0, 600.0], [700.0, 900.0]];
    let costs = cuts.map(|cuts| check(speeds, (-2, cuts)));
    // The later the fast lane may be left, the sooner one arrives.
    assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "{costs:?}");
    assert!(costs[3] < 0.5 * costs[0], "{costs:?}");
}

/// Lanes that take as long as each other, each fast where the other one is slow.
#[test]
fn the_fast_part_of_each_lane_is_found() {
    let cost = check([[50.0, 2.0], [2.0, 50.0], [5.0; 2]], (-2, [490.0, 500.0]));
    // 500 m on either at 50 m/s; on the third lane 200 s.
    assert!(cost < 60.0, "{cost}");
}
