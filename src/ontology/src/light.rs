//! What traffic lights can show.

use crate::file::{EntryFault, LightEntry};

/// Bits of a light's lamps.
pub mod bulb {
    /// Red.
    pub const RED: u8 = 1;
    /// Yellow.
    pub const YELLOW: u8 = 2;
    /// Green.
    pub const GREEN: u8 = 4;
}

/// Bits of the phases that a light can show.
pub mod phase {
    /// Red.
    pub const RED: u8 = 1;
    /// Red and yellow together.
    pub const RED_YELLOW: u8 = 2;
    /// Yellow.
    pub const YELLOW: u8 = 4;
    /// Green.
    pub const GREEN: u8 = 8;
    /// Flashing red.
    pub const FLASHING_RED: u8 = 16;
    /// Flashing yellow.
    pub const FLASHING_YELLOW: u8 = 32;
    /// Flashing green.
    pub const FLASHING_GREEN: u8 = 64;
    /// Off.
    pub const OFF: u8 = 128;
}

/// Bits of the movements that a light with arrows is for; none set: for all.
pub mod arrow {
    /// To the left.
    pub const LEFT: u8 = 1;
    /// Straight on.
    pub const STRAIGHT: u8 = 2;
    /// To the right.
    pub const RIGHT: u8 = 4;
    /// Back.
    pub const U_TURN: u8 = 8;
}

/// Lamps, phases and movements of a light, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Light {
    /// Lamps, of [`bulb`].
    pub bulbs: u8,
    /// Phases, of [`phase`].
    pub phases: u8,
    /// Movements, of [`arrow`].
    pub arrows: u8,
}

const BULBS: &[(&str, u8)] =
    &[("red", bulb::RED), ("yellow", bulb::YELLOW), ("green", bulb::GREEN)];

const PHASES: &[(&str, u8)] = &[
    ("red", phase::RED),
    ("red_yellow", phase::RED_YELLOW),
    ("yellow", phase::YELLOW),
    ("green", phase::GREEN),
    ("flashing_red", phase::FLASHING_RED),
    ("flashing_yellow", phase::FLASHING_YELLOW),
    ("flashing_green", phase::FLASHING_GREEN),
    ("off", phase::OFF),
];

const ARROWS: &[(&str, u8)] = &[
    ("left", arrow::LEFT),
    ("straight", arrow::STRAIGHT),
    ("right", arrow::RIGHT),
    ("u_turn", arrow::U_TURN),
];

fn bits(words: &[String], known: &[(&str, u8)]) -> Result<u8, EntryFault> {
    words.iter().try_fold(0, |bits, word| {
        let found = known.iter().find(|(name, _)| name == word);
        found.map(|(_, bit)| bits | bit).ok_or_else(|| EntryFault::Word(word.clone()))
    })
}

/// The bits of arrows.
pub(crate) fn arrows(words: &[String]) -> Result<u8, EntryFault> {
    bits(words, ARROWS)
}

impl LightEntry {
    pub(crate) fn light(&self) -> Result<Light, EntryFault> {
        Ok(Light {
            bulbs: bits(&self.bulbs, BULBS)?,
            phases: bits(&self.phases, PHASES)?,
            arrows: 0,
        })
    }
}
