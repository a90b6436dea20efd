//! `mapd compile`: one file in this process, or in a child with a ceiling of memory; many files, each in a child.

mod inputs;
mod one;
mod table;
mod tiles;
mod up_to_date;

use crate::args::BuildArgs;
use crate::args::CompileArguments;
use crate::args::JudgingArgs;
use crate::args::ProgressArgs;
use crate::args::Size;
use crate::args::at_least_one;
use crate::args::{ThreadCount, ThreadsArg};
use crate::child::{self, ChildReport, End, Message, Output, Work};
use crate::draft;
use crate::exit::Exit;
use crate::exit::UsageError;
use crate::printable::shown;
use crate::progress::Meter;
use crate::rounded;
use crate::same_file::is_same_file;
use crate::source::Compiling;
use anyhow::{Context, Result, bail};
use clap::{ArgMatches, Args, ValueEnum};
use mapd_compiler::Progress;
use one::Target;
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// Shortest time between two messages of a child about how much it has read.
const MESSAGES: Duration = Duration::from_millis(200);

/// Options that make tiles of whatever is compiled, a single file as well.
const TABLE: [&str; 3] = ["output_dir", "jobs", "json"];

/// Said at the end of `mapd help compile`.
pub(crate) const HELP: &str = "\
With several files, a folder, --output-dir, --jobs or --json, each file is a tile. Tiles are compiled in processes of their own, \
several at once. Next to DIR/NAME.mapd, DIR/NAME.report.json has the findings. Folders are searched recursively for .xodr and \
.xodrz; DIR gets the same subfolders. A tile is skipped if its archive is up to date with its input, included files, options and \
the program. Jobs share the memory and, without --threads, the cores. The result is a table on stdout; docs/tiles.md has more.\n\n\
Exit codes: 0 done and accepted, 3 a map was accepted with quarantined parts, 4 a map was rejected, 2 wrong usage, 1 the \
environment failed, for example because compiling needed more memory than --max-memory. For several tiles the worst counts: \
1 before 4 before 3.";

/// What to compile, and how.
#[derive(Args)]
pub(crate) struct CompileCommand {
    /// OpenDRIVE files (.xodr or .xodrz), and folders of them
    #[arg(required = true, value_name = "FILE")]
    inputs: Vec<PathBuf>,

    /// For a single file: archive to write [default: FILE with the ending .mapd]
    #[arg(short, long, value_name = "OUT.mapd", conflicts_with_all = TABLE)]
    output: Option<PathBuf>,

    /// Folder for archives and reports, created if necessary [default: next to each file]
    #[arg(long, value_name = "DIR")]
    output_dir: Option<PathBuf>,

    /// For a single file: write the findings as JSON
    #[arg(long, value_name = "R.json", conflicts_with_all = TABLE)]
    report: Option<PathBuf>,

    /// Compile tiles even if they are up to date; a single file is always compiled
    #[arg(long)]
    force: bool,

    /// Tiles to compile at once [default: number of cores]
    #[arg(long, value_name = "N", value_parser = at_least_one::<NonZeroUsize>)]
    jobs: Option<NonZeroUsize>,

    /// Write the table of tiles as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    options: BuildArgs,

    #[command(flatten)]
    judging: JudgingArgs,

    #[command(flatten)]
    threads: ThreadsArg,

    /// Limit of memory for the compiler's own data, of all tiles together, such as 4GiB [default: three quarters of what is
    /// free; for a single file no limit]
    #[arg(long, visible_alias = "memory-limit", value_name = "SIZE")]
    max_memory: Option<Size>,

    #[command(flatten)]
    progress: ProgressArgs,

    /// As the child of another mapd: where the archive goes, its answer as lines of JSON
    #[arg(long, hide = true, requires = "output")]
    child: Option<ChildOutput>,
}

/// As [`Output`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ChildOutput {
    /// Into the file that is there.
    Into,
    /// To a file that appears when it is whole.
    At,
}

/// Runs the command. `matches` are those of its own arguments.
///
/// Errors: wrong usage; files that cannot be read or written; no memory.
pub(crate) fn run(
    command: CompileCommand,
    matches: &ArgMatches,
    out: &mut dyn Write,
) -> Result<Exit> {
    if let (Some(to), [file]) = (command.child, command.inputs.as_slice()) {
        return be_child(&command, file, to, out);
    }
    let is_many = command.inputs.len() > 1
        || command.output_dir.is_some()
        || command.jobs.is_some()
        || command.json
        || command.inputs.iter().any(|input| input.is_dir());
    match command.inputs.as_slice() {
        [file] if !is_many => compile_one(&command, file, matches, out),
        _ => compile_many(&command, matches, out),
    }
}

