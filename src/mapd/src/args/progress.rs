//! How progress is shown.

use super::Seconds;
use crate::progress::Manner;
use clap::Args;
use std::time::Duration;

/// Time between two lines of progress where nothing else is said: seldom enough for a log, often enough to see that work
/// goes on.
const INTERVAL: Duration = Duration::from_secs(5);

/// Options of showing progress.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct ProgressArgs {
    /// Print only findings and errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// If stderr is not a terminal: seconds between two lines of progress
    #[arg(long, value_name = "S", default_value_t = Seconds(INTERVAL))]
    progress_interval: Seconds,
}

impl ProgressArgs {
    /// How progress is shown.
    pub(crate) fn manner(&self) -> Manner {
        if self.quiet { Manner::Silent } else { Manner::Lines(self.progress_interval.0) }
    }
}
