//! What is asked and answered.

use super::status::{DaemonStatus, ReloadReport};
use serde::{Deserialize, Serialize};

/// What is asked of a daemon.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "command", rename_all = "kebab-case")]
pub enum Request {
    /// Everything about the daemon and all its maps.
    Status,
    /// Compile a map's source again and serve it.
    Reload {
        /// The map.
        map: String,
        /// Leave it for [`Request::Activate`].
        stage: bool,
    },
    /// Serve the generation before again, under a new number.
    Rollback {
        /// The map.
        map: String,
        /// Leave it for [`Request::Activate`].
        stage: bool,
    },
    /// Serve what is staged.
    Activate {
        /// The map.
        map: String,
    },
}

/// What a daemon answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Response {
    /// To [`Request::Status`].
    Status(Box<DaemonStatus>),
    /// To everything else: how it ended.
    Done(ReloadReport),
    /// The request cannot be understood, or names a map that this daemon does not serve.
    Refused {
        /// Why.
        reason: String,
    },
}
