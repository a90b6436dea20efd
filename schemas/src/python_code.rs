//! Writes what Python has to know of the tables: their numbers, their rows' ids, and what a row is in numpy's words.

use crate::archive::{Layout, Table};
use std::fmt::Write;

/// `src/python/python/mapd/_layout.py`.
pub(crate) fn layout(layout: &Layout) -> String {
    let mut out = String::from(
        "# Written by mapd-schemas from schemas/archive.toml; do not edit.\n\"\"\"Tables of the archive: number, row id, and what a row is.\"\"\"\n\n\
         from typing import Any\n\nTABLES: dict[str, tuple[int, int, Any]] = {\n",
    );
    for table in layout.by_number() {
        let _ = writeln!(
            out,
            "    \"{}\": ({}, {:#018x}, {}),",
            table.name,
            table.number,
            table.row_id(),
            row(table)
        );
    }
    out + "}\n"
}

fn row(table: &Table) -> String {
    if let Some(scalar) = &table.scalar {
        return kind(scalar);
    }
    let field = |field: &crate::archive::Field| {
        let name = &field.name;
        match field.kind.strip_prefix('[').and_then(|kind| kind.strip_suffix(']')) {
            Some(array) => {
                let (of, count) = array.split_once(';').unwrap_or((array, "1"));
                format!("(\"{name}\", {}, ({},))", kind(of.trim()), count.trim())
            }
            None => format!("(\"{name}\", {})", kind(&field.kind)),
        }
    };
    let fields: Vec<_> = table.fields.iter().map(field).collect();
    format!("[{}]", fields.join(", "))
}

/// A field's type in numpy's words; the archive is little-endian.
fn kind(name: &str) -> String {
    match name {
        "range" => "[(\"first\", \"<u4\"), (\"count\", \"<u4\")]".to_owned(),
        "u8" => "\"u1\"".to_owned(),
        number => {
            let (letter, bits) = number.split_at(1);
            let bytes = bits.parse::<usize>().unwrap_or(8) / 8;
            format!("\"<{letter}{bytes}\"")
        }
    }
}
