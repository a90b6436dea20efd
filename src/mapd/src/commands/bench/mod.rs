//! `mapd bench`: what attaching and querying take on this machine with this map, beside plain open and mmap of the same
//! bytes.
//!
//! Every comparison is made in turns within one run, so that ratios hold where absolute figures drift. Attaching is
//! measured with fresh processes of this program itself.

mod boot;
mod client;
mod figures;
mod places;
mod queries;
mod served;
mod text;

pub(crate) use client::{BenchClientCommand, SUBCOMMAND};
use figures::Comparison;

use crate::args::{AttachArgs, Live};
use crate::exit::Exit;
use crate::report::hex;
use crate::source::{Attaching, Source};
use anyhow::{Result, ensure};
use clap::Args;
use mapd_client::{Attach, Snapshot};
use mapd_transport::MAX_SUBSCRIBERS;
use serde::Serialize;
use std::io::Write;

/// Most clients at once: a thread of this process starts each.
const MOST_CLIENTS: i64 = 1000;

/// Subscribers of a map that this command leaves to others.
const SUBSCRIBERS_OF_OTHERS: usize = 4;

/// What to measure, and how often.
#[derive(Args)]
pub(crate) struct BenchCommand {
    /// .xodr, .mapd or shm:NAME [default: the served map, if there is only one]
    source: Option<Source>,
    /// Fresh client processes, one after the other and then all at once; at most 60 of them subscribers
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u16).range(1..=MOST_CLIENTS))]
    clients: u16,
    /// Queries of each kind
    #[arg(long, value_name = "N", default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(1..))]
    queries: u32,
    /// Routes
    #[arg(long, value_name = "N", default_value_t = 500)]
    routes: u32,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    live: Live,
    #[command(flatten)]
    attach: AttachArgs,
}

/// Everything that was measured.
#[derive(Serialize)]
struct Report<'a> {
    source: String,
    map: &'a str,
    generation: u64,
    bytes: usize,
    content_hash: String,
    lanes: usize,
    cores: usize,
    kernel: String,
    /// Whether this program was built without optimisation: then the figures say little.
    debug_build: bool,
    boot: boot::Boot,
    queries: Vec<Comparison>,
}

impl BenchCommand {
    /// Measures and prints.
    ///
    /// Errors: more clients than may subscribe; as [`measure`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let (domain, wait) = self.live.get_for(self.source.as_ref())?;
        let most = MAX_SUBSCRIBERS - SUBSCRIBERS_OF_OTHERS;
        ensure!(
            self.attach.get() != Attach::Subscriber || usize::from(self.clients) <= most,
            "--clients {}: a map has room for {most} subscribers of a benchmark; observers are not limited",
            self.clients
        );
        let live = Attaching { domain: &domain, attach: self.attach.get(), wait };
        measure(&self, live, out)?;
        Ok(Exit::Done)
    }
}

/// Measures and prints.
///
/// Errors: no source, or none that can be served; a client fails; writing fails.
fn measure(args: &BenchCommand, live: Attaching<'_>, out: &mut dyn Write) -> Result<()> {
    served::with(args.source.as_ref(), live, |served| {
        let file = Snapshot::open(&served.file)?;
        let boot = boot::run(
            &served.domain,
            live.attach,
            &served.name,
            &served.file.display().to_string(),
            usize::from(args.clients),
        )?;
        let counts =
            queries::Counts { queries: args.queries as usize, routes: args.routes as usize };
        let both = queries::OnBoth { shared: served.snapshot.map(), file: file.map() };
        let map = served.snapshot.map();
        let report = Report {
            source: args.source.as_ref().map_or_else(|| served.name.clone(), Source::to_string),
            map: &served.name,
            generation: served.snapshot.generation(),
            bytes: served.snapshot.bytes().len(),
            content_hash: hex(&map.content_hash()),
            lanes: map.lanes().filter(|lane| lane.number() != 0).count(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            kernel: rustix::system::uname().release().to_string_lossy().into_owned(),
            debug_build: cfg!(debug_assertions),
            boot,
            queries: queries::compare(both, counts),
        };
        if args.json {
            serde_json::to_writer_pretty(&mut *out, &report)?;
            writeln!(out)?;
        } else {
            text::print(&report, out)?;
        }
        Ok(())
    })
}
