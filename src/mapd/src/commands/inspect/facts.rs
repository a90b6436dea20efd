//! What `mapd inspect` tells, as data.

use super::annotations::AnnotationFacts;
use super::findings::FindingFacts;
use super::graph::{GraphFacts, lane_links};
use super::objects::ObjectFacts;
use super::signals::SignalFacts;
use crate::report::hex;
use mapd_client::{Map, Snapshot};
use mapd_compiler::Compilation;
use mapd_query::Bounds;
use mapd_query::document::HeaderOffset;
use mapd_query::document::Revision;
use mapd_query::document::SourcePosition;
use mapd_query::document::{FileFrame, Quarantined};
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Serialize)]
pub(super) struct Inspection {
    pub(super) source: String,
    pub(super) bytes: usize,
    pub(super) format: u32,
    /// What this release does not know of it.
    pub(super) unknown: Vec<String>,
    pub(super) content_hash: String,
    pub(super) input_hash: String,
    pub(super) options_hash: String,
    pub(super) compiler_version: String,
    pub(super) generation: u64,
    pub(super) verified: Option<bool>,
    pub(super) map: MapFacts,
    pub(super) graph: GraphFacts,
    pub(super) signals: SignalFacts,
    pub(super) objects: ObjectFacts,
    pub(super) besides: AnnotationFacts,
    /// Of an OpenDRIVE file: archives keep none.
    pub(super) findings: Option<FindingFacts>,
    pub(super) quarantined: Vec<QuarantinedFacts>,
    pub(super) tables: Vec<TableFacts>,
}

#[derive(Serialize)]
pub(super) struct MapFacts {
    pub(super) name: String,
    pub(super) opendrive: String,
    pub(super) geo_reference: String,
    pub(super) geo_reference_form: &'static str,
    /// PROJ parameters that the georeference was understood as.
    pub(super) projection: Option<String>,
    /// x, y, z `[m]` and turn `[rad]`, as applied.
    pub(super) header_offset: [f64; 4],
    pub(super) offset_negated: bool,
    /// Smallest and largest latitude and longitude `[deg]` of the bounds' edge.
    pub(super) geodetic_bounds: Option<[[f64; 2]; 2]>,
    /// The file's own frame, where the map is in another.
    pub(super) file_frame: Option<FileFrameFacts>,
    pub(super) roads: usize,
    pub(super) junctions: usize,
    pub(super) sections: usize,
    pub(super) lanes: usize,
    /// Lanes by type.
    pub(super) lane_types: BTreeMap<&'static str, usize>,
    pub(super) lane_links: usize,
    pub(super) road_length_m: f64,
    pub(super) min: [f64; 3],
    pub(super) max: [f64; 3],
    pub(super) bytes_per_road_km: f64,
}

#[derive(Serialize)]
pub(super) struct FileFrameFacts {
    /// As it was asked for.
    pub(super) target: String,
    pub(super) projection: String,
    /// x, y, z `[m]` and turn `[rad]`, as applied before the transformation.
    pub(super) header_offset: [f64; 4],
    pub(super) min: [f64; 3],
    pub(super) max: [f64; 3],
    /// Bound for points of reference lines `[m]`.
    pub(super) error_m: f64,
    pub(super) height_shift_m: f64,
    pub(super) height_error_m: f64,
    pub(super) scale_min: f64,
    pub(super) scale_max: f64,
}

impl FileFrameFacts {
    fn of(frame: FileFrame<'_>) -> Self {
        let HeaderOffset { shift, heading: turn } = frame.offset();
        let Bounds { low: min, high: max } = frame.bounds();
        Self {
            target: frame.target().to_owned(),
            projection: frame.projection().to_owned(),
            header_offset: [shift.x, shift.y, shift.z, turn],
            min: min.to_array(),
            max: max.to_array(),
            error_m: frame.error(),
            height_shift_m: frame.height_shift(),
            height_error_m: frame.height_error(),
            scale_min: frame.scale_min(),
            scale_max: frame.scale_max(),
        }
    }
}

#[derive(Serialize)]
pub(super) struct QuarantinedFacts {
    pub(super) kind: &'static str,
    pub(super) id: String,
    pub(super) owner: String,
    pub(super) owner_kind: &'static str,
    /// What people call it.
    #[serde(skip)]
    pub(super) name: String,
    pub(super) reference_line: bool,
    pub(super) min: Option<[f64; 2]>,
    pub(super) max: Option<[f64; 2]>,
    pub(super) rule: String,
    pub(super) message: String,
    /// The included file that the finding stands in; none for the document itself.
    pub(super) file: Option<String>,
    pub(super) line: u32,
    pub(super) column: u32,
}

