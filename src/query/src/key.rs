//! `LaneKey`: the stable name of a lane.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Characters that separate keys and their parts, percent-encoded within road ids.
const RESERVED: [char; 5] = ['%', ':', ';', ',', '@'];

/// Names a lane by what the file says: road id, number of the section in its road (from 0, in the order of s), lane
/// number, layer. May be stored and sent to other processes. Written `road:section:lane`, `…@temporary` for a lane of the
/// temporary layer.
///
/// ```
/// use mapd_query::LaneKey;
/// let key: LaneKey = "A%3A1:0:-2".parse().unwrap();
/// assert_eq!((key.road.as_ref(), key.section, key.lane), ("A:1", 0, -2));
/// assert_eq!(key.to_string(), "A%3A1:0:-2");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneKey<'a> {
    /// OpenDRIVE's id of the road.
    pub road: Cow<'a, str>,
    /// Section in its road, from 0.
    pub section: u32,
    /// OpenDRIVE's lane number: positive left, negative right.
    pub lane: i32,
    /// Layer, whose sections are counted by themselves.
    pub layer: LaneLayer,
}

/// Layer of a lane (OpenDRIVE 1.9, e_layerType).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum LaneLayer {
    /// There for good; before 1.9 all are.
    #[default]
    Permanent,
    /// Replaces others for a time, as road works do.
    Temporary,
}

/// What stands behind the key of a lane of the temporary layer.
const TEMPORARY: &str = "@temporary";

impl fmt::Display for LaneKey<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.road.chars() {
            if RESERVED.contains(&c) || c.is_control() {
                let mut bytes = [0; 4];
                c.encode_utf8(&mut bytes).bytes().try_for_each(|b| write!(f, "%{b:02X}"))?;
            } else {
                write!(f, "{c}")?;
            }
        }
        write!(f, ":{}:{}", self.section, self.lane)?;
        if self.layer == LaneLayer::Temporary { f.write_str(TEMPORARY) } else { Ok(()) }
    }
}

/// A text that is not a lane key.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("expected a lane key road:section:lane such as 12:0:-1, found {found:?}")]
pub struct ParseLaneKeyError {
    found: String,
}

impl FromStr for LaneKey<'static> {
    type Err = ParseLaneKeyError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parse = || {
            let (text, layer) = match text.strip_suffix(TEMPORARY) {
                Some(text) => (text, LaneLayer::Temporary),
                None => (text, LaneLayer::Permanent),
            };
            let mut parts = text.rsplitn(3, ':');
            let lane = parts.next()?.parse().ok()?;
            let section = parts.next()?.parse().ok()?;
            let road = decode(parts.next()?)?;
            Some(Self { road: Cow::Owned(road), section, lane, layer })
        };
        parse().ok_or_else(|| ParseLaneKeyError { found: text.to_owned() })
    }
}

/// Undoes percent-encoding; `None` for reserved characters in the open and for bad codes.
fn decode(text: &str) -> Option<String> {
    let mut out = Vec::with_capacity(text.len());
    let mut bytes = text.bytes();
    while let Some(byte) = bytes.next() {
        match byte {
            b'%' => {
                let digit = |b: u8| (b as char).to_digit(16);
                let code = digit(bytes.next()?)? * 16 + digit(bytes.next()?)?;
                out.push(u8::try_from(code).ok()?);
            }
            b if RESERVED.contains(&(b as char)) => return None,
            b => out.push(b),
        }
    }
    String::from_utf8(out).ok()
}
