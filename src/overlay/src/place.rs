//! Where, as it was given.

use serde::{Deserialize, Serialize};
use std::fmt;

/// A stretch of a road's lanes, given by the road or by the key of a lane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LaneStretch {
    /// The road.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub road: Option<RoadId>,
    /// Number of the lane; all lanes of the road if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lane: Option<i32>,
    /// Key of a lane, `road:section:lane`, instead of road and number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// Start and end on the road, s `[m]`; the whole road if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s: Option<[f64; 2]>,
}

/// Id of a road, as text or as a number.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum RoadId {
    /// As text.
    Text(String),
    /// As a number.
    Number(i64),
}

impl fmt::Display for RoadId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}

/// A line or an area on Earth, by latitude and longitude.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EarthPlace {
    /// A line in the direction of travel: latitude and longitude of its points `[deg]`, WGS 84.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub line: Vec<[f64; 2]>,
    /// Instead of a line, the corners of an area: latitude and longitude `[deg]`, WGS 84.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub area: Vec<[f64; 2]>,
    /// How far beside it lanes may lie `[m]`: of a line the nearest one, 3 if not given; of an area all of them, 0 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Of a line, which lanes of those driven its way.
    #[serde(default, skip_serializing_if = "Across::is_nearest")]
    pub lanes: Across,
    /// Of numbered lanes, how many there are: where there are others, nothing is meant.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<u32>,
}

/// Which lanes of a road, of those driven one way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Across {
    /// In a word.
    Word(AcrossWord),
    /// By number, from 1 at the left as traffic goes.
    Order(Vec<u32>),
}

impl Default for Across {
    fn default() -> Self {
        Self::Word(AcrossWord::Nearest)
    }
}

impl Across {
    fn is_nearest(&self) -> bool {
        *self == Self::default()
    }
}

/// Which lanes of a road, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum AcrossWord {
    /// The nearest.
    Nearest,
    /// All.
    All,
}

impl EarthPlace {
    /// Faults that show without a map: field and reason.
    pub(crate) fn wrong(&self) -> Option<(String, &'static str)> {
        let field = |name: &str, why| Some((name.to_owned(), why));
        match (self.line.len(), self.area.len()) {
            (0, 0) => return field("line", "names neither a line nor an area"),
            (0, 1 | 2) => return field("area", "expected three corners or more"),
            (1, 0) => return field("line", "expected two points or more"),
            (0, _) | (_, 0) => {}
            _ => return field("area", "stands in the place of a line"),
        }
        for (name, points) in [("line", &self.line), ("area", &self.area)] {
            let outside = |[latitude, longitude]: &[f64; 2]| {
                !((-90.0..=90.0).contains(latitude) && (-180.0..=180.0).contains(longitude))
            };
            if let Some(i) = points.iter().position(outside) {
                return Some((
                    format!("{name}[{i}]"),
                    "expected latitude and longitude in degrees",
                ));
            }
        }
        if self.tolerance.is_some_and(|m| !(0.0..=WIDEST_TOLERANCE).contains(&m)) {
            return field("tolerance", "expected a distance from 0 m to 100 m");
        }
        match (&self.lanes, self.of) {
            _ if !self.area.is_empty() && (self.of.is_some() || !self.lanes.is_nearest()) => {
                field("lanes", "an area means all lanes in it")
            }
            (Across::Order(_), None) => field("of", "numbered lanes need how many there are"),
            (Across::Word(_), Some(_)) => field("of", "only numbered lanes have it"),
            (Across::Order(order), Some(of)) => {
                let known = |number: &u32| (1..=of).contains(number);
                let is_wrong = order.is_empty() || !order.iter().all(known);
                if is_wrong { field("lanes", "expected numbers from 1 to `of`") } else { None }
            }
            (Across::Word(_), None) => None,
        }
    }
}

/// Widest tolerance of a place on Earth `[m]`.
pub const WIDEST_TOLERANCE: f64 = 100.0;

impl LaneStretch {
    pub(crate) fn wrong(&self) -> Option<(&'static str, &'static str)> {
        match (&self.road, &self.key) {
            (None, None) => return Some(("road", "names neither a road nor a key")),
            (Some(_), Some(_)) => return Some(("key", "stands in the place of road and lane")),
            _ => {}
        }
        if self.key.is_some() && self.lane.is_some() {
            return Some(("lane", "the key names it"));
        }
        if self.lane == Some(0) {
            return Some(("lane", "lane 0 is a line; nobody drives on it"));
        }
        match self.s {
            Some([from, to]) if !(from.is_finite() && to.is_finite() && from < to) => {
                Some(("s", "expected two numbers, the smaller first"))
            }
            _ => None,
        }
    }
}
