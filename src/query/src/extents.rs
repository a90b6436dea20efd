//! Ranges, bounds and places in files: small results with names.

use glam::DVec3;

/// Both ends of a stretch on a road `[m]`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SRange {
    /// The smaller s.
    pub low: f64,
    /// The larger s.
    pub high: f64,
}

/// A box along the axes, in inertial coordinates `[m]`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// Smallest x, y and z.
    pub low: DVec3,
    /// Largest x, y and z.
    pub high: DVec3,
}

/// Numbers of the lanes from one to another, both among them.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneRange {
    /// The lower number.
    pub from: i32,
    /// The higher number.
    pub to: i32,
}

/// A place in a file.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SourcePosition {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
}

/// A header's offset: a point p becomes R(heading)·p + shift (ASAM OpenDRIVE 1.8.1, 8.4.3).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HeaderOffset {
    /// Shift `[m]`.
    pub shift: DVec3,
    /// Turn, counter-clockwise `[rad]`.
    pub heading: f64,
}

/// The version of OpenDRIVE that a file states; zeros where it states none.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Revision {
    /// `revMajor`
    pub major: u16,
    /// `revMinor`
    pub minor: u16,
}
