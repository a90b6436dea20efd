//! How maps travel: iceoryx2 publish-subscribe, one sample per generation.
//!
//! This side attaches; the daemon's side is in the crate `mapd`. What both must agree on stands in `protocol`. The bytes
//! are opaque here.

mod domain;
mod error;
mod locks;
mod pinned;
pub mod protocol;
mod status;
mod subscription;

pub use domain::{Domain, DomainError};
pub use error::AttachError;
pub use locks::{AttachLock, LockMode};
pub use pinned::Pinned;
pub use protocol::GenerationInfo;
pub use status::{MapStatus, list_maps, map_lock};
pub use subscription::Subscription;
