//! Proving an archive: the content hash and what every row says. Linear in its size.

use crate::directory::feature_bit;
use crate::error::VerifyError;
use crate::header::HEADER_LENGTH;
use crate::open::{Archive, open};
use crate::packed_index::WIDTH;
use crate::table::Range;
use crate::verify_annotations::annotations;
use crate::verify_graph::graph;
use crate::verify_lines::lines;
use crate::verify_objects::{objects, signal_index};
use crate::{NONE, Tables};

/// Opens an archive and proves it: content hash, finite numbers, known codes, references and ranges inside their
/// tables, strings that are UTF-8, ascending `s`, sections that meet, an index that is a complete tree, a lane graph whose edges
/// are mirrored, whose components are ordered and whose loops are closed where it says so, objects in the order of
/// their roads with copies and lanes that know them, each place of theirs and each signal once in their index, annotations in the
/// order of owners that there are.
///
/// Tables and codes that this release does not know are no errors: [`crate::unknown`] lists them.
///
/// Errors: the first thing that is wrong, with table, row and field.
pub fn verify(bytes: &[u8]) -> Result<Archive<'_>, VerifyError> {
    verify_hash(bytes)?;
    verify_tables(bytes)
}

/// The part of [`verify`] that is about the content hash.
pub fn verify_hash(bytes: &[u8]) -> Result<(), VerifyError> {
    let expected = open(bytes)?.header.content_hash;
    let found = *blake3::hash(&bytes[HEADER_LENGTH..]).as_bytes();
    if found == expected { Ok(()) } else { Err(VerifyError::ContentHash { expected, found }) }
}

/// The part of [`verify`] that is about what rows say.
pub fn verify_tables(bytes: &[u8]) -> Result<Archive<'_>, VerifyError> {
    let archive = open(bytes)?;
    let tables = &archive.tables;
    features(&archive)?;
    strings(tables.string_bytes, tables.string_offsets)?;
    tables.verify_rows()?;
    exactly_one_map(tables)?;
    ascending(tables)?;
    sections(tables)?;
    lines(tables)?;
    index(tables)?;
    graph(tables)?;
    objects(tables)?;
    signal_index(tables)?;
    annotations(tables)?;
    Ok(archive)
}

/// The place of a row that is being checked.
pub(crate) struct Check {
    pub(crate) table: &'static str,
    pub(crate) row: usize,
}

impl Check {
    pub(crate) fn fail(
        &self,
        field: &'static str,
        expected: impl Into<String>,
        found: impl ToString,
    ) -> Result<(), VerifyError> {
        Err(VerifyError::Row {
            table: self.table,
            row: self.row,
            field,
            expected: expected.into(),
            found: found.to_string(),
        })
    }

    pub(crate) fn finite(&self, field: &'static str, value: f64) -> Result<(), VerifyError> {
        if value.is_finite() { Ok(()) } else { self.fail(field, "a finite number", value) }
    }

    pub(crate) fn code(
        &self,
        field: &'static str,
        value: u8,
        codes: u32,
    ) -> Result<(), VerifyError> {
        if u32::from(value) < codes {
            Ok(())
        } else {
            self.fail(field, format!("a code below {codes}"), value)
        }
    }

    pub(crate) fn reference(
        &self,
        field: &'static str,
        value: u32,
        count: usize,
        optional: bool,
    ) -> Result<(), VerifyError> {
        if (value as usize) < count || (optional && value == NONE) {
            Ok(())
        } else {
            self.fail(field, format!("a row below {count}"), value)
        }
    }

    pub(crate) fn parallel(&self, count: usize, parent: usize) -> Result<(), VerifyError> {
        if count == 0 || count == parent {
            Ok(())
        } else {
            self.fail("", format!("0 or {parent} rows"), count)
        }
    }

    pub(crate) fn range(
        &self,
        field: &'static str,
        range: Range,
        count: usize,
    ) -> Result<(), VerifyError> {
        if range.end() <= count as u64 {
            Ok(())
        } else {
            self.fail(field, format!("a range ending at most at {count}"), format!("{range:?}"))
        }
    }
}

