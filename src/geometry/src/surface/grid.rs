//! Elevation grid of a junction, OpenDRIVE 1.8.

/// What a grid knows at a corner of a cell. Derivatives are per cell, not per metre.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellCorner {
    /// Height `[m]`.
    pub z: f64,
    /// Derivative along the junction's reference line, times the cell's length `[m]`.
    pub along: f64,
    /// Derivative across it, positive to the left, times the cell's width `[m]`.
    pub across: f64,
    /// Mixed derivative, times both `[m]`.
    pub twist: f64,
}

/// The cubic basis of Hermite at `x` ∈ [0, 1]: weights of the values at 0 and 1 and of the derivatives there.
fn hermite(x: f64) -> ([f64; 2], [f64; 2]) {
    let (x2, x3) = (x * x, x * x * x);
    ([2.0 * x3 - 3.0 * x2 + 1.0, 3.0 * x2 - 2.0 * x3], [x3 - 2.0 * x2 + x, x3 - x2])
}

/// Derivatives of [`hermite`] by x.
fn hermite_slopes(x: f64) -> ([f64; 2], [f64; 2]) {
    let x2 = x * x;
    ([6.0 * x2 - 6.0 * x, 6.0 * x - 6.0 * x2], [3.0 * x2 - 4.0 * x + 1.0, 3.0 * x2 - 2.0 * x])
}

/// Height at (`x`, `y`) ∈ [0, 1]² of a cell: bicubic through its corners (OpenDRIVE 1.8.1, 12.8), and its derivatives by x
/// and y. `corners[i][j]` lies at x = i (along the reference line), y = j (to the left).
#[must_use]
pub fn grid_cell(corners: &[[CellCorner; 2]; 2], x: f64, y: f64) -> [f64; 3] {
    let blend = |(value, slope): &([f64; 2], [f64; 2]),
                 (value_y, slope_y): &([f64; 2], [f64; 2])| {
        let mut z = 0.0;
        for i in 0..2 {
            for j in 0..2 {
                let c = &corners[i][j];
                z += value[i] * (value_y[j] * c.z + slope_y[j] * c.across)
                    + slope[i] * (value_y[j] * c.along + slope_y[j] * c.twist);
            }
        }
        z
    };
    let (at_x, at_y) = (hermite(x), hermite(y));
    [blend(&at_x, &at_y), blend(&hermite_slopes(x), &at_y), blend(&at_x, &hermite_slopes(y))]
}

/// Blend from a road's own height to the grid's over the transition at a joint: `share` ∈ [0, 1] of the transition's
/// length, counted from the joint. Flat at both ends, so that slopes meet (OpenDRIVE 1.8.1, 12.8).
#[must_use]
pub fn transition(road: f64, grid: f64, share: f64) -> f64 {
    let share = crate::clamp(share, 0.0, 1.0);
    road + (grid - road) * share * share * (3.0 - 2.0 * share)
}
