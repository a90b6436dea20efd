//! `mapd inspect`.

mod annotations;
mod graph;
mod objects;
mod signals;

use crate::args::Opening;
use crate::exit::Exit;
use crate::report::hex;
use annotations::AnnotationFacts;
use anyhow::Result;
use clap::Args;
use graph::{GraphFacts, lane_links};
use mapd_client::Snapshot;
use mapd_query::{FileFrame, Quarantined};
use objects::ObjectFacts;
use serde::Serialize;
use signals::SignalFacts;
use std::io::Write;

/// What to show.
#[derive(Args)]
pub(crate) struct InspectCommand {
    /// .xodr, .mapd or shm:NAME
    source: String,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Verify the content hash and every row first
    #[arg(long)]
    verify: bool,
    #[command(flatten)]
    opening: Opening,
}

impl InspectCommand {
    /// Prints what an archive holds.
    ///
    /// Errors: the source cannot be opened; the archive does not prove.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let Some(snapshot) = self.opening.open(&self.source)? else { return Ok(Exit::Rejected) };
        show(&self.source, &snapshot, self.json, self.verify, out)?;
        Ok(Exit::Done)
    }
}

#[derive(Serialize)]
struct Inspection {
    source: String,
    bytes: usize,
    format: u32,
    /// What this release does not know of it.
    unknown: Vec<String>,
    content_hash: String,
    input_hash: String,
    options_hash: String,
    compiler_version: String,
    generation: u64,
    verified: Option<bool>,
    map: MapFacts,
    graph: GraphFacts,
    signals: SignalFacts,
    objects: ObjectFacts,
    besides: AnnotationFacts,
    quarantined: Vec<QuarantinedFacts>,
    tables: Vec<TableFacts>,
}

#[derive(Serialize)]
struct MapFacts {
    name: String,
    opendrive: String,
    geo_reference: String,
    geo_reference_form: &'static str,
    /// PROJ parameters that the georeference was understood as.
    projection: Option<String>,
    /// x, y, z `[m]` and turn `[rad]`, as applied.
    header_offset: [f64; 4],
    offset_negated: bool,
    /// Smallest and largest latitude and longitude `[deg]` of the bounds' edge.
    geodetic_bounds: Option<[[f64; 2]; 2]>,
    /// The file's own frame, where the map is in another.
    file_frame: Option<FileFrameFacts>,
    roads: usize,
    junctions: usize,
    sections: usize,
    lanes: usize,
    lane_links: usize,
    road_length_m: f64,
    min: [f64; 3],
    max: [f64; 3],
    bytes_per_road_km: f64,
}

#[derive(Serialize)]
struct FileFrameFacts {
    /// As it was asked for.
    target: String,
    projection: String,
    /// x, y, z `[m]` and turn `[rad]`, as applied before the transformation.
    header_offset: [f64; 4],
    min: [f64; 3],
    max: [f64; 3],
    /// Bound for points of reference lines `[m]`.
    error_m: f64,
    height_shift_m: f64,
    height_error_m: f64,
    scale_min: f64,
    scale_max: f64,
}

impl FileFrameFacts {
    fn of(frame: FileFrame<'_>) -> Self {
        let (shift, turn) = frame.offset();
        let (min, max) = frame.bounds();
        let (scale_min, scale_max) = frame.scale();
        Self {
            target: frame.target().to_owned(),
            projection: frame.projection().to_owned(),
            header_offset: [shift.x, shift.y, shift.z, turn],
            min: min.to_array(),
            max: max.to_array(),
            error_m: frame.error(),
            height_shift_m: frame.height_shift(),
            height_error_m: frame.height_error(),
            scale_min,
            scale_max,
        }
    }

    fn print(&self, out: &mut dyn Write) -> std::io::Result<()> {
        writeln!(out, "target        {}", self.target)?;
        writeln!(out, "  file frame  {}, offset {:?}", self.projection, self.header_offset)?;
        writeln!(out, "  bounds [m]  {:?} to {:?}", self.min, self.max)?;
        writeln!(
            out,
            "  error       {:.1e} m, scale {:.9} to {:.9}, z + {} m (± {:.1e} m)",
            self.error_m, self.scale_min, self.scale_max, self.height_shift_m, self.height_error_m
        )
    }
}

#[derive(Serialize)]
struct QuarantinedFacts {
    kind: &'static str,
    id: String,
    owner: String,
    owner_kind: &'static str,
    /// What people call it.
    #[serde(skip)]
    name: String,
    reference_line: bool,
    min: Option<[f64; 2]>,
    max: Option<[f64; 2]>,
    rule: String,
    message: String,
    /// The included file that the finding stands in; none for the document itself.
    file: Option<String>,
    line: u32,
    column: u32,
}

#[derive(Serialize)]
struct TableFacts {
    number: u32,
    name: &'static str,
    count: usize,
    element_bytes: usize,
    bytes: usize,
    /// Of the archive's bytes.
    share: f64,
    bytes_per_road_km: f64,
}

