//! The commands: each is what clap reads of its arguments, and what it does.

pub(crate) mod bench;
pub(crate) mod change;
pub(crate) mod check;
pub(crate) mod compile;
pub(crate) mod doctor;
pub mod export;
pub(crate) mod help;
pub(crate) mod inspect;
pub(crate) mod overlay;
pub mod query;
pub(crate) mod shell;
pub(crate) mod sign;
pub(crate) mod status;
pub(crate) mod trace;
pub(crate) mod view;
