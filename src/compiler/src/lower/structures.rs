//! Bridges, tunnels and references to objects as written.

use super::need::{ElementContext, ElementPath};
use super::objects::{lanes, orientation};
use crate::draft::Draft;
use crate::draft::single;
use crate::draft::{Reference, Structure};
use mapd_archive::{NONE, ObjectReferenceRow, Range, StructureRow};
use mapd_xodr::{self as xodr, Attribute, Finding, Position, Span, Text as _, Value as _};

/// In the rows of structures: not given.
const NOT_GIVEN: f32 = -1.0;

impl Draft {
    /// Takes the references of a road to objects. One without a place or the id of an object is an error of its
    /// own.
    pub(super) fn references(
        &mut self,
        road: u32,
        references: &[xodr::ObjectReference],
        base: &str,
        findings: &mut Vec<Finding>,
    ) {
        for reference in references {
            let path = ElementPath::new(base, "objectReference");
            let mut part = ElementContext { span: reference.span, path, findings };
            let place = [("s", &reference.s), ("t", &reference.t)]
                .map(|(name, at)| part.need_along(at.value(), name));
            let id = part.need(reference.id.as_ref(), "id");
            let ([Some(s), Some(t)], Some(_)) = (place, id) else { continue };
            let row = ObjectReferenceRow {
                s,
                t,
                road,
                object: NONE,
                id: self.strings.add(reference.id.text()),
                validities: Range::default(),
                z_offset: single(reference.z_offset.value().unwrap_or(0.0)),
                valid_length: single(reference.valid_length.value().unwrap_or(0.0)).max(0.0),
                orientation: orientation(reference.orientation.value()).code(),
                reserved: [0; 3],
            };
            let validities = lanes(&reference.validity);
            self.objects.references.push(Reference { row, validities });
        }
    }

    /// Takes the bridges and tunnels of a road. One without a place is an error of its own.
    pub(super) fn structures(
        &mut self,
        road: u32,
        objects: &xodr::Objects,
        base: &str,
        position: impl Fn(Span) -> Position,
        findings: &mut Vec<Finding>,
    ) {
        for bridge in &objects.bridge {
            let part = ElementContext {
                span: bridge.span,
                path: ElementPath::new(base, "bridge"),
                findings,
            };
            let place = (&bridge.s, &bridge.length);
            let Some(mut row) = structure(road, place, position(bridge.span), part) else {
                continue;
            };
            row.id = self.strings.add(bridge.id.text());
            row.name = self.strings.add(bridge.name.text());
            let material = bridge.r#type.value().map_or("", xodr::BridgeType::name);
            row.material = self.strings.add(material);
            let validities = lanes(&bridge.validity);
            self.objects.structures.push(Structure { row, validities });
        }
        for tunnel in &objects.tunnel {
            let part = ElementContext {
                span: tunnel.span,
                path: ElementPath::new(base, "tunnel"),
                findings,
            };
            let place = (&tunnel.s, &tunnel.length);
            let Some(mut row) = structure(road, place, position(tunnel.span), part) else {
                continue;
            };
            row.id = self.strings.add(tunnel.id.text());
            row.name = self.strings.add(tunnel.name.text());
            let material = tunnel.r#type.value().map_or("", xodr::TunnelType::name);
            row.material = self.strings.add(material);
            row.lighting = tunnel.lighting.value().map_or(NOT_GIVEN, single);
            row.daylight = tunnel.daylight.value().map_or(NOT_GIVEN, single);
            row.kind = 1;
            let validities = lanes(&tunnel.validity);
            self.objects.structures.push(Structure { row, validities });
        }
    }
}

/// A bridge without its texts.
fn structure(
    road: u32,
    (s, length): (&Option<Attribute<f64>>, &Option<Attribute<f64>>),
    at: Position,
    mut part: ElementContext<'_>,
) -> Option<StructureRow> {
    let s = part.need_along(s.value(), "s");
    let length = part.need_along(length.value(), "length");
    Some(StructureRow {
        s: s?,
        length: length?.max(0.0),
        road,
        id: 0,
        name: 0,
        material: 0,
        validities: Range::default(),
        lighting: NOT_GIVEN,
        daylight: NOT_GIVEN,
        line: at.line,
        column: at.column,
        kind: 0,
        reserved: [0; 7],
    })
}
