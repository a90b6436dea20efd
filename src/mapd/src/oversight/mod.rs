//! What shows that a daemon is well, while it runs: logs, metrics, queries of its own, the service manager's watchdog, and
//! proofs of what is served.
//!
//! Everything here runs in threads beside the one that serves, looks at the maps as any client would, and writes what it
//! finds on the daemon's [`Board`]. Nothing here can hold up serving.

mod attendant;
pub(crate) mod log;
mod metrics;
mod page;
mod periodic;
pub(crate) mod proof;
mod rounds;
mod scrubber;
mod self_query;

use crate::args::at_least_one;
use crate::control::Board;
use crate::exit::UsageError;
use anyhow::{Context, Result, bail};
use clap::Args;
use mapd_client::Domain;
use periodic::{Periodic, Stop};
use std::net::{SocketAddr, TcpListener};
use std::num::NonZeroU32;
use std::sync::Arc;
use std::time::Duration;

/// Options of oversight.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct OversightArgs {
    #[command(flatten)]
    pub(crate) log: log::LogArgs,

    /// Serve metrics for Prometheus, at 127.0.0.1:9464 for example
    #[arg(long, value_name = "ADDRESS:PORT")]
    metrics: Option<SocketAddr>,

    /// Allow an address for --metrics that other machines can reach
    #[arg(long)]
    metrics_open: bool,

    /// Verify every byte of the served maps at this interval [s]
    #[arg(long, value_name = "SECONDS", value_parser = at_least_one::<NonZeroU32>)]
    scrub: Option<NonZeroU32>,
}

/// The same, as far as a configuration file says it.
#[derive(Clone, Debug, Default)]
pub(crate) struct OversightSettings {
    pub(crate) metrics: Option<SocketAddr>,
    pub(crate) metrics_open: bool,
    pub(crate) scrub: Option<NonZeroU32>,
}

impl OversightArgs {
    /// These, and where they are silent, what the configuration file says.
    pub(crate) fn or(&self, file: &OversightSettings) -> Self {
        Self {
            log: self.log.clone(),
            metrics: self.metrics.or(file.metrics),
            metrics_open: self.metrics_open || file.metrics_open,
            scrub: self.scrub.or(file.scrub),
        }
    }
}

/// Where the metrics will be read: had before anything is served, so that a daemon that cannot have it serves nothing.
pub(crate) struct MetricsPort(Option<TcpListener>);

impl OversightArgs {
    /// Opens the port of the metrics, if they are asked for.
    ///
    /// Errors: the port cannot be had, or is open to others without --metrics-open, or that is said of none.
    pub(crate) fn open_metrics(&self) -> Result<MetricsPort> {
        let Some(address) = self.metrics else {
            if self.metrics_open {
                bail!(UsageError("--metrics-open goes with --metrics".to_owned()));
            }
            return Ok(MetricsPort(None));
        };
        if !address.ip().is_loopback() && !self.metrics_open {
            let message = format!(
                "--metrics {address} can be reached from other machines: say --metrics-open if that is meant"
            );
            bail!(UsageError(message));
        }
        let listener =
            TcpListener::bind(address).with_context(|| format!("--metrics {address}"))?;
        Ok(MetricsPort(Some(listener)))
    }
}

/// Oversight of a daemon; ends when dropped.
pub(crate) struct Oversight {
    _threads: Vec<Periodic>,
    _page: Option<page::Page>,
}

impl Drop for Oversight {
    fn drop(&mut self) {
        attendant::stopping();
    }
}

impl Oversight {
    /// Begins. The service manager hears that the daemon is ready once every map has answered a query, so that serving has to
    /// begin soon.
    ///
    /// Errors: no thread can be had for the metrics.
    pub(crate) fn start(
        args: &OversightArgs,
        MetricsPort(port): MetricsPort,
        domain: &Domain,
        board: &Arc<Board>,
        maps: Vec<String>,
    ) -> Result<Self> {
        let page = port.map(|listener| {
            let board = board.clone();
            let text = move || metrics::text(&board.status_with_subscribers());
            page::Page::serve(listener, args.metrics_open, text).context("--metrics")
        });
        let page = page.transpose()?;
        let stop = Arc::new(Stop::default());
        let mut threads = Vec::new();
        // Without a service manager and without metrics, no self-query is needed.
        if attendant::is_managed() || page.is_some() {
            threads.push(attendant::start(domain, board, &maps, &stop));
        }
        if let Some(seconds) = args.scrub {
            let interval = Duration::from_secs(u64::from(seconds.get()));
            threads.push(scrubber::start(domain, board, &maps, interval, &stop));
        }
        Ok(Self { _threads: threads, _page: page })
    }
}
