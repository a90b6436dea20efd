//! Compiling in a separate process: a map that makes the compiler fail affects nothing else.
//!
//! The child is this program as `mapd compile` with hidden options. It says on its standard output, a line of JSON each, how
//! far it is and what it made; on its standard error what a user would see. It ends with its parent.

use crate::allocator::{NO_ADDRESS_SPACE_IS_LEFT, NO_MEMORY_IS_LEFT};
use crate::args::CompileArguments;
use crate::args::Size;
use crate::args::ThreadCount;
use crate::exit::Exit;
use crate::report::Counts;
use mapd_compiler::Progress;
use rustix::process::{Resource, Rlimit, Signal};
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Of the memory that is free, what compiling may take where nothing is said: three of four parts.
const SHARE: (u64, u64) = (3, 4);

/// Pauses between two looks at the child.
const PAUSES: (Duration, Duration) = (Duration::from_micros(500), Duration::from_millis(20));

/// What a process says, around the bytes, when memory cannot be had; then it ends.
const NO_MEMORY: (&str, &str) = ("memory allocation of ", " bytes failed");

/// What it says next, which is said better with the limit; the standard library's words where the program has not its own
/// allocator.
const NO_BACKTRACE: [&str; 4] = [
    NO_MEMORY_IS_LEFT,
    NO_ADDRESS_SPACE_IS_LEFT,
    "skipping backtrace printing to avoid potential recursion",
    "note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace",
];

/// What a child has made.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct ChildReport {
    /// Files that the document includes.
    pub(crate) included: Vec<PathBuf>,
    /// Files that it wants to include and that cannot be read.
    #[serde(default)]
    pub(crate) missing: Vec<PathBuf>,
    pub(crate) counts: Counts,
    /// Nothing for a rejected map.
    pub(crate) archive: Option<ArchiveFacts>,
    /// Whether the map is compiled, and the archive could not be written.
    #[serde(default)]
    pub(crate) is_unwritten: bool,
}

/// What an archive holds.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct ArchiveFacts {
    pub(crate) bytes: u64,
    pub(crate) roads: usize,
    pub(crate) lanes: usize,
    /// As hexadecimal digits.
    pub(crate) content_hash: String,
}

/// A line of a child's standard output.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Message {
    /// How far it is.
    Progress(#[serde(with = "ProgressOnTheWay")] Progress),
    /// Its last word.
    Report(ChildReport),
}

/// As [`Progress`].
#[derive(Serialize, Deserialize)]
#[serde(remote = "Progress", rename_all = "snake_case")]
enum ProgressOnTheWay {
    Reading { bytes: u64, roads: usize },
    Linking { roads: usize },
    Sampling { lanes: usize },
    Graph { nodes: usize },
    Indexing { bytes: usize },
}

/// Where a child writes to.
pub(crate) enum Output<'a> {
    /// Into an existing file that has no readers yet.
    Into(&'a OsStr),
    /// To a file that appears when it is whole; the report before it.
    At { archive: &'a Path, report: Option<&'a Path> },
}

/// What a child is to do.
pub(crate) struct Work<'a> {
    pub(crate) source: &'a Path,
    pub(crate) output: Output<'a>,
    pub(crate) options: &'a CompileArguments,
    /// Bytes that it may take for its own data.
    pub(crate) memory: Option<u64>,
    /// Threads [default: all cores].
    pub(crate) threads: Option<ThreadCount>,
    /// Whether it has this process's standard input, from which a map may come.
    pub(crate) has_input: bool,
}

/// How a child ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// As a command does.
    Exit(Exit),
    /// It needed more than it was allowed: this many bytes, for one allocation, as far as it could say so; of address space rather than of memory.
    OutOfMemory { asked: Option<u64>, is_address_space: bool },
    /// By a panic or a signal.
    Broken(ExitStatus),
}

/// Memory that compiling may take where nothing is said \[bytes\]; `None` if the system does not say what is free.
pub(crate) fn default_memory() -> Option<u64> {
    Some(crate::serve::available_memory()? / SHARE.1 * SHARE.0)
}

