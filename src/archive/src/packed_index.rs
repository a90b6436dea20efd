//! Numbers that writer and readers of the packed R-trees share: part of the meaning of `index_nodes`, `index_leaves` and the
//! trees over objects and signals, and of `lane_blocks`.

/// Children of a node, places of a leaf.
pub const WIDTH: usize = 16;

/// Most levels of a tree: 16⁸ places below it. A damaged archive may state more.
pub const LEVELS: usize = 8;

/// Metres in a unit of a leaf's `reach` and `overshoot`.
pub const REACH_UNIT: f32 = 1.0 / 128.0;

/// Metres in a unit of a leaf's `z_low` and `z_high`.
pub const HEIGHT_UNIT: f32 = 1.0 / 16.0;

/// In a leaf's `reach`, `overshoot` and `z_high`: any distance.
pub const ANY: u16 = u16::MAX;

/// Lanes of a row of `lane_blocks`.
pub const LANES_PER_BLOCK: u32 = u64::BITS;
