//! Ending a server.

use iceoryx2::prelude::{FileDescriptor, FileDescriptorBased, SynchronousMultiplexing};
use signal_hook::SigId;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::low_level::{pipe, unregister};
use std::fmt;
use std::io::{self, Write};
use std::os::fd::AsRawFd;
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Ends [`super::Server::run`], at once even if it waits. For [`StopSignal::install`], SIGINT and SIGTERM do so; dropping
/// it gives these signals back.
pub struct StopSignal {
    requested: Arc<AtomicBool>,
    sender: UnixStream,
    /// Kept open as long as `descriptor` names it. Never read: once stopped, always stopped.
    receiver: UnixStream,
    descriptor: FileDescriptor,
    handlers: Vec<SigId>,
}

impl StopSignal {
    /// A signal that only [`StopSignal::request`] sets.
    ///
    /// Errors: no socket pair can be had.
    pub fn new() -> io::Result<Self> {
        let (sender, receiver) = UnixStream::pair()?;
        sender.set_nonblocking(true)?;
        let descriptor = FileDescriptor::non_owning_new(receiver.as_raw_fd())
            .ok_or(io::ErrorKind::InvalidInput)?;
        Ok(Self { requested: Arc::default(), sender, receiver, descriptor, handlers: Vec::new() })
    }

    /// A signal that SIGINT and SIGTERM set.
    ///
    /// Errors: no socket pair can be had; the handlers cannot be installed.
    pub fn install() -> io::Result<Self> {
        let mut stop = Self::new()?;
        for signal in [SIGINT, SIGTERM] {
            // The flag is set before the socket wakes anyone: handlers run in the order they were registered.
            stop.handlers.push(signal_hook::flag::register(signal, stop.requested.clone())?);
            stop.handlers.push(pipe::register(signal, stop.sender.try_clone()?)?);
        }
        Ok(stop)
    }

    /// Asks to stop.
    pub fn request(&self) {
        self.requested.store(true, Ordering::SeqCst);
        // Fails only if the socket is full of earlier wake-ups, or interrupted; then the next tick sees the flag.
        let _ = (&self.sender).write(&[0]);
    }

    /// What is set once stopping was asked for.
    pub fn flag(&self) -> Arc<AtomicBool> {
        self.requested.clone()
    }

    /// Whether stopping was asked for.
    pub fn is_requested(&self) -> bool {
        self.requested.load(Ordering::SeqCst)
    }
}

impl Drop for StopSignal {
    fn drop(&mut self) {
        for handler in self.handlers.drain(..) {
            unregister(handler);
        }
    }
}

impl FileDescriptorBased for StopSignal {
    fn file_descriptor(&self) -> &FileDescriptor {
        &self.descriptor
    }
}

impl SynchronousMultiplexing for StopSignal {}

impl fmt::Debug for StopSignal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StopSignal")
            .field("requested", &self.is_requested())
            .field("socket", &self.receiver)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    #[test]
    fn a_request_is_seen_and_wakes() {
        let stop = StopSignal::new().expect("a socket pair");
        assert!(!stop.is_requested());
        stop.request();
        assert!(stop.is_requested());
        stop.receiver.set_nonblocking(true).expect("a socket");
        assert_eq!((&stop.receiver).read(&mut [0; 8]).ok(), Some(1));
    }
}
