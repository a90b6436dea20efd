//! Questions about parts of the map, one by one and in lists.

use crate::numbers::{NOTHING, Numbers, hash, lane_bits, object_bits, short, signal_bits};
use crate::{Asker, Result};
use mapd_client::glam::DVec2;
use mapd_client::vocabulary::ClassSet;
use mapd_client::{LaneTypes, Region};

impl Asker<'_> {
    pub(crate) fn numbers_of_a_road(&mut self) -> Result<()> {
        let road = self.random.one_of(&self.roads);
        let s = self.random.between(-1.0, road.length() + 1.0);
        let t = self.random.between(-12.0, 12.0);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.u(hash(road.id())).f(road.elevation_at(s)).f(road.superelevation_at(s));
        a.f(road.lane_offset_at(s));
        a.u(lane_bits(road.section_at(s).and_then(|section| section.lane_at(s, t))));
        let first = road.section(0);
        a.lanes(first.iter().flat_map(|one| one.lanes()).map(|lane| lane.lane_id()));
        self.write("road", q.id(road.road_id().to_bits()).f(s).f(t), &a);
        Ok(())
    }

    pub(crate) fn region(&mut self) -> Result<()> {
        let map = self.map;
        let low = self.point();
        let size = DVec2::new(self.random.between(1.0, 30.0), self.random.between(1.0, 30.0));
        let region = Region { low, high: low + size };
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(region.low.x).f(region.low.y).f(region.high.x).f(region.high.y);
        let types = LaneTypes::from_bits(u64::MAX);
        let mut lanes = Vec::new();
        map.lanes_in(region, types, &mut lanes)?;
        a.lanes(lanes.iter().copied());
        let mut signals = Vec::new();
        map.signals_in(region, &mut signals)?;
        a.u(signals.len() as u64);
        for one in &signals {
            a.id(one.to_bits());
        }
        let mut objects = Vec::new();
        map.objects_in(region, &mut objects)?;
        a.u(objects.len() as u64);
        for one in &objects {
            a.id(one.object.to_bits()).u(one.copy.map_or(NOTHING, u64::from));
        }
        let mut landmarks = Vec::new();
        map.landmarks_in(region, ClassSet::LANDMARKS, &mut landmarks)?;
        a.u(landmarks.len() as u64);
        for one in &landmarks {
            a.v(one.position).f(one.distance);
        }
        let (mut bounds, mut marks) = (Vec::new(), Vec::new());
        map.boundary_segments(region, types, &mut lanes, &mut bounds)?;
        a.u(bounds.len() as u64);
        for one in &bounds {
            a.id(one.lane.to_bits()).f(one.s[0]).f(one.s[1]).v(one.ends[0]).v(one.ends[1]);
        }
        map.road_mark_segments(region, types, &mut lanes, &mut bounds, &mut marks)?;
        a.u(marks.len() as u64);
        for one in &marks {
            a.id(one.segment.lane.to_bits()).f(one.segment.s[0]).f(one.width);
            a.u(one.kind.code()).u(one.color.code());
        }
        self.write("region", &q, &a);
        Ok(())
    }

    pub(crate) fn details(&mut self) -> Result<()> {
        let (lane, s) = self.place();
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.pose(&lane.pose_of_reference_line(s, 0.5)?);
        a.f(lane.time_between(s, lane.section().s_end()));
        let rule = lane.overtaking_rule_at(s);
        a.u(signal_bits(rule.all)).u(signal_bits(rule.trucks));
        let height = lane.height_at(s);
        a.f(height.inner).f(height.outer);
        let material = lane.material_at(s);
        a.u(u64::from(material.is_some()));
        a.f(material.and_then(|one| one.friction).unwrap_or(-1.0));
        a.u(lane.road_marks().count() as u64);
        for one in lane.road_marks() {
            a.f(one.s()).f(one.s_end()).f(one.width_or_default());
            a.u(one.kind().code()).u(one.color().code());
        }
        a.u(lane.objects().count() as u64);
        for one in lane.objects() {
            a.u(object_bits(one.object().map(|object| object.object_id()))).f(one.s_range().low);
            a.f(one.s_range().high).f(one.distance());
        }
        let lines = [
            lane.lines_to_stop_at().collect::<Vec<_>>(),
            lane.crossings().collect(),
            lane.movement_crossings().collect(),
            lane.movement_stop().into_iter().collect(),
        ];
        for all in &lines {
            a.u(all.len() as u64);
            for one in all {
                a.id(one.lane.to_bits()).f(one.s).u(one.class.code());
            }
        }
        let node = lane.node_at(s, lane.is_forward());
        a.u(node.as_ref().map_or(NOTHING, |node| short(node.node_id().to_bits())));
        a.u(node.as_ref().map_or(0, |node| node.predecessors().count() as u64));
        for one in node.iter().flat_map(|node| node.predecessors()) {
            a.id(one.node_id().to_bits());
        }
        self.write("details", q.id(lane.lane_id().to_bits()).f(s), &a);
        Ok(())
    }

    pub(crate) fn sign(&mut self) -> Result<()> {
        let map = self.map;
        let all: Vec<_> = map.signals().map(|one| one.signal_id()).collect();
        if all.is_empty() {
            return Ok(());
        }
        let id = self.random.one_of(&all);
        let signal = map.signal(id)?;
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.u(all.len() as u64);
        a.u(map.signal_by_id(signal.id()).map_or(NOTHING, |one| hash(one.id())));
        for links in [signal.dependencies().collect::<Vec<_>>(), signal.links().collect()] {
            a.u(links.len() as u64);
            for one in &links {
                a.u(hash(one.id)).u(hash(one.kind));
                a.u(signal_bits(one.signal.map(|signal| signal.signal_id())));
                a.u(object_bits(one.object.map(|object| object.object_id())));
                a.u(u64::from(one.is_object));
            }
        }
        a.lanes(signal.movements().map(|one| one.lane_id()));
        a.u(signal.controllers().count() as u64);
        for one in signal.controllers() {
            a.u(one.controller_id().row());
        }
        self.write("sign", q.id(id.to_bits()), &a);
        Ok(())
    }

    pub(crate) fn thing(&mut self) -> Result<()> {
        let map = self.map;
        let all: Vec<_> = map.objects().map(|one| one.object_id()).collect();
        if all.is_empty() {
            return Ok(());
        }
        let id = self.random.one_of(&all);
        let object = map.object(id)?;
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.u(all.len() as u64);
        a.u(object_bits(map.object_by_id(object.id()).map(|one| one.object_id())));
        a.u(object.lanes().count() as u64);
        for one in object.lanes() {
            a.u(lane_bits(one.lane())).f(one.s_range().low).f(one.distance());
        }
        a.u(object.placements().count() as u64);
        let mut corners = Vec::new();
        for one in object.placements() {
            a.v(one.position()).f(one.angles()[0]).f(one.length()).f(one.height());
            map.placement(one.placement_id())?.footprint(&mut corners);
            a.u(corners.len() as u64);
            for corner in &corners {
                a.v(*corner);
            }
        }
        self.write("thing", q.id(id.to_bits()), &a);
        Ok(())
    }

    pub(crate) fn earth(&mut self) -> Result<()> {
        let at = self.point();
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let Ok(projector) = self.map.projector() else { return Ok(()) };
        let place = projector.to_geodetic(at.extend(0.5))?;
        q.f(place.latitude).f(place.longitude).f(place.altitude);
        a.v(projector.from_geodetic(place)?);
        self.write("earth", &q, &a);
        Ok(())
    }

    /// What the map has only once.
    pub(crate) fn whole(&mut self) {
        let map = self.map;
        let mut a = Numbers::default();
        a.u(map.lane_nodes().len() as u64);
        a.u(map.junctions().count() as u64);
        for one in map.junctions() {
            a.id(one.junction_id().to_bits()).u(hash(one.id()));
            a.u(map
                .junction_by_id(one.id())
                .map_or(NOTHING, |one| short(one.junction_id().to_bits())));
            a.u(one.connections().count() as u64);
            for connection in one.connections() {
                a.u(hash(connection.id())).u(connection.contact_point().code());
            }
            let controllers: Vec<_> =
                one.controllers().filter_map(|one| one.controller()).collect();
            a.u(controllers.len() as u64);
            for controller in &controllers {
                a.u(controller.controller_id().row());
            }
        }
        a.u(map.controllers().count() as u64);
        for one in map.controllers() {
            a.u(hash(one.id())).u(hash(one.name()));
        }
        a.u(map.junction_groups().count() as u64);
        for one in map.junction_groups() {
            a.u(hash(one.id())).u(one.kind().code());
            a.u(one.members().filter_map(|one| one.junction()).count() as u64);
            a.lanes(one.ring());
        }
        a.u(map.structures().count() as u64);
        for one in map.structures() {
            a.u(hash(one.id())).f(one.s_range().low).f(one.s_range().high).u(one.kind().code());
        }
        a.u(map.object_references().count() as u64);
        for one in map.object_references() {
            a.u(hash(one.id())).f(one.s()).f(one.t());
        }
        a.u(map.quarantined().count() as u64);
        let bounds = map.geodetic_bounds();
        a.u(u64::from(bounds.is_some()));
        for one in bounds.into_iter().flatten() {
            a.f(one);
        }
        self.write("whole", &Numbers::default(), &a);
    }
}
