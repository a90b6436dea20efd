//! Where a map's daemon takes proposals, and how long one may be. What is written there is the business of `mapd-client` and the daemon.

use crate::Domain;
use std::path::PathBuf;

/// Longest proposal, with the name of its source \[bytes\]: daemons read no longer ones.
pub const LONGEST_PROPOSAL: usize = 64 << 10;

/// The socket on which a map's daemon takes proposals. Its name holds a hash instead of the map's name: the path of a socket has 107 bytes.
pub fn proposals_socket(domain: &Domain, map: &str) -> PathBuf {
    // Fowler, Noll and Vo's hash 1a.
    let hash = map.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    domain.root().join(format!("proposals-{hash:016x}"))
}
