//! The lane graph: nodes, edges, conflicts.

use crate::error::QueryError;
use crate::extents::{SRange, SourcePosition};
use crate::ids::NodeId;
use crate::lane::{Lane, edges_of};
use crate::map::Map;
use crate::rules::Basis;
use mapd_archive::{
    ArchivedConflictRow, ArchivedLaneNodeRow, ArchivedPieceRow, ConflictKind, EdgeKind,
    NO_RELATION, NONE, Relation, RelationReason, VehicleClass, beside_row, edge_flags, node_flags,
    section_step,
};

/// A node of the lane graph: a lane, or a piece of one, travelled in one direction. Under an overlay ([`View`](crate::view::View)) a [`RouteCost`](crate::route::RouteCost) is also asked
/// for pieces of nodes, whose length, time and permissions are those of the piece.
#[derive(Clone, Copy)]
pub struct LaneNode<'a> {
    pub(crate) map: Map<'a>,
    pub(crate) number: u32,
    pub(crate) row: &'a ArchivedLaneNodeRow,
    /// What holds instead on a piece of the node, under an overlay.
    pub(crate) piece: Option<NodePiece<'a>>,
}

/// A piece of a node, as an overlay has it at a moment, for a class of vehicles. Searches pass it on for every node, so it is small.
#[derive(Clone, Copy)]
pub(crate) struct NodePiece<'a> {
    pub(crate) row: &'a ArchivedPieceRow,
    /// From its begin to its end at the travel speed of today \[s\].
    pub(crate) time: f64,
    /// Whether an entry states that speed.
    pub(crate) is_speed_stated: bool,
    /// Classes of vehicles that may use it, a bit each.
    pub(crate) access: u16,
}

/// An edge of the lane graph: from one node into the next, in driving direction.
#[derive(Clone, Copy)]
pub struct LaneEdge<'a> {
    map: Map<'a>,
    /// Row of `successors` and `edges`.
    number: u32,
    /// Rows of the nodes that are left and entered.
    left: u32,
    target: u32,
}

/// A place where two lanes of a junction meet.
#[derive(Clone, Copy)]
pub struct Conflict<'a> {
    map: Map<'a>,
    row: &'a ArchivedConflictRow,
}

