//! What is written, and how far writing is.

#[cfg(feature = "html")]
use crate::Findings;
#[cfg(any(feature = "geojson", feature = "lanelet2"))]
use crate::Origin;
#[cfg(feature = "svg")]
use crate::RouteEnds;
#[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
use crate::layers::Layer;

/// What a map is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// A drawing in plan view: lanes by type, bounds, road marks, reference lines.
    #[cfg(feature = "svg")]
    Svg,
    /// Layers of features with longitudes and latitudes (RFC 7946).
    #[cfg(feature = "geojson")]
    GeoJson,
    /// Layers of features in one indexed table, in the plane of the map's projection.
    #[cfg(feature = "flatgeobuf")]
    FlatGeobuf,
    /// One page for a browser, which draws the map and answers questions, without a network.
    #[cfg(feature = "html")]
    Html,
    /// Lanelets and regulatory elements with latitudes and longitudes (.osm).
    #[cfg(feature = "lanelet2")]
    Lanelet2,
}

impl Format {
    /// All formats that were built.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "svg")]
        Self::Svg,
        #[cfg(feature = "geojson")]
        Self::GeoJson,
        #[cfg(feature = "flatgeobuf")]
        Self::FlatGeobuf,
        #[cfg(feature = "html")]
        Self::Html,
        #[cfg(feature = "lanelet2")]
        Self::Lanelet2,
    ];

    /// What the command line calls it.
    pub const fn name(self) -> &'static str {
        match self {
            #[cfg(feature = "svg")]
            Self::Svg => "svg",
            #[cfg(feature = "geojson")]
            Self::GeoJson => "geojson",
            #[cfg(feature = "flatgeobuf")]
            Self::FlatGeobuf => "flatgeobuf",
            #[cfg(feature = "html")]
            Self::Html => "html",
            #[cfg(feature = "lanelet2")]
            Self::Lanelet2 => "lanelet2",
        }
    }

    /// What it is, in a few words.
    pub const fn about(self) -> &'static str {
        match self {
            #[cfg(feature = "svg")]
            Self::Svg => {
                "A drawing in plan view: lanes by type, bounds, road marks, reference lines"
            }
            #[cfg(feature = "geojson")]
            Self::GeoJson => "Layers of features with longitudes and latitudes (RFC 7946)",
            #[cfg(feature = "flatgeobuf")]
            Self::FlatGeobuf => {
                "Layers of features in one indexed table, in the plane of the map's projection"
            }
            #[cfg(feature = "html")]
            Self::Html => {
                "One page for a browser, which draws the map and answers questions, without a network"
            }
            #[cfg(feature = "lanelet2")]
            Self::Lanelet2 => {
                "Lanelets and regulatory elements with latitudes and longitudes (.osm)"
            }
        }
    }
}

/// What is written besides what every map has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Of a drawing, the boxes of the spatial index and the rectangles of its leaves.
    #[cfg(feature = "svg")]
    pub index_boxes: bool,
    /// Of a drawing, the ends of a route, whose driven line is drawn.
    #[cfg(feature = "svg")]
    pub route: Option<RouteEnds>,
    /// Of formats that have layers, those that are written; none: all.
    #[cfg(any(feature = "flatgeobuf", feature = "geojson"))]
    pub layers: Vec<Layer>,
    /// Of a page, its title.
    #[cfg(feature = "html")]
    pub title: String,
    /// Of a page, what was found in the map's file.
    #[cfg(feature = "html")]
    pub findings: Findings,
    /// Of formats with latitudes and longitudes, where a map without a georeference is to lie.
    #[cfg(any(feature = "geojson", feature = "lanelet2"))]
    pub origin: Option<Origin>,
    /// Of Lanelet2's, what Autoware reads and Lanelet2's own loader refuses.
    #[cfg(feature = "lanelet2")]
    pub autoware: bool,
}

/// How far writing is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What is being done, such as the layer that is written.
    pub doing: &'static str,
    /// How much of it is done; 0 where nothing is counted.
    pub done: usize,
}

/// From one call to the next of what shows progress, in things that are written: often enough for an eye, seldom enough to cost nothing.
const OFTEN: usize = 1024;

impl Progress {
    /// Tells how far something is, now and then.
    #[allow(dead_code, reason = "a page is written in one piece")]
    pub(crate) fn tell(doing: &'static str, done: usize, progress: &mut dyn FnMut(Self)) {
        if done.is_multiple_of(OFTEN) {
            progress(Self { doing, done });
        }
    }
}
