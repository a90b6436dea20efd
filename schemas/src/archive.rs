//! Reads `archive.toml` and checks that it describes a layout which can be written.

use anyhow::{Context, Result, bail, ensure};
use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Layout {
    pub(crate) format: u32,
    /// The rkyv version and flags that shape the bytes; part of the layout id.
    pub(crate) rkyv: String,
    #[serde(rename = "table")]
    pub(crate) tables: Vec<Table>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Table {
    pub(crate) name: String,
    /// Name of the row type, for tables of structs.
    pub(crate) row: Option<String>,
    /// Element type, for tables of plain numbers.
    pub(crate) scalar: Option<String>,
    /// Table that a plain u32 points into.
    pub(crate) to: Option<String>,
    pub(crate) doc: String,
    #[serde(default)]
    pub(crate) fields: Vec<Field>,
    /// The table that writes the fields of the row type out; none where this one does.
    #[serde(skip)]
    pub(crate) fields_of: Option<String>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Field {
    pub(crate) name: String,
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) to: Option<String>,
    /// The field of the same row that says how many rows from this one on are meant.
    pub(crate) count: Option<String>,
    #[serde(default)]
    pub(crate) optional: bool,
    pub(crate) codes: Option<u32>,
    pub(crate) unit: Option<String>,
    pub(crate) doc: String,
}

/// Bytes and alignment of a field type.
pub(crate) struct Size {
    pub(crate) bytes: usize,
    pub(crate) align: usize,
}

impl Layout {
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let text =
            std::fs::read_to_string(path).with_context(|| format!("reading {}", path.display()))?;
        let mut layout: Self = toml::from_str(&text)?;
        layout.share_rows();
        for table in &layout.tables {
            layout.check(table).with_context(|| format!("table {}", table.name))?;
        }
        Ok(layout)
    }

    /// Gives tables that name a row type without fields those of the table that writes them out.
    fn share_rows(&mut self) {
        let written = |t: &&Table| t.row.is_some() && !t.fields.is_empty();
        let of = |t: &Table| (t.row.clone(), t.name.clone(), t.fields.clone());
        let known: Vec<_> = self.tables.iter().filter(written).map(of).collect();
        for table in self.tables.iter_mut().filter(|t| t.row.is_some() && t.fields.is_empty()) {
            if let Some((_, name, fields)) = known.iter().find(|(row, ..)| *row == table.row) {
                table.fields_of = Some(name.clone());
                table.fields = fields.clone();
            }
        }
    }

    fn check(&self, table: &Table) -> Result<()> {
        ensure!(table.row.is_some() != table.scalar.is_some(), "needs either `row` or `scalar`");
        ensure!(table.row.is_some() != table.fields.is_empty(), "`fields` belong to `row`");
        let writes = |t: &&Table| t.row.is_some() && t.row == table.row && t.fields_of.is_none();
        ensure!(
            self.tables.iter().filter(writes).count() <= 1,
            "the row's fields are written twice"
        );
        self.target(table.to.as_deref())?;
        let mut offset = 0;
        let mut align = 1;
        for field in &table.fields {
            let size = size_of(&field.kind)?;
            ensure!(offset % size.align == 0, "{} would need padding before it", field.name);
            offset += size.bytes;
            align = align.max(size.align);
            self.target(field.to.as_deref())?;
            if let Some(count) = &field.count {
                let is_count = |f: &Field| f.name == *count && f.kind == "u16";
                ensure!(table.fields.iter().any(is_count), "no count {count} of type u16");
            }
        }
        ensure!(
            offset % align == 0,
            "the row would end in padding ({offset} bytes, alignment {align})"
        );
        Ok(())
    }

    fn target(&self, to: Option<&str>) -> Result<()> {
        match to {
            Some(to) if to != "strings" && !self.tables.iter().any(|t| t.name == to) => {
                bail!("no table {to}")
            }
            _ => Ok(()),
        }
    }

    /// Identifies the layout: whatever changes the meaning of a byte changes it, documentation does not.
    pub(crate) fn id(&self) -> [u8; 16] {
        let mut text = format!("mapd archive {}; {}\n", self.format, self.rkyv);
        for table in &self.tables {
            text += &format!("{} {:?} {:?}\n", table.name, table.scalar, table.to);
            for f in &table.fields {
                text += &format!(
                    "  {} {} {:?} {:?} {} {:?} {:?}\n",
                    f.name, f.kind, f.to, f.count, f.optional, f.codes, f.unit
                );
            }
        }
        let mut id = [0; 16];
        id.copy_from_slice(&blake3::hash(text.as_bytes()).as_bytes()[..16]);
        id
    }
}

impl Table {
    /// Bytes of one element.
    pub(crate) fn element_bytes(&self) -> usize {
        let kinds = self.scalar.iter().chain(self.fields.iter().map(|f| &f.kind));
        kinds.filter_map(|kind| size_of(kind).ok()).map(|size| size.bytes).sum()
    }
}

/// Splits "[f32; 16]" into the element type and the count.
pub(crate) fn array_of(kind: &str) -> Option<(&str, usize)> {
    let (element, count) = kind.strip_prefix('[')?.strip_suffix(']')?.split_once("; ")?;
    Some((element, count.parse().ok()?))
}

pub(crate) fn size_of(kind: &str) -> Result<Size> {
    if let Some((element, count)) = array_of(kind) {
        let size = size_of(element)?;
        return Ok(Size { bytes: size.bytes * count, align: size.align });
    }
    let (bytes, align) = match kind {
        "u8" => (1, 1),
        "u16" => (2, 2),
        "u32" | "i32" | "f32" => (4, 4),
        "u64" | "f64" => (8, 8),
        "range" => (8, 4),
        other => bail!("unknown type {other}"),
    };
    Ok(Size { bytes, align })
}
