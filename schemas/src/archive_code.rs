//! Rust code of the archive's rows and tables.

use crate::archive::{Field, Layout, Table, array_of};
use std::collections::BTreeSet;
use std::fmt::Write as _;

pub(crate) const NOTE: &str = "// Written by `cargo run -p mapd-schemas` from schemas/archive.toml; change that file instead.\n\n";

/// Parts of the generated code, so that no file grows too long: name, first table, what the tables hold.
pub(crate) const PARTS: [(&str, &str, &str); 6] = [
    ("network", "", "the network"),
    ("index", "index_levels", "the index over lanes"),
    ("beside", "surfaces", "what is derived from the network and lies beside it"),
    ("signal", "signals", "signals and of what is left out"),
    ("object", "objects", "objects"),
    ("annotation", "annotations", "what files say besides"),
];

/// Tables by the part that they are in.
pub(crate) fn parts(layout: &Layout) -> Vec<(&'static str, &'static str, &[Table])> {
    let first = |name: &str| layout.tables.iter().position(|table| table.name == name);
    let starts: Vec<usize> = PARTS.iter().map(|(_, table, _)| first(table).unwrap_or(0)).collect();
    let ends = starts.iter().skip(1).copied().chain([layout.tables.len()]);
    let ranges = starts.iter().copied().zip(ends);
    PARTS
        .iter()
        .zip(ranges)
        .map(|((name, _, what), (from, to))| (*name, *what, &layout.tables[from..to]))
        .collect()
}

/// Row types and accessors of the rows as they lie in an archive: name of each file and its code.
pub(crate) fn row_files(layout: &Layout) -> Vec<(String, String)> {
    let parts = parts(layout).into_iter();
    let files = parts.flat_map(|(name, what, tables)| {
        let rows = rows_of(&format!("Row types of the tables of {what}."), NOTE, tables);
        let accessors = accessors_of(&format!("Reading the rows of {what}."), (name, NOTE), tables);
        [(format!("{name}_rows.rs"), rows), (format!("{name}_accessors.rs"), accessors)]
    });
    files.collect()
}

pub(crate) fn rows_of(title: &str, note: &str, tables: &[Table]) -> String {
    let mut out = format!("//! {title}\n{note}");
    if tables.iter().flat_map(|table| &table.fields).any(|field| field.kind == "range") {
        out += "use crate::table::Range;\n";
    }
    out += "use bytemuck::{Pod, Zeroable};\nuse rkyv::Archive;\n";
    for table in tables {
        let Some(row) = table.row.as_ref().filter(|_| table.fields_of.is_none()) else { continue };
        let _ = write!(out, "\n/// {}\n", table.doc);
        out += "#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, PartialEq)]\n";
        out += "#[rkyv(derive(Pod, Zeroable, Clone, Copy))]\n#[repr(C)]\n";
        let _ = writeln!(out, "pub struct {row} {{");
        for field in &table.fields {
            let _ = writeln!(
                out,
                "/// {}{}\npub {}: {},",
                unit(field),
                field.doc,
                ident(field),
                native(&field.kind)
            );
        }
        out += "}\n";
        let _ = writeln!(
            out,
            "const _: () = assert!(size_of::<{row}>() == {0} && size_of::<Archived{row}>() == {0});",
            table.element_bytes()
        );
    }
    out
}

/// The field's name in Rust.
pub(crate) fn ident(field: &Field) -> &str {
    if field.name == "type" { "r#type" } else { &field.name }
}

