//! Junctions.

use crate::ids::JunctionId;
use crate::map::Map;
use crate::road::Road;
use mapd_archive::{ArchivedConnectionRow, ArchivedJunctionRow, ContactPoint, string};

/// A junction.
#[derive(Clone, Copy)]
pub struct Junction<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    row: &'a ArchivedJunctionRow,
}

impl<'a> Junction<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().junctions.get(number as usize)? })
    }

    /// Dense id.
    pub fn junction_id(&self) -> JunctionId {
        JunctionId::new(self.number, self.map.content())
    }

    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// OpenDRIVE's name.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// Connections in file order.
    pub fn connections(&self) -> impl ExactSizeIterator<Item = Connection<'a>> + use<'a> {
        let (map, range) = (self.map, self.row.connections());
        let rows = range.of(map.tables().connections).iter().enumerate();
        rows.map(move |(i, row)| {
            let number = range.first.wrapping_add(i as u32);
            Connection { map, number, row }
        })
    }
}

/// A connection of a junction, as written.
#[derive(Clone, Copy)]
pub struct Connection<'a> {
    pub(crate) map: Map<'a>,
    pub(crate) number: u32,
    row: &'a ArchivedConnectionRow,
}

/// A link of lanes by their numbers.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ConnectedLanes {
    /// Number of the lane of the incoming road.
    pub from: i32,
    /// Number of the lane of the connecting road.
    pub to: i32,
}

impl<'a> Connection<'a> {
    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Road that leads into the junction, where the map has it.
    pub fn incoming_road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.incoming_road())
    }

    /// Connecting road, or the linked road of a direct junction, where the map has it.
    pub fn connecting_road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.connecting_road())
    }

    /// End of the connecting road that touches the incoming one.
    pub fn contact_point(&self) -> ContactPoint {
        ContactPoint::from_code(self.row.contact())
    }

    /// Lane links as written.
    pub fn lane_links(&self) -> impl ExactSizeIterator<Item = ConnectedLanes> + use<'a> {
        let links = self.row.lane_links().of(self.map.tables().connection_lane_links);
        links.iter().map(|link| ConnectedLanes { from: link.from(), to: link.to() })
    }
}
