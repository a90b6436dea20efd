//! What a view answers.

use super::heed::OverlaidGraph;
use super::{OverlayEntry, Restriction, View};
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::ids::{LaneId, SignalId};
use crate::lane::Lane;
use crate::route::{
    AlternativeOptions, PositionOnLane, Reach, Reached, Route, RouteCost, RouteError, RouteRequest,
    RouteScratch, RouteStep, Routes, WithinCost, alternatives, find, find_via, network, reach,
};
use crate::rules::{OvertakingRule, SpeedRule};
use mapd_archive::{ArchivedPieceRow, Overlay, OverlayKind, VehicleClass};

/// Whether a class of vehicles may use a lane at a place.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Permission<'a> {
    /// Whether it may.
    pub is_allowed: bool,
    /// The entry that decides so; none where the map does.
    pub restriction: Option<Restriction<'a>>,
}

/// The speed limit at a place, with what is said of it today.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SpeedToday<'a> {
    /// Limit `[m/s]`; infinite if there is no limit; `None` if neither map nor overlay states one.
    #[cfg_attr(feature = "serde", serde(serialize_with = "crate::numbers::limit::serialize"))]
    pub max: Option<f64>,
    /// What the map says.
    pub map: SpeedRule,
    /// The entry that says otherwise.
    pub restriction: Option<Restriction<'a>>,
}

/// Whether a class of vehicles may overtake at a place, with what is said of it today.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OvertakingToday<'a> {
    /// Whether a sign or an entry forbids it to the class. Of signs, those for all count for motor vehicles, those for trucks for [`VehicleClass::Truck`].
    pub is_forbidden: bool,
    /// The map's signs.
    pub map: OvertakingRule,
    /// The first entry that forbids it to the class.
    pub restriction: Option<Restriction<'a>>,
}

impl<'a> View<'a> {
    /// Entries that hold now at s of a lane, in its direction of travel, for any class of vehicles, in the order of the overlay.
    ///
    /// Errors: an id of another map; an s that is no finite number.
    pub fn restrictions_at(
        &self,
        lane: LaneId,
        s: f64,
    ) -> Result<impl Iterator<Item = Restriction<'a>> + use<'a>, QueryError> {
        let own = self.map.lane(lane)?;
        if !s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        Ok(self.restrictions_in(&own, s))
    }

    /// [`View::restrictions_at`] of an s that is a number.
    fn restrictions_in(
        &self,
        lane: &Lane<'a>,
        s: f64,
    ) -> impl Iterator<Item = Restriction<'a>> + use<'a> {
        let section = lane.section();
        let s = mapd_geometry::clamp(s, section.s_start(), section.s_end());
        self.restrictions_on(self.piece_at(lane, s, lane.is_forward()))
    }

    /// Entries that hold now on a piece.
    pub(super) fn restrictions_on(
        &self,
        piece: Option<u32>,
    ) -> impl Iterator<Item = Restriction<'a>> + use<'a> {
        let (view, content) = (*self, self.map.content());
        self.piece_row(piece).into_iter().flat_map(move |(overlay, row)| {
            let node = overlay.tables.nodes.get(row.node() as usize);
            let node = node.and_then(|node| LaneNode::new(view.map, node.node()));
            let lane = node.map(|node| LaneId::new(node.row.lane(), content));
            let active = view.active_on(&overlay.tables, row);
            active.filter_map(move |(number, _)| restriction(overlay, number, row, lane?))
        })
    }

    /// What holds now, wherever it does: each entry once for each piece of a lane, for each way in which that is travelled.
    pub fn restrictions(&self) -> impl Iterator<Item = Restriction<'a>> + use<'a> {
        let view = *self;
        let count = self.tables().map_or(0, |tables| tables.pieces.len());
        (0..count as u32).flat_map(move |piece| view.restrictions_on(Some(piece)))
    }

