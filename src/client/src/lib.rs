//! Attach to a map that mapd serves and query its lanes in place.
//!
//! A [`Client`] connects by map name, whichever side starts first. A [`Snapshot`] pins one generation: it stays valid and
//! readable as long as it exists, whatever the daemon does, and many threads query it without locks. [`Snapshot::open`] maps
//! a `.mapd` file and gives a snapshot too, so that tests of a planner need no daemon.
//!
//! Without the feature `subscriber`, which is on by default, iceoryx2 is not built; observers, files and bytes remain.
//!
//! Invariants: attaching validates in constant time; every wait has a deadline; no signal handlers, no threads, no
//! output, no configuration read from the working directory. Deliberately absent: XML, compiling, publishing.
//!
//! ```no_run
//! use mapd_client::{Client, NearestOptions, glam::DVec2};
//! use std::time::Duration;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let client = Client::connect("town", Duration::from_secs(5))?;
//! let snapshot = client.snapshot();
//! let map = snapshot.map();
//! if let Some(hit) = map.nearest_lane(DVec2::new(12.0, -3.0), &NearestOptions::default())? {
//!     println!("{} s={:.2}", map.lane(hit.lane)?.key(), hit.position.s);
//! }
//! # Ok(())
//! # }
//! ```

mod client;
mod error;
mod events;
mod file;
pub mod overlay;
mod snapshot;
#[cfg(feature = "trust")]
mod trust;
#[cfg(feature = "trust")]
mod trust_overlay;

pub use client::{Attach, Client};
pub use error::ClientError;
pub use events::{Events, MapEvent};
pub use mapd_query::*;
pub use mapd_transport::{AttachError, Domain, DomainError, GenerationInfo};
pub use snapshot::Snapshot;
#[cfg(feature = "trust")]
pub use trust::{SIGNATURE_SUFFIX, TrustError, TrustedKey, read_signature, signature_path};
#[cfg(feature = "trust")]
pub use trust_overlay::SignedEntries;
