//! Railway switches and stations as written. Nothing is built from them: what they lack is left open.

use crate::draft::Draft;
use crate::draft::{Platform, Station, Switch};
use mapd_archive::{NONE, PlatformRow, PlatformSegmentRow, Range, StationRow, SwitchRow};
use mapd_xodr::{self as xodr, ElementDir, PlatformSide, SwitchPosition, Text as _, Value as _};

impl Draft {
    /// Takes the switches of a road.
    pub(crate) fn switches(&mut self, road: u32, railroad: &xodr::Railroad) {
        for switch in &railroad.switch {
            let (main, side) = (switch.main_track.as_deref(), switch.side_track.as_deref());
            let row = SwitchRow {
                main_s: main.and_then(|track| track.s.value()).unwrap_or(0.0),
                side_s: side.and_then(|track| track.s.value()).unwrap_or(0.0),
                road,
                id: self.strings.add(switch.id.text()),
                name: self.strings.add(switch.name.text()),
                main: NONE,
                side: NONE,
                partner: NONE,
                position: match switch.position.value() {
                    Some(SwitchPosition::Dynamic) => 1,
                    Some(SwitchPosition::Straight) => 2,
                    Some(SwitchPosition::Turn) => 3,
                    _ => 0,
                },
                main_direction: direction(main.and_then(|track| track.dir.value())),
                side_direction: direction(side.and_then(|track| track.dir.value())),
                reserved: [0; 5],
            };
            let tracks = [main.map_or("", |t| t.id.text()), side.map_or("", |t| t.id.text())];
            let partner = switch.partner.as_deref().map_or("", |partner| partner.id.text());
            let tracks = tracks.map(str::to_owned);
            self.objects.switches.push(Switch { row, tracks, partner: partner.to_owned() });
        }
    }

    /// Takes a station.
    pub(crate) fn station(&mut self, station: &xodr::Station) {
        let kind = station.r#type.value().map_or("", xodr::StationType::name);
        let row = StationRow {
            id: self.strings.add(station.id.text()),
            name: self.strings.add(station.name.text()),
            kind: self.strings.add(kind),
            platforms: Range::default(),
        };
        let mut platforms = Vec::new();
        for platform in &station.platform {
            let row = PlatformRow {
                id: self.strings.add(platform.id.text()),
                name: self.strings.add(platform.name.text()),
                segments: Range::default(),
            };
            let segment = |segment: &xodr::PlatformSegment| {
                let row = PlatformSegmentRow {
                    s_start: segment.s_start.value().unwrap_or(0.0),
                    s_end: segment.s_end.value().unwrap_or(0.0),
                    road: NONE,
                    side: match segment.side.value() {
                        Some(PlatformSide::Left) => 1,
                        Some(PlatformSide::Right) => 2,
                        _ => 0,
                    },
                    reserved: [0; 3],
                };
                (segment.road_id.text().to_owned(), row)
            };
            let segments = platform.segment.iter().map(segment).collect();
            platforms.push(Platform { row, segments });
        }
        self.objects.stations.push(Station { row, platforms });
    }
}

fn direction(written: Option<ElementDir>) -> u8 {
    match written {
        Some(ElementDir::Plus) => 1,
        Some(ElementDir::Minus) => 2,
        _ => 0,
    }
}
