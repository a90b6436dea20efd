//! strace: which calls a command makes, and running it with a kill at one of them.

use std::collections::BTreeMap;
use std::process::{Child, Command, Stdio};

/// One system call of a victim: the `number`th of its name, from 1, as strace counts for each thread.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    pub(crate) name: String,
    pub(crate) number: usize,
}

/// Whether strace is there and may trace.
pub(crate) fn is_possible() -> bool {
    let run =
        Command::new("strace").args(["-o", "/dev/null", "true"]).stderr(Stdio::null()).status();
    run.is_ok_and(|status| status.success())
}

/// The calls in a log of `strace -f -o`, in the order in which they were first reached: for each thread, every call.
pub(crate) fn calls(log: &str) -> Vec<Call> {
    let mut seen: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut known: BTreeMap<&str, usize> = BTreeMap::new();
    let mut calls = Vec::new();
    for line in log.lines() {
        let Some((thread, rest)) = line.split_once(' ') else { continue };
        let rest = rest.trim_start();
        let Some((name, _)) = rest.split_once('(') else { continue };
        // Signals, exits and the second halves of interrupted calls have no name before the bracket.
        if name.is_empty() || !name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
            continue;
        }
        let number = seen.entry((thread, name)).or_default();
        *number += 1;
        // An injection hits whichever thread comes to that number first: each number of a name once.
        let most = known.entry(name).or_default();
        if *number > *most {
            *most = *number;
            calls.push(Call { name: name.to_owned(), number: *number });
        }
    }
    calls
}

/// Puts `strace` before a command: logging all calls to a file.
pub(crate) fn logging(command: &Command, log: &std::path::Path) -> Command {
    let mut traced = Command::new("strace");
    traced.args(["-f", "-o"]).arg(log);
    with_command(traced, command)
}

/// Puts `strace` before a command: killing it as it enters a call.
pub(crate) fn killing(command: &Command, call: &Call) -> Command {
    let mut traced = Command::new("strace");
    traced.args(["-f", "-o", "/dev/null", "-e", &format!("trace={}", call.name), "-e"]);
    traced.arg(format!("inject={}:signal=KILL:when={}", call.name, call.number));
    with_command(traced, command)
}

fn with_command(mut traced: Command, command: &Command) -> Command {
    traced.arg(command.get_program()).args(command.get_args());
    for (key, value) in command.get_envs() {
        match value {
            Some(value) => traced.env(key, value),
            None => traced.env_remove(key),
        };
    }
    traced.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    traced
}

/// The process that a running strace traces, while there is one.
pub(crate) fn tracee(strace: &Child) -> Option<u32> {
    let id = strace.id();
    let children = std::fs::read_to_string(format!("/proc/{id}/task/{id}/children")).ok()?;
    children.split_ascii_whitespace().next()?.parse().ok()
}
