//! Objects that signals name, once objects have rows.

use mapd_archive::{NONE, Rows};
use std::collections::HashMap;

/// Resolves references from signals to objects, and lists them by object.
pub(super) fn resolve(rows: &mut Rows) {
    // Of objects with one id, the first is meant.
    let mut objects: HashMap<u32, u32> = HashMap::new();
    if rows.signal_links.iter().any(|link| link.kind == 0) {
        for (row, object) in rows.objects.iter().enumerate() {
            objects.entry(object.id).or_insert(row as u32);
        }
    }
    let mut named: Vec<(u32, u32)> = Vec::new();
    for (row, link) in rows.signal_links.iter_mut().enumerate().filter(|(_, link)| link.kind == 0) {
        link.object = objects.get(&link.id).copied().unwrap_or(NONE);
        if link.object != NONE {
            named.push((link.object, row as u32));
        }
    }
    named.sort_unstable();
    rows.object_signals = named.into_iter().map(|(_, row)| row).collect::<Vec<_>>().into();
}
