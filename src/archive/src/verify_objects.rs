//! Proving what the tables of objects say about each other.

use crate::error::VerifyError;
use crate::verify::{Check, tree};
use crate::{NONE, Tables};

/// Objects lie in the order of their roads and own their copies and lanes; the index is a complete tree over every place of
/// theirs; what belongs to a lane is listed by lane and s.
pub(crate) fn objects(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let mut before = (0, 0);
    let (mut copies, mut lanes) = (0u64, 0u64);
    for (row, object) in tables.objects.iter().enumerate() {
        let check = Check { table: "objects", row };
        let owner = (object.road(), object.junction());
        if owner < before || (owner.0 == NONE) == (owner.1 == NONE) {
            return check.fail("road", format!("after {before:?}"), format!("{owner:?}"));
        }
        before = owner;
        for (field, range, end) in
            [("copies", object.copies(), &mut copies), ("lanes", object.lanes(), &mut lanes)]
        {
            if range.count > 0 && u64::from(range.first) != *end {
                return check.fail(field, format!("rows from {end}"), format!("{range:?}"));
            }
            *end = (*end).max(range.end());
        }
        if object.copies().of(tables.object_copies).iter().any(|copy| copy.object() as usize != row)
        {
            return check.fail("copies", "copies of this object", format!("{:?}", object.copies()));
        }
        if object.lanes().of(tables.object_lanes).iter().any(|lane| lane.object() as usize != row) {
            return check.fail("lanes", "lanes of this object", format!("{:?}", object.lanes()));
        }
    }
    for (table, found, owned) in [
        ("object_copies", tables.object_copies.len(), copies),
        ("object_lanes", tables.object_lanes.len(), lanes),
    ] {
        if found as u64 != owned {
            return Check { table, row: 0 }.fail("", format!("{owned} rows of objects"), found);
        }
    }
    by_lane(tables)?;
    by_object(tables)?;
    index(tables)
}

/// `lane_objects` lists each row of `object_lanes` once, by lane and s.
fn by_lane(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let at = |row| Check { table: "lane_objects", row };
    if tables.lane_objects.len() != tables.object_lanes.len() {
        let expected = format!("{} rows", tables.object_lanes.len());
        return at(0).fail("", expected, tables.lane_objects.len());
    }
    let key =
        |row: u32| tables.object_lanes.get(row as usize).map(|of| (of.lane(), of.s_from(), row));
    for (row, pair) in tables.lane_objects.windows(2).enumerate() {
        if key(pair[0]) >= key(pair[1]) {
            return at(row + 1).fail("", format!("after {}", pair[0]), pair[1]);
        }
    }
    Ok(())
}

/// `object_signals` lists the links that name objects of the map, each once, by object.
fn by_object(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let at = |row| Check { table: "object_signals", row };
    let links = tables.signal_links.iter().filter(|link| link.object() != NONE).count();
    if tables.object_signals.len() != links {
        return at(0).fail("", format!("{links} rows"), tables.object_signals.len());
    }
    let key = |row: u32| (tables.signal_links.get(row as usize).map(|link| link.object()), row);
    for (row, number) in tables.object_signals.iter().enumerate() {
        let before = row.checked_sub(1).and_then(|row| tables.object_signals.get(row));
        let is_object = key(*number).0.is_some_and(|object| object != NONE);
        if !is_object || before.is_some_and(|before| key(*before) >= key(*number)) {
            return at(row).fail("", "links of objects, by object", number);
        }
    }
    Ok(())
}

/// The index holds every place once: of an object that is not repeated itself, of others their copies.
fn index(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let objects = tables.objects.len();
    let is_template =
        |item: usize| tables.objects.get(item).is_some_and(|object| object.copies().count > 0);
    let index = PackedIndex {
        levels_name: "object_index_levels",
        levels: tables.object_index_levels,
        nodes: tables.object_index_nodes.len(),
        items_name: "object_index_items",
        items: tables.object_index_items,
    };
    each_once(index, objects + tables.object_copies.len(), |item| !is_template(item))
}

/// The signals' index is a complete tree that holds every signal once.
pub(crate) fn signal_index(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let index = PackedIndex {
        levels_name: "signal_index_levels",
        levels: tables.signal_index_levels,
        nodes: tables.signal_index_nodes.len(),
        items_name: "signal_index_items",
        items: tables.signal_index_items,
    };
    each_once(index, tables.signals.len(), |_| true)
}

/// A packed index over places, with the names of its tables.
struct PackedIndex<'a> {
    levels_name: &'static str,
    levels: &'a [u32],
    /// Number of its nodes.
    nodes: usize,
    items_name: &'static str,
    items: &'a [u32],
}

/// A packed index is a complete tree over each of `count` things that belong into it, once.
fn each_once(
    PackedIndex { levels_name, levels, nodes, items_name: table, items }: PackedIndex<'_>,
    count: usize,
    belongs: impl Fn(usize) -> bool,
) -> Result<(), VerifyError> {
    tree(levels_name, levels, nodes, items.len())?;
    let mut seen = vec![false; count];
    for (row, item) in items.iter().enumerate() {
        match seen.get_mut(*item as usize) {
            Some(seen) if !*seen && belongs(*item as usize) => *seen = true,
            _ => return Check { table, row }.fail("", "a place, each once", item),
        }
    }
    let expected = (0..count).filter(|item| belongs(*item)).count();
    if items.len() != expected {
        return Check { table, row: 0 }.fail("", format!("{expected} places"), items.len());
    }
    Ok(())
}
