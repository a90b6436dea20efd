//! How a generation of a map travels from the daemon to its readers: opaque bytes in iceoryx2 shared memory.
//!
//! The daemon publishes one exactly sized sample per generation. An [`Observer`] maps it and writes nothing; a `Subscription`
//! takes part in iceoryx2 and receives it (feature `iceoryx2`, which the daemon needs too). Either way a [`Pinned`] keeps the bytes readable as long as it exists, even if the daemon ends. Nothing here knows what the bytes mean.
//!
//! Where both sides meet is a [`Domain`]: a prefix for every file in `/dev/shm` and a root folder there, mode 0700.
//!
//! ```text
//! /dev/shm/mapd_…                     segments of iceoryx2: map data (0400), queues, service state, counter of nodes
//! /dev/shm/mapd_root/.attach          flock: shared while a client attaches, exclusive while a daemon creates or cleans
//! /dev/shm/mapd_root/.turn            flock: taken by every process before .attach, so that daemons get their turn
//! /dev/shm/mapd_root/.present         flock: shared by every process that uses the domain; free if no process does
//! /dev/shm/mapd_root/{map}.lock       flock, exclusive while a daemon serves the map; holds its process id
//! /dev/shm/mapd_root/{map}.generation the last generation number handed out
//! /dev/shm/mapd_root/{map}.published  record of what is served now: one page, on which readers wait
//! /dev/shm/mapd_root/{map}.overlay-…  the map's overlay, if there is one; named by the record
//! /dev/shm/mapd_root/{map}.staged     the staged generation, which waits to be served
//! /dev/shm/mapd_root/control-…        the daemon's socket for `mapd status`, `reload`, `rollback`, `activate`
//! /dev/shm/mapd_root/proposals-…      the daemon's socket for proposals of a map's overlay, if it takes any
//! /dev/shm/mapd_root/{nodes,services} iceoryx2's own files
//! ```
//!
//! Why the attach lock: a process killed while it creates a segment leaves one of size zero or without read permission,
//! and iceoryx2 0.10 waits for such a segment for ever. A process that creates anything therefore holds the lock. A daemon that
//! holds it exclusively knows that the creator of every unfinished segment has died, and removes the segment before another process can wait for it.
//!
//! Every user can put files into `/dev/shm`. What belongs to another user than the domain's is no part of the domain, whatever its name: no file there is opened but by
//! [`open_guarded`], which follows no link, waits for no pipe and asks the open file whose it is. What the domain's user has there, nobody else can remove or replace,
//! for the folder is sticky. Where a stranger was first, the error names the file and its owner.
//!
//! Invariants: a client creates no service, cleans up nothing, starts no thread, installs no signal handler, prints
//! nothing, and reads no configuration; every wait has a deadline. All processes of a domain run as one user.
//!
//! ```no_run
//! use mapd_transport::{Domain, Observer};
//! use std::time::{Duration, Instant};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let deadline = Instant::now() + Duration::from_secs(2);
//! let observer = Observer::connect(&Domain::from_env()?, "town", deadline)?;
//! let pinned = observer.wait_newer(0, deadline)?;
//! assert_eq!(pinned.bytes().len() as u64, pinned.info().length);
//! # Ok(())
//! # }
//! ```

mod accounts;
mod attach_lock;
mod claim;
mod connecting;
mod deadline;
mod domain;
mod error;
mod limits;
mod mapping;
mod observer;
mod payload;
mod pinned;
mod presence;
mod proposals;
mod record;
mod regular;
mod room;
mod share;
mod status;
#[cfg(feature = "iceoryx2")]
mod subscriber;
mod unfinished;
mod user;

pub use accounts::{group_id, user_id};
pub use attach_lock::{AttachGuard, AttachLock};
pub use claim::{Claim, ClaimError, served_by};
pub use connecting::connect_until;
pub use deadline::after;
pub use domain::{
    DEFAULT_PREFIX, Domain, DomainError, MAX_PREFIX_LENGTH, OWNER_VARIABLE, PREFIX_VARIABLE,
    SHARED_MEMORY_FOLDER,
};
pub use error::AttachError;
pub use limits::*;
pub use mapping::Mapping;
pub use observer::{
    Observer, OverlayLocation, OverlayState, PinnedOverlay, RecordWriter, SegmentLocation,
    heartbeat_age, overlay_file, revision_of,
};
pub use payload::{Chunk64, GenerationInfo, chunks_for};
pub use pinned::Pinned;
pub use presence::{Presence, Sharing};
pub use proposals::{LONGEST_PROPOSAL, proposals_socket};
pub use record::{
    GENERATION_SUFFIX, LARGEST_GENERATION, RECORD_SUFFIX, hex, parse_generation, pending,
    read_generation, read_generation_file, remove_staged, replace_text, replace_text_durably,
    write_generation, write_staged,
};
pub use regular::{
    OWN_FILE, Untrusted, create_guarded, open_guarded, open_owned, open_regular, read_owned,
    read_regular,
};
pub use room::{ATTACH_DESCRIPTORS, ATTACH_ROOM, Descriptors, descriptors, free_bytes};
pub use share::Share;
pub use status::{MapStatus, list_maps};
#[cfg(feature = "iceoryx2")]
pub use subscriber::{
    AttachTiming, Subscription, TransportService, count_subscriptions, foreign_node_counter,
    iceoryx2_config, node_counter, prepare_node_counter, silence_iceoryx2,
};
pub use unfinished::{DomainFiles, ForeignFile, MOST_FOREIGN, domain_files, unfinished_segments};
pub use user::{check_own, check_owner, is_ours};
