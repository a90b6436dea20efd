//! `mapd inspect`.

mod annotations;
mod facts;
mod findings;
mod graph;
mod objects;
mod page;
mod signals;

use crate::args::{OpenedSource, Opening};
use crate::exit::Exit;
use crate::progress::Manner;
use crate::source::Source;
use anyhow::Result;
use clap::Args;
use std::io::Write;

/// What to show.
#[derive(Args)]
pub(crate) struct InspectCommand {
    /// .xodr, .mapd or shm:NAME
    source: Source,
    /// Print JSON, with every figure and table
    #[arg(long)]
    json: bool,
    /// Also show the bytes of each table of the archive
    #[arg(long)]
    tables: bool,
    /// Verify the content hash and every row first
    #[arg(long)]
    verify: bool,
    #[command(flatten)]
    opening: Opening,
}

impl InspectCommand {
    /// Prints what an archive holds.
    ///
    /// Errors: the source cannot be opened; the archive does not prove.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let Some(OpenedSource { snapshot, compilation }) =
            self.opening.open_with_findings(&self.source, Manner::Bar)?
        else {
            return Ok(Exit::Rejected);
        };
        if self.verify {
            snapshot.verify()?;
        }
        let facts = facts::inspect(
            &self.source.to_string(),
            &snapshot,
            compilation.as_deref(),
            self.verify,
        );
        if self.json {
            serde_json::to_writer_pretty(&mut *out, &facts)?;
            writeln!(out)?;
        } else {
            page::write(&facts, self.tables, out)?;
        }
        Ok(Exit::Done)
    }
}
