//! A map as one GeoJSON feature collection (RFC 7946).

use crate::earth::{self, Coordinate};
use crate::layers::{Layer, Shape, Value};
use crate::{ExportError, Progress, Result};
use geojson::{Feature, FeatureWriter, Geometry, GeometryValue, JsonObject, JsonValue, Position};
use mapd_client::geodesy::Projector;
use mapd_client::view::View;
use std::io::{self, Write};

/// Writes the layers, one after the other; each feature says its own.
///
/// Errors: a point outside the area of the map's projection; what writing gives.
pub(super) fn write(
    view: View<'_>,
    layers: &[Layer],
    projector: &Projector,
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<()> {
    let mut writer = FeatureWriter::from_writer(out);
    for layer in layers {
        let mut done = 0;
        layer.visit(view, &mut |shape, values| {
            Progress::tell(layer.name(), done, progress);
            done += 1;
            let places = earth::on_earth(&shape, projector)?;
            let mut properties = JsonObject::new();
            properties.insert("layer".to_owned(), layer.name().into());
            for ((name, _), value) in layer.columns().iter().zip(values) {
                properties.insert((*name).to_owned(), json(value));
            }
            let geometry = geometry(&shape, places).map(Geometry::new);
            let properties = Some(properties);
            let feature = Feature { geometry, properties, ..Feature::default() };
            writer.write_feature(&feature).map_err(encoding)
        })?;
    }
    writer.finish().map_err(encoding)
}

/// What the encoder says, which may be what writing gives.
fn encoding(error: geojson::Error) -> ExportError {
    match error {
        geojson::Error::Io(error) => error.into(),
        // The name is for reading; in writing it holds what the file says.
        geojson::Error::MalformedGeoJson(error) if error.is_io() => io::Error::from(error).into(),
        other => ExportError::Encoding(other.to_string()),
    }
}

fn json(value: &Value<'_>) -> JsonValue {
    match value {
        Value::None => JsonValue::Null,
        Value::Text(text) => text.as_ref().into(),
        Value::Whole(number) => (*number).into(),
        Value::Number(number) => (*number).into(),
        Value::Flag(flag) => (*flag).into(),
    }
}

/// The geometry of a shape; areas run counter-clockwise, as the RFC wants them.
fn geometry(shape: &Shape, mut places: Vec<Coordinate>) -> Option<GeometryValue> {
    let position = |place: Coordinate| Position::from(place.to_vec());
    match shape {
        Shape::Nowhere => None,
        Shape::Point(_) => Some(GeometryValue::Point { coordinates: position(*places.first()?) }),
        Shape::Line(_) => Some(GeometryValue::LineString {
            coordinates: places.into_iter().map(position).collect(),
        }),
        Shape::Polygon(_) => {
            if earth::is_clockwise(&places) {
                places.reverse();
            }
            let first = *places.first()?;
            places.push(first);
            let ring = places.into_iter().map(position).collect();
            Some(GeometryValue::Polygon { coordinates: vec![ring] })
        }
    }
}
