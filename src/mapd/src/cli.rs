//! The command line: which commands there are, and how the process begins and ends.

use crate::args::{BuildArgs, CompileArguments, DomainArgs, JudgingArgs, Size, TrustArgs};
use crate::colour::Colours;
use crate::commands::bench::{self, BenchClientCommand, BenchCommand};
use crate::commands::change::{ChangeArgs, StagedChange};
use crate::commands::check::{self, CheckCommand};
use crate::commands::compile::{self, CompileCommand};
use crate::commands::doctor::DoctorCommand;
use crate::commands::export::ExportCommand;
use crate::commands::help::{self, HelpCommand};
use crate::commands::inspect::InspectCommand;
use crate::commands::overlay::OverlayCommand;
use crate::commands::query::{self, QueryCommand};
use crate::commands::shell::{CompletionsCommand, ManCommand};
use crate::commands::sign::SignCommand;
use crate::commands::status::StatusCommand;
use crate::commands::trace::{self, TraceCommand};
use crate::commands::view::{self, ViewCommand};
use crate::control::AskError;
use crate::daemon::{self, DaemonArgs};
use crate::exit::{Exit, UsageError, explained};
use crate::oversight::OversightArgs;
use crate::printable::{printable, printable_lines};
use crate::trust::is_distrust;
use anyhow::{Context, Result};
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use mapd_xodr::Severity;
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;
use std::sync::Arc;

/// Compile OpenDRIVE maps once and serve them to every process from shared memory.
///
/// `mapd --load map.xodr` compiles and checks the map, publishes it under the name `map` and serves until SIGINT or
/// SIGTERM. Other processes read it in place: with the crate mapd-client, or with `mapd query shm:map …`.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true, disable_help_subcommand = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(flatten, next_help_heading = "Serving")]
    daemon: DaemonArgs,

    #[command(flatten, next_help_heading = "Compiling")]
    options: BuildArgs,

    #[command(flatten, next_help_heading = "Findings")]
    judging: JudgingArgs,

    #[command(flatten, next_help_heading = "Trust")]
    trust: TrustArgs,

    #[command(flatten, next_help_heading = "Operating")]
    oversight: OversightArgs,

    #[command(flatten, next_help_heading = "Shared memory")]
    domain: DomainArgs,

    #[command(subcommand)]
    command: Option<Command>,
}

/// Name of the program, whatever its file is called.
const PROGRAM: &str = "mapd";

const EXIT_CODES: &str = "Exit codes: 0 done and accepted, 3 accepted with quarantined parts, 4 map rejected, 2 wrong usage, 1 the environment failed.";

#[derive(Subcommand)]
enum Command {
    /// Compile OpenDRIVE files into archives
    #[command(after_help = compile::HELP)]
    Compile(Box<CompileCommand>),
    /// List everything that is wrong with an OpenDRIVE file
    ///
    /// The map is not built.
    #[command(after_help = check::help())]
    Check(Box<CheckCommand>),
    /// Show the contents of a map
    Inspect(Box<InspectCommand>),
    /// Answer questions: CSV from stdin to stdout
    ///
    /// The first row of the CSV names its columns.
    #[command(after_help = query::HELP)]
    Query(Box<QueryCommand>),
    /// Find the lanes of a recorded trace: CSV from stdin to stdout
    ///
    /// The first row of the CSV names its columns.
    #[command(after_help = trace::HELP)]
    Match(Box<TraceCommand>),
    /// Draw or convert a map
    Export(Box<ExportCommand>),
    /// Show maps in a browser, and follow live ones
    #[command(after_help = view::HELP)]
    View(Box<ViewCommand>),
    /// List the served maps
    Status(StatusCommand),
    /// Measure attaching and querying on this machine
    ///
    /// Attaching is compared with open and mmap of the same bytes.
    Bench(BenchCommand),
    /// Examine this machine and the served maps
    ///
    /// Looks at memory, limits, stale files, versions, permissions and attaching.
    #[command(after_help = "Exit codes: 0 no problems, 1 problems.")]
    Doctor(DoctorCommand),
    /// Sign archives and entries of overlays with Ed25519, in minisign's format
    ///
    /// With --trust, daemon and clients refuse all other archives; with --overlay-trust, the daemon all other entries.
    Sign(SignCommand),
    #[command(name = bench::SUBCOMMAND, hide = true)]
    BenchClient(BenchClientCommand),
    /// Compile a map's file again and serve it
    ///
    /// If that fails, the served map stays.
    Reload(StagedChange),
    /// Serve the previous generation again, under a new number
    Rollback(StagedChange),
    /// Serve the staged generation
    Activate(ChangeArgs),
    /// Say what is so on the road today: closed, slower, slippery
    ///
    /// Also what is opened or out of service, and warnings (docs/overlay.md).
    Overlay(OverlayCommand),
    /// Write the script by which a shell completes commands
    Completions(CompletionsCommand),
    /// Write the man pages
    Man(ManCommand),
    /// Explain a command, or a topic such as units
    ///
    /// Topics: sources, units, exit-codes, environment, files.
    #[command(name = help::HELP)]
    Help(HelpCommand),
}

