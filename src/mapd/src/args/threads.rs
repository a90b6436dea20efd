//! How many threads compile.

use crate::args::Size;
use anyhow::{Result, anyhow};
use clap::Args;
use serde::Deserialize;
use std::num::NonZeroUsize;
use std::str::FromStr;
use std::sync::OnceLock;

/// Most threads that compile. What they cost in looking for work grows with the square of their number: on two cores 256
/// take a tenth of a second for a small map, 1,024 take four, 4,000 do not end.
pub(crate) const MOST_THREADS: usize = 512;

/// A number of threads, from 1 to [`MOST_THREADS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "u64")]
pub(crate) struct ThreadCount(NonZeroUsize);

impl ThreadCount {
    /// As many as there are cores.
    pub(crate) fn of_cores() -> Self {
        Self::at_most(std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN))
    }

    /// So many, or as many as there may be.
    pub(crate) fn at_most(count: NonZeroUsize) -> Self {
        Self(NonZeroUsize::new(count.get().min(MOST_THREADS)).unwrap_or(NonZeroUsize::MIN))
    }

    /// The number.
    pub(crate) fn get(self) -> usize {
        self.0.get()
    }

    /// So many times as many, or as many as there may be.
    pub(crate) fn times(self, factor: NonZeroUsize) -> Self {
        Self::at_most(self.0.saturating_mul(factor))
    }
}

impl TryFrom<u64> for ThreadCount {
    type Error = String;

    fn try_from(count: u64) -> Result<Self, String> {
        let known = usize::try_from(count).ok().filter(|count| *count <= MOST_THREADS);
        let known = known.and_then(NonZeroUsize::new).map(Self);
        known.ok_or_else(|| format!("expected from 1 to {MOST_THREADS} threads, found {count}"))
    }
}

impl FromStr for ThreadCount {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.parse::<u64>().map_err(|error| error.to_string())?.try_into()
    }
}

/// How many threads work; what they yield is the same for any number.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct ThreadsArg {
    /// Threads for compiling, up to 512; the result is the same for any number [default: number of cores]
    #[arg(long, value_name = "N")]
    threads: Option<ThreadCount>,
}

impl ThreadsArg {
    /// The number that was asked for.
    pub(crate) fn get(self) -> Option<ThreadCount> {
        self.threads
    }

    /// Starts the threads of this process, which may take so much memory \[bytes\]; once, before anything is compiled: later
    /// calls change nothing.
    ///
    /// Errors: so many threads cannot be had.
    pub(crate) fn start(self, limit: Option<Size>) -> Result<()> {
        static STARTED: OnceLock<()> = OnceLock::new();
        if STARTED.set(()).is_err() {
            return Ok(());
        }
        let within = limit.map(|limit| format!(" within {limit} of memory")).unwrap_or_default();
        let count = self.threads.unwrap_or_else(ThreadCount::of_cores);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count.get());
        let count = match self.threads {
            Some(count) => format!("{} threads", count.get()),
            None => "a thread for each core".to_owned(),
        };
        pool.build_global()
            .map_err(|error| anyhow!("starting {count}{within} (--threads): {error}"))
    }
}
