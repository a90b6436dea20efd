//! `mapd export`: a map drawn or converted.

mod index_boxes;
mod marks;
mod objects;
mod route;
mod style;
mod svg;

use anyhow::{Context, Result};
use clap::ValueEnum;
use mapd_client::Map;
pub use route::RouteEnds;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

/// What a map is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A drawing in plan view: lanes by type, bounds, road marks, reference lines.
    Svg,
}

/// What a drawing shows besides lanes and bounds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The boxes of the spatial index and the rectangles of its leaves.
    pub index_boxes: bool,
    /// The ends of a route, whose driven line is drawn.
    pub route: Option<RouteEnds>,
}

/// Writes a map to a file, or to `out` where there is none.
///
/// Errors: the file cannot be written.
pub(crate) fn run(
    map: Map<'_>,
    format: Format,
    options: &Options,
    file: Option<&Path>,
    out: &mut dyn Write,
) -> Result<()> {
    let line = options.route.as_ref().map(|ends| route::line(map, ends)).transpose()?;
    let write = |out: &mut dyn Write| match format {
        Format::Svg => svg::write(map, options, line.as_deref(), out),
    };
    let Some(path) = file else { return Ok(write(out)?) };
    let context = || format!("writing {}", path.display());
    let mut file = BufWriter::new(File::create(path).with_context(context)?);
    write(&mut file).and_then(|()| file.flush()).with_context(context)
}
