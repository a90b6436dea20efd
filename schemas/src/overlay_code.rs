//! Rust code of the overlay's rows and tables, from `overlay.toml`.

use crate::archive::{Layout, Table};
use crate::archive_code::{accessors_of, element, row_imports_of, rows_of, verify_table, view};
use std::fmt::Write as _;

const NOTE: &str = "// Written by `cargo run -p mapd-schemas` from schemas/overlay.toml; change that file instead.\n\n";

/// The part's name, which its files begin with.
const PART: &str = "overlay";

/// Name of each file and its code.
pub(crate) fn files(layout: &Layout) -> Vec<(String, String)> {
    let tables = layout.by_number();
    let rows = rows_of("Row types of an overlay.", NOTE, &layout.tables);
    let accessors = accessors_of("Reading the rows of an overlay.", (PART, NOTE), &layout.tables);
    let code = tables_of(&tables) + &filled(&tables) + &verification(&tables);
    vec![
        ("overlay_rows.rs".to_owned(), rows),
        ("overlay_accessors.rs".to_owned(), accessors),
        ("overlay_tables.rs".to_owned(), code),
    ]
}

fn tables_of(tables: &[&Table]) -> String {
    let mut out = format!("//! An overlay's tables.\n{NOTE}{}", row_imports_of(PART));
    out += "use crate::directory::{Reader, TableKind};\nuse crate::error::{OpenError, VerifyError};\nuse crate::table::Table;\nuse crate::verify::Check;\n\n";
    let _ = writeln!(
        out,
        "/// The tables of an overlay, by number.\npub(crate) const OVERLAY_TABLES: [TableKind; {}] = [",
        tables.len()
    );
    for t in tables {
        let _ = writeln!(
            out,
            "TableKind::new({}, \"{}\", {}, {:#018x}, {}),",
            t.number,
            t.name,
            t.element_bytes(),
            t.row_id(),
            t.required
        );
    }
    out += "];\n\n/// All tables of an opened overlay; those that it does not have are empty.\n#[derive(Clone, Copy)]\npub struct OverlayTables<'a> {\n";
    for t in tables {
        let _ = writeln!(out, "/// {}\npub {}: &'a [{}],", t.doc, t.name, view(t));
    }
    out += "}\n\nimpl<'a> OverlayTables<'a> {\npub(crate) fn read(directory: &mut Reader<'a>) -> Result<Self, OpenError> {\nOk(Self {\n";
    for (i, t) in tables.iter().enumerate() {
        let _ = writeln!(out, "{}: directory.take(&OVERLAY_TABLES[{i}])?,", t.name);
    }
    out + "})\n}\n}\n"
}

fn filled(tables: &[&Table]) -> String {
    let mut out = "\n/// All tables of an overlay as they are filled.\n#[derive(Default)]\npub struct OverlayRows {\n".to_owned();
    for t in tables {
        let _ = writeln!(out, "/// {}\npub {}: Table<{}>,", t.doc, t.name, element(t));
    }
    let count = tables.len();
    let _ = write!(
        out,
        "}}\n\nimpl OverlayRows {{\n/// The bytes of all tables, in the order of `OVERLAY_TABLES`.\npub(crate) fn bytes(&self) -> [&[u8]; {count}] {{\n[\n"
    );
    for t in tables {
        let _ = writeln!(out, "bytemuck::cast_slice(self.{}.as_slice()),", t.name);
    }
    out + "]\n}\n}\n"
}

fn verification(tables: &[&Table]) -> String {
    let mut out = "\nimpl OverlayTables<'_> {\n/// Proves every row: finite numbers, known codes, references and ranges inside their tables.\npub(crate) fn verify_rows(&self) -> Result<(), VerifyError> {\nlet strings = self.string_offsets.len().saturating_sub(1);\n".to_owned();
    for t in tables {
        out += &verify_table(t);
    }
    out + "Ok(())\n}\n}\n"
}
