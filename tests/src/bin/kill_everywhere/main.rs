//! Kills daemon and clients at every system call of theirs, and at random moments, and proves each time that nothing is
//! wedged, wrong or left behind. See `docs/transport.md`.

mod changes;
mod check;
mod client;
mod daemon;
mod overlays;
mod random;
mod report;
mod watchdog;

use clap::{Parser, ValueEnum};
use mapd_client::Attach;
use mapd_tests::say;
use mapd_tests::stage::{Checked, Stage};
use report::{Choice, Report};
use std::path::PathBuf;
use std::process::ExitCode;

/// Moments of each victim in the short form.
const SHORT: usize = 60;

/// Random kills of the full form, of both sides together.
const RANDOM_KILLS: u32 = 300;

/// The same in the short form.
const SHORT_RANDOM_KILLS: u32 = 40;

/// Seed of the short form: it is always the same.
const SHORT_SEED: u64 = 1;

/// A point of the map `one_road`, and one far away from it.
const QUESTION: &str = "x,y\n10,-1.5\n5000,5000\n";

/// Kill mapd's daemon and clients at every system call, and at random, and check what is left.
#[derive(Parser)]
struct Options {
    /// The program to kill [default: `mapd` beside this program]
    #[arg(long)]
    mapd: Option<PathBuf>,
    /// Whom to kill [default: all, one after the other]
    #[arg(long, value_enum)]
    victim: Vec<Victim>,
    /// About a minute: of each victim's moments only some, evenly spread, always the same
    #[arg(long)]
    short: bool,
    /// Only at system calls of this name, such as `bind`
    #[arg(long)]
    call: Vec<String>,
    /// Of each victim's moments at most so many, evenly spread [default: all]
    #[arg(long)]
    moments: Option<usize>,
    /// Kills of the victim `random`
    #[arg(long)]
    kills: Option<u32>,
    /// Seed of the random kills [default: the clock, in the short form always the same]
    #[arg(long)]
    seed: Option<u64>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Victim {
    /// A subscriber that attaches, asks and detaches, while a daemon serves and other clients hold snapshots
    Client,
    /// The same of an observer
    Observer,
    /// A daemon that starts, publishes and stops, alone
    Daemon,
    /// The same, while a client holds a snapshot of the daemon before
    DaemonWithClient,
    /// A daemon that reloads, rolls back, stages and activates, beside a client that follows
    Changes,
    /// The client that asks a daemon to do so
    Asker,
    /// A daemon that lays overlays over what it serves
    Overlays,
    /// Daemons and clients, at random moments
    Random,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            say(&format!("kill_everywhere: {error}"));
            ExitCode::FAILURE
        }
    }
}

/// Whether every check held.
fn run(options: &Options) -> Checked<bool> {
    let mapd = match &options.mapd {
        Some(mapd) => mapd.clone(),
        None => std::env::current_exe().map_err(|error| error.to_string())?.with_file_name("mapd"),
    };
    if !mapd.exists() {
        return Err(format!("{} is missing: cargo build -p mapd", mapd.display()));
    }
    watchdog::start();
    let all = Victim::value_variants();
    let victims = if options.victim.is_empty() { all } else { options.victim.as_slice() };
    let most = options.moments.unwrap_or(if options.short { SHORT } else { usize::MAX });
    let choice = Choice { most, calls: &options.call };
    let mut good = true;
    for victim in victims {
        let stage = Stage::new(&mapd, &mapd_tests::carried("one_road.xodr"), QUESTION)?;
        let report: Report = match victim {
            Victim::Client => client::run(&stage, Attach::Subscriber, choice)?,
            Victim::Observer => client::run(&stage, Attach::Observer, choice)?,
            Victim::Daemon => daemon::run(&stage, false, choice)?,
            Victim::DaemonWithClient => daemon::run(&stage, true, choice)?,
            Victim::Changes => changes::daemon(&mapd, choice)?,
            Victim::Asker => changes::asker(&mapd, choice)?,
            Victim::Overlays => overlays::daemon(&mapd, choice)?,
            Victim::Random => {
                let short = if options.short { SHORT_RANDOM_KILLS } else { RANDOM_KILLS };
                let kills = options.kills.unwrap_or(short);
                let usual = || if options.short { SHORT_SEED } else { random::seed_of_clock() };
                random::run(&stage, kills, options.seed.unwrap_or_else(usual))?
            }
        };
        say(&report.to_string());
        good &= report.is_good();
    }
    Ok(good)
}
