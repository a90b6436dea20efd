//! The catalog: every rule, in groups. A file has rules that belong together, each entry beside its function. What no function of these looks for has its entries in
//! `reading` and [`building`]: mapd writes no finding whose id is not here.

pub mod building;
pub(crate) mod junctions;
mod lanes;
mod network;
mod objects;
mod reading;
mod road;
mod signals;

use crate::rule::Rule;
pub(crate) use road::plan_view::{GAP, KINK, S_ROUNDING};
pub use road::poly::COMPUTABLE;

/// Every rule, in the order in which they are applied.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    GROUPS.iter().flat_map(|(_, rules)| rules.iter().copied().flatten())
}

/// The rule of an id; none where there is none.
pub fn of(id: &str) -> Option<&'static Rule> {
    all().find(|rule| rule.id == id)
}

/// Groups of rules with their titles.
pub static GROUPS: &[(&str, &[&[Rule]])] = &[
    ("Road", road::RULES),
    ("Lanes", lanes::RULES),
    ("Objects", objects::RULES),
    ("Header, signals and controllers", signals::RULES),
    ("Junctions", junctions::RULES),
    ("The whole network", network::RULES),
    ("Reading", reading::RULES),
    ("Building", building::RULES),
];
