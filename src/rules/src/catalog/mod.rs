//! The catalog: every rule, in groups.

use crate::rule::Rule;

/// Every rule, in the order in which they are applied.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    GROUPS.iter().flat_map(|(_, rules)| rules.iter().copied().flatten())
}

/// Groups of rules with their titles.
pub static GROUPS: &[(&str, &[&[Rule]])] = &[];
