//! Tables of the user's that say what signals and objects mean.

use crate::exit::UsageError;
use crate::small_text;
use anyhow::Result;
use clap::Args;
use mapd_compiler::ReadOptions;
use std::path::PathBuf;

/// Tables of the vocabulary, besides those that mapd has.
#[derive(Args)]
pub(crate) struct OntologyArgs {
    /// Table with the meaning of signals and objects; takes precedence over mapd's own; may be repeated (docs/ontology.md)
    #[arg(long, value_name = "FILE")]
    ontology: Vec<PathBuf>,
}

impl OntologyArgs {
    /// Reading options with these tables.
    ///
    /// Errors: a file cannot be read, or is no table.
    pub(crate) fn apply(&self, mut reading: ReadOptions) -> Result<ReadOptions> {
        for path in &self.ontology {
            let text = small_text::read(path)?;
            let name = path.display().to_string();
            reading.ontology.extend(&name, &text).map_err(|error| UsageError(error.to_string()))?;
        }
        Ok(reading)
    }

    /// Reading options for a SOURCE.
    ///
    /// Errors: as [`OntologyArgs::apply`]; tables for a map that is compiled already.
    pub(crate) fn for_source(&self, is_compiled: bool) -> Result<ReadOptions> {
        if is_compiled && !self.ontology.is_empty() {
            let message =
                "--ontology holds when a map is compiled; this source is compiled already";
            return Err(UsageError(message.to_owned()).into());
        }
        self.apply(ReadOptions::default())
    }
}
