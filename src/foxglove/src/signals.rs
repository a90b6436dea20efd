//! Signals: a board of their size where they stand, an arrow that shows where they face, what they mean.

use crate::scene::{Frame, color, entity};
use foxglove::messages::{
    ArrowPrimitive, CubePrimitive, Pose, Quaternion, SceneEntity, TextPrimitive, Timestamp, Vector3,
};
use mapd_client::Map;
use mapd_client::glam::DVec3;
use mapd_client::signals::Signal;
use mapd_web::SignalSign;

/// Thickness of a board, its width and height where the file gives none `[m]`.
const BOARD: [f64; 3] = [0.1, 0.6, 0.6];
/// Length of an arrow `[m]`.
const ARROW: f64 = 1.5;
/// Size of text `[px]`.
const TEXT: f64 = 12.0;

/// An entity for each signal.
pub(crate) fn entities(map: Map<'_>, frame: &Frame, stamp: Option<Timestamp>) -> Vec<SceneEntity> {
    map.signals().map(|signal| of(&signal, frame, stamp)).collect()
}

fn of(signal: &Signal<'_>, frame: &Frame, stamp: Option<Timestamp>) -> SceneEntity {
    let code = signal.code().join(" ");
    let road = signal.road();
    let value = signal.written_value().map(|one| format!("{} {}", one.value, one.unit));
    let value = value.unwrap_or_default();
    let mut entity = entity(
        format!("signal {}", signal.id()),
        stamp,
        &[
            ("signal", signal.id()),
            ("class", signal.class().name()),
            ("name", signal.name()),
            ("code", code.trim()),
            ("value", value.trim()),
            ("road", road.as_ref().map_or("", |road| road.id())),
        ],
    );
    let [width, height, _] = signal.size();
    let given = |size: Option<f64>, or: f64| size.filter(|size| *size > 0.0).unwrap_or(or);
    let size = [BOARD[0], given(width, BOARD[1]), given(height, BOARD[2])];
    let middle = signal.position() + DVec3::new(0.0, 0.0, 0.5 * size[2]);
    let (sin, cos) = libm::sincos(0.5 * signal.facing());
    let position = frame.point(middle);
    let position = Vector3 { x: position.x, y: position.y, z: position.z };
    let turn = Quaternion { x: 0.0, y: 0.0, z: sin, w: cos };
    let pose = || Some(Pose { position: Some(position), orientation: Some(turn) });
    let paint = color(
        match SignalSign::of(signal) {
            SignalSign::Light => 0x20_2428,
            SignalSign::Stop | SignalSign::Yield | SignalSign::Ban => 0xcc_211f,
            SignalSign::Speed | SignalSign::Warning => 0xe8_5a4f,
            SignalSign::Priority => 0xff_c71a,
            SignalSign::Direction | SignalSign::Information => 0x0f_5cb8,
            _ => 0x9a_a2ab,
        },
        1.0,
    );
    let [x, y, z] = size;
    entity.cubes.push(CubePrimitive {
        pose: pose(),
        size: Some(Vector3 { x, y, z }),
        color: Some(paint),
    });
    entity.arrows.push(ArrowPrimitive {
        pose: pose(),
        shaft_length: 0.7 * ARROW,
        shaft_diameter: 0.08,
        head_length: 0.3 * ARROW,
        head_diameter: 0.2,
        color: Some(paint),
    });
    let text = [signal.class().name(), value.trim()].join(" ");
    entity.texts.push(TextPrimitive {
        pose: pose(),
        billboard: true,
        font_size: TEXT,
        scale_invariant: true,
        color: Some(color(0xff_ffff, 1.0)),
        text: text.trim().to_owned(),
    });
    entity
}
