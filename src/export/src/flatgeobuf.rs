//! A map as a FlatGeobuf file: one table of all layers with an index in plan view.

use crate::earth::{self, Coordinate};
use crate::layers::{Column, Kind, Layer, Shape, ShapeKind, Value};
use crate::{ExportError, Progress, Result};
use flatgeobuf::geozero::error::Result as GeometryResult;
use flatgeobuf::geozero::{ColumnValue, GeomProcessor, PropertyProcessor};
use flatgeobuf::{ColumnType, FgbCrs, FgbWriter, FgbWriterOptions, GeometryType, GeozeroGeometry};
use mapd_client::Map;
use mapd_client::document::HeaderOffset;
use mapd_client::geodesy::{Offset, Projector};
use mapd_client::view::View;
use std::io::Write;

/// EPSG's code of latitude and longitude on WGS 84.
const WGS_84: i32 = 4326;
/// EPSG's codes of zone 0 of UTM on WGS 84, north and south.
const UTM: [i32; 2] = [32600, 32700];

/// Where shapes are written.
enum OutputFrame {
    /// In the map's own frame, which no program can place.
    Own,
    /// In the plane of the map's projection.
    Plane(Offset),
    /// As longitudes and latitudes.
    Earth(Box<Projector>),
}

/// How the frame is called.
#[derive(Debug, Default, PartialEq, Eq)]
struct Crs {
    /// EPSG's code, 0 where there is none.
    code: i32,
    /// Well-known text where there is no code.
    text: Option<String>,
}

impl OutputFrame {
    /// The frame in which a map is written: its plane where programs can place that.
    ///
    /// Errors: the map's projection cannot be used.
    fn of(map: Map<'_>) -> Result<(Self, Crs)> {
        let definition = map.projection();
        if definition.is_empty() {
            return Ok((Self::Own, Crs::default()));
        }
        Ok(match crs(definition) {
            Some(crs) => {
                let HeaderOffset { shift, heading } = map.header_offset();
                (Self::Plane(Offset { shift, heading }), crs)
            }
            None => {
                let crs = Crs { code: WGS_84, text: None };
                (Self::Earth(Box::new(earth::projector(map, None)?)), crs)
            }
        })
    }

    /// The points of a shape in the frame.
    ///
    /// Errors: a point outside the projection's area.
    fn places(&self, shape: &Shape) -> Result<Vec<Coordinate>> {
        Ok(match self {
            Self::Own => shape.points().iter().map(|point| point.to_array()).collect(),
            Self::Plane(offset) => {
                shape.points().iter().map(|point| offset.apply(*point).to_array()).collect()
            }
            Self::Earth(projector) => earth::on_earth(shape, projector)?,
        })
    }
}

/// Parameters that say of which body a plane is.
const BODY: [&str; 10] = ["datum", "ellps", "towgs84", "nadgrids", "pm", "a", "b", "R", "rf", "f"];

/// The name of the plane that PROJ parameters define; none where its coordinates are not metres, where PROJ has no such plane, or
/// where its ellipsoid is another than that of WGS 84 or GRS 80 or its datum another: that would need names of datums.
fn crs(definition: &str) -> Option<Crs> {
    let words: Vec<(&str, &str)> = definition
        .split_whitespace()
        .map(|word| word.trim_start_matches('+'))
        .map(|word| word.split_once('=').unwrap_or((word, "")))
        .collect();
    let value = |name: &str| words.iter().find(|(key, _)| *key == name).map(|(_, value)| *value);
    if value("proj") == Some("topocentric")
        || value("units").is_some_and(|unit| unit != "m")
        || value("to_meter").is_some()
    {
        return None;
    }
    let is_zero = |shift: &str| shift.split(',').all(|one| one.parse() == Ok(0.0));
    let body: Vec<_> = words
        .iter()
        .filter(|(key, value)| BODY.contains(key) && !(*key == "towgs84" && is_zero(value)))
        .collect();
    // A datum's ellipsoid may be named beside it.
    let is_wgs84 = |word: &(&str, &str)| matches!(word, ("datum" | "ellps", "WGS84"));
    let (earth, spheroid) = match body[..] {
        _ if body.iter().all(|word| is_wgs84(word)) => {
            ("WGS 84\",DATUM[\"WGS_1984", "WGS 84\",6378137,298.257223563")
        }
        [("ellps", "GRS80")] => ("GRS 80\",DATUM[\"unknown", "GRS 1980\",6378137,298.257222101"),
        _ => return None,
    };
    let is_plain = words.iter().all(|(key, _)| {
        ["proj", "zone", "south", "datum", "ellps", "units", "no_defs", "type"].contains(key)
    });
    if is_plain && value("proj") == Some("utm") && value("datum").is_some() {
        let [north, south] = UTM;
        let base = if value("south").is_some() { south } else { north };
        let zone = value("zone").and_then(|zone| zone.parse().ok());
        if let Some(zone) = zone.filter(|zone| (1..=60).contains(zone)) {
            return Some(Crs { code: base + zone, text: None });
        }
    }
    // PROJ takes the plane from the extension and the ellipsoid from the base.
    let text = format!(
        "PROJCS[\"map\",GEOGCS[\"{earth}\",SPHEROID[\"{spheroid}]],PRIMEM[\"Greenwich\",0],\
         UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"custom_proj4\"],UNIT[\"metre\",1],\
         EXTENSION[\"PROJ4\",\"{}\"]]",
        definition.replace('"', "\"\"")
    );
    Some(Crs { code: 0, text: Some(text) })
}

