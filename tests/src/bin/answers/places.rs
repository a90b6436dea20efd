//! Questions about places, roads and lanes.

use crate::numbers::{NOTHING, Numbers, clamped, hash, lane_bits, object_bits, short, signal_bits};
use crate::{Asker, RADII, Result};
use mapd_client::localisation::LandmarkSource;
use mapd_client::route::{LaneSequences, PositionOnLane, RouteScratch};
use mapd_client::signals::SignalsAhead;
use mapd_client::vocabulary::{ClassSet, VehicleClass};
use mapd_client::{Nearest, NearestOptions, Point, Track};

impl Asker<'_> {
    pub(crate) fn points(&mut self) -> Result<()> {
        let map = self.map;
        let at = self.point();
        let (radius, has_z) = (self.random.one_of(RADII), self.random.next() % 2);
        let z = self.random.between(-2.0, 2.0);
        let point = Point { xy: at, z: (has_z == 1).then_some(z) };
        let options = NearestOptions { radius, ..NearestOptions::default() };
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y).f(z).u(has_z).f(radius);
        match map.nearest_lane(point, &options)? {
            Some(hit) => a.u(1u64).nearest(&hit),
            None => a.u(0u64),
        };
        self.write("nearest", &q, &a);

        let (mut near, mut a) = (Vec::new(), Numbers::default());
        map.lanes_near(point, &options, &mut near)?;
        a.u(near.len() as u64);
        near.iter().for_each(|one| {
            a.nearest(one);
        });
        self.write("near", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y).f(radius);
        let mut objects = Vec::new();
        map.objects_near(at, radius, &mut objects)?;
        a.u(objects.len() as u64);
        for one in &objects {
            let copy = one.place.copy.map_or(NOTHING, u64::from);
            a.id(one.place.object.to_bits()).u(copy).f(one.distance);
        }
        self.write("objects", &q, &a);

        let (mut landmarks, mut a) = (Vec::new(), Numbers::default());
        map.landmarks_near(at, radius, ClassSet::LANDMARKS, &mut landmarks)?;
        a.u(landmarks.len() as u64);
        for one in &landmarks {
            let (signal, place) = match one.source {
                LandmarkSource::Signal(signal) => (Some(signal), None),
                LandmarkSource::Object(place) => (None, Some(place.object)),
            };
            a.u(signal_bits(signal)).u(object_bits(place)).u(one.class.code()).v(one.position);
            a.f(one.heading).f(one.size[0]).f(one.size[1]).f(one.size[2]).f(one.distance);
        }
        self.write("landmarks", &q, &a);

        let (mut signals, mut a) = (Vec::new(), Numbers::default());
        map.signals_near(at, radius, &mut signals)?;
        a.u(signals.len() as u64);
        for one in &signals {
            a.u(hash(map.signal(one.signal)?.id())).f(one.distance);
        }
        a.u(objects.len() as u64);
        for one in &objects {
            a.u(hash(map.object(one.place.object)?.id())).f(one.distance);
        }
        self.write("around", &q, &a);

        let road = self.random.one_of(&self.roads);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.id(road.road_id().to_bits()).f(at.x).f(at.y).f(z).u(has_z);
        let track = road.to_track(point)?;
        a.f(track.s).f(track.t).option(track.h).f(track.distance).u(clamped(track.clamped));
        a.u(u64::from(track.exact));
        self.write("track", &q, &a);

        let mut a = Numbers::default();
        if let Ok(place) =
            map.projector().map_err(drop).and_then(|p| p.to_geodetic(at.extend(z)).map_err(drop))
        {
            a.u(1u64).f(place.latitude).f(place.longitude).f(place.altitude);
        } else {
            a.u(0u64);
        }
        let mut q = Numbers::default();
        self.write("geodetic", q.f(at.x).f(at.y).f(z), &a);
        Ok(())
    }

    pub(crate) fn roads(&mut self) -> Result<()> {
        let road = self.random.one_of(&self.roads);
        let s = self.random.between(-1.0, road.length() + 1.0);
        let (t, h) = (self.random.between(-12.0, 12.0), self.random.between(-1.0, 1.0));
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.id(road.road_id().to_bits()).f(s).f(t).f(h);
        a.pose(&road.to_inertial(Track { s, t, h })?);
        self.write("inertial", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let surface = road.surface_at(s, t)?;
        a.v(surface.position)
            .v(surface.normal)
            .u(surface.lane.map_or(NOTHING, |lane| short(lane.to_bits())));
        a.u(u64::from(surface.material.is_some()));
        a.f(surface.material.and_then(|one| one.friction).unwrap_or(-1.0))
            .u(clamped(surface.clamped));
        self.write("surface", q.id(road.road_id().to_bits()).f(s).f(t), &a);
        Ok(())
    }

    pub(crate) fn lanes(&mut self) -> Result<()> {
        let map = self.map;
        let (lane, s) = self.place();
        let id = short(lane.lane_id().to_bits());
        let offset = self.random.between(-2.0, 2.0);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.pose(&lane.pose_at(s, offset)?);
        self.write("pose", q.u(id).f(s).f(offset), &a);

        let at = lane.pose_at(s, offset * 3.0)?.position.truncate();
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.nearest(&Nearest { lane: lane.lane_id(), position: lane.position_of(at)? });
        self.write("position", q.u(id).f(at.x).f(at.y), &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let (edges, waypoint) = (lane.edges_at(s), lane.waypoint_at(s)?);
        a.f(edges.inner).f(edges.outer);
        a.f(waypoint.s).v(waypoint.position).f(waypoint.heading).f(waypoint.width);
        let [left, right] = lane.bounds_at(s).ok_or("bounds")?;
        a.v(left).v(right).f(lane.length_between(s, lane.section().s_end()));
        let rule = lane.speed_rule_at(s);
        a.u(signal_bits(rule.signal));
        match lane.road_mark_at(s) {
            Some(mark) => {
                a.u(1u64).u(mark.kind().code()).u(mark.color().code()).f(mark.width_or_default())
            }
            None => a.u(0u64),
        };
        self.write("edges", q.u(id).f(s), &a);

        let mut a = Numbers::default();
        a.f(lane.width_at(s)).option(lane.recorded_speed_limit_at(s)).option(rule.max);
        a.u(u64::from(lane.allows_at(s, VehicleClass::PassengerCar)));
        a.u(lane.speed_rules().count() as u64);
        for own in lane.speed_rules() {
            a.f(own.s.low).f(own.s.high).option(own.rule.max).option(own.lowest);
        }
        self.write("at", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.u(hash(&lane.key().to_string())).u(lane.number() as u32).u(lane.kind().code());
        a.u(u64::from(lane.is_forward())).f(lane.section().s_start()).f(lane.section().s_end());
        a.u(lane_bits(lane.left())).u(lane_bits(lane.right())).u(lane_bits(lane.opposite()));
        a.lanes(lane.successors()).lanes(lane.predecessors());
        self.write("lane", q.u(id), &a);

        let mut a = Numbers::default();
        a.lanes(lane.entries().map(|one| one.lane_id()));
        a.lanes(lane.movement_lanes().map(|one| one.lane_id()));
        a.u(lane.turn().bit());
        let ways: Vec<_> = lane.right_of_way().collect();
        a.u(ways.len() as u64);
        for one in &ways {
            a.u(lane_bits(one.other())).u(one.relation().code()).u(one.reason().code());
        }
        let lights: Vec<_> = lane.movement_lights().collect();
        a.u(lights.len() as u64);
        for one in &lights {
            a.id(one.signal().signal_id().to_bits()).u(lane_bits(one.lane()));
        }
        self.write("movement", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let line = lane.center_line();
        a.u(line.len() as u64);
        line.points().for_each(|point| {
            a.f(point.s).v(point.position);
        });
        self.write("line", q.u(id), &a);

        let reach = self.random.between(5.0, 150.0);
        let from = PositionOnLane { lane: lane.lane_id(), s };
        let (mut q, mut ahead) = (Numbers::default(), SignalsAhead::default());
        q.u(id).f(s).f(reach);
        map.signals_ahead(from, reach, VehicleClass::PassengerCar, &mut ahead)?;
        let mut a = Numbers::default();
        a.u(ahead.iter().len() as u64);
        for one in ahead.iter() {
            a.u(hash(map.signal(one.signal)?.id())).id(one.lane.to_bits()).f(one.distance).f(one.s);
        }
        self.write("ahead", &q, &a);

        let (mut sequences, mut a) = (LaneSequences::default(), Numbers::default());
        let (car, mut scratch) = (VehicleClass::PassengerCar, RouteScratch::default());
        map.lane_sequences_ahead(from, reach, car, &mut scratch, &mut sequences)?;
        let pieces = sequences.network().reached().len();
        let links = (0..pieces).map(|piece| sequences.network().links(piece).len()).sum::<usize>();
        a.u(pieces as u64).u(links as u64);
        while let Some(lanes) = sequences.next_sequence() {
            a.lanes(lanes.iter().copied());
        }
        self.write("sequences", &q, &a);

        let mut a = Numbers::default();
        match map.next_junction(from, reach, VehicleClass::PassengerCar)? {
            Some(next) => a.u(1u64).id(next.junction.to_bits()).f(next.distance),
            None => a.u(0u64),
        };
        self.write("junction", &q, &a);
        Ok(())
    }
}
