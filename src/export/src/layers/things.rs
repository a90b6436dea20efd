//! Signals and objects, crosswalks among them.

use super::lines::{across, source};
use super::{Column, Kind, Shape, Sink, Value, lanes};
use crate::Result;
use mapd_client::Map;
use mapd_client::glam::DVec3;
use mapd_client::objects::{Object, ObjectPlacement};
use mapd_client::rules::LineSource;
use mapd_client::vocabulary::{Class, ObjectShape};

pub(super) const SIGNAL_COLUMNS: &[Column] = &[
    ("id", Kind::Text),
    ("name", Kind::Text),
    ("class", Kind::Text),
    ("country", Kind::Text),
    ("country_revision", Kind::Text),
    ("code", Kind::Text),
    ("subcode", Kind::Text),
    ("text", Kind::Text),
    ("value_si", Kind::Number),
    ("written_value", Kind::Number),
    ("written_unit", Kind::Text),
    ("road", Kind::Text),
    ("s_m", Kind::Number),
    ("t_m", Kind::Number),
    ("orientation", Kind::Text),
    ("facing_rad", Kind::Number),
    ("width_m", Kind::Number),
    ("height_m", Kind::Number),
    ("is_dynamic", Kind::Flag),
    ("is_temporary", Kind::Flag),
    ("line", Kind::Whole),
];

pub(super) const OBJECT_COLUMNS: &[Column] = &[
    ("id", Kind::Text),
    ("name", Kind::Text),
    ("class", Kind::Text),
    ("code", Kind::Text),
    ("subcode", Kind::Text),
    ("road", Kind::Text),
    ("junction", Kind::Text),
    ("placement", Kind::Whole),
    ("outline", Kind::Whole),
    ("is_hole", Kind::Flag),
    ("s_m", Kind::Number),
    ("t_m", Kind::Number),
    ("heading_rad", Kind::Number),
    ("length_m", Kind::Number),
    ("width_m", Kind::Number),
    ("height_m", Kind::Number),
    ("radius_m", Kind::Number),
    ("is_dynamic", Kind::Flag),
    ("is_temporary", Kind::Flag),
    ("line", Kind::Whole),
];

pub(super) const CROSSWALK_COLUMNS: &[Column] = &[
    ("source", Kind::Text),
    ("id", Kind::Text),
    ("class", Kind::Text),
    ("lanes", Kind::Text),
    ("is_hole", Kind::Flag),
];

/// One point for each signal.
pub(super) fn signals(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for signal in map.signals() {
        let [country, revision, code, subcode] = signal.code();
        let ([s, t, ..], [width, height, _]) = (signal.track(), signal.size());
        let written = signal.written_value();
        let values = [
            signal.id().into(),
            signal.name().into(),
            signal.class().name().into(),
            country.into(),
            revision.into(),
            code.into(),
            subcode.into(),
            signal.shown_text().into(),
            signal.value().into(),
            written.map(|written| written.value).into(),
            written.map(|written| written.unit).into(),
            signal.road().map(|road| road.id()).into(),
            s.into(),
            t.into(),
            signal.orientation().name().into(),
            signal.facing().into(),
            width.into(),
            height.into(),
            signal.is_dynamic().into(),
            signal.is_temporary().into(),
            signal.source_position().line.into(),
        ];
        sink(Shape::Point(signal.position()), &values)?;
    }
    Ok(())
}

/// What an object covers where it stands, outline by outline: the outline's number, whether it is a hole, and its shape.
fn shapes(
    place: &ObjectPlacement<'_>,
    corners: &mut Vec<DVec3>,
    mut each: impl FnMut(Option<u32>, bool, Shape) -> Result<()>,
) -> Result<()> {
    if place.shape() != ObjectShape::Outlines {
        place.footprint(corners);
        return each(None, false, Shape::polygon(corners.clone()));
    }
    for (number, outline) in place.outlines().enumerate() {
        let points = outline.positions().collect();
        let shape = if outline.is_closed() { Shape::polygon(points) } else { Shape::line(points) };
        each(Some(number as u32), !outline.is_outer(), shape)?;
    }
    Ok(())
}

/// Every place of every object.
pub(super) fn objects(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    let mut corners = Vec::new();
    for object in map.objects() {
        for (number, place) in object.placements().enumerate() {
            shapes(&place, &mut corners, |outline, is_hole, shape| {
                let values = [
                    object.id().into(),
                    object.name().into(),
                    object.class().name().into(),
                    object.type_name().into(),
                    object.subtype().into(),
                    object.road().map(|road| road.id()).into(),
                    object.junction().map(|junction| junction.id()).into(),
                    (number as u32).into(),
                    outline.into(),
                    is_hole.into(),
                    place.s().into(),
                    place.t().into(),
                    place.angles()[0].into(),
                    given(place.length()),
                    given(place.width()),
                    given(place.height()),
                    given(place.radius()),
                    object.is_dynamic().into(),
                    object.is_temporary().into(),
                    object.source_position().line.into(),
                ];
                sink(shape, &values)
            })?;
        }
    }
    Ok(())
}

/// A size, which is 0 where the file gives none.
fn given(size: f64) -> Value<'static> {
    Some(size).filter(|size| *size > 0.0).into()
}

/// Objects that are crosswalks or bicycle crossings as they lie; of signals that say so, a line across each lane.
pub(super) fn crosswalks(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    let is_crossing =
        |object: &Object<'_>| matches!(object.class(), Class::Crosswalk | Class::BicycleCrossing);
    let mut corners = Vec::new();
    for object in map.objects().filter(is_crossing) {
        let lanes = object.lanes().filter_map(|one| one.lane());
        let keys: Vec<String> = lanes.map(|lane| lane.key().to_string()).collect();
        let keys = keys.join(",");
        for place in object.placements() {
            shapes(&place, &mut corners, |_, is_hole, shape| {
                let class = object.class().name();
                let values = [
                    "object".into(),
                    object.id().into(),
                    class.into(),
                    keys.as_str().into(),
                    is_hole.into(),
                ];
                sink(shape, &values)
            })?;
        }
    }
    for lane in lanes(map) {
        let is_signal = |source: &LineSource| matches!(source, LineSource::Signal(_));
        for line in lane.crossings().filter(|line| is_signal(&line.source)) {
            let (source, id) = source(map, &line);
            let values =
                [source, id, line.class.name().into(), lane.key().to_string().into(), false.into()];
            sink(across(&lane, line.s), &values)?;
        }
    }
    Ok(())
}
