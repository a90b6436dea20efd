//! The room along a path, station by station.

use super::edge::{Edge, EdgeMark};
use super::speed::Limit;
use super::{Path, Piece, Span};
use crate::error::QueryError;
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::route::Ways;
use crate::rules::SpeedRule;
use crate::waypoints::MOST_STATIONS;
use glam::DVec3;
use mapd_archive::VehicleClass;

/// Lanes beside the driven one that are looked at on either side at most; a damaged archive might lead round in a circle.
const MOST_BESIDE: usize = 64;

/// The room along a path, a column for each fact and an entry for each station. Left and right are as seen by the driver.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Corridor {
    /// S `[m]`.
    pub along: Vec<f64>,
    /// The driven lane.
    pub lane: Vec<LaneId>,
    /// s on its road `[m]`.
    pub s: Vec<f64>,
    /// Left edge of the driven lane, inertial on the plane h = 0 `[m]`.
    pub left: Vec<DVec3>,
    /// Right edge of the driven lane `[m]`.
    pub right: Vec<DVec3>,
    /// Left edge of the leftmost lane beside it that has its direction and is open to the vehicle `[m]`.
    pub outer_left: Vec<DVec3>,
    /// Right edge of the rightmost such lane `[m]`.
    pub outer_right: Vec<DVec3>,
    /// What lies on the left edge of the driven lane.
    pub left_mark: Vec<EdgeMark>,
    /// What lies on its right edge.
    pub right_mark: Vec<EdgeMark>,
    /// What lies on the left edge of the leftmost lane.
    pub outer_left_mark: Vec<EdgeMark>,
    /// What lies on the right edge of the rightmost lane.
    pub outer_right_mark: Vec<EdgeMark>,
    /// The speed limit, as [`Path::speed_at`] has it; of a view's corridor today's, with the origin [`SpeedOrigin::Overlay`](crate::rules::SpeedOrigin::Overlay)
    /// where an entry states it.
    pub speed: Vec<SpeedRule>,
    /// The road's surface on the driven line. Empty until [`Path::corridor_surface`] fills it.
    pub surface: Vec<CorridorSurface>,
}

/// The road's surface at a station.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CorridorSurface {
    /// Inertial position of the lane's middle on the surface `[m]`.
    pub position: DVec3,
    /// Unit normal, upwards.
    pub normal: DVec3,
    /// Friction coefficient, where the file gives one. The code of the material is [`Lane::material_at`]'s.
    pub friction: Option<f64>,
    /// Roughness as written, where the file gives one.
    pub roughness: Option<f64>,
}

impl Corridor {
    fn clear(&mut self) {
        let Self { along, lane, s, left, right, outer_left, outer_right, .. } = self;
        along.clear();
        lane.clear();
        s.clear();
        [left, right, outer_left, outer_right].into_iter().for_each(Vec::clear);
        let Self { left_mark, right_mark, outer_left_mark, outer_right_mark, .. } = self;
        let marks = [left_mark, right_mark, outer_left_mark, outer_right_mark];
        marks.into_iter().for_each(Vec::clear);
        self.speed.clear();
        self.surface.clear();
    }

    /// Number of stations.
    pub fn len(&self) -> usize {
        self.along.len()
    }

    /// Whether there are no stations.
    pub fn is_empty(&self) -> bool {
        self.along.is_empty()
    }
}

/// What holds for a while: the node that is driven on and what lies beside it.
struct CurrentNode<'a> {
    piece: u32,
    /// The number of the node among the ways; none where no node holds.
    number: Option<u32>,
    lane: Lane<'a>,
    /// Between which s the node holds.
    s: SRange,
    /// Left and right.
    sides: [Side<'a>; 2],
    limit: Limit,
}

/// One side of the driven lane: its own edge, and that of the outermost lane beside it.
struct Side<'a> {
    near: Edge<'a>,
    far: Option<Edge<'a>>,
}

impl<'a> CurrentNode<'a> {
    fn new(
        ways: impl Ways<'a>,
        lane: Lane<'a>,
        piece: &Piece,
        piece_number: u32,
        s: f64,
        vehicle: VehicleClass,
    ) -> Self {
        let named = |number: u32| Some((number, ways.node(number)?));
        let node = ways.at(&lane, s, piece.forward).and_then(named);
        let side = |is_left: bool| {
            let is_outer = |lane: &Lane<'a>| is_left == ((lane.number() > 0) == piece.forward);
            let change = |(number, node): &(u32, LaneNode<'a>)| {
                let to = ways.change(*number, node, is_left).and_then(|to| ways.node(to));
                to.is_some_and(|to| to.allows(vehicle))
            };
            let open = |(number, node): &(u32, LaneNode<'a>)| {
                let next = ways.beside(*number, node, is_left).and_then(named);
                next.filter(|(_, next)| next.allows(vehicle))
            };
            let beside = node.as_ref().and_then(open);
            let last = std::iter::successors(beside, open).take(MOST_BESIDE).last();
            let far = last.and_then(|outermost| {
                let lane = outermost.1.lane()?;
                Some(Edge::new(lane, is_outer(&lane), change(&outermost)))
            });
            let near = Edge::new(lane, is_outer(&lane), node.as_ref().is_some_and(change));
            Side { near, far }
        };
        let held = node.map_or(SRange { low: s, high: s }, |(_, node)| node.s_range());
        let sides = [side(true), side(false)];
        let number = node.map(|(number, _)| number);
        Self { piece: piece_number, number, lane, s: held, sides, limit: Limit::NONE }
    }
}

