//! Overlays of what is served: small files in the root folder, each named in the record together with the generation that it was made for.
//!
//! A file is whole and read-only before the record names it, and goes once the record names another: readers keep what they have mapped. What a
//! killed daemon left goes when its successor claims the map.

use super::error::ServeError;
use super::server::Server;
use mapd_transport::{Domain, OverlayLocation, Share, overlay_file};
use rustix::fs::{Mode, OFlags};
use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;

/// Mode while it is written.
const WRITING: Mode = Mode::RUSR.union(Mode::WUSR);

/// An overlay that is to be published: opaque bytes.
#[derive(Clone, Debug)]
pub struct OverlayBytes {
    /// Rises with each that is published.
    pub revision: u64,
    /// Hash of its content.
    pub content_hash: [u8; 32],
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// The file of an overlay; it goes with the value.
#[derive(Debug)]
pub(crate) struct OverlayFile {
    path: PathBuf,
    pub(crate) place: OverlayLocation,
}

impl OverlayFile {
    /// Writes the file, with all its pages.
    ///
    /// Errors: what the system says; nothing is left then.
    pub(crate) fn write(
        domain: &Domain,
        map: &str,
        overlay: &OverlayBytes,
        share: Share,
    ) -> io::Result<Self> {
        let path = overlay_file(domain, map, overlay.revision);
        let flags =
            OFlags::RDWR | OFlags::CREATE | OFlags::EXCL | OFlags::NOFOLLOW | OFlags::CLOEXEC;
        let mut file = File::from(rustix::fs::open(&path, flags, WRITING)?);
        let length = overlay.bytes.len() as u64;
        let (revision, content_hash) = (overlay.revision, overlay.content_hash);
        // From here on it is removed again if something fails.
        let mut made =
            Self { path, place: OverlayLocation { revision, length, inode: 0, content_hash } };
        // Writing takes a page for each of its bytes, or fails: taking them first would clear each before it is written.
        file.write_all(&overlay.bytes)?;
        share.finished(&file)?;
        made.place.inode = file.metadata()?.ino();
        Ok(made)
    }
}

impl Drop for OverlayFile {
    fn drop(&mut self) {
        // What stays is removed when the map is claimed again.
        let _ = fs::remove_file(&self.path);
    }
}

/// Removes what a killed daemon left of a map's overlays.
pub(crate) fn remove_left(domain: &Domain, map: &str) {
    let whole = overlay_file(domain, map, 0);
    let Some(prefix) = whole.file_name().and_then(|name| name.to_str()?.strip_suffix('0')) else {
        return;
    };
    for entry in fs::read_dir(domain.root()).into_iter().flatten().flatten() {
        let is_left = |name: &str| {
            name.strip_prefix(prefix).is_some_and(|rest| rest.bytes().all(|b| b.is_ascii_digit()))
        };
        if entry.file_name().to_str().is_some_and(is_left) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

impl Server {
    /// Lays an overlay over what is served of a map, in the place of the one before; `None`: nothing is laid over it any more. Clients that wait are
    /// woken.
    ///
    /// Errors: nothing is served; what the system says. Then what was laid over it stays.
    pub fn lay(&mut self, map: &str, overlay: Option<&OverlayBytes>) -> Result<(), ServeError> {
        let io = ServeError::io(self.domain.root());
        let Some(ports) = self.maps.get_mut(map) else {
            return Err(ServeError::iceoryx("laying an overlay")("map not claimed"));
        };
        let file =
            overlay.map(|overlay| OverlayFile::write(&self.domain, map, overlay, self.share));
        file.transpose().and_then(|file| ports.lay(file)).map_err(io)
    }
}
