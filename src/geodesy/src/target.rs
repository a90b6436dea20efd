//! Target frames: what a map may be compiled into.

use crate::projector::Geodetic;
use crate::reference::{Reference, ReferenceError};
use crate::utm::UtmZone;
use crate::warning::DefinitionWarning;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Word for the zone of UTM that the map's middle lies in.
const UTM: &str = "utm";
/// What an east-north-up frame begins with.
const ENU: &str = "enu:";

/// A frame to compile a map into.
///
/// ```
/// use mapd_geodesy::{Geodetic, Target};
///
/// let target: Target = "utm".parse().unwrap();
/// let munich = Geodetic { latitude: 48.14, longitude: 11.57, altitude: 0.0 };
/// assert_eq!(target.definition(munich), "+proj=utm +zone=32 +datum=WGS84");
/// assert!("epsg:4326".parse::<Target>().is_err(), "degrees are no plane");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    text: String,
    /// None: by the map's middle.
    definition: Option<String>,
    warnings: Vec<DefinitionWarning>,
}

/// Why a target frame is none.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum TargetError {
    /// There is no text.
    #[error("expected an EPSG code, PROJ parameters, utm or enu:LAT,LON[,ALT]")]
    Empty,
    /// The origin of an east-north-up frame is none.
    #[error(
        "expected enu:LAT,LON[,ALT] with a latitude of −90 to 90, a longitude of −180 to 180 degrees and an altitude in metres, found {0}"
    )]
    Origin(String),
    /// It is no projection that is known here.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
}

impl Target {
    /// As it was asked for.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What is understood of it only in part.
    pub fn warnings(&self) -> &[DefinitionWarning] {
        &self.warnings
    }

    /// PROJ parameters of the frame for a map with this middle. Zones of UTM are the regular ones, 6 degrees wide, without
    /// the exceptions around Norway.
    pub fn definition(&self, middle: Geodetic) -> String {
        if let Some(definition) = &self.definition {
            return definition.clone();
        }
        UtmZone::regular(middle.latitude, middle.longitude).definition()
    }
}

impl FromStr for Target {
    type Err = TargetError;

    /// An EPSG code, PROJ parameters or well-known text as in georeferences, `utm`, or `enu:LAT,LON[,ALT]`.
    fn from_str(text: &str) -> Result<Self, TargetError> {
        let text = text.trim();
        let new = |definition: Option<String>, warnings: Vec<DefinitionWarning>| Self {
            text: text.to_owned(),
            definition,
            warnings,
        };
        if text.eq_ignore_ascii_case(UTM) {
            return Ok(new(None, Vec::new()));
        }
        let is_enu = text.get(..ENU.len()).is_some_and(|start| start.eq_ignore_ascii_case(ENU));
        if let Some(origin) = text.get(ENU.len()..).filter(|_| is_enu) {
            let definition = enu(origin).ok_or_else(|| TargetError::Origin(text.to_owned()))?;
            return Ok(new(Some(definition), Vec::new()));
        }
        let reference = Reference::read(text).ok_or(TargetError::Empty)?;
        Ok(new(Some(reference.definition?), reference.warnings))
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Parameters of a topocentric frame's plane.
fn enu(origin: &str) -> Option<String> {
    let numbers: Result<Vec<f64>, _> =
        origin.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let (latitude, longitude, altitude) = match *numbers.ok()?.as_slice() {
        [latitude, longitude] => (latitude, longitude, 0.0),
        [latitude, longitude, altitude] => (latitude, longitude, altitude),
        _ => return None,
    };
    let known = latitude.abs() <= 90.0 && longitude.abs() <= 180.0 && altitude.is_finite();
    known.then(|| {
        format!(
            "+proj=topocentric +lat_0={latitude} +lon_0={longitude} +h_0={altitude} +datum=WGS84"
        )
    })
}
