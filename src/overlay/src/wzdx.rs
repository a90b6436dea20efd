//! Work zones of the US Work Zone Data Exchange (WZDx 4.0 to 4.2, a GeoJSON feed) as entries.
//!
//! Each work zone is a warning over all lanes of its line. What it says beyond that, lane by lane, is an entry more, named after the zone: lanes that
//! are closed, vehicles that may not pass, the limit. What has no entry is a finding with its place in the file.

mod feed;

use crate::document::{Document, DocumentError, Limits};
use crate::entry::{Entry, Kind};
use crate::place::{Across, AcrossWord, EarthPlace};
use feed::{EventType, Lane, Restriction, WorkZone};
use serde_json::Value;

/// How far beside a feed's lines lanes may lie, where nothing is said `[m]`: lines follow the middle of the road, or a coarser map.
pub const WZDX_TOLERANCE: f64 = 15.0;

/// Something in a feed that no entry says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FeedFinding {
    /// Where in the file, such as `features[3].properties.lanes[1]`.
    pub place: String,
    /// Why.
    pub why: String,
}

/// A feed, read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feed {
    /// Its entries.
    pub document: Document,
    /// Of each entry, its place in the file.
    pub places: Vec<String>,
    /// What has no entry, in the file's order.
    pub findings: Vec<FeedFinding>,
    /// Names of entries, or of features with all their entries, that cannot be read: what they said before must stay. An empty one stands for all.
    pub unread: Vec<String>,
}

/// Whether a text begins as GeoJSON does, and is to be read as a feed.
pub fn is_feed(text: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Typed {
        r#type: Option<String>,
    }
    serde_json::from_str::<Typed>(text)
        .is_ok_and(|typed| typed.r#type.as_deref() == Some("FeatureCollection"))
}

/// Reads a feed. Lines are matched with this tolerance `[m]`.
///
/// Errors: it is not a feed, or has too many entries. What is wrong with one feature is a finding, and the others are taken; unless it is sure that it
/// closes nothing, it is noted as unread.
pub fn read_feed(text: &str, tolerance: f64, limits: &Limits) -> Result<Feed, DocumentError> {
    let wrong = |place: &str, why: String| DocumentError::Json { place: place.to_owned(), why };
    let value: Value =
        serde_json::from_str(text).map_err(|error| wrong("document", error.to_string()))?;
    let features = value.get("features").and_then(Value::as_array);
    let features = features.ok_or_else(|| wrong("features", "expected a list".to_owned()))?;
    let mut feed = Feed::default();
    feed.findings.extend(other_version(&value));
    for (i, feature) in features.iter().enumerate() {
        let place = format!("features[{i}]");
        match serde_path_to_error::deserialize::<_, feed::Feature>(feature) {
            Ok(feature) => Reader { feed: &mut feed, place, tolerance }.feature(feature),
            Err(error) => {
                let place = format!("{place}.{}", error.path());
                let mut why = error.into_inner().to_string();
                if !closes_nothing(feature) {
                    why += STAYS;
                    let id = feature.get("id").and_then(Value::as_str).unwrap_or_default();
                    feed.unread.push(id.to_owned());
                }
                feed.findings.push(FeedFinding { place, why });
            }
        }
    }
    feed.check(limits)?;
    Ok(feed)
}

/// Names of what cannot be read that are told apart; of more, all stays.
const MOST_UNREAD: usize = 1000;

/// Said of what cannot be read.
const STAYS: &str = "; what it said before stays";

/// Whether a feature, as far as it can be read, says that it is no work zone, or has ended.
fn closes_nothing(feature: &Value) -> bool {
    let said = |pointer| feature.pointer(pointer).and_then(Value::as_str);
    said("/properties/core_details/event_type").is_some_and(|event| event != "work-zone")
        || said("/properties/event_status").is_some_and(feed::is_over)
}

/// Tells that a feed is of a version whose words are others.
fn other_version(feed: &Value) -> Option<FeedFinding> {
    ["feed_info", "road_event_feed_info"].into_iter().find_map(|info| {
        let version = feed.get(info)?.get("version")?.as_str()?;
        let why = format!("version {version}: read as one of 4.0 to 4.2");
        (!["4.0", "4.1", "4.2"].contains(&version))
            .then(|| FeedFinding { place: format!("{info}.version"), why })
    })
}

/// Lanes across a zone's line.
#[derive(Clone, Copy)]
struct OnLine<'a> {
    lanes: &'a Across,
    /// How many lanes there are, of numbered ones.
    of: Option<u32>,
}

