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
mod annotation_facts;
pub mod archive_file;
mod bench;
pub mod cache;
mod change;
mod check;
mod child;
pub mod cli;
mod clock;
mod compile;
mod compile_args;
pub mod control;
mod daemon;
mod doctor;
mod draft;
pub mod exit;
pub mod export;
mod faults;
mod graph_facts;
mod inspect;
mod joining;
mod judging;
mod number;
mod object_facts;
mod ontology_args;
mod oversight;
mod progress;
pub mod query;
pub mod report;
mod same_file;
pub mod serve;
mod sign;
mod signal_facts;
mod size;
mod small_text;
pub mod source;
mod status;
mod threads;
mod trust;

pub use allocator::Allocator;
