//! What is said, as it was given.

use crate::place::{EarthPlace, LaneStretch};
use crate::time::{Day, Moment, TimeOfDay};
use mapd_archive::{OverlayKind, VehicleClass};
use serde::{Deserialize, Serialize};

/// Bits of all classes of vehicles.
pub(crate) const EVERYBODY: u16 = {
    let (mut all, mut i) = (0, 0);
    while i < VehicleClass::ALL.len() {
        all |= VehicleClass::ALL[i].bit();
        i += 1;
    }
    all
};

/// Something that is said about lanes or signals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Its name; no other entry has it.
    pub id: String,
    /// What is said.
    pub kind: Kind,
    /// Who says so.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub source: String,
    /// The feed that it comes from: when that is applied anew, what it has no more is removed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub feed: String,
    /// What is said, for people.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// Of a speed, the limit `[m/s]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Stretches of lanes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lanes: Vec<LaneStretch>,
    /// Lines and areas on Earth.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub places: Vec<EarthPlace>,
    /// Ids of signals.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub signals: Vec<String>,
    /// Ids of objects: the lanes that they lie on are meant.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub objects: Vec<String>,
    /// Classes of vehicles, in the words of OpenDRIVE; none: everybody.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub vehicles: Vec<String>,
    /// From when on; always has if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<Moment>,
    /// Until when, this moment not included; until it is removed if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<Moment>,
    /// Times of the week; always if not given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub weekly: Vec<Weekly>,
    /// How sure the source is, from 0 to 1.
    #[serde(default = "one")]
    pub confidence: f64,
}

fn one() -> f64 {
    1.0
}

/// What is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Kind {
    /// Closed for these vehicles.
    Closed,
    /// Open for these vehicles only: closed for all others.
    Only,
    /// Opened for these vehicles, as a hard shoulder.
    Open,
    /// The speed limit.
    Speed,
    /// No overtaking.
    NoOvertaking,
    /// The surface is wet.
    Wet,
    /// There is ice.
    Icy,
    /// There is snow.
    Snow,
    /// The surface is rough.
    Rough,
    /// A signal is out of service.
    SignalOff,
    /// A warning.
    Warning,
}

impl Kind {
    /// How it is stored.
    pub(crate) fn stored(self) -> OverlayKind {
        match self {
            Self::Closed | Self::Only => OverlayKind::Closed,
            Self::Open => OverlayKind::Open,
            Self::Speed => OverlayKind::Speed,
            Self::NoOvertaking => OverlayKind::NoOvertaking,
            Self::Wet => OverlayKind::Wet,
            Self::Icy => OverlayKind::Icy,
            Self::Snow => OverlayKind::Snow,
            Self::Rough => OverlayKind::Rough,
            Self::SignalOff => OverlayKind::SignalOff,
            Self::Warning => OverlayKind::Warning,
        }
    }

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Only => "only",
            other => other.stored().name(),
        }
    }
}

/// Times of the week, UTC.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Weekly {
    /// Days on which it begins.
    pub days: Vec<Day>,
    /// Begin.
    pub from: TimeOfDay,
    /// End, not included; not after the begin: on the next day.
    pub until: TimeOfDay,
}

/// Seconds of a day and of a week.
const DAY: u32 = 24 * 3600;
const WEEK: u32 = 7 * DAY;
/// Seconds from the Monday before the Unix epoch, a Thursday, to the epoch.
const EPOCH_IN_WEEK: i64 = 3 * DAY as i64;

impl Weekly {
    /// Begins and ends in seconds since Monday 00:00, none beyond the week's end.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.days.iter().flat_map(|day| {
            let from = *day as u32 * DAY + self.from.0;
            let night = if self.until <= self.from { DAY } else { 0 };
            let until = *day as u32 * DAY + self.until.0 + night;
            let parts = [[from, until.min(WEEK)], [0, until.saturating_sub(WEEK)]];
            parts.into_iter().filter(|[from, until]| from < until)
        })
    }
}

