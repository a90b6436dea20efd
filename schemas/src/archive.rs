//! Reads `archive.toml` and checks that it describes a layout which can be written.

use anyhow::{Context, Result, bail, ensure};
use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Layout {
    pub(crate) format: u32,
    /// Numbers of tables that are no longer written, and never used again.
    retired: Vec<u32>,
    #[serde(rename = "table")]
    pub(crate) tables: Vec<Table>,
    #[serde(rename = "feature", default)]
    pub(crate) features: Vec<Feature>,
}

/// Something that changes the meaning of tables that older readers know.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Feature {
    /// Its bit in the header's `must_understand`.
    pub(crate) bit: u32,
    pub(crate) name: String,
    /// First release that reads it.
    pub(crate) release: [u16; 3],
    pub(crate) doc: String,
}

/// Bits of the header's `must_understand`.
const FEATURE_BITS: u32 = 64;

/// Most bytes of a feature's name: those of `name` in the table `features`.
const FEATURE_NAME: usize = 32;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Table {
    pub(crate) name: String,
    /// Its number in the directory, fixed for ever.
    pub(crate) number: u32,
    /// Whether every archive has it; the others may be missing, which is the same as empty.
    #[serde(default)]
    pub(crate) required: bool,
    /// The table that this one has a row for each of, or none at all.
    pub(crate) parallel: Option<String>,
    /// Raised when unit, sign, order, completeness or meaning changes.
    #[serde(default = "first")]
    semantics: u32,
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
    /// Whether a code that is not known is an error.
    #[serde(default)]
    pub(crate) closed: bool,
    pub(crate) unit: Option<String>,
    pub(crate) doc: String,
}

fn first() -> u32 {
    1
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
        for feature in &layout.features {
            ensure!(feature.bit < FEATURE_BITS, "feature {}: no such bit", feature.name);
            ensure!(feature.name.len() <= FEATURE_NAME, "feature {}: too long", feature.name);
            let same = |f: &&Feature| f.bit == feature.bit || f.name == feature.name;
            ensure!(layout.features.iter().filter(same).count() == 1, "{} twice", feature.name);
        }
        Ok(layout)
    }

    /// The tables in the order in which they lie.
    pub(crate) fn by_number(&self) -> Vec<&Table> {
        let mut tables: Vec<&Table> = self.tables.iter().collect();
        tables.sort_by_key(|table| table.number);
        tables
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
        let number = table.number;
        ensure!(number > 0 && !self.retired.contains(&number), "{number} cannot be a number");
        let same = |t: &&Table| t.number == number || t.name == table.name;
        ensure!(self.tables.iter().filter(same).count() == 1, "its number or name is another's");
        self.target(table.parallel.as_deref())?;
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
            ensure!(field.codes.is_some() || !field.closed, "`closed` belongs to `codes`");
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

    /// Identifies the layout: numbers and row ids of all tables.
    pub(crate) fn id(&self) -> [u8; 16] {
        let mut text = format!("mapd archive {}\n", self.format);
        for table in self.by_number() {
            text += &format!("{} {:016x}\n", table.number, table.row_id());
        }
        let mut id = [0; 16];
        id.copy_from_slice(&blake3::hash(text.as_bytes()).as_bytes()[..16]);
        id
    }
}

impl Table {
    /// Identifies what a row is: names, types, references and semantics; neither documentation nor units nor codes.
    pub(crate) fn row_id(&self) -> u64 {
        let mut text = format!("{} {}\n", self.name, self.semantics);
        let mut element = |name: &str, kind: &str, to: &Option<String>, rest: &str| {
            text += &format!("{name}: {kind} -> {}{rest}\n", to.as_deref().unwrap_or("nothing"));
        };
        if let Some(scalar) = &self.scalar {
            element("", scalar, &self.to, "");
        }
        for field in &self.fields {
            let count = field.count.as_ref().map(|count| format!(" × {count}"));
            let optional = if field.optional { " or none" } else { "" };
            let rest = format!("{}{optional}", count.unwrap_or_default());
            element(&field.name, &field.kind, &field.to, &rest);
        }
        let mut id = [0; 8];
        id.copy_from_slice(&blake3::hash(text.as_bytes()).as_bytes()[..8]);
        u64::from_le_bytes(id)
    }

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
