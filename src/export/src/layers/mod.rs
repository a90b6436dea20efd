//! What files for other programs hold: layers of features, each a shape in the map's frame and values in columns.

mod edges;
mod findings;
mod lanes;
mod lines;
mod overlay;
mod things;

use crate::Result;
use mapd_client::glam::DVec3;
use mapd_client::view::View;
use mapd_client::{Lane, LaneSection, Map};
use std::borrow::Cow;

/// Features of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Layer {
    /// Lanes as polygons.
    Lanes,
    /// Centre lines of lanes, in driving direction.
    CenterLines,
    /// Borders of lanes, cut where their road mark changes.
    Borders,
    /// Lines across a lane where its traffic stops or yields.
    StopLines,
    /// Crosswalks and bicycle crossings.
    Crosswalks,
    /// Signals as points.
    Signals,
    /// Objects, outline by outline.
    Objects,
    /// Edges of the lane graph.
    Edges,
    /// Parts of the file that are in quarantine, as boxes.
    Findings,
    /// What is laid over a live map now, as polygons.
    Overlay,
}

impl Layer {
    /// All layers, in the order in which they are written.
    pub const ALL: [Self; 10] = [
        Self::Lanes,
        Self::CenterLines,
        Self::Borders,
        Self::StopLines,
        Self::Crosswalks,
        Self::Signals,
        Self::Objects,
        Self::Edges,
        Self::Findings,
        Self::Overlay,
    ];

    /// What files and the command line call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lanes => "lanes",
            Self::CenterLines => "center_lines",
            Self::Borders => "borders",
            Self::StopLines => "stop_lines",
            Self::Crosswalks => "crosswalks",
            Self::Signals => "signals",
            Self::Objects => "objects",
            Self::Edges => "edges",
            Self::Findings => "findings",
            Self::Overlay => "overlay",
        }
    }

    /// What it is, in a few words.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Lanes => "Lanes as polygons",
            Self::CenterLines => "Centre lines of lanes, in driving direction",
            Self::Borders => "Borders of lanes, cut where their road mark changes",
            Self::StopLines => "Lines across a lane where its traffic stops or yields",
            Self::Crosswalks => "Crosswalks and bicycle crossings",
            Self::Signals => "Signals as points",
            Self::Objects => "Objects, outline by outline",
            Self::Edges => "Edges of the lane graph",
            Self::Findings => "Parts of the file that are in quarantine, as boxes",
            Self::Overlay => "What is laid over a live map now, as polygons",
        }
    }

    /// Its columns. One of the same name in another layer is of the same kind.
    pub(super) fn columns(self) -> &'static [Column] {
        match self {
            Self::Lanes => lanes::AREA_COLUMNS,
            Self::CenterLines => lanes::LINE_COLUMNS,
            Self::Borders => lines::BORDER_COLUMNS,
            Self::StopLines => lines::STOP_COLUMNS,
            Self::Crosswalks => things::CROSSWALK_COLUMNS,
            Self::Signals => things::SIGNAL_COLUMNS,
            Self::Objects => things::OBJECT_COLUMNS,
            Self::Edges => edges::COLUMNS,
            Self::Findings => findings::COLUMNS,
            Self::Overlay => overlay::COLUMNS,
        }
    }

    /// What its shapes are; none where they are not all of one kind.
    #[cfg(feature = "flatgeobuf")]
    pub(super) fn shapes(self) -> Option<ShapeKind> {
        match self {
            Self::Lanes | Self::Findings | Self::Overlay => Some(ShapeKind::Polygon),
            Self::CenterLines | Self::Borders | Self::StopLines | Self::Edges => {
                Some(ShapeKind::Line)
            }
            Self::Signals => Some(ShapeKind::Point),
            Self::Crosswalks | Self::Objects => None,
        }
    }

    /// Hands over all features, in the order of the map's own lists.
    ///
    /// Errors: the first that `sink` gives.
    pub(super) fn visit(self, view: View<'_>, sink: &mut Sink<'_>) -> Result<()> {
        let map = view.map();
        match self {
            Self::Lanes => lanes::areas(map, sink),
            Self::CenterLines => lanes::center_lines(map, sink),
            Self::Borders => lines::borders(map, sink),
            Self::StopLines => lines::stop_lines(map, sink),
            Self::Crosswalks => things::crosswalks(map, sink),
            Self::Signals => things::signals(map, sink),
            Self::Objects => things::objects(map, sink),
            Self::Edges => edges::edges(map, sink),
            Self::Findings => findings::findings(map, sink),
            Self::Overlay => overlay::stretches(view, sink),
        }
    }
}