/// Compiles in this process for another one.
fn be_child(
    command: &CompileCommand,
    file: &Path,
    to: ChildOutput,
    out: &mut dyn Write,
) -> Result<Exit> {
    child::end_with_parent();
    if let Some(limit) = command.max_memory {
        child::limit_memory(limit.0).context("limiting memory")?;
    }
    command.threads.start(command.max_memory)?;
    let reading = command.options.reading(&command.judging)?;
    let options = command.options.validated()?;
    let archive = command.output.clone().unwrap_or_default();
    let target =
        Target { archive, report: command.report.clone(), is_there: to == ChildOutput::Into };
    let mut told_at: Option<Instant> = None;
    let mut failed = Ok(());
    let mut tell = |message: &Message| -> io::Result<()> {
        serde_json::to_writer(&mut *out, message)?;
        writeln!(out)?;
        out.flush()
    };
    let mut progress = |progress: Progress| {
        let is_reading = matches!(progress, Progress::Reading { .. });
        if !is_reading || told_at.is_none_or(|at| at.elapsed() >= MESSAGES) {
            told_at = Some(Instant::now());
            failed = std::mem::replace(&mut failed, Ok(()))
                .and_then(|()| tell(&Message::Progress(progress)));
        }
    };
    let compiled = one::compile(
        file,
        &target,
        Compiling { reading: &reading, options: &options },
        &mut progress,
    );
    failed?;
    if compiled.as_ref().is_err_and(|error| error.is::<one::Unwritten>()) {
        tell(&Message::Report(ChildReport { is_unwritten: true, ..ChildReport::default() }))?;
    }
    let (verdict, mut told) = compiled?;
    if to == ChildOutput::At {
        // They are in the report; a name that is no text cannot be told.
        told.included.clear();
        told.missing.clear();
    }
    tell(&Message::Report(told))?;
    Ok(verdict.into())
}

fn compile_one(
    command: &CompileCommand,
    file: &Path,
    matches: &ArgMatches,
    out: &mut dyn Write,
) -> Result<Exit> {
    let manner = command.progress.manner();
    let archive = command.output.clone().unwrap_or_else(|| file.with_extension("mapd"));
    if is_same_file(&archive, file) {
        let message =
            format!("{} would overwrite its source; name another file with -o", archive.display());
        bail!(UsageError(message));
    }
    let is_map = |report: &Path| is_same_file(report, file) || is_same_file(report, &archive);
    if command.report.as_deref().is_some_and(is_map) {
        let message = "the report would overwrite the map; name another file with --report";
        bail!(UsageError(message.to_owned()));
    }
    let target = Target { archive, report: command.report.clone(), is_there: false };
    let reading = command.options.reading(&command.judging)?;
    let options = command.options.validated()?;
    let meter = Meter::of_file(file, manner);
    let (exit, told) = match command.max_memory {
        None => {
            command.threads.start(None)?;
            let compiled = one::compile(
                file,
                &target,
                Compiling { reading: &reading, options: &options },
                &mut |p| meter.show(p),
            );
            meter.finish();
            let (verdict, told) = compiled?;
            (verdict.into(), told)
        }
        Some(_) => in_child(command, file, &target, &CompileArguments::of(matches), &meter)?,
    };
    if let Some(made) = told.archive.filter(|_| !command.progress.quiet) {
        writeln!(
            out,
            "{}: {}, {} roads, {} lanes, content {}",
            shown(&target.archive),
            rounded::bytes(made.bytes as f64),
            made.roads,
            made.lanes,
            made.content_hash
        )?;
    }
    Ok(exit)
}

/// Compiles one file in a child process: one that runs out of memory cannot report it itself.
fn in_child(
    command: &CompileCommand,
    file: &Path,
    target: &Target,
    options: &CompileArguments,
    meter: &Meter,
) -> Result<(Exit, ChildReport)> {
    let work = Work {
        source: file,
        output: Output::At { archive: &target.archive, report: target.report.as_deref() },
        options,
        memory: command.max_memory.map(|limit| limit.0),
        threads: command.threads.get(),
        has_input: true,
    };
    let mut said = |line: &str| meter.say(&format!("{line}\n"));
    let mut progress = |progress| meter.show(progress);
    let ended = child::run(&work, &mut said, &mut progress, &AtomicBool::new(false), None);
    meter.finish();
    let (end, told) = ended.context("the compiler")?;
    match end {
        End::Exit(exit) => return Ok((exit, told)),
        End::OutOfMemory { .. } | End::Broken(_) => draft::remove_left(&target.archive),
    }
    bail!("{}: {}", file.display(), end.reason(work.memory, "--max-memory"));
}

fn compile_many(
    command: &CompileCommand,
    matches: &ArgMatches,
    out: &mut dyn Write,
) -> Result<Exit> {
    for (is_said, option) in
        [(command.output.is_some(), "-o"), (command.report.is_some(), "--report")]
    {
        if is_said {
            let message = format!("{option} goes with a single file; see --output-dir");
            bail!(UsageError(message));
        }
    }
    if command.options.is_patched() {
        bail!(UsageError("--patch and --remove need a single map".to_owned()));
    }
    let manner = command.progress.manner();
    let reading = command.options.reading(&command.judging)?;
    let options = command.options.validated()?;
    let tiles = inputs::tiles(&command.inputs, command.output_dir.as_deref())?;
    let cores = std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let jobs = command.jobs.unwrap_or(cores);
    let jobs = jobs.min(NonZeroUsize::new(tiles.len()).unwrap_or(NonZeroUsize::MIN));
    let threads = command.threads.get();
    let plan = tiles::Plan {
        tiles: &tiles,
        arguments: &CompileArguments::of(matches),
        options: reading.hash(&options),
        force: command.force,
        jobs,
        // Together as many as there are cores.
        threads: threads.unwrap_or_else(|| {
            ThreadCount::at_most(NonZeroUsize::new(cores.get() / jobs).unwrap_or(NonZeroUsize::MIN))
        }),
        memory: command.max_memory.map(|size| size.0).or_else(child::default_memory),
    };
    let begun = Instant::now();
    let rows = tiles::run(&plan, manner)?;
    let exit = rows.iter().fold(Exit::Done, |exit, row| exit.worst(row.exit));
    if command.json {
        table::write_json(&rows, begun.elapsed(), out)?;
    } else if !command.progress.quiet {
        table::write(&rows, begun.elapsed(), out)?;
    }
    Ok(exit)
}
