//! Links of roads and junctions.

use crate::draft::{
    ConnectedLanes, Links, RoadLink, WrittenConnection, WrittenController, WrittenJunction, between,
};
use mapd_xodr::{
    Connection, ConnectionType, ElementType, Junction, JunctionType, LinkedElement, Text as _,
    Value as _,
};

/// Whether more is built of a junction than its connections, controllers and priorities.
fn says_more(junction: &Junction) -> bool {
    let is_virtual = |c: &Connection| {
        c.r#type.value() == Some(ConnectionType::Virtual)
            || c.predecessor.is_some()
            || c.successor.is_some()
    };
    let has_zone = |c: &Connection| c.lane_link.iter().any(|l| l.overlap_zone.is_some());
    !junction.road_section.is_empty()
        || !junction.cross_path.is_empty()
        || junction.main_road.is_some()
        || junction.s_start.is_some()
        || junction.connection.iter().any(|c| is_virtual(c) || has_zone(c))
}

impl Links {
    /// A road's link, if it names anything.
    pub(super) fn road_link(&mut self, link: &LinkedElement) -> Option<RoadLink> {
        let id = self.names.add(&link.element_id.as_ref()?.value);
        Some(RoadLink {
            span: link.span,
            id,
            contact: link.contact_point.value(),
            dir: link.element_dir.value(),
            // Files without the type link roads.
            to_junction: link.element_type.value() == Some(ElementType::Junction),
            s: link.element_s.value(),
        })
    }

    /// Takes a junction.
    pub(super) fn junction(&mut self, mut junction: Junction) {
        let before = [self.connections.len(), self.controllers.len(), self.priorities.len()];
        for c in &junction.connection {
            let first = self.connected.len();
            self.connected.extend(c.lane_link.iter().filter_map(|link| {
                let (from, to) = (link.from.value()?, link.to.value()?);
                Some(ConnectedLanes { span: link.span, from, to })
            }));
            let [id, incoming, connecting, linked] =
                [&c.id, &c.incoming_road, &c.connecting_road, &c.linked_road]
                    .map(|id| self.names.add(id.text()));
            self.connections.push(WrittenConnection {
                span: c.span,
                id,
                incoming,
                connecting,
                linked,
                lane_links: between(first, self.connected.len()),
                contact: c.contact_point.value(),
            });
        }
        for controller in &junction.controller {
            let sequence = controller.sequence.value().and_then(|s| i32::try_from(s).ok());
            let [id, r#type] =
                [&controller.id, &controller.r#type].map(|text| self.names.add(text.text()));
            self.controllers.push(WrittenController { id, r#type, sequence });
        }
        for priority in &junction.priority {
            let roads = [&priority.high, &priority.low].map(|id| self.names.add(id.text()));
            self.priorities.push(roads);
        }
        let kind = junction.r#type.value().unwrap_or(JunctionType::Default);
        let says_more = says_more(&junction);
        junction.objects = None;
        self.junctions.push(WrittenJunction {
            span: junction.span,
            connections: between(before[0], self.connections.len()),
            controllers: between(before[1], self.controllers.len()),
            priorities: between(before[2], self.priorities.len()),
            kind,
            element: says_more.then(|| Box::new(junction)),
        });
    }
}
