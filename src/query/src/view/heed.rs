//! The lane graph with an overlay applied, for searches.

use super::{View, is_touched, node_row};
use crate::graph::LaneNode;
use crate::lane::{Lane, edges_of};
use crate::map::Map;
use crate::route::{Bounds, Ways};
use crate::rules::{SpeedOrigin, SpeedRule};
use mapd_archive::{ArchivedTouchedRow, NONE, OverlayTables, VehicleClass};
use std::ops::Range;

/// Share by which a sum of lengths or times in single precision may be too small.
const ROUNDING: f64 = 1e-6;

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
    /// Whether ways may be shorter than the map says.
    shortens: bool,
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

/// What raised speeds shorten of times, and cuts of lengths and of times; none where the overlay does not say what its cuts do.
fn shortenings(tables: Option<&OverlayTables<'_>>) -> Option<[Shortening; 3]> {
    let Some(tables) = tables else { return Some([Shortening::NONE; 3]) };
    let raised = tables.overlay.first().map_or(Shortening::NONE, |row| Shortening {
        factor: row.time_factor(),
        saved: row.time_saved(),
    });
    let [length, time] = match tables.cuts.first() {
        Some(row) => [
            Shortening { factor: row.length_factor(), saved: row.length_saved() },
            Shortening { factor: row.time_factor(), saved: row.time_saved() },
        ],
        None if tables.pieces.len() > tables.nodes.len() => return None,
        None => [Shortening::NONE; 2],
    };
    Some([raised, length, time])
}

impl<'a> OverlaidGraph<'a> {
    pub(super) fn new(view: View<'a>, vehicle: VehicleClass) -> Self {
        let tables = view.tables();
        let all = shortenings(tables);
        let opens =
            tables.and_then(|tables| tables.overlay.first()).is_some_and(|row| row.opens() != 0);
        Self {
            view,
            vehicle,
            nodes: view.map.tables().lane_nodes.len() as u32,
            touched: tables.map_or(&[], |tables| tables.touched),
            shortens: all.is_some_and(|all| all.iter().any(|one| one.saved > 0.0)),
            has_bounds: !opens && all.is_some(),
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

    /// What the map's speeds make of a node's pieces before one that begins at this share of it `[cost]`.
    fn passed(&self, bounds: &Bounds<'a>, node: u32, before: f32) -> f64 {
        let Some(tables) = self.view.tables() else { return f64::INFINITY };
        let rows = self.view.pieces_of(node);
        let rows = tables.pieces.get(rows.start as usize..rows.end as usize).unwrap_or(&[]);
        let mut sum = 0.0;
        for row in rows.iter().take_while(|row| row.before() < before) {
            sum += f64::from(if bounds.times { row.time() } else { row.length() });
        }
        sum * bounds.per_unit * (1.0 + ROUNDING)
    }

    /// What is left of a bound where ways may be shorter than the map says, or on a piece of a node behind others: whoever goes on from there would also come there from the
    /// node's beginning, over the pieces before.
    #[cold]
    fn shortened(&self, mut least: f64, bounds: &Bounds<'a>, behind: Option<(u32, f32)>) -> f64 {
        if least == 0.0 {
            return least;
        }
        if self.shortens {
            let Some([raised, length, time]) = shortenings(self.view.tables()) else { return 0.0 };
            let all = if bounds.times { [time, raised] } else { [length, Shortening::NONE] };
            for one in all {
                least = one.left(least, bounds.per_unit);
            }
        }
        if let Some((node, before)) = behind {
            least -= self.passed(bounds, node, before);
        }
        least.max(0.0)
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
        let next = match index.saturating_add(1) < count {
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
            return enter(number.wrapping_sub(1));
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
        // Nodes beside each other are cut alike, but in a damaged overlay there may be no such piece.
        let piece = pieces.start.checked_add(index).filter(|piece| pieces.contains(piece))?;
        Some(self.nodes + piece)
    }

    fn follows(&self, before: u32, number: u32) -> bool {
        let ((own, index, count), (next, first, _)) = (self.base(before), self.base(number));
        let is_next = |before: u32, number: u32| before.checked_add(1) == Some(number);
        (own == next && is_next(index, first))
            || (is_next(index, count) && first == 0 && is_next(own, next))
    }

    /// A bound of the map's from a node's beginning holds from a piece of it on less the way to there. Changes of lane in the middle of nodes and raised speeds leave at least a
    /// share of it, and save at most so much in all.
    #[inline]
    fn least(&self, bounds: &Bounds<'a>, node: &LaneNode<'a>) -> f64 {
        let least = bounds.least(node.row);
        // Apart, so that the search itself stays short.
        let before = node.piece.map_or(0.0, |piece| piece.row.before());
        if self.shortens || before > 0.0 {
            let behind = (before > 0.0).then_some((node.number, before));
            return self.shortened(least, bounds, behind);
        }
        least
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
