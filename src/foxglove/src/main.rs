//! `mapd-foxglove`: a map as an MCAP file.

mod lanes;
mod marks;
mod recording;
mod scene;
mod signals;

use anyhow::{Context, Result};
use clap::Parser;
use foxglove::messages::Timestamp;
use mapd::draft;
use mapd::exit::{Exit, explained};
use mapd::progress::{Manner, Meter};
use mapd::source::{self, Attaching, Compiling, Opened, Source, WAIT};
use mapd_client::{Attach, Domain, Snapshot};
use mapd_compiler::{CompileOptions, ReadOptions};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// Writes a map as an MCAP file for Foxglove
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// .xodr, .mapd or shm:NAME
    source: OsString,
    /// File to write
    #[arg(short, long, value_name = "OUT.mcap")]
    output: PathBuf,
    /// Time of all messages: seconds since 1970, such as the start of the recording that the map belongs to [default: now]
    #[arg(long, value_name = "S", value_parser = given)]
    time: Option<Timestamp>,
    /// Print only errors
    #[arg(short, long)]
    quiet: bool,
}

/// Time between two lines of progress where stderr is no terminal.
const INTERVAL: Duration = Duration::from_secs(5);

fn main() -> ExitCode {
    let exit = run(Arguments::parse()).unwrap_or_else(|error| {
        // A closed stderr is nobody's loss.
        let _ = writeln!(std::io::stderr(), "mapd-foxglove: {}", explained(&error));
        Exit::Environment
    });
    exit.into()
}

/// Writes the file.
///
/// Errors: the source cannot be read; the file cannot be encoded or written.
fn run(arguments: Arguments) -> Result<Exit> {
    let Arguments { source, output, time, quiet } = arguments;
    let time = time.unwrap_or_else(Timestamp::now);
    let meter = Meter::of_file(
        Path::new(&source),
        if quiet { Manner::Silent } else { Manner::Lines(INTERVAL) },
    );
    let source = Source::from(source);
    let Some(map) = open(&source, &meter)? else {
        let _ = writeln!(
            std::io::stderr(),
            "mapd-foxglove: {source} is rejected: `mapd check {source}` says why"
        );
        return Ok(Exit::Rejected);
    };
    source::say_without_overlay(&map, "mapd-foxglove");
    let recording =
        recording::of(map.map(), time, &mut |what| meter.stage(|| format!("writing {what}")))?;
    meter.finish();
    if !recording.has_place {
        // A closed stderr is nobody's loss.
        let _ = writeln!(
            std::io::stderr(),
            "mapd-foxglove: the map has no georeference: there is no /map/location"
        );
    }
    draft::write_by(&output, |out| Ok(out.write_all(&recording.bytes)?))?;
    Ok(Exit::Done)
}

/// A time that is given \[s\].
///
/// Errors: before 1970, or later than the 32 bits of Foxglove's messages reach, in 2106.
fn given(text: &str) -> Result<Timestamp> {
    let time = Duration::try_from_secs_f64(text.parse()?)?;
    let seconds = time.as_secs().try_into();
    let seconds = seconds.context("Foxglove's messages end in 2106")?;
    Ok(Timestamp::new(seconds, time.subsec_nanos()))
}

/// Opens a SOURCE as `mapd export` does without options; none where the map is rejected.
///
/// Errors: it cannot be read.
fn open(source: &Source, meter: &Meter) -> Result<Option<Snapshot>> {
    let compiling =
        Compiling { reading: &ReadOptions::default(), options: &CompileOptions::default() };
    let domain = Domain::from_env()?;
    let live = Attaching { domain: &domain, attach: Attach::Observer, wait: WAIT };
    Ok(match source::open(source, compiling, live, &mut |progress| meter.show(progress))? {
        Opened::Map(map, _) => Some(map),
        Opened::Rejected(_) => None,
    })
}
