//! The file that holds a generation.

use super::loan::Mark;
use super::locked::LockedPages;
use super::served_map::MapPublisher;
use mapd_transport::{
    Domain, SHARED_MEMORY_FOLDER, SegmentLocation, Share, Untrusted, open_guarded, open_owned,
};
use rustix::fs::{FallocateFlags, Mode, OFlags};
use std::cell::OnceCell;
use std::fs::File;
use std::io;
use std::os::unix::fs::{FileExt, MetadataExt};
use std::path::{Path, PathBuf};

/// The hash of a type name that iceoryx2 puts into the names of data segments, once one has been found: it is the same for
/// all publishers of maps.
pub(crate) type SegmentType = OnceCell<String>;

/// How far into a segment its one sample may begin; iceoryx2 0.10 has it begin at 384 \[bytes\].
const SEARCHED: usize = 64 << 10;

/// The data segment of a publisher, or one that the daemon has made for observers alone.
pub(crate) struct Segment {
    file: File,
    name: String,
}

impl Segment {
    /// Finds it. iceoryx2 names it prefix, hash of a type name, `_`, publisher, `.data`. Only where the hash is not `known`
    /// is the folder searched, which takes as long as there are files of all maps. Another user may have made one that is named alike: it is passed over.
    ///
    /// Errors: there is none, or the system refuses.
    pub(crate) fn of(
        domain: &Domain,
        publisher: &MapPublisher,
        known: &SegmentType,
    ) -> io::Result<Self> {
        let suffix = format!("_{}.data", publisher.id().value());
        let us = rustix::process::geteuid().as_raw();
        let open = |kind: &str| -> Result<Self, Untrusted> {
            let name = format!("{}{kind}{suffix}", domain.prefix());
            let (file, _) = open_guarded(&path_of(&name), OFlags::RDWR, Mode::empty(), us)?;
            Ok(Self { file: file.into(), name })
        };
        match known.get().map(|kind| open(kind)) {
            Some(Err(Untrusted::Io(error))) if error.kind() == io::ErrorKind::NotFound => {}
            Some(other) => return Ok(other?),
            None => {}
        }
        for entry in std::fs::read_dir(SHARED_MEMORY_FOLDER)? {
            let name = entry?.file_name();
            let middle = |name: &str| {
                name.strip_prefix(domain.prefix())?.strip_suffix(&suffix).map(str::to_owned)
            };
            let Some(kind) = name.to_str().and_then(middle) else { continue };
            match open(&kind) {
                Err(Untrusted::OtherOwner(_)) => {}
                segment => {
                    // Set already only if iceoryx2 has changed its mind, and then searched for each time.
                    let _ = known.set(kind);
                    return Ok(segment?);
                }
            }
        }
        Err(io::Error::new(
            io::ErrorKind::NotFound,
            format!("no data segment {}*{suffix}", domain.prefix()),
        ))
    }

    /// A segment of this name, of so many bytes, which must not be there.
    ///
    /// Errors: what the system says.
    pub(super) fn create(name: String, length: u64) -> io::Result<Self> {
        let access = OFlags::RDWR | OFlags::CREATE | OFlags::EXCL;
        let us = rustix::process::geteuid().as_raw();
        let (file, _) = open_guarded(&path_of(&name), access, Mode::RUSR | Mode::WUSR, us)?;
        let segment = Self { file: file.into(), name };
        segment.file.set_len(length)?;
        Ok(segment)
    }

    /// Its file, open for reading and writing.
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Where it is.
    pub(super) fn path(&self) -> PathBuf {
        path_of(&self.name)
    }

    /// The place of bytes that begin where it does.
    ///
    /// Errors: what the system says.
    pub(super) fn whole(&self) -> io::Result<SegmentLocation> {
        let inode = self.file.metadata()?.ino();
        Ok(SegmentLocation { segment: self.name.clone(), inode, offset: 0, overlay: None })
    }

    /// Where a sample lies that begins with this mark.
    ///
    /// Errors: nowhere, or at several places; what the system says.
    pub(crate) fn place_of(&self, mark: &Mark) -> io::Result<SegmentLocation> {
        let mut start = vec![0; SEARCHED];
        let mut read = 0;
        while read < SEARCHED {
            match self.file.read_at(&mut start[read..], read as u64)? {
                0 => break,
                count => read += count,
            }
        }
        let mut places =
            start[..read].chunks_exact(mark.len()).enumerate().filter(|(_, chunk)| chunk == mark);
        match (places.next(), places.next()) {
            (Some((chunk, _)), None) => Ok(SegmentLocation {
                segment: self.name.clone(),
                inode: self.file.metadata()?.ino(),
                offset: (chunk * mark.len()) as u64,
                overlay: None,
            }),
            _ => Err(io::Error::new(
                io::ErrorKind::NotFound,
                format!("the sample's place in {} is not found", self.name),
            )),
        }
    }

    /// Has the kernel provide all its pages now: too little memory is an error here, and would be SIGBUS for the process that
    /// writes. (Populating the mapping with `madvise` would do as well, but needs Linux 5.14.)
    ///
    /// Errors: no space, no memory.
    pub(crate) fn reserve(&self) -> io::Result<()> {
        let length = self.file.metadata()?.len();
        Ok(rustix::io::retry_on_intr(|| {
            rustix::fs::fallocate(&self.file, FallocateFlags::empty(), 0, length)
        })?)
    }

    /// Keeps its pages in memory.
    ///
    /// Errors: see [`LockedPages::of`].
    pub(crate) fn lock(&self) -> io::Result<LockedPages> {
        LockedPages::of(&self.file)
    }

    /// Another descriptor, to look after it with once its publisher is gone.
    ///
    /// Errors: what the system says.
    pub(crate) fn keep(&self) -> io::Result<File> {
        open_owned(&self.path(), rustix::process::geteuid().as_raw())
    }

    /// Makes it read-only for good, for the group that the daemon shares with. Existing mappings stay what they are; iceoryx2 maps readers read-only anyway, but
    /// would give any process of the user a writable one.
    ///
    /// Errors: what the system says.
    pub(crate) fn protect(&self, share: Share) -> io::Result<()> {
        share.finished(&self.file)
    }
}

fn path_of(name: &str) -> PathBuf {
    Path::new(SHARED_MEMORY_FOLDER).join(name)
}
