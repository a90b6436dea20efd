//! Places objects (docs/objects.md): their origins, axes and shapes in space, by the functions that queries use.

mod attach;
mod beside;
mod details;
mod line;
mod near_lanes;
mod outline;
mod place;
mod repeat;
mod track_area;

use crate::draft::{Object, Objects};
use crate::findings::{Graded, TooLarge};
use crate::options::CompileOptions;
use crate::sample::Fault;
use crate::sample::view;
use line::Line;
use mapd_archive::{
    NONE, ObjectCopyRow, ObjectOutlineRow, ObjectPointRow, ObjectRow, Range, Rows,
    SkeletonVertexRow, string,
};
use mapd_query::Map;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use rayon::prelude::*;
use repeat::LeftOutCopies;

/// Objects that are placed at once, for each thread.
const OBJECTS_PER_TASK: usize = 64;
/// Points that curves and swept repetitions of one object may make: both edges of 100 km of guard rail.
const MOST_MADE_OF_AN_OBJECT: usize = 1 << 15;
/// Points that those of all objects of any map may make, however small its file is.
const LEAST_MADE_OF_A_MAP: usize = 1 << 19;
/// Points beyond these for each object of the map: guard rails have some hundred.
const MADE_FOR_AN_OBJECT: usize = 1 << 9;

/// An outline with its corners in the frame of what it belongs to.
pub(crate) struct Shape {
    row: ObjectOutlineRow,
    points: Vec<ObjectPointRow>,
    /// Points that are not corners of the file: those of curves and of what is swept.
    made: usize,
    /// Ids of corners with the number of their point.
    corners: Vec<(u32, u32)>,
}

/// A place of a repeated object; a swept one has an outline of its own.
pub(crate) struct Copy {
    row: ObjectCopyRow,
    shape: Option<Box<Shape>>,
}

impl Copy {
    fn made(&self) -> usize {
        self.shape.as_ref().map_or(0, |shape| shape.made)
    }
}

/// Copies of an object times the corners of its outlines, at most: all corners of a copy tell which lanes it lies on. Maps at hand have up to 384.
const MOST_CORNERS_OF_COPIES: usize = 1 << 16;

/// What is known of an object once it is placed.
struct PlacedObject {
    row: ObjectRow,
    shapes: Vec<Shape>,
    copies: Vec<Copy>,
    skeletons: Vec<Vec<SkeletonVertexRow>>,
    findings: Vec<Finding>,
}

/// Fills the tables of objects but for their lanes.
pub(crate) fn build(
    rows: &mut Rows,
    mut written: Objects,
    options: &CompileOptions,
) -> Result<Vec<Finding>, TooLarge> {
    // Those of junctions have no road, whose number is the largest.
    written.objects.sort_by_key(|object| object.row.road);
    let mut findings = Vec::new();
    let rooms = rooms(rows, &written);
    let most_made = written.objects.len().saturating_mul(MADE_FOR_AN_OBJECT);
    let mut points_left = most_made.saturating_add(LEAST_MADE_OF_A_MAP);
    let at_once = OBJECTS_PER_TASK * rayon::current_num_threads().max(1);
    for (objects, rooms) in written.objects.chunks(at_once).zip(rooms.chunks(at_once)) {
        let placed: Vec<PlacedObject> = {
            let archive = view(rows);
            let map = Map::new(&archive, 0);
            let one =
                |(object, room): (&Object, &usize)| place(map, &written, object, *room, options);
            objects.par_iter().zip(rooms).map(one).collect()
        };
        for (object, placed) in objects.iter().zip(placed) {
            append(rows, object, placed, &mut points_left, &mut findings)?;
        }
    }
    rows.objects_by_id = by_id(rows).into();
    let references = beside::append(rows, &written)?;
    if rows.objects.is_empty() {
        return Ok(findings);
    }
    let unattached = attach::attach(rows, &references, options.lane_reach)?;
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    findings.extend(unattached.iter().filter_map(|number| {
        let object = written.objects.get(*number)?;
        let message = format!(
            "no lane that it may belong to is within {} m; it belongs only to its road",
            options.lane_reach
        );
        let rule = Graded { rule: &building::OBJECT_LANE, severity: Severity::Info };
        Some(finding(map, object, rule, object.span, message))
    }));
    Ok(findings)
}