#[derive(Serialize)]
pub(super) struct TableFacts {
    pub(super) number: u32,
    pub(super) name: &'static str,
    pub(super) count: usize,
    pub(super) element_bytes: usize,
    pub(super) bytes: usize,
    /// Of the archive's bytes.
    pub(super) share: f64,
    pub(super) bytes_per_road_km: f64,
}

/// What a map holds.
pub(super) fn inspect(
    source: &str,
    snapshot: &Snapshot,
    compiled: Option<&Compilation>,
    verified: bool,
) -> Inspection {
    let map = snapshot.map();
    let tables = map.tables();
    let header = snapshot.header();
    let Bounds { low: min, high: max } = map.bounds();
    let Revision { major, minor } = map.revision();
    let length = map.road_length();
    let HeaderOffset { shift, heading: turn } = map.header_offset();
    let bytes = snapshot.bytes().len();
    let per_km = |bytes: usize| if length > 0.0 { bytes as f64 / (length / 1000.0) } else { 0.0 };
    let [a, b, c] = header.provenance.compiler_version;
    Inspection {
        source: source.to_owned(),
        bytes,
        format: mapd_archive::FORMAT,
        unknown: unknown_to_this_release(snapshot),
        content_hash: hex(&header.content_hash),
        input_hash: hex(&header.provenance.input_hash),
        options_hash: hex(&header.provenance.options_hash),
        compiler_version: format!("{a}.{b}.{c}"),
        generation: snapshot.generation(),
        verified: verified.then_some(true),
        map: MapFacts {
            name: map.name().to_owned(),
            opendrive: format!("{major}.{minor}"),
            geo_reference: map.geo_reference().to_owned(),
            geo_reference_form: map.geo_reference_form().name(),
            projection: Some(map.projection()).filter(|text| !text.is_empty()).map(str::to_owned),
            header_offset: [shift.x, shift.y, shift.z, turn],
            offset_negated: map.offset_is_negated(),
            geodetic_bounds: map.geodetic_bounds().map(|[s, n, w, e]| [[s, w], [n, e]]),
            file_frame: map.file_frame().map(FileFrameFacts::of),
            roads: tables.roads.len(),
            junctions: tables.junctions.len(),
            sections: tables.sections.len(),
            lanes: map.lanes().count(),
            lane_types: lane_types(map),
            lane_links: lane_links(map),
            road_length_m: length,
            min: min.to_array(),
            max: max.to_array(),
            bytes_per_road_km: per_km(bytes),
        },
        graph: GraphFacts::of(map),
        signals: SignalFacts::of(map),
        objects: ObjectFacts::of(map),
        besides: AnnotationFacts::of(map),
        findings: compiled.map(FindingFacts::of),
        quarantined: map.quarantined().map(|part| left_out(&part)).collect(),
        tables: tables
            .infos()
            .iter()
            .map(|t| TableFacts {
                number: t.number,
                name: t.name,
                count: t.count,
                element_bytes: t.element_bytes,
                bytes: t.count * t.element_bytes,
                share: (t.count * t.element_bytes) as f64 / bytes.max(1) as f64,
                bytes_per_road_km: per_km(t.count * t.element_bytes),
            })
            .collect(),
    }
}

fn lane_types(map: Map<'_>) -> BTreeMap<&'static str, usize> {
    let mut types = BTreeMap::new();
    for lane in map.lanes() {
        *types.entry(lane.kind().name()).or_default() += 1;
    }
    types
}

fn unknown_to_this_release(snapshot: &Snapshot) -> Vec<String> {
    // What is open can be opened again.
    let unknown = mapd_archive::unknown(snapshot.bytes()).unwrap_or_default();
    unknown.iter().map(ToString::to_string).collect()
}

fn left_out(part: &Quarantined<'_>) -> QuarantinedFacts {
    let SourcePosition { line, column } = part.source_position();
    let extent = part.extent();
    QuarantinedFacts {
        kind: part.kind().name(),
        id: part.id().to_owned(),
        owner: part.owner().to_owned(),
        owner_kind: part.owner_kind().name(),
        name: part.to_string(),
        reference_line: part.is_reference_line(),
        min: extent.map(|extent| extent.low.to_array()),
        max: extent.map(|extent| extent.high.to_array()),
        rule: part.rule().to_owned(),
        message: part.message().to_owned(),
        file: part.source_file().map(str::to_owned),
        line,
        column,
    }
}
