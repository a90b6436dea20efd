//! Questions about routes by request: several starts and goals, a lane to avoid, costs of turns, alternatives, the network ahead.

use crate::along::steps;
use crate::numbers::Numbers;
use crate::{Asker, Result};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteEnd, RouteRequest, RouteScratch, Routes,
    ShortestLength, WithTurns,
};
use mapd_client::vocabulary::VehicleClass;

impl Asker<'_> {
    pub(crate) fn requests(&mut self, scratch: &mut RouteScratch) -> Result<()> {
        let map = self.map;
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        // Two starts and two goals; of one the direction is given, of one what it costs to be there.
        let mut ends = Vec::new();
        for number in 0..4 {
            let (lane, s) = self.place();
            let cost = if number % 2 == 1 { self.random.between(0.0, 50.0) } else { 0.0 };
            let forward = (number == 2).then(|| lane.is_forward());
            q.id(lane.lane_id().to_bits()).f(s).f(cost);
            q.u(forward.map_or(0u64, |forward| if forward { 1 } else { 2 }));
            let place = PositionOnLane { lane: lane.lane_id(), s };
            ends.push(RouteEnd { place, forward, cost });
        }
        let avoid = [self.random.one_of(&self.lanes).lane_id()];
        let (turn, limit) = (self.random.between(0.0, 30.0), self.random.between(10.0, 150.0));
        q.id(avoid[0].to_bits()).f(turn).f(limit);
        let cost = WithTurns {
            base: ShortestLength::default(),
            left: turn,
            right: 0.5 * turn,
            back: 90.0,
        };
        let (starts, goals) = ends.split_at(2);
        let vehicle = VehicleClass::PassengerCar;
        let request = RouteRequest { starts, goals, vehicle, cost: &cost, avoid: &avoid };
        let mut own = Vec::new();
        let found = map.find_route(&request, scratch, &mut own)?;
        a.u(u64::from(found.is_some()));
        if let Some(route) = found {
            a.f(route.cost).f(route.length).u(route.start as u64).u(route.goal as u64);
            steps(&mut a, &own);
        }
        let mut routes = Routes::default();
        map.alternatives(&request, &AlternativeOptions::default(), scratch, &mut routes)?;
        a.u(routes.iter().len() as u64);
        for (route, own) in routes.iter() {
            a.f(route.cost);
            steps(&mut a, own);
        }
        let mut reach = Reach::default();
        for to in [false, true] {
            if to {
                map.reach_to(&request, limit, scratch, &mut reach)?;
            } else {
                map.reach(&request, limit, scratch, &mut reach)?;
            }
            a.u(reach.reached().len() as u64);
            for (number, one) in reach.reached().iter().enumerate() {
                a.id(one.lane.to_bits()).u(u64::from(one.forward)).f(one.cost);
                a.f(one.s_from.min(one.s_to)).f(one.s_from.max(one.s_to)).u(one.lane_changes);
                a.u(reach.links(number).len() as u64);
                for link in reach.links(number) {
                    a.u(link.to as u64).u(link.enter as u64);
                }
            }
        }
        self.write("request", &q, &a);
        Ok(())
    }
}
