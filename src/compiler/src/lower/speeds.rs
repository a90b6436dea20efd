//! Speeds: those of types of roads, what a speed record says, and whether roads have such limits.

use super::need::{ElementContext, ElementPath};
use super::semantics::meant;
use crate::draft::Draft;
use mapd_archive::{DefaultSpeedRow, RoadType, SpeedKind};
use mapd_ontology::{Class, ClassGroup, Meaning};
use mapd_rules::Rule;
use mapd_rules::catalog::building::{MOST_SPEED, MOST_WITHOUT_UNIT, SPEED_LIMIT, SPEED_PLAUSIBLE};
use mapd_xodr::{self as xodr, Finding, Header, Severity, SpeedLimit, UnitSpeed, Value as _};

impl Draft {
    /// Speeds that the header's regulations give to types of roads (OpenDRIVE 1.8.1, 6.4).
    pub(super) fn default_speeds(&mut self, header: &Header, findings: &mut Vec<Finding>) {
        let Some(regulations) = header.default_regulations.as_deref() else { return };
        for rule in &regulations.road_regulations {
            let word = rule.r#type.value().map_or("", xodr::RoadType::name);
            let stated = rule.semantics.as_deref().map(meant).unwrap_or_default();
            let path = ElementPath::of_owner("OpenDRIVE/header/defaultRegulations/roadRegulations");
            let mut part = ElementContext { span: rule.span, path, findings };
            let mut limit = None;
            for one in &stated {
                let meaning = one.meaning(&self.signals.ontology);
                if matches!(meaning.class, Class::SpeedLimit | Class::SpeedLimitZone) {
                    if one.is_unreadable {
                        unknown(NO_UNIT, &mut part);
                    }
                    sign(&meaning, &mut part);
                    limit = limit.or(meaning.value);
                }
            }
            if let Some(max) = limit {
                let kind = RoadType::from_name(word).code();
                self.rows.default_speeds.push(DefaultSpeedRow { max, kind, reserved: [0; 7] });
            }
        }
    }
}

/// Why a limit is unknown.
pub(super) const NO_UNIT: &str = "expected a unit of speed (m/s, km/h, mph) or none";

/// Whether a unit is one of speed. Without one, a number has the unit of its place: m/s in records.
pub(super) fn is_of_speed(unit: Option<&str>) -> bool {
    matches!(unit, None | Some("m/s" | "km/h" | "mph"))
}

/// Says that a limit is unknown.
pub(super) fn unknown(why: &str, part: &mut ElementContext<'_>) {
    part.add(&SPEED_LIMIT, Severity::Warning, format!("{why}; the limit is unknown"));
}

/// What a speed record says, in m/s. What is stated and cannot be read is a limit that nobody knows: what else holds on the road is not meant.
pub(super) fn speed(
    max: Option<SpeedLimit>,
    unit: Option<UnitSpeed>,
    part: &mut ElementContext<'_>,
) -> (SpeedKind, f64) {
    const UNKNOWN: (SpeedKind, f64) = (SpeedKind::Unreadable, 0.0);
    let value = match max {
        None => {
            unknown("expected @max, found none that can be used", part);
            return UNKNOWN;
        }
        Some(SpeedLimit::NoLimit) => return (SpeedKind::NoLimit, 0.0),
        Some(SpeedLimit::Undefined) => return (SpeedKind::Undefined, 0.0),
        Some(SpeedLimit::Limit(value)) => value,
    };
    if value < 0.0 {
        unknown(&format!("expected @max of at least 0, found {value}"), part);
        return UNKNOWN;
    }
    if !is_of_speed(unit.map(UnitSpeed::name)) {
        unknown(NO_UNIT, part);
        return UNKNOWN;
    }
    let max = match unit {
        Some(UnitSpeed::KilometersPerHour) => value / 3.6,
        Some(UnitSpeed::MilesPerHour) => value * 0.44704,
        _ => value,
    };
    plausible(max, unit.is_none(), part);
    (SpeedKind::Value, max)
}

/// Says so if the speed on a sign is none that roads have.
pub(super) fn sign(meaning: &Meaning, part: &mut ElementContext<'_>) {
    let Some(value) = meaning.value else { return };
    if meaning.class.group() == ClassGroup::Speed {
        plausible(value, matches!(meaning.assumed_unit, Some("SI" | "m/s")), part);
    }
}

/// Says so if a limit `[m/s]` is none that roads have.
fn plausible(max: f64, without_unit: bool, part: &mut ElementContext<'_>) {
    const RULE: &Rule = &SPEED_PLAUSIBLE;
    let most = if without_unit { MOST_WITHOUT_UNIT } else { MOST_SPEED };
    if max > most.value {
        let kmh = max * 3.6;
        let message = match without_unit {
            true => format!(
                "expected a unit beside {max}, found none: read as m/s, it is {kmh:.0} km/h"
            ),
            false => format!("expected at most {:.0} km/h, found {kmh:.0}", most.value * 3.6),
        };
        part.add(RULE, Severity::Warning, message);
    }
}
