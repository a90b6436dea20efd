//! Whether another process has a file open.
#![allow(unsafe_code)]

use std::fs::File;
use std::io;
use std::os::fd::{AsRawFd, RawFd};

/// `F_SETSIG` of Linux, which libc does not name: the signal that tells of a lease that is asked for.
const SET_SIGNAL: i32 = 10;

/// Whether another process has a file open, or maps it. `file` must be opened read-only: a file that is open for writing prevents its own lease. If the
/// system cannot tell, the answer is no.
pub(super) fn is_held(file: &File) -> bool {
    let fd = file.as_raw_fd();
    // A process that opens the file at this moment is announced by a signal, which by default ends the process; this one does not.
    let quiet = lease(fd, SET_SIGNAL, libc::SIGURG);
    // A write lease is granted only if no other process has the file open; a mapping counts as open.
    match quiet.and_then(|()| lease(fd, libc::F_SETLEASE, libc::F_WRLCK)) {
        Ok(()) => {
            // Fails for no lease that is held; it would end with the descriptor.
            let _ = lease(fd, libc::F_SETLEASE, libc::F_UNLCK);
            false
        }
        Err(error) => error.kind() == io::ErrorKind::WouldBlock,
    }
}

fn lease(fd: RawFd, command: i32, argument: i32) -> io::Result<()> {
    // SAFETY: these commands take a number and touch no memory of this process; the descriptor is open for the time of the call.
    match unsafe { libc::fcntl(fd, command, argument) } {
        -1 => Err(io::Error::last_os_error()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::{Duration, Instant};

    /// Longest wait for what takes milliseconds.
    const PATIENCE: Duration = Duration::from_secs(20);

    /// Whether nobody has it after a while: children that other tests fork have what this process has, until they execute another program.
    fn is_let_go(file: &File) -> bool {
        let until = Instant::now() + PATIENCE;
        while is_held(file) {
            if Instant::now() >= until {
                return false;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        true
    }

    #[test]
    fn a_file_is_held_while_it_is_mapped() {
        let path = format!("/dev/shm/mapdheld{}", std::process::id());
        std::fs::write(&path, [1; 8192]).expect("written");
        let kept = File::open(&path).expect("opens");
        assert!(is_let_go(&kept));
        let other = File::open(&path).expect("opens");
        assert!(is_held(&kept), "it is open");
        // SAFETY: nobody looks at the bytes.
        let mapping = unsafe { memmap2::Mmap::map(&other) }.expect("maps");
        drop(other);
        std::fs::remove_file(&path).expect("removed");
        assert!(is_held(&kept), "it is mapped");
        drop(mapping);
        assert!(is_let_go(&kept));
    }
}
