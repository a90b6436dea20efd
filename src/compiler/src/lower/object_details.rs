//! Markings, borders, skeletons, materials and parking of objects as written.

use super::need::ElementContext;
use super::objects::left_out;
use crate::draft::Draft;
use crate::draft::single;
use crate::draft::{Border, Corner, Details, Marking, Outline, OutlineCorners, Vertex};
use mapd_archive::{
    NONE, ObjectBorderRow, ObjectMarkingRow, ObjectMaterialRow, ParkingSpaceRow, Range,
};
use mapd_rules::catalog::building;
use mapd_xodr::{
    self as xodr, Attribute, ParkingSpaceMarkingSide, Severity, SideType, Text as _, Value as _,
};

/// In the rows of materials: not given.
const NOT_GIVEN: f32 = -1.0;

impl Draft {
    /// What is written in an object besides its place and shape; none where there is nothing.
    pub(super) fn details(
        &mut self,
        object: &xodr::Object,
        outlines: &[Outline],
        part: &mut ElementContext<'_>,
    ) -> Option<Box<Details>> {
        if let Some(crg) = object.surface.as_deref().and_then(|surface| surface.crg.as_deref()) {
            let message =
                format!("the OpenCRG file {:?} is not built into the object", crg.file.text());
            part.add(&building::UNSUPPORTED, Severity::Info, message);
        }
        let has_any = object.markings.is_some()
            || object.borders.is_some()
            || object.skeleton.is_some()
            || object.parking_space.is_some()
            || !object.material.is_empty()
            || object.outlines.iter().flat_map(|o| &o.outline).any(|o| o.markings.is_some());
        if !has_any {
            return None;
        }
        let mut details = Details::default();
        for marking in object.markings.iter().flat_map(|markings| &markings.marking) {
            let marking = self.marking(marking, None);
            details.markings.push(marking);
        }
        let written = object.outline.as_deref().into_iter();
        let written = written.chain(object.outlines.iter().flat_map(|outlines| &outlines.outline));
        for (number, outline) in written.enumerate() {
            let kept = outlines.iter().position(|kept| kept.number == number);
            for marking in outline.markings.iter().flat_map(|markings| &markings.marking) {
                let marking = self.marking(marking, kept);
                details.markings.push(marking);
            }
        }
        for border in object.borders.iter().flat_map(|borders| &borders.border) {
            let border = self.border(border, outlines);
            details.borders.push(border);
        }
        for line in object.skeleton.iter().flat_map(|skeleton| &skeleton.polyline) {
            let vertices = vertices(line);
            match vertices.len() {
                0 | 1 => left_out(
                    part,
                    "a line of the skeleton has no two vertices; it is left out".into(),
                ),
                _ => details.skeletons.push(vertices),
            }
        }
        for material in &object.material {
            let color = material.road_mark_color.value().map_or("", xodr::RoadMarkColor::name);
            let number = |n: Option<f64>| n.filter(|n| *n >= 0.0).map_or(NOT_GIVEN, single);
            details.materials.push(ObjectMaterialRow {
                object: 0,
                surface: self.strings.add(material.surface.text()),
                color: self.strings.add(color),
                friction: number(material.friction.value()),
                roughness: number(material.roughness.value()),
            });
        }
        if let Some(parking) = object.parking_space.as_deref() {
            let access = parking.access.value().map_or("", xodr::ParkingSpaceAccess::name);
            details.parking = Some(ParkingSpaceRow {
                object: 0,
                restrictions: self.strings.add(parking.restrictions.text()),
                access: self.strings.add(access),
            });
            for marking in &parking.marking {
                let marking = self.parking_marking(marking);
                details.markings.push(marking);
            }
        }
        Some(Box::new(details))
    }