/// Prints what an archive holds; with `verify` proves it first.
///
/// Errors: the archive does not prove.
fn show(
    source: &str,
    snapshot: &Snapshot,
    json: bool,
    verify: bool,
    out: &mut dyn Write,
) -> Result<()> {
    if verify {
        snapshot.verify()?;
    }
    let inspection = inspect(source, snapshot, verify);
    if json {
        serde_json::to_writer_pretty(&mut *out, &inspection)?;
        writeln!(out)?;
        return Ok(());
    }
    let i = &inspection;
    let m = &i.map;
    writeln!(out, "source        {}", i.source)?;
    writeln!(out, "map           {:?}, OpenDRIVE {}", m.name, m.opendrive)?;
    writeln!(
        out,
        "roads         {} ({:.3} km), {} junctions",
        m.roads,
        m.road_length_m / 1000.0,
        m.junctions
    )?;
    writeln!(out, "lanes         {} in {} sections, {} links", m.lanes, m.sections, m.lane_links)?;
    i.graph.print(out)?;
    i.signals.print(out)?;
    i.objects.print(out)?;
    i.besides.print(out)?;
    writeln!(out, "bounds [m]    {:?} to {:?}", m.min, m.max)?;
    writeln!(out, "geoReference  {} ({})", m.geo_reference.trim(), m.geo_reference_form)?;
    match (&m.projection, m.geodetic_bounds) {
        (Some(projection), Some([low, high])) => {
            writeln!(out, "projection    {projection}")?;
            writeln!(out, "lat, lon      {low:?} to {high:?}")?;
        }
        (Some(projection), None) => {
            writeln!(out, "projection    {projection}; the map lies outside its area")?;
        }
        _ => {}
    }
    if let Some(frame) = &m.file_frame {
        frame.print(out)?;
    }
    if m.header_offset != [0.0; 4] {
        let sign = if m.offset_negated { ", sign turned" } else { "" };
        writeln!(out, "offset        {:?}{sign}", m.header_offset)?;
    }
    writeln!(out, "archive       {} bytes, {:.0} per km of road", i.bytes, m.bytes_per_road_km)?;
    writeln!(out, "generation    {}", i.generation)?;
    writeln!(out, "format        {}", i.format)?;
    for unknown in &i.unknown {
        writeln!(out, "warning       {unknown}")?;
    }
    writeln!(out, "content hash  {}", i.content_hash)?;
    writeln!(out, "input hash    {}", i.input_hash)?;
    writeln!(out, "options hash  {}", i.options_hash)?;
    writeln!(out, "compiler      {}", i.compiler_version)?;
    if verify {
        writeln!(out, "verified      content hash and every row")?;
    }
    for part in &i.quarantined {
        let kept = if part.reference_line { ", kept as its reference line" } else { "" };
        writeln!(
            out,
            "quarantined   {}{kept}, by line {}, column {}: {}: {}",
            part.name, part.line, part.column, part.rule, part.message
        )?;
    }
    writeln!(
        out,
        "\n{:<24}{:>12}{:>8}{:>14}{:>9}{:>11}",
        "table", "elements", "bytes", "total", "share", "per km"
    )?;
    for t in &i.tables {
        writeln!(
            out,
            "{:<24}{:>12}{:>8}{:>14}{:>8.1}%{:>11.0}",
            t.name,
            t.count,
            t.element_bytes,
            t.bytes,
            100.0 * t.share,
            t.bytes_per_road_km
        )?;
    }
    Ok(())
}

fn inspect(source: &str, snapshot: &Snapshot, verified: bool) -> Inspection {
    let map = snapshot.map();
    let tables = map.tables();
    let header = snapshot.header();
    let (min, max) = map.bounds();
    let (major, minor) = map.revision();
    let length = map.road_length();
    let (shift, turn) = map.header_offset();
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
        quarantined: map.quarantined().map(|part| quarantined(&part)).collect(),
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

fn unknown_to_this_release(snapshot: &Snapshot) -> Vec<String> {
    // What is open can be opened again.
    let unknown = mapd_archive::unknown(snapshot.bytes()).unwrap_or_default();
    unknown.iter().map(ToString::to_string).collect()
}

fn quarantined(part: &Quarantined<'_>) -> QuarantinedFacts {
    let (line, column) = part.source_position();
    let extent = part.extent();
    QuarantinedFacts {
        kind: part.kind().name(),
        id: part.id().to_owned(),
        owner: part.owner().to_owned(),
        owner_kind: part.owner_kind().name(),
        name: part.to_string(),
        reference_line: part.is_reference_line(),
        min: extent.map(|(min, _)| min.to_array()),
        max: extent.map(|(_, max)| max.to_array()),
        rule: part.rule().to_owned(),
        message: part.message().to_owned(),
        file: part.source_file().map(str::to_owned),
        line,
        column,
    }
}
