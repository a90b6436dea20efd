//! A file that goes to the disk while it is written: who waits for the disk at the end waits for the last part alone.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{Builder, Scope, ScopedJoinHandle};

/// Bytes written after which the disk gets them, unless it is still at those before.
const PART: usize = 4 << 20;

/// A file that is being written.
pub(crate) struct Writing<'a> {
    file: &'a File,
    /// Bytes since the disk was asked last.
    since: usize,
    more: SyncSender<()>,
}

/// A thread that has the system write a file to its disk.
pub(crate) struct Syncing<'scope, 'a> {
    file: &'a File,
    /// None where the system has no thread left.
    thread: Option<ScopedJoinHandle<'scope, io::Result<()>>>,
}

/// A writer of a file, and its disk. The disk has all once the writer is dropped and [`Syncing::finish`] returns.
pub(crate) fn begin<'scope, 'env>(
    file: &'env File,
    scope: &'scope Scope<'scope, 'env>,
) -> (Writing<'env>, Syncing<'scope, 'env>) {
    let (more, parts) = sync_channel(1);
    let sync = move || {
        let parts: Receiver<()> = parts;
        parts.iter().try_for_each(|()| file.sync_data())?;
        file.sync_data()
    };
    // Not one of the pool's: it does nothing but wait.
    let thread = Builder::new().name("mapd-sync".to_owned()).spawn_scoped(scope, sync).ok();
    (Writing { file, since: 0, more }, Syncing { file, thread })
}

impl Syncing<'_, '_> {
    /// Waits until the disk has all.
    ///
    /// Errors: what the system says.
    pub(crate) fn finish(self) -> io::Result<()> {
        let lost = |_| io::Error::other("the thread that waits for the disk ended early");
        self.thread.map_or_else(|| self.file.sync_data(), |thread| thread.join().map_err(lost)?)
    }
}

impl Write for Writing<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        self.since += count;
        if self.since >= PART {
            self.since = 0;
            // If it is at work and knows of more, it comes to this too. If it has failed, the end says so.
            let _ = self.more.try_send(());
        }
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Seek for Writing<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::fd::OwnedFd;

    /// What a file holds that was written in pieces of some sizes, and whether its disk had it all.
    fn check(file: &File, sizes: &[usize]) -> io::Result<()> {
        std::thread::scope(|scope| {
            let (mut writing, syncing) = begin(file, scope);
            for size in sizes {
                writing.write_all(&vec![b'm'; *size])?;
            }
            drop(writing);
            syncing.finish()
        })
    }

    #[test]
    fn all_that_is_written_is_there_and_synced() {
        let file = tempfile::tempfile().unwrap();
        let sizes = [1, PART, PART - 1, 1, 3 * PART];
        check(&file, &sizes).unwrap();
        assert_eq!(file.metadata().unwrap().len(), sizes.iter().sum::<usize>() as u64);
    }

    /// A pipe has no disk, and its system says so.
    #[test]
    fn a_failure_of_the_disk_is_told_at_the_end() {
        let (mut reader, writer) = io::pipe().unwrap();
        let file = File::from(OwnedFd::from(writer));
        let reading = std::thread::spawn(move || io::copy(&mut reader, &mut io::sink()));
        for sizes in [&[1][..], &[PART, PART, 1]] {
            let error = check(&file, sizes).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::InvalidInput, "{sizes:?}");
        }
        drop(file);
        assert_eq!(reading.join().unwrap().unwrap(), 2 * PART as u64 + 2);
    }
}
