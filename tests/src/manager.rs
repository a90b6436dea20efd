//! A service manager, as far as a daemon knows it: a socket that hears READY=1 and WATCHDOG=1.

use crate::test_domain::PATIENCE;
use std::os::unix::net::UnixDatagram;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;
use tempfile::TempDir;

/// Interval of the watchdog in tests.
pub const WATCHDOG: Duration = Duration::from_millis(600);

/// A service manager's end of the socket.
pub struct Manager {
    socket: UnixDatagram,
    path: PathBuf,
    _folder: TempDir,
}

impl Manager {
    /// Listens in a folder of its own.
    #[expect(clippy::new_without_default, reason = "it makes files")]
    pub fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("notify");
        let socket = UnixDatagram::bind(&path).expect("a socket");
        Self { socket, path, _folder: folder }
    }

    /// Has a program talk to it, with [`WATCHDOG`].
    pub fn listen_to<'a>(&self, command: &'a mut Command) -> &'a mut Command {
        command
            .env("NOTIFY_SOCKET", &self.path)
            .env("WATCHDOG_USEC", WATCHDOG.as_micros().to_string())
            .env_remove("WATCHDOG_PID")
    }

    /// The next message, if one comes in time.
    pub fn hear(&self, patience: Duration) -> Option<String> {
        self.socket.set_read_timeout(Some(patience)).expect("a deadline");
        let mut buffer = [0; 4096];
        let length = self.socket.recv(&mut buffer).ok()?;
        Some(String::from_utf8_lossy(&buffer[..length]).into_owned())
    }

    /// The next message has this line.
    pub fn expect(&self, message: &str) {
        let heard = self.hear(PATIENCE).unwrap_or_default();
        assert!(heard.lines().any(|line| line == message), "{heard:?} instead of {message}");
    }

    /// Forgets what has come.
    pub fn drain(&self) {
        while self.hear(Duration::from_millis(1)).is_some() {}
    }
}
