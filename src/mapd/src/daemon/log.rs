//! What the daemon says while it runs.

pub(crate) use crate::oversight::log::{relay, say};
