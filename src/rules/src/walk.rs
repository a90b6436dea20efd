//! The walk through an element, to each part that some rule looks at.

use crate::examiner::{Examiner, Rules};
use crate::line::ReferenceLine;
use crate::place::{LaneIn, ObjectIn, RoadIn, SectionIn, Side, SignalIn, number, text};
use crate::sink::{Key, PathSegment};
use mapd_xodr::{Item, Junction, Objects, Road};

/// Applies each rule of a list to something.
macro_rules! apply {
    ($self:ident, $rules:ident, $list:ident, $path:expr, $element:expr) => {
        for listed in &$rules.lists.$list {
            $self.apply($rules, listed, $path, |sink| (listed.check)($element, sink));
        }
    };
}

impl Examiner {
    /// Applies the rules on single elements.
    pub(crate) fn walk(&mut self, rules: &Rules, item: &Item, line: &ReferenceLine) {
        match item {
            Item::Header(header) => {
                apply!(self, rules, header, &[PathSegment("header", Key::None)], header);
            }
            Item::Road(road) => self.road(rules, road, line),
            Item::Controller(controller) => {
                let step = PathSegment("controller", Key::Id(text(&controller.id)));
                apply!(self, rules, controller, &[step], controller);
            }
            Item::Junction(junction) => self.junction(rules, junction),
            Item::JunctionGroup(group) => {
                let step = PathSegment("junctionGroup", Key::Id(text(&group.id)));
                apply!(self, rules, junction_group, &[step], group);
            }
            Item::Station(station) => {
                let step = PathSegment("station", Key::Id(text(&station.id)));
                apply!(self, rules, station, &[step], station);
            }
            Item::VmsGroup(group) => {
                let step = PathSegment("vmsGroup", Key::Id(text(&group.id)));
                apply!(self, rules, vms_group, &[step], group);
            }
        }
    }

    /// Applies the rules on the order of what a road has along it.
    pub(crate) fn order(&mut self, rules: &Rules, road: &Road, are_records_sorted: bool) {
        let step = PathSegment("road", Key::Id(text(&road.id)));
        apply!(self, rules, order, &[step], road);
        if !are_records_sorted {
            apply!(self, rules, records, &[step], road);
        }
    }

    fn road(&mut self, rules: &Rules, road: &Road, line: &ReferenceLine) {
        let step = PathSegment("road", Key::Id(text(&road.id)));
        apply!(self, rules, road, &[step], &RoadIn { road, line });
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
            apply!(self, rules, signal, &path, &SignalIn { road, signal });
        }
    }

    fn section(&mut self, rules: &Rules, section: &SectionIn<'_>, road: PathSegment<'_>) {
        let here = PathSegment("laneSection", Key::S(number(&section.section.s)));
        let path = [road, PathSegment("lanes", Key::None), here];
        apply!(self, rules, section, &path, section);
        for (side, name) in [(Side::Left, "left"), (Side::Right, "right")] {
            for lane in section.side(side) {
                let id = lane.id.map_or(0, |id| id.value);
                let [a, b, c] = path;
                let path =
                    [a, b, c, PathSegment(name, Key::None), PathSegment("lane", Key::Lane(id))];
                apply!(self, rules, lane, &path, &LaneIn { section: *section, side, lane });
            }
        }
        for lane in section.section.center.iter().flat_map(|center| &center.lane) {
            let [a, b, c] = path;
            let path =
                [a, b, c, PathSegment("center", Key::None), PathSegment("lane", Key::Lane(0))];
            apply!(self, rules, center_lane, &path, lane);
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
            apply!(self, rules, object, &path, &ObjectIn { road, object });
        }
    }

    fn junction(&mut self, rules: &Rules, junction: &Junction) {
        let step = PathSegment("junction", Key::Id(text(&junction.id)));
        apply!(self, rules, junction, &[step], junction);
        if let Some(objects) = &junction.objects {
            self.objects(rules, objects, None, step);
        }
    }
}
