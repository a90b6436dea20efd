//! What is known of a document while it is read and resolved: rows as they will be, and beside them what the file says until
//! every id and lane is known.
//!
//! Types only. `lower` fills them from elements, `resolve` makes rows of ids; parts of a document are appended here.

mod append;
mod interned;
mod joints;
mod lane_numbers;
mod links;
mod marks;
mod objects;
mod owners;
mod permissions;
mod placed;
mod signals;

use crate::options::Lowering;
use crate::without::Without;
use mapd_archive::{MapRow, Range, Rows, StringTable};
use mapd_xodr::{Finding, Span};
use std::sync::Arc;

pub(crate) use interned::Interned;
pub(crate) use joints::Joint;
pub(crate) use lane_numbers::LaneNumbers;
pub(crate) use links::{LaneLink, Links, RoadWritten};
pub(crate) use marks::Styles;
pub(crate) use objects::{
    Border, Corner, Curve, Details, Lateral, Marking, Object, Objects, Outline, OutlineCorners,
    Platform, Reference, Repeat, Station, Structure, Switch, Vertex, linear, shape, single,
};
pub(crate) use owners::{Owner, Owners};
pub(crate) use permissions::{Access, Mark, Permissions};
pub(crate) use placed::StatedGeoreference;
pub(crate) use signals::{OnCarrier, Position, SignalReference, Signals, WrittenSignal};

/// The rows of what has been read so far.
#[derive(Default)]
pub(crate) struct Draft {
    pub(crate) rows: Rows,
    pub(crate) strings: StringTable,
    /// Per road: place of its start tag, by which [`Links`] finds it in the network.
    pub(crate) road_spans: Vec<Span>,
    /// Number of connections that will have rows.
    pub(crate) connections: usize,
    /// Joints of junctions with an elevation grid.
    pub(crate) joints: Vec<Joint>,
    pub(crate) permissions: Permissions,
    pub(crate) objects: Objects,
    /// Where the map lies on Earth, as the header says it.
    pub(crate) placed: StatedGeoreference,
    /// Errors about geometries that lie too far away to be stored. A target frame says better what is wrong with their place.
    pub(crate) too_far: Vec<Finding>,
    pub(crate) styles: Styles,
    /// Sequences of cubics.
    pub(crate) cubics: Interned,
    /// Coefficients of geometries.
    pub(crate) coefficients: Interned,
    pub(crate) signals: Signals,
    /// What got rows of the top-level element that is being lowered.
    pub(crate) owners: Owners,
    /// What is left out of the archive.
    pub(crate) without: Without,
    pub(crate) map: Option<MapRow>,
}

impl Draft {
    /// Nothing yet; `ontology` says what signals mean.
    pub(crate) fn new(ontology: Arc<mapd_ontology::Ontology>, lowering: Lowering) -> Self {
        let Lowering { without, marks } = lowering;
        let permissions = Permissions { reading: marks, ..Permissions::default() };
        Self { signals: Signals::new(ontology), without, permissions, ..Self::default() }
    }

    pub(crate) fn roads(&self) -> usize {
        self.rows.roads.len()
    }

    /// Id and start tag of a road, by its row.
    pub(crate) fn road_named(&self, road: u32) -> Option<(String, Span)> {
        let row = self.rows.roads.get(road as usize)?;
        let id = String::from_utf8_lossy(self.strings.bytes_of(row.id)).into_owned();
        Some((id, self.road_spans.get(road as usize).copied().unwrap_or_default()))
    }

    /// Names the projection of a target frame as the map's. The file's own and the target as asked for, as strings.
    pub(crate) fn retarget(&mut self, definition: &str, target: &str) -> [u32; 2] {
        if let Some(map) = &mut self.map {
            map.projection = self.strings.add(definition);
        }
        [self.strings.add(&self.placed.definition), self.strings.add(target)]
    }
}

/// Rows between two lengths. Tables that outgrow 32 bits are refused at the end, before anything is written.
pub(crate) fn between(before: usize, after: usize) -> Range {
    Range::between(before, after).unwrap_or_default()
}
