//! Queries in a process that is attached and warm, each timed by itself.

use super::figures::{Comparison, keep};
use super::places::{ends, places};
use mapd_client::compiling::ByRow as _;
use mapd_client::route::{RouteScratch, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, NearestOptions};
use std::time::{Duration, Instant};

/// Queries in a row on one side before it is the other's turn: what disturbs the machine disturbs both.
const TURN: usize = 128;

/// Pairs of places that are tried for each route.
const TRIES: usize = 20;

/// The same map on both sides.
#[derive(Clone, Copy)]
pub(crate) struct OnBoth<'a> {
    /// In shared memory.
    pub(crate) shared: Map<'a>,
    /// In a file that is mapped.
    pub(crate) file: Map<'a>,
}

/// How many queries of each kind are asked.
#[derive(Clone, Copy)]
pub(crate) struct Counts {
    pub(crate) queries: usize,
    pub(crate) routes: usize,
}

/// Every kind of query on both sides; kinds that the map has nothing for are left out.
pub(crate) fn compare(maps: OnBoth<'_>, counts: Counts) -> Vec<Comparison> {
    let Counts { queries, routes } = counts;
    let options = NearestOptions::default();
    let mut out = Vec::new();
    out.extend(run("clock alone", maps, &vec![(); queries], |_, ()| ()));
    for (along, [nearest, to_track, to_inertial]) in [
        (false, ["nearest lane, random", "x,y to s,t, random", "s,t to x,y,z, random"]),
        (true, ["nearest lane, trajectory", "x,y to s,t, trajectory", "s,t to x,y,z, trajectory"]),
    ] {
        let places = places(maps.shared, along, queries);
        out.extend(run(nearest, maps, &places, |map, place| {
            keep(map.nearest_lane(place.point(), &options));
        }));
        out.extend(run(to_track, maps, &places, |map, place| {
            let road = map.road_by_row(place.road);
            keep(road.map(|road| road.to_track(place.point())));
        }));
        out.extend(run(to_inertial, maps, &places, |map, place| {
            let road = map.road_by_row(place.road);
            keep(road.map(|road| road.to_inertial(place.track)));
        }));
    }
    let mut scratch = RouteScratch::with_capacity(maps.shared.lane_nodes().len());
    let mut steps = Vec::new();
    let cost = ShortestLength::default();
    let car = VehicleClass::PassengerCar;
    // Ends between which there is a way; of a map in many pieces, as many as are found.
    let mut pairs = ends(maps.shared, routes.saturating_mul(TRIES));
    let mut found = 0;
    pairs.retain(|[from, to]| {
        let wanted = found < routes && {
            let route = maps.shared.route(*from, *to, car, &cost, &mut scratch, &mut steps);
            matches!(route, Ok(Some(_)))
        };
        found += usize::from(wanted);
        wanted
    });
    out.extend(run("route by length", maps, &pairs, |map, [from, to]| {
        keep(map.route(*from, *to, car, &cost, &mut scratch, &mut steps));
    }));
    out
}

/// Asks everything once on each side, so that pages and caches are warm, then times it in turns.
fn run<T>(
    what: &'static str,
    maps: OnBoth<'_>,
    inputs: &[T],
    mut query: impl FnMut(Map<'_>, &T),
) -> Option<Comparison> {
    for map in [maps.shared, maps.file] {
        inputs.iter().for_each(|input| query(map, input));
    }
    let mut time = |map: Map<'_>, inputs: &[T], times: &mut Vec<Duration>| {
        for input in inputs {
            let start = Instant::now();
            query(map, input);
            times.push(start.elapsed());
        }
    };
    let (mut shared, mut file) = (Vec::new(), Vec::new());
    for (turn, inputs) in inputs.chunks(TURN).enumerate() {
        // The second one finds the inputs in the caches: each is second equally often.
        if turn % 2 == 0 {
            time(maps.shared, inputs, &mut shared);
            time(maps.file, inputs, &mut file);
        } else {
            time(maps.file, inputs, &mut file);
            time(maps.shared, inputs, &mut shared);
        }
    }
    Comparison::new(what, shared, file)
}
