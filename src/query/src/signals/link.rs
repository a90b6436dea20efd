//! What signals and objects have to do with each other.

use super::Signal;
use crate::map::Map;
use crate::objects::Object;
use mapd_archive::{ArchivedSignalLinkRow, Range, string};

/// Something that a signal names.
#[derive(Clone, Copy)]
pub struct SignalLink<'a> {
    /// The signal, where it is one and the map has it.
    pub signal: Option<Signal<'a>>,
    /// The object, where it is one and the map has it.
    pub object: Option<Object<'a>>,
    /// Id as written.
    pub id: &'a str,
    /// `type` as written.
    pub kind: &'a str,
    /// Whether an object is named.
    pub is_object: bool,
}

/// Rows of `signal_dependencies`.
pub(super) fn dependencies<'a>(
    map: Map<'a>,
    range: Range,
) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
    let tables = map.tables();
    range.of(tables.signal_dependencies).iter().map(move |row| SignalLink {
        signal: Signal::new(map, row.signal()),
        object: None,
        id: string(tables, row.id()),
        kind: string(tables, row.r#type()),
        is_object: false,
    })
}

/// Rows of `signal_links`.
pub(super) fn links<'a>(
    map: Map<'a>,
    range: Range,
) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
    let tables = map.tables();
    range.of(tables.signal_links).iter().map(move |row| SignalLink {
        signal: Signal::new(map, row.signal()),
        object: crate::objects::Object::new(map, row.object()),
        id: string(tables, row.id()),
        kind: string(tables, row.r#type()),
        is_object: row.kind() == 0,
    })
}

impl<'a> Signal<'a> {
    /// Signals that it controls or depends on.
    pub fn dependencies(&self) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
        dependencies(self.map, self.row.dependencies())
    }

    /// Objects and signals that belong to it, such as the pole that it hangs from.
    pub fn links(&self) -> impl ExactSizeIterator<Item = SignalLink<'a>> + use<'a> {
        links(self.map, self.row.links())
    }
}

impl<'a> Object<'a> {
    /// Signals that name it, themselves or by a board that they carry, in file order.
    pub fn signals(&self) -> impl Iterator<Item = Signal<'a>> + use<'a> {
        let (map, own) = (self.map, self.object_id().row());
        let tables = map.tables();
        let link = move |row: u32| -> Option<&'a ArchivedSignalLinkRow> {
            tables.signal_links.get(row as usize)
        };
        let before = |row: &u32| link(*row).is_some_and(|link| link.object() < own);
        let first = tables.object_signals.partition_point(before);
        let rows = tables.object_signals.get(first..).unwrap_or_default().iter();
        rows.map_while(move |row| link(*row).filter(|link| link.object() == own))
            .filter_map(move |link| Signal::new(map, link.owner()))
    }
}
