//! Railway switches and stations, as written (OpenDRIVE 1.8.1, 15).

use crate::map::Map;
use crate::road::Road;
use mapd_archive::{
    ArchivedPlatformRow, ArchivedPlatformSegmentRow, ArchivedStationRow, ArchivedSwitchRow,
    Orientation, PlatformSide, SwitchPosition, string,
};

/// A railway switch.
#[derive(Clone, Copy)]
pub struct Switch<'a> {
    map: Map<'a>,
    row: &'a ArchivedSwitchRow,
}

/// A track at a switch.
#[derive(Clone, Copy)]
pub struct SwitchTrack<'a> {
    /// The road; none where the map does not have it.
    pub road: Option<Road<'a>>,
    /// Place of the switch on it `[m]`.
    pub s: f64,
    /// Direction along the track; `Both` if not given.
    pub direction: Orientation,
}

impl<'a> Switch<'a> {
    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Name for people.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// The road that it is written in; none in a damaged archive.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// Its state, or that it changes; none if not given.
    pub fn position(&self) -> Option<SwitchPosition> {
        Some(SwitchPosition::from_code(self.row.position()))
            .filter(|position| *position != SwitchPosition::None)
    }

    /// The straight track.
    pub fn main_track(&self) -> SwitchTrack<'a> {
        self.track(self.row.main(), self.row.main_s(), self.row.main_direction())
    }

    /// The branching track.
    pub fn side_track(&self) -> SwitchTrack<'a> {
        self.track(self.row.side(), self.row.side_s(), self.row.side_direction())
    }

    fn track(&self, road: u32, s: f64, direction: u8) -> SwitchTrack<'a> {
        let road = Road::new(self.map, road);
        SwitchTrack { road, s, direction: Orientation::from_code(direction) }
    }

    /// The switch at the other end of the side track.
    pub fn partner(&self) -> Option<Switch<'a>> {
        let row = self.map.tables().switches.get(self.row.partner() as usize)?;
        Some(Switch { map: self.map, row })
    }
}

/// A station.
#[derive(Clone, Copy)]
pub struct Station<'a> {
    pub(crate) map: Map<'a>,
    pub(crate) number: u32,
    row: &'a ArchivedStationRow,
}

impl<'a> Station<'a> {
    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Name for people.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// `type` as written: small, medium, large.
    pub fn type_name(&self) -> &'a str {
        string(self.map.tables(), self.row.kind())
    }

    /// Platforms in file order.
    pub fn platforms(&self) -> impl ExactSizeIterator<Item = Platform<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.platforms().of(map.tables().platforms);
        rows.iter().map(move |row| Platform { map, row })
    }
}

/// A platform.
#[derive(Clone, Copy)]
pub struct Platform<'a> {
    map: Map<'a>,
    row: &'a ArchivedPlatformRow,
}

/// A stretch of track beside a platform.
#[derive(Clone, Copy)]
pub struct PlatformSegment<'a> {
    /// The road; none where the map does not have it.
    pub road: Option<Road<'a>>,
    /// From where to where `[m]`, as written.
    pub s: [f64; 2],
    /// Side of the road that the platform is on.
    pub side: PlatformSide,
}

impl<'a> Platform<'a> {
    /// OpenDRIVE's id, verbatim.
    pub fn id(&self) -> &'a str {
        string(self.map.tables(), self.row.id())
    }

    /// Name for people.
    pub fn name(&self) -> &'a str {
        string(self.map.tables(), self.row.name())
    }

    /// Stretches of track beside it.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = PlatformSegment<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.segments().of(map.tables().platform_segments);
        rows.iter().map(move |row: &ArchivedPlatformSegmentRow| PlatformSegment {
            road: Road::new(map, row.road()),
            s: [row.s_start(), row.s_end()],
            side: PlatformSide::from_code(row.side()),
        })
    }
}

impl<'a> Map<'a> {
    /// All switches, by the road that they are written in.
    pub fn switches(&self) -> impl ExactSizeIterator<Item = Switch<'a>> + use<'a> {
        let map = *self;
        map.tables().switches.iter().map(move |row| Switch { map, row })
    }

    /// All stations in file order.
    pub fn stations(&self) -> impl ExactSizeIterator<Item = Station<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().stations.iter().enumerate();
        rows.map(move |(number, row)| Station { map, number: number as u32, row })
    }
}
