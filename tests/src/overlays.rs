//! Overlays in tests: made in this process, and the same written into the OpenDRIVE text.

use mapd_archive::{AlignedBytes, encode_overlay, verify_overlay};
use mapd_overlay::{Document, Limits, Policy, Resolved, resolve};
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{Lane, Map};
use std::collections::HashMap;

/// A stretch of a lane of a road.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// OpenDRIVE's id of the road.
    pub road: String,
    /// Section in its road.
    pub section: usize,
    /// Number of the lane.
    pub lane: i32,
    /// From where to where on the road.
    pub s: [f64; 2],
    /// Where the section begins.
    pub start: f64,
    /// The limit \[m/s\]; none: closed for passenger cars.
    pub speed: Option<f64>,
}

/// The bytes of a document's overlay over a map, proved, and what does not fit.
pub fn over(map: Map<'_>, text: &str, may_loosen: bool) -> (AlignedBytes, Resolved) {
    let document = Document::read(text.as_bytes(), &Limits::default()).expect("a document");
    let resolved = resolve(map, &document, Policy { may_loosen });
    let bytes = encode_overlay(&resolved.rows, map.content_hash()).expect("encodes");
    verify_overlay(&bytes).expect("proves");
    (bytes, resolved)
}

/// A document with entries of every kind: on a part of a lane, on whole lanes, some for the time of the epoch's week only.
pub fn todays_entries(map: Map<'_>) -> String {
    let open = |lane: &Lane<'_>| lane.nodes().any(|node| node.allows(VehicleClass::PassengerCar));
    let lanes = map.lanes().filter(open).step_by(3);
    let mut entries: Vec<String> = lanes
        .enumerate()
        .map(|(i, lane)| {
            let (from, to) = (lane.section().s_start(), lane.section().s_end());
            let (key, third) = (lane.key(), (to - from) / 3.0);
            let (from, to) = (from + third, to - third);
            let what = match i % 6 {
                0 => format!(r#""kind":"closed","lanes":[{{"key":"{key}","s":[{from},{to}]}}]"#),
                1 => format!(r#""kind":"speed","value":3,"lanes":[{{"key":"{key}"}}]"#),
                2 => format!(
                    r#""kind":"wet","weekly":[{{"days":["thu"],"from":"00:00","until":"01:00"}}],"lanes":[{{"key":"{key}"}}]"#
                ),
                3 => format!(r#""kind":"only","vehicles":["passengerCar"],"lanes":[{{"key":"{key}"}}]"#),
                4 => format!(r#""kind":"no-overtaking","lanes":[{{"key":"{key}"}}]"#),
                _ => format!(r#""kind":"warning","text":"cones","lanes":[{{"key":"{key}"}}]"#),
            };
            format!(r#"{{"id":"{i}",{what}}}"#)
        })
        .collect();
    for signal in map.signals() {
        let id = signal.id();
        entries.push(format!(r#"{{"id":"off {id}","kind":"signal-off","signals":["{id}"]}}"#));
    }
    format!(r#"{{"entries":[{}]}}"#, entries.join(","))
}

impl Stretch {
    /// As an entry of a document.
    pub fn entry(&self, id: usize) -> String {
        let Self { road, section, lane, s: [from, to], .. } = self;
        let what = match self.speed {
            Some(speed) => format!(r#""kind":"speed","value":{speed}"#),
            None => r#""kind":"closed","vehicles":["passengerCar"]"#.to_owned(),
        };
        let key = format!("{road}:{section}:{lane}");
        format!(r#"{{"id":"{id}",{what},"lanes":[{{"key":"{key}","s":[{from},{to}]}}]}}"#)
    }

    /// As an entry that opens it for passenger cars.
    pub fn opening(&self, id: usize) -> String {
        self.entry(id).replace(r#""kind":"closed""#, r#""kind":"open""#)
    }

    /// The records that say so in a lane.
    pub fn records(&self) -> String {
        let [from, to] = self.s.map(|s| s - self.start);
        match self.speed {
            Some(speed) => format!(
                r#"<speed sOffset="{from}" max="{speed}"/><speed sOffset="{to}" max="undefined"/>"#
            ),
            None => self.denials(&["passengerCar"]),
        }
    }

    /// The records that close it for these.
    pub fn denials(&self, vehicles: &[&str]) -> String {
        let [from, to] = self.s.map(|s| s - self.start);
        let deny =
            |name: &&str| format!(r#"<access sOffset="{from}" rule="deny" restriction="{name}"/>"#);
        let denied: String = vehicles.iter().map(deny).collect();
        format!(r#"{denied}<access sOffset="{to}" rule="allow" restriction="none"/>"#)
    }

    /// Where its records go, in the road that begins there.
    fn place(&self, text: &str, road: usize) -> Option<usize> {
        let end = road + text[road..].find("</road>")?;
        let mut at = road;
        for _ in 0..=self.section {
            at += text[at..end].find("<laneSection")? + 1;
        }
        let lane = element(&text[..end], at, "lane", &self.lane.to_string())?;
        let close = lane + text[lane..end].find("</lane>")?;
        let body = &text[lane..close];
        if body.contains("<access") || body.contains("<speed") {
            return None;
        }
        let place = ["<userData", "<height", "<rule"].iter().filter_map(|tag| body.find(tag)).min();
        Some(lane + place.unwrap_or(body.len()))
    }
}

/// Where records of stretches of different lanes go in the text of a map; `None` of one whose lane has no body, or has such records already.
pub fn places(stretches: &[Stretch], text: &str) -> Vec<Option<usize>> {
    let begins = text.match_indices("<road ").map(|(at, _)| at);
    let id = |at: usize| {
        let tag = text[at..].split('>').next()?;
        tag.split(" id=\"").nth(1)?.split('"').next()
    };
    let roads: HashMap<&str, usize> = begins.filter_map(|at| Some((id(at)?, at))).collect();
    let place = |one: &Stretch| one.place(text, *roads.get(one.road.as_str())?);
    stretches.iter().map(place).collect()
}

/// The text with records written into it, each at its place.
pub fn write_at(text: &str, records: impl IntoIterator<Item = (usize, String)>) -> String {
    let mut records: Vec<(usize, String)> = records.into_iter().collect();
    records.sort();
    let (mut out, mut written) = (String::with_capacity(text.len()), 0);
    for (at, record) in records {
        out.push_str(&text[written..at]);
        out.push_str(&record);
        written = at;
    }
    out.push_str(&text[written..]);
    out
}

/// Writes stretches of different lanes into the text of a map; `None` where one cannot be.
pub fn write_all(stretches: &[Stretch], text: &str) -> Option<String> {
    let places = places(stretches, text).into_iter().collect::<Option<Vec<_>>>()?;
    Some(write_at(text, places.into_iter().zip(stretches.iter().map(Stretch::records))))
}

/// Where an element of this name and id begins.
fn element(text: &str, from: usize, name: &str, id: &str) -> Option<usize> {
    let (open, id) = (format!("<{name} "), format!(" id=\"{id}\""));
    let mut at = from;
    loop {
        at += text[at..].find(&open)?;
        let end = at + text[at..].find('>')?;
        if text[at..end].contains(&id) && !text[at..end].ends_with('/') {
            return Some(at);
        }
        at = end;
    }
}
