//! One pinned generation with its overlay.
#![allow(unsafe_code)]

use crate::error::ClientError;
use crate::file;
use mapd_archive::{
    AlignedBytes, Archive, Overlay, open, open_overlay, verify, verify_overlay, verify_overlay_on,
};
use mapd_query::Map;
use mapd_query::view::View;
use mapd_transport::{AttachError, Mapping, Pinned, PinnedOverlay};
use std::path::Path;
use std::sync::Arc;
use std::time::SystemTime;

/// What keeps the bytes where they are.
enum Memory {
    Shared(Pinned),
    File(Mapping),
    Owned(AlignedBytes),
}

impl Memory {
    fn bytes(&self) -> &[u8] {
        match self {
            Self::Shared(pinned) => pinned.bytes(),
            Self::File(map) => map.bytes(),
            Self::Owned(bytes) => bytes,
        }
    }
}

struct Inner {
    /// Borrows from `memory`; declared first, dropped first.
    archive: Archive<'static>,
    memory: Memory,
    generation: u64,
    /// File or map name, for errors.
    source_name: Box<str>,
}

/// What keeps an overlay's bytes where they are.
enum OverlayMemory {
    Shared(PinnedOverlay),
    Owned(AlignedBytes),
}

impl OverlayMemory {
    fn bytes(&self) -> &[u8] {
        match self {
            Self::Shared(pinned) => pinned.bytes(),
            Self::Owned(bytes) => bytes,
        }
    }

    fn revision(&self) -> u64 {
        match self {
            Self::Shared(pinned) => pinned.revision(),
            Self::Owned(_) => 0,
        }
    }
}

struct Over {
    /// Borrows from `memory`; declared first, dropped first.
    overlay: Overlay<'static>,
    memory: OverlayMemory,
}

/// One pinned generation of a map with its overlay, if there is one. Cheap to clone, shared by threads without locks, readable as long as any clone exists.
#[derive(Clone)]
pub struct Snapshot {
    inner: Arc<Inner>,
    over: Option<Arc<Over>>,
}

