//! What a signal looks like on a map.

use mapd_query::signals::Signal;
use mapd_query::vocabulary::{Class, ClassGroup};

/// Kinds of pictures. The page draws them by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum SignalSign {
    /// A grey dot: other things.
    Dot,
    /// A traffic light.
    Light,
    /// A red octagon.
    Stop,
    /// A red triangle that stands on its tip.
    Yield,
    /// A yellow square that stands on a corner.
    Priority,
    /// A red ring, with the limit beside it.
    Speed,
    /// A red disc.
    Ban,
    /// A blue disc.
    Direction,
    /// A red triangle.
    Warning,
    /// A blue square.
    Information,
    /// A flat line: what is painted on the road.
    Marking,
}

impl SignalSign {
    /// The picture of a signal.
    pub fn of(signal: &Signal<'_>) -> Self {
        match signal.class() {
            Class::Stop => Self::Stop,
            Class::Yield | Class::YieldToOncoming => Self::Yield,
            class => match class.group() {
                ClassGroup::Light => Self::Light,
                ClassGroup::RightOfWay => Self::Priority,
                ClassGroup::Speed => Self::Speed,
                ClassGroup::Ban => Self::Ban,
                ClassGroup::Direction => Self::Direction,
                ClassGroup::Warning => Self::Warning,
                ClassGroup::Information => Self::Information,
                ClassGroup::Marking => Self::Marking,
                _ => Self::Dot,
            },
        }
    }
}
