//! Connecting to a socket of a daemon.

use crate::domain::Domain;
use crate::error::AttachError;
use crate::user::check_owner;
use rustix::io::Errno;
use rustix::net::{self, AddressFamily, SocketAddrUnix, SocketFlags, SocketType, socket_with};
use std::io;
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::time::{Duration, Instant};

/// First pause before another attempt where the line of those who connect is full; doubles up to [`LONGEST_PAUSE`].
const FIRST_PAUSE: Duration = Duration::from_micros(100);

/// Longest such pause.
const LONGEST_PAUSE: Duration = Duration::from_millis(10);

/// Connects to a socket in the root folder, which must be the trusted user's: anybody can make a folder of its name, and listen there. Tries again until the deadline while too many others do: the kernel's own wait would have no end where the daemon is stopped.
///
/// Errors: the folder is another user's; what the system says; [`io::ErrorKind::WouldBlock`] at the deadline.
pub fn connect_until(domain: &Domain, path: &Path, deadline: Instant) -> io::Result<UnixStream> {
    check_owner(domain).map_err(|error| match error {
        AttachError::Io { source, .. } => source,
        stranger => io::Error::other(stranger),
    })?;
    let flags = SocketFlags::NONBLOCK | SocketFlags::CLOEXEC;
    let socket = socket_with(AddressFamily::UNIX, SocketType::STREAM, flags, None)?;
    let address = SocketAddrUnix::new(path)?;
    let mut pause = FIRST_PAUSE;
    loop {
        let left = deadline.saturating_duration_since(Instant::now());
        match net::connect(&socket, &address) {
            Ok(()) => break,
            Err(Errno::AGAIN) if !left.is_zero() => {
                std::thread::sleep(pause.min(left));
                pause = (pause * 2).min(LONGEST_PAUSE);
            }
            Err(error) => return Err(error.into()),
        }
    }
    let stream = UnixStream::from(socket);
    stream.set_nonblocking(false)?;
    Ok(stream)
}
