//! What is compared of kept archives is complete: each field of each table changes a line of the texts beside them.

use mapd_client::Snapshot;
use mapd_schemas::decode::{FieldPlace, fields};
use mapd_tests::releases::{Parts, kept, texts};
use mapd_tests::workspace;
use std::collections::BTreeSet;

/// Fields that change no line: no feature exists yet. With a row of one, they leave this list and get a line.
const SILENT: [&str; 3] = ["features.bit", "features.name", "features.release"];

/// All that is compared of an archive.
fn text(parts: &Parts) -> String {
    let snapshot = Snapshot::from_bytes(parts.to_archive()).expect("opens");
    let texts = texts(snapshot.map()).expect("text");
    texts.map(|(_, text)| text).concat()
}

/// How rows are changed. One of them shows for each field: a bound that grows changes nothing, one that shrinks does.
const CHANGES: [Change; 4] = [
    Change { float: |value| value + 1.25, int: |value| value.wrapping_add(1) },
    Change { float: |_| 0.0, int: |_| 0 },
    Change { float: |value| value - 1e3, int: |value| value / 2 },
    Change { float: |value| value + 1e3, int: |value| value ^ 0x5555_5555 },
];

/// What becomes of a field's values.
struct Change {
    float: fn(f64) -> f64,
    int: fn(u64) -> u64,
}

impl Change {
    /// Of an element of a type.
    fn apply(&self, kind: &str, bytes: &mut [u8]) {
        match kind {
            "f64" => {
                let value = f64::from_le_bytes(*bytes.first_chunk().expect("eight bytes"));
                bytes.copy_from_slice(&(self.float)(value).to_le_bytes());
            }
            "f32" => {
                let value = f32::from_le_bytes(*bytes.first_chunk().expect("four bytes"));
                bytes.copy_from_slice(&((self.float)(value.into()) as f32).to_le_bytes());
            }
            // The number of rows.
            "range" => self.apply("u32", &mut bytes[4..]),
            _ => {
                let mut whole = [0; 8];
                whole[..bytes.len()].copy_from_slice(bytes);
                let whole = (self.int)(u64::from_le_bytes(whole)).to_le_bytes();
                bytes.copy_from_slice(&whole[..bytes.len()]);
            }
        }
    }

    /// Of a field in all rows.
    fn apply_to_field(&self, field: &FieldPlace, rows: &mut [u8]) {
        for row in rows.chunks_exact_mut(field.row_bytes) {
            for element in 0..field.count {
                let start = field.offset + element * field.element_bytes;
                self.apply(&field.kind, &mut row[start..start + field.element_bytes]);
            }
        }
    }
}

#[test]
fn each_field_changes_a_line() {
    let mut archives: Vec<_> = kept()
        .iter()
        .map(|path| {
            let parts = Parts::of(&std::fs::read(path).expect("readable"));
            let text = text(&parts);
            (parts, text)
        })
        .collect();
    // Short ones first: most fields show there.
    archives.sort_by_key(|(_, text)| text.len());
    let mut silent = BTreeSet::new();
    for field in fields(&workspace()).expect("the layout") {
        let shows = CHANGES.iter().any(|change| {
            archives.iter().any(|(parts, expected)| {
                let edit = |rows: &mut [u8]| change.apply_to_field(&field, rows);
                let changed = parts.edit_rows(field.number, edit);
                changed.is_some_and(|changed| text(&changed) != *expected)
            })
        });
        if !shows {
            silent.insert(format!("{}.{}", field.table, field.name));
        }
    }
    assert_eq!(silent, BTreeSet::from(SILENT.map(str::to_owned)));
}
