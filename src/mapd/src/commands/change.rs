//! `mapd reload`, `rollback`, `activate`: what a running daemon is told.

use crate::args::DomainArgs;
use crate::args::Seconds;
use crate::control::{AskError, ReloadResult, Request, Response, ask};
use crate::daemon::sentence;
use crate::exit::Exit;
use crate::printable::printable;
use anyhow::{Result, bail};
use clap::Args;
use std::io::Write;
use std::time::Duration;

/// Longest wait for the outcome of a change, where nothing else is said.
const OUTCOME: Duration = Duration::from_secs(600);

/// A change that makes a generation, which may be left for later.
#[derive(Args)]
pub(crate) struct StagedChange {
    #[command(flatten)]
    change: ChangeArgs,
    /// Leave it pending, for `mapd activate`
    #[arg(long)]
    stage: bool,
}

impl StagedChange {
    /// `mapd reload`.
    ///
    /// Errors: as [`ChangeArgs::ask`].
    pub(crate) fn reload(self, out: &mut dyn Write) -> Result<Exit> {
        let stage = self.stage;
        self.change.ask(|map| Request::Reload { map, stage }, out)
    }

    /// `mapd rollback`.
    ///
    /// Errors: as [`ChangeArgs::ask`].
    pub(crate) fn rollback(self, out: &mut dyn Write) -> Result<Exit> {
        let stage = self.stage;
        self.change.ask(|map| Request::Rollback { map, stage }, out)
    }
}

/// Which map, and how its outcome is told.
#[derive(Args)]
pub(crate) struct ChangeArgs {
    /// Name of the map
    name: String,
    /// Longest wait for the result [s]; the daemon continues in any case
    #[arg(long, value_name = "S", default_value_t = Seconds(OUTCOME))]
    wait: Seconds,
    /// Print the result as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    domain: DomainArgs,
}

impl ChangeArgs {
    /// `mapd activate`.
    ///
    /// Errors: as [`ChangeArgs::ask`].
    pub(crate) fn activate(self, out: &mut dyn Write) -> Result<Exit> {
        self.ask(|map| Request::Activate { map }, out)
    }

    /// Asks the daemon and tells what came of it: done, or rejected where the generation before is still served.
    ///
    /// Errors: no daemon, no answer in time, no such map.
    fn ask(&self, request: impl FnOnce(String) -> Request, out: &mut dyn Write) -> Result<Exit> {
        let domain = self.domain.domain()?;
        mapd_transport::check_map_name(&self.name)?;
        match ask(&domain, &self.name, &request(self.name.clone()), self.wait.0)? {
            Response::Done(report) => {
                if self.json {
                    serde_json::to_writer(&mut *out, &report)?;
                    writeln!(out)?;
                } else {
                    writeln!(out, "{}: {}", self.name, printable(&sentence(&report)))?;
                }
                Ok(if report.result == ReloadResult::Failed { Exit::Rejected } else { Exit::Done })
            }
            Response::Refused { reason } => bail!("map {:?}: {reason}", self.name),
            _ => bail!(AskError::Unexpected { map: self.name.clone() }),
        }
    }
}
