//! Height of a road's surface above its reference plane, over (s, t).
//!
//! Each profile of OpenDRIVE is a function of plain numbers that the caller has looked up for its s. Heights are metres
//! along the normal of the plane that superelevation rolls (along z where there is none); slopes are derivatives by s and
//! by t. t is positive to the left.

mod crossfall;
mod grid;
mod lane_height;
mod shape;
mod strips;

pub use crossfall::crossfall;
pub use grid::{CellCorner, grid_cell, transition};
pub use lane_height::{LaneRise, lane_height};
pub use shape::{Station, shape};
pub use strips::{StripProfile, strip_heights};

/// A height with its slopes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Height {
    /// Above the reference plane `[m]`.
    pub h: f64,
    /// Slope along the road, by s at constant t.
    pub by_s: f64,
    /// Slope across the road, by t at constant s.
    pub by_t: f64,
}

impl core::ops::Add for Height {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { h: self.h + other.h, by_s: self.by_s + other.by_s, by_t: self.by_t + other.by_t }
    }
}

/// A value over s and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along {
    /// The value.
    pub value: f64,
    /// Its derivative by s.
    pub by_s: f64,
}
