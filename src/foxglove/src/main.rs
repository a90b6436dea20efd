//! `mapd-foxglove`: a map as an MCAP file.

mod lanes;
mod marks;
mod recording;
mod scene;
mod signals;

use anyhow::{Context, Result, bail};
use clap::Parser;
use foxglove::messages::Timestamp;
use mapd::draft;
use mapd::source::{self, Attaching, Compiling, Opened, WAIT};
use mapd_client::{Attach, Domain, Snapshot};
use mapd_compiler::{CompileOptions, ReadOptions};
use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;

/// Writes a map as an MCAP file for Foxglove
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// .xodr, .mapd or shm:NAME
    source: String,
    /// File to write
    #[arg(short, long, value_name = "OUT.mcap")]
    output: PathBuf,
    /// Time of all messages: seconds since 1970, such as the start of the recording that the map belongs to [default: now]
    #[arg(long, value_name = "S")]
    time: Option<f64>,
}

fn main() -> Result<()> {
    let Arguments { source, output, time } = Arguments::parse();
    let time = time.map_or_else(|| Ok(Timestamp::now()), given)?;
    let map = open(&source)?;
    source::say_without_overlay(&map, "mapd-foxglove");
    let recording = recording::of(map.map(), time)?;
    if !recording.has_place {
        // A closed stderr is nobody's loss.
        let _ = writeln!(
            std::io::stderr(),
            "mapd-foxglove: the map has no georeference: there is no /map/location"
        );
    }
    draft::write_by(&output, |out| Ok(out.write_all(&recording.bytes)?))
}

/// A time that is given \[s\].
///
/// Errors: before 1970, or later than the 32 bits of Foxglove's messages reach, in 2106.
fn given(time: f64) -> Result<Timestamp> {
    let time = Duration::try_from_secs_f64(time).context("--time")?;
    let seconds = time.as_secs().try_into();
    let seconds = seconds.context("--time: Foxglove's messages end in 2106")?;
    Ok(Timestamp::new(seconds, time.subsec_nanos()))
}

/// Opens a SOURCE as `mapd export` does without options.
///
/// Errors: it cannot be read; the map is rejected.
fn open(source: &str) -> Result<Snapshot> {
    let compiling =
        Compiling { reading: &ReadOptions::default(), options: &CompileOptions::default() };
    let domain = Domain::from_env()?;
    let live = Attaching { domain: &domain, attach: Attach::Observer, wait: WAIT };
    match source::open(source, compiling, live, &mut |_| {})? {
        Opened::Map(map, _) => Ok(map),
        Opened::Rejected(_) => bail!("{source} is rejected: `mapd check {source}` says why"),
    }
}
