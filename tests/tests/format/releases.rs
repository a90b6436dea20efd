//! Archives of releases of other ages: what this one does not know is left alone, what it would misread is refused by name.

use mapd_archive::{AlignedBytes, OpenError, open};
use std::path::{Path, PathBuf};

/// Archives of released layouts.
fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/archives")
}

fn read(path: &Path) -> AlignedBytes {
    let mut bytes = AlignedBytes::new();
    bytes.extend_from_slice(&std::fs::read(path).expect("readable"));
    bytes
}

#[test]
fn format_1_is_refused_by_name() {
    let error = open(&read(&golden().join("format-1.mapd"))).err().expect("refused");
    assert_eq!(error, OpenError::Format { expected: 2, found: 1 });
    assert!(error.to_string().contains("format 1"), "{error}");
}