impl<'a> LaneNode<'a> {
    #[inline]
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        let row = map.tables().lane_nodes.get(number as usize)?;
        Some(Self { map, number, row, piece: None })
    }

    /// Dense id.
    pub fn node_id(&self) -> NodeId {
        NodeId::new(self.number, self.map.content())
    }

    /// The lane.
    pub fn lane(&self) -> Option<Lane<'a>> {
        Lane::new(self.map, self.row.lane())
    }

    /// Whether it travels towards +s.
    pub fn is_forward(&self) -> bool {
        self.row.flags() & node_flags::FORWARD != 0
    }

    /// Both ends of the piece on the road `[m]`, the smaller s first.
    pub fn s_range(&self) -> SRange {
        if let Some(piece) = &self.piece {
            return SRange { low: piece.row.s_from(), high: piece.row.s_to() };
        }
        let Some(lane) = self.lane() else { return SRange::default() };
        let section = lane.section();
        let start = section.s_start();
        let beyond =
            if self.is_forward() { self.number.checked_add(1) } else { self.number.checked_sub(1) };
        let neighbour = beyond.and_then(|number| Self::new(self.map, number)).filter(|other| {
            other.row.lane() == self.row.lane() && other.is_forward() == self.is_forward()
        });
        let high = neighbour.map_or(section.s_end(), |n| start + f64::from(n.row.s_from()));
        SRange { low: start + f64::from(self.row.s_from()), high }
    }

    /// Length of the centre line in plan view `[m]`.
    #[inline]
    pub fn length(&self) -> f64 {
        match &self.piece {
            None => f64::from(self.row.length()),
            Some(piece) => f64::from(piece.row.length()),
        }
    }

    /// What a route by time counts for it `[s]`: as [`Lane::time_between`], under an overlay at the speeds that entries state.
    #[inline]
    pub fn travel_time(&self) -> f64 {
        match &self.piece {
            None => f64::from(self.row.time()),
            Some(piece) => piece.time,
        }
    }

    /// Whether an entry of an overlay states the speed that its time counts.
    pub(crate) fn is_speed_stated(&self) -> bool {
        self.piece.is_some_and(|piece| piece.is_speed_stated)
    }

    /// Whether a class of vehicles may use it, by lane type and access records.
    pub fn allows(&self, class: VehicleClass) -> bool {
        self.access() & class.bit() != 0
    }

    #[inline]
    pub(crate) fn access(&self) -> u16 {
        match &self.piece {
            None => self.row.access(),
            Some(piece) => piece.access,
        }
    }

    /// Whether a vehicle goes on into one that follows: what is open may be entered; a closed lane on which it is already, is driven to its end.
    #[inline]
    pub(crate) fn leads_into(&self, to: &LaneNode<'_>, class: VehicleClass) -> bool {
        to.allows(class) || self.stays_on_closed(to, class)
    }

    /// Whether one that follows is the next piece of the same lane, and both are closed: however a lane is cut, who is on it may leave it at its end.
    pub(crate) fn stays_on_closed(&self, to: &LaneNode<'_>, class: VehicleClass) -> bool {
        if self.allows(class) || to.allows(class) || self.row.lane() != to.row.lane() {
            return false;
        }
        // A lane may also lead to its own beginning: that is to enter it.
        let before = |node: &LaneNode<'_>| node.piece.map_or(0.0, |piece| piece.row.before());
        let is_next = match self.number == to.number {
            true => before(to) > before(self),
            false => self.number.checked_add(1) == Some(to.number),
        };
        is_next && self.is_forward() == to.is_forward()
    }

    /// Whether any class of vehicles may use it.
    pub fn is_open(&self) -> bool {
        self.access() != 0
    }

    /// The node beside it, in driving direction to the left, that travels the same way.
    pub fn left(&self) -> Option<LaneNode<'a>> {
        Self::new(self.map, beside_row(self.number, self.row.left()))
    }

    /// The node beside it, in driving direction to the right, that travels the same way.
    pub fn right(&self) -> Option<LaneNode<'a>> {
        Self::new(self.map, beside_row(self.number, self.row.right()))
    }

    /// Where a change of lane to the left leads, if the road marks allow one.
    pub fn change_left(&self) -> Option<LaneNode<'a>> {
        self.left().filter(|_| self.row.flags() & node_flags::CHANGE_LEFT != 0)
    }

    /// Where a change of lane to the right leads, if the road marks allow one.
    pub fn change_right(&self) -> Option<LaneNode<'a>> {
        self.right().filter(|_| self.row.flags() & node_flags::CHANGE_RIGHT != 0)
    }

    /// Edges that leave the node, by road id, section and lane of their targets.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = LaneEdge<'a>> + use<'a> {
        let (map, left) = (self.map, self.number);
        let tables = map.tables();
        let first = tables.successor_offsets.get(self.number as usize).copied().unwrap_or(NONE);
        let targets = edges_of(tables.successor_offsets, tables.successors, self.number);
        targets.iter().enumerate().map(move |(i, target)| LaneEdge {
            map,
            number: first.wrapping_add(i as u32),
            left,
            target: *target,
        })
    }

    /// Nodes from which this one is entered.
    pub fn predecessors(&self) -> impl Iterator<Item = LaneNode<'a>> + use<'a> {
        let map = self.map;
        let tables = map.tables();
        let sources = edges_of(tables.predecessor_offsets, tables.predecessors, self.number);
        sources.iter().filter_map(move |node| Self::new(map, *node))
    }

    /// Strongly connected component. Components are numbered in topological order of the condensation: no edge leads from
    /// a higher number to a lower one.
    pub fn component(&self) -> u32 {
        self.row.component()
    }
}

/// Nodes to one side of a node that are looked at; beyond more of them nothing is known.
const BESIDE: usize = 64;

/// The node beside one to the left or right, if a change of lane leads from one to the other, whichever way.
fn joined<'a>(node: &LaneNode<'a>, left: bool) -> Option<LaneNode<'a>> {
    let change =
        |from: &LaneNode<'a>, left| if left { from.change_left() } else { from.change_right() };
    let beside = if left { node.left() } else { node.right() }?;
    (change(node, left).is_some() || change(&beside, !left).is_some()).then_some(beside)
}

/// Whether a node is the first from the left of those that changes of lane join with it.
pub fn is_first_joined(node: &LaneNode<'_>) -> bool {
    joined(node, true).is_none()
}

