//! Georeferences as files have them.

use crate::offset::Offset;
use crate::parameters::canonical;
use crate::projector::{DefinitionError, Projector};
use crate::warning::DefinitionWarning;
use thiserror::Error;

/// Longest text that is looked at `[bytes]`: compound WKT 2 has some thousand.
const LONGEST: usize = 65_536;
/// Deepest nesting of WKT: real ones have about 8.
const DEEPEST: usize = 32;
/// Longest part of a text that messages repeat `[bytes]`.
const SHOWN: usize = 80;

/// How a georeference is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// There is none, or it is empty.
    Absent,
    /// PROJ parameters, as OpenDRIVE wants them.
    Proj,
    /// PROJ parameters without a projection, such as `+lat_0=49 +lon_0=8` in maps of CARLA.
    Parameters,
    /// A code of EPSG's.
    Epsg,
    /// Well-known text 1.
    Wkt1,
    /// Well-known text 2 (ISO 19162).
    Wkt2,
    /// None of these.
    Other,
}

/// Why a georeference cannot be used.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReferenceError {
    /// Neither PROJ parameters nor WKT nor a code.
    #[error("expected PROJ parameters, well-known text or an EPSG code")]
    Unrecognized,
    /// Too long or nested too deep.
    #[error("expected at most {LONGEST} bytes, nested at most {DEEPEST} deep")]
    TooLarge,
    /// No such code.
    #[error("the EPSG projection {0} is not supported")]
    Code(String),
    /// The well-known text is not understood.
    #[error("the well-known text is not understood: {0}")]
    Wkt(String),
    /// It has degrees or geocentric coordinates.
    #[error(
        "it is no projection: coordinates would be degrees or geocentric, and OpenDRIVE's are metres in a plane"
    )]
    Geographic,
    /// The datum is given by a grid file.
    #[error("the datum is shifted by the grid {0}, and grids are not supported")]
    Grid(String),
    /// A parameter has no number where one is expected.
    #[error("expected a number for {name}, found {value:?}")]
    Value {
        /// Name of the parameter.
        name: String,
        /// What it is.
        value: String,
    },
    /// The projection is not supported.
    #[error("{0}")]
    Projection(String),
}

/// A georeference that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// How it is written.
    pub form: Form,
    /// PROJ parameters that a [`Projector`] is built from.
    pub definition: Result<String, ReferenceError>,
    /// What is understood only in part.
    pub warnings: Vec<DefinitionWarning>,
}

impl Reference {
    /// Reads the text of `header/geoReference` (ASAM OpenDRIVE 1.8.1, 8.4.2); none where the text is empty.
    pub fn read(text: &str) -> Option<Self> {
        let text = text.trim().trim_matches(['"', '\'']).trim();
        if text.is_empty() {
            return None;
        }
        if text.len() > LONGEST || depth(text) > DEEPEST {
            let definition = Err(ReferenceError::TooLarge);
            return Some(Self { form: Form::Other, definition, warnings: Vec::new() });
        }
        let form = form(text);
        let read = match form {
            Form::Absent | Form::Other => Err(ReferenceError::Unrecognized),
            Form::Proj | Form::Parameters => canonical(text),
            Form::Epsg => code(text).and_then(|(text, doubts)| {
                let (definition, mut warnings) = canonical(text)?;
                warnings.extend(doubts);
                Ok((definition, warnings))
            }),
            Form::Wkt1 | Form::Wkt2 => {
                let text = proj4wkt::wkt_to_projstring(text);
                text.map_err(|error| ReferenceError::Wkt(shown(&error.to_string())))
                    .and_then(|text| canonical(&text))
            }
        };
        let (definition, warnings) = match read {
            Ok((definition, warnings)) => (tried(definition), warnings),
            Err(error) => (Err(error), Vec::new()),
        };
        Some(Self { form, definition, warnings })
    }
}

/// The definition, if a projector can be built from it.
fn tried(definition: String) -> Result<String, ReferenceError> {
    match Projector::new(&definition, Offset::default()) {
        Ok(_) => Ok(definition),
        Err(DefinitionError::Unusable { reason, .. }) => Err(ReferenceError::Projection(reason)),
        Err(error) => Err(ReferenceError::Projection(error.to_string())),
    }
}

