//! Rules on objects along a road.

mod basics;
mod corners;
mod markings;
mod outlines;
mod repeats;
mod skeletons;
mod surfaces;
mod validity;

use crate::rule::Rule;

pub(super) static RULES: &[&[Rule]] = &[
    basics::RULES,
    validity::RULES,
    repeats::RULES,
    outlines::RULES,
    corners::RULES,
    markings::RULES,
    skeletons::RULES,
    surfaces::RULES,
];
