//! Warnings about georeferences that are understood only in part.

use std::fmt;

/// A warning about a georeference that can be used nevertheless.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DefinitionWarning {
    /// There are parameters but no projection.
    Assumed,
    /// Neither datum nor shift to WGS 84 is given and the ellipsoid is another: no shift is applied.
    Datum,
    /// Datum, ellipsoid and shift contradict each other.
    Mixed,
    /// The definition of a code has a shift to WGS 84 by three numbers, where others use a better one.
    Shift(String),
    /// The height's reference is a geoid or a vertical datum.
    Height(String),
    /// Heights are said to have another unit than metres.
    HeightUnit(String),
    /// Coordinates are said to have another unit than metres.
    Unit(String),
    /// The axes are said to point elsewhere than east, north and up.
    Axes(String),
    /// Parameters that are not known.
    Ignored(String),
    /// Parameters that UTM has values of its own for, and these are others.
    NoEffect(String),
}

impl DefinitionWarning {
    /// Whether latitudes and longitudes may be wrong because of it, which makes it a warning; others are only information.
    pub fn is_grave(&self) -> bool {
        !matches!(self, Self::Height(_))
    }
}

impl fmt::Display for DefinitionWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Assumed => f.write_str(
                "the georeference names no projection: transverse Mercator about its lat_0 and lon_0 on WGS 84 is assumed",
            ),
            Self::Datum => f.write_str(
                "the georeference has an ellipsoid but neither datum nor towgs84: latitudes and longitudes are not shifted to WGS 84 and may be hundreds of metres off",
            ),
            Self::Mixed => f.write_str(
                "the georeference mixes datums: its datum contradicts its ellipsoid or towgs84; the latter two count",
            ),
            Self::Shift(code) => write!(
                f,
                "EPSG:{code} is shifted to WGS 84 by three numbers; by default PROJ takes a better shift where it has one: latitudes and longitudes may be ten metres off"
            ),
            Self::Height(name) => write!(
                f,
                "heights are above {name}, which is not applied: altitudes are the map's own z"
            ),
            Self::HeightUnit(unit) => write!(
                f,
                "the georeference gives heights in {unit}; z is taken in metres, as OpenDRIVE wants it"
            ),
            Self::Unit(unit) => write!(
                f,
                "the georeference gives coordinates in {unit}; x and y are taken in metres, as OpenDRIVE wants them"
            ),
            Self::Axes(axes) => write!(
                f,
                "the georeference turns the axes ({axes}); x is taken as east, y as north and z as up, as OpenDRIVE wants them"
            ),
            Self::Ignored(parameter) => {
                write!(f, "parameters of the georeference that are not known are ignored: {parameter}")
            }
            Self::NoEffect(parameters) => write!(
                f,
                "parameters of the georeference have no effect with +proj=utm, which has its own: {parameters}"
            ),
        }
    }
}
