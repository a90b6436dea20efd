//! The daemon and command line of mapd, as a library so that programs and tests can run the same jobs.
//!
//! `mapd --load map.xodr` compiles a map, proves the archive and publishes it in shared memory until it is told to stop.
//! Other jobs are subcommands. Answers go to stdout, everything else to stderr.
//!
//! Invariants: a map that is rejected leaves nothing behind; what is published has been verified in place; exit codes are
//! those of [`exit::Exit`]. Deliberately absent: queries and geometry, which live in `mapd-query`.
//!
//! ```
//! use mapd::source;
//!
//! # let path = std::env::temp_dir().join(format!("mapd-doc-{}.xodr", std::process::id()));
//! # std::fs::write(&path, r#"<OpenDRIVE><header revMajor="1" revMinor="7"/></OpenDRIVE>"#).unwrap();
//! let compiled = source::compile_file(&path, &Default::default(), &mut |_| {}).unwrap();
//! assert!(compiled.rows.is_some());
//! # std::fs::remove_file(&path).unwrap();
//! ```

mod allocator;
pub mod archive_file;
mod args;
pub mod cache;
mod child;
pub mod cli;
mod clock;
mod colour;
pub mod commands;
pub mod control;
mod daemon;
pub mod draft;
mod early_sync;
pub mod exit;
mod faults;
mod findings;
mod http;
mod joining;
mod oversight;
mod places;
mod printable;
mod program;
pub mod progress;
pub mod report;
mod rounded;
mod same_file;
pub mod serve;
mod similar;
mod small_text;
pub mod source;
mod trust;

pub use allocator::Allocator;