/// Runs a child to its end. `said` is given each line of its standard error, from another thread; `progress` how far it is.
///
/// Errors: it cannot be started; it takes longer than `deadline`; `cancelled`.
pub(crate) fn run(
    work: &Work<'_>,
    said: &mut (dyn FnMut(&str) + Send),
    progress: &mut (dyn FnMut(Progress) + Send),
    cancelled: &AtomicBool,
    deadline: Option<Duration>,
) -> io::Result<(End, ChildReport)> {
    let mut child = command(work).spawn()?;
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    let (mut no_memory, mut is_address_space) = (None, false);
    let (status, told) = std::thread::scope(|scope| {
        let named = |name: &str| std::thread::Builder::new().name(name.to_owned());
        let hear = move || {
            let mut told = ChildReport::default();
            for line in lines(stdout) {
                match serde_json::from_str(&line) {
                    Ok(Message::Progress(now)) => progress(now),
                    Ok(Message::Report(last)) => told = last,
                    // Of what is said when a process breaks down.
                    Err(_) => {}
                }
            }
            told
        };
        let relay = || {
            for line in lines(stderr) {
                is_address_space |= line == NO_ADDRESS_SPACE_IS_LEFT;
                match last_words(&line) {
                    None if NO_BACKTRACE.contains(&line.as_str()) => {}
                    Some(asked) => no_memory = Some(asked.or(no_memory.flatten())),
                    None => said(&line),
                }
            }
        };
        let threads = named("hear")
            .spawn_scoped(scope, hear)
            .and_then(|listening| Ok((listening, named("relay").spawn_scoped(scope, relay)?)));
        let (listening, relaying) = match threads {
            Ok(threads) => threads,
            Err(error) => {
                // The receiver is gone, so the work is no longer wanted.
                child.kill().and_then(|()| child.wait())?;
                return Err(error);
            }
        };
        let status = wait(&mut child, cancelled, deadline);
        // Panics of the callbacks are theirs.
        let told = listening.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        relaying.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        Ok((status, told))
    })?;
    let status = status?;
    let exit = status.code().and_then(|code| Exit::from_code(u8::try_from(code).ok()?));
    let end = match (exit, no_memory) {
        (Some(Exit::Environment) | None, Some(asked)) => {
            End::OutOfMemory { asked, is_address_space }
        }
        (Some(exit), _) => End::Exit(exit),
        (None, None) => End::Broken(status),
    };
    Ok((end, told))
}

fn lines(from: Option<impl Read>) -> impl Iterator<Item = String> {
    from.map(BufReader::new).into_iter().flat_map(BufRead::lines).map_while(io::Result::ok)
}

fn command(work: &Work<'_>) -> Command {
    // The program that runs, also after another one has taken its name.
    let mut command = Command::new("/proc/self/exe");
    command.arg("compile").arg("--quiet");
    match work.output {
        Output::Into(file) => command.arg("--child").arg("into").arg("-o").arg(file),
        Output::At { archive, report } => {
            command.arg("--child").arg("at").arg("-o").arg(archive);
            if let Some(report) = report {
                command.arg("--report").arg(report);
            }
            &mut command
        }
    };
    if let Some(memory) = work.memory {
        command.arg("--max-memory").arg(memory.to_string());
    }
    if let Some(threads) = work.threads {
        command.arg("--threads").arg(threads.get().to_string());
    }
    command.args(work.options.as_slice()).arg("--").arg(work.source);
    // Where memory has run out, printing a backtrace needs some, and waits for a lock that is held: without, it ends.
    command.env("RUST_BACKTRACE", "0").env_remove("RUST_LIB_BACKTRACE");
    command.stdin(if work.has_input { Stdio::inherit() } else { Stdio::null() });
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Waits for the child, and ends it if it is not wanted any more.
fn wait(
    child: &mut Child,
    cancelled: &AtomicBool,
    deadline: Option<Duration>,
) -> io::Result<ExitStatus> {
    let (mut pause, longest) = PAUSES;
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        let late = deadline.filter(|deadline| begun.elapsed() >= *deadline);
        if late.is_some() || cancelled.load(Ordering::Relaxed) {
            child.kill()?;
            child.wait()?;
            return Err(match late {
                Some(deadline) => {
                    io::Error::other(format!("takes longer than {} s", deadline.as_secs()))
                }
                None => io::Error::other("given up, for its parent ends"),
            });
        }
        std::thread::sleep(pause);
        pause = (pause * 2).min(longest);
    }
}

/// Whether a line is what a process without memory says: the bytes that it asked for. Several threads may say so at once, one
/// into the other: then it is one of their numbers, if one can be read.
fn last_words(line: &str) -> Option<Option<u64>> {
    let (start, end) = NO_MEMORY;
    let rest = line.replace(start, "").replace(end, "");
    if line.is_empty() || !rest.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let number = line.rsplit(start).next().and_then(|last| last.split(end).next());
    Some(number.and_then(|bytes| bytes.parse().ok()))
}