pub(crate) fn accessors_of(title: &str, (part, note): (&str, &str), tables: &[Table]) -> String {
    let mut out = String::new();
    for table in tables {
        let Some(row) = table.row.as_ref().filter(|_| table.fields_of.is_none()) else { continue };
        let _ = writeln!(out, "\nimpl Archived{row} {{");
        for field in table.fields.iter().filter(|f| f.name != "reserved") {
            let _ = writeln!(out, "/// {}{}\n#[inline]", unit(field), field.doc);
            out += &getter(field);
        }
        out += "}\n";
    }
    let mut head = format!("//! {title}\n{note}");
    let _ = writeln!(head, "use super::{part}_rows::*;");
    for (used, import) in [("-> Range", "crate::table::Range"), ("rend::", "rkyv::rend")] {
        if out.contains(used) {
            let _ = writeln!(head, "use {import};");
        }
    }
    head + &out
}

fn unit(field: &Field) -> String {
    field.unit.as_ref().map(|u| format!("`[{u}]` ")).unwrap_or_default()
}

fn native(kind: &str) -> &str {
    if kind == "range" { "Range" } else { kind }
}

fn getter(field: &Field) -> String {
    let name = ident(field);
    match (field.kind.as_str(), array_of(&field.kind)) {
        ("u8", _) => format!("pub fn {name}(&self) -> u8 {{ self.{name} }}\n"),
        (kind, Some(("u8", _))) => format!("pub fn {name}(&self) -> &{kind} {{ &self.{name} }}\n"),
        ("range", _) => format!("pub fn {name}(&self) -> Range {{ self.{name}.to_native() }}\n"),
        (_, Some((element, count))) => format!(
            "pub fn {name}(&self) -> &[{element}; {count}] {{ bytemuck::cast_ref::<[rend::{element}_le; {count}], _>(&self.{name}) }}\n"
        ),
        (kind, None) => format!("pub fn {name}(&self) -> {kind} {{ self.{name}.to_native() }}\n"),
    }
}

/// Imports of all row types.
fn row_imports() -> String {
    PARTS.iter().map(|(part, ..)| row_imports_of(part)).collect()
}

/// Imports of a part's row types.
pub(crate) fn row_imports_of(part: &str) -> String {
    format!("use super::{part}_rows::*;\n")
}

