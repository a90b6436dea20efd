//! The fields of a WZDx feed that entries are made of, by the names of its specification. Others are read over.

use crate::time::Moment;
use serde::Deserialize;
use serde::de::{self, Deserializer, IgnoredAny, SeqAccess, Visitor};
use std::fmt;

#[derive(Deserialize)]
pub(super) struct Feature {
    pub(super) id: String,
    pub(super) properties: WorkZone,
    pub(super) geometry: Geometry,
}

#[derive(Deserialize)]
pub(super) struct Geometry {
    /// `LineString`, or `MultiPoint` of which nothing is known between the points: both are followed straight.
    #[serde(rename = "type")]
    _kind: GeometryType,
    pub(super) coordinates: Vec<Position>,
}

#[derive(Deserialize)]
enum GeometryType {
    LineString,
    MultiPoint,
}

/// Longitude and latitude `[deg]`, in this order, and perhaps a height.
pub(super) struct Position {
    pub(super) longitude: f64,
    pub(super) latitude: f64,
}

impl<'de> Deserialize<'de> for Position {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl<'de> Visitor<'de> for Numbers {
            type Value = Position;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("longitude and latitude")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<Position, A::Error> {
                let missing = || de::Error::custom("expected longitude and latitude");
                let longitude = from.next_element()?.ok_or_else(missing)?;
                let latitude = from.next_element()?.ok_or_else(missing)?;
                while from.next_element::<IgnoredAny>()?.is_some() {}
                Ok(Position { longitude, latitude })
            }
        }
        from.deserialize_seq(Numbers)
    }
}

/// The properties of a feature; those that only a work zone has may be missing from others.
#[derive(Deserialize)]
pub(super) struct WorkZone {
    pub(super) core_details: CoreDetails,
    pub(super) start_date: Moment,
    pub(super) end_date: Moment,
    #[serde(default, deserialize_with = "or_default")]
    pub(super) vehicle_impact: Impact,
    #[serde(default)]
    pub(super) event_status: Option<String>,
    #[serde(default)]
    pub(super) reduced_speed_limit_kph: Option<f64>,
    #[serde(default, deserialize_with = "or_default")]
    pub(super) restrictions: Vec<Restriction>,
    #[serde(default, deserialize_with = "or_default")]
    pub(super) lanes: Vec<Lane>,
    /// An object, or anything else: what only informs never takes a zone off the road.
    #[serde(default)]
    worker_presence: serde_json::Value,
}

impl WorkZone {
    /// Whether people work there, by the feed's word.
    pub(super) fn has_workers(&self) -> bool {
        self.worker_presence.get("are_workers_present") == Some(&true.into())
    }
}

/// Whether an event of this status affects nobody any more.
pub(super) fn is_over(status: &str) -> bool {
    matches!(status, "completed" | "cancelled")
}

/// What a zone does to traffic, in the feed's word.
#[derive(Deserialize)]
#[serde(transparent)]
pub(super) struct Impact(pub(super) String);

impl Default for Impact {
    fn default() -> Self {
        Self("unknown".to_owned())
    }
}

/// Reads a null as what is missing: feeds write both.
fn or_default<'de, D: Deserializer<'de>, T: Deserialize<'de> + Default>(
    from: D,
) -> Result<T, D::Error> {
    Option::deserialize(from).map(Option::unwrap_or_default)
}

#[derive(Deserialize)]
pub(super) struct CoreDetails {
    pub(super) event_type: EventType,
    pub(super) data_source_id: String,
    #[serde(default)]
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) description: Option<String>,
}

#[derive(Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub(super) enum EventType {
    WorkZone,
    Detour,
    Restriction,
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
pub(super) struct Lane {
    /// From the left, from 1.
    pub(super) order: u32,
    pub(super) r#type: String,
    pub(super) status: String,
    #[serde(default, deserialize_with = "or_default")]
    pub(super) restrictions: Vec<Restriction>,
}

impl Lane {
    /// Whether traffic drives on it: these are the lanes that a map's lanes are counted with.
    pub(super) fn is_travelled(&self) -> bool {
        const WITHOUT: [&str; 5] = ["sidewalk", "bike-lane", "shoulder", "parking", "median"];
        !WITHOUT.contains(&self.r#type.as_str())
    }
}

#[derive(Deserialize)]
pub(super) struct Restriction {
    pub(super) r#type: String,
    #[serde(default)]
    value: Option<f64>,
    #[serde(default)]
    unit: Option<String>,
}

impl fmt::Display for Restriction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.r#type)?;
        self.value.map_or(Ok(()), |value| write!(f, " {value}"))?;
        self.unit.as_ref().map_or(Ok(()), |unit| write!(f, " {unit}"))
    }
}
