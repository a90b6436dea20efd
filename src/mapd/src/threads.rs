//! How many threads compile.

use crate::size::Size;
use anyhow::{Result, anyhow};
use clap::Args;
use std::num::NonZeroUsize;

/// How many threads work; what they yield is the same for any number.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct ThreadsArg {
    /// Threads that compile; the result is the same for any number [default: as many as there are cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

impl ThreadsArg {
    /// The number that was asked for.
    pub(crate) fn get(self) -> Option<NonZeroUsize> {
        self.threads
    }

    /// Starts the threads of this process, which may take so much memory \[bytes\]. To be called once, before anything is
    /// compiled.
    ///
    /// Errors: so many threads cannot be had.
    pub(crate) fn start(self, limit: Option<Size>) -> Result<()> {
        let within = limit.map(|limit| format!(" within {limit} of memory")).unwrap_or_default();
        // 0 stands for all cores.
        let count = self.threads.map_or(0, NonZeroUsize::get);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count);
        let count = match self.threads {
            Some(count) => format!("{count} threads"),
            None => "a thread for each core".to_owned(),
        };
        pool.build_global()
            .map_err(|error| anyhow!("starting {count}{within} (--threads): {error}"))
    }
}