/// What this release writes and knows: its format, features and the directory's entries.
pub(crate) fn known_tables(layout: &Layout) -> String {
    let mut out = format!("//! What this release writes and knows.\n{NOTE}");
    out += "use crate::directory::{Feature, TableKind};\n\n";
    let _ = writeln!(
        out,
        "/// Number of the format, raised by hand when old archives can no longer be read.\npub const FORMAT: u32 = {};",
        layout.format
    );
    let _ = writeln!(
        out,
        "/// Identifies what this release writes: numbers and row ids of all its tables.\npub const LAYOUT_ID: [u8; 16] = {:?};\n",
        layout.id()
    );
    out += "/// What this release knows of what a reader must know of, by bit of the header's `must_understand`.\n";
    let _ = writeln!(out, "pub const FEATURES: [Feature; {}] = [", layout.features.len());
    for f in &layout.features {
        let (bit, name, release) = (f.bit, &f.name, f.release);
        let _ = writeln!(out, "// {}", f.doc);
        let _ = writeln!(out, "Feature {{ bit: {bit}, name: {name:?}, release: {release:?} }},");
    }
    out += "];\n\n";
    let tables = layout.by_number();
    let _ = writeln!(
        out,
        "/// The tables that this release knows, by number.\npub(crate) const TABLES: [TableKind; {}] = [",
        tables.len()
    );
    for t in &tables {
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
    out + "];\n"
}

/// The rows as the compiler fills them.
pub(crate) fn filled(layout: &Layout) -> String {
    let mut out = format!("//! The archive's tables as they are filled.\n{NOTE}{}", row_imports());
    out += "use super::tables::Tables;\nuse crate::table::Table;\n\n";
    let tables = layout.by_number();
    out += "/// All tables of a map as the compiler fills them.\n#[derive(Default)]\npub struct Rows {\n";
    for t in &tables {
        let _ = writeln!(out, "/// {}\npub {}: Table<{}>,", t.doc, t.name, element(t));
    }
    out += "}\n\nimpl Rows {\n/// The rows as the tables that an archive of them would have, so that queries run while it is being built.\npub fn as_tables(&self) -> Tables<'_> {\nTables {\n";
    for t in &tables {
        let cast = if t.row.is_some() { "bytemuck::cast_slice" } else { "" };
        let _ = writeln!(out, "{0}: {cast}(self.{0}.as_slice()),", t.name);
    }
    out += "}\n}\n\n/// The bytes of all tables, as they lie in an archive, in the order of `TABLES`.\n";
    let _ = writeln!(out, "pub(crate) fn bytes(&self) -> [&[u8]; {}] {{\n[", tables.len());
    for t in &tables {
        let _ = writeln!(out, "bytemuck::cast_slice(self.{}.as_slice()),", t.name);
    }
    out + "]\n}\n}\n"
}

/// The borrowed tables.
pub(crate) fn tables(layout: &Layout) -> String {
    let mut out = format!("//! The archive's tables as they lie.\n{NOTE}{}", row_imports());
    out += "use super::known_tables::TABLES;\nuse crate::directory::Reader;\nuse crate::error::OpenError;\nuse crate::table::TableInfo;\nuse rkyv::rend;\n\n";
    let tables = layout.by_number();
    out += "/// All tables of an opened archive; those that it does not have are empty. Lengths and places were read once and\n/// checked; they stay what they are whatever happens to the bytes later.\n#[derive(Clone, Copy)]\npub struct Tables<'a> {\n";
    for t in &tables {
        let _ = writeln!(out, "/// {}\npub {}: &'a [{}],", t.doc, t.name, view(t));
    }
    out += "}\n\nimpl<'a> Tables<'a> {\n";
    out += "/// Takes the tables that this release knows from the directory.\npub(crate) fn read(directory: &mut Reader<'a>) -> Result<Self, OpenError> {\nOk(Self {\n";
    for (i, t) in tables.iter().enumerate() {
        let _ = writeln!(out, "{}: directory.take(&TABLES[{i}])?,", t.name);
    }
    out += "})\n}\n\n/// Name, element size and length of every table, in the order in which they lie.\n";
    let _ = writeln!(out, "pub fn infos(&self) -> [TableInfo; {}] {{\n[", tables.len());
    for t in &tables {
        let _ = writeln!(out, "TableInfo::of({1}, \"{0}\", self.{0}),", t.name, t.number);
    }
    out += "]\n}\n}\n";
    out += "\n// The element types as they lie in the bytes.\n";
    let scalars: BTreeSet<&str> = tables.iter().filter_map(|t| t.scalar.as_deref()).collect();
    for s in scalars.into_iter().filter(|s| *s != "u8") {
        let _ =
            writeln!(out, "const _: () = assert!(size_of::<rend::{s}_le>() == size_of::<{s}>());");
    }
    out
}

/// The row part of `verify()`.
pub(crate) fn verification(layout: &Layout) -> String {
    let mut out = format!("//! Proving the archive's rows.\n{NOTE}");
    out +=
        "use super::tables::Tables;\nuse crate::error::VerifyError;\nuse crate::verify::Check;\n\n";
    out += "impl Tables<'_> {\n/// Proves every row: finite numbers, known codes, references and ranges inside their tables.\npub(crate) fn verify_rows(&self) -> Result<(), VerifyError> {\nlet strings = self.string_offsets.len().saturating_sub(1);\n";
    for t in &layout.tables {
        out += &verify_table(t);
    }
    out + "Ok(())\n}\n}\n"
}

/// Codes that this release does not know.
pub(crate) fn unknown_codes(layout: &Layout) -> String {
    let mut out =
        format!("//! Codes of the archive's rows that this release does not know.\n{NOTE}");
    out += "use super::tables::Tables;\nuse crate::unknown::UnknownCodes;\n\nimpl Tables<'_> {\n";
    out += "/// Notes codes that this release does not know where nothing else depends on them.\npub(crate) fn note_unknown_codes(&self, found: &mut UnknownCodes) {\n";
    for t in &layout.tables {
        let open = |f: &&Field| f.codes.is_some() && !f.closed;
        let notes: String = t.fields.iter().filter(open).map(|f| note(t, f)).collect();
        if !notes.is_empty() {
            let _ =
                write!(out, "for (i, row) in self.{}.iter().enumerate() {{\n{notes}}}\n", t.name);
        }
    }
    out + "}\n}\n"
}

fn note(t: &Table, f: &Field) -> String {
    format!(
        "found.note(\"{}\", \"{}\", i, row.{}(), {});\n",
        t.name,
        f.name,
        ident(f),
        f.codes.unwrap_or_default()
    )
}

pub(crate) fn element(t: &Table) -> &str {
    t.row.as_deref().or(t.scalar.as_deref()).unwrap_or_default()
}

pub(crate) fn view(t: &Table) -> String {
    match &t.row {
        Some(row) => format!("Archived{row}"),
        None => t.scalar.clone().unwrap_or_default(),
    }
}

fn count(to: &str) -> String {
    if to == "strings" { "strings".into() } else { format!("self.{to}.len()") }
}

pub(crate) fn verify_table(t: &Table) -> String {
    let mut checks = String::new();
    if t.scalar.as_deref() == Some("f64") {
        checks += "check.finite(\"\", *row)?;\n";
    }
    if t.scalar.as_deref() == Some("f32") {
        checks += "check.finite(\"\", f64::from(*row))?;\n";
    }
    if let Some(to) = &t.to {
        let _ = writeln!(checks, "check.reference(\"\", *row, {}, false)?;", count(to));
    }
    for f in &t.fields {
        let (name, get) = (&f.name, ident(f));
        let array = array_of(&f.kind).map(|(element, _)| element);
        match (f.kind.as_str(), &f.to) {
            ("f64", _) => {
                let _ = writeln!(checks, "check.finite(\"{name}\", row.{get}())?;");
            }
            ("f32", _) => {
                let _ = writeln!(checks, "check.finite(\"{name}\", f64::from(row.{get}()))?;");
            }
            ("range", Some(to)) => {
                let _ = writeln!(checks, "check.range(\"{name}\", row.{get}(), {})?;", count(to));
            }
            ("u32", Some(to)) if f.count.is_some() => {
                let _ = writeln!(
                    checks,
                    "check.range(\"{name}\", crate::Range {{ first: row.{get}(), count: row.{}().into() }}, {})?;",
                    f.count.as_deref().unwrap_or_default(),
                    count(to)
                );
            }
            ("u32", Some(to)) => {
                let _ = writeln!(
                    checks,
                    "check.reference(\"{name}\", row.{get}(), {}, {})?;",
                    count(to),
                    f.optional
                );
            }
            ("u8", _) if f.closed => {
                let _ = writeln!(
                    checks,
                    "check.code(\"{name}\", row.{get}(), {})?;",
                    f.codes.unwrap_or_default()
                );
            }
            _ if array == Some("f32") => {
                let _ = writeln!(
                    checks,
                    "for value in row.{get}() {{ check.finite(\"{name}\", f64::from(*value))?; }}"
                );
            }
            _ => {}
        }
    }
    let mut out = String::new();
    if let Some(parent) = &t.parallel {
        let _ = writeln!(
            out,
            "Check {{ table: \"{0}\", row: 0 }}.parallel(self.{0}.len(), self.{parent}.len())?;",
            t.name
        );
    }
    if !checks.is_empty() {
        let _ = write!(
            out,
            "for (i, row) in self.{0}.iter().enumerate() {{\nlet check = Check {{ table: \"{0}\", row: i }};\n{checks}}}\n",
            t.name
        );
    }
    out
}