/// The layers that are written where these are asked for: each once, in the order of all; where none is, all.
pub(super) fn wanted(layers: &[Layer]) -> Vec<Layer> {
    let is_wanted = |layer: &Layer| layers.is_empty() || layers.contains(layer);
    Layer::ALL.into_iter().filter(is_wanted).collect()
}

/// Takes a feature: its shape, and one value for each column of its layer.
pub(super) type Sink<'s> = dyn FnMut(Shape, &[Value<'_>]) -> Result<()> + 's;

/// Name and kind of a column.
pub(super) type Column = (&'static str, Kind);

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// UTF-8, verbatim where it is the file's.
    Text,
    /// A whole number.
    Whole,
    /// A number in the unit that the column's name ends with.
    Number,
    /// Yes or no.
    Flag,
}

/// A value of a feature.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value<'a> {
    /// Not known, or there is none.
    None,
    /// Of [`Kind::Text`].
    Text(Cow<'a, str>),
    /// Of [`Kind::Whole`].
    Whole(i64),
    /// Of [`Kind::Number`]; finite.
    Number(f64),
    /// Of [`Kind::Flag`].
    Flag(bool),
}

impl<'a> From<&'a str> for Value<'a> {
    fn from(text: &'a str) -> Self {
        Self::Text(Cow::Borrowed(text))
    }
}

impl From<String> for Value<'_> {
    fn from(text: String) -> Self {
        Self::Text(Cow::Owned(text))
    }
}

impl From<i32> for Value<'_> {
    fn from(number: i32) -> Self {
        Self::Whole(number.into())
    }
}

impl From<u32> for Value<'_> {
    fn from(number: u32) -> Self {
        Self::Whole(number.into())
    }
}

/// What is not finite is no value: no file format of these has a place for it.
impl From<f64> for Value<'_> {
    fn from(number: f64) -> Self {
        if number.is_finite() { Self::Number(number) } else { Self::None }
    }
}

impl From<bool> for Value<'_> {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl<'a, T: Into<Value<'a>>> From<Option<T>> for Value<'a> {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}

/// Kind of a [`Shape`] that has a place.
#[cfg(feature = "flatgeobuf")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShapeKind {
    /// A point.
    Point,
    /// A line.
    Line,
    /// A polygon.
    Polygon,
}

/// A shape in the map's frame `[m]`.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// The place is not known.
    Nowhere,
    /// A point.
    Point(DVec3),
    /// At least two points.
    Line(Vec<DVec3>),
    /// Corners of an area, at least three, the first one not repeated.
    Polygon(Vec<DVec3>),
}

impl Shape {
    /// A line; where there is but one point that, where there is none nothing.
    fn line(points: Vec<DVec3>) -> Self {
        match points[..] {
            [] => Self::Nowhere,
            [one] => Self::Point(one),
            _ => Self::Line(points),
        }
    }

    /// An area; what has too few corners as [`Shape::line`].
    fn polygon(points: Vec<DVec3>) -> Self {
        if points.len() < 3 { Self::line(points) } else { Self::Polygon(points) }
    }

    /// Its points in order.
    pub(super) fn points(&self) -> &[DVec3] {
        match self {
            Self::Nowhere => &[],
            Self::Point(point) => std::slice::from_ref(point),
            Self::Line(points) | Self::Polygon(points) => points,
        }
    }
}

/// All lane sections, those of temporary lanes behind the others of their road.
fn sections<'a>(map: Map<'a>) -> impl Iterator<Item = LaneSection<'a>> {
    map.roads().flat_map(|road| road.sections().chain(road.temporary_sections()))
}

/// All lanes but lane 0, temporary ones among them.
fn lanes<'a>(map: Map<'a>) -> impl Iterator<Item = Lane<'a>> {
    sections(map).flat_map(|section| section.lanes()).filter(|lane| lane.number() != 0)
}

/// Values that name a lane: key, road, number of the section, number of the lane.
fn named<'a>(lane: &Lane<'a>) -> [Value<'a>; 4] {
    let key = lane.key();
    let text = key.to_string();
    [text.into(), lane.road().id().into(), key.section.into(), lane.number().into()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn a_column_is_of_one_kind_wherever_it_stands_and_on_the_page() {
        let page = include_str!("../../../../docs/export.md");
        let mut kinds = BTreeMap::new();
        for layer in Layer::ALL {
            assert!(page.contains(&format!("| `{}` |", layer.name())), "{}", layer.name());
            for (name, kind) in layer.columns() {
                assert_eq!(*kinds.entry(*name).or_insert(*kind), *kind, "{name}");
                assert!(page.contains(&format!("`{name}`")), "{name} is not on the page");
            }
        }
    }
}
