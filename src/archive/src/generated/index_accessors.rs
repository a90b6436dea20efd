//! Reading the rows of the index over lanes.
// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.

use super::index_rows::*;
use rkyv::rend;

impl ArchivedIndexNodeRow {
    /// `[m]` Smallest x of each child.
    #[inline]
    pub fn min_x(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.min_x)
    }
    /// `[m]` Smallest y of each child.
    #[inline]
    pub fn min_y(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.min_y)
    }
    /// `[m]` Largest x of each child.
    #[inline]
    pub fn max_x(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.max_x)
    }
    /// `[m]` Largest y of each child.
    #[inline]
    pub fn max_y(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.max_y)
    }
    /// `[m]` Smallest z of each child.
    #[inline]
    pub fn min_z(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.min_z)
    }
    /// `[m]` Largest z of each child.
    #[inline]
    pub fn max_z(&self) -> &[f32; 16] {
        bytemuck::cast_ref::<[rend::f32_le; 16], _>(&self.max_z)
    }
}

impl ArchivedIndexLeafRow {
    /// `[m]` Corner from which ends count, relative to the local origin: no end has a smaller x.
    #[inline]
    pub fn x(&self) -> f32 {
        self.x.to_native()
    }
    /// `[m]` The corner's y: no end has a smaller one.
    #[inline]
    pub fn y(&self) -> f32 {
        self.y.to_native()
    }
    /// `[m]` Height from which `z_low` and `z_high` count.
    #[inline]
    pub fn z(&self) -> f32 {
        self.z.to_native()
    }
    /// `[m]` What ends count in.
    #[inline]
    pub fn step(&self) -> f32 {
        self.step.to_native()
    }
    /// The lane; u32::MAX if unused.
    #[inline]
    pub fn lane(&self) -> &[u32; 16] {
        bytemuck::cast_ref::<[rend::u32_le; 16], _>(&self.lane)
    }
    /// `[steps]` Start of each segment.
    #[inline]
    pub fn start_x(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.start_x)
    }
    /// `[steps]` Start of each segment.
    #[inline]
    pub fn start_y(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.start_y)
    }
    /// `[steps]` End of each segment, which is never its start.
    #[inline]
    pub fn end_x(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.end_x)
    }
    /// `[steps]` End of each segment.
    #[inline]
    pub fn end_y(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.end_y)
    }
    /// Number of the segment within the lane's centre line.
    #[inline]
    pub fn segment(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.segment)
    }
    /// `[m/128]` Largest distance of the lane's area from the line through the segment.
    #[inline]
    pub fn reach(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.reach)
    }
    /// `[m/128]` Largest distance by which the lane's area exceeds the segment's ends, along it.
    #[inline]
    pub fn overshoot(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.overshoot)
    }
    /// `[m/16]` Smallest height of the lane's area above `z`.
    #[inline]
    pub fn z_low(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.z_low)
    }
    /// `[m/16]` Largest height of the lane's area above `z`.
    #[inline]
    pub fn z_high(&self) -> &[u16; 16] {
        bytemuck::cast_ref::<[rend::u16_le; 16], _>(&self.z_high)
    }
}
