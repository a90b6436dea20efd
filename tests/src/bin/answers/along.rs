//! Questions about what a path comes by, the room along it, and ways from and to it.

use crate::numbers::{Numbers, hash, object_bits, short, signal_bits};
use crate::{Asker, Result};
use mapd_client::Map;
use mapd_client::path::{
    Corridor, CorridorEdges, LaneChange, Path, PathBuffer, PathFact, PathFactKind, PathOptions,
};
use mapd_client::route::{RouteScratch, RouteStep, ShortestLength};
use mapd_client::rules::{LaneLine, LineSource};
use mapd_client::vocabulary::VehicleClass;

/// Who drives.
const CAR: VehicleClass = VehicleClass::PassengerCar;
/// Length of a change of lane `[m]`.
const CHANGE: f64 = 15.0;

fn line(a: &mut Numbers, line: &LaneLine) {
    let (signal, object) = match line.source {
        LineSource::Signal(signal) => (Some(signal), None),
        LineSource::Object(object) => (None, Some(object)),
    };
    a.u(signal_bits(signal)).u(object_bits(object)).id(line.lane.to_bits()).f(line.s);
    a.u(hash(line.class.name()));
}

pub(crate) fn steps(a: &mut Numbers, steps: &[RouteStep]) {
    a.u(steps.len() as u64);
    for step in steps {
        a.id(step.lane.to_bits()).u(u64::from(step.forward)).u(step.enter as u64);
        a.f(step.s_from).f(step.s_to).f(step.s_latest);
    }
}

fn fact(a: &mut Numbers, map: Map<'_>, fact: &PathFact) -> Result<()> {
    a.f(fact.along[0]).f(fact.along[1]).id(fact.lane.to_bits());
    match fact.kind {
        PathFactKind::Junction { junction, turn } => {
            a.u(0u64).u(hash(map.junction(junction)?.id())).u(turn.bit());
        }
        PathFactKind::Signal { signal, governs } => {
            a.u(1u64).id(signal.to_bits()).u(u64::from(governs));
        }
        PathFactKind::Line { line: own, ends } => {
            line(a.u(2u64), &own);
            a.v(ends[0]).v(ends[1]);
        }
        PathFactKind::RoadType(kind) => {
            a.u(3u64).u(hash(kind.name()));
        }
        PathFactKind::LaneType(kind) => {
            a.u(4u64).u(hash(kind.name()));
        }
        PathFactKind::Structure { kind, number } => {
            a.u(5u64).u(hash(kind.name())).u(number);
        }
        PathFactKind::Hole { number } => {
            a.u(6u64).u(number);
        }
        PathFactKind::Country { number } => {
            a.u(7u64).u(hash(map.country(number).unwrap_or_default()));
        }
        PathFactKind::Access { classes } => {
            let all = VehicleClass::ALL.iter().filter(|class| classes & class.bit() != 0);
            a.u(8u64).u(all.fold(0u64, |sum, class| sum.wrapping_add(hash(class.name()))));
        }
        _ => {}
    }
    Ok(())
}

