//! The lanes that many uncertain poses may be in.

use super::BatchScratch;
use crate::map::Map;
use crate::matching::{LaneMatch, MatchError, MatchOptions, VehiclePose};
use glam::DMat3;
use thiserror::Error;

/// Why one of several poses has no match.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("pose {pose}: {source}")]
pub struct PoseError {
    /// Its number, from 0.
    pub pose: usize,
    /// Why.
    pub source: MatchError,
}

/// The lanes that poses may be in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseMatches {
    none: Vec<f64>,
    /// Where the matches of each pose begin, and their end.
    ranges: Vec<[usize; 2]>,
    matches: Vec<LaneMatch>,
    own: Vec<LaneMatch>,
}

impl PoseMatches {
    /// For how many poses there are answers.
    pub fn len(&self) -> usize {
        self.none.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.none.is_empty()
    }

    /// Probability that a pose is in no lane, for each pose in order.
    pub fn none(&self) -> &[f64] {
        &self.none
    }

    /// The lanes of a pose, by its number, the most probable one first; none of a pose that is not there.
    pub fn of(&self, pose: usize) -> &[LaneMatch] {
        let range = self.ranges.get(pose).copied();
        range.and_then(|[from, to]| self.matches.get(from..to)).unwrap_or(&[])
    }

    fn reset(&mut self, count: usize) {
        self.matches.clear();
        self.none.clear();
        self.none.resize(count, 0.0);
        self.ranges.clear();
        self.ranges.resize(count, [0; 2]);
    }
}

impl Map<'_> {
    /// [`Map::match_pose`] of many poses, in their order, bit for bit. There is one covariance for all of them, or one for each. `out` is
    /// emptied first; it and `scratch` grow only if they are too small.
    ///
    /// Errors: as [`Map::match_pose`], by the number of the first pose that has one; of the first that has no covariance, or of
    /// which there are too many, [`MatchError::Covariances`].
    pub fn match_poses(
        &self,
        poses: &[VehiclePose],
        covariances: &[DMat3],
        options: &MatchOptions<'_>,
        scratch: &mut BatchScratch,
        out: &mut PoseMatches,
    ) -> Result<(), PoseError> {
        out.reset(0);
        let count = poses.len();
        if covariances.len() != count && (covariances.len() != 1 || count == 0) {
            let pose = covariances.len().min(count);
            return Err(PoseError { pose, source: MatchError::Covariances });
        }
        out.reset(count);
        let PoseMatches { none, ranges, matches, own } = out;
        let place = |i: usize| poses.get(i).map_or(glam::DVec2::NAN, |pose| pose.position.xy);
        let ask = |i: usize, own: &mut Vec<LaneMatch>| {
            let given =
                poses.get(i).zip(covariances.get(if covariances.len() == 1 { 0 } else { i }));
            let (pose, covariance) = given.ok_or(MatchError::Covariances)?;
            self.match_pose(pose, covariance, options, own)
        };
        let asked: Result<(), MatchError> = scratch.order.each(count, place, |i| {
            let found = ask(i, own)?;
            if let (Some(none), Some(range)) = (none.get_mut(i), ranges.get_mut(i)) {
                (*none, *range) = (found, [matches.len(), matches.len() + own.len()]);
            }
            matches.extend_from_slice(own);
            Ok(())
        });
        if asked.is_err() {
            // Of several the first in the caller's order, whichever was asked first.
            let first = (0..count).find_map(|pose| {
                let source = ask(pose, own).err()?;
                Some(PoseError { pose, source })
            });
            out.reset(0);
            return first.map_or(Ok(()), Err);
        }
        Ok(())
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for PoseMatches {
    /// For each pose the probability that it is in no lane, and its lanes.
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq((0..self.len()).map(|pose| (self.none.get(pose), self.of(pose))))
    }
}
