//! Waking the serving thread: it connects new clients until another thread needs it.

use iceoryx2::prelude::{FileDescriptor, FileDescriptorBased, SynchronousMultiplexing};
use std::fmt;
use std::io::{self, Read, Write};
use std::os::fd::AsRawFd;
use std::os::unix::net::UnixStream;

/// Ends [`super::Server::run_until`], at once even if it waits. Rung by its [`Ringer`]s.
pub struct Doorbell {
    sender: UnixStream,
    receiver: UnixStream,
    descriptor: FileDescriptor,
}

impl Doorbell {
    /// A bell that has not been rung.
    ///
    /// Errors: no socket pair can be had.
    pub fn new() -> io::Result<Self> {
        let (sender, receiver) = UnixStream::pair()?;
        sender.set_nonblocking(true)?;
        receiver.set_nonblocking(true)?;
        let descriptor = FileDescriptor::non_owning_new(receiver.as_raw_fd())
            .ok_or(io::ErrorKind::InvalidInput)?;
        Ok(Self { sender, receiver, descriptor })
    }

    /// Something that rings it, from any thread.
    ///
    /// Errors: no descriptor can be had.
    pub fn ringer(&self) -> io::Result<Ringer> {
        Ok(Ringer(self.sender.try_clone()?))
    }

    /// Has a signal ring it, as long as the process lives.
    ///
    /// Errors: the handler cannot be installed.
    pub fn ring_on(&self, signal: i32) -> io::Result<()> {
        signal_hook::low_level::pipe::register(signal, self.sender.try_clone()?).map(|_| ())
    }

    /// Forgets the calls that have come. A caller that looks for work afterwards misses none.
    pub fn answer(&self) {
        let mut buffer = [0; 64];
        // Ends with an error, would-block, once there is nothing more; interrupted, it rings again.
        while (&self.receiver).read(&mut buffer).is_ok_and(|count| count == buffer.len()) {}
    }
}

/// Rings a [`Doorbell`].
pub struct Ringer(UnixStream);

impl Ringer {
    /// Rings.
    pub fn ring(&self) {
        // Fails only if the socket is full of calls that have not been answered.
        let _ = (&self.0).write(&[0]);
    }
}

impl FileDescriptorBased for Doorbell {
    fn file_descriptor(&self) -> &FileDescriptor {
        &self.descriptor
    }
}

impl SynchronousMultiplexing for Doorbell {}

impl fmt::Debug for Doorbell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Doorbell").field("socket", &self.receiver).finish_non_exhaustive()
    }
}
