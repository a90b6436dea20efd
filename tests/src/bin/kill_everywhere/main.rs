//! Kills daemons and clients at each of their system calls, and at random, and proves after each kill that everybody else
//! goes on: `kill_everywhere [--short] [--random N] [--seed S]`. Needs Linux and strace.
//!
//! A victim runs once under strace, which lists its calls; then once for each call, with SIGKILL injected as the call is
//! entered. After each: the next client attaches within its deadline and answers rightly, the next daemon starts by
//! itself, what was held stays readable and right, and at the end nothing is left in shared memory.
//!
//! Three victims: a client (attach, query, detach) while a daemon serves; a daemon (start, publish, stop) alone; a daemon
//! while a client holds the generation before. `--short` takes every [`SHORT_STEP`]th call.

mod client;
mod daemon;
mod holder;
mod random;
mod trace;

use mapd_tests::say;
use std::path::PathBuf;
use std::process::ExitCode;

/// With `--short`, one of so many calls; a prime, so that no pattern of calls is left out.
const SHORT_STEP: usize = 13;
/// Random kills where `--random` says nothing else.
const RANDOM_KILLS: usize = 300;
/// The same with `--short`.
const SHORT_RANDOM_KILLS: usize = 30;

/// What a run is to do.
struct Plan {
    /// One of so many calls.
    step: usize,
    random: usize,
    seed: u64,
}

/// A victim's whole treatment.
type Run = fn(&Plan) -> Result<Tally, Box<dyn std::error::Error>>;

/// What a victim went through.
#[derive(Default)]
struct Tally {
    kills: usize,
    /// One line for each kill after which something was wrong.
    bad: Vec<String>,
    /// Longest time until a fresh client had its answer \[ms\].
    worst_ms: u128,
}

impl Tally {
    fn print(&self, victim: &str) {
        say(&format!(
            "{victim}: {} kills, {} bad, slowest answer after a kill {} ms",
            self.kills,
            self.bad.len(),
            self.worst_ms
        ));
        self.bad.iter().for_each(|line| say(&format!("  BAD {line}")));
    }
}

/// A program that lies beside this one.
fn beside(name: &str) -> PathBuf {
    let own = std::env::current_exe().unwrap_or_default();
    own.with_file_name(name)
}

fn plan() -> Result<Plan, String> {
    let mut plan = Plan { step: 1, random: RANDOM_KILLS, seed: u64::from(std::process::id()) };
    let mut args = std::env::args().skip(1);
    while let Some(flag) = args.next() {
        let mut number = || {
            let text = args.next().ok_or(format!("{flag} needs a number"))?;
            text.parse::<u64>().map_err(|error| format!("{flag}: {error}"))
        };
        match flag.as_str() {
            "--short" => (plan.step, plan.random) = (SHORT_STEP, SHORT_RANDOM_KILLS),
            "--random" => plan.random = number()? as usize,
            "--seed" => plan.seed = number()?,
            _ => {
                return Err(format!(
                    "unknown {flag}; usage: kill_everywhere [--short] [--random N] [--seed S]"
                ));
            }
        }
    }
    Ok(plan)
}

fn main() -> ExitCode {
    let plan = match plan() {
        Ok(plan) => plan,
        Err(error) => {
            say(&error);
            return ExitCode::from(2);
        }
    };
    if !trace::is_possible() {
        say(
            "strace cannot be run here; install it (Debian: apt-get install strace) and allow ptrace",
        );
        return ExitCode::from(1);
    }
    let runs: [(&str, Run); 4] = [
        ("client", client::kill_everywhere),
        ("daemon alone", daemon::kill_everywhere_alone),
        ("daemon beside a client that holds", daemon::kill_everywhere_held),
        ("both sides at random", random::kill),
    ];
    let mut bad = 0;
    for (victim, run) in runs {
        match run(&plan) {
            Ok(tally) => {
                tally.print(victim);
                bad += tally.bad.len();
            }
            Err(error) => {
                say(&format!("{victim}: {error}"));
                bad += 1;
            }
        }
    }
    if bad == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
