//! Objects as written, in numbers. They are placed when everything else is.

use super::need::{ElementContext, ElementPath};
use crate::draft::Draft;
use crate::draft::single;
use crate::draft::{Object, Repeat};
use mapd_archive::{
    AnnotationOwner, NONE, ObjectRow, ObjectShape, ObjectValueRow, Orientation, Range, object_flags,
};
use mapd_ontology::{Class, Meaning, ObjectCode, Ontology};
use mapd_rules::catalog::building;
use mapd_rules::line::ReferenceLine;
use mapd_xodr::{self as xodr, Finding, Position, Severity, Span, Text as _, Value as _};

/// What objects are written in.
#[derive(Clone, Copy)]
pub(crate) enum Owner<'a> {
    /// A road: its row and id.
    Road(u32, &'a str),
    /// A junction: its row and id.
    Junction(u32, &'a str),
}

impl Owner<'_> {
    /// Path of its objects.
    fn path(self) -> String {
        let (element, id) = match self {
            Self::Road(_, id) => ("road", id),
            Self::Junction(_, id) => ("junction", id),
        };
        ["OpenDRIVE/", element, "[@id=", id, "]/objects"].concat()
    }

    /// Rows of the road and of the junction.
    fn rows(self) -> (u32, u32) {
        match self {
            Self::Road(row, _) => (row, NONE),
            Self::Junction(row, _) => (NONE, row),
        }
    }
}

/// What objects are read with.
pub(crate) struct ObjectContext<'o, P> {
    /// What types and names mean.
    pub(crate) ontology: &'o Ontology,
    /// Line and column of a span.
    pub(crate) position: P,
}

impl Draft {
    /// Takes the objects of a road or junction. One that cannot be placed is an error of its own.
    pub(crate) fn objects(
        &mut self,
        owner: Owner<'_>,
        objects: &xodr::Objects,
        ObjectContext { ontology, position }: ObjectContext<'_, impl Fn(Span) -> Position>,
        findings: &mut Vec<Finding>,
    ) {
        // Many roads have an empty list.
        if objects.object.is_empty()
            && objects.object_reference.is_empty()
            && objects.tunnel.is_empty()
            && objects.bridge.is_empty()
        {
            return;
        }
        let base = owner.path();
        for object in &objects.object {
            let tail = format!("object[@id={}]", object.id.text());
            let mut part = ElementContext {
                span: object.span,
                path: ElementPath::new(&base, &tail),
                findings,
            };
            let place = [("s", &object.s), ("t", &object.t)]
                .map(|(name, at)| part.need_along(at.value(), name));
            let [Some(s), Some(t)] = place else { continue };
            let mut row = self.object_row(owner, object, [s, t], position(object.span));
            let meaning = meaning(ontology, object);
            row.class = meaning.class.code();
            let outlines = self.outlines(object, &mut part);
            let mut details = self.details(object, &outlines, &mut part);
            if let Some(value) = meaning.value {
                let unit = meaning.assumed_unit.unwrap_or_default();
                assumed_unit(unit, &mut part);
                let unit = self.strings.add(unit);
                details.get_or_insert_default().value =
                    Some(ObjectValueRow { value, object: NONE, unit });
            }
            let of = self.repeats(object, &mut part);
            let angles = [&object.hdg, &object.pitch, &object.roll];
            let number = self.objects.objects.len() as u32;
            self.owners.add(object.span, AnnotationOwner::Object, number);
            self.objects.objects.push(Object {
                row: with_shape(row, !outlines.is_empty()),
                z_offset: object.z_offset.value().unwrap_or(0.0),
                angles: angles.map(|angle| angle.value().unwrap_or(0.0)),
                outlines,
                repeats: of,
                validities: lanes(&object.validity),
                details,
                span: object.span,
            });
        }
        if let Owner::Road(road, _) = owner {
            self.references(road, &objects.object_reference, &base, findings);
            self.structures(road, objects, &base, position, findings);
        }
    }

    /// Takes the objects of a junction whose row comes next, and the reference line that they are written along.
    pub(crate) fn junction_objects(
        &mut self,
        junction: &xodr::Junction,
        number: u32,
        context: ObjectContext<'_, impl Fn(Span) -> Position>,
        line: &ReferenceLine,
        findings: &mut Vec<Finding>,
    ) {
        let Some(objects) = junction.objects.as_deref().filter(|all| !all.object.is_empty()) else {
            return;
        };
        if junction.id.is_none() {
            // The junction is left out; the finding is its own.
            return;
        }
        let path = format!("OpenDRIVE/junction[@id={}]", junction.id.text());
        match junction.plan_view.as_deref() {
            Some(plan_view) => {
                let line = self.geometries(plan_view, line, &path, findings);
                self.objects.junction_lines.push((number, line));
            }
            None => {
                let mut part = ElementContext {
                    span: objects.span,
                    path: ElementPath::new(&path, "objects"),
                    findings,
                };
                let message = "expected the element planView in a junction with objects, found none; the objects are left out";
                left_out(&mut part, message.to_owned());
                return;
            }
        }
        let owner = Owner::Junction(number, junction.id.text());
        self.objects(owner, objects, context, findings);
    }

