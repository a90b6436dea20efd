//! What is asked and answered.

use super::status::{DaemonStatus, ReloadReport};
use mapd_overlay::Entry;
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
    /// Look at what is laid over a map, or change it.
    Overlay {
        /// The map.
        map: String,
        /// What to do.
        action: OverlayAction,
    },
}

/// What is to be done with what is laid over a map.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OverlayAction {
    /// Take over the entries of a document; those of the same name are replaced.
    Apply {
        /// The document, as JSON.
        document: String,
        /// The feed that it is all of: of that, what it does not have is removed.
        #[serde(default)]
        feed: Option<String>,
        /// Of this feed, what could not be read, and therefore stays as it was ([`mapd_overlay::Feed::unread`]).
        #[serde(default)]
        unread: Vec<String>,
        /// Feeds that have ended: their entries are removed in the same revision, or become this feed's.
        #[serde(default)]
        ended: Vec<String>,
        /// Of the document's bytes, in minisign's format.
        #[serde(default)]
        signature: Option<String>,
    },
    /// Change nothing.
    List,
    /// Remove entries.
    Remove {
        /// Their names.
        ids: Vec<String>,
    },
    /// Remove all.
    Clear,
}

/// What is laid over a map.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OverlayReport {
    /// Rises with each change that readers see.
    pub revision: u64,
    /// All entries, in the order in which they were given.
    pub entries: Vec<ListedEntry>,
}

/// An entry of an overlay.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ListedEntry {
    /// As it was given.
    pub entry: Entry,
    /// Why it does not fit the map that is served, and is left out; `None` where it does.
    pub unplaced: Option<String>,
    /// Why a part of its lines could not be placed; the rest holds.
    #[serde(default)]
    pub part: Option<String>,
}

/// What a daemon answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Response {
    /// To [`Request::Status`].
    Status(Box<DaemonStatus>),
    /// To everything else: how it ended.
    Done(ReloadReport),
    /// To [`Request::Overlay`]: what is so afterwards.
    Overlay(OverlayReport),
    /// What was sent is wrong; nothing was changed.
    Wrong {
        /// What is wrong with it.
        reason: String,
    },
    /// The request cannot be understood, or names a map that this daemon does not serve.
    Refused {
        /// Why.
        reason: String,
    },
}
