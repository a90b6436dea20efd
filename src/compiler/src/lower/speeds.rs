//! Speeds: those of types of roads, and what a speed record says.

use super::semantics::meant;
use crate::draft::Draft;
use mapd_archive::{DefaultSpeedRow, RoadType, SpeedKind};
use mapd_ontology::Class;
use mapd_xodr::{self as xodr, Header, SpeedLimit, UnitSpeed, Value as _};

impl Draft {
    /// Speeds that the header's regulations give to types of roads (OpenDRIVE 1.8.1, 6.4).
    pub(super) fn default_speeds(&mut self, header: &Header) {
        let Some(regulations) = header.default_regulations.as_deref() else { return };
        for rule in &regulations.road_regulations {
            let word = rule.r#type.value().map_or("", xodr::RoadType::name);
            let stated = rule.semantics.as_deref().map(meant).unwrap_or_default();
            let meanings = stated.iter().map(|one| one.meaning(&self.signals.ontology));
            let limit = meanings
                .filter(|m| matches!(m.class, Class::SpeedLimit | Class::SpeedLimitZone))
                .find_map(|meaning| meaning.value);
            if let Some(max) = limit {
                let kind = RoadType::from_name(word).code();
                self.rows.default_speeds.push(DefaultSpeedRow { max, kind, reserved: [0; 7] });
            }
        }
    }
}

/// What a speed record says, in m/s. Without a unit, or with one that is none of speed, m/s is meant.
pub(super) fn speed(max: Option<SpeedLimit>, unit: Option<UnitSpeed>) -> (SpeedKind, f64) {
    match max {
        None => (SpeedKind::None, 0.0),
        Some(SpeedLimit::NoLimit) => (SpeedKind::NoLimit, 0.0),
        Some(SpeedLimit::Undefined) => (SpeedKind::Undefined, 0.0),
        Some(SpeedLimit::Limit(value)) => {
            let value = match unit {
                Some(UnitSpeed::KilometersPerHour) => value / 3.6,
                Some(UnitSpeed::MilesPerHour) => value * 0.44704,
                _ => value,
            };
            (SpeedKind::Value, value)
        }
    }
}
