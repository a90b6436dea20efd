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
        if name == "drivable" {
            set = LaneType::ALL
                .iter()
                .filter(|kind| kind.is_drivable())
                .fold(set, |set, kind| set.with(*kind));
            continue;
        }
        match LaneType::from_name(name) {
            LaneType::Unknown => {
                let known: Vec<&str> = LaneType::ALL.iter().map(|kind| kind.name()).collect();
                bail!(UsageError(format!(
                    "unknown lane type {name:?}{}; known are drivable, {}",
                    did_you_mean(name, known.iter().copied()),
                    known.join(", ")
                )));
            }
            kind => set = set.with(kind),
        }
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
