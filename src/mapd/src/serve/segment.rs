//! The file that holds a generation.

use super::locked::LockedPages;
use super::served_map::MapPublisher;
use mapd_client::transport::{Domain, SHARED_MEMORY_FOLDER};
use rustix::fs::FallocateFlags;
use std::cell::OnceCell;
use std::fs::{File, OpenOptions, Permissions};
use std::io;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// Mode of a published data segment: nobody changes it any more, and other users do not even read it.
const READ_ONLY: u32 = 0o400;

/// The hash of a type name that iceoryx2 puts into the names of data segments, once one has been found: it is the same for
/// all publishers of maps.
pub(crate) type SegmentType = OnceCell<String>;

/// The data segment of a publisher.
pub(crate) struct Segment(File);

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
        let open = |kind: &str| {
            let name = format!("{}{kind}{suffix}", domain.prefix());
            let path = Path::new(SHARED_MEMORY_FOLDER).join(name);
            OpenOptions::new().read(true).write(true).open(path).map(Self)
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

    /// Has the kernel provide all its pages now: too little memory is an error here, and would be SIGBUS for whoever
    /// writes. (Populating the mapping with `madvise` would do as well, but needs Linux 5.14.)
    ///
    /// Errors: no space, no memory.
    pub(crate) fn reserve(&self) -> io::Result<()> {
        let length = self.0.metadata()?.len();
        Ok(rustix::io::retry_on_intr(|| {
            rustix::fs::fallocate(&self.0, FallocateFlags::empty(), 0, length)
        })?)
    }

    /// Keeps its pages in memory.
    ///
    /// Errors: see [`LockedPages::of`].
    pub(crate) fn lock(&self) -> io::Result<LockedPages> {
        LockedPages::of(&self.0)
    }

    /// Makes it read-only for good. Existing mappings stay what they are; iceoryx2 maps readers read-only anyway, but
    /// would give any process of the user a writable one.
    ///
    /// Errors: what the system says.
    pub(crate) fn protect(&self) -> io::Result<()> {
        self.0.set_permissions(Permissions::from_mode(READ_ONLY))
    }
}
