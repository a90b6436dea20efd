//! Waiting for a thread that may not end.

use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long the daemon's end waits for a thread: one that proves gigabytes, or reads from a disk that does not answer, ends
/// with the process.
const PATIENCE: Duration = Duration::from_secs(2);

/// Pause between two looks at it.
const PAUSE: Duration = Duration::from_millis(1);

/// Waits for a thread that has been told to end, for [`PATIENCE`] at most.
pub(crate) fn join_soon(thread: Option<JoinHandle<()>>) {
    let until = Instant::now() + PATIENCE;
    let Some(thread) = thread else { return };
    while !thread.is_finished() && Instant::now() < until {
        std::thread::sleep(PAUSE);
    }
    if thread.is_finished() {
        // A panic there has been printed; it is no reason to serve no more.
        let _ = thread.join();
    }
}
