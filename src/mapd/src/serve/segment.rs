//! The file that holds a generation.

use super::loan::Mark;
use super::locked::LockedPages;
use super::served_map::MapPublisher;
use mapd_transport::{Domain, SHARED_MEMORY_FOLDER, SegmentLocation, Share};
use rustix::fs::FallocateFlags;
use std::cell::OnceCell;
use std::fs::{File, OpenOptions};
use std::io;
use std::os::unix::fs::{FileExt, MetadataExt};
use std::path::Path;

/// The hash of a type name that iceoryx2 puts into the names of data segments, once one has been found: it is the same for
/// all publishers of maps.
pub(crate) type SegmentType = OnceCell<String>;

/// How far into a segment its one sample may begin; iceoryx2 0.10 has it begin at 384 \[bytes\].
const SEARCHED: usize = 64 << 10;

/// The data segment of a publisher.
pub(crate) struct Segment {
    file: File,
    name: String,
}

impl Segment {
    /// Finds it. iceoryx2 names it prefix, hash of a type name, `_`, publisher, `.data`. Only where the hash is not `known`
    /// is the folder searched, which takes as long as there are files of all maps.
    ///
    /// Errors: there is none, or the system refuses.
    pub(crate) fn of(
        domain: &Domain,
        publisher: &MapPublisher,
        known: &SegmentType,
    ) -> io::Result<Self> {
        let suffix = format!("_{}.data", publisher.id().value());
        let open = |kind: &str| -> io::Result<Self> {
            let name = format!("{}{kind}{suffix}", domain.prefix());
            let path = Path::new(SHARED_MEMORY_FOLDER).join(&name);
            let file = OpenOptions::new().read(true).write(true).open(path)?;
            Ok(Self { file, name })
        };
        match known.get().map(|kind| open(kind)) {
            Some(Err(error)) if error.kind() == io::ErrorKind::NotFound => {}
            Some(other) => return other,
            None => {}
        }
        for entry in std::fs::read_dir(SHARED_MEMORY_FOLDER)? {
            let name = entry?.file_name();
            let middle = |name: &str| {
                name.strip_prefix(domain.prefix())?.strip_suffix(&suffix).map(str::to_owned)
            };
            if let Some(kind) = name.to_str().and_then(middle) {
                let segment = open(&kind);
                // Set already only if iceoryx2 has changed its mind, and then searched for each time.
                let _ = known.set(kind);
                return segment;
            }
        }
        Err(io::Error::new(
            io::ErrorKind::NotFound,
            format!("no data segment {}*{suffix}", domain.prefix()),
        ))
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
        File::open(Path::new(SHARED_MEMORY_FOLDER).join(&self.name))
    }

    /// Makes it read-only for good, for the group that the daemon shares with. Existing mappings stay what they are; iceoryx2 maps readers read-only anyway, but
    /// would give any process of the user a writable one.
    ///
    /// Errors: what the system says.
    pub(crate) fn protect(&self, share: Share) -> io::Result<()> {
        share.finished(&self.file)
    }
}
