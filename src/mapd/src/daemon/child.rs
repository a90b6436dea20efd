//! A daemon's compiler: what becomes of a map that ends its child.

use super::log::relay;
use super::settings::MapSettings;
use crate::args::ThreadCount;
use crate::child::{self, ChildReport, End, Output, Work};
use crate::exit::Exit;
use std::collections::VecDeque;
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// Longest time that compiling may take: a map of 500 MB takes half a minute.
const DEADLINE: Duration = Duration::from_secs(1800);

/// The option that says how much memory it may take.
const LIMIT: &str = "--compile-memory";

/// Lines of its messages that are kept for the reason.
const LINES: usize = 64;

/// Why there is no archive.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// The map is rejected.
    Rejected(String),
    /// The map is rejected, and other files than its own may mend it.
    RejectedWith(String, OtherFiles),
    /// The map is compiled, and its archive found no place.
    Unwritten(String),
    /// Something else failed.
    Failed(String),
}

/// Files that a document includes.
#[derive(Clone, Debug)]
pub(crate) struct OtherFiles {
    /// Those that were read.
    pub(crate) included: Vec<PathBuf>,
    /// Those that could not be.
    pub(crate) missing: Vec<PathBuf>,
}

impl Refusal {
    pub(crate) fn reason(&self) -> &str {
        let (Self::Rejected(reason)
        | Self::RejectedWith(reason, _)
        | Self::Unwritten(reason)
        | Self::Failed(reason)) = self;
        reason
    }

    /// Files besides the map's own that may mend it.
    pub(crate) fn other_files(&self) -> Option<&OtherFiles> {
        match self {
            Self::RejectedWith(_, files) => Some(files),
            Self::Rejected(_) | Self::Unwritten(_) | Self::Failed(_) => None,
        }
    }

    pub(crate) fn exit(&self) -> Exit {
        match self {
            Self::Rejected(_) | Self::RejectedWith(..) => Exit::Rejected,
            Self::Unwritten(_) | Self::Failed(_) => Exit::Environment,
        }
    }
}

/// What a compiler may take.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Means {
    /// Memory \[bytes\]; a share of what is free where nothing is said.
    pub(crate) memory: Option<u64>,
    /// Threads; as many as there are cores where nothing is said.
    pub(crate) threads: Option<ThreadCount>,
}

/// Compiles a map into `output`, which is there already. The child's messages go where the daemon's go.
///
/// Errors: the map is rejected; the child cannot be started, dies, needs too much memory, or takes too long; `cancelled`.
pub(crate) fn compile(
    map: &MapSettings,
    output: &OsStr,
    means: Means,
    cancelled: &AtomicBool,
) -> Result<ChildReport, Refusal> {
    let memory = means.memory.or_else(child::default_memory);
    let work = Work {
        source: &map.source,
        output: Output::Into(output),
        options: &map.options,
        memory,
        threads: means.threads,
        has_input: false,
    };
    let mut said = VecDeque::new();
    let mut hear = |line: &str| {
        relay(line);
        if said.len() == LINES {
            // The first line stays: it names the first error.
            said.remove(1);
        }
        said.push_back(line.to_owned());
    };
    let ended = child::run(&work, &mut hear, &mut |_| {}, cancelled, Some(DEADLINE));
    let (end, told) = ended.map_err(|error| Refusal::Failed(format!("the compiler: {error}")))?;
    match end {
        End::Exit(Exit::Done | Exit::Quarantined) => Ok(told),
        End::Exit(Exit::Rejected) => {
            let files = OtherFiles { included: told.included, missing: told.missing };
            Err(Refusal::RejectedWith(reason(&said), files))
        }
        End::Exit(Exit::Environment) if told.is_unwritten => Err(Refusal::Unwritten(reason(&said))),
        End::Exit(Exit::Environment | Exit::Usage) => Err(Refusal::Failed(reason(&said))),
        End::OutOfMemory { .. } => Err(Refusal::Failed(end.reason(memory, LIMIT))),
        End::Broken(_) => {
            let last = said.back().map(|line| format!(": {line}")).unwrap_or_default();
            Err(Refusal::Failed(end.reason(memory, LIMIT) + &last))
        }
    }
}

/// The first error, and the verdict. Who says it is said by whoever passes it on.
fn reason(said: &VecDeque<String>) -> String {
    let text = first_and_last(said);
    text.strip_prefix("mapd: ").map(str::to_owned).unwrap_or(text)
}

fn first_and_last(said: &VecDeque<String>) -> String {
    let first = said.iter().find(|line| line.contains(": error[")).or(said.front());
    let last = said.iter().rev().find(|line| !line.starts_with(' ') && !line.is_empty());
    match (first, last) {
        (Some(first), Some(last)) if first != last => format!("{last}; first: {first}"),
        (_, Some(line)) | (Some(line), _) => line.clone(),
        (None, None) => "the compiler failed without a word".to_owned(),
    }
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
    tracing::error!(map, error = refusal.reason(), "map {map}: {}", refusal.reason());
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
        assert_eq!(reason(&said(&["mapd: opening m: not found"])), "opening m: not found");
        assert!(!reason(&said(&[])).is_empty());
    }
}