    /// Whether a class of vehicles may use a lane at s, in its own direction: as [`crate::Lane::allows_at`], unless an entry closes or opens it. What one
    /// entry closes no other opens.
    ///
    /// Errors: as [`View::restrictions_at`].
    // Always: as `speed_rule_at`.
    #[inline(always)]
    pub fn allows(
        &self,
        lane: LaneId,
        s: f64,
        vehicle: VehicleClass,
    ) -> Result<Permission<'a>, QueryError> {
        let own = self.map.lane(lane)?;
        if !s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let is_open = own.allows_at(s, vehicle);
        if !self.touches(&own) {
            return Ok(Permission { is_allowed: is_open, restriction: None });
        }
        Ok(self.permission(&own, s, vehicle, is_open))
    }

    /// [`View::allows`] on a lane of which the overlay says something.
    #[cold]
    fn permission(
        &self,
        lane: &Lane<'a>,
        s: f64,
        vehicle: VehicleClass,
        is_open: bool,
    ) -> Permission<'a> {
        let plain = Permission { is_allowed: is_open, restriction: None };
        let Some((overlay, piece)) = self.piece_row(self.piece_at(lane, s, lane.is_forward()))
        else {
            return plain;
        };
        let mut opens = None;
        for (number, entry) in self.active_on(&overlay.tables, piece) {
            if entry.vehicles() & vehicle.bit() == 0 {
                continue;
            }
            match OverlayKind::from_code(entry.kind()) {
                OverlayKind::Closed => {
                    let restriction = restriction(overlay, number, piece, lane.lane_id());
                    return Permission { is_allowed: false, restriction };
                }
                OverlayKind::Open if !is_open => opens = opens.or(Some(number)),
                _ => {}
            }
        }
        let Some(number) = opens else { return plain };
        let restriction = restriction(overlay, number, piece, lane.lane_id());
        Permission { is_allowed: true, restriction }
    }

    /// The speed limit at s for a class of vehicles: the lowest that an entry states, else the map's ([`crate::Lane::speed_rule_at`]).
    ///
    /// Errors: as [`View::restrictions_at`].
    // Always: a call would copy the longer answer once more.
    #[inline(always)]
    pub fn speed_rule_at(
        &self,
        lane: LaneId,
        s: f64,
        vehicle: VehicleClass,
    ) -> Result<SpeedToday<'a>, QueryError> {
        // Looked at where the answer lies: `?` would copy the lane.
        let found = self.map.lane(lane);
        let own = match &found {
            Ok(own) => own,
            Err(error) => return Err(*error),
        };
        if !s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let map = own.speed_rule_at(s);
        if self.touches(own) {
            return Ok(self.speed_today(own, s, vehicle, map));
        }
        Ok(SpeedToday { max: map.max, map, restriction: None })
    }

    /// [`View::speed_rule_at`] on a lane of which the overlay says something.
    #[cold]
    fn speed_today(
        &self,
        lane: &Lane<'a>,
        s: f64,
        vehicle: VehicleClass,
        map: SpeedRule,
    ) -> SpeedToday<'a> {
        let mut today = SpeedToday { max: map.max, map, restriction: None };
        self.lower(&mut today, lane, self.piece_at(lane, s, lane.is_forward()), vehicle);
        today
    }

    /// Whether a class of vehicles may overtake at s: what the map's signs forbid ([`crate::Lane::overtaking_rule_at`]), and entries. What road marks forbid is with the
    /// lane graph's lane changes.
    ///
    /// Errors: as [`View::restrictions_at`].
    pub fn overtaking_rule_at(
        &self,
        lane: LaneId,
        s: f64,
        vehicle: VehicleClass,
    ) -> Result<OvertakingToday<'a>, QueryError> {
        let own = self.map.lane(lane)?;
        if !s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let map = own.overtaking_rule_at(s);
        let is_motor = vehicle.bit() & VehicleClass::MOTOR != 0;
        let by_sign = (map.all.is_some() && is_motor)
            || (map.trucks.is_some() && vehicle == VehicleClass::Truck);
        let forbids = |one: &Restriction<'a>| {
            one.entry.kind() == OverlayKind::NoOvertaking && one.entry.concerns(vehicle)
        };
        let restriction = self.restrictions_in(&own, s).find(forbids);
        let is_forbidden = by_sign || restriction.is_some();
        Ok(OvertakingToday { is_forbidden, map, restriction })
    }

    /// Takes the lowest limit that an entry states on a piece of a lane.
    pub(super) fn lower(
        &self,
        today: &mut SpeedToday<'a>,
        lane: &Lane<'a>,
        piece: Option<u32>,
        vehicle: VehicleClass,
    ) {
        let lowest = piece.and_then(|piece| self.lowest(piece, vehicle));
        let (Some((max, number)), Some((overlay, row))) = (lowest, self.piece_row(piece)) else {
            return;
        };
        today.max = Some(max);
        today.restriction = restriction(overlay, number, row, lane.lane_id());
    }

    /// The lowest limit that an entry states on a piece, and the number of the entry.
    pub(super) fn lowest(&self, piece: u32, vehicle: VehicleClass) -> Option<(f64, u32)> {
        let (overlay, row) = self.piece_row(Some(piece))?;
        let (mut lowest, mut by) = (f64::INFINITY, None);
        for (number, entry) in self.active_on(&overlay.tables, row) {
            let states = OverlayKind::from_code(entry.kind()) == OverlayKind::Speed
                && entry.vehicles() & vehicle.bit() != 0;
            if states && entry.value() < lowest {
                (lowest, by) = (entry.value(), Some(number));
            }
        }
        Some((lowest, by?))
    }

    /// The row of a piece.
    fn piece_row(&self, piece: Option<u32>) -> Option<(&'a Overlay<'a>, &'a ArchivedPieceRow)> {
        let overlay = self.overlay?;
        Some((overlay, overlay.tables.pieces.get(piece? as usize)?))
    }

    /// The entry by which a signal is out of service now, if one says so.
    ///
    /// Errors: an id of another map.
    pub fn signal_out_of_service(
        &self,
        signal: SignalId,
    ) -> Result<Option<OverlayEntry<'a>>, QueryError> {
        self.map.signal(signal)?;
        let Some(overlay) = self.overlay else { return Ok(None) };
        let rows = overlay.tables.signal_entries;
        let from = rows.partition_point(|row| row.signal() < signal.row());
        let own = rows.get(from..).unwrap_or(&[]).iter();
        let mut own = own.take_while(|row| row.signal() == signal.row());
        Ok(own.find_map(|row| {
            let entry = OverlayEntry::new(overlay, row.entry())?;
            self.holds(&entry).then_some(entry)
        }))
    }

    /// As [`crate::Map::route`], with the overlay's current entries applied: closed stretches are not entered, opened ones may be, and times are those of today's speeds. The
    /// lane of the start may be closed.
    ///
    /// Errors: as [`crate::Map::route`].
    pub fn route(
        &self,
        from: PositionOnLane,
        to: PositionOnLane,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        self.route_via(&[from, to], vehicle, cost, scratch, steps)
    }

    /// As [`crate::Map::route_via`], with the overlay's current entries applied.
    ///
    /// Errors: as [`crate::Map::route_via`].
    pub fn route_via(
        &self,
        places: &[PositionOnLane],
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        if self.overlay.is_none() {
            return self.map.route_via(places, vehicle, cost, scratch, steps);
        }
        find_via(OverlaidGraph::new(*self, vehicle), places, vehicle, cost, scratch, steps)
    }

    /// As [`crate::Map::find_route`], with the overlay's current entries applied.
    ///
    /// Errors: as [`crate::Map::find_route`].
    pub fn find_route(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        if self.overlay.is_none() {
            return self.map.find_route(request, scratch, steps);
        }
        steps.clear();
        find(OverlaidGraph::new(*self, request.vehicle), request, scratch, steps)
    }

    /// As [`crate::Map::alternatives`], with the overlay's current entries applied.
    ///
    /// Errors: as [`crate::Map::alternatives`].
    pub fn alternatives(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        options: &AlternativeOptions,
        scratch: &mut RouteScratch,
        out: &mut Routes,
    ) -> Result<(), RouteError> {
        if self.overlay.is_none() {
            return self.map.alternatives(request, options, scratch, out);
        }
        alternatives(OverlaidGraph::new(*self, request.vehicle), request, options, scratch, out)
    }

    /// As [`crate::Map::reachable`], with the overlay's current entries applied. If what the overlay says of the vehicle cuts a node, the answer lists its pieces one by one.
    ///
    /// Errors: as [`crate::Map::reachable`].
    pub fn reachable(
        &self,
        from: PositionOnLane,
        limit: f64,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        out: &mut Vec<Reached>,
    ) -> Result<(), QueryError> {
        if self.overlay.is_none() {
            return self.map.reachable(from, limit, vehicle, cost, scratch, out);
        }
        let starts = &[from.into()];
        let request = RouteRequest { starts, goals: &[], vehicle, cost, avoid: &[] };
        Ok(reach(OverlaidGraph::new(*self, vehicle), &request, limit, scratch, out)?)
    }

    /// As [`crate::Map::reach`], with the overlay's current entries applied; pieces as in [`View::reachable`].
    ///
    /// Errors: as [`crate::Map::reach`].
    pub fn reach(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        limit: f64,
        scratch: &mut RouteScratch,
        out: &mut Reach,
    ) -> Result<(), RouteError> {
        if self.overlay.is_none() {
            return self.map.reach(request, limit, scratch, out);
        }
        network(
            OverlaidGraph::new(*self, request.vehicle),
            request,
            WithinCost { limit, ahead: true },
            scratch,
            out,
        )
    }

    /// As [`crate::Map::reach_to`], with the overlay's current entries applied; pieces as in [`View::reachable`].
    ///
    /// Errors: as [`crate::Map::reach_to`].
    pub fn reach_to(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        limit: f64,
        scratch: &mut RouteScratch,
        out: &mut Reach,
    ) -> Result<(), RouteError> {
        if self.overlay.is_none() {
            return self.map.reach_to(request, limit, scratch, out);
        }
        network(
            OverlaidGraph::new(*self, request.vehicle),
            request,
            WithinCost { limit, ahead: false },
            scratch,
            out,
        )
    }

    /// What holds now along a route or any list of steps, in its order: each entry once for each stretch on which it holds that a step drives over.
    /// Where the step only begins or ends at its edge, it is not met; a step of no length meets what holds at its place.
    ///
    /// Errors: ids of another map.
    pub fn restrictions_along(
        &self,
        steps: &[RouteStep],
        vehicle: VehicleClass,
        out: &mut Vec<Restriction<'a>>,
    ) -> Result<(), QueryError> {
        out.clear();
        for step in steps {
            let lane = self.map.lane(step.lane)?;
            let (low, high) = (step.s_from.min(step.s_to), step.s_from.max(step.s_to));
            let concerned = |one: &Restriction<'a>| one.entry.concerns(vehicle);
            if low == high {
                let piece = self.piece_at(&lane, low, step.forward);
                out.extend(self.restrictions_on(piece).filter(concerned));
                continue;
            }
            let met = |one: &Restriction<'a>| one.s_from < high && one.s_to > low && concerned(one);
            for node in lane.nodes().filter(|node| node.is_forward() == step.forward) {
                for piece in self.pieces_of(node.number) {
                    out.extend(self.restrictions_on(Some(piece)).filter(met));
                }
            }
        }
        Ok(())
    }
}

/// An entry on a piece of a lane.
fn restriction<'a>(
    overlay: &'a Overlay<'a>,
    number: u32,
    piece: &ArchivedPieceRow,
    lane: LaneId,
) -> Option<Restriction<'a>> {
    let entry = OverlayEntry::new(overlay, number)?;
    Some(Restriction { entry, lane, s_from: piece.s_from(), s_to: piece.s_to() })
}