impl Snapshot {
    /// Opens a `.mapd` file in place.
    ///
    /// Errors: the file cannot be read or is not an archive that this release can read.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, ClientError> {
        let path = path.as_ref();
        let map = file::map(path)
            .map_err(|source| ClientError::File { path: path.to_owned(), source })?;
        Self::new(Memory::File(map), 0, &path.display().to_string())
    }

    /// An archive that was encoded in this process.
    ///
    /// Errors: the bytes are not an archive that this release can read.
    pub fn from_bytes(bytes: AlignedBytes) -> Result<Self, ClientError> {
        Self::new(Memory::Owned(bytes), 0, "archive in memory")
    }

    /// Errors: the bytes are no archive that this program reads, or another one than was announced.
    pub(crate) fn from_pinned(pinned: Pinned, name: &str) -> Result<Self, ClientError> {
        let info = *pinned.info();
        let snapshot = Self::new(Memory::Shared(pinned), info.generation, name)?;
        if snapshot.header().content_hash != info.content_hash {
            return Err(AttachError::OtherContent { map: name.to_owned() }.into());
        }
        Ok(snapshot)
    }

    fn new(memory: Memory, generation: u64, name: &str) -> Result<Self, ClientError> {
        let bytes = memory.bytes();
        // SAFETY: the bytes live in `memory` (shared sample, mapping or heap block), which moves into the same `Inner`
        // and neither moves nor frees them before it is dropped; `archive` is dropped first, is private, and is handed
        // out only with the lifetime of a borrow of the snapshot (`map`).
        let bytes: &'static [u8] =
            unsafe { std::slice::from_raw_parts(bytes.as_ptr(), bytes.len()) };
        let archive = open(bytes)
            .map_err(|source| ClientError::Open { source_name: name.to_owned(), source })?;
        let inner = Arc::new(Inner { archive, memory, generation, source_name: name.into() });
        Ok(Self { inner, over: None })
    }

    /// The same map with an overlay that was made in this process.
    ///
    /// Errors: the bytes are not an overlay of this map.
    pub fn with_overlay(&self, bytes: AlignedBytes) -> Result<Self, ClientError> {
        self.over(OverlayMemory::Owned(bytes))
    }

    /// The same map without an overlay.
    pub(crate) fn bare(&self) -> Self {
        Self { inner: self.inner.clone(), over: None }
    }

    /// Errors: the bytes are no overlay of this map, or another one than was announced.
    pub(crate) fn under(&self, pinned: PinnedOverlay) -> Result<Self, ClientError> {
        let announced = pinned.content_hash();
        let under = self.over(OverlayMemory::Shared(pinned))?;
        match &under.over {
            Some(over) if over.overlay.header.content_hash == announced => Ok(under),
            _ => Err(self.other_content()),
        }
    }

    fn over(&self, memory: OverlayMemory) -> Result<Self, ClientError> {
        let bytes = memory.bytes();
        // SAFETY: as in `new`: the bytes live in `memory`, which moves into the same `Over`, neither moves nor frees them before it is dropped, and is
        // dropped after `overlay`, which is handed out only with the lifetime of a borrow of the snapshot (`view`).
        let bytes: &'static [u8] =
            unsafe { std::slice::from_raw_parts(bytes.as_ptr(), bytes.len()) };
        let source_name = || self.inner.source_name.to_string();
        let overlay = open_overlay(bytes)
            .map_err(|source| ClientError::Open { source_name: source_name(), source })?;
        if overlay.header.provenance.input_hash != self.header().content_hash {
            return Err(self.other_content());
        }
        Ok(Self { inner: self.inner.clone(), over: Some(Arc::new(Over { overlay, memory })) })
    }

    fn other_content(&self) -> ClientError {
        AttachError::OtherContent { map: self.inner.source_name.to_string() }.into()
    }

    /// The map.
    #[inline]
    pub fn map(&self) -> Map<'_> {
        Map::new(&self.inner.archive, self.inner.generation)
    }

    /// The map with its overlay at a moment; without an overlay, the map as it is.
    pub fn view(&self, at: SystemTime) -> View<'_> {
        View::of(self.map(), self.over.as_ref().map(|over| &over.overlay), at)
    }

    /// Revision of the overlay, which rises with each change; 0 without an overlay and for an overlay that was made in this process.
    pub fn overlay_revision(&self) -> u64 {
        self.over.as_ref().map_or(0, |over| over.memory.revision())
    }

    /// The overlay's bytes; none without an overlay.
    pub fn overlay_bytes(&self) -> &[u8] {
        self.over.as_ref().map_or(&[], |over| over.memory.bytes())
    }

    /// Maps every page of the archive into this process now, so that no query waits for the kernel. Without this call, a page is mapped
    /// when a query first reads it, in each process. Reads one byte of each page: linear in the archive's
    /// size, milliseconds per 100 MB in shared memory. Pages stay mapped unless the kernel runs short of memory;
    /// a daemon with `--lock-memory` prevents that. The returned sum of the bytes read has no
    /// meaning.
    pub fn populate(&self) -> u8 {
        let bytes = self.bytes();
        let page = rustix::param::page_size();
        bytes.iter().step_by(page).chain(bytes.last()).fold(0, |sum, byte| {
            // A look that the compiler cannot leave out.
            std::hint::black_box(sum ^ *byte)
        })
    }

    /// Number of the generation; 0 for a file.
    pub fn generation(&self) -> u64 {
        self.inner.generation
    }

    /// The archive's header.
    pub fn header(&self) -> &mapd_archive::Header {
        &self.inner.archive.header
    }

    /// The archive's bytes.
    pub fn bytes(&self) -> &[u8] {
        self.inner.memory.bytes()
    }

    /// File or map name, for errors.
    #[cfg(feature = "trust")]
    pub(crate) fn source_name(&self) -> &str {
        &self.inner.source_name
    }

    /// Verifies the whole archive, its content hash included, and the overlay, if there is one, which has to fit the map. Linear in their size; attaching does not do this.
    ///
    /// Errors: the first fault that is found.
    pub fn verify(&self) -> Result<(), ClientError> {
        let source_name = || self.inner.source_name.to_string();
        let verified = verify(self.bytes()).and_then(|archive| match &self.over {
            None => Ok(()),
            Some(over) => {
                let overlay = verify_overlay(over.memory.bytes())?;
                verify_overlay_on(&overlay, &archive.tables)
            }
        });
        verified.map_err(|source| ClientError::Verify { source_name: source_name(), source })
    }
}
