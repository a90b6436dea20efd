//! Rules of the road by country: who goes first where nothing is written.

use crate::generated::road_rules::RULES;

/// A side from which traffic comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FromSide {
    /// From the right.
    Right,
    /// From the left.
    Left,
}

/// What a country's law says where neither signs, lights nor the file's priorities do. That it holds at a place is for the caller to know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RoadRules {
    /// Two letters of ISO 3166-1.
    pub country: &'static str,
    /// Traffic from this side has priority at a crossing of equal roads; none if there is no such rule.
    pub from_side: Option<FromSide>,
    /// Whether who turns across oncoming traffic gives way to it.
    pub turn: bool,
    /// Where the law says so.
    pub source: &'static str,
}

impl RoadRules {
    /// All countries whose rules are known, by their letters.
    pub const ALL: &'static [Self] = RULES;

    /// The rules of a country by its two letters, in either case; none where they are not known.
    pub fn of(country: &str) -> Option<&'static Self> {
        RULES.iter().find(|own| own.country.eq_ignore_ascii_case(country))
    }
}
