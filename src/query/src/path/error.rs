//! Why there is no path.

use crate::error::QueryError;
use thiserror::Error;

/// Why there is no path. Steps are counted from 0.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PathError {
    /// There is nothing to drive: no steps, or none of any length.
    #[error("the steps have no length to drive")]
    Empty,
    /// A step's lane cannot be asked.
    #[error("step {step}: {source}")]
    Step {
        /// The step.
        step: usize,
        /// What is wrong with it.
        source: QueryError,
    },
    /// A step goes against its own direction.
    #[error("step {step} ends before its beginning")]
    Backwards {
        /// The step.
        step: usize,
    },
    /// A part of a step lies outside its lane's section.
    #[error("step {step} has a part outside its lane")]
    OutsideLane {
        /// The step.
        step: usize,
    },
    /// No edge of the lane graph leads into a step's lane from the one before.
    #[error("step {step} does not follow the one before: no link leads from lane to lane")]
    NotLinked {
        /// The step.
        step: usize,
    },
    /// A step's lane is entered by a change of lane, and does not lie beside the one before.
    #[error("step {step} does not lie beside the one before on the side that is changed to")]
    NotBeside {
        /// The step.
        step: usize,
    },
    /// A step's lane is entered by a change that is not allowed there.
    #[error("step {step} is entered by a change of lane that is not allowed there")]
    ChangeForbidden {
        /// The step.
        step: usize,
    },
    /// An option out of its domain.
    #[error("the option {0} is out of its domain")]
    Option(&'static str),
    /// The path is on another map than what it is asked of.
    #[error(transparent)]
    Map(#[from] QueryError),
    /// Two S that should be finite and in order are not.
    #[error("a part of a path begins and ends at finite S, the smaller one first")]
    NotInOrder,
    /// The steps are not those that the path was built on.
    #[error("the steps are not those that the path was built on")]
    OtherSteps,
}
