//! From an OpenDRIVE document to the tables of an archive.
//!
//! [`compile`] reads a stream road by road, checks each, lowers it to flat rows, then resolves links, samples lanes and
//! builds the spatial index on the compact network. What is wrong with the map comes back as findings with line and
//! column; `Err` is for the environment.
//!
//! Invariants: the document is never whole in memory; geometry is evaluated by the very functions that queries use; the
//! same bytes and options give the same archive on every machine and for every number of threads. Deliberately absent:
//! files, shared memory, printing.
//!
//! ```
//! let map = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>
//! <road id="1" length="10" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="10"><line/></geometry></planView>
//! <lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
//! </road></OpenDRIVE>"#;
//! let compiled = mapd_compiler::compile(map.as_bytes(), &Default::default(), &mut |_| {}).unwrap();
//! let bytes = mapd_archive::encode(compiled.rows.as_ref().unwrap(), &compiled.provenance).unwrap();
//! assert_eq!(mapd_archive::verify(&bytes).unwrap().tables.lanes.len(), 2);
//! ```

mod draft;
mod findings;
mod frame;
mod graph;
mod index;
mod lower;
mod objects;
mod options;
mod pipeline;
mod quarantine;
mod report;
mod resolve;
mod sample;
mod signals;
mod without;

pub use mapd_geodesy::{Target, TargetError};
pub use options::{
    CompileOptions, CyclePolicy, MarkReading, OffsetSign, OptionsError, ReadOptions,
};
pub use quarantine::{OnError, PartKind, Policy, QuarantinedContent, QuarantinedPart, Treatment};
pub use report::{Compilation, Counts, Diagnostic, Progress, Verdict, Version};
pub use without::{Extra, Without};

use std::io::{self, Read};

/// Compiles a document that includes no files. `progress` is told after each top-level element and at each stage.
///
/// Errors: reading failed. A map that is rejected is no error: see [`Compilation::verdict`].
pub fn compile(
    input: impl Read + Send,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    compile_with(input, &ReadOptions::default(), options, progress)
}

/// Compiles a document that can be read once. An error rejects the map: to leave out the part that has it, the document must
/// be read again, which [`compile_from`] does.
///
/// Errors: reading failed. A map that is rejected is no error: see [`Compilation::verdict`].
pub fn compile_with(
    input: impl Read + Send,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    pipeline::compile_once(input, reading, options, progress)
}

/// Compiles a document. `open` yields it from its start, as often as it is called: parts with errors are treated as
/// [`ReadOptions::policy`] says.
///
/// Errors: reading failed, or the document changed in between. A map that is rejected is no error: see
/// [`Compilation::verdict`].
pub fn compile_from<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    pipeline::compile(&mut open, reading, options, progress)
}

/// Finds everything that [`compile_with`] finds, without building the map: there are no rows.
///
/// Errors: reading failed.
pub fn check(
    input: impl Read + Send,
    reading: &ReadOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    pipeline::check_once(input, reading, &options, progress)
}

/// Finds everything that [`compile_from`] finds, without building the map: there are no rows.
///
/// Errors: reading failed, or the document changed in between.
pub fn check_from<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    check_with(&mut open, reading, &CompileOptions::default(), progress)
}

/// As [`check_from`], for a map that is to be compiled with these options.
///
/// Errors: reading failed, or the document changed in between.
pub fn check_with<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let options = CompileOptions { landmarks: 0, ..options.clone() };
    pipeline::check(&mut open, reading, &options, progress)
}
