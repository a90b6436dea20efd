//! Joints of junctions with an elevation grid, until their roads are known.

/// A joint of a junction with a grid.
pub(crate) struct Joint {
    pub(crate) grid: usize,
    pub(crate) road: String,
    pub(crate) contact: mapd_archive::ContactPoint,
    /// Lanes between whose outer edges the joint lies; none: the whole road.
    pub(crate) lanes: [Option<i32>; 2],
    /// Length of the transition `[m]`.
    pub(crate) length: f64,
}

/// Those of the part that comes next, whose row 0 of grids is not used, behind so many grids.
pub(super) fn behind(part: Vec<Joint>, grids: usize) -> impl Iterator<Item = Joint> {
    part.into_iter().map(move |joint| Joint { grid: joint.grid + grids - 1, ..joint })
}
