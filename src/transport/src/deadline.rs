//! Deadlines from durations of any length.

use std::time::{Duration, Instant};

/// Stands for every longer wait: a clock counts no more than some hundred years, and no process lives so long.
const FOR_EVER: Duration = Duration::from_secs(30 * 365 * 24 * 3600);

/// The moment so much later; [`Duration::MAX`] waits for ever.
pub fn after(wait: Duration) -> Instant {
    Instant::now() + wait.min(FOR_EVER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_wait_has_a_deadline() {
        for wait in [Duration::ZERO, Duration::from_secs(1), FOR_EVER, Duration::MAX] {
            let before = Instant::now();
            assert!(after(wait) >= before + wait.min(FOR_EVER), "{wait:?}");
        }
    }
}
