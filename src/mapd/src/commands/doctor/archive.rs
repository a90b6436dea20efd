//! The archive that is to be served: whether it is one that this release reads, and sound.

use super::finding::{Finding, size};
use mapd_archive::FORMAT;
use mapd_client::{ClientError, Snapshot};
use std::path::Path;

/// Opens and proves the archive as the daemon does; its length \[bytes\], 0 of what is no file.
pub(super) fn examine(path: &Path, out: &mut Vec<Finding>) -> u64 {
    let check = "archive";
    let file = path.metadata().ok().filter(|metadata| metadata.is_file());
    let length = file.map_or(0, |file| file.len());
    let proved = Snapshot::open(path).and_then(|snapshot| snapshot.verify());
    out.push(match proved {
        Ok(()) => Finding::ok(
            check,
            format!("{}: {} of format {FORMAT}, every byte verified", path.display(), size(length)),
        ),
        Err(error @ ClientError::File { .. }) => {
            let advice = "name a file that the daemon's user can read";
            Finding::problem(check, error.to_string(), advice)
        }
        Err(error) => Finding::problem(
            check,
            error.to_string(),
            "compile the map (mapd compile FILE.xodr -o FILE.mapd), or copy the archive again",
        ),
    });
    length
}
