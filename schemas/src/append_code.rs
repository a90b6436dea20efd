//! Rust code that appends the rows of a part of a map to the whole.

use crate::archive::{Field, Layout, Table};
use crate::archive_code::{NOTE, ident, parts};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// The tables that something refers to, in the order in which they lie; strings first.
fn targets(layout: &Layout) -> Vec<&str> {
    let of_tables = layout.tables.iter().filter_map(|table| table.to.as_deref());
    let of_fields = layout.tables.iter().flat_map(|table| &table.fields);
    let named: BTreeSet<&str> =
        of_tables.chain(of_fields.filter_map(|field| field.to.as_deref())).collect();
    let tables = layout.tables.iter().map(|table| table.name.as_str());
    std::iter::once("strings").chain(tables).filter(|name| named.contains(name)).collect()
}

fn references(table: &Table) -> impl Iterator<Item = (&Field, &str)> {
    table.fields.iter().filter_map(|field| Some((field, field.to.as_deref()?)))
}

/// `RowMappings`, and what makes and uses it.
pub(crate) fn append(layout: &Layout) -> String {
    let targets = targets(layout);
    let mut out = format!("//! Appending the rows of a part of a map to the whole.\n{NOTE}");
    out += "use super::rows::Rows;\nuse crate::moves::RowMapping;\n\n";
    out += "/// Where the rows of a part of a map come to lie, of each table that something refers to.\npub struct RowMappings {\n";
    for name in &targets {
        let _ = writeln!(out, "/// `{name}`.\npub {name}: RowMapping,");
    }
    out += "}\n\nimpl Rows {\n/// Rows of a part of a map, to be appended to the whole. Row 0 of each table is not used, so that 0 and empty ranges\n/// from 0 on refer to nothing.\npub fn part() -> Self {\nfn unused<T: bytemuck::Zeroable>() -> crate::Table<T> {\nvec![T::zeroed()].into()\n}\nSelf {\n";
    for table in &layout.tables {
        let _ = writeln!(out, "{}: unused(),", table.name);
    }
    out += "}\n}\n\n/// Where the rows of a part would come to lie behind these; strings stay what they are.\npub fn moves(&self) -> RowMappings {\nRowMappings {\nstrings: RowMapping::appended_to(1),\n";
    for name in targets.iter().filter(|name| **name != "strings") {
        let _ = writeln!(out, "{name}: RowMapping::appended_to(self.{name}.len()),");
    }
    out += "}\n}\n\n/// Appends the rows of a part that move behind those that are there.\npub fn append(&mut self, part: &Self, moves: &RowMappings) {\n";
    for table in &layout.tables {
        out += &append_table(table, targets.contains(&table.name.as_str()));
    }
    out + "}\n}\n"
}

/// What lets each row refer to where what it refers to comes to lie.
pub(crate) fn move_rows(layout: &Layout) -> String {
    let mut out =
        format!("//! Letting rows refer to where what they refer to comes to lie.\n{NOTE}");
    out += "use super::append::RowMappings;\n";
    let refers = |table: &Table| table.fields_of.is_none() && references(table).next().is_some();
    for (part, ..) in parts(layout).iter().filter(|(.., tables)| tables.iter().any(refers)) {
        let _ = writeln!(out, "use super::{part}_rows::*;");
    }
    for table in layout.tables.iter().filter(|table| table.fields_of.is_none()) {
        let Some(row) = table.row.as_ref().filter(|_| references(table).next().is_some()) else {
            continue;
        };
        let _ = writeln!(
            out,
            "\nimpl {row} {{\n/// Lets the row refer to where what it refers to comes to lie.\npub fn move_by(&mut self, moves: &RowMappings) {{"
        );
        for (field, to) in references(table) {
            let kind = if field.kind == "range" { "range" } else { "row" };
            let _ = match &field.count {
                // Moved ranges are as long as they were.
                Some(count) => writeln!(
                    out,
                    "self.{0} = moves.{to}.range(crate::Range {{ first: self.{0}, count: self.{count}.into() }}).first;",
                    ident(field)
                ),
                None => writeln!(out, "self.{0} = moves.{to}.{kind}(self.{0});", ident(field)),
            };
        }
        out += "}\n}\n";
    }
    out
}

fn append_table(table: &Table, is_target: bool) -> String {
    let name = &table.name;
    let rows = format!("part.{name}.get(1..).unwrap_or_default()");
    let code = if let Some(to) = &table.to {
        format!("self.{name}.extend({rows}.iter().map(|row| moves.{to}.row(*row)));\n")
    } else if references(table).next().is_some() {
        format!(
            "let before = self.{name}.len();\nself.{name}.extend_from_slice({rows});\nself.{name}.iter_mut().skip(before).for_each(|row| row.move_by(moves));\n"
        )
    } else {
        format!("self.{name}.extend_from_slice({rows});\n")
    };
    if is_target { format!("if moves.{name}.is_appended() {{\n{code}}}\n") } else { code }
}