/// Smallest and largest measure of the nodes that changes of lane join with a node, itself among them.
pub fn extremes_of_joined(node: &LaneNode<'_>, measure: impl Fn(&LaneNode<'_>) -> f64) -> [f64; 2] {
    let own = measure(node);
    let [mut least, mut most] = [own, own];
    for left in [true, false] {
        let mut beside = std::iter::successors(joined(node, left), |next| joined(next, left));
        for next in beside.by_ref().take(BESIDE) {
            let own = measure(&next);
            (least, most) = (least.min(own), most.max(own));
        }
        if beside.next().is_some() {
            return [0.0, f64::INFINITY];
        }
    }
    [least, most]
}

impl<'a> LaneEdge<'a> {
    /// The node that is left: its length, time and access are the edge's.
    pub fn source(&self) -> Option<LaneNode<'a>> {
        LaneNode::new(self.map, self.left)
    }

    /// What is travelled until the edge is reached: the length of the node that is left `[m]`.
    pub fn length(&self) -> f64 {
        self.source().map_or(0.0, |node| node.length())
    }

    /// Speed limit where the edge is passed `[m/s]`: at the end of the node that is left. As [`Lane::speed_rule_at`]; none where it depends, too.
    pub fn speed_limit(&self) -> Option<f64> {
        let node = self.source()?;
        let SRange { low: from, high: to } = node.s_range();
        node.lane()?.speed_rule_at(if node.is_forward() { to } else { from }).max
    }

    /// Whether a class of vehicles may use both nodes that the edge joins.
    pub fn allows(&self, class: VehicleClass) -> bool {
        let allows = |node: Option<LaneNode<'a>>| node.is_some_and(|node| node.allows(class));
        allows(self.source()) && allows(self.target())
    }

    /// The node that is entered.
    pub fn target(&self) -> Option<LaneNode<'a>> {
        LaneNode::new(self.map, self.target)
    }

    /// Where the edge comes from.
    pub fn kind(&self) -> EdgeKind {
        self.row().map_or(EdgeKind::Unknown, |row| EdgeKind::from_code(row.kind()))
    }

    /// Line and column of the link in the file, from 1; none where no link is needed.
    pub fn source_position(&self) -> Option<SourcePosition> {
        let place = self.row().map(|row| SourcePosition { line: row.line(), column: row.column() });
        place.filter(|place| place.line > 0)
    }

    /// Which file the link stands in: 0 for the document itself, else the number of the included file, in the order in which
    /// they are included.
    pub fn source_file(&self) -> u16 {
        self.row().map_or(0, |row| row.file())
    }

    /// Whether the edge closes a loop. The graph without such edges has no cycle; which edges they are depends on names
    /// only, not on the order of elements in the file.
    pub fn closes_loop(&self) -> bool {
        self.row().is_some_and(|row| row.flags() & edge_flags::CLOSES_LOOP != 0)
    }

    fn row(&self) -> Option<&'a mapd_archive::ArchivedEdgeRow> {
        self.map.tables().edges.get(self.number as usize)
    }
}

impl<'a> Conflict<'a> {
    /// The lane that is met.
    pub fn other(&self) -> Option<Lane<'a>> {
        Lane::new(self.map, self.row.other())
    }

    /// How the two meet.
    pub fn kind(&self) -> ConflictKind {
        ConflictKind::from_code(self.row.kind())
    }

    /// Who goes first, by what the file says; [`Relation::Unknown`] where a rule of the road would have to say
    /// ([`RightOfWay::relation_by`](crate::rules::RightOfWay::relation_by)), and where no rule of junctions applies or nothing decides.
    pub fn relation(&self) -> Relation {
        Basis::written(self.row)
    }

    /// What that rests on: [`Basis::Written`] or [`Basis::Unknown`].
    pub fn basis(&self) -> Basis {
        Basis::without_rules(self.reason())
    }

    /// Whether it is one that somebody has to go first at.
    pub(crate) fn has_relation(&self) -> bool {
        self.row.relation() != NO_RELATION
    }

    /// Who goes first as it is stored, by what right-before-left and the rule of turns would say too; [`Relation::Open`] where nothing decides.
    pub(crate) fn stored_relation(&self) -> Relation {
        Relation::from_code(self.row.relation())
    }

    /// Why; where nothing is written, which rule of the road would have to say.
    pub fn reason(&self) -> RelationReason {
        RelationReason::from_code(self.row.reason())
    }

    /// The common area on the lane itself: both ends on its road `[m]`, the smaller s first.
    pub fn s_range(&self) -> SRange {
        self.on(self.row.lane(), [self.row.from(), self.row.to()])
    }

    /// The common area on the other lane: both ends on its road `[m]`, the smaller s first.
    pub fn other_range(&self) -> SRange {
        self.on(self.row.other(), [self.row.other_from(), self.row.other_to()])
    }

    fn on(&self, lane: u32, [from, to]: [u16; 2]) -> SRange {
        let section = Lane::new(self.map, lane).map(|lane| lane.section());
        let (start, end) = section.map_or((0.0, 0.0), |s| (s.s_start(), s.s_end()));
        let step = section_step(end - start);
        SRange {
            low: start + f64::from(from) * step,
            high: (start + f64::from(to) * step).min(end),
        }
    }
}

