//! The packed spatial indexes: of lanes, objects and signals; and what queries read ahead by.

mod lane_blocks;
mod lane_lengths;
mod lane_lines;
mod lanes;
mod objects;
mod packed;
mod signals;

pub(crate) use lane_blocks::build as lane_blocks;
pub(crate) use lane_lengths::build as lane_lengths;
pub(crate) use lanes::build as lanes;
pub(crate) use objects::build as objects;
pub(crate) use signals::build as signals;
