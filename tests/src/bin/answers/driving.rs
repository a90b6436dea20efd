//! Questions about routes and paths.

use crate::numbers::{Numbers, clamped, hash, lane_bits, object_bits, signal_bits};
use crate::{Asker, Result};
use mapd_client::SRange;
use mapd_client::glam::DVec2;
use mapd_client::path::{Corridor, PathBuffer, PathOptions};
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestLength, ShortestTime};
use mapd_client::rules::LineSource;
use mapd_client::vocabulary::VehicleClass;

impl Asker<'_> {
    pub(crate) fn routes(&mut self, scratch: &mut RouteScratch) -> Result<()> {
        let map = self.map;
        let ((from, s_from), (to, s_to)) = (self.place(), self.place());
        let by_time = self.random.next() % 2;
        let places = [
            PositionOnLane { lane: from.lane_id(), s: s_from },
            PositionOnLane { lane: to.lane_id(), s: s_to },
        ];
        let (mut q, mut a, mut steps) = (Numbers::default(), Numbers::default(), Vec::new());
        q.id(from.lane_id().to_bits()).f(s_from).id(to.lane_id().to_bits()).f(s_to).u(by_time);
        let class = VehicleClass::PassengerCar;
        let route = if by_time == 1 {
            map.route_via(&places, class, &ShortestTime::default(), scratch, &mut steps)?
        } else {
            map.route_via(&places, class, &ShortestLength::default(), scratch, &mut steps)?
        };
        a.u(u64::from(route.is_some()));
        if let Some(route) = route {
            a.f(route.cost).f(route.length).f(route.travel_time).f(route.assumed_time);
            a.u(route.lane_changes);
            a.u(steps.len() as u64);
            for step in &steps {
                a.id(step.lane.to_bits()).u(u64::from(step.forward)).u(step.enter as u64);
                a.f(step.s_from).f(step.s_to).f(step.s_latest);
            }
            self.write("route", &q, &a);
            let (mut lines, mut a) = (Vec::new(), Numbers::default());
            map.lines_along(&steps, &mut lines)?;
            a.u(lines.len() as u64);
            for one in &lines {
                let (signal, object) = match one.line.source {
                    LineSource::Signal(signal) => (Some(signal), None),
                    LineSource::Object(object) => (None, Some(object)),
                };
                a.u(signal_bits(signal)).u(object_bits(object)).id(one.line.lane.to_bits());
                a.f(one.line.s).f(one.distance).u(one.line.class.code());
            }
            self.write("lines", &q, &a);
            self.path(&q, &steps)?;
            self.along(&q, &steps, scratch)?;
        } else {
            self.write("route", &q, &a);
        }

        let limit = self.random.between(10.0, 300.0);
        let (mut q, mut a, mut reached) = (Numbers::default(), Numbers::default(), Vec::new());
        map.reachable(places[0], limit, class, &ShortestLength::default(), scratch, &mut reached)?;
        a.u(reached.len() as u64);
        for one in &reached {
            let node = map.lane_node(one.node)?;
            let SRange { low: s_from, high: s_to } = node.s_range();
            a.u(lane_bits(node.lane())).u(u64::from(node.is_forward()));
            a.f(s_from).f(s_to).f(one.cost);
        }
        self.write("reachable", q.id(from.lane_id().to_bits()).f(s_from).f(limit), &a);
        Ok(())
    }

    /// A path along a route: the place at S, a point in its coordinates, its limit, its room and who crosses it.
    fn path(&mut self, route: &Numbers, steps: &[RouteStep]) -> Result<()> {
        let (map, mut buffer) = (self.map, PathBuffer::default());
        let Ok(path) = map.path(steps, &PathOptions::default(), &mut buffer) else { return Ok(()) };
        let length = path.length();
        let along = self.random.between(-1.0, length + 1.0);
        let at = path.at(along)?;
        let near = self.random.between(-3.0, 3.0);
        let left = DVec2::from_angle(at.heading).perp();
        let point = at.position.truncate() + left * near;
        let step = length / 7.0;
        let mut q = Numbers(route.0.clone());
        q.f(along).f(point.x).f(point.y).f(step);
        let mut a = Numbers::default();
        a.f(length).u(u64::from(path.is_broken())).lanes(path.lanes().map(|own| own.lane));
        a.f(at.along).v(at.position).f(at.heading).f(at.curvature).f(at.curvature_rate);
        a.f(at.grade).f(at.superelevation).f(at.left).f(at.right).f(at.s);
        a.id(at.lane.to_bits()).u(clamped(at.clamped));
        let found = path.project(point, None)?;
        a.f(found.along).f(found.d).f(found.distance).f(found.heading).f(found.s);
        a.id(found.lane.to_bits()).u(clamped(found.clamped));
        a.option(path.speed_at(along).and_then(|rule| rule.max));
        let mut room = Corridor::default();
        path.corridor(0.0, length, step, VehicleClass::PassengerCar, &mut room)?;
        a.u(room.len() as u64);
        for i in 0..room.len() {
            a.f(room.along[i]).id(room.lane[i].to_bits()).v(room.left[i]).v(room.right[i]);
            a.v(room.outer_left[i]).v(room.outer_right[i]);
            for mark in [room.left_mark[i], room.right_mark[i]] {
                a.u(mark.kind.code()).u(mark.color.code()).u(u64::from(mark.may_cross));
            }
        }
        let (mut conflicts, mut lanes) = (Vec::new(), Vec::new());
        path.conflicts(&mut conflicts, &mut lanes);
        a.u(conflicts.len() as u64);
        for one in &conflicts {
            a.f(one.along[0]).f(one.along[1]).id(one.other.to_bits());
            a.f(one.other_s[0]).f(one.other_s[1]).f(one.wait);
            a.u(hash(one.kind.name())).u(hash(one.yields.name())).u(hash(one.reason.name()));
            a.u(one.lanes_of(&lanes).len() as u64);
            for lane in one.lanes_of(&lanes) {
                a.id(lane.other.to_bits()).f(lane.along[0]).f(lane.along[1]);
            }
        }
        self.write("path", &q, &a);
        Ok(())
    }
}
