//! The frame that a map is compiled into.

use crate::exit::UsageError;
use crate::source::Source;
use anyhow::Result;
use clap::Args;
use mapd_compiler::{CompileOptions, Target};

/// The frame that a map is compiled into.
#[derive(Args)]
pub(crate) struct FrameArgs {
    /// Frame for x, y and z: an EPSG code, PROJ parameters, `utm` (the zone of the map's centre) or
    /// enu:LAT,LON[,ALT] (east and north of that place); s and t stay as written [default: the file's own frame]
    #[arg(long, value_name = "CRS")]
    pub(crate) crs: Option<Target>,
}

impl FrameArgs {
    /// Options for a SOURCE that is compiled if it is an OpenDRIVE file.
    ///
    /// Errors: a frame is asked for, but the source is compiled already.
    pub(super) fn source(&self, source: &Source) -> Result<CompileOptions> {
        if self.crs.is_some() && source.is_compiled() {
            let message = format!(
                "--crs transforms OpenDRIVE files only; {source} keeps the frame it was compiled into"
            );
            return Err(UsageError(message).into());
        }
        Ok(CompileOptions { crs: self.crs.clone(), ..CompileOptions::default() })
    }
}
