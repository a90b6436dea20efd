//! `mapd check`: every finding about a file, whether or not a map can be built from it.

mod excerpt;
mod json;
mod sarif;
mod text;
mod xqar;

use crate::args::{FrameArgs, JudgingArgs, ProgressArgs, ThreadsArg};
use crate::exit::Exit;
use crate::progress::Meter;
use crate::source::{self, Input};
use anyhow::{Context, Result};
use clap::{Args, ValueEnum};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions};
use mapd_xodr::{Limits, source::SourceLimits};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Said at the end of `mapd help check`.
pub(crate) fn help() -> String {
    format!(
        "{}\n\nExit codes: 0 the map would be accepted (no errors), 3 parts of it would be left out, 4 it would be rejected, 2 wrong usage, 1 the file \
         cannot be read.",
        mapd_rules::ERROR
    )
}

/// What to check, and how.
#[derive(Args)]
pub(crate) struct CheckCommand {
    /// OpenDRIVE file (.xodr or .xodrz)
    file: PathBuf,
    /// Output format of findings
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Print JSON: as --format json
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// text: tell every finding, not only the first three of each rule
    #[arg(long)]
    all: bool,
    #[command(flatten)]
    frame: FrameArgs,
    #[command(flatten)]
    reading: ReadArgs,
    #[command(flatten)]
    threads: ThreadsArg,
    #[command(flatten)]
    progress: ProgressArgs,
}

/// Output format of findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people: each finding with its line of the file.
    Text,
    /// For programs: one document.
    Json,
    /// For code review tools: SARIF 2.1.0.
    Sarif,
    /// For ASAM's quality checker framework: its result file.
    Xqar,
}

/// Bounds on what a file may ask for, and where it may include others from.
#[derive(Args)]
struct ReadArgs {
    /// Deepest nesting of elements
    #[arg(long, value_name = "N", default_value_t = Limits::default().depth)]
    max_depth: usize,

    /// Longest tag, including its attributes [bytes]
    #[arg(long, value_name = "BYTES", default_value_t = Limits::default().tag_bytes)]
    max_attribute_length: usize,

    /// Most attributes of one element
    #[arg(long, value_name = "N", default_value_t = Limits::default().attributes)]
    max_attributes: usize,

    /// Longest text, comment or CDATA section [bytes]
    #[arg(long, value_name = "BYTES", default_value_t = Limits::default().text_bytes)]
    max_text_length: usize,

    /// Largest file with all its includes, decompressed [bytes]
    #[arg(long, value_name = "BYTES", default_value_t = SourceLimits::default().decoded_bytes)]
    max_bytes: u64,

    /// Largest road, junction or other top-level element, plus 256 bytes for each element inside [bytes]
    #[arg(long, value_name = "BYTES", default_value_t = Limits::default().item_bytes)]
    max_road_bytes: usize,

    /// Findings of reading to keep of one kind for one type of element; more are only counted
    #[arg(long, value_name = "N", default_value_t = Limits::default().findings_of_a_kind)]
    max_findings: u32,

    /// Folder that files may be included from [default: the folder of FILE]
    #[arg(long, value_name = "FOLDER")]
    include_base: Option<PathBuf>,

    #[command(flatten)]
    judging: JudgingArgs,
}

impl ReadArgs {
    fn options(&self, file: &Path) -> Result<ReadOptions> {
        let source = SourceLimits { decoded_bytes: self.max_bytes, ..SourceLimits::default() };
        let limits = Limits {
            depth: self.max_depth,
            tag_bytes: self.max_attribute_length,
            text_bytes: self.max_text_length,
            attributes: self.max_attributes,
            item_bytes: self.max_road_bytes,
            findings_of_a_kind: self.max_findings,
            source,
            ..Limits::default()
        };
        let include_folder = self.include_base.clone().or_else(|| source::folder(file));
        self.judging.apply(ReadOptions { limits, include_folder, ..ReadOptions::default() })
    }
}

impl CheckCommand {
    /// Checks a file and writes what was found.
    ///
    /// Errors: the file cannot be read, or the output not written.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        self.threads.start(None)?;
        let file = &*self.file;
        let options = CompileOptions { crs: self.frame.crs, ..CompileOptions::default() };
        let bar = Meter::of_file(file, self.progress.manner());
        let mut input = Input::open(file)?;
        let reading = self.reading.options(file)?;
        let show = &mut |p| bar.show(p);
        let checked = mapd_compiler::check_with(|| input.reopen(), &reading, &options, show)
            .with_context(|| format!("reading {}", file.display()))?;
        bar.finish();
        match if self.json { Format::Json } else { self.format } {
            Format::Text => text::write(file, &checked, self.all, out)?,
            Format::Json => json::write(file, &checked, out)?,
            Format::Sarif => sarif::write(file, &checked, out)?,
            Format::Xqar => xqar::write(file, &checked, out)?,
        }
        Ok(checked.verdict.into())
    }
}

/// Findings of each rule, most first: rule, count.
fn by_rule(checked: &Compilation) -> Vec<(&'static str, usize)> {
    let mut counts = std::collections::BTreeMap::new();
    for (_, rule, count) in checked.counts.iter() {
        *counts.entry(rule).or_insert(0) += count;
    }
    let mut rules: Vec<(&str, usize)> = counts.into_iter().collect();
    rules.sort_by_key(|(rule, count)| (std::cmp::Reverse(*count), *rule));
    rules
}