    fn object_row(
        &mut self,
        owner: Owner<'_>,
        object: &xodr::Object,
        [s, t]: [f64; 2],
        at: Position,
    ) -> ObjectRow {
        let number =
            |attribute: &Option<xodr::Attribute<f64>>| single(attribute.value().unwrap_or(0.0));
        let set = [
            (object.dynamic.value(), object_flags::DYNAMIC),
            (object.perp_to_road.value(), object_flags::PERPENDICULAR),
            (object.temporary.value(), object_flags::TEMPORARY),
            (object.invalidated.value(), object_flags::INVALIDATED),
        ];
        let (road, junction) = owner.rows();
        ObjectRow {
            x: 0.0,
            y: 0.0,
            z: 0.0,
            s,
            t,
            heading: 0.0,
            pitch: 0.0,
            roll: 0.0,
            z_offset: number(&object.z_offset),
            length: number(&object.length).max(0.0),
            width: number(&object.width).max(0.0),
            height: number(&object.height),
            radius: number(&object.radius).max(0.0),
            valid_length: number(&object.valid_length).max(0.0),
            id: self.strings.add(object.id.text()),
            name: self.strings.add(object.name.text()),
            kind: self.strings.add(object.r#type.text()),
            subtype: self.strings.add(object.subtype.text()),
            road,
            junction,
            outlines: Range::default(),
            copies: Range::default(),
            lanes: Range::default(),
            validities: Range::default(),
            line: at.line,
            column: at.column,
            class: 0,
            shape: ObjectShape::Point.code(),
            orientation: orientation(object.orientation.value()).code(),
            flags: set.iter().filter(|(on, _)| *on == Some(true)).fold(0, |all, (_, f)| all | f),
            reserved: [0; 3],
        }
    }

    /// Repetitions with what the object itself says where they do not.
    fn repeats(&self, object: &xodr::Object, part: &mut ElementContext<'_>) -> Vec<Repeat> {
        let mut repeats = Vec::new();
        for repeat in &object.repeat {
            let base = part.path.inside;
            let tail = format!("{base}/repeat");
            let mut part = ElementContext {
                span: repeat.span,
                path: ElementPath::new(part.path.owner, &tail),
                findings: part.findings,
            };
            repeats.extend(super::object_repeats::repeat(object, repeat, &mut part));
        }
        repeats
    }
}

/// What an object means. An element `parkingSpace` says it whatever the type.
fn meaning(ontology: &Ontology, object: &xodr::Object) -> Meaning {
    let code = ObjectCode {
        r#type: object.r#type.text(),
        subtype: object.subtype.text(),
        name: object.name.text(),
    };
    let meaning = ontology.object(&code);
    if matches!(meaning.class, Class::Unknown | Class::None) && object.parking_space.is_some() {
        return Meaning { class: Class::ParkingSpace, ..meaning };
    }
    meaning
}

/// Says in which unit a number is read that the file states without one.
pub(crate) fn assumed_unit(unit: &str, part: &mut ElementContext<'_>) {
    let message =
        format!("expected the unit of its value, found none; the number is read in {unit}");
    part.add(&building::ASSUMED_UNIT, Severity::Info, message);
}

/// The row with the shape that its sizes or outlines make.
fn with_shape(mut row: ObjectRow, has_outlines: bool) -> ObjectRow {
    row.shape = if has_outlines { ObjectShape::Outlines } else { shape(&row) }.code();
    row
}

/// The shape that sizes make.
fn shape(row: &ObjectRow) -> ObjectShape {
    crate::draft::shape([row.length, row.width, row.radius])
}

/// Direction of travel as the archive has it.
pub(crate) fn orientation(written: Option<xodr::Orientation>) -> Orientation {
    match written {
        Some(xodr::Orientation::Plus) => Orientation::Along,
        Some(xodr::Orientation::Minus) => Orientation::Against,
        _ => Orientation::Both,
    }
}

/// Lane numbers of validities, the lower one first: where a file has them the other way round, a rule says so. One that
/// lacks a number holds for the other alone.
pub(crate) fn lanes(written: &[xodr::LaneValidity]) -> Vec<(i32, i32)> {
    let lanes = |validity: &xodr::LaneValidity| {
        let (from, to) = (validity.from_lane.value(), validity.to_lane.value());
        let (from, to) = (from.or(to)?, to.or(from)?);
        Some((from.min(to), from.max(to)))
    };
    // Nearly all have both, so that as much room is needed.
    let mut all = Vec::with_capacity(written.len());
    all.extend(written.iter().filter_map(lanes));
    all
}

/// Says that a part of an object is left out.
pub(super) fn left_out(part: &mut ElementContext<'_>, message: String) {
    part.add(&building::OBJECT_PART, Severity::Warning, message);
}