impl End {
    /// Why there is no archive. `limit`: bytes that it was allowed, by an option of this name.
    pub(crate) fn reason(&self, limit: Option<u64>, option: &str) -> String {
        match self {
            Self::OutOfMemory { asked, is_address_space } => {
                let of = if *is_address_space { Resource::As } else { Resource::Data };
                // The child has what this process may have, and of memory no more than the option allows.
                let own = rustix::process::getrlimit(of).current;
                let option = limit.filter(|_| of == Resource::Data).map(|limit| (limit, option));
                too_little(option, own.zip(name_of(of)), *asked)
            }
            Self::Broken(status) => {
                // The C library ends a process that has no address space for a thread by a signal.
                let address_space = rustix::process::getrlimit(Resource::As).current;
                match (address_space.zip(name_of(Resource::As)), limit) {
                    (Some((most, name)), _) => {
                        format!(
                            "the compiler ended with {status}; there are {} of {name}",
                            Size(most)
                        )
                    }
                    (None, Some(limit)) => format!(
                        "the compiler ended with {status}; it was allowed {} of memory ({option})",
                        Size(limit)
                    ),
                    (None, None) => format!("the compiler ended with {status}"),
                }
            }
            Self::Exit(exit) => format!("the compiler ended with {}", exit.code()),
        }
    }
}

/// By what name people know a limit of processes.
fn name_of(limit: Resource) -> Option<&'static str> {
    match limit {
        Resource::As => Some("address space that this process may have (`ulimit -v`)"),
        Resource::Data => Some("memory that this process may have (`ulimit -d`)"),
        _ => None,
    }
}

/// What is said of the smallest of these limits, each with its name.
fn too_little(option: Option<(u64, &str)>, own: Option<(u64, &str)>, asked: Option<u64>) -> String {
    let limit = match option.into_iter().chain(own).min_by_key(|(limit, _)| *limit) {
        Some((limit, name)) => format!("the {} of {name}", Size(limit)),
        None => "the memory that the system gives it".to_owned(),
    };
    let needed = match asked {
        Some(asked) => format!("; allocating another {} failed", Size(asked)),
        None => String::new(),
    };
    format!("compiling needs more than {limit}{needed}")
}

/// In the child: ends with the parent.
pub(crate) fn end_with_parent() {
    // Without it the child would end later, and its result would be discarded.
    let _ = rustix::process::set_parent_process_death_signal(Some(Signal::KILL));
}

/// In the child: takes at most so much memory for its own data \[bytes\].
///
/// Errors: the limit cannot be set.
pub(crate) fn limit_memory(limit: u64) -> io::Result<()> {
    // Private writable memory, of which the archive's pages are none: an allocation beyond it fails, which ends the
    // process and nothing else. What the process has set aside already, such as a sanitizer's tables, does not count.
    let limit = limit.saturating_add(own_data().unwrap_or(0));
    let allowed = rustix::process::getrlimit(Resource::Data).maximum;
    let limit = Some(allowed.map_or(limit, |allowed| allowed.min(limit)));
    rustix::process::setrlimit(Resource::Data, Rlimit { current: limit, maximum: limit })?;
    Ok(())
}

/// Private writable memory of this process now \[bytes\].
fn own_data() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let kilobytes = status.lines().find_map(|line| line.strip_prefix("VmData:"))?;
    kilobytes.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_failed_is_read_from_the_last_words() {
        let asked = |line: &str| last_words(line);
        assert_eq!(asked("memory allocation of 4096 bytes failed"), Some(Some(4096)));
        // Two threads at once.
        assert_eq!(
            asked("memory allocation of memory allocation of 41 bytes failed"),
            Some(Some(41))
        );
        assert_eq!(
            asked("memory allocation of 7memory allocation of 41 bytes failed"),
            Some(Some(41))
        );
        assert_eq!(asked("memory allocation of "), Some(None));
        assert_eq!(asked(" bytes failed"), Some(None));
        assert_eq!(asked("41"), Some(Some(41)));
        assert_eq!(asked(""), None);
        assert_eq!(asked("a.xodr:1:1: memory allocation of 4096 bytes failed"), None);
        let option = Some((64 << 20, "--max-memory"));
        let said = |own| too_little(option, own, Some(1 << 20));
        let needed = "; allocating another 1 MiB failed";
        let of_option = format!("compiling needs more than the 64 MiB of --max-memory{needed}");
        assert_eq!(said(None), of_option);
        assert_eq!(said(Some((1 << 30, "that"))), of_option);
        let of_system = said(Some((32 << 20, "that")));
        assert_eq!(of_system, format!("compiling needs more than the 32 MiB of that{needed}"));
    }
}
