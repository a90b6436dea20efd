//! The daemon's side of the transport: one exactly sized publisher per generation.
//!
//! ```text
//! start    root folder, attach lock alone, sweep half-made segments, clean up after the dead
//! publish  map lock, room?, service, publisher, loan, reserve pages, fill, verify, send, 0444, tell clients
//! run      a client arrived → connect it; once a second → sweep and clean up, if nobody is attaching
//! ```

mod error;
mod generation;
mod loan;
mod room;
mod server;
mod stop;
mod sweep;

pub use error::ServeError;
pub use server::{PublishMeta, Server};
pub use stop::StopSignal;
