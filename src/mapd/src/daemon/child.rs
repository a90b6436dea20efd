//! Compiling in a process of its own: whatever a map does to its compiler, the maps that are served do not notice.

use super::log::{relay, say};
use super::settings::MapSettings;
use crate::exit::Exit;
use crate::serve::available_memory;
use rustix::process::{Resource, Rlimit, Signal};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::ffi::OsStr;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Of the memory that is free, what compiling may take where nothing is said: three of four parts.
const SHARE: (u64, u64) = (3, 4);

/// Longest time that compiling may take: a map of 500 MB takes half a minute.
const DEADLINE: Duration = Duration::from_secs(1800);

/// Pauses between two looks at the child.
const PAUSES: (Duration, Duration) = (Duration::from_micros(500), Duration::from_millis(20));

/// Lines of its messages that are kept for the reason.
const LINES: usize = 64;

/// What a child says on its standard output.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Told {
    /// Files that the document includes.
    pub(crate) included: Vec<PathBuf>,
}

/// Why there is no archive.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// The map is rejected.
    Rejected(String),
    /// Something else failed.
    Failed(String),
}

impl Refusal {
    pub(crate) fn reason(&self) -> &str {
        let (Self::Rejected(reason) | Self::Failed(reason)) = self;
        reason
    }

    pub(crate) fn exit(&self) -> Exit {
        match self {
            Self::Rejected(_) => Exit::Rejected,
            Self::Failed(_) => Exit::Environment,
        }
    }
}

/// Compiles a map into `output`, which is there already. With `tell`, the child's messages go where the daemon's go.
///
/// Errors: the map is rejected; the child cannot be started, dies, needs too much memory, or takes too long; `cancelled`.
pub(crate) fn compile(
    map: &MapSettings,
    output: &OsStr,
    memory: Option<u64>,
    cancelled: &AtomicBool,
) -> Result<Told, Refusal> {
    let failed = |what: &str, error: io::Error| Refusal::Failed(format!("{what}: {error}"));
    // The program that runs, also after another one has taken its name.
    let mut command = Command::new("/proc/self/exe");
    command.arg("compile").arg(&map.source).arg("-o").arg(output).arg("--for-daemon");
    let ceiling = memory.or_else(|| Some(available_memory()? / SHARE.1 * SHARE.0));
    if let Some(ceiling) = ceiling {
        command.arg("--memory-limit").arg(ceiling.to_string());
    }
    command.args(map.options.as_slice());
    // Where memory has run out, printing a backtrace needs some, and waits for a lock that is held: without, it ends.
    command.env("RUST_BACKTRACE", "0").env_remove("RUST_LIB_BACKTRACE");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| failed("starting the compiler", error))?;
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    let ended = std::thread::scope(|scope| {
        let told = scope.spawn(move || {
            let mut text = String::new();
            stdout.map(|mut stdout| stdout.read_to_string(&mut text));
            text
        });
        let said = scope.spawn(move || {
            let mut lines = VecDeque::new();
            let stderr = stderr.map(BufReader::new).into_iter().flat_map(BufRead::lines);
            for line in stderr.map_while(io::Result::ok) {
                relay(&line);
                if lines.len() == LINES {
                    // The first line stays: it names the first error.
                    lines.remove(1);
                }
                lines.push_back(line);
            }
            lines
        });
        let status = wait(&mut child, cancelled);
        (status, told.join().unwrap_or_default(), said.join().unwrap_or_default())
    });
    let (status, told, said) = ended;
    let status = status.map_err(|error| failed("the compiler", error))?;
    match status.code().and_then(|code| u8::try_from(code).ok()) {
        Some(code) if code == Exit::Done.code() || code == Exit::Quarantined.code() => {
            serde_json::from_str(&told)
                .map_err(|error| failed("the compiler's answer", error.into()))
        }
        Some(code) if code == Exit::Rejected.code() => Err(Refusal::Rejected(reason(&said))),
        Some(code) if code == Exit::Environment.code() || code == Exit::Usage.code() => {
            Err(Refusal::Failed(reason(&said)))
        }
        // A panic, or a signal.
        _ => Err(Refusal::Failed(broken(status, ceiling, &said))),
    }
}

