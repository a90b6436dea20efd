//! Words of the map's vocabulary as options.

use crate::exit::UsageError;
use crate::similar::did_you_mean;
use anyhow::{Result, bail};
use mapd_client::LaneTypes;
use mapd_client::vocabulary::{LaneType, VehicleClass};

/// The set of lane types that names stand for.
pub(crate) fn lane_types(names: &[String]) -> Result<LaneTypes> {
    if names.is_empty() {
        return Ok(LaneTypes::ALL);
    }
    let mut set = LaneTypes::NONE;
    for name in names {
        let Some(types) = LaneTypes::from_word(name) else {
            let sets = ["all", "drivable", "routable"].into_iter();
            let known: Vec<&str> =
                sets.chain(LaneType::ALL.iter().map(|kind| kind.name())).collect();
            bail!(UsageError(format!(
                "unknown lane type {name:?}{}; known are {}",
                did_you_mean(name, known.iter().copied()),
                known.join(", ")
            )));
        };
        set = set.union(types);
    }
    Ok(set)
}

/// Who travels, by name.
///
/// Errors: no such class.
pub(crate) fn vehicle(name: &str) -> Result<VehicleClass, String> {
    match VehicleClass::from_name(name) {
        VehicleClass::Unknown => {
            let all: Vec<_> = VehicleClass::ALL.iter().map(|class| class.name()).collect();
            let meant = did_you_mean(name, all.iter().copied());
            Err(format!("expected one of {}{meant}", all.join(", ")))
        }
        known => Ok(known),
    }
}
