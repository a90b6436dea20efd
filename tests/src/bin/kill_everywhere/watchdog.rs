//! Ends the program when a step of it hangs: a call into shared memory that never returns cannot be interrupted.

use mapd_tests::say;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Longest time between two steps: each has deadlines of its own, whose sum is less.
const LONGEST_STEP: Duration = Duration::from_secs(600);

/// Exit code of a hang.
const HANGS: i32 = 3;

static LAST: Mutex<Option<(Instant, String)>> = Mutex::new(None);

/// Begins to watch.
pub(crate) fn start() {
    step("start");
    std::thread::spawn(|| {
        loop {
            std::thread::sleep(Duration::from_secs(1));
            if let Ok(last) = LAST.lock()
                && let Some((since, what)) = last.as_ref()
                && since.elapsed() > LONGEST_STEP
            {
                say(&format!("HANGS: {what}"));
                std::process::exit(HANGS);
            }
        }
    });
}

/// A step begins.
pub(crate) fn step(what: &str) {
    if let Ok(mut last) = LAST.lock() {
        *last = Some((Instant::now(), what.to_owned()));
    }
}
