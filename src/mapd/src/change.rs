//! `mapd reload`, `rollback`, `activate`: what a running daemon is told.

use crate::cli::{DomainArgs, UsageError};
use crate::control::{ReloadResult, Request, Response, ask};
use crate::daemon::sentence;
use crate::exit::Exit;
use anyhow::{Result, bail};
use clap::Args;
use std::io::Write;
use std::time::Duration;

/// Which map, and how its outcome is told.
#[derive(Args)]
pub(crate) struct ChangeArgs {
    /// The map
    name: String,
    /// Longest wait for the outcome [s]; the daemon goes on also without
    #[arg(long, value_name = "S", default_value_t = 600.0)]
    wait: f64,
    /// The outcome as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    domain: DomainArgs,
}

impl ChangeArgs {
    /// Asks the daemon and tells what came of it: done, or rejected where the generation before is still served.
    ///
    /// Errors: no daemon, no answer in time, no such map.
    pub(crate) fn ask(
        &self,
        request: impl FnOnce(String) -> Request,
        out: &mut dyn Write,
    ) -> Result<Exit> {
        let wait = Duration::try_from_secs_f64(self.wait)
            .map_err(|error| UsageError(format!("--wait: {error}")))?;
        let domain = self.domain.domain()?;
        mapd_client::transport::check_map_name(&self.name)?;
        match ask(&domain, &self.name, &request(self.name.clone()), wait)? {
            Response::Done(report) => {
                if self.json {
                    serde_json::to_writer(&mut *out, &report)?;
                    writeln!(out)?;
                } else {
                    writeln!(out, "{}: {}", self.name, sentence(&report))?;
                }
                Ok(if report.result == ReloadResult::Failed { Exit::Rejected } else { Exit::Done })
            }
            Response::Refused { reason } => bail!("map {:?}: {reason}", self.name),
            Response::Status(_) => bail!("map {:?}: the daemon answers something else", self.name),
        }
    }
}