impl<'a> Path<'a, '_> {
    /// The room along the path from S on, a station every `step` metres and one at the end, `length` metres on or where the path ends. `out` is
    /// emptied first; it grows only if its capacity is too small. The surface is [`Path::corridor_surface`]'s.
    ///
    /// Errors: numbers that are not finite, a step that is not positive or gives more than a million stations up to there; a damaged archive.
    pub fn corridor(
        &self,
        from: f64,
        length: f64,
        step: f64,
        vehicle: VehicleClass,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        self.corridor_on(self.map, from, length, step, vehicle, out)
    }

    /// As [`Path::corridor`], on the path's map or under an overlay of it.
    pub(crate) fn corridor_on(
        &self,
        ways: impl Ways<'a>,
        from: f64,
        length: f64,
        step: f64,
        vehicle: VehicleClass,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        out.clear();
        if !(from.is_finite() && length.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        let from = mapd_geometry::clamp(from, 0.0, self.length());
        let end = mapd_geometry::clamp(from + length, from, self.length());
        if !(step > 0.0 && step.is_finite() && (end - from) / step <= MOST_STATIONS) {
            return Err(QueryError::Option("step"));
        }
        let mut driven: Option<CurrentNode<'a>> = None;
        let mut span = 0;
        let mut number = 0u64;
        loop {
            let next = from + number as f64 * step;
            number += 1;
            let along = if next < end { next } else { end };
            span = self.span_from(span, along);
            let own = self.buffer.spans.get(span).ok_or(QueryError::Corrupt)?;
            self.station(ways, own, along, vehicle, &mut driven, out)?;
            if along >= end {
                return Ok(());
            }
        }
    }

    /// Fills the column `surface` of a corridor of this path: heights with crossfall and lane heights, and what the lanes are made of. It
    /// costs about as much as the rest of the corridor.
    ///
    /// Errors: stations of another path; a damaged archive.
    pub fn corridor_surface(&self, room: &mut Corridor) -> Result<(), QueryError> {
        let Corridor { lane, s, surface, .. } = room;
        surface.clear();
        let mut last: Option<Lane<'a>> = None;
        for (id, s) in lane.iter().zip(s.iter()) {
            let lane = match last.filter(|last| last.lane_id() == *id) {
                Some(same) => same,
                None => self.map.lane(*id)?,
            };
            last = Some(lane);
            let edges = lane.edge_slopes(lane.place(*s)?.0);
            let (inner, outer) = (edges.inner.value, edges.outer.value);
            // What has no width holds nothing; elsewhere the lane holds its own middle.
            let own = (inner != outer).then_some(lane);
            let found = lane.road().surface_on(*s, 0.5 * (inner + outer), own)?;
            surface.push(CorridorSurface {
                position: found.position,
                normal: found.normal,
                friction: found.material.and_then(|material| material.friction),
                roughness: found.material.and_then(|material| material.roughness),
            });
        }
        Ok(())
    }

    /// The span that holds S, at a joint the later one, from one on that lies before it.
    fn span_from(&self, first: usize, along: f64) -> usize {
        let rest = self.buffer.spans.get(first + 1..).unwrap_or(&[]);
        first + rest.iter().take_while(|span| span.along <= along).count()
    }

    fn station(
        &self,
        ways: impl Ways<'a>,
        span: &Span,
        along: f64,
        vehicle: VehicleClass,
        driven: &mut Option<CurrentNode<'a>>,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        let s = span.s_at(along - span.along);
        let holds =
            |own: &CurrentNode<'_>| own.piece == span.piece && own.s.low <= s && s < own.s.high;
        let own = match driven {
            Some(own) if holds(own) => own,
            _ => {
                let (piece, lane) = self.piece(span).ok_or(QueryError::Corrupt)?;
                driven.insert(CurrentNode::new(ways, lane, piece, span.piece, s, vehicle))
            }
        };
        if along >= own.limit.until {
            own.limit = self.limit_from(span.piece as usize, along, s);
            if let Some(number) = own.number {
                own.limit.rule = ways.limit(number, own.limit.rule);
            }
        }
        // Lanes beside each other share the cut: what they differ by is t.
        let (at, _) = own.lane.place(s)?;
        let cut = own.lane.road().cross_section(at.s).ok_or(QueryError::Corrupt)?;
        let edges = own.lane.edge_slopes(at);
        let origin = self.map.origin().extend(0.0);
        let columns = [
            (&mut out.left, &mut out.outer_left, &mut out.left_mark, &mut out.outer_left_mark),
            (&mut out.right, &mut out.outer_right, &mut out.right_mark, &mut out.outer_right_mark),
        ];
        for (side, (near, far, near_mark, far_mark)) in own.sides.iter_mut().zip(columns) {
            let point = origin + cut.place(side.near.t(&edges));
            let mark = side.near.mark_at(at, s);
            near.push(point);
            near_mark.push(mark);
            let (point, mark) = match &mut side.far {
                Some(edge) => (origin + cut.place(edge.t_at(at)), edge.mark_at(at, s)),
                None => (point, mark),
            };
            far.push(point);
            far_mark.push(mark);
        }
        out.along.push(along);
        out.lane.push(own.lane.lane_id());
        out.s.push(s);
        out.speed.push(own.limit.rule);
        Ok(())
    }
}

/// Both edges of a lane, the driver's left one first.
pub(super) fn bounds(lane: &Lane<'_>, forward: bool, s: f64) -> Option<[DVec3; 2]> {
    let [left, right] = lane.bounds_at(s)?;
    Some(if lane.is_forward() == forward { [left, right] } else { [right, left] })
}
