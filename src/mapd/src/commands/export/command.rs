//! `mapd export` on the command line.

use super::{Format, Layer, Options, Origin, RouteEnds, write};
use crate::args::Opening;
use crate::exit::{Exit, UsageError};
use crate::same_file::is_same_file;
use crate::source::SHARED;
use anyhow::{Result, bail};
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What to write of which map.
#[derive(Args)]
pub(crate) struct ExportCommand {
    /// .xodr, .mapd or shm:NAME
    source: String,
    /// Output format
    #[arg(long, value_enum)]
    format: Format,
    /// File to write [default: stdout]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// svg: also the boxes of the spatial index
    #[arg(long)]
    index_boxes: bool,
    /// svg: also the driven line of a passenger car's shortest route
    #[arg(long, value_name = "ROAD,S,LANE:ROAD,S,LANE", allow_hyphen_values = true)]
    route: Option<RouteEnds>,
    /// geojson, flatgeobuf: layers to write [default: all]
    #[arg(long, value_name = "LAYER,…", value_enum, value_delimiter = ',')]
    layers: Vec<Layer>,
    /// geojson, lanelet2: where the point 0, 0 of a map without a georeference is to lie [deg]
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true)]
    origin: Option<Origin>,
    /// lanelet2: also what Autoware reads and Lanelet2's own loader refuses
    #[arg(long)]
    autoware: bool,
    /// lanelet2: CSV file that lists what is not in OUT as it is in the map
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    #[command(flatten)]
    opening: Opening,
}

impl ExportCommand {
    /// Writes the map.
    ///
    /// Errors: wrong usage; the source cannot be opened; as [`write`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let output = self.output.as_deref();
        if let Some(output) = output.filter(|file| is_same_file(file, self.source.as_ref())) {
            bail!(UsageError(format!("{} would overwrite its source", output.display())));
        }
        let Some(snapshot) = self.opening.open(&self.source)? else { return Ok(Exit::Rejected) };
        let title = title(&self.source);
        let Self { index_boxes, route, layers, origin, autoware, .. } = self;
        let options = Options { index_boxes, route, layers, origin, autoware, title };
        let left_out = write(&snapshot, self.format, &options, self.output.as_deref(), out)?;
        left_out.tell(self.report.as_deref())?;
        Ok(Exit::Done)
    }
}

/// What a page is called: a file without its folder and kind, a live map by its name.
fn title(source: &str) -> String {
    let name = source.strip_prefix(SHARED).unwrap_or(source);
    let stem = Path::new(name).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
