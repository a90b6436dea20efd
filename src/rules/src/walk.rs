//! The walk through an element, to each part that some rule looks at.

use crate::examiner::{Examiner, Rules};
use crate::line::ReferenceLine;
use crate::place::{LaneIn, ObjectIn, RoadIn, SectionIn, Side, SignalIn, number, text};
use crate::rule::Check;
use crate::sink::{Key, PathSegment};
use mapd_xodr::{Item, Junction, Objects, Road};

/// Applies each rule of a list to something.
macro_rules! apply {
    ($self:ident, $rules:ident, $list:ident, $kind:ident, $path:expr, $element:expr) => {
        for rank in $rules.lists.$list.iter().copied() {
            let Some(applied) = $rules.applied.get(rank) else { continue };
            if let Check::$kind(check) = applied.rule.check {
                $self.apply($rules, (rank, applied), $path, |sink| check($element, sink));
            }
        }
    };
}

impl Examiner {
    /// Applies the rules on single elements.
    pub(crate) fn walk(&mut self, rules: &Rules, item: &Item, line: &ReferenceLine) {
        match item {
            Item::Header(header) => {
                apply!(self, rules, header, Header, &[PathSegment("header", Key::None)], header);
            }
            Item::Road(road) => self.road(rules, road, line),
            Item::Controller(controller) => {
                let step = PathSegment("controller", Key::Id(text(&controller.id)));
                apply!(self, rules, controller, Controller, &[step], controller);
            }
            Item::Junction(junction) => self.junction(rules, junction),
            Item::JunctionGroup(group) => {
                let step = PathSegment("junctionGroup", Key::Id(text(&group.id)));
                apply!(self, rules, junction_group, JunctionGroup, &[step], group);
            }
            Item::Station(station) => {
                let step = PathSegment("station", Key::Id(text(&station.id)));
                apply!(self, rules, station, Station, &[step], station);
            }
            Item::VmsGroup(group) => {
                let step = PathSegment("vmsGroup", Key::Id(text(&group.id)));
                apply!(self, rules, vms_group, VmsGroup, &[step], group);
            }
        }
    }

    /// Applies the rules on the order of a road's records.
    pub(crate) fn order(&mut self, rules: &Rules, road: &Road) {
        let step = PathSegment("road", Key::Id(text(&road.id)));
        apply!(self, rules, order, Order, &[step], road);
    }

    fn road(&mut self, rules: &Rules, road: &Road, line: &ReferenceLine) {
        let step = PathSegment("road", Key::Id(text(&road.id)));
        apply!(self, rules, road, Road, &[step], &RoadIn { road, line });
        for lanes in &road.lanes {
            for (index, section) in lanes.lane_section.iter().enumerate() {
                self.section(rules, &SectionIn { road, lanes, section, index }, step);
            }
        }
        if let Some(objects) = &road.objects {
            self.objects(rules, objects, Some(road), step);
        }
        for signal in road.signals.iter().flat_map(|signals| &signals.signal) {
            let path = [
                step,
                PathSegment("signals", Key::None),
                PathSegment("signal", Key::Id(text(&signal.id))),
            ];
            apply!(self, rules, signal, Signal, &path, &SignalIn { road, signal });
        }
    }

    fn section(&mut self, rules: &Rules, section: &SectionIn<'_>, road: PathSegment<'_>) {
        let here = PathSegment("laneSection", Key::S(number(&section.section.s)));
        let path = [road, PathSegment("lanes", Key::None), here];
        apply!(self, rules, section, Section, &path, section);
        for (side, name) in [(Side::Left, "left"), (Side::Right, "right")] {
            for lane in section.side(side) {
                let id = lane.id.map_or(0, |id| id.value);
                let [a, b, c] = path;
                let path =
                    [a, b, c, PathSegment(name, Key::None), PathSegment("lane", Key::Lane(id))];
                apply!(self, rules, lane, Lane, &path, &LaneIn { section: *section, side, lane });
            }
        }
        for lane in section.section.center.iter().flat_map(|center| &center.lane) {
            let [a, b, c] = path;
            let path =
                [a, b, c, PathSegment("center", Key::None), PathSegment("lane", Key::Lane(0))];
            apply!(self, rules, center_lane, CenterLane, &path, lane);
        }
    }

    fn objects(
        &mut self,
        rules: &Rules,
        objects: &Objects,
        road: Option<&Road>,
        step: PathSegment<'_>,
    ) {
        for object in &objects.object {
            let path = [
                step,
                PathSegment("objects", Key::None),
                PathSegment("object", Key::Id(text(&object.id))),
            ];
            apply!(self, rules, object, Object, &path, &ObjectIn { road, object });
        }
    }

    fn junction(&mut self, rules: &Rules, junction: &Junction) {
        let step = PathSegment("junction", Key::Id(text(&junction.id)));
        apply!(self, rules, junction, Junction, &[step], junction);
        if let Some(objects) = &junction.objects {
            self.objects(rules, objects, None, step);
        }
    }
}
