//! `mapd export`: a map drawn or converted.

mod command;
mod earth;
mod flatgeobuf;
mod geojson;
mod index_boxes;
mod lanelet2;
mod layers;
mod marks;
mod objects;
mod overlay;
mod route;
mod style;
mod svg;

use crate::draft;
use anyhow::Result;
use clap::ValueEnum;
pub(crate) use command::ExportCommand;
pub use earth::Origin;
pub(crate) use lanelet2::Report;
pub use layers::Layer;
use mapd_client::Snapshot;
use mapd_web::page;
pub use route::RouteEnds;
use std::io::{self, Write};
use std::path::Path;
use std::time::SystemTime;

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
    /// Lanelets and regulatory elements with latitudes and longitudes (.osm).
    Lanelet2,
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
    /// Of formats with latitudes and longitudes, where a map without a georeference is to lie.
    pub origin: Option<Origin>,
    /// Of Lanelet2's, what Autoware reads and Lanelet2's own loader refuses.
    pub autoware: bool,
}

/// What a format cannot hold.
#[derive(Default)]
pub(crate) struct LeftOut {
    /// Features without a place, in a format that cannot do without.
    pub(crate) features: usize,
    /// What is not in a Lanelet2 file as it is in the map.
    pub(crate) report: Option<Report>,
}

impl LeftOut {
    /// Says on stderr what it is, and writes Lanelet2's report to a file where there is one.
    ///
    /// Errors: the file cannot be written.
    pub(crate) fn tell(&self, file: Option<&Path>) -> Result<()> {
        // A closed stderr is nobody's loss.
        if self.features > 0 {
            let _ = writeln!(
                io::stderr(),
                "mapd: {} features without a place are left out: this format cannot hold them",
                self.features
            );
        }
        let Some(report) = &self.report else { return Ok(()) };
        let _ = report.summary(&mut io::stderr());
        match file {
            Some(path) => draft::write_by(path, |out| report.write(out)),
            None => Ok(()),
        }
    }
}

/// Writes a map to a file, which is there as a whole or not, or to `out` where there is none. Returns what the format cannot hold.
///
/// Errors: the file cannot be written; the format needs a georeference and the map has none.
pub(crate) fn write(
    snapshot: &Snapshot,
    format: Format,
    options: &Options,
    file: Option<&Path>,
    out: &mut dyn Write,
) -> Result<LeftOut> {
    let map = snapshot.map();
    let view = snapshot.view(SystemTime::now());
    let line = options.route.as_ref().map(|ends| route::line(map, ends)).transpose()?;
    let mut layers = options.layers.clone();
    layers.sort_unstable();
    layers.dedup();
    if layers.is_empty() {
        layers = Layer::ALL.to_vec();
    }
    let mut left_out = LeftOut::default();
    let projector = || earth::projector(map, options.origin);
    let mut write_to = |out: &mut dyn Write| -> Result<()> {
        match format {
            Format::Svg => svg::write(view, options, line.as_deref(), out)?,
            Format::GeoJson => geojson::write(view, &layers, &projector()?, out)?,
            Format::FlatGeobuf => left_out.features = flatgeobuf::write(view, &layers, out)?,
            Format::Lanelet2 => {
                let report = lanelet2::write(map, &projector()?, options.autoware, out)?;
                left_out.report = Some(report);
            }
            Format::Html => {
                page::write(page::Content::Archive(snapshot.bytes()), &options.title, out)?
            }
        }
        Ok(())
    };
    match file {
        Some(path) => draft::write_by(path, write_to)?,
        None => write_to(out)?,
    }
    Ok(left_out)
}