/// Copies that each object may make, as many as it asks for until the map's are used up. Shared out before any is made:
/// making them is what takes memory.
fn rooms(rows: &Rows, written: &Objects) -> Vec<usize> {
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    let mut left = repeat::MOST_COPIES_OF_A_MAP;
    let room = |object: &Object| {
        let asked = asked(Line::of(map, written, &object.row).as_ref(), object);
        let room = asked.min(left);
        left -= room;
        room
    };
    written.objects.iter().map(room).collect()
}

/// Copies that an object's repetitions ask for.
fn asked(line: Option<&Line<'_>>, object: &Object) -> usize {
    let counts = line.map(|line| object.repeats.iter().map(|repeat| repeat::count(line, repeat)));
    counts.into_iter().flatten().fold(0, usize::saturating_add)
}

/// Rows in byte order of their ids, then of the rows themselves.
fn by_id(rows: &Rows) -> Vec<u32> {
    let tables = rows.as_tables();
    let text = |row: u32| string(&tables, rows.objects[row as usize].id).as_bytes();
    let mut order: Vec<u32> = (0..rows.objects.len() as u32).collect();
    order.sort_by(|a, b| text(*a).cmp(text(*b)).then(a.cmp(b)));
    order
}

/// Places an object that may make so many copies.
fn place(
    map: Map<'_>,
    written: &Objects,
    object: &Object,
    room: usize,
    options: &CompileOptions,
) -> PlacedObject {
    let line = Line::of(map, written, &object.row);
    let mut row = object.row;
    let mut findings = Vec::new();
    let standing = line.as_ref().and_then(|line| place::stand(line, object, &mut row));
    let Some((line, standing)) = line.as_ref().zip(standing) else {
        let message = "expected a place along a reference line, found one that no number can hold";
        let rule = Graded { rule: &building::OBJECT_PLACE, severity: Severity::Error };
        findings.push(finding(map, object, rule, object.span, message.to_owned()));
        let (shapes, copies, skeletons) = (Vec::new(), Vec::new(), Vec::new());
        return PlacedObject { row, shapes, copies, skeletons, findings };
    };
    let mut made = 0;
    let mut shapes = Vec::new();
    for outline in &object.outlines {
        match outline::shape(line, &standing, outline, options.bound_tolerance) {
            Ok(Some(shape)) if made + shape.made <= MOST_MADE_OF_AN_OBJECT => {
                made += shape.made;
                shapes.push(shape);
            }
            Ok(Some(_)) | Err(Fault::TooManyPoints) => {
                findings.push(too_detailed(map, object, "an outline"));
            }
            Ok(None) | Err(Fault::NotFinite) => {}
        }
    }
    let mut copies = Vec::with_capacity(room);
    let corners: usize = shapes.iter().map(|shape| shape.points.len()).sum();
    for repeat in &object.repeats {
        let before = copies.len();
        let wanted = before + repeat::count(line, repeat);
        if wanted.saturating_mul(corners) > MOST_CORNERS_OF_COPIES.max(corners) {
            let message = format!(
                "expected copies times corners of an object of at most {MOST_CORNERS_OF_COPIES}, found {wanted} times {corners}; the repetition is left out"
            );
            findings.push(finding(map, object, REPEAT, repeat.span, message));
            continue;
        }
        let bounds = repeat::Bounds { tolerance: options.bound_tolerance, copies: room - before };
        let outcome = repeat::copies(line, object, repeat, bounds, &mut copies);
        let new = copies[before..].iter().map(Copy::made).sum::<usize>();
        if new > MOST_MADE_OF_AN_OBJECT - made
            || matches!(outcome, Err(LeftOutCopies::TooManyPoints))
        {
            copies.truncate(before);
            let finding = too_detailed(map, object, "a repetition");
            findings.push(Finding { span: repeat.span, ..finding });
            continue;
        }
        made += new;
        if let Err(LeftOutCopies::Out(message)) = outcome {
            findings.push(finding(map, object, REPEAT, repeat.span, message));
        }
    }
    let lost = asked(Some(line), object) - room;
    if lost > 0 {
        let message = format!(
            "the map's objects are repeated more than {} times; {lost} repetitions are left out",
            repeat::MOST_COPIES_OF_A_MAP
        );
        let span = object.repeats.first().map_or(object.span, |repeat| repeat.span);
        findings.push(finding(map, object, REPEAT, span, message));
    }
    let details = object.details.as_deref();
    let skeletons =
        details.map_or_else(Vec::new, |details| details::skeletons(line, &standing, details));
    PlacedObject { row, shapes, copies, skeletons, findings }
}