/// Waits for the child, and ends it if it is not wanted any more.
fn wait(child: &mut Child, cancelled: &AtomicBool) -> io::Result<ExitStatus> {
    let (mut pause, longest) = PAUSES;
    let until = Instant::now() + DEADLINE;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        let late = Instant::now() >= until;
        if late || cancelled.load(Ordering::Relaxed) {
            child.kill()?;
            child.wait()?;
            return Err(match late {
                true => io::Error::other(format!("takes longer than {} s", DEADLINE.as_secs())),
                false => io::Error::other("given up, for the daemon ends"),
            });
        }
        std::thread::sleep(pause);
        pause = (pause * 2).min(longest);
    }
}

/// The first error, and the verdict.
fn reason(said: &VecDeque<String>) -> String {
    let first = said.iter().find(|line| line.contains(": error[")).or(said.front());
    let last = said.iter().rev().find(|line| !line.starts_with(' ') && !line.is_empty());
    match (first, last) {
        (Some(first), Some(last)) if first != last => format!("{last}; first: {first}"),
        (_, Some(line)) | (Some(line), _) => line.clone(),
        (None, None) => "the compiler failed without a word".to_owned(),
    }
}

fn broken(status: ExitStatus, ceiling: Option<u64>, said: &VecDeque<String>) -> String {
    let limit = match ceiling {
        Some(ceiling) => format!("; it was allowed {ceiling} bytes of memory (--compile-memory)"),
        None => String::new(),
    };
    let last = said.back().map(|line| format!(": {line}")).unwrap_or_default();
    format!("the compiler ended with {status}{limit}{last}")
}

/// In the child: ends with the parent, and takes at most so much memory for its own data.
///
/// Errors: the limit cannot be set.
pub(crate) fn enter(parent_watches: bool, memory: Option<u64>) -> io::Result<()> {
    if parent_watches {
        // Without it the child would end a while later, for nobody.
        let _ = rustix::process::set_parent_process_death_signal(Some(Signal::KILL));
    }
    if let Some(limit) = memory {
        // Private writable memory, of which the archive's pages are none: an allocation beyond it fails, which ends the
        // process and nothing else. What the process has set aside already, such as a sanitizer's tables, does not count.
        let limit = limit.saturating_add(own_data().unwrap_or(0));
        let allowed = rustix::process::getrlimit(Resource::Data).maximum;
        let limit = Some(allowed.map_or(limit, |allowed| allowed.min(limit)));
        rustix::process::setrlimit(Resource::Data, Rlimit { current: limit, maximum: limit })?;
    }
    Ok(())
}

/// Private writable memory of this process now \[bytes\].
fn own_data() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let kilobytes = status.lines().find_map(|line| line.strip_prefix("VmData:"))?;
    kilobytes.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

/// A file without a name, for a child to write into, and the name by which the child finds it.
///
/// Errors: what the system says.
pub(crate) fn nameless() -> io::Result<(std::fs::File, PathBuf)> {
    use std::os::fd::AsRawFd;
    let file = rustix::fs::memfd_create("mapd-archive", rustix::fs::MemfdFlags::CLOEXEC)?;
    let path = format!("/proc/{}/fd/{}", std::process::id(), file.as_raw_fd());
    Ok((file.into(), Path::new(&path).to_owned()))
}

/// Says why a map is not compiled.
pub(crate) fn tell(map: &str, refusal: &Refusal) {
    say(&format!("map {map}: {}", refusal.reason()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_names_the_first_error_and_the_verdict() {
        let said = |lines: &[&str]| lines.iter().map(|line| (*line).to_owned()).collect();
        let lines = [
            "m.xodr:3:1: warning[x]: w",
            "m.xodr:4:1: error[y]: bad",
            "    at /",
            "m.xodr: rejected, 1 errors",
        ];
        assert_eq!(
            reason(&said(&lines)),
            "m.xodr: rejected, 1 errors; first: m.xodr:4:1: error[y]: bad"
        );
        assert_eq!(reason(&said(&["mapd: opening m: not found"])), "mapd: opening m: not found");
        assert!(!reason(&said(&[])).is_empty());
    }
}
