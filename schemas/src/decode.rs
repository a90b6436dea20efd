//! Reading an archive's tables by the layout alone, without the types written from it: for tests that ask which field says what.

use crate::archive::{Layout, array_of, size_of};
use anyhow::{Context, Result};
use std::path::Path;

/// A number, a text or a place as it stands in a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number; of an array each by itself.
    Number(f64),
    /// A code or bits: one byte.
    Code(u8),
    /// A text that the row names.
    Text(String),
    /// A row of another table, or where a range begins and how long it is.
    Row(u32, u32),
}

/// The rows of one table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Name of the table.
    pub name: String,
    /// Names of the fields; a table of plain numbers has one without name.
    pub fields: Vec<String>,
    /// Values of the fields, row by row.
    pub rows: Vec<Vec<Vec<Value>>>,
}

/// A table that lies in an archive: number and bytes.
pub type Lying<'a> = (u32, &'a [u8]);

/// Reads tables by the layout of a workspace, which it reads once.
pub struct Decoder(Layout);

impl Decoder {
    /// Errors: the layout cannot be read.
    pub fn new(root: &Path) -> Result<Self> {
        Ok(Self(Layout::read(&root.join("schemas/archive.toml"))?))
    }

    /// Reads tables. Those that the layout does not have, and those of strings, are passed over.
    ///
    /// Errors: a table does not have its rows.
    pub fn decode(&self, tables: &[Lying<'_>]) -> Result<Vec<Rows>> {
        decode(&self.0, tables)
    }
}

fn decode(layout: &Layout, tables: &[Lying<'_>]) -> Result<Vec<Rows>> {
    let bytes_of = |name: &str| {
        let number = layout.tables.iter().find(|t| t.name == name).map(|t| t.number);
        tables.iter().find(|(n, _)| Some(*n) == number).map_or(&[][..], |(_, bytes)| *bytes)
    };
    let (texts, offsets) = (bytes_of("string_bytes"), bytes_of("string_offsets"));
    let text = |number: u32| {
        let at = |i: usize| offsets.get(4 * i..4 * i + 4).map(|bytes| number_of(bytes) as usize);
        let (start, end) = (at(number as usize)?, at(number as usize + 1)?);
        Some(String::from_utf8_lossy(texts.get(start..end)?).into_owned())
    };
    let mut out = Vec::new();
    for (number, bytes) in tables {
        let Some(table) = layout.tables.iter().find(|table| table.number == *number) else {
            continue;
        };
        if table.name.starts_with("string_") {
            continue;
        }
        let plain = table.scalar.iter().map(|kind| (String::new(), kind.clone(), table.to.clone()));
        let fields = table.fields.iter().map(|f| (f.name.clone(), f.kind.clone(), f.to.clone()));
        let fields: Vec<_> = plain.chain(fields).filter(|(name, ..)| name != "reserved").collect();
        let all = table.scalar.iter().cloned().chain(table.fields.iter().map(|f| f.kind.clone()));
        let kinds: Vec<String> = all.collect();
        let is_kept = |i: usize| table.fields.get(i).is_none_or(|f| f.name != "reserved");
        let mut rows = Vec::new();
        for row in bytes.chunks_exact(table.element_bytes().max(1)) {
            let (mut at, mut values) = (0, Vec::new());
            for (i, kind) in kinds.iter().enumerate() {
                let length = size_of(kind)?.bytes;
                let bytes = row.get(at..at + length).context("a row ends early")?;
                at += length;
                if !is_kept(i) {
                    continue;
                }
                let to = fields.get(values.len()).and_then(|(.., to)| to.as_deref());
                values.push(read(kind, bytes, to, &text)?);
            }
            rows.push(values);
        }
        let fields = fields.into_iter().map(|(name, ..)| name).collect();
        out.push(Rows { name: table.name.clone(), fields, rows });
    }
    Ok(out)
}

/// Where a field lies in the rows of its table.
#[derive(Clone, Debug)]
pub struct FieldPlace {
    /// Name of the table.
    pub table: String,
    /// The table's number in the directory.
    pub number: u32,
    /// Bytes of a row.
    pub row_bytes: usize,
    /// Name of the field; empty for a table of plain numbers.
    pub name: String,
    /// Type of the field, of an array that of its elements: `u8`, `f64`, `range` (two u32: first and count).
    pub kind: String,
    /// Number of elements: 1 unless it is an array.
    pub count: usize,
    /// Bytes of an element.
    pub element_bytes: usize,
    /// Where the field begins in a row \[bytes\].
    pub offset: usize,
}

/// All fields of the layout of a workspace, table by table, but for reserved ones.
///
/// Errors: the layout cannot be read.
pub fn fields(root: &Path) -> Result<Vec<FieldPlace>> {
    let layout = Layout::read(&root.join("schemas/archive.toml"))?;
    let mut out = Vec::new();
    for table in layout.by_number() {
        let plain = table.scalar.iter().map(|kind| (String::new(), kind.clone()));
        let fields = table.fields.iter().map(|field| (field.name.clone(), field.kind.clone()));
        let mut offset = 0;
        for (name, kind) in plain.chain(fields) {
            let bytes = size_of(&kind)?.bytes;
            let element = array_of(&kind).map_or(kind.as_str(), |(element, _)| element);
            let element_bytes = size_of(element)?.bytes;
            if name != "reserved" {
                out.push(FieldPlace {
                    table: table.name.clone(),
                    number: table.number,
                    row_bytes: table.element_bytes(),
                    name,
                    kind: element.to_owned(),
                    count: bytes / element_bytes.max(1),
                    element_bytes,
                    offset,
                });
            }
            offset += bytes;
        }
    }
    Ok(out)
}

fn number_of(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |all, byte| all << 8 | u32::from(*byte))
}

fn read(
    kind: &str,
    bytes: &[u8],
    to: Option<&str>,
    text: &impl Fn(u32) -> Option<String>,
) -> Result<Vec<Value>> {
    if let Some((element, _)) = array_of(kind) {
        let size = size_of(element)?.bytes;
        let mut out = Vec::new();
        for one in bytes.chunks_exact(size) {
            out.extend(read(element, one, to, text)?);
        }
        return Ok(out);
    }
    let eight = || <[u8; 8]>::try_from(bytes).context("eight bytes");
    let four = || <[u8; 4]>::try_from(bytes).context("four bytes");
    Ok(vec![match (kind, to) {
        ("u8", _) => Value::Code(bytes.first().copied().unwrap_or_default()),
        ("u16", _) => Value::Number(f64::from(number_of(bytes))),
        ("u32", Some("strings")) => {
            let number = number_of(bytes);
            text(number).map_or(Value::Row(number, 1), Value::Text)
        }
        ("u32", Some(_)) => Value::Row(number_of(bytes), 1),
        ("u32", None) => Value::Number(f64::from(number_of(bytes))),
        ("i32", _) => Value::Number(f64::from(i32::from_le_bytes(four()?))),
        ("f32", _) => Value::Number(f64::from(f32::from_le_bytes(four()?))),
        ("f64", _) => Value::Number(f64::from_le_bytes(eight()?)),
        ("u64", _) => Value::Number(u64::from_le_bytes(eight()?) as f64),
        _ => {
            let (first, count) = bytes.split_at(bytes.len() / 2);
            Value::Row(number_of(first), number_of(count))
        }
    }])
}
