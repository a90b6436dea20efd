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
mod check;
pub mod cli;
pub mod exit;
pub mod export;
mod graph_facts;
mod inspect;
mod judging;
mod load;
mod object_facts;
mod ontology_args;
mod progress;
pub mod query;
pub mod report;
pub mod serve;
mod signal_facts;
pub mod source;
mod status;
