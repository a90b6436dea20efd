//! Lateral shape: cubics across the road at stations along it.

use super::Height;
use crate::cubic::Cubic;

/// The profile of a station: its place and the cubic that covers a t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Where the station lies on the road `[m]`.
    pub s: f64,
    /// Where the cubic begins `[m]`.
    pub t: f64,
    /// The cubic over t − `t`.
    pub cubic: Cubic,
}

impl Station {
    fn at(&self, t: f64) -> (f64, f64) {
        let dt = t - self.t;
        (self.cubic.value(dt), self.cubic.derivative(dt))
    }
}

/// Height at (`s`, `t`) `[m]` between the station before and the one behind, linear in s between their profiles
/// (OpenDRIVE 1.8.1, 10.5.3). Before the first station or behind the last one that profile holds.
///
/// Of each station the caller gives the record that starts last at or below t; if none does, the first one, whose cubic
/// then goes on beyond its start.
#[must_use]
pub fn shape(before: Station, behind: Option<Station>, s: f64, t: f64) -> Height {
    let (from, slope) = before.at(t);
    let held = Height { h: from, by_s: 0.0, by_t: slope };
    let Some(behind) = behind else { return held };
    let length = behind.s - before.s;
    if length <= 0.0 || s <= before.s {
        return held;
    }
    let (to, slope_to) = behind.at(t);
    let share = ((s - before.s) / length).min(1.0);
    Height {
        h: from + share * (to - from),
        by_s: (to - from) / length,
        by_t: slope + share * (slope_to - slope),
    }
}
