//! mapd for C and C++ (`include/mapd.h` and `include/mapd/queries.hpp`, made from these sources, and `include/mapd.hpp` around them).
//!
//! Every function that can fail returns a [`mapd_code`] and takes an optional [`mapd_error`] of the caller's for the message. Handles
//! are opaque; a caller that gets one closes it with the function that takes its address and sets it to null. Results are plain data. Lists
//! go into the caller's buffer: its capacity goes in, the number of all entries comes out, and [`mapd_code::TOO_SMALL`] says that
//! only as many as there was room for were written.
//!
//! # Safety
//!
//! This holds for every function. A pointer is null, which is answered with [`mapd_code::NULL_POINTER`] wherever the pointer is needed, or
//! it points to what its type says, aligned, for as long as the call lasts; buffers have the length that is given with them. A handle is used only
//! between its making and its closing. Clients, snapshots, views, paths and projectors may be used by several threads at once;
//! scratches, trackers and events belong to one thread at a time. A text points into the snapshot and is valid until the last handle of
//! its content is closed.
//!
//! No panic leaves a function: it becomes [`mapd_code::PANIC`].

mod along;
mod client;
mod code;
mod conflicts;
mod corridor;
mod details;
mod earth;
mod events;
mod graph;
mod ground;
mod groups;
mod ids;
mod junction;
mod landmarks;
mod lane;
mod list;
mod lookup;
mod marks;
mod matching;
mod movement;
mod names;
mod nearest;
mod objects;
mod options;
mod path;
mod path_facts;
mod path_steps;
mod point;
mod polyline;
mod propose;
mod request;
mod road;
mod route;
mod scratch;
mod signals;
mod signals_ahead;
mod snapshot;
mod surface;
mod text;
mod tracker;
mod view;
mod view_path;
mod view_ways;

pub use along::*;
pub use client::*;
pub use code::*;
pub use conflicts::*;
pub use corridor::*;
pub use details::*;
pub use earth::*;
pub use events::*;
pub use graph::*;
pub use ground::*;
pub use groups::*;
pub use ids::*;
pub use junction::*;
pub use landmarks::*;
pub use lane::*;
pub use lookup::*;
pub use marks::*;
pub use matching::*;
pub use movement::*;
pub use names::*;
pub use nearest::*;
pub use objects::*;
pub use path::*;
pub use path_facts::*;
pub use path_steps::*;
pub use point::*;
pub use polyline::*;
pub use propose::*;
pub use request::*;
pub use road::*;
pub use route::*;
pub use scratch::*;
pub use signals::*;
pub use signals_ahead::*;
pub use snapshot::*;
pub use surface::*;
pub use text::*;
pub use tracker::*;
pub use view::*;
pub use view_path::*;
pub use view_ways::*;
