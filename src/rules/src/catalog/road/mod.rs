//! Rules on roads by themselves.

mod crg;
mod jumps;
mod lateral;
mod links;
pub(crate) mod plan_view;
pub(crate) mod poly;
mod railroad;
mod records;
mod redundant;
mod types;

use crate::rule::Rule;

pub(super) static RULES: &[&[Rule]] = &[
    plan_view::RULES,
    poly::RULES,
    records::RULES,
    lateral::RULES,
    jumps::RULES,
    types::RULES,
    links::RULES,
    crg::RULES,
    railroad::RULES,
    redundant::RULES,
];
