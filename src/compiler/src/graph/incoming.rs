//! Connections by the road that leads in, and their lane links by the lane.

use super::Source;
use crate::draft::LaneLink;

/// A connection, with its junction.
#[derive(Clone, Copy)]
pub(crate) struct IncomingConnection {
    /// The road that leads in.
    road: u32,
    pub(crate) junction: u32,
    pub(crate) connection: u32,
}

/// Connections by incoming road.
pub(crate) struct Incoming {
    /// Those that link no lanes, by their roads.
    bare: Vec<IncomingConnection>,
    /// The links of the others, by road and lane: each lane of a road asks for its own.
    links: Vec<(IncomingConnection, LaneLink)>,
}

impl Incoming {
    pub(crate) fn new(source: Source<'_>) -> Self {
        let rows = &source.draft.rows;
        let (mut bare, mut links) = (Vec::new(), Vec::new());
        for (junction, row) in (0u32..).zip(rows.junctions.iter()) {
            let own = (row.connections.first..).zip(row.connections.of(&rows.connections));
            for (number, connection) in own {
                let road = connection.incoming_road;
                let Some(written) = source.links.connection(number) else { continue };
                if road as usize >= rows.roads.len() {
                    continue;
                }
                let one = IncomingConnection { road, junction, connection: number };
                let before = links.len();
                links.extend(source.links.connected(written).map(|link| (one, link)));
                if links.len() == before {
                    bare.push(one);
                }
            }
        }
        // Of those that lead into one road at one end, the first says it all.
        let entered = |one: &IncomingConnection| {
            let row = rows.connections.get(one.connection as usize);
            row.map(|row| (row.connecting_road, row.contact))
        };
        bare.sort_by_key(|one| (one.road, one.junction, entered(one), one.connection));
        bare.dedup_by_key(|one| (one.road, one.junction, entered(one)));
        links.sort_by_key(by_lane);
        Self { bare, links }
    }

    /// Connections that a road leads into and that link no lanes.
    pub(crate) fn bare(&self, road: u32) -> &[IncomingConnection] {
        let from = self.bare.partition_point(|one| one.road < road);
        let to = self.bare.partition_point(|one| one.road <= road);
        self.bare.get(from..to).unwrap_or_default()
    }

    /// Links from a lane of a road, each with its connection.
    pub(crate) fn links(&self, road: u32, lane: i32) -> &[(IncomingConnection, LaneLink)] {
        let from = self.links.partition_point(|one| by_lane(one) < (road, lane));
        let to = self.links.partition_point(|one| by_lane(one) <= (road, lane));
        self.links.get(from..to).unwrap_or_default()
    }
}

/// What links are ordered by.
fn by_lane((connection, link): &(IncomingConnection, LaneLink)) -> (u32, i32) {
    (connection.road, link.from)
}