/// Writes the layers into one table and returns how many features were left out: those without a place, which the format
/// cannot hold.
///
/// Errors: a point outside the area of the map's projection; what writing gives.
pub(super) fn write(
    view: View<'_>,
    layers: &[Layer],
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<usize> {
    let map = view.map();
    let (frame, crs) = OutputFrame::of(map)?;
    // A table of one layer has the type of its shapes.
    let (name, only) = match layers {
        [one] => (one.name(), one.shapes()),
        _ => ("map", None),
    };
    let kept =
        |shape: &Shape| kind_of(shape).is_some_and(|kind| only.is_none_or(|only| only == kind));
    let options = FgbWriterOptions {
        detect_type: false,
        promote_to_multi: false,
        has_z: true,
        title: Some(map.name()),
        // An index of nothing is an error to those who read it.
        write_index: layers.iter().any(|layer| has_any(*layer, view, &kept)),
        crs: FgbCrs { code: crs.code, wkt: crs.text.as_deref(), ..FgbCrs::default() },
        ..FgbWriterOptions::default()
    };
    let kind = only.map_or(GeometryType::Unknown, |kind| match kind {
        ShapeKind::Point => GeometryType::Point,
        ShapeKind::Line => GeometryType::LineString,
        ShapeKind::Polygon => GeometryType::Polygon,
    });
    let mut writer = FgbWriter::create_with_options(name, kind, options).map_err(encoding)?;
    let columns = columns(layers);
    for (name, kind) in &columns {
        let kind = match kind {
            Kind::Text => ColumnType::String,
            Kind::Whole => ColumnType::Long,
            Kind::Number => ColumnType::Double,
            Kind::Flag => ColumnType::Bool,
        };
        writer.add_column(name, kind, |_, _| {});
    }
    let mut left_out = 0;
    for layer in layers {
        let mut done = 0;
        let own = layer.columns().iter();
        let place_of = |column| columns.iter().position(|there| there == column);
        let numbers: Vec<usize> = own.filter_map(place_of).collect();
        layer.visit(view, &mut |shape, values| {
            if !kept(&shape) {
                left_out += 1;
                return Ok(());
            }
            Progress::tell(layer.name(), done, progress);
            done += 1;
            let places = frame.places(&shape)?;
            let mut written = Ok(false);
            let placed = PlacedShape { shape: &shape, places: &places };
            let added = writer.add_feature_geom(placed, |row| {
                written = row.property(0, LAYER.0, &ColumnValue::String(layer.name()));
                for (number, value) in numbers.iter().zip(values) {
                    if let (Ok(_), Some(value)) = (&written, column_value(value)) {
                        written = row.property(*number, "", &value);
                    }
                }
            });
            added.map_err(|error| ExportError::Encoding(error.to_string()))?;
            written.map(drop).map_err(|error| ExportError::Encoding(error.to_string()))
        })?;
    }
    progress(Progress { doing: "the index", done: 0 });
    writer.write(out).map_err(encoding)?;
    Ok(left_out)
}

/// What the encoder says, which may be what writing gives.
fn encoding(error: flatgeobuf::Error) -> ExportError {
    match error {
        flatgeobuf::Error::IO(error) => error.into(),
        other => ExportError::Encoding(other.to_string()),
    }
}

/// Whether a layer has a feature that will be written. Looks no farther than to the first.
fn has_any(layer: Layer, view: View<'_>, kept: &dyn Fn(&Shape) -> bool) -> bool {
    let found = || Err(ExportError::Encoding(String::new()));
    layer.visit(view, &mut |shape, _| if kept(&shape) { found() } else { Ok(()) }).is_err()
}

/// The column that says which layer a feature is of.
const LAYER: Column = ("layer", Kind::Text);

/// The columns of a table of several layers: one for each name.
fn columns(layers: &[Layer]) -> Vec<Column> {
    let mut columns = vec![LAYER];
    for column in layers.iter().flat_map(|layer| layer.columns()) {
        if !columns.contains(column) {
            columns.push(*column);
        }
    }
    columns
}

fn kind_of(shape: &Shape) -> Option<ShapeKind> {
    match shape {
        Shape::Nowhere => None,
        Shape::Point(_) => Some(ShapeKind::Point),
        Shape::Line(_) => Some(ShapeKind::Line),
        Shape::Polygon(_) => Some(ShapeKind::Polygon),
    }
}

fn column_value<'a>(value: &'a Value<'_>) -> Option<ColumnValue<'a>> {
    match value {
        Value::None => None,
        Value::Text(text) => Some(ColumnValue::String(text)),
        Value::Whole(number) => Some(ColumnValue::Long(*number)),
        Value::Number(number) => Some(ColumnValue::Double(*number)),
        Value::Flag(flag) => Some(ColumnValue::Bool(*flag)),
    }
}

/// A shape with its points in the file's frame.
struct PlacedShape<'a> {
    shape: &'a Shape,
    places: &'a [Coordinate],
}

