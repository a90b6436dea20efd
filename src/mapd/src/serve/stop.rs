//! Ending on SIGINT and SIGTERM.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

type Waker = Box<dyn Fn() + Send>;

/// Set by SIGINT or SIGTERM; wakes whoever waits.
#[derive(Clone, Default)]
pub struct StopSignal {
    stopped: Arc<AtomicBool>,
    waker: Arc<Mutex<Option<Waker>>>,
}

impl StopSignal {
    /// Catches the signals from now on, in a thread of its own.
    ///
    /// Errors: the handlers cannot be installed.
    pub fn install() -> io::Result<Self> {
        let stop = Self::default();
        let mut signals = Signals::new([SIGINT, SIGTERM])?;
        let caught = stop.clone();
        std::thread::Builder::new().name("mapd-signals".to_owned()).spawn(move || {
            if signals.forever().next().is_some() {
                caught.stop();
            }
        })?;
        Ok(stop)
    }

    /// Stops as a signal would.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::SeqCst);
        if let Some(wake) = self.waker.lock().unwrap_or_else(PoisonError::into_inner).as_ref() {
            wake();
        }
    }

    /// Whether it is time to end.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::SeqCst)
    }

    /// What to call when it is time to end.
    pub(super) fn on_stop(&self, waker: Option<Waker>) {
        *self.waker.lock().unwrap_or_else(PoisonError::into_inner) = waker;
    }
}
