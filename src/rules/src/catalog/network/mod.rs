//! Rules on the document as a whole.

mod boundaries;
mod connections;
mod cross_paths;
mod crossings;
mod dependencies;
mod direct;
mod extent;
mod ids;
mod incoming;
mod joints;
mod lane_links;
mod levels;
mod linkage;
mod meeting;
mod overlaps;
mod topology;
mod virtual_junctions;

use crate::rule::Rule;

pub(super) static RULES: &[&[Rule]] = &[
    ids::RULES,
    dependencies::RULES,
    extent::RULES,
    linkage::RULES,
    lane_links::RULES,
    levels::RULES,
    joints::RULES,
    connections::RULES,
    incoming::RULES,
    direct::RULES,
    virtual_junctions::RULES,
    crossings::RULES,
    cross_paths::RULES,
    boundaries::RULES,
    overlaps::RULES,
    topology::RULES,
    meeting::RULES,
];
