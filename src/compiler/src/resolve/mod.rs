//! Ids become rows, and the draft becomes tables.

mod annotations;
mod joints;
mod links;
mod origin;
mod quarantine;
mod signals;
mod tables;

pub(crate) use annotations::{finish as annotations, groups};
pub(crate) use links::resolve as links;
pub(crate) use quarantine::store as quarantined;
pub(crate) use signals::{PlaceWritten, Resolved, resolve as signals};
pub(crate) use tables::tables;