impl Feed {
    /// Entries that say what cannot be become findings.
    fn check(&mut self, limits: &Limits) -> Result<(), DocumentError> {
        let found = self.document.entries.len();
        if found > limits.entries {
            return Err(DocumentError::Entries { found, most: limits.entries });
        }
        let mut names = std::collections::BTreeSet::new();
        let wrong: Vec<bool> = self
            .document
            .entries
            .iter()
            .zip(&self.places)
            .map(|(entry, place)| {
                let twice = || ("id".to_owned(), "another entry of the feed has it".to_owned());
                let twice = (!names.insert(entry.id.clone())).then(twice);
                let stays = |(field, why)| (field, why + STAYS);
                let wrong = twice.or_else(|| entry.wrong().map(stays));
                let wrong = wrong.map(|(field, why)| format!("{field}: {why}"));
                self.unread.extend(wrong.is_some().then(|| entry.id.clone()));
                self.findings.extend(
                    wrong.iter().map(|why| FeedFinding { place: place.clone(), why: why.clone() }),
                );
                wrong.is_some()
            })
            .collect();
        if self.unread.len() > MOST_UNREAD {
            self.unread = vec![String::new()];
        }
        let mut each = wrong.iter();
        self.document.entries.retain(|_| !each.next().is_some_and(|wrong| *wrong));
        let mut each = wrong.iter();
        self.places.retain(|_| !each.next().is_some_and(|wrong| *wrong));
        Ok(())
    }
}

/// Turns a feature into entries.
struct Reader<'f> {
    feed: &'f mut Feed,
    place: String,
    tolerance: f64,
}

/// What several entries of a work zone share.
struct Zone {
    base: Entry,
    line: Vec<[f64; 2]>,
}

