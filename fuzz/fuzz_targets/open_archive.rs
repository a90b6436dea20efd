//! Opens damaged archives, proves them, and asks for all their rows: no panic, no access outside. Paths, which take long, are asked by `damaged`.
//!
//! The first byte chooses: the rest as an archive of its own, or as a list of patches (place, value) to a good one, in the header and the
//! directory or anywhere, whose hashes are then made to fit or not, and which may be cut.
#![no_main]

use libfuzzer_sys::fuzz_target;
use mapd_archive::{AlignedBytes, HEADER_LENGTH, TableEntry};
use mapd_tests::damage::{ask_rows, seal, seal_header};
use mapd_tests::{carried, maps};
use std::sync::OnceLock;

/// Bytes behind the header that the directory takes at least.
const DIRECTORY: usize = 20 * size_of::<TableEntry>();

/// Patches of one input.
const PATCHES: usize = 16;

fn good() -> &'static [u8] {
    static GOOD: OnceLock<Vec<u8>> = OnceLock::new();
    GOOD.get_or_init(|| maps::open(&carried("one_road.xodr")).bytes().to_vec())
}

fn aligned(bytes: &[u8]) -> AlignedBytes {
    let mut out = AlignedBytes::with_capacity(bytes.len());
    out.extend_from_slice(bytes);
    out
}

fuzz_target!(|data: &[u8]| {
    let Some((choice, rest)) = data.split_first() else { return };
    if choice & 1 == 0 {
        return ask_rows(aligned(rest));
    }
    let mut bytes = aligned(good());
    for patch in rest.chunks_exact(4).take(PATCHES) {
        let at = usize::from(u16::from_le_bytes([patch[0], patch[1]]));
        let at = match patch[2] & 3 {
            // Header and directory, which decide where everything lies.
            0 => at % (HEADER_LENGTH + DIRECTORY),
            1 => bytes.len().wrapping_sub(1 + at),
            _ => at,
        };
        if let Some(byte) = bytes.get_mut(at) {
            *byte = patch[3];
        }
    }
    match choice >> 1 & 3 {
        0 => seal(&mut bytes),
        1 => seal_header(&mut bytes),
        2 => {
            let length = bytes.len() - rest.len().min(bytes.len());
            bytes.resize(length, 0);
        }
        _ => {}
    }
    let _ = mapd_archive::unknown(&bytes);
    ask_rows(bytes);
});
