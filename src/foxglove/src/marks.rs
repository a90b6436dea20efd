//! Road marks as lines, broken as they are painted.

use crate::scene::{Frame, color, entity};
use foxglove::messages::{
    Color, LinePrimitive, SceneEntity, Timestamp, line_primitive::Type as LineType,
};
use mapd_client::glam::DVec3;
use mapd_client::vocabulary::RoadMarkColor;
use mapd_client::{Map, Road};
use mapd_web::MarkStroke;

/// How far marks lie above the road, so that they are seen `[m]`.
const ABOVE: f64 = 0.02;
/// Shortest dash and gap that are drawn one by one: shorter ones would be nothing but points of a file `[m]`.
const SHORTEST: f64 = 0.05;

/// An entity for each road that has marks.
pub(crate) fn entities(map: Map<'_>, frame: &Frame, stamp: Option<Timestamp>) -> Vec<SceneEntity> {
    map.roads().filter_map(|road| of_road(&road, frame, stamp)).collect()
}

fn of_road(road: &Road<'_>, frame: &Frame, stamp: Option<Timestamp>) -> Option<SceneEntity> {
    // Lines of one colour and width are one primitive.
    let mut lines: Vec<(RoadMarkColor, LinePrimitive)> = Vec::new();
    for lane in road.sections().flat_map(|section| section.lanes()) {
        for mark in lane.road_marks() {
            for mut stroke in MarkStroke::of(&mark, lane.number()) {
                let is_same = |(color, line): &(RoadMarkColor, LinePrimitive)| {
                    *color == stroke.color && line.thickness == stroke.width
                };
                let at = match lines.iter().position(is_same) {
                    Some(at) => at,
                    None => {
                        lines.push((stroke.color, line(stroke.color, stroke.width)));
                        lines.len() - 1
                    }
                };
                let Some((_, to)) = lines.get_mut(at) else { continue };
                let dashes = stroke.extent.dashes;
                stroke.extent.dashes = dashes.filter(|[dash, gap]| dash.min(*gap) >= SHORTEST);
                let above = DVec3::new(0.0, 0.0, ABOVE);
                for dash in stroke.painted(&stroke.line(&lane, &mark)) {
                    for pair in dash.windows(2) {
                        to.points.extend(pair.iter().map(|point| frame.point(*point + above)));
                    }
                }
            }
        }
    }
    lines.retain(|(_, line)| !line.points.is_empty());
    let mut entity = entity(format!("marks {}", road.id()), stamp, &[("road", road.id())]);
    entity.lines = lines.into_iter().map(|(_, line)| line).collect();
    (!entity.lines.is_empty()).then_some(entity)
}

fn line(of: RoadMarkColor, width: f64) -> LinePrimitive {
    LinePrimitive {
        r#type: LineType::LineList as i32,
        thickness: width,
        color: Some(paint(of)),
        ..LinePrimitive::default()
    }
}

fn paint(of: RoadMarkColor) -> Color {
    let rgb = match of {
        RoadMarkColor::Blue => 0x3f_86f0,
        RoadMarkColor::Green => 0x35_b567,
        RoadMarkColor::Red => 0xe0_453c,
        RoadMarkColor::Yellow => 0xff_d21f,
        RoadMarkColor::Black => 0x11_1111,
        RoadMarkColor::Orange => 0xf0_8a1d,
        RoadMarkColor::Violet => 0x9a_5ad6,
        _ => 0xff_ffff,
    };
    color(rgb, 1.0)
}