impl Entry {
    /// Whether it holds at a moment.
    pub fn holds(&self, at: Moment) -> bool {
        let in_week = (at.unix_seconds.floor() as i64 + EPOCH_IN_WEEK).rem_euclid(WEEK.into());
        let weekly = |weekly: &Weekly| {
            weekly
                .ranges()
                .any(|[from, until]| (i64::from(from)..i64::from(until)).contains(&in_week))
        };
        self.from.is_none_or(|from| at >= from)
            && self.until.is_none_or(|until| at < until)
            && (self.weekly.is_empty() || self.weekly.iter().any(weekly))
    }

    /// Bits of the vehicles that the stored entry concerns.
    pub(crate) fn concerned(&self) -> u16 {
        let named = self.vehicles.iter().map(|name| VehicleClass::from_name(name).bit());
        let named = named.fold(0, |all, bit| all | bit);
        match self.kind {
            Kind::Only => EVERYBODY & !named,
            _ if named == 0 => EVERYBODY,
            _ => named,
        }
    }

    /// Faults of the entry that show without a map: field and reason.
    pub(crate) fn wrong(&self) -> Option<(String, String)> {
        let field = |name: &str, why: &str| Some((name.to_owned(), why.to_owned()));
        if self.id.is_empty() || self.id.len() > LONGEST_ID {
            return field("id", "expected a name of 1 to 200 bytes");
        }
        if self.id.chars().any(char::is_control) {
            return field("id", "has control characters");
        }
        match (self.kind, self.value) {
            (Kind::Speed, Some(value)) if value.is_finite() && value >= 0.0 => {}
            (Kind::Speed, Some(_)) => {
                return field("value", "expected a speed in m/s, not negative");
            }
            (Kind::Speed, None) => return field("value", "a speed needs one, in m/s"),
            (_, Some(_)) => return field("value", "only a speed has one"),
            (_, None) => {}
        }
        if !(0.0..=1.0).contains(&self.confidence) {
            return field("confidence", "expected a number from 0 to 1");
        }
        if let (Some(from), Some(until)) = (self.from, self.until)
            && until <= from
        {
            return field("until", "ends before it begins");
        }
        if let Some(i) = self.weekly.iter().position(|weekly| weekly.days.is_empty()) {
            return field(&format!("weekly[{i}].days"), "names no day");
        }
        let unknown = |name: &String| VehicleClass::from_name(name) == VehicleClass::Unknown;
        if let Some(i) = self.vehicles.iter().position(unknown) {
            let all: Vec<_> = VehicleClass::ALL.iter().map(|class| class.name()).collect();
            let why = format!("expected one of {}", all.join(", "));
            return field(&format!("vehicles[{i}]"), &why);
        }
        if self.kind == Kind::Only && self.vehicles.is_empty() {
            return field("vehicles", "`only` needs those for whom it stays open");
        }
        let of_signals = self.kind == Kind::SignalOff;
        if of_signals && self.signals.is_empty() {
            return field("signals", "names none");
        }
        if !of_signals && !self.signals.is_empty() {
            return field("signals", "only `signal-off` is about signals");
        }
        let nowhere = self.lanes.is_empty() && self.objects.is_empty() && self.places.is_empty();
        if !of_signals && nowhere {
            return field("lanes", "names no place");
        }
        if of_signals && !nowhere {
            return field("lanes", "`signal-off` is about signals");
        }
        let on_earth = |(i, place): (usize, &EarthPlace)| {
            let (field, why) = place.wrong()?;
            Some((format!("places[{i}].{field}"), why.to_owned()))
        };
        if let Some(wrong) = self.places.iter().enumerate().find_map(on_earth) {
            return Some(wrong);
        }
        let place = |(i, place): (usize, &LaneStretch)| {
            let (field, why) = place.wrong()?;
            Some((format!("lanes[{i}].{field}"), why.to_owned()))
        };
        self.lanes.iter().enumerate().find_map(place)
    }
}

/// Longest name of an entry \[bytes\].
const LONGEST_ID: usize = 200;
