//! `mapd export`: a map drawn or converted.

mod command;
mod earth;
mod flatgeobuf;
mod geojson;
mod index_boxes;
mod layers;
mod marks;
mod objects;
mod route;
mod style;
mod svg;

use crate::draft;
use anyhow::Result;
use clap::ValueEnum;
pub(crate) use command::ExportCommand;
pub use layers::Layer;
use mapd_client::Snapshot;
pub use route::RouteEnds;
use std::io::Write;
use std::path::Path;

/// What a map is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A drawing in plan view: lanes by type, bounds, road marks, reference lines.
    Svg,
    /// Layers of features with longitudes and latitudes (RFC 7946).
    #[value(name = "geojson")]
    GeoJson,
    /// Layers of features in one indexed table, in the plane of the map's projection.
    #[value(name = "flatgeobuf")]
    FlatGeobuf,
    /// One page for a browser, which draws the map and answers questions, without a network.
    Html,
}

/// What is written besides what every map has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Of a drawing, the boxes of the spatial index and the rectangles of its leaves.
    pub index_boxes: bool,
    /// Of a drawing, the ends of a route, whose driven line is drawn.
    pub route: Option<RouteEnds>,
    /// Of formats that have layers, those that are written; none: all.
    pub layers: Vec<Layer>,
    /// Of a page, its title.
    pub title: String,
}

/// Writes a map to a file, which is there as a whole or not, or to `out` where there is none. Returns how many features were
/// left out for want of a place, in a format that cannot do without.
///
/// Errors: the file cannot be written; the format needs a georeference and the map has none.
pub(crate) fn write(
    snapshot: &Snapshot,
    format: Format,
    options: &Options,
    file: Option<&Path>,
    out: &mut dyn Write,
) -> Result<usize> {
    let map = snapshot.map();
    let line = options.route.as_ref().map(|ends| route::line(map, ends)).transpose()?;
    let mut layers = options.layers.clone();
    layers.sort_unstable();
    layers.dedup();
    if layers.is_empty() {
        layers = Layer::ALL.to_vec();
    }
    let mut left_out = 0;
    let mut write_to = |out: &mut dyn Write| -> Result<()> {
        match format {
            Format::Svg => svg::write(map, options, line.as_deref(), out)?,
            Format::GeoJson => geojson::write(map, &layers, out)?,
            Format::FlatGeobuf => left_out = flatgeobuf::write(map, &layers, out)?,
            Format::Html => mapd_web::page::write(snapshot.bytes(), &options.title, out)?,
        }
        Ok(())
    };
    match file {
        Some(path) => draft::write_by(path, write_to)?,
        None => write_to(out)?,
    }
    Ok(left_out)
}
