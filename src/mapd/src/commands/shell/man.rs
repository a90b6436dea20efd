//! `mapd man`.

use crate::commands::help::EXAMPLES;
use crate::exit::Exit;
use anyhow::{Context, Result};
use clap::{Args, Command};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

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
    pub(crate) fn run(self, mut program: Command) -> Result<Exit> {
        let writing = || format!("writing man pages into {}", self.folder.display());
        std::fs::create_dir_all(&self.folder).with_context(writing)?;
        program.build();
        write_pages(&program, &self.folder).with_context(writing)?;
        Ok(Exit::Done)
    }
}

/// Writes the page of a command and those of the commands below it.
fn write_pages(command: &Command, folder: &Path) -> io::Result<()> {
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        write_pages(below, folder)?;
    }
    let version = concat!("mapd ", env!("CARGO_PKG_VERSION"));
    let man = Man::new(command.clone()).source(version);
    let mut page = Vec::new();
    write(&man, command, &mut page)?;
    std::fs::write(folder.join(man.get_filename()), page)
}

/// Writes a page. What stands at the end of the help has lines of its own there, and sections here.
fn write(man: &Man, command: &Command, page: &mut dyn Write) -> io::Result<()> {
    man.render_title(page)?;
    man.render_name_section(page)?;
    man.render_synopsis_section(page)?;
    man.render_description_section(page)?;
    man.render_options_section(page)?;
    if command.get_subcommands().any(|below| !below.is_hide_set()) {
        man.render_subcommands_section(page)?;
    }
    let help = command.get_after_long_help().or(command.get_after_help());
    let help = help.map(ToString::to_string).unwrap_or_default();
    let (notes, examples) = help.split_once(EXAMPLES).unwrap_or((&help, ""));
    let mut roff = Roff::new();
    section("NOTES", notes, &mut roff);
    section("EXAMPLES", examples, &mut roff);
    roff.to_writer(page)
}

/// A section of paragraphs; lines that begin with a space stay as they are, so that they can be read in columns and copied.
fn section(name: &str, text: &str, roff: &mut Roff) {
    let text = text.trim_matches('\n');
    if text.is_empty() {
        return;
    }
    roff.control("SH", [name]);
    let mut is_literal = false;
    for line in text.lines() {
        if line.starts_with(' ') != is_literal && !line.is_empty() {
            is_literal = !is_literal;
            roff.control(if is_literal { "nf" } else { "fi" }, []);
        }
        match line {
            "" if is_literal => roff.text([roman("")]),
            "" => roff.control("PP", []),
            line => roff.text([roman(line)]),
        };
    }
    if is_literal {
        roff.control("fi", []);
    }
}
