//! Options that several commands share, and what options are written as.

mod arguments;
mod build;
mod domain;
mod frame;
mod judging;
mod number;
mod ontology;
mod opening;
mod progress;
mod share;
mod size;
mod threads;
mod trust;
mod vocabulary;

pub(crate) use arguments::CompileArguments;
pub(crate) use build::BuildArgs;
pub(crate) use domain::DomainArgs;
pub(crate) use frame::FrameArgs;
pub(crate) use judging::JudgingArgs;
pub(crate) use number::{Seconds, at_least_one, finite, not_negative};
pub(crate) use ontology::OntologyArgs;
pub(crate) use opening::{AttachArgs, Live, OpenedSource, Opening};
pub(crate) use progress::ProgressArgs;
pub(crate) use share::ShareWith;
pub(crate) use size::Size;
pub(crate) use threads::{ThreadCount, ThreadsArg};
pub(crate) use trust::TrustArgs;
pub(crate) use vocabulary::{lane_types, vehicle};
