//! `mapd completions` and `mapd man`: the command line as files for shells and for man.

use crate::exit::Exit;
use anyhow::{Context, Result};
use clap::Args;
use clap_complete::Shell;
use std::io::Write;
use std::path::PathBuf;

/// Name of the program in scripts and pages.
const PROGRAM: &str = "mapd";

/// Which shell completes.
#[derive(Args)]
pub(crate) struct CompletionsCommand {
    /// Shell that the script is for
    shell: Shell,
}

impl CompletionsCommand {
    /// Writes the script.
    ///
    /// Errors: writing fails.
    pub(crate) fn run(self, mut command: clap::Command, out: &mut dyn Write) -> Result<Exit> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, PROGRAM, &mut script);
        out.write_all(&script)?;
        Ok(Exit::Done)
    }
}

/// Where man pages go.
#[derive(Args)]
pub(crate) struct ManCommand {
    /// Folder that the pages are written into; it is made where there is none
    folder: PathBuf,
}

impl ManCommand {
    /// Writes a page of section 1 for the program and one for each command.
    ///
    /// Errors: the folder cannot be made, or a page not be written.
    pub(crate) fn run(self, command: clap::Command) -> Result<Exit> {
        let writing = || format!("writing man pages into {}", self.folder.display());
        std::fs::create_dir_all(&self.folder).with_context(writing)?;
        clap_mangen::generate_to(command, &self.folder).with_context(writing)?;
        Ok(Exit::Done)
    }
}
