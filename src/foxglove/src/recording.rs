//! The file: each part of the map once, on a topic of its own.

use crate::scene::{Frame, MIDDLE};
use crate::{lanes, marks, signals};
use anyhow::Result;
use foxglove::messages::{
    FrameTransform, LocationFix, Quaternion, SceneUpdate, Timestamp, Vector3,
};
use foxglove::{Channel, Context, Encode, PartialMetadata};
use mapd_client::Map;
use std::io::Cursor;
use std::sync::Arc;

/// A map as MCAP.
pub(crate) struct Recording {
    /// The file.
    pub(crate) bytes: Vec<u8>,
    /// Whether it says where on Earth the map is.
    pub(crate) has_place: bool,
}

/// Writes channels.
struct Writer {
    context: Arc<Context>,
    time: Timestamp,
}

impl Writer {
    fn log<T: Encode>(&self, topic: &str, message: &T) {
        let channel: Channel<T> = self.context.channel_builder(topic).build();
        let log_time = Some(self.time.total_nanos());
        channel.log_with_meta(message, PartialMetadata { log_time });
    }
}

/// The whole map, at one time. `doing` is told which part comes next.
///
/// Errors: the file cannot be encoded.
pub(crate) fn of(
    map: Map<'_>,
    time: Timestamp,
    doing: &mut dyn FnMut(&'static str),
) -> Result<Recording> {
    let context = Context::new();
    let file = context.mcap_writer().create(Cursor::new(Vec::new()))?;
    let writer = Writer { context, time };
    let stamp = Some(time);
    let frame = Frame::of(map);
    let middle = frame.middle();
    writer.log(
        "/tf",
        &FrameTransform {
            timestamp: stamp,
            parent_frame_id: "map".to_owned(),
            child_frame_id: MIDDLE.to_owned(),
            translation: Some(Vector3 { x: middle.x, y: middle.y, z: middle.z }),
            rotation: Some(Quaternion { x: 0.0, y: 0.0, z: 0.0, w: 1.0 }),
        },
    );
    let place = map.projector().ok().and_then(|projector| projector.to_geodetic(middle).ok());
    if let Some(place) = &place {
        let fix = LocationFix {
            timestamp: stamp,
            frame_id: MIDDLE.to_owned(),
            latitude: place.latitude,
            longitude: place.longitude,
            altitude: place.altitude,
            ..LocationFix::default()
        };
        writer.log("/map/location", &fix);
    }
    let update = |entities| SceneUpdate { deletions: Vec::new(), entities };
    doing("lanes");
    writer.log("/map/lanes", &update(lanes::entities(map, &frame, stamp)));
    doing("road marks");
    writer.log("/map/marks", &update(marks::entities(map, &frame, stamp)));
    doing("signals");
    writer.log("/map/signals", &update(signals::entities(map, &frame, stamp)));
    let bytes = file.close()?.into_inner();
    Ok(Recording { bytes, has_place: place.is_some() })
}