fn append(
    rows: &mut Rows,
    object: &Object,
    mut placed: PlacedObject,
    points_left: &mut usize,
    findings: &mut Vec<Finding>,
) -> Result<(), TooLarge> {
    let number = u32::try_from(rows.objects.len()).map_err(|_| TooLarge::new("objects"))?;
    let mut row = placed.row;
    let mut fits = |made: usize| {
        let fits = made <= *points_left;
        *points_left -= if fits { made } else { 0 };
        fits
    };
    let before = (placed.shapes.len(), placed.copies.len());
    placed.shapes.retain(|shape| fits(shape.made));
    placed.copies.retain(|copy| fits(copy.made()));
    if before != (placed.shapes.len(), placed.copies.len()) {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        findings.push(too_detailed(map, object, "a part, with all others of the map,"));
    }
    let corners = object.details.as_deref().map(|_| details::Corners::new(&placed.shapes));
    let before = rows.object_outlines.len();
    for shape in placed.shapes {
        append_shape(rows, shape)?;
    }
    row.outlines = Range::between(before, rows.object_outlines.len())
        .ok_or_else(|| TooLarge::new("object_outlines"))?;
    let before = rows.object_copies.len();
    for copy in placed.copies {
        let mut copy_row = ObjectCopyRow { object: number, ..copy.row };
        if let Some(shape) = copy.shape {
            let before = rows.object_outlines.len();
            append_shape(rows, *shape)?;
            copy_row.outlines = Range::between(before, rows.object_outlines.len())
                .ok_or_else(|| TooLarge::new("object_outlines"))?;
        }
        rows.object_copies.push(copy_row);
    }
    row.copies = Range::between(before, rows.object_copies.len())
        .ok_or_else(|| TooLarge::new("object_copies"))?;
    row.validities = beside::lane_ranges(rows, &object.validities)?;
    if let (Some(details), Some(corners)) = (object.details.as_deref(), &corners) {
        let of = details::Of { object: number, outlines: row.outlines, corners };
        details::append(rows, &of, details, placed.skeletons)?;
    }
    rows.objects.push(row);
    findings.extend(placed.findings);
    Ok(())
}

fn append_shape(rows: &mut Rows, shape: Shape) -> Result<(), TooLarge> {
    let before = rows.object_points.len();
    rows.object_points.extend_from_slice(&shape.points);
    let points = Range::between(before, rows.object_points.len())
        .ok_or_else(|| TooLarge::new("object_points"))?;
    rows.object_outlines.push(ObjectOutlineRow { points, ..shape.row });
    Ok(())
}

/// Something is left out because its lines would have too many points.
fn too_detailed(map: Map<'_>, object: &Object, what: &str) -> Finding {
    let message = format!(
        "{what} has more points within the tolerance of borders than its length explains, than the {MOST_MADE_OF_AN_OBJECT} that objects may have, or the {LEAST_MADE_OF_A_MAP} and {MADE_FOR_AN_OBJECT} for each object that maps may have; it is left out"
    );
    let rule = Graded { rule: &building::OBJECT_PART, severity: Severity::Warning };
    finding(map, object, rule, object.span, message)
}

/// Whatever keeps a repetition from all of its copies.
const REPEAT: Graded = Graded { rule: &building::OBJECT_REPEAT, severity: Severity::Warning };

/// A finding about an object or one of its repetitions.
fn finding(
    map: Map<'_>,
    object: &Object,
    graded: Graded,
    span: mapd_xodr::Span,
    message: String,
) -> Finding {
    let text = |number: u32| string(map.tables(), number);
    let tables = map.tables();
    let (owner, id) = if object.row.road == NONE {
        let row = tables.junctions.get(object.row.junction as usize);
        ("junction", row.map_or(0, |row| row.id()))
    } else {
        ("road", tables.roads.get(object.row.road as usize).map_or(0, |row| row.id()))
    };
    let path =
        format!("OpenDRIVE/{owner}[@id={}]/objects/object[@id={}]", text(id), text(object.row.id));
    crate::findings::finding(graded.rule, graded.severity, span, path, message, "")
}