impl<'a> Map<'a> {
    /// The node of an id.
    ///
    /// Errors: an id of another map content, or that names nothing; a damaged archive.
    pub fn lane_node(&self, id: NodeId) -> Result<LaneNode<'a>, QueryError> {
        self.known_id(id.row, id.content, id.tile)?;
        LaneNode::new(*self, id.row).ok_or_else(|| QueryError::Corrupt.of_row(id.row))
    }

    /// All nodes of the lane graph.
    pub fn lane_nodes(&self) -> impl ExactSizeIterator<Item = LaneNode<'a>> + use<'a> {
        let map = *self;
        let rows = map.tables().lane_nodes.iter().enumerate();
        rows.map(move |(number, row)| LaneNode { map, number: number as u32, row, piece: None })
    }
}

impl<'a> Lane<'a> {
    /// The lane's nodes in driving order; of a lane travelled both ways then those of the other way.
    pub fn nodes(&self) -> impl Iterator<Item = LaneNode<'a>> + use<'a> {
        let map = self.map;
        self.row
            .nodes()
            .rows(map.tables().lane_nodes.len())
            .filter_map(move |n| LaneNode::new(map, n))
    }

    /// The node that holds s, in one direction of travel; at a cut the later one in that direction. s outside the lane's section
    /// counts as its nearer end; none for an s that is not finite.
    pub fn node_at(&self, s: f64, forward: bool) -> Option<LaneNode<'a>> {
        if !s.is_finite() {
            return None;
        }
        let way = |node: &LaneNode<'a>| node.is_forward() == forward;
        let mut found = None;
        for node in self.nodes().filter(way) {
            // Most lanes have one node in a direction, whose ends need not be known.
            let is_reached = found.is_none() || {
                let SRange { low: from, high: to } = node.s_range();
                if forward { s >= from } else { s <= to }
            };
            if is_reached {
                found = Some(node);
            }
        }
        found
    }

    /// Whether a class of vehicles may use the lane at s in its own direction, by lane type and access records (OpenDRIVE
    /// 1.8.1, 11.8.1).
    pub fn allows_at(&self, s: f64, class: VehicleClass) -> bool {
        self.node_at(s, self.is_forward()).is_some_and(|node| node.allows(class))
    }

    /// Classes of vehicles that may use the lane at s in its own direction.
    pub fn access_at(&self, s: f64) -> impl Iterator<Item = VehicleClass> + use<'a> {
        let node = self.node_at(s, self.is_forward());
        let allowed = move |class: &VehicleClass| node.is_some_and(|node| node.allows(*class));
        VehicleClass::ALL.iter().copied().filter(allowed)
    }

    /// The nearest lane beside this one that is travelled the other way: across lane 0, or beside a reversed lane.
    pub fn opposite(&self) -> Option<Lane<'a>> {
        let other_way =
            |lane: &Lane<'a>| lane.kind().is_drivable() && lane.is_forward() != self.is_forward();
        self.inner_ones().find(other_way).or_else(|| self.outer_ones().find(other_way))
    }

    /// Lanes of the same junction whose areas meet this one's.
    pub fn conflicts(&self) -> impl Iterator<Item = Conflict<'a>> + use<'a> {
        let map = self.map;
        let rows = map.tables().conflicts;
        let own = self.lane_id().row();
        let from = rows.partition_point(|row| row.lane() < own);
        let rest = rows.get(from..).unwrap_or(&[]).iter();
        rest.take_while(move |row| row.lane() == own).map(move |row| Conflict { map, row })
    }
}
