//! Exit codes.

use mapd_compiler::Verdict;
use std::process::ExitCode;

/// How a job ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Done and accepted.
    Done,
    /// Accepted, with parts in quarantine.
    Quarantined,
    /// A map was rejected.
    Rejected,
    /// Wrong usage.
    Usage,
    /// The environment failed: files, memory, shared memory.
    Environment,
}

impl Exit {
    /// The process's exit code.
    pub fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Environment => 1,
            Self::Usage => 2,
            Self::Quarantined => 3,
            Self::Rejected => 4,
        }
    }

    /// What a process's exit code says; `None` for those of other ends, such as a panic's.
    pub fn from_code(code: u8) -> Option<Self> {
        let all = [Self::Done, Self::Environment, Self::Usage, Self::Quarantined, Self::Rejected];
        all.into_iter().find(|exit| exit.code() == code)
    }

    /// The worse of two: the environment, then rejected maps, then those with parts in quarantine.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        let rank = |exit: Self| match exit {
            Self::Done => 0,
            Self::Quarantined => 1,
            Self::Rejected => 2,
            Self::Usage => 3,
            Self::Environment => 4,
        };
        if rank(other) > rank(self) { other } else { self }
    }
}

impl From<Verdict> for Exit {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Accepted => Self::Done,
            Verdict::Quarantined => Self::Quarantined,
            Verdict::Rejected => Self::Rejected,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.code())
    }
}

/// Wrong usage that only shows while running.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub(crate) struct UsageError(pub(crate) String);

/// An error with its causes, each once: many messages end with their cause already.
pub fn explained(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain().map(|cause| cause.to_string()) {
        if text.is_empty() {
            text = cause;
        } else if !text.contains(&cause) {
            text.push_str(": ");
            text.push_str(&cause);
        }
    }
    text
}