/// Columns of help where the terminal has more: longer lines are hard to read.
const MOST_COLUMNS: usize = 100;

/// The command line itself: commands, options and their help, to be looked at or completed.
pub fn command() -> clap::Command {
    let command = Cli::command().bin_name(PROGRAM).max_term_width(MOST_COLUMNS);
    help::completed(numbers_of_options(command))
}

/// Lets an option's own check refuse a negative number, which would be taken for an unknown option otherwise.
fn numbers_of_options(command: clap::Command) -> clap::Command {
    let own = |arg: clap::Arg| {
        let takes_values = arg.get_action().takes_values() && !arg.is_positional();
        arg.allow_negative_numbers(takes_values)
    };
    command.mut_args(own).mut_subcommands(numbers_of_options)
}

/// Runs the program with the process's arguments.
pub fn run() -> ExitCode {
    crate::allocator::give_back();
    survive_file_limits();
    let matches = match command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) if help::is_first_page(&error, command()) => {
            return first_page(Exit::Done).into();
        }
        Err(error) => return refused(&error).into(),
    };
    match execute(&matches) {
        Ok(exit) => exit.into(),
        // The reader of the output is gone, so the error cannot be reported.
        Err(error) if is_broken_pipe(&error) => Exit::Done.into(),
        Err(error) => {
            let mut err = io::stderr().lock();
            let mapd = Colours::of(&err).severity(Severity::Error, "mapd:").to_string();
            let _ = writeln!(err, "{mapd} {}", printable(&explained(&error)));
            exit_of(&error).into()
        }
    }
}

/// Says why a command line cannot be read, or the help that it asks for. Names of files stand in the error as they were given: where they would do
/// something to a terminal, they are shown instead.
fn refused(error: &clap::Error) -> Exit {
    let exit = if error.use_stderr() { Exit::Usage } else { Exit::Done };
    let given = std::env::args_os().map(|arg| arg.to_string_lossy().into_owned());
    let unseen: Vec<String> = given.filter(|arg| printable(arg) != arg.as_str()).collect();
    // A reader who has gone wants no more of it.
    let _ = match unseen.is_empty() {
        true => error.print(),
        false => {
            let text = error.render().ansi().to_string();
            let text = unseen.iter().fold(text, |text, arg| text.replace(arg, &printable(arg)));
            let text = anstream::adapter::strip_str(&text).to_string();
            io::stderr().lock().write_all(printable_lines(&text).as_bytes())
        }
    };
    exit
}

/// Shows the first page of help. A reader who has gone wants no more of it.
fn first_page(exit: Exit) -> Exit {
    let _ = help::with_first_page(command(), MOST_COLUMNS).print_help();
    exit
}

/// The exit code that an error ends the program with.
fn exit_of(error: &anyhow::Error) -> Exit {
    match error {
        error if error.is::<UsageError>() => Exit::Usage,
        error if is_distrust(error) => Exit::Rejected,
        _ => Exit::Environment,
    }
}

