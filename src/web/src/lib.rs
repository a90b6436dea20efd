//! A map as one HTML page, which draws it and answers questions about it.
//!
//! The crate is compiled twice. For WebAssembly it is the module that the page runs: the project's own queries on the archive's
//! own bytes, with drawings for a graphics card and sheets of facts. For the machine it writes the page, with that module in
//! it, and answers the same questions for tests that compare the two. It asks no network for anything.

mod drawing;
#[cfg(target_arch = "wasm32")]
mod edge;
mod find;
#[cfg(not(target_arch = "wasm32"))]
pub mod page;
mod paint;
mod place;
mod question;
mod scene;
mod sheet;
mod signs;
mod strokes;
mod triangles;
mod way;

pub use drawing::{Chunk, Corner, Drawing, LEVEL, Pen, Stroke, TILE};
pub use find::{MOST_FOUND, find};
pub use paint::Paint;
pub use place::{LaneHere, PlanPoint, pick};
pub use question::{Answer, Question};
pub use scene::Layer;
pub use sheet::{Fact, Kind, Link, Sheet, Words};
pub use signs::SignalSign;
pub use strokes::MarkStroke;
pub use way::{DrawnWay, Meeting, Step, Told, Way, highlight, way};
