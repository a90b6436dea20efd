//! One fresh process that attaches, asks once, and ends: what `mapd bench` starts many of.

use super::figures::keep;
use crate::args::DomainArgs;
use crate::exit::Exit;
use crate::faults::minor_faults;
use anyhow::{Context, Result, ensure};
use clap::{Args, ValueEnum};
use mapd_client::compiling::ByRow as _;
use mapd_client::{Attach, Client, Domain, NearestOptions, Snapshot};
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Longest wait for the map: long enough for a machine on which hundreds of clients start at once.
const WAIT: Duration = Duration::from_secs(60);

/// Name of the hidden subcommand.
pub(crate) const SUBCOMMAND: &str = "bench-client";

/// Where a process finds the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum From {
    /// In shared memory, by name, as an observer
    Shm,
    /// In shared memory, by name, as a subscriber
    Subscriber,
    /// In a file
    File,
}

/// A client of a benchmark. Not for users: its output may change.
#[derive(Args)]
pub(crate) struct BenchClientCommand {
    #[arg(value_enum)]
    from: From,
    what: String,
    #[command(flatten)]
    domain: DomainArgs,
}

impl BenchClientCommand {
    /// Attaches, asks, and writes what it took.
    ///
    /// Errors: as [`answer`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        answer(&self, &self.domain.domain()?, out)?;
        Ok(Exit::Done)
    }
}

/// What one process took.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Taken {
    /// From before the process was made until its first answer was known here.
    pub(crate) exec: Duration,
    /// Its call that attaches, or opens the file.
    pub(crate) attach: Duration,
    /// Its first query.
    pub(crate) first_query: Duration,
    /// Minor page faults of that query.
    pub(crate) faults: u64,
}

/// Attaches, asks where the first point of the middle lane lies, and writes `!` as soon as the answer is there; then what
/// it took.
///
/// Errors: no such map; stdout is closed.
fn answer(args: &BenchClientCommand, domain: &Domain, out: &mut dyn Write) -> Result<()> {
    let start = Instant::now();
    let (_client, snapshot) = match args.from {
        From::Shm | From::Subscriber => {
            let attach = match args.from {
                From::Subscriber => Attach::Subscriber,
                _ => Attach::Observer,
            };
            let client = Client::connect_as(attach, domain, &args.what, WAIT)?;
            let snapshot = client.snapshot();
            (Some(client), snapshot)
        }
        From::File => (None, Snapshot::open(&args.what)?),
    };
    let attach = start.elapsed();
    let map = snapshot.map();
    let faults = minor_faults();
    let start = Instant::now();
    let middle = u32::try_from(map.tables().lanes.len() / 2)?;
    if let Some(point) =
        map.lane_by_row(middle).and_then(|lane| lane.center_line().positions().next())
    {
        keep(map.nearest_lane(point.truncate(), &NearestOptions::default())?);
    }
    let first_query = start.elapsed();
    out.write_all(b"!")?;
    out.flush()?;
    let faults = minor_faults().saturating_sub(faults);
    writeln!(out, "{} {} {faults}", attach.as_nanos(), first_query.as_nanos())?;
    Ok(())
}

/// Starts such a process and waits for its end.
///
/// Errors: it cannot be started; it fails.
pub(crate) fn start(domain: &Domain, from: From, what: &str) -> Result<Taken> {
    let program = std::env::current_exe().context("finding this program")?;
    let from = match from {
        From::Shm => "shm",
        From::Subscriber => "subscriber",
        From::File => "file",
    };
    let start = Instant::now();
    let mut child = Command::new(program)
        .args([SUBCOMMAND, "--prefix", domain.prefix()])
        .args(["--owner", &domain.owner().to_string(), from, what])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("starting a client")?;
    let mut text = String::new();
    let mut exec = None;
    if let Some(out) = &mut child.stdout
        && out.read_exact(&mut [0]).is_ok()
    {
        exec = Some(start.elapsed());
        out.read_to_string(&mut text).context("reading from a client")?;
    }
    let ended = child.wait_with_output().context("waiting for a client")?;
    let said = String::from_utf8_lossy(&ended.stderr);
    ensure!(ended.status.success(), "a client ended with {}: {}", ended.status, said.trim());
    let mut numbers = text.split_whitespace().map_while(|word| word.parse::<u64>().ok());
    let mut next = || numbers.next().context("a client said nothing");
    Ok(Taken {
        exec: exec.context("a client said nothing")?,
        attach: Duration::from_nanos(next()?),
        first_query: Duration::from_nanos(next()?),
        faults: next()?,
    })
}