impl GeozeroGeometry for PlacedShape<'_> {
    fn process_geom<P: GeomProcessor>(&self, to: &mut P) -> GeometryResult<()> {
        let points = |to: &mut P, places: &mut dyn Iterator<Item = &Coordinate>| {
            let mut places = places.enumerate();
            places
                .try_for_each(|(i, [x, y, z])| to.coordinate(*x, *y, Some(*z), None, None, None, i))
        };
        let count = self.places.len();
        match self.shape {
            Shape::Nowhere => Ok(()),
            Shape::Point(_) => {
                to.point_begin(0)?;
                points(to, &mut self.places.iter())?;
                to.point_end(0)
            }
            Shape::Line(_) => {
                to.linestring_begin(true, count, 0)?;
                points(to, &mut self.places.iter())?;
                to.linestring_end(true, 0)
            }
            Shape::Polygon(_) => {
                to.polygon_begin(true, 1, 0)?;
                to.linestring_begin(false, count + 1, 0)?;
                points(to, &mut self.places.iter().chain(self.places.first()))?;
                to.linestring_end(false, 0)?;
                to.polygon_end(true, 0)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(cases: &[(&str, Option<i32>)]) {
        for (definition, code) in cases {
            assert_eq!(crs(definition).map(|crs| crs.code), *code, "{definition}");
        }
    }

    #[test]
    fn planes_are_called_by_what_programs_know() {
        check(&[
            ("+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs", Some(32632)),
            ("+proj=utm +zone=56 +south +datum=WGS84", Some(32756)),
            ("+proj=utm +zone=32 +ellps=GRS80 +units=m", Some(0)),
            ("+proj=utm +zone=32 +datum=WGS84 +ellps=WGS84 +units=m", Some(32632)),
            ("+proj=tmerc +lat_0=48 +lon_0=11 +datum=WGS84", Some(0)),
            ("+proj=tmerc +lat_0=48 +lon_0=11 +ellps=WGS84 +datum=WGS84", Some(0)),
            ("+proj=utm +zone=32 +datum=WGS84 +ellps=GRS80", None),
            ("+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0,0,0,0,0", Some(0)),
            ("+proj=utm +zone=32", Some(0)),
            ("+proj=utm +zone=32 +ellps=GRS80 +towgs84=598.1,73.7,418.2", None),
            ("+proj=tmerc +lat_0=48 +lon_0=11 +ellps=bessel", None),
            ("+proj=tmerc +lat_0=48 +lon_0=11 +units=us-ft", None),
            ("+proj=utm +zone=32 +datum=WGS84 +to_meter=0.3048", None),
            ("+proj=topocentric +lat_0=48 +lon_0=11 +h_0=0 +datum=WGS84", None),
        ]);
    }
}
