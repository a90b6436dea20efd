//! A start on a closed lane: who is on it leaves it at its end or to its sides, however other entries cut it; who is not does not enter it.

use crate::overlays::{at, lane_id, with};
use mapd_query::path::{PathBuffer, PathOptions};
use mapd_query::route::{
    AlternativeOptions, Enter, PositionOnLane, Reach, RouteRequest, RouteScratch, Routes,
    ShortestLength,
};
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;

const CAR: VehicleClass = VehicleClass::PassengerCar;

/// What is said of lanes of the road: kind, lane, from where to where.
type Said<'t> = &'t [(&'t str, i32, [u32; 2])];

/// Length and changes of lane of the way under what is said, by every kind of search.
fn check(said: Said<'_>, (from, to): ((i32, f64), (i32, f64)), expected: Option<(f64, u32)>) {
    let entry = |(i, (kind, lane, [from, to])): (usize, &(&str, i32, [u32; 2]))| {
        let value = if *kind == "speed" { r#","value":5"# } else { "" };
        format!(
            r#"{{"id":"{i}","kind":"{kind}"{value},"lanes":[{{"road":"A","s":[{from},{to}],"lane":{lane}}}]}}"#
        )
    };
    let all: Vec<String> = said.iter().enumerate().map(entry).collect();
    let text = format!(r#"{{"entries":[{}]}}"#, all.join(","));
    with(&text, at(0.0), |view| {
        let what = format!("{said:?} from {from:?} to {to:?}");
        let place = |(lane, s)| PositionOnLane { lane: lane_id(view.map(), lane), s };
        let (starts, goals) = ([place(from).into()], [place(to).into()]);
        let cost = ShortestLength::default();
        let request =
            RouteRequest { starts: &starts, goals: &goals, vehicle: CAR, cost: &cost, avoid: &[] };
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let found = view.find_route(&request, &mut scratch, &mut steps).expect("an answer");
        assert_eq!(found.map(|route| (route.length, route.lane_changes)), expected, "{what}");
        for share in [0.0, 0.3] {
            let (options, mut routes) =
                (AlternativeOptions { share, ..AlternativeOptions::default() }, Routes::default());
            view.alternatives(&request, &options, &mut scratch, &mut routes).expect("routes");
            assert_eq!(routes.iter().next().map(|(route, _)| *route), found, "{what}");
        }
        let mut network = Reach::default();
        view.reach(&request, 1e3, &mut scratch, &mut network).expect("a network");
        let (goal, s) = (lane_id(view.map(), to.0), to.1);
        let reaches = network.reached().iter().any(|one| {
            one.lane == goal && (one.s_from.min(one.s_to)..=one.s_from.max(one.s_to)).contains(&s)
        });
        // One may go to where one stands on a closed lane, though not as to a goal.
        let on_own = view.allows(goal, s, CAR).is_ok_and(|answer| !answer.is_allowed);
        assert_eq!(reaches, expected.is_some() || on_own, "{what}: {:?}", network.reached());
        for (i, own) in network.reached().iter().enumerate() {
            let is_closed = |s: f64| view.allows(own.lane, s, CAR).is_ok_and(|one| !one.is_allowed);
            let closed = is_closed(0.5 * (own.s_from + own.s_to));
            let entries = (0..network.reached().len()).flat_map(|from| {
                network
                    .links(from)
                    .iter()
                    .filter(|link| link.to == i)
                    .map(move |link| (from, link.enter))
            });
            for (from, enter) in entries.filter(|_| closed) {
                let stays = network.reached()[from].lane == own.lane && enter == Enter::Ahead;
                assert!(stays, "{what}: {own:?} is entered from {from}");
            }
        }
        ahead_on_lane(view, place(from), place(to), expected, &what);
    });
}

/// Where no change of lane is needed, the lane itself leads on along the path to an open goal.
fn ahead_on_lane(
    view: View<'_>,
    from: PositionOnLane,
    to: PositionOnLane,
    expected: Option<(f64, u32)>,
    what: &str,
) {
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let cost = ShortestLength::default();
    let plain = view.map().route(from, to, CAR, &cost, &mut scratch, &mut steps).expect("a way");
    let is_open = view.allows(to.lane, to.s, CAR).expect("an answer").is_allowed;
    if !is_open || plain.is_none_or(|route| route.lane_changes > 0) {
        return;
    }
    let (mut buffer, mut segments) = (PathBuffer::default(), Vec::new());
    let path = view.map().path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    view.segments_on_path(&path, CAR, &mut segments).expect("an answer");
    let leads = segments.iter().any(|one| one.along[0] == 0.0 && one.driven && one.changes == 0);
    assert_eq!(leads, expected.is_some_and(|(_, changes)| changes == 0), "{what}: {segments:?}");
}

#[test]
fn a_closed_lane_is_left_however_it_is_cut() {
    let there = ((-1, 10.0), (-1, 90.0));
    let closed = |lane, s| ("closed", lane, s);
    check(&[closed(-1, [0, 50])], there, Some((80.0, 0)));
    // What is said of the lane beside it cuts it, too.
    check(&[closed(-1, [0, 50]), ("speed", -2, [20, 30])], there, Some((80.0, 0)));
    check(&[closed(-1, [0, 50]), closed(-2, [0, 100])], there, Some((80.0, 0)));
    check(&[closed(-1, [0, 25]), closed(-1, [25, 50])], there, Some((80.0, 0)));
    check(
        &[closed(-1, [0, 25]), closed(-1, [25, 50]), closed(-2, [0, 30])],
        there,
        Some((80.0, 0)),
    );
    // The lane beside it opens only next to a further piece.
    let beside = ((-1, 10.0), (-2, 90.0));
    check(
        &[closed(-1, [0, 25]), closed(-1, [25, 100]), closed(-2, [0, 30])],
        beside,
        Some((80.0, 1)),
    );
    // Against s.
    let back = ((1, 90.0), (1, 10.0));
    check(&[closed(1, [50, 75]), closed(1, [75, 100]), closed(2, [60, 70])], back, Some((80.0, 0)));
}

#[test]
fn a_closed_lane_is_not_entered() {
    let there = ((-1, 10.0), (-1, 90.0));
    let closed = |lane, s| ("closed", lane, s);
    check(&[closed(-1, [20, 30]), closed(-2, [0, 100])], there, None);
    check(&[closed(-1, [20, 30]), closed(-1, [30, 50]), closed(-2, [0, 100])], there, None);
    // It ends, and begins again.
    check(&[closed(-1, [0, 30]), closed(-1, [40, 50]), closed(-2, [0, 100])], there, None);
    // The goal may not be on one.
    check(&[closed(-1, [0, 50]), ("speed", -2, [20, 30])], ((-1, 10.0), (-1, 40.0)), None);
}
