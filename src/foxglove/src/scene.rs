//! What all parts of the scene share: the frame, colours, entities.

use foxglove::messages::{Color, KeyValuePair, Point3, SceneEntity, Timestamp};
use mapd_client::Map;
use mapd_client::glam::DVec3;

/// The frame of all shapes: that of the map, moved to its middle, so that viewers with single precision are exact to a millimetre.
pub(crate) const MIDDLE: &str = "map_middle";

/// The frame of shapes.
pub(crate) struct Frame {
    middle: DVec3,
}

impl Frame {
    /// Whole metres near the middle of the map in plan view, at its lowest height.
    pub(crate) fn of(map: Map<'_>) -> Self {
        let bounds = map.bounds();
        let middle = 0.5 * (bounds.low + bounds.high);
        let middle = DVec3::new(middle.x, middle.y, bounds.low.z).round();
        // Of a map without points there is none.
        Self { middle: if middle.is_finite() { middle } else { DVec3::ZERO } }
    }

    /// Its origin in the map's frame `[m]`.
    pub(crate) fn middle(&self) -> DVec3 {
        self.middle
    }

    /// A point of the map in the frame `[m]`.
    pub(crate) fn point(&self, point: DVec3) -> Point3 {
        let DVec3 { x, y, z } = point - self.middle;
        Point3 { x, y, z }
    }
}

/// A colour, of six hexadecimal digits.
pub(crate) fn color(rgb: u32, alpha: f64) -> Color {
    let part = |shift: u32| f64::from(rgb >> shift & 0xff) / 255.0;
    Color { r: part(16), g: part(8), b: part(0), a: alpha }
}

/// An entity without shapes, which stays until another one replaces it, with what a click on it shows.
pub(crate) fn entity(
    id: String,
    timestamp: Option<Timestamp>,
    metadata: &[(&str, &str)],
) -> SceneEntity {
    let given = metadata.iter().filter(|(_, value)| !value.is_empty());
    let pair =
        |(key, value): &(&str, &str)| KeyValuePair { key: (*key).into(), value: (*value).into() };
    SceneEntity {
        timestamp,
        frame_id: MIDDLE.to_owned(),
        id,
        metadata: given.map(pair).collect(),
        ..SceneEntity::default()
    }
}
