//! `mapd query … annotations`, `visibility` and `junction-groups`: what files say besides.

use super::holes::Holes;
use super::kinds::{number, text};
use super::row::Row;
use mapd_client::Map;
use mapd_query::LaneKey;
use mapd_query::document::Annotation;
use mapd_query::document::SourcePosition;
use mapd_query::roads::LaneVisibility;
use mapd_query::vocabulary::{AnnotationOwner, QuarantinedKind};

/// Columns of annotations.
pub(super) const ANNOTATIONS: &[&str] =
    &["kind", "path", "name", "value", "text", "file", "line", "column"];
/// Columns of junction groups.
pub(super) const GROUPS: &[&str] = &["group", "name", "type", "junctions", "ring"];

/// What the file says besides of the part that the columns `owner` and `id` name.
pub(super) fn annotations(
    map: Map<'_>,
    holes: &Holes<'_>,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let owner = row.text("owner")?.trim();
    let kind = AnnotationOwner::ALL.iter().find(|kind| kind.name() == owner);
    let id = if row.has("id") { row.text("id")? } else { "" };
    let missing = || {
        let (error, part) = (format!("the map has no {owner} {id:?}"), kind.and_then(left_out_as));
        match part {
            Some(part) => holes.because_of(part, id, error),
            None => error,
        }
    };
    match kind {
        Some(AnnotationOwner::Document) => write(map.document_annotations(), out),
        Some(AnnotationOwner::Road) => {
            write(map.road_by_id(id).ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Section) => {
            let parts = id.rsplit_once(':').and_then(|(road, n)| Some((road, n.parse().ok()?)));
            let (road, number) =
                parts.ok_or_else(|| format!("expected road:section, found {id:?}"))?;
            let section = map.road_by_id(road).and_then(|road| road.section(number));
            write(section.ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Lane) => {
            let key: LaneKey<'_> = id.parse().map_err(|error| format!("{error}"))?;
            write(map.lane_by_key(&key).ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Junction) => {
            let junction = map.junction_by_id(id).ok_or_else(missing)?;
            write(junction.annotations(), out);
            // Connections have names within their junction alone: theirs come with it, their path in front.
            for connection in junction.connections() {
                let within = format!("connection[@id={}]", connection.id());
                write_below(&within, connection.annotations(), out);
            }
        }
        Some(AnnotationOwner::Object) => {
            write(map.object_by_id(id).ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Signal) => {
            write(map.signal_by_id(id).ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Controller) => {
            let found = map.controllers().find(|controller| controller.id() == id);
            write(found.ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::JunctionGroup) => {
            let found = map.junction_groups().find(|group| group.id() == id);
            write(found.ok_or_else(missing)?.annotations(), out)
        }
        Some(AnnotationOwner::Station) => {
            let found = map.stations().find(|station| station.id() == id);
            write(found.ok_or_else(missing)?.annotations(), out)
        }
        _ => {
            let known: Vec<&str> = AnnotationOwner::ALL.iter().map(|kind| kind.name()).collect();
            return Err(format!("owner must be one of {}, found {owner:?}", known.join(", ")));
        }
    }
    Ok(())
}

/// What a part of the kind is in quarantine as.
fn left_out_as(kind: &AnnotationOwner) -> Option<QuarantinedKind> {
    match kind {
        AnnotationOwner::Road => Some(QuarantinedKind::Road),
        AnnotationOwner::Junction => Some(QuarantinedKind::Junction),
        AnnotationOwner::Object => Some(QuarantinedKind::Object),
        AnnotationOwner::Signal => Some(QuarantinedKind::Signal),
        AnnotationOwner::Controller => Some(QuarantinedKind::Controller),
        _ => None,
    }
}

fn write<'a>(annotations: impl Iterator<Item = Annotation<'a>>, out: &mut Vec<String>) {
    write_below("", annotations, out);
}

fn write_below<'a>(
    within: &str,
    annotations: impl Iterator<Item = Annotation<'a>>,
    out: &mut Vec<String>,
) {
    for one in annotations {
        let between = if within.is_empty() || one.path().is_empty() { "" } else { "/" };
        let SourcePosition { line, column } = one.source_position();
        out.push(one.kind().name().to_owned());
        out.push(format!("{within}{between}{}", one.path()));
        out.extend([one.name(), one.value(), one.text()].map(str::to_owned));
        out.push(one.file().map_or("", |file| file.name()).to_owned());
        out.extend([line.to_string(), column.to_string()]);
    }
}

/// How far one sees; empty where no record holds.
pub(super) fn visibility(seen: Option<LaneVisibility>, out: &mut Vec<String>) {
    let all = seen.map(|seen| [seen.forward, seen.back, seen.left, seen.right]);
    let all = all.unwrap_or_default();
    out.extend(all.map(|distance| distance.map(number).unwrap_or_default()));
}

/// Groups of a junction, with their junctions and the lanes of the ring.
pub(super) fn groups(
    map: Map<'_>,
    holes: &Holes<'_>,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let id = row.text("junction_id")?;
    let missing = || {
        let error = format!("the map has no junction {id:?}");
        holes.because_of(QuarantinedKind::Junction, id, error)
    };
    let junction = map.junction_by_id(id).ok_or_else(missing)?;
    for group in junction.groups() {
        let members: Vec<&str> = group.members().map(|member| member.id()).collect();
        let ring = group.ring().map(|lane| Ok(map.lane(lane).map_err(text)?.key().to_string()));
        let ring: Vec<String> = ring.collect::<Result<_, String>>()?;
        out.extend([group.id(), group.name(), group.kind().name()].map(str::to_owned));
        out.extend([members.join(";"), ring.join(";")]);
    }
    Ok(())
}