/// Each bit of the header's `must_understand` has a row that names it.
fn features(archive: &Archive<'_>) -> Result<(), VerifyError> {
    let rows = archive.tables.features;
    let named = rows.iter().fold(0, |bits, row| bits | feature_bit(row.bit()));
    let bits = archive.header.must_understand;
    if named != bits {
        let check = Check { table: "features", row: 0 };
        return check.fail("bit", format!("bits {bits:#x}"), format!("{named:#x}"));
    }
    match rows.iter().position(|row| row.name_text().is_empty()) {
        Some(row) => Check { table: "features", row }.fail("name", "UTF-8 text", "none"),
        None => Ok(()),
    }
}

pub(crate) fn strings(text: &[u8], offsets: &[u32]) -> Result<(), VerifyError> {
    let at = |row| Check { table: "string_offsets", row };
    let (first, last) = (offsets.first(), offsets.last());
    if first != Some(&0) || last.map(|l| *l as usize) != Some(text.len()) {
        return at(0).fail(
            "",
            "offsets from 0 to the number of bytes",
            format!("{first:?} to {last:?}"),
        );
    }
    for (row, pair) in offsets.windows(2).enumerate() {
        let bytes = text.get(pair[0] as usize..pair[1] as usize);
        match bytes.map(std::str::from_utf8) {
            None => return at(row).fail("", "ascending offsets", format!("{pair:?}")),
            Some(Err(error)) => return at(row).fail("", "UTF-8 text", error),
            Some(Ok(_)) => {}
        }
    }
    Ok(())
}

fn exactly_one_map(tables: &Tables<'_>) -> Result<(), VerifyError> {
    match tables.map.len() {
        1 => Ok(()),
        found => Check { table: "map", row: 0 }.fail("", "exactly one row", found),
    }
}

/// Records along s never fall within their range.
fn ascending(tables: &Tables<'_>) -> Result<(), VerifyError> {
    fn check<T>(
        table: &'static str,
        rows: &[T],
        range: Range,
        s: impl Fn(&T) -> f64,
    ) -> Result<(), VerifyError> {
        for (i, pair) in range.of(rows).windows(2).enumerate() {
            if s(&pair[1]) < s(&pair[0]) {
                let row = range.first as usize + i + 1;
                return Check { table, row }.fail(
                    "s",
                    format!("at least {}", s(&pair[0])),
                    s(&pair[1]),
                );
            }
        }
        Ok(())
    }
    for road in tables.roads {
        check("geometries", tables.geometries, road.geometries(), |r| r.s())?;
        check("cubics", tables.cubics, road.elevations(), |r| r.s())?;
        check("cubics", tables.cubics, road.superelevations(), |r| r.s())?;
        check("cubics", tables.cubics, road.lane_offsets(), |r| r.s())?;
        check("road_types", tables.road_types, road.types(), |r| r.s())?;
    }
    for lane in tables.lanes {
        check("cubics", tables.cubics, lane.widths(), |r| r.s())?;
    }
    by_lane("lane_speeds", tables.lane_speeds, |r| (r.lane(), r.s()))?;
    by_lane("lane_heights", tables.lane_heights, |r| (r.lane(), r.s()))?;
    by_lane("lane_materials", tables.lane_materials, |r| (r.lane(), r.s()))?;
    by_lane("lane_visibilities", tables.lane_visibilities, |r| (r.lane(), r.s()))?;
    by_lane("lane_rules", tables.lane_rules, |r| (r.lane(), r.s()))?;
    marks(tables)
}

/// Marks of a sequence do not fall, and the last sequence ends.
fn marks(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let rows = tables.road_marks;
    for (row, mark) in rows.iter().enumerate().filter(|(_, mark)| mark.last() == 0) {
        let check = Check { table: "road_marks", row };
        match rows.get(row + 1) {
            None => return check.fail("last", "1", 0),
            Some(next) if next.s_offset() < mark.s_offset() => {
                let expected = format!("at most {}", next.s_offset());
                return check.fail("s_offset", expected, mark.s_offset());
            }
            Some(_) => {}
        }
    }
    Ok(())
}

