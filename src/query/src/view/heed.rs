//! The lane graph with an overlay applied, for searches.

use super::{View, is_touched, node_row};
use crate::graph::{LaneNode, extremes_of_joined};
use crate::lane::{Lane, edges_of};
use crate::map::Map;
use crate::route::{Bounds, Ways};
use crate::rules::{SpeedOrigin, SpeedRule};
use mapd_archive::{ArchivedTouchedRow, NONE, VehicleClass};
use std::ops::Range;

/// A view, for a class of vehicles.
///
/// Numbers below the map's number of nodes are nodes of which the overlay says nothing that changes the vehicle's ways; from there on they are rows of its pieces.
#[derive(Clone, Copy)]
pub(super) struct OverlaidGraph<'a> {
    view: View<'a>,
    vehicle: VehicleClass,
    nodes: u32,
    /// Which nodes have pieces.
    touched: &'a [ArchivedTouchedRow],
    /// What raised speeds make of a time.
    raised: Shortening,
    /// What cuts make of a length and of a time.
    cuts: [Shortening; 2],
    has_bounds: bool,
}

/// By how much ways may be shorter than the map says.
#[derive(Clone, Copy)]
struct Shortening {
    /// At least this share is left,
    factor: f64,
    /// and all but so many metres or seconds.
    saved: f64,
}

impl Shortening {
    const NONE: Self = Self { factor: 1.0, saved: 0.0 };

    /// What is left of a bound at a cost of a metre or second.
    #[inline]
    fn left(self, least: f64, per_unit: f64) -> f64 {
        (least * self.factor).max(least - self.saved * per_unit)
    }
}

impl<'a> OverlaidGraph<'a> {
    pub(super) fn new(view: View<'a>, vehicle: VehicleClass) -> Self {
        let row = view.tables().and_then(|tables| tables.overlay.first());
        let cuts = view.tables().and_then(|tables| tables.cuts.first()).map(|row| {
            let length = Shortening { factor: row.length_factor(), saved: row.length_saved() };
            let time = Shortening { factor: row.time_factor(), saved: row.time_saved() };
            [length, time]
        });
        let is_cut = view.tables().is_some_and(|tables| tables.pieces.len() > tables.nodes.len());
        Self {
            view,
            vehicle,
            nodes: view.map.tables().lane_nodes.len() as u32,
            touched: view.tables().map_or(&[], |tables| tables.touched),
            raised: row.map_or(Shortening::NONE, |row| Shortening {
                factor: row.time_factor(),
                saved: row.time_saved(),
            }),
            cuts: cuts.unwrap_or([Shortening::NONE; 2]),
            has_bounds: row.is_none_or(|row| row.opens() == 0) && (cuts.is_some() || !is_cut),
        }
    }

    /// The piece that a number stands for.
    #[inline]
    fn piece(&self, number: u32) -> Option<u32> {
        number.checked_sub(self.nodes)
    }

    /// The number by which a node of the map is entered.
    #[inline]
    fn entered(&self, node: u32) -> u32 {
        let pieces = self.view.pieces_for(node, self.vehicle);
        if pieces.is_empty() { node } else { self.nodes + pieces.start }
    }

    /// The most that can lie before a piece of a node `[cost]`. From the piece one may change to one beside it, so that of the other's node as much is passed: all of the
    /// longest counts, since a node's parts need not count as their lengths do.
    #[cold]
    fn most_before(&self, bounds: &Bounds<'a>, node: &LaneNode<'a>) -> f64 {
        let whole = LaneNode { piece: None, ..*node };
        let [_, most] = match bounds.times {
            true => extremes_of_joined(&whole, |node| node.travel_time()),
            false => extremes_of_joined(&whole, |node| node.length()),
        };
        most * bounds.per_unit
    }

    /// The node of the map, the number of this piece in it, and how many it has.
    #[inline]
    fn base(&self, number: u32) -> (u32, u32, u32) {
        let Some(piece) = self.piece(number) else { return (number, 0, 1) };
        let row = self.view.tables().and_then(|tables| node_row(tables, piece));
        let Some(row) = row else { return (NONE, 0, 1) };
        let pieces = row.pieces();
        (row.node(), piece.wrapping_sub(pieces.first), pieces.count)
    }
}