impl Asker<'_> {
    /// Of the path along a route, by the numbers of the question about that.
    pub(crate) fn along(
        &mut self,
        route: &Numbers,
        own: &[RouteStep],
        scratch: &mut RouteScratch,
    ) -> Result<()> {
        let (map, mut buffer) = (self.map, PathBuffer::default());
        let Ok(path) = map.path(own, &PathOptions::default(), &mut buffer) else { return Ok(()) };
        let length = path.length();
        let (from, to) = (self.random.between(0.0, 0.5), self.random.between(0.5, 1.0));
        let (from, to) = (from * length, to * length);
        let reach = self.random.between(5.0, 80.0);
        let mut q = Numbers(route.0.clone());
        q.f(from).f(to).f(reach);
        let mut a = Numbers::default();
        let mut facts = Vec::new();
        path.facts(&mut facts);
        a.u(facts.len() as u64);
        for one in &facts {
            fact(&mut a, map, one)?;
        }
        let mut speeds = Vec::new();
        path.speeds(&mut speeds);
        a.u(speeds.len() as u64);
        for one in &speeds {
            a.f(one.along[0]).f(one.along[1]).option(one.rule.max).u(signal_bits(one.rule.signal));
        }
        let time = path.travel_time([from, to])?;
        a.f(time.time).f(time.unlimited);
        let mut segments = Vec::new();
        path.segments(CAR, &mut segments);
        a.u(segments.len() as u64);
        for one in &segments {
            a.f(one.along[0]).f(one.along[1]).id(one.lane.to_bits()).f(one.last_change);
            a.f(one.lane_end).u(one.changes).u(u64::from(one.forward)).u(u64::from(one.driven));
        }
        let mut part = Vec::new();
        match path.steps_between(own, [from, to], &mut part) {
            Ok(()) => steps(&mut a, &part),
            Err(_) => steps(&mut a, &[]),
        }
        self.who_meets(&path, reach, &mut a)?;
        let mut changes = Vec::new();
        let found =
            path.rebase(map, CAR, &ShortestLength::default(), scratch, &mut part, &mut changes)?;
        a.u(u64::from(found.is_some())).f(found.map_or(0.0, |route| route.cost));
        steps(&mut a, if found.is_some() { &part } else { &[] });
        a.u(changes.len() as u64);

        let mut buffer = PathBuffer::default();
        let options = PathOptions { change: LaneChange::Lateral(CHANGE), ..PathOptions::default() };
        let curved = map.path(own, &options, &mut buffer)?;
        a.f(curved.length()).u(curved.joints().len() as u64);
        for one in curved.joints() {
            a.f(one.along).f(one.gap).f(one.kink).u(one.enter as u64);
            a.u(u64::from(one.broken)).u(u64::from(one.short));
        }
        self.write("along", &q, &a);
        self.room(route, &path)
    }

    /// Who crosses the path, and who comes to its first conflict.
    fn who_meets(&mut self, path: &Path<'_, '_>, reach: f64, a: &mut Numbers) -> Result<()> {
        let mut crossings = Vec::new();
        path.crossings(&mut crossings);
        a.u(crossings.len() as u64);
        for one in &crossings {
            a.f(one.along[0]).f(one.along[1]).f(one.wait);
            line(a, &one.line);
            a.u(hash(one.yields.name()));
        }
        let (mut conflicts, mut lanes, mut approaches) = (Vec::new(), Vec::new(), Vec::new());
        path.conflicts(&mut conflicts, &mut lanes);
        if let Some(first) = conflicts.first() {
            self.map.approaches(first.lanes_of(&lanes), reach, CAR, &mut approaches)?;
        }
        a.u(approaches.len() as u64);
        for one in &approaches {
            a.id(one.lane.to_bits()).f(one.s[0]).f(one.s[1]).f(one.distance[0]).f(one.distance[1]);
            a.u(u64::from(one.forward));
        }
        Ok(())
    }

    /// The room along a path: limits, what lies beside it, its surface and its outline.
    fn room(&mut self, route: &Numbers, path: &Path<'_, '_>) -> Result<()> {
        let step = path.length() / 5.0;
        let (mut q, mut a) = (Numbers(route.0.clone()), Numbers::default());
        q.f(step);
        let mut room = Corridor::default();
        path.corridor(0.0, path.length(), step, CAR, &mut room)?;
        path.corridor_surface(&mut room)?;
        a.u(room.len() as u64);
        for i in 0..room.len() {
            a.f(room.s[i]).option(room.speed[i].max);
            for mark in [room.left_mark[i], room.right_mark[i]] {
                a.u(hash(mark.edge.name()));
            }
            for mark in [room.outer_left_mark[i], room.outer_right_mark[i]] {
                a.u(mark.kind.code()).u(mark.color.code()).u(u64::from(mark.may_cross));
                a.u(hash(mark.edge.name()));
            }
            let ground = room.surface[i];
            a.v(ground.position).v(ground.normal);
            a.f(ground.friction.unwrap_or(-1.0)).f(ground.roughness.unwrap_or(-1.0));
        }
        for edges in [CorridorEdges::Driven, CorridorEdges::Open] {
            let mut points = Vec::new();
            a.u(u64::from(room.outline(edges, &mut points))).u(points.len() as u64);
            points.iter().for_each(|point| {
                a.f(point.x).f(point.y);
            });
        }
        self.write("room", &q, &a);
        Ok(())
    }

    /// Pieces of lanes from which a place can be reached.
    pub(crate) fn comes(&mut self, scratch: &mut RouteScratch) -> Result<()> {
        let ((lane, s), limit) = (self.place(), self.random.between(10.0, 200.0));
        let to = mapd_client::route::PositionOnLane { lane: lane.lane_id(), s };
        let (mut q, mut a, mut found) = (Numbers::default(), Numbers::default(), Vec::new());
        let cost = ShortestLength::default();
        self.map.reachable_to(to, limit, CAR, &cost, scratch, &mut found)?;
        a.u(found.len() as u64);
        for one in &found {
            let node = self.map.lane_node(one.node)?;
            let range = node.s_range();
            a.u(node.lane().map_or(0, |lane| short(lane.lane_id().to_bits())));
            a.u(u64::from(node.is_forward())).f(range.low).f(range.high).f(one.cost);
        }
        self.write("comes", q.id(lane.lane_id().to_bits()).f(s).f(limit), &a);
        Ok(())
    }
}