    fn marking(&mut self, marking: &xodr::Marking, outline: Option<usize>) -> Marking {
        let number = |attribute: &Option<Attribute<f64>>| single(attribute.value().unwrap_or(0.0));
        let row = ObjectMarkingRow {
            object: 0,
            outline: NONE,
            corners: Range::default(),
            color: self.strings.add(marking.color.value().map_or("", xodr::RoadMarkColor::name)),
            weight: self.strings.add(marking.weight.value().map_or("", xodr::RoadMarkWeight::name)),
            kind: self.strings.add(""),
            width: number(&marking.width),
            z_offset: number(&marking.z_offset),
            line_length: number(&marking.line_length),
            space_length: number(&marking.space_length),
            start_offset: number(&marking.start_offset),
            stop_offset: number(&marking.stop_offset),
            side: match marking.side.value() {
                Some(SideType::Left) => 1,
                Some(SideType::Right) => 2,
                Some(SideType::Front) => 3,
                Some(SideType::Rear) => 4,
                _ => 0,
            },
            reserved: [0; 3],
        };
        Marking {
            row,
            along: OutlineCorners { outline, corners: corners(&marking.corner_reference) },
        }
    }

    /// The marking of a parking space's side in OpenDRIVE 1.4.
    fn parking_marking(&mut self, marking: &xodr::ParkingSpaceMarking) -> Marking {
        let row = ObjectMarkingRow {
            object: 0,
            outline: NONE,
            corners: Range::default(),
            color: self.strings.add(marking.color.value().map_or("", xodr::RoadMarkColor::name)),
            weight: self.strings.add(""),
            kind: self.strings.add(marking.r#type.value().map_or("", xodr::RoadMarkType::name)),
            width: single(marking.width.value().unwrap_or(0.0)),
            z_offset: 0.0,
            line_length: 0.0,
            space_length: 0.0,
            start_offset: 0.0,
            stop_offset: 0.0,
            side: match marking.side.value() {
                Some(ParkingSpaceMarkingSide::Left) => 1,
                Some(ParkingSpaceMarkingSide::Right) => 2,
                Some(ParkingSpaceMarkingSide::Front) => 3,
                Some(ParkingSpaceMarkingSide::Rear) => 4,
                _ => 0,
            },
            reserved: [0; 3],
        };
        Marking { row, along: OutlineCorners::default() }
    }

    /// A border; a rule says where its outline is none of the object's.
    fn border(&mut self, border: &xodr::ObjectBorder, outlines: &[Outline]) -> Border {
        let meant = border.outline_id.value();
        let outline = meant.and_then(|id| outlines.iter().position(|outline| outline.row.id == id));
        let row = ObjectBorderRow {
            object: 0,
            outline: NONE,
            corners: Range::default(),
            kind: self.strings.add(border.r#type.value().map_or("", xodr::BorderType::name)),
            width: single(border.width.value().unwrap_or(0.0)),
        };
        let is_whole = border.use_complete_outline.value() == Some(true);
        let corners = if is_whole { Vec::new() } else { corners(&border.corner_reference) };
        Border { row, along: OutlineCorners { outline, corners } }
    }
}

fn corners(references: &[xodr::CornerReference]) -> Vec<u32> {
    references.iter().filter_map(|reference| reference.id.value()).collect()
}

/// Vertices of a line; one without a place is left out with it, which a rule says.
fn vertices(line: &xodr::Polyline) -> Vec<Vertex> {
    let place = |at: [&Option<Attribute<f64>>; 3]| {
        Some([at[0].value()?, at[1].value()?, at[2].value().unwrap_or(0.0), 0.0])
    };
    let vertex = |corner: Corner, radius: Option<f64>, ground: Option<bool>| Vertex {
        corner,
        radius: radius.unwrap_or(0.0),
        is_on_ground: ground == Some(true),
    };
    let on_road = line.vertex_road.iter().filter_map(|v| {
        let corner = Corner::Road(place([&v.s, &v.t, &v.dz])?);
        Some(vertex(corner, v.radius.value(), v.intersection_point.value()))
    });
    let local = line.vertex_local.iter().filter_map(|v| {
        let corner = Corner::Local(place([&v.u, &v.v, &v.z])?);
        Some(vertex(corner, v.radius.value(), v.intersection_point.value()))
    });
    on_road.chain(local).collect()
}
