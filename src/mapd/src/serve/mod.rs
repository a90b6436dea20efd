//! Publishing generations of maps from one daemon to any number of processes.
//!
//! A [`Server`] claims map names, publishes opaque bytes under them, and answers newcomers until a [`StopSignal`] ends it.
//! The bytes are written once, straight into shared memory, by a function that the caller gives; each generation has a
//! publisher of its own, exactly as large as the map. The meeting place and what clients do there is described in
//! [`mapd_transport`].
//!
//! Invariants: a generation number never repeats; a fill that fails leaves nothing
//! behind; memory is reserved before it is written, so that too little of it is an error and no signal; segments are
//! created and dead processes cleaned up only under the attach lock; a server that is dropped leaves nothing in shared
//! memory but what living clients hold; nothing of another user is opened, removed or changed (`mapd_transport`). Nothing is printed: what happens meanwhile is told through
//! [`Server::start_with`].
//!
//! ```no_run
//! use mapd::serve::{PublishMeta, Server, StopSignal};
//! use mapd_client::Domain;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let stop = StopSignal::install()?;
//! let mut server = Server::start(&Domain::from_env()?)?;
//! let bytes = b"the map";
//! server.publish("town", bytes.len(), |loan| {
//!     loan.copy_from_slice(bytes);
//!     Ok(PublishMeta { layout_id: [0; 32], content_hash: [0; 32], input_hash: [0; 32] })
//! })?;
//! server.run(&stop)?;
//! # Ok(())
//! # }
//! ```

mod cleanup;
mod control_group;
mod doorbell;
mod error;
mod generations;
mod greeter;
mod guard;
mod held;
mod lease;
mod loan;
mod locked;
mod memory;
mod nodes;
mod notice;
mod orphans;
mod overlays;
mod own_segment;
mod publishing;
mod reserve;
mod segment;
mod served_map;
mod server;
mod services;
mod sharing;
mod stop;
mod strangers;

pub(crate) use control_group::available as control_group_available;
pub use doorbell::{Doorbell, Ringer};
pub use error::ServeError;
pub use guard::shm_open;
pub use held::{HeldGeneration, HeldGenerations};
pub use loan::PublishMeta;
pub(crate) use memory::available as available_memory;
pub(crate) use memory::{OVERHEAD, machine_available};
pub use notice::Notice;
pub use overlays::OverlayBytes;
pub use reserve::ftruncate;
pub(crate) use reserve::reserving;
pub use server::{ServedMap, Server};
pub use stop::StopSignal;
