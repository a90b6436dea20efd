//! Signals, controllers and right of way (docs/signals.md): first as written, then ids become rows, then places become
//! coordinates and lanes.

mod append;
mod attach;
mod index;
mod objects;
mod place;
mod read;
mod resolve;
mod right_of_way;
mod semantics;

use crate::options::CompileOptions;
use glam::DVec3;
use mapd_archive::{BoardGroupRow, ControlRow, ControllerRow, Rows, SignalRow};
use mapd_ontology::Ontology;
use mapd_xodr::source::Places;
use mapd_xodr::{Finding, Span};
use std::sync::Arc;

pub(crate) use index::build as index;
pub(crate) use resolve::resolve;

/// What is known of signals until every id and lane is.
#[derive(Default)]
pub(crate) struct Pending {
    /// What signals mean.
    pub(crate) ontology: Arc<Ontology>,
    signals: Vec<Written>,
    references: Vec<Reference>,
    controllers: Vec<(ControllerRow, Vec<ControlRow>, Span)>,
    board_groups: Vec<BoardGroupRow>,
}

/// A signal whose row stands in the table already.
struct Written {
    span: Span,
    /// Lanes that it is written to be for, from the lower to the higher number.
    validity: Box<[(i32, i32)]>,
    position: Position,
    on_carrier: OnCarrier,
}

/// Lateral and upward place on the board's carrier `[m]`. Few signals have one.
type OnCarrier = Option<Box<(f64, f64)>>;

/// Where a signal stands: nearly all by their s and t on the road that they are written in.
enum Position {
    Track,
    /// Id of the road; s, t, zOffset, hOffset.
    Road(Box<(u32, [f64; 4])>),
    /// x, y, z, hdg.
    Inertial(Box<[f64; 4]>),
}

/// A `signalReference`.
struct Reference {
    road: u32,
    /// The signal's id.
    id: u32,
    s: f64,
    t: f64,
    orientation: u8,
    validity: Box<[(i32, i32)]>,
    span: Span,
}

/// A place where a signal counts, before its lanes are known.
struct PlaceWritten {
    signal: u32,
    road: u32,
    s: f64,
    t: f64,
    orientation: u8,
    kind: u8,
    validity: Box<[(i32, i32)]>,
    /// Whether roads refer to the signal, or to what carries it: then they say which lanes it is for where a validity names none.
    has_references: bool,
    span: Span,
    line: u32,
    column: u32,
}

/// What `complete` needs besides rows.
#[derive(Default)]
pub(crate) struct Resolved {
    places: Vec<PlaceWritten>,
    /// Per signal row: where it stands.
    positions: Vec<(Position, OnCarrier)>,
    /// Rows of roads by the numbers of their ids.
    roads: Vec<(u32, u32)>,
}

impl Resolved {
    /// Moves places that are written in x, y and z; what has no image stays and lies beside the map, as its roads do not.
    pub(crate) fn move_by(&mut self, image: &dyn Fn(DVec3, f64) -> Option<(DVec3, f64)>) {
        for (position, _) in &mut self.positions {
            if let Position::Inertial(place) = position
                && let [x, y, z, heading] = &mut **place
                && let Some((at, turned)) = image(DVec3::new(*x, *y, *z), *heading)
            {
                (*x, *y, *z, *heading) = (at.x, at.y, at.z, turned);
            }
        }
    }
}

/// Fills positions, lanes and right of way of a map whose lane graph is complete. What belongs to no lane is a finding.
pub(crate) fn complete(
    rows: &mut Rows,
    resolved: &Resolved,
    options: &CompileOptions,
) -> Vec<Finding> {
    objects::resolve(rows);
    place::place(rows, resolved);
    let findings = attach::attach(rows, resolved, options.lane_reach);
    right_of_way::build(rows);
    findings
}

/// Line and column of a place.
fn line_of(places: &Places, span: Span) -> (u32, u32) {
    let position = places.place(span.start).position;
    (position.line, position.column)
}

/// A row in which nothing is known.
fn empty_row() -> SignalRow {
    bytemuck::Zeroable::zeroed()
}