/// Records of lanes are in the order of their lanes, and of s within one.
fn by_lane<T>(
    table: &'static str,
    rows: &[T],
    key: impl Fn(&T) -> (u32, f64),
) -> Result<(), VerifyError> {
    for (i, pair) in rows.windows(2).enumerate() {
        let (before, after) = (key(&pair[0]), key(&pair[1]));
        if after < before {
            let row = i + 1;
            return Check { table, row }.fail(
                "lane",
                format!("at least {before:?}"),
                format!("{after:?}"),
            );
        }
    }
    Ok(())
}

/// Sections know their road, follow each other, and own the lanes that say so.
fn sections(tables: &Tables<'_>) -> Result<(), VerifyError> {
    for (number, road) in tables.roads.iter().enumerate() {
        let range = road.sections();
        let mut end = None;
        for (i, section) in range.of(tables.sections).iter().enumerate() {
            let check = Check { table: "sections", row: range.first as usize + i };
            if section.road() as usize != number {
                return check.fail("road", number.to_string(), section.road());
            }
            if end.is_some_and(|end| end != section.s_start())
                || section.s_end() < section.s_start()
            {
                return check.fail("s_start", format!("{end:?}"), section.s_start());
            }
            end = Some(section.s_end());
        }
    }
    for (number, section) in tables.sections.iter().enumerate() {
        let lanes = section.lanes();
        let mut left = i64::from(i32::MAX) + 1;
        for (i, lane) in lanes.of(tables.lanes).iter().enumerate() {
            let check = Check { table: "lanes", row: lanes.first as usize + i };
            if lane.section() as usize != number {
                return check.fail("section", number.to_string(), lane.section());
            }
            let number = i64::from(lane.number());
            if number >= left {
                return check.fail("number", format!("below {left}"), number);
            }
            left = number;
        }
    }
    Ok(())
}

/// The index over lanes is a complete tree, and every used place names a lane and its points.
fn index(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let places = tables.index_leaves.len();
    tree("index_levels", tables.index_levels, tables.index_nodes.len(), places)?;
    for (row, leaf) in tables.index_leaves.iter().enumerate() {
        let check = Check { table: "index_leaves", row };
        for place in 0..WIDTH {
            let (lane, segment) = (leaf.lane()[place], leaf.segment()[place]);
            if lane == NONE {
                continue;
            }
            let Some(owner) = tables.lanes.get(lane as usize) else {
                return check.fail("lane", "a lane", lane);
            };
            let points = owner.center_count();
            if u32::from(segment) + 1 >= points.into() {
                return check.fail("segment", format!("a segment of {points} points"), segment);
            }
        }
    }
    Ok(())
}

/// Each level of a packed R-tree has as many nodes as the next one's places need; below the last one lie `places`.
pub(crate) fn tree(
    table: &'static str,
    levels: &[u32],
    nodes: usize,
    places: usize,
) -> Result<(), VerifyError> {
    let at = |row| Check { table, row };
    if levels.is_empty() != (places == 0) || levels.len() == 1 {
        return at(0).fail("", "levels just where there are leaves", levels.len());
    }
    if let (Some(first), Some(last)) = (levels.first(), levels.last())
        && (*first != 0 || *last as usize != nodes)
    {
        return at(0).fail(
            "",
            "levels from 0 to the number of nodes",
            format!("{first} to {last}"),
        );
    }
    let mut below = places;
    for (row, pair) in levels.windows(2).enumerate().rev() {
        let nodes = (pair[1] as usize).checked_sub(pair[0] as usize);
        if nodes != Some(below.div_ceil(WIDTH)) {
            return at(row).fail(
                "",
                format!("{} nodes", below.div_ceil(WIDTH)),
                format!("{nodes:?}"),
            );
        }
        below = below.div_ceil(WIDTH);
    }
    if !levels.is_empty() && below != 1 {
        return at(0).fail("", "one root", below);
    }
    Ok(())
}
