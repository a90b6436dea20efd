//! What differs between two archives.

use crate::workspace;
use mapd_compiler::{CompileOptions, ReadOptions, Verdict, compile_from};
use mapd_schemas::decode::{Decoder, Rows, Value};
use std::sync::LazyLock;

/// Largest difference, relative, between a number and itself in single precision.
const SINGLE: f64 = 1e-6;

/// A field in which two archives differ.
pub(super) struct Difference {
    pub(super) table: String,
    pub(super) field: String,
    /// Whether all that differs in it are codes.
    pub(super) is_code: bool,
    /// What it holds in the first and in the second archive where they differ, row by row.
    values: Vec<(Vec<Value>, Vec<Value>)>,
}

impl Difference {
    /// Whether the first archive has one value where the second has the other.
    pub(super) fn holds(&self, written: &str, value: &str) -> bool {
        let mut cells = self.values.iter().flat_map(|(old, new)| old.iter().zip(new));
        cells.any(|(old, new)| is(old, written) && is(new, value))
    }
}

/// Whether a field says what is written.
fn is(found: &Value, written: &str) -> bool {
    match found {
        Value::Text(text) => text == written,
        Value::Number(found) => {
            let number = written.trim().parse::<f64>();
            number.is_ok_and(|n| (found - n).abs() <= SINGLE * n.abs().max(1e-3))
        }
        Value::Code(_) | Value::Row(..) => false,
    }
}

/// Tables of a document's archive. Errors: it is not accepted as it is, with what was found.
pub(super) fn compile(text: &str) -> Result<Vec<Rows>, String> {
    let include_folder = Some(super::folder().join("parts"));
    let reading = ReadOptions { include_folder, ..ReadOptions::default() };
    let options = CompileOptions::default();
    let compiled = compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {})
        .map_err(|error| error.to_string())?;
    let rows = match (compiled.verdict, compiled.rows) {
        (Verdict::Accepted, Some(rows)) => rows,
        _ => {
            let told = compiled.diagnostics.iter().filter(|told| told.rejects);
            let told = told.map(|t| format!("line {}: {}", t.line, t.finding.message));
            return Err(told.collect::<Vec<_>>().join("\n"));
        }
    };
    let bytes = mapd_archive::encode(&rows, &compiled.provenance).map_err(|e| e.to_string())?;
    let entries = mapd_archive::directory(&bytes).map_err(|error| error.to_string())?;
    let tables: Vec<(u32, &[u8])> = entries
        .iter()
        .filter_map(|entry| {
            let from = usize::try_from(entry.offset).ok()?;
            let length = usize::try_from(entry.count).ok()? * entry.row_bytes as usize;
            Some((entry.number, bytes.get(from..from + length)?))
        })
        .collect();
    static DECODER: LazyLock<Decoder> =
        LazyLock::new(|| Decoder::new(&workspace()).expect("the layout reads"));
    DECODER.decode(&tables).map_err(|error| error.to_string())
}

fn table<'a>(tables: &'a [Rows], name: &str) -> Option<&'a Rows> {
    tables.iter().find(|rows| rows.name == name)
}

/// A field of a row; nothing where there is no such row.
fn cell(rows: Option<&Rows>, row: usize, field: usize) -> &[Value] {
    rows.and_then(|rows| rows.rows.get(row)?.get(field)).map_or(&[], Vec::as_slice)
}

/// Fields in which they differ, in the order of tables; places in the file count for nothing.
pub(super) fn differences(before: &[Rows], after: &[Rows]) -> Vec<Difference> {
    let mut out = Vec::new();
    let names = before.iter().chain(after).map(|rows| (&rows.name, &rows.fields));
    let mut seen = std::collections::BTreeSet::new();
    for (name, fields) in names {
        // Numbers and blocks of annotations change with their places.
        if !seen.insert(name) || name.starts_with("annotation_") {
            continue;
        }
        let (old, new) = (table(before, name), table(after, name));
        if old.zip(new).is_some_and(|(old, new)| old.rows == new.rows) {
            continue;
        }
        let count = |rows: Option<&Rows>| rows.map_or(0, |rows| rows.rows.len());
        for (i, field) in fields.iter().enumerate() {
            if ["line", "column"].contains(&field.as_str()) {
                continue;
            }
            let rows = 0..count(old).max(count(new));
            let cells = rows.map(|row| (cell(old, row, i), cell(new, row, i)));
            let differ = cells.filter(|(old, new)| old != new);
            let values: Vec<_> = differ.map(|(old, new)| (old.to_vec(), new.to_vec())).collect();
            if !values.is_empty() {
                let all = values.iter().flat_map(|(old, new)| old.iter().chain(new));
                let is_code = all.into_iter().all(|value| matches!(value, Value::Code(_)));
                out.push(Difference { table: name.clone(), field: field.clone(), is_code, values });
            }
        }
    }
    out
}
