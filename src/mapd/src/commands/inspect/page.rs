//! What `mapd inspect` tells, as a page for people: what this map is, how large, where, and what it lacks.

use super::facts::{FileFrameFacts, Inspection, MapFacts, QuarantinedFacts, TableFacts};
use crate::printable::printable;
use crate::rounded;
use std::io::{Result, Write};

/// Parts in quarantine that are told one by one.
const MOST_LEFT_OUT: usize = 20;

/// Writes the page; with `tables` also what each table takes.
///
/// Errors: writing fails.
pub(super) fn write(facts: &Inspection, tables: bool, out: &mut dyn Write) -> Result<()> {
    let map = &facts.map;
    let name =
        if map.name.is_empty() { "without a name".to_owned() } else { format!("{:?}", map.name) };
    writeln!(out, "map           {name}, OpenDRIVE {}", map.opendrive)?;
    writeln!(out, "source        {}", printable(&facts.source))?;
    let km = map.road_length_m / 1000.0;
    writeln!(out, "roads         {}, {km:.3} km; {} junctions", map.roads, map.junctions)?;
    let (lanes, sections, links) = (map.lanes, map.sections, map.lane_links);
    writeln!(out, "lanes         {lanes} in {sections} sections, {links} links")?;
    let types: Vec<String> =
        map.lane_types.iter().map(|(name, count)| format!("{count} {name}")).collect();
    if !types.is_empty() {
        writeln!(out, "              {}", types.join(", "))?;
    }
    facts.graph.print(out)?;
    facts.signals.print(out)?;
    facts.objects.print(out)?;
    facts.besides.print(out)?;
    place(map, out)?;
    match &facts.findings {
        Some(findings) => findings.print(&printable(&facts.source), out)?,
        None => {
            writeln!(out, "findings      not in an archive: `mapd check` of its file tells them")?
        }
    }
    left_out(&facts.quarantined, out)?;
    let size = rounded::bytes(facts.bytes as f64);
    let density = rounded::bytes(map.bytes_per_road_km);
    writeln!(out, "archive       {size}, {density} per km of road; format {}", facts.format)?;
    for unknown in &facts.unknown {
        writeln!(out, "warning       {unknown}")?;
    }
    writeln!(out, "generation    {}", facts.generation)?;
    writeln!(out, "content hash  {}", facts.content_hash)?;
    writeln!(out, "input hash    {}", facts.input_hash)?;
    writeln!(out, "options hash  {}", facts.options_hash)?;
    writeln!(out, "compiler      {}", facts.compiler_version)?;
    if facts.verified == Some(true) {
        writeln!(out, "verified      content hash and every row")?;
    }
    if tables {
        write_tables(&facts.tables, out)?;
    }
    Ok(())
}

/// Where the map lies.
fn place(map: &MapFacts, out: &mut dyn Write) -> Result<()> {
    let [width, length, height] = [0, 1, 2].map(|axis| map.max[axis] - map.min[axis]);
    writeln!(out, "extent        {width:.1} m × {length:.1} m, {height:.1} m high")?;
    bounds(map.min, map.max, out)?;
    let text = map.geo_reference.trim();
    let stated = if text.is_empty() { "none".into() } else { printable(text) };
    writeln!(out, "geoReference  {stated} ({})", map.geo_reference_form)?;
    match (&map.projection, map.geodetic_bounds) {
        (Some(projection), Some([[south, west], [north, east]])) => {
            writeln!(out, "projection    {projection}")?;
            writeln!(out, "lat, lon      {south:.6}, {west:.6} to {north:.6}, {east:.6}")?;
        }
        (Some(projection), None) => {
            writeln!(out, "projection    {projection}; the map lies outside its area")?;
        }
        _ => {}
    }
    if let Some(frame) = &map.file_frame {
        file_frame(frame, out)?;
    }
    if map.header_offset != [0.0; 4] {
        let sign = if map.offset_negated { ", sign turned" } else { "" };
        writeln!(out, "offset        {}{sign}", offset(map.header_offset))?;
    }
    Ok(())
}

fn file_frame(frame: &FileFrameFacts, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "target        {}", frame.target)?;
    writeln!(out, "  file frame  {}, offset {}", frame.projection, offset(frame.header_offset))?;
    bounds(frame.min, frame.max, out)?;
    writeln!(
        out,
        "  error       {:.1e} m, scale {:.9} to {:.9}, z + {:.3} m (± {:.1e} m)",
        frame.error_m, frame.scale_min, frame.scale_max, frame.height_shift_m, frame.height_error_m
    )
}

fn bounds(min: [f64; 3], max: [f64; 3], out: &mut dyn Write) -> Result<()> {
    let [x, y, z] = [0, 1, 2].map(|axis| format!("{} to {}", metres(min[axis]), metres(max[axis])));
    writeln!(out, "              x {x}, y {y}, z {z} m")
}

fn offset([x, y, z, turn]: [f64; 4]) -> String {
    format!("{}, {}, {} m, turned by {turn:.6} rad", metres(x), metres(y), metres(z))
}

/// To the millimetre, without a sign before zero.
fn metres(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { text[1..].to_owned() } else { text }
}

/// What the map lacks, and why.
fn left_out(parts: &[QuarantinedFacts], out: &mut dyn Write) -> Result<()> {
    if parts.is_empty() {
        return writeln!(out, "quarantine    empty: nothing was left out");
    }
    let parts_word = if parts.len() == 1 { "part" } else { "parts" };
    writeln!(out, "quarantine    {} {parts_word}", parts.len())?;
    for part in parts.iter().take(MOST_LEFT_OUT) {
        let kept = if part.reference_line { ", kept as its reference line" } else { "" };
        let file =
            part.file.as_deref().map(|file| format!("{}, ", printable(file))).unwrap_or_default();
        writeln!(
            out,
            "  {}{kept}: {file}line {}, column {}: {}: {}",
            printable(&part.name),
            part.line,
            part.column,
            part.rule,
            printable(&part.message)
        )?;
    }
    if parts.len() > MOST_LEFT_OUT {
        writeln!(out, "  and {} more; --json lists all", parts.len() - MOST_LEFT_OUT)?;
    }
    Ok(())
}

fn write_tables(tables: &[TableFacts], out: &mut dyn Write) -> Result<()> {
    let heads = ["table", "elements", "bytes", "total", "share", "per km"];
    let [table, elements, bytes, total, share, per_km] = heads;
    writeln!(out, "\n{table:<24}{elements:>12}{bytes:>8}{total:>14}{share:>9}{per_km:>11}")?;
    for t in tables.iter().filter(|table| table.count > 0) {
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
