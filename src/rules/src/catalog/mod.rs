//! The catalog: every rule, in groups. A file has rules that belong together, each entry beside its function.

pub(crate) mod junctions;
mod lanes;
mod network;
mod objects;
mod road;
mod signals;

use crate::rule::Rule;

/// Every rule, in the order in which they are applied.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    GROUPS.iter().flat_map(|(_, rules)| rules.iter().copied().flatten())
}

/// Groups of rules with their titles.
pub static GROUPS: &[(&str, &[&[Rule]])] = &[
    ("Road", road::RULES),
    ("Lanes", lanes::RULES),
    ("Objects", objects::RULES),
    ("Header, signals and controllers", signals::RULES),
    ("Junctions", junctions::RULES),
    ("The whole network", network::RULES),
];
