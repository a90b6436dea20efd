//! Rules on junctions by themselves.

mod connections;
mod crossings;
mod grids;
mod kinds;

use crate::rule::Rule;
use mapd_xodr::{Junction, JunctionType};

pub(super) static RULES: &[&[Rule]] =
    &[kinds::RULES, connections::RULES, crossings::RULES, grids::RULES];

/// The kind of a junction.
pub(crate) fn kind(junction: &Junction) -> JunctionType {
    junction.r#type.map_or(JunctionType::Default, |kind| kind.value)
}