impl Reader<'_> {
    fn find(&mut self, within: &str, why: impl Into<String>) {
        let place = format!("{}{within}", self.place);
        self.feed.findings.push(FeedFinding { place, why: why.into() });
    }

    fn feature(&mut self, feature: feed::Feature) {
        let zone = feature.properties;
        if zone.core_details.event_type != EventType::WorkZone {
            return self.find(".properties.core_details.event_type", "only work zones are taken");
        }
        if zone.event_status.as_deref().is_some_and(feed::is_over) {
            return;
        }
        let core = &zone.core_details;
        let said = core.description.as_deref().or(core.name.as_deref()).unwrap_or_default();
        let mut text = zone.vehicle_impact.0.clone();
        if zone.has_workers() {
            text += ", workers present";
        }
        if !said.is_empty() {
            text = format!("{text}: {said}");
        }
        let base = Entry {
            id: feature.id,
            kind: Kind::Warning,
            source: core.data_source_id.clone(),
            feed: String::new(),
            text,
            value: None,
            lanes: Vec::new(),
            places: Vec::new(),
            signals: Vec::new(),
            objects: Vec::new(),
            vehicles: Vec::new(),
            from: Some(zone.start_date),
            until: Some(zone.end_date),
            weekly: Vec::new(),
            confidence: 1.0,
        };
        let line = feature.geometry.coordinates.iter().map(|at| [at.latitude, at.longitude]);
        self.work_zone(&Zone { base, line: line.collect() }, &zone);
    }

    fn work_zone(&mut self, own: &Zone, zone: &WorkZone) {
        let all = Across::Word(AcrossWord::All);
        let travelled = travelled(&zone.lanes);
        self.add(own, "", "", OnLine { lanes: &all, of: None }, |_| {});
        match zone.vehicle_impact.0.as_str() {
            "all-lanes-closed" => {
                self.add(
                    own,
                    "closed",
                    ".properties.vehicle_impact",
                    OnLine { lanes: &all, of: None },
                    |entry| {
                        entry.kind = Kind::Closed;
                    },
                );
            }
            impact
                if impact.starts_with("some-lanes-closed")
                    && !zone.lanes.iter().any(|lane| lane.status == "closed") =>
            {
                let why =
                    "lanes are closed, and none is named: only the warning is laid over the map";
                self.find(".properties.vehicle_impact", why);
            }
            _ => {}
        }
        if let Some(kph) = zone.reduced_speed_limit_kph {
            let within = ".properties.reduced_speed_limit_kph";
            let on = OnLine { lanes: &all, of: None };
            match kph > 0.0 {
                true => self.add(own, "speed", within, on, |entry| {
                    (entry.kind, entry.value) = (Kind::Speed, Some(kph / 3.6));
                }),
                // Some programs write 0 where they know no limit.
                false => self
                    .find(within, "a limit of 0 or less is not taken; close lanes by their status"),
            }
        }
        for (i, restriction) in zone.restrictions.iter().enumerate() {
            let within = format!(".properties.restrictions[{i}]");
            let name = name_of(&zone.restrictions, i);
            self.restriction(own, restriction, &within, &name, OnLine { lanes: &all, of: None });
        }
        for (i, lane) in zone.lanes.iter().enumerate() {
            let within = format!(".properties.lanes[{i}]");
            let position = travelled.iter().position(|order| *order == lane.order);
            match position.filter(|_| lane.is_travelled()) {
                Some(position) => {
                    let across = Across::Order(vec![position as u32 + 1]);
                    let of = Some(travelled.len() as u32);
                    self.lane(own, lane, &within, OnLine { lanes: &across, of });
                }
                None if lane.status != "open" || !lane.restrictions.is_empty() => {
                    let why = format!(
                        "{} {}: only lanes of traffic are placed",
                        lane.r#type, lane.status
                    );
                    self.find(&within, why);
                }
                None => {}
            }
        }
    }

    fn lane(&mut self, own: &Zone, lane: &Lane, within: &str, across: OnLine<'_>) {
        let name = format!("lane-{}", lane.order);
        match lane.status.as_str() {
            "open" => {}
            "closed" => self.add(own, &name, within, across, |entry| entry.kind = Kind::Closed),
            other => {
                self.add(own, &name, within, across, |entry| entry.text = format!("lane: {other}"));
            }
        }
        for (i, restriction) in lane.restrictions.iter().enumerate() {
            let within = format!("{within}.restrictions[{i}]");
            let name = format!("{name}-{}", name_of(&lane.restrictions, i));
            self.restriction(own, restriction, &within, &name, across);
        }
    }

    fn restriction(
        &mut self,
        own: &Zone,
        restriction: &Restriction,
        within: &str,
        name: &str,
        across: OnLine<'_>,
    ) {
        let (kind, vehicles): (Kind, &[&str]) = match restriction.r#type.as_str() {
            "no-trucks" => (Kind::Closed, &["truck"]),
            "local-access-only" => (Kind::Closed, &["throughTraffic"]),
            "hov-2" | "hov-3" => (Kind::Only, &["HOV", "bus", "emergency"]),
            "no-passing" => (Kind::NoOvertaking, &[]),
            _ => (Kind::Warning, &[]),
        };
        self.add(own, name, within, across, |entry| {
            entry.kind = kind;
            entry.vehicles = vehicles.iter().map(|name| (*name).to_owned()).collect();
            if kind == Kind::Warning {
                entry.text = restriction.to_string();
            }
        });
    }

    /// Adds an entry of the zone on these lanes of its line.
    fn add(
        &mut self,
        own: &Zone,
        name: &str,
        within: &str,
        on: OnLine<'_>,
        change: impl FnOnce(&mut Entry),
    ) {
        let mut entry = own.base.clone();
        if !name.is_empty() {
            entry.id = format!("{}/{name}", entry.id);
        }
        let line = own.line.clone();
        let tolerance = Some(self.tolerance);
        entry.places.push(EarthPlace {
            line,
            area: Vec::new(),
            tolerance,
            lanes: on.lanes.clone(),
            of: on.of,
        });
        change(&mut entry);
        self.feed.document.entries.push(entry);
        self.feed.places.push(format!("{}{within}", self.place));
    }
}

/// What a restriction of a list is called: by its type, and from the second of a type on by number.
fn name_of(restrictions: &[Restriction], i: usize) -> String {
    let kind = |restriction: &Restriction| restriction.r#type.clone();
    let own = restrictions.get(i).map(kind).unwrap_or_default();
    let before = restrictions.iter().take(i).filter(|other| other.r#type == own).count();
    if before == 0 { own } else { format!("{own}-{}", before + 1) }
}

/// Orders of the lanes of traffic, from the left.
fn travelled(lanes: &[Lane]) -> Vec<u32> {
    let mut orders: Vec<u32> =
        lanes.iter().filter(|lane| lane.is_travelled()).map(|lane| lane.order).collect();
    orders.sort_unstable();
    orders.dedup();
    orders
}
