//! Maps as files for other programs: drawings, one page for a browser, tables for QGIS and GDAL, Lanelet2.
//!
//! [`write()`] writes a [`Snapshot`] in a [`Format`] and says what the format cannot hold. Every format is a feature of its name; without a
//! feature, its format and its options are absent, and so are the crates that it needs.
//!
//! Invariants: text of a map is text in every format, whatever it contains; the same map and options give the same bytes. Deliberately
//! absent: files. The caller decides where the bytes go, and what becomes of half a file.
//!
//! ```
//! # #[cfg(feature = "geojson")] {
//! use mapd_client::Snapshot;
//! use mapd_export::{ExportError, Format, Layer, LeftOut, Options, write};
//!
//! fn signals(map: &Snapshot) -> Result<(LeftOut, Vec<u8>), ExportError> {
//!     let options = Options { layers: vec![Layer::Signals], ..Options::default() };
//!     let mut file = Vec::new();
//!     let left_out = write(map, Format::GeoJson, &options, &mut |_| {}, &mut file)?;
//!     Ok((left_out, file))
//! }
//! # }
//! ```

#[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "lanelet2"))]
mod earth;
mod error;
#[cfg(feature = "flatgeobuf")]
mod flatgeobuf;
#[cfg(feature = "geojson")]
mod geojson;
#[cfg(feature = "lanelet2")]
mod lanelet2;
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
mod layers;
mod options;
#[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "svg"))]
mod overlay;
#[cfg(feature = "svg")]
mod svg;

#[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "lanelet2"))]
pub use earth::Origin;
pub use error::{ExportError, Result};
#[cfg(feature = "lanelet2")]
pub use lanelet2::Report;
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
pub use layers::Layer;
use mapd_client::Snapshot;
#[cfg(feature = "html")]
pub use mapd_web::page::{Findings, ReportedFinding};
pub use options::{Format, Options, Progress};
use std::io::Write;
#[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "svg"))]
use std::time::SystemTime;
#[cfg(feature = "svg")]
pub use svg::RouteEnds;

/// What a format cannot hold.
#[derive(Default)]
#[non_exhaustive]
pub struct LeftOut {
    /// Number of features without a place, in a format that cannot do without.
    pub features: usize,
    /// What is not in a Lanelet2 file as it is in the map.
    #[cfg(feature = "lanelet2")]
    pub report: Option<Report>,
}

/// Writes a map, with what is laid over it now, and returns what the format cannot hold. `progress` is called as the work goes on.
///
/// Errors: the format needs a georeference and the map has none; a point outside the area of the map's projection; no such route; what
/// writing gives. What has been written by then is half a file.
pub fn write(
    snapshot: &Snapshot,
    format: Format,
    options: &Options,
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<LeftOut> {
    #[allow(unused_mut, reason = "in formats that hold everything")]
    let mut left_out = LeftOut::default();
    #[cfg(any(feature = "flatgeobuf", feature = "geojson", feature = "svg"))]
    let view = snapshot.view(SystemTime::now());
    match format {
        #[cfg(feature = "svg")]
        Format::Svg => svg::write(view, options, progress, out)?,
        #[cfg(feature = "geojson")]
        Format::GeoJson => {
            let projector = earth::projector(view.map(), options.origin)?;
            geojson::write(view, &layers::wanted(&options.layers), &projector, progress, out)?;
        }
        #[cfg(feature = "flatgeobuf")]
        Format::FlatGeobuf => {
            let layers = layers::wanted(&options.layers);
            left_out.features = flatgeobuf::write(view, &layers, progress, out)?;
        }
        #[cfg(feature = "html")]
        Format::Html => {
            progress(Progress { doing: "packing the map", done: 0 });
            let (map, overlay) = (snapshot.bytes(), snapshot.overlay_bytes());
            let findings = &options.findings;
            let content = mapd_web::page::Content::Archive { map, overlay, findings };
            mapd_web::page::write(content, &options.title, out)?;
        }
        #[cfg(feature = "lanelet2")]
        Format::Lanelet2 => {
            let map = snapshot.map();
            let projector = earth::projector(map, options.origin)?;
            let report = lanelet2::write(map, &projector, options.autoware, progress, out)?;
            left_out.report = Some(report);
        }
    }
    Ok(left_out)
}
