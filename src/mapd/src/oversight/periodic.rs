//! Threads that work periodically until they are stopped.

use crate::joining::join_soon;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Wakes the sleeping thread and ends it.
#[derive(Debug, Default)]
pub(crate) struct Stop {
    stopped: Mutex<bool>,
    wake: Condvar,
}

impl Stop {
    fn request(&self) {
        *self.stopped.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.wake.notify_all();
    }

    /// Whether it is time to end.
    pub(crate) fn is_requested(&self) -> bool {
        *self.stopped.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Sleeps, at most so long; whether it is time to end.
    pub(crate) fn sleep(&self, time: Duration) -> bool {
        let until = Instant::now() + time;
        let mut stopped = self.stopped.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            let left = until.saturating_duration_since(Instant::now());
            if *stopped || left.is_zero() {
                return *stopped;
            }
            let woken = self.wake.wait_timeout(stopped, left);
            stopped = woken.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

/// A thread; stopped, and waited for, when dropped.
pub(crate) struct Periodic {
    stop: Arc<Stop>,
    thread: Option<JoinHandle<()>>,
}

impl Periodic {
    /// Runs `work`, which ends when its stop is requested.
    pub(crate) fn spawn(
        name: &str,
        stop: &Arc<Stop>,
        work: impl FnOnce(&Stop) + Send + 'static,
    ) -> Self {
        let stopped = stop.clone();
        let builder = std::thread::Builder::new().name(name.to_owned());
        let thread = builder.spawn(move || work(&stopped));
        if let Err(error) = &thread {
            tracing::error!(%error, "no thread for {name}: {error}");
        }
        Self { stop: stop.clone(), thread: thread.ok() }
    }
}

impl Drop for Periodic {
    fn drop(&mut self) {
        self.stop.request();
        join_soon(self.thread.take());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sleeper_is_woken_by_the_end() {
        let stop = Arc::new(Stop::default());
        assert!(!stop.sleep(Duration::from_millis(1)));
        let start = Instant::now();
        let thread =
            Periodic::spawn(
                "sleeper",
                &stop,
                |stop| {
                    while !stop.sleep(Duration::from_secs(1000)) {}
                },
            );
        drop(thread);
        assert!(start.elapsed() < Duration::from_secs(100));
    }
}