/// Has a write beyond the limit of file sizes (`ulimit -f`) fail with an error, as one to a full disk does; without a handler
/// SIGXFSZ ends the process.
fn survive_file_limits() {
    // Where it cannot be had, all is as it would be without.
    let _ = signal_hook::flag::register(libc::SIGXFSZ, Arc::default());
}

/// Address space that must be left at the start where it is limited \[bytes\]: with less, the C library ends a thread that it
/// cannot register by SIGABRT.
const LEAST_ROOM: usize = 16 << 20;

/// Looks for room to work in where the address space is limited (`ulimit -v`).
///
/// Errors: there is none.
fn check_room() -> Result<()> {
    if rustix::process::getrlimit(rustix::process::Resource::As).current.is_some() {
        let room = memmap2::MmapMut::map_anon(LEAST_ROOM);
        drop(room.with_context(|| {
            format!(
                "{} of address space are not left; raise the limit (`ulimit -v`)",
                Size(LEAST_ROOM as u64)
            )
        })?);
    }
    Ok(())
}

/// Whether the reader of our output has gone. A pipe to a daemon that breaks is another matter.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let mut causes = error.chain().take_while(|cause| !cause.is::<AskError>());
    causes.any(|cause| {
        let kind = if let Some(io) = cause.downcast_ref::<io::Error>() {
            Some(io.kind())
        } else if let Some(json) = cause.downcast_ref::<serde_json::Error>() {
            json.io_error_kind()
        } else {
            match cause.downcast_ref::<csv::Error>().map(csv::Error::kind) {
                Some(csv::ErrorKind::Io(io)) => Some(io.kind()),
                _ => None,
            }
        };
        kind == Some(io::ErrorKind::BrokenPipe)
    })
}

fn execute(matches: &ArgMatches) -> Result<Exit> {
    let cli = Cli::from_arg_matches(matches)?;
    check_room()?;
    let out = &mut BufWriter::new(io::stdout().lock());
    let Some(wanted) = cli.command else { return serve(&cli, matches) };
    let own = matches.subcommand().map_or(matches, |(_, own)| own);
    let exit = match wanted {
        Command::Compile(command) => compile::run(*command, own, out),
        Command::Check(command) => command.run(out),
        Command::Inspect(command) => command.run(out),
        Command::Query(command) => command.run(own, out),
        Command::Match(command) => command.run(out),
        Command::Export(command) => command.run(out),
        Command::View(command) => command.run(out),
        Command::Status(command) => command.run(out),
        Command::Bench(command) => command.run(out),
        Command::Doctor(command) => command.run(out),
        Command::Sign(command) => command.run(out),
        Command::BenchClient(command) => command.run(out),
        Command::Reload(change) => change.reload(out),
        Command::Rollback(change) => change.rollback(out),
        Command::Activate(change) => change.activate(out),
        Command::Overlay(command) => command.run(out),
        Command::Completions(completions) => completions.run(command(), out),
        Command::Man(man) => man.run(command()),
        Command::Help(help) => help.run(command(), out),
    }?;
    out.flush()?;
    Ok(exit)
}

/// What mapd does without a command: it is the daemon, or says how it is used.
fn serve(cli: &Cli, matches: &ArgMatches) -> Result<Exit> {
    if !cli.daemon.is_wanted() {
        return Ok(first_page(Exit::Usage));
    }
    let log = &cli.oversight.log;
    log.init();
    match served(cli, matches) {
        // A line of text among lines of JSON would stop who reads them.
        Err(error) if log.is_json() && !is_broken_pipe(&error) => {
            tracing::error!("{}", explained(&error));
            Ok(exit_of(&error))
        }
        other => other,
    }
}

/// Serves maps until it is stopped, with a log.
fn served(cli: &Cli, matches: &ArgMatches) -> Result<Exit> {
    let domain = cli.domain.named()?;
    let options = CompileArguments::of(matches);
    let settings = cli.daemon.settings(&options, domain)?;
    let key = cli.trust.clone().or(settings.trust.as_ref()).key()?;
    let oversight = cli.oversight.or(&settings.oversight);
    daemon::run(settings, key, &oversight)
}