fn depth(text: &str) -> usize {
    let mut depth = 0usize;
    let mut deepest = 0;
    for byte in text.bytes() {
        match byte {
            b'[' | b'(' => depth += 1,
            b']' | b')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}

fn form(text: &str) -> Form {
    if let Some(keyword) = wkt_keyword(text) {
        let first = ["PROJCS", "GEOGCS", "GEOCCS", "COMPD_CS", "VERT_CS", "LOCAL_CS", "FITTED_CS"];
        let first = first.iter().any(|name| keyword.eq_ignore_ascii_case(name));
        return if first { Form::Wkt1 } else { Form::Wkt2 };
    }
    if epsg(text).is_some() {
        return Form::Epsg;
    }
    let has = |name: &str| {
        text.split_whitespace().any(|word| {
            word.trim_start_matches('+')
                .strip_prefix(name)
                .is_some_and(|tail| tail.starts_with('='))
        })
    };
    match (has("proj"), has("lat_0") && has("lon_0")) {
        (true, _) => Form::Proj,
        (false, true) => Form::Parameters,
        (false, false) => Form::Other,
    }
}

/// The first keyword of a well-known text.
fn wkt_keyword(text: &str) -> Option<&str> {
    let end = text.find(['[', '('])?;
    let keyword = text.get(..end)?.trim_end();
    let sound = !keyword.is_empty()
        && keyword.bytes().all(|byte| byte.is_ascii_alphabetic() || byte == b'_');
    sound.then_some(keyword)
}

/// Code of the projection, and of the vertical reference where there is one: `epsg:25832`, `EPSG:25832+7837`,
/// `+init=epsg:25832`, `urn:ogc:def:crs:EPSG::25832`, `http://www.opengis.net/def/crs/EPSG/0/25832`, or the bare code.
fn epsg(text: &str) -> Option<(&str, Option<&str>)> {
    let is_code = |code: &str| !code.is_empty() && code.bytes().all(|byte| byte.is_ascii_digit());
    let first = text.split_whitespace().next()?;
    let first = first.trim_start_matches('+');
    if is_code(first) && first.len() == text.len() {
        return Some((first, None));
    }
    let lower = first.to_ascii_lowercase();
    let at = lower.rfind("epsg")? + "epsg".len();
    let tail = first.get(at..)?;
    let (tail, height) = tail.split_once('+').map_or((tail, None), |(code, v)| (code, Some(v)));
    let code = tail.rsplit([':', '/']).next()?;
    (is_code(code) && tail.starts_with([':', '/'])).then_some((code, height))
}

/// Whether a definition is moved to WGS 84 without a turn or a scale: where surveyors have a shift of seven numbers, that is metres off.
fn is_only_moved(definition: &str) -> bool {
    let key = "+towgs84=";
    let shift = definition.split_whitespace().find_map(|word| word.strip_prefix(key));
    let numbers: Vec<f64> =
        shift.unwrap_or_default().split(',').filter_map(|one| one.parse().ok()).collect();
    let (moved, turned) = numbers.split_at(numbers.len().min(3));
    moved.iter().any(|number| *number != 0.0) && turned.iter().all(|number| *number == 0.0)
}

/// The parameters of a code, and the doubts that its shift and its vertical reference leave.
fn code(text: &str) -> Result<(&'static str, Vec<DefinitionWarning>), ReferenceError> {
    let (code, height) = epsg(text).ok_or(ReferenceError::Unrecognized)?;
    let known = code.parse::<u16>().ok().and_then(crs_definitions::from_code);
    let known = known.ok_or_else(|| ReferenceError::Code(shown(code)))?;
    let shift = is_only_moved(known.proj4).then(|| DefinitionWarning::Shift(shown(code)));
    let height = height.map(|height| DefinitionWarning::Height(format!("EPSG:{}", shown(height))));
    Ok((known.proj4, shift.into_iter().chain(height).collect()))
}

/// As much of a text as a message repeats.
pub(crate) fn shown(text: &str) -> String {
    text.chars().take(SHOWN).collect()
}
