//! Row types of the tables of the index over lanes.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use bytemuck::{Pod, Zeroable};
use rkyv::Archive;

/// Packed R-tree: node i of a level has children 16·i … 16·i + 15 on the next one; below the last level lie the leaves. Boxes are relative to the local origin and rounded outwards; unused places are empty boxes.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct IndexNodeRow {
    /// `[m]` Smallest x of each child.
    pub min_x: [f32; 16],
    /// `[m]` Smallest y of each child.
    pub min_y: [f32; 16],
    /// `[m]` Largest x of each child.
    pub max_x: [f32; 16],
    /// `[m]` Largest y of each child.
    pub max_y: [f32; 16],
    /// `[m]` Smallest z of each child.
    pub min_z: [f32; 16],
    /// `[m]` Largest z of each child.
    pub max_z: [f32; 16],
}
const _: () = assert!(size_of::<IndexNodeRow>() == 384 && size_of::<ArchivedIndexNodeRow>() == 384);

/// Sixteen segments of lanes' centre lines each, their ends in steps from the leaf's corner. A lane's area between a segment's ends lies in a rectangle around the segment as it stands here: `reach` to both sides, `overshoot` beyond both ends; in height between `z_low` and `z_high`. All four are rounded outwards; 65535 in `reach`, `overshoot` or `z_high` stands for any distance. Unused places have lane u32::MAX.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct IndexLeafRow {
    /// `[m]` Corner from which ends count, relative to the local origin: no end has a smaller x.
    pub x: f32,
    /// `[m]` The corner's y: no end has a smaller one.
    pub y: f32,
    /// `[m]` Height from which `z_low` and `z_high` count.
    pub z: f32,
    /// `[m]` What ends count in.
    pub step: f32,
    /// The lane; u32::MAX if unused.
    pub lane: [u32; 16],
    /// `[steps]` Start of each segment.
    pub start_x: [u16; 16],
    /// `[steps]` Start of each segment.
    pub start_y: [u16; 16],
    /// `[steps]` End of each segment, which is never its start.
    pub end_x: [u16; 16],
    /// `[steps]` End of each segment.
    pub end_y: [u16; 16],
    /// Number of the segment within the lane's centre line.
    pub segment: [u16; 16],
    /// `[m/128]` Largest distance of the lane's area from the line through the segment.
    pub reach: [u16; 16],
    /// `[m/128]` Largest distance by which the lane's area exceeds the segment's ends, along it.
    pub overshoot: [u16; 16],
    /// `[m/16]` Smallest height of the lane's area above `z`.
    pub z_low: [u16; 16],
    /// `[m/16]` Largest height of the lane's area above `z`.
    pub z_high: [u16; 16],
}
const _: () = assert!(size_of::<IndexLeafRow>() == 368 && size_of::<ArchivedIndexLeafRow>() == 368);
