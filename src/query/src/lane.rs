//! Lanes: edges, poses, polylines, neighbours and links.

use crate::beside::Beside;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::key::{LaneKey, LaneLayer};
use crate::map::Map;
use crate::polyline::{Points, Polyline};
use crate::position;
use crate::profile::{self, At, Slope};
use crate::road::{JOINT, Road};
use crate::section::LaneSection;
use crate::types::{Clamped, LaneEdges, LanePosition, Point, Pose, is_place, turned};
use glam::DVec3;
use mapd_archive::{ArchivedLaneRow, ArchivedLaneSpeedRow, LaneType, Range, SpeedKind, lane_flags};
use mapd_geometry::normalize_angle;
use std::borrow::Cow;

/// A lane of a section.
#[derive(Clone, Copy)]
pub struct Lane<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    pub(crate) row: &'a ArchivedLaneRow,
    pub(crate) section: LaneSection<'a>,
    pub(crate) road: Road<'a>,
}

/// A `lane/speed` record.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneSpeed {
    /// Start on the road `[m]`.
    pub s: f64,
    /// What the record says.
    pub kind: SpeedKind,
    /// Limit `[m/s]` if `kind` is `Value`, else 0.
    pub max: f64,
}

impl<'a> Lane<'a> {
    #[inline]
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        let row = map.tables().lanes.get(number as usize)?;
        let section = LaneSection::new(map, row.section())?;
        let road = section.road()?;
        Some(Self { map, number, row, section, road })
    }

    /// Dense id.
    pub fn lane_id(&self) -> LaneId {
        LaneId::new(self.number, self.map.content())
    }

    /// Row in the archive's table.
    #[inline]
    pub(crate) fn row_number(&self) -> u32 {
        self.number
    }

    /// OpenDRIVE's lane number: positive left of lane 0, negative right.
    #[inline]
    pub fn number(&self) -> i32 {
        self.row.number()
    }

    /// Whether the lane is the same as its namesake in the section before: it goes on while a section of the other side
    /// alone (`singleSide`) begins. Such pieces have one key, that of the section they are written in, and are linked.
    pub fn continues(&self) -> bool {
        self.row.continues() != 0
    }

    /// The lane's stable name.
    pub fn key(&self) -> LaneKey<'a> {
        LaneKey {
            road: Cow::Borrowed(self.road.id()),
            section: self.section.number().saturating_sub(u32::from(self.row.continues())),
            lane: self.number(),
            layer: if self.is_temporary() { LaneLayer::Temporary } else { LaneLayer::Permanent },
        }
    }

    /// The lane type.
    #[inline]
    pub fn kind(&self) -> LaneType {
        LaneType::from_code(self.row.kind())
    }

    /// The section.
    pub fn section(&self) -> LaneSection<'a> {
        self.section
    }

    /// The road.
    pub fn road(&self) -> Road<'a> {
        self.road
    }

    /// Whether vehicles travel towards +s (by traffic rule, side and `direction`). Left, right and ahead of a lane are those of
    /// this direction; of a lane that is used both ways, it is the one of its side by the traffic rule.
    pub fn is_forward(&self) -> bool {
        self.row.flags() & lane_flags::FORWARD != 0
    }

    /// Whether the lane is of the temporary layer (1.9). Such lanes have geometry, marks and speeds; they are found by
    /// [`Road::temporary_sections`] and their keys, not by queries in space, and are no part of the lane graph.
    #[inline]
    pub fn is_temporary(&self) -> bool {
        self.row.flags() & lane_flags::TEMPORARY != 0
    }

    /// Whether the lane may be travelled in both directions.
    pub fn is_bidirectional(&self) -> bool {
        self.row.flags() & lane_flags::BOTH != 0
    }

    /// `speed` records in ascending s.
    pub fn speeds(&self) -> impl ExactSizeIterator<Item = LaneSpeed> + use<'a> {
        self.speed_rows().iter().map(|r| LaneSpeed {
            s: r.s(),
            kind: SpeedKind::from_code(u8::try_from(r.kind()).unwrap_or(u8::MAX)),
            max: r.max(),
        })
    }

    /// Rows of its `speed` records.
    pub(crate) fn speed_rows(&self) -> &'a [ArchivedLaneSpeedRow] {
        let (rows, lane) = (self.map.tables().lane_speeds, self.number);
        let first = rows.partition_point(|row| row.lane() < lane);
        let rows = rows.get(first..).unwrap_or(&[]);
        // Lanes have few: to look for the end among all rows would take longer.
        let count = rows.iter().take_while(|row| row.lane() == lane).count();
        rows.get(..count).unwrap_or(&[])
    }

    /// Both edges at s, from the file's own polynomials (OpenDRIVE 1.8.1, 11.6). Negative widths count as 0. At the end of
    /// the lane's section what holds in the section counts, not what begins with the next. s outside the section counts as its
    /// nearer end; of an s that is not finite both edges are NaN.
    #[inline]
    pub fn edges_at(&self, s: f64) -> LaneEdges {
        let Ok((at, _)) = self.place(s) else { return LaneEdges::NOWHERE };
        self.edges(at)
    }

    /// Both edges at s in inertial coordinates, on the plane h = 0: the inner one first. s outside the lane's section counts as its
    /// nearer end. None for a damaged archive or an s that is not finite.
    pub fn edge_points_at(&self, s: f64) -> Option<[DVec3; 2]> {
        let (at, _) = self.place(s).ok()?;
        let edges = self.edges(at);
        let cut = self.road.cross_section(at.s)?;
        let origin = self.map.origin().extend(0.0);
        Some([edges.inner, edges.outer].map(|edge| origin + cut.place(edge)))
    }

    /// As [`Lane::edge_points_at`], the edge on the left of the lane's traffic first.
    pub fn bounds_at(&self, s: f64) -> Option<[DVec3; 2]> {
        let [inner, outer] = self.edge_points_at(s)?;
        let outer_is_left = (self.number() > 0) == self.is_forward();
        Some(if outer_is_left { [outer, inner] } else { [inner, outer] })
    }

    /// The place that an s means: within the lane's section and the reference line.
    ///
    /// Errors: an s that is not finite.
    #[inline]
    pub(crate) fn place(&self, s: f64) -> Result<(At, Clamped), QueryError> {
        if !s.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let (start, end) = (self.section.s_start(), self.section.s_end());
        let line = self.road.reference_end();
        let inside = mapd_geometry::clamp(s, start, end);
        let at = At { s: if inside > line { line } else { inside }, ..self.at(inside) };
        Ok((at, Clamped::of(s, start, end.min(line + JOINT))))
    }

    /// A place on the lane: at its end with what holds in its section, whatever begins with the next one.
    #[inline]
    pub(crate) fn at(&self, s: f64) -> At {
        At::within(s, self.section.s_start(), self.section.s_end())
    }

    /// Every s on the road at which a record begins that shapes this lane in space, in no order, repeated ones included:
    /// between two of them the lane is smooth.
    pub fn shape_breaks(&self) -> impl Iterator<Item = f64> + use<'a> {
        self.width_breaks()
            .chain(self.road.shape_breaks())
            .chain(self.road.temporary_lane_offsets().iter().map(|record| record.s()))
    }

    /// Those of [`Self::shape_breaks`] that are not of the whole road: for the compiler.
    #[doc(hidden)]
    pub fn width_breaks(&self) -> impl Iterator<Item = f64> + use<'a> {
        let cubics = self.map.tables().cubics;
        let section = self.section.row.lanes();
        let lanes = section.of(self.map.tables().lanes);
        let own = self.number.wrapping_sub(section.first) as usize;
        let center = lanes.binary_search_by(|lane| 0.cmp(&lane.number())).unwrap_or(own);
        let inner = lanes.get(own.min(center)..=own.max(center)).unwrap_or(&[]);
        inner.iter().flat_map(move |lane| lane.widths().of(cubics).iter().map(|record| record.s()))
    }

    /// Width at s `[m]`, never negative. As [`Lane::edges_at`] otherwise.
    pub fn width_at(&self, s: f64) -> f64 {
        self.edges_at(s).width()
    }

    /// Pose at s as the lane's traffic has it, `offset` `[m]` to its left of the lane's centre, on the plane h = 0. Heading and curvature are those of the line
    /// that keeps this offset from the centre, in driving direction: where the lane widens or shifts, it runs at an angle to the reference line. Slope and
    /// superelevation are the road's. s outside the lane's section is moved to its nearer end and flagged.
    ///
    /// Where records meet that do not fit, the later one counts, at the section's end the earlier. Beyond the centre of curvature the line runs backwards; the
    /// heading stays the driving direction.
    ///
    /// Errors: coordinates that are not finite; a damaged archive.
    pub fn pose_at(&self, s: f64, offset: f64) -> Result<Pose, QueryError> {
        let (at, clamped) = self.place(s)?;
        let pose = self.pose_beside_center(at, offset)?;
        Ok(Pose { clamped, ..pose })
    }

    /// The pose at a place of the lane, so far to the left of its centre as its traffic goes `[m]`.
    pub(crate) fn pose_beside_center(&self, at: At, offset: f64) -> Result<Pose, QueryError> {
        let forward = self.is_forward();
        let center = self.center_bend(at);
        let t = Slope {
            value: center.slope.value + if forward { offset } else { -offset },
            ..center.slope
        };
        let pose = self.road.pose(at, t.value, 0.0)?;
        let piece = self.road.piece_at(at).ok_or(QueryError::Corrupt)?;
        let beside = Beside::new(&self.road, at, self.road.roll(at), t);
        let roll = profile::bend(self.road.superelevations(), at);
        let curvature = beside.curvature(&piece.rates(at.s), center.second, &roll);
        let along = Pose { curvature, ..pose };
        let turn = beside.turn(piece.speed_and_curvature(at.s));
        let heading = self.heading_along(pose.heading, turn);
        Ok(Pose { heading, ..if forward { along } else { along.turned() } })
    }

    /// Heading of the lane's traffic on a line that turns by `turn` off the reference line, whose heading is known `[rad]`, in (−π, π].
    #[inline]
    pub(crate) fn heading_along(&self, line: f64, turn: f64) -> f64 {
        // Most lines do not, and what is in range stays as it is.
        let along = if turn == 0.0 { line } else { normalize_angle(line + turn) };
        if self.is_forward() { along } else { turned(along) }
    }

    /// Pose at s in the road's frame: heading and curvature are those of the reference line, ahead is the way s rises, and `offset` `[m]` counts from the
    /// lane's centre to the left of that. Otherwise as [`Lane::pose_at`].
    ///
    /// Errors: as [`Lane::pose_at`].
    pub fn pose_of_reference_line(&self, s: f64, offset: f64) -> Result<Pose, QueryError> {
        let (at, clamped) = self.place(s)?;
        let pose = self.road.pose(at, self.edges(at).center() + offset, 0.0)?;
        Ok(Pose { clamped, ..pose })
    }

    /// A point in the lane's coordinates: exact foot on the reference line within the lane's section, distance from
    /// the lane's area.
    ///
    /// Errors: coordinates that are not finite; a damaged archive; lane 0, which has no area.
    pub fn position_of(&self, point: impl Into<Point>) -> Result<LanePosition, QueryError> {
        let point = point.into();
        if !is_place(point.xy) {
            return Err(QueryError::NotFinite);
        }
        position::position_in(self, point.xy - self.map.origin()).ok_or(QueryError::Corrupt)
    }

    /// Whether a point lies in the lane's area, edges included, in plan view.
    ///
    /// Errors: as [`Lane::position_of`].
    pub fn contains(&self, point: impl Into<Point>) -> Result<bool, QueryError> {
        let point = point.into();
        if !is_place(point.xy) {
            return Err(QueryError::NotFinite);
        }
        position::is_in(self, point.xy - self.map.origin()).ok_or(QueryError::Corrupt)
    }

    /// The points of the centre line.
    #[inline]
    pub(crate) fn center_points(&self) -> Points<'a> {
        Points::center(self.map.tables(), self.section.row, self.row)
    }

    fn border_of(&self, row: &ArchivedLaneRow) -> Polyline<'a> {
        let points = Points::border(self.map.tables(), self.section.row, row);
        Polyline::new(self.map.origin().extend(0.0), self.section.row, points)
    }

    /// Centre line in ascending s. Empty for lane 0.
    pub fn center_line(&self) -> Polyline<'a> {
        Polyline::new(self.map.origin().extend(0.0), self.section.row, self.center_points())
    }

    /// The border away from lane 0, in ascending s; for lane 0 the shifted reference line.
    pub fn border(&self) -> Polyline<'a> {
        self.border_of(self.row)
    }

    /// The next lane towards lane 0, lane 0 included; none for lane 0 itself.
    pub fn inner(&self) -> Option<Lane<'a>> {
        let step = i64::from(self.number().signum());
        if step == 0 {
            return None;
        }
        // Rows run from left to right, from high numbers to low ones.
        let lane = Lane::new(self.map, u32::try_from(i64::from(self.number) + step).ok()?)?;
        (lane.row.section() == self.row.section()).then_some(lane)
    }

    /// Border on the left of the lane's traffic, in ascending s.
    pub fn left_bound(&self) -> Polyline<'a> {
        if self.is_forward() {
            self.left_bound_of_reference_line()
        } else {
            self.right_bound_of_reference_line()
        }
    }

    /// Border on the right of the lane's traffic, in ascending s.
    pub fn right_bound(&self) -> Polyline<'a> {
        if self.is_forward() {
            self.right_bound_of_reference_line()
        } else {
            self.left_bound_of_reference_line()
        }
    }

    /// Border on the left of the reference line's direction, in ascending s.
    pub fn left_bound_of_reference_line(&self) -> Polyline<'a> {
        if self.number() >= 0 { self.border() } else { self.neighbour_border(-1) }
    }

    /// Border on the right of the reference line's direction, in ascending s.
    pub fn right_bound_of_reference_line(&self) -> Polyline<'a> {
        if self.number() <= 0 { self.border() } else { self.neighbour_border(1) }
    }

    /// A border is stored once, with the lane on its inner side; rows run from left to right.
    fn neighbour_border(&self, step: i64) -> Polyline<'a> {
        let at = usize::try_from(i64::from(self.number) + step).unwrap_or(usize::MAX);
        let row = self.map.tables().lanes.get(at).unwrap_or(self.row);
        self.border_of(row)
    }

    /// The next lane to the left of this lane's traffic, whichever way it is travelled itself; lane 0 is skipped. One that
    /// shares the direction and may be changed to is [`LaneNode::change_left`](crate::graph::LaneNode::change_left).
    pub fn left(&self) -> Option<Lane<'a>> {
        self.beside(if self.is_forward() { -1 } else { 1 })
    }

    /// The next lane to the right of this lane's traffic, as [`Lane::left`].
    pub fn right(&self) -> Option<Lane<'a>> {
        self.beside(if self.is_forward() { 1 } else { -1 })
    }

    /// The next lane to the left of the reference line's direction; lane 0 is skipped.
    pub fn left_of_reference_line(&self) -> Option<Lane<'a>> {
        self.beside(-1)
    }

    /// The next lane to the right of the reference line's direction; lane 0 is skipped.
    pub fn right_of_reference_line(&self) -> Option<Lane<'a>> {
        self.beside(1)
    }

    /// Lanes from the next one towards lane 0 on to the edge beyond it; lane 0 is skipped.
    pub(crate) fn inner_ones(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let step = i64::from(self.number().signum());
        std::iter::successors(self.beside(step), move |lane| lane.beside(step))
    }

    /// Lanes from the next one away from lane 0 on to the road's edge.
    pub(crate) fn outer_ones(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let step = -i64::from(self.number().signum());
        std::iter::successors(self.beside(step), move |lane| lane.beside(step))
    }

    /// The next lane but lane 0, by so many rows; none by none, as for lane 0, which has no side.
    fn beside(&self, step: i64) -> Option<Lane<'a>> {
        if step == 0 {
            return None;
        }
        let mut at = i64::from(self.number);
        loop {
            at += step;
            let lane = Lane::new(self.map, u32::try_from(at).ok()?)?;
            if lane.row.section() != self.row.section() {
                return None;
            }
            if lane.number() != 0 {
                return Some(lane);
            }
        }
    }

    /// Lanes entered from this one in its own driving direction, in order of road id, section and lane.
    #[inline]
    pub fn successors(&self) -> impl Iterator<Item = LaneId> + use<'a> {
        self.successors_towards(self.is_forward())
    }

    /// As [`Lane::successors`], for travel towards +s or towards −s: of a lane that is used both ways each direction has its own.
    /// None in a direction that the lane is not travelled.
    #[inline]
    pub fn successors_towards(&self, forward: bool) -> impl Iterator<Item = LaneId> + use<'a> {
        let tables = self.map.tables();
        self.linked(tables.successor_offsets, tables.successors, 1, forward)
    }

    /// Lanes from which this one is entered in its own driving direction, in order of road id, section and lane.
    #[inline]
    pub fn predecessors(&self) -> impl Iterator<Item = LaneId> + use<'a> {
        self.predecessors_towards(self.is_forward())
    }

    /// As [`Lane::predecessors`], for travel towards +s or towards −s.
    #[inline]
    pub fn predecessors_towards(&self, forward: bool) -> impl Iterator<Item = LaneId> + use<'a> {
        let tables = self.map.tables();
        self.linked(tables.predecessor_offsets, tables.predecessors, -1, forward)
    }

    /// Lanes over the edges of this lane's nodes, those between its own pieces left out; `step` is from a piece to the
    /// next in the direction of the edges.
    #[inline]
    fn linked(
        &self,
        offsets: &'a [u32],
        targets: &'a [u32],
        step: i32,
        forward: bool,
    ) -> impl Iterator<Item = LaneId> + use<'a> {
        let (map, content) = (self.map, self.map.content());
        let list = map.tables().lane_nodes;
        let nodes = self.row.nodes();
        // Nodes of the other way come last.
        let two_way = self.row.flags() & lane_flags::TWO_WAY != 0;
        let count = if two_way { nodes.count / 2 } else { nodes.count };
        let first = match (forward == self.is_forward(), two_way) {
            (true, _) => Some(nodes.first),
            (false, true) => nodes.first.checked_add(count),
            (false, false) => None,
        };
        let way = first.map_or(Range { first: 0, count: 0 }, |first| Range { first, count });
        let own_way = way.rows(list.len());
        own_way.clone().flat_map(move |node| {
            let edges = edges_of(offsets, targets, node);
            let own_way = own_way.clone();
            edges.iter().filter_map(move |target| {
                let own = node.wrapping_add_signed(step) == *target && own_way.contains(target);
                let row = list.get(*target as usize).filter(|_| !own)?;
                Some(LaneId::new(row.lane(), content))
            })
        })
    }
}

/// Entries of a node in compressed sparse rows.
#[inline]
pub(crate) fn edges_of<'a>(offsets: &[u32], targets: &'a [u32], node: u32) -> &'a [u32] {
    let at = node as usize;
    match offsets.get(at..at + 2) {
        Some(&[from, to]) => targets.get(from as usize..to as usize).unwrap_or(&[]),
        _ => &[],
    }
}
