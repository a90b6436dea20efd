//! What a pose, its covariance and the options must be.

use super::{MatchOptions, VehiclePose};
use crate::error::QueryError;
use crate::types::is_coordinate;
use glam::DMat3;
use thiserror::Error;

/// By what share of the variances' product a minor of a covariance may fall below 0: rounding where somebody turned it.
const ROUNDING: f64 = 1e-9;

/// Why a pose has no match.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MatchError {
    /// A part of the pose is not a finite number, or beyond 10⁹ (m, or rad).
    #[error("{0} of the pose is not a finite number of at most 1e9")]
    Pose(&'static str),
    /// An entry of the covariance is not a finite number.
    #[error("covariance[{0}][{1}] is not a finite number")]
    NotFinite(usize, usize),
    /// A variance is negative.
    #[error("covariance[{0}][{0}] is negative")]
    Negative(usize),
    /// The covariance is not symmetric.
    #[error("covariance[{0}][{1}] and covariance[{1}][{0}] differ")]
    Asymmetric(usize, usize),
    /// A covariance is greater than its variances allow.
    #[error("covariance[{0}][{1}] is greater than its variances allow: not positive semi-definite")]
    Indefinite(usize, usize),
    /// Each pair is possible, all three together are not.
    #[error("the covariance's determinant is negative: not positive semi-definite")]
    Determinant,
    /// An option out of its domain.
    #[error("the option {0} is out of its domain")]
    Option(&'static str),
    /// A fix of a trace, by its number from 0, has a part that is not a finite number.
    #[error("fix {0} has a part that is not a finite number")]
    Fix(usize),
    /// A fix of a trace, by its number from 0, is earlier than the one before.
    #[error("fix {0} is earlier than the one before")]
    Time(usize),
    /// A fix of a running drive is earlier than the one before.
    #[error("the fix is earlier than the one before")]
    Earlier,
    /// Covariances that are neither one nor as many as the poses.
    #[error("there are neither one nor as many covariances as poses")]
    Covariances,
    /// The query itself failed.
    #[error(transparent)]
    Query(QueryError),
}

pub(super) fn check_pose(pose: &VehiclePose) -> Result<(), MatchError> {
    let (xy, z) = (pose.position.xy, pose.position.z.unwrap_or(0.0));
    let parts = [("x", xy.x), ("y", xy.y), ("z", z), ("heading", pose.heading)];
    match parts.iter().find(|(_, value)| !is_coordinate(*value)) {
        Some((name, _)) => Err(MatchError::Pose(name)),
        None => Ok(()),
    }
}

pub(super) fn check_options(options: &MatchOptions<'_>) -> Result<(), MatchError> {
    let is_share = |value: f64| value > 0.0 && value <= 1.0;
    let rules = [
        ("drive_deviation", options.drive_deviation >= 0.0 && options.drive_deviation.is_finite()),
        ("none", options.none > 0.0 && options.none.is_finite()),
        ("closed", is_share(options.closed)),
        ("unexpected", is_share(options.unexpected)),
        ("z_tolerance", options.z_tolerance.is_none_or(|by| by >= 0.0 && by.is_finite())),
    ];
    match rules.iter().find(|(_, holds)| !holds) {
        Some((name, _)) => Err(MatchError::Option(name)),
        None => options.outline.map_or(Ok(()), |outline| outline.check()),
    }
}

/// All principal minors of a matrix that is positive semi-definite are not negative.
pub(super) fn check_covariance(covariance: &DMat3) -> Result<(), MatchError> {
    let at = |row: usize, column: usize| covariance.col(column)[row];
    let variances = [at(0, 0), at(1, 1), at(2, 2)];
    for row in 0..3 {
        if let Some(column) = (0..3).find(|column| !at(row, *column).is_finite()) {
            return Err(MatchError::NotFinite(row, column));
        }
    }
    if let Some(i) = variances.iter().position(|variance| *variance < 0.0) {
        return Err(MatchError::Negative(i));
    }
    for [row, column] in [[0, 1], [0, 2], [1, 2]] {
        let (a, b) = (at(row, column), at(column, row));
        let product = variances[row] * variances[column];
        if (a - b).abs() > ROUNDING * product.sqrt() {
            return Err(MatchError::Asymmetric(row, column));
        }
        if a * b > product * (1.0 + ROUNDING) {
            return Err(MatchError::Indefinite(row, column));
        }
    }
    let product: f64 = variances.iter().product();
    if covariance.determinant() < -ROUNDING * product {
        Err(MatchError::Determinant)
    } else {
        Ok(())
    }
}
