//! Places on straight roads, computed from a document's numbers and nothing else: what mapd answers is compared with them.

use mapd_benches::Random;
use mapd_client::glam::DVec2;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::path::Path;

/// The middle of a lane half along a road.
pub(crate) struct Written {
    pub(crate) road: String,
    pub(crate) lane: i32,
    pub(crate) s: f64,
    pub(crate) t: f64,
    pub(crate) place: DVec2,
}

/// A road as far as it was read.
#[derive(Default)]
struct Road {
    id: String,
    /// x, y, heading and length of its only geometry, which is a line.
    line: Option<[f64; 4]>,
    geometries: usize,
    sections: usize,
    is_right: bool,
    /// Lanes to the right with their widths, from the middle outwards.
    lanes: Vec<(i32, f64)>,
    /// Something in it is not as simple as that.
    is_other: bool,
}

impl Road {
    /// The middle of one of its lanes, if it is straight and its lanes are as wide everywhere.
    fn place(self, random: &mut Random) -> Option<Written> {
        let [x, y, heading, length] = self.line.filter(|_| self.geometries == 1)?;
        let are_in_order = self
            .lanes
            .iter()
            .enumerate()
            .all(|(rank, (lane, width))| *lane == -1 - rank as i32 && *width > 0.0);
        if self.is_other || self.sections != 1 || self.lanes.is_empty() || !are_in_order {
            return None;
        }
        let chosen = (random.unit() * self.lanes.len() as f64) as usize;
        let inner: f64 = self.lanes[..chosen].iter().map(|(_, width)| width).sum();
        let (lane, width) = self.lanes[chosen];
        let (s, t) = (length / 2.0, -inner - width / 2.0);
        let along = DVec2::from_angle(heading);
        let place = DVec2::new(x, y) + along * s + along.perp() * t;
        Some(Written { road: self.id, lane, s, t, place })
    }

    fn take(&mut self, tag: &BytesStart<'_>) {
        let text = |name: &str| {
            let found = tag.try_get_attribute(name).ok().flatten();
            found.map_or(String::new(), |found| found.value.into_owned())
        };
        let number = |name: &str| text(name).trim().parse::<f64>().unwrap_or(f64::NAN);
        match tag.name().as_ref() {
            "road" => {
                let id = text("id");
                // Ids with entities are left to others.
                *self = Self { is_other: id.contains('&'), id, ..Self::default() };
            }
            "geometry" => {
                self.geometries += 1;
                self.line = Some(["x", "y", "hdg", "length"].map(number));
            }
            "arc" | "spiral" | "poly3" | "paramPoly3" | "superelevation" | "laneOffset"
            | "border" | "left" | "offset" => self.is_other = true,
            "laneSection" => self.sections += 1,
            "right" => self.is_right = true,
            "center" => self.is_right = false,
            "lane" if self.is_right => {
                self.lanes.push((number("id") as i32, 0.0));
            }
            "width" if self.is_right => {
                let is_even = ["sOffset", "b", "c", "d"].map(number) == [0.0; 4];
                match self.lanes.last_mut() {
                    Some((_, width)) if is_even && *width == 0.0 => *width = number("a"),
                    _ => self.is_other = true,
                }
            }
            _ => {}
        }
    }
}

/// So many places of a document at random; fewer where it has fewer roads of that kind, none where its header moves it.
pub(crate) fn sample(file: &Path, count: usize) -> Vec<Written> {
    let mut reader = Reader::from_file(file).expect("the map opens");
    let (mut random, mut road, mut buffer) = (Random(11), Road::default(), Vec::new());
    let (mut chosen, mut seen): (Vec<Written>, usize) = (Vec::new(), 0);
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer).expect("the map is well-formed") {
            Event::Start(tag) => road.take(&tag),
            Event::Empty(tag) => road.take(&tag),
            // A header with an offset moves all that follows.
            Event::End(tag) if tag.name().as_ref() == "header" && road.is_other => break,
            Event::End(tag) if tag.name().as_ref() == "road" => {
                let Some(place) = std::mem::take(&mut road).place(&mut random) else { continue };
                // Each has the same chance, however many there are.
                seen += 1;
                if chosen.len() < count {
                    chosen.push(place);
                } else if let Some(other) = chosen.get_mut((random.unit() * seen as f64) as usize) {
                    *other = place;
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    chosen
}