impl<'a> Ways<'a> for OverlaidGraph<'a> {
    fn map(&self) -> Map<'a> {
        self.view.map
    }

    fn count(&self) -> usize {
        self.nodes as usize + self.view.tables().map_or(0, |tables| tables.pieces.len())
    }

    #[inline]
    fn node(&self, number: u32) -> Option<LaneNode<'a>> {
        match self.piece(number) {
            Some(piece) => self.view.piece(piece, self.vehicle),
            None => LaneNode::new(self.view.map, number),
        }
    }

    fn pieces(&self, node: u32) -> Range<u32> {
        let pieces = self.view.pieces_for(node, self.vehicle);
        if pieces.is_empty() {
            return node..node.saturating_add(1);
        }
        self.nodes + pieces.start..self.nodes + pieces.end
    }

    fn at(&self, lane: &Lane<'a>, s: f64, forward: bool) -> Option<u32> {
        let node = self.view.map.at(lane, s, forward)?;
        let piece = self.view.piece_among(self.view.pieces_for(node, self.vehicle), s, forward);
        Some(piece.map_or(node, |piece| self.nodes + piece))
    }

    #[inline]
    fn ahead(&self, number: u32, mut enter: impl FnMut(u32)) {
        let (node, index, count) = self.base(number);
        let (tables, beyond) = (self.view.map.tables(), [number.wrapping_add(1)]);
        // One loop, so that what is done with each is generated once.
        let next = match index + 1 < count {
            true => &beyond,
            false => edges_of(tables.successor_offsets, tables.successors, node),
        };
        for next in next {
            // A piece's number is beyond all bits.
            enter(if is_touched(self.touched, *next) { self.entered(*next) } else { *next });
        }
    }

    fn behind(&self, number: u32, mut enter: impl FnMut(u32)) {
        let (node, index, _) = self.base(number);
        if index > 0 {
            return enter(number - 1);
        }
        self.view.map.behind(node, |before| {
            let pieces = self.view.pieces_for(before, self.vehicle);
            enter(if pieces.is_empty() { before } else { self.nodes + pieces.end - 1 });
        });
    }

    #[inline]
    fn beside(&self, number: u32, node: &LaneNode<'a>, left: bool) -> Option<u32> {
        // A piece has the number of its node.
        let beside = self.view.map.beside(node.number, node, left)?;
        let pieces = self.view.pieces_for(beside, self.vehicle);
        if pieces.is_empty() {
            return Some(beside);
        }
        let (_, index, _) = self.base(number);
        Some(self.nodes + pieces.start + index)
    }

    fn follows(&self, before: u32, number: u32) -> bool {
        let ((own, index, count), (next, first, _)) = (self.base(before), self.base(number));
        (own == next && index + 1 == first) || (index + 1 == count && first == 0 && own + 1 == next)
    }

    /// A bound of the map's from a node's beginning holds from a piece of it on less the way to there. Changes of lane in the middle of nodes and raised speeds leave at least a
    /// share of it, and save at most so much in all.
    #[inline]
    fn least(&self, bounds: &Bounds<'a>, node: &LaneNode<'a>) -> f64 {
        let mut least = bounds.least(node.row);
        if least == 0.0 {
            return least;
        }
        if node.piece.is_some_and(|piece| piece.row.before() > 0.0) {
            least -= self.most_before(bounds, node);
        }
        let cuts = self.cuts[usize::from(bounds.times)];
        if cuts.saved > 0.0 {
            least = cuts.left(least, bounds.per_unit);
        }
        if bounds.times && self.raised.saved > 0.0 {
            least = self.raised.left(least, bounds.per_unit);
        }
        least.max(0.0)
    }

    fn limit(&self, number: u32, map: SpeedRule) -> SpeedRule {
        let lowest = self.piece(number).and_then(|piece| self.view.lowest(piece, self.vehicle));
        lowest.map_or(map, |(max, _)| SpeedRule {
            max: Some(max),
            origin: SpeedOrigin::Overlay,
            signal: None,
        })
    }

    fn has_bounds(&self) -> bool {
        self.has_bounds
    }
}
