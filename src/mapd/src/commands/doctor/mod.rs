//! `mapd doctor`: what this machine and the domain are like, line by line, and what to do about it.
//!
//! Nothing is changed: it looks, and attaches to each map as a client would.

mod archive;
mod configuration;
mod domain;
mod finding;
mod limits;
mod maps;
mod memory;

use crate::args::Live;
use crate::colour::Colours;
use crate::exit::Exit;
use crate::printable::printable;
use anyhow::Result;
use clap::Args;
use finding::{Finding, State};
use mapd_client::Domain;
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;

/// Width of the column of what was examined.
const CHECK: usize = 24;

/// What to examine.
#[derive(Args)]
pub(crate) struct DoctorCommand {
    /// Archive (.mapd) to serve: verify it, and check that there is room for two copies, as needed during a reload
    archive: Option<PathBuf>,
    /// Configuration file (docs/service.md): check what it says, and that its maps can be read
    #[arg(long, value_name = "FILE.toml")]
    config: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    live: Live,
}

impl DoctorCommand {
    /// Examines and prints.
    ///
    /// Errors: as [`examine`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let (domain, wait) = self.live.get()?;
        examine(&self, &domain, wait, out)
    }
}

#[derive(Serialize)]
struct Report<'a> {
    prefix: &'a str,
    /// The gravest of all.
    state: State,
    findings: &'a [Finding],
}

/// Examines and prints. Ends with [`Exit::Environment`] where anything is a problem.
///
/// Errors: writing fails.
fn examine(
    args: &DoctorCommand,
    domain: &Domain,
    wait: Duration,
    out: &mut dyn Write,
) -> Result<Exit> {
    let mut findings = Vec::new();
    let archive = args.archive.as_deref().map_or(0, |path| archive::examine(path, &mut findings));
    memory::examine(archive, &mut findings);
    limits::examine(archive, &mut findings);
    if let Some(config) = &args.config {
        configuration::examine(config, &mut findings);
    }
    if domain::examine(domain, &mut findings) {
        maps::examine(domain, wait, &mut findings);
    }
    let state = findings.iter().map(|finding| finding.state).max().unwrap_or(State::Ok);
    if args.json {
        let report = Report { prefix: domain.prefix(), state, findings: &findings };
        serde_json::to_writer_pretty(&mut *out, &report)?;
        writeln!(out)?;
    } else {
        let colours = Colours::of(&std::io::stdout());
        for Finding { check, state, found, advice } in &findings {
            let shown = colours.severity(state.severity(), state.name());
            writeln!(out, "{shown:<8}{check:<CHECK$}{}", printable(found))?;
            if let Some(advice) = advice {
                writeln!(out, "{:8}{:CHECK$}→ {}", "", "", printable(advice))?;
            }
        }
    }
    Ok(if state == State::Problem { Exit::Environment } else { Exit::Done })
}
