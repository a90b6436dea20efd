//! Movements through a junction: a movement is a lane of a connecting road, seen from its entry.

use super::country::by_rules;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::signals::{LaneSignal, LightStates, Signal};
use mapd_archive::{ArchivedConflictRow, Class, NO_RELATION, Relation, RelationReason, RoadRules};
use std::cell::OnceCell;
use std::f64::consts::{FRAC_PI_4, PI};

/// Signals this far before a junction are its entry's `[m]`: beyond it they belong to something else more often than not.
pub(crate) const ENTRY_REACH: f64 = 30.0;
/// Pieces that a movement has at most; a damaged archive might lead round in a circle.
const MOST_PIECES: usize = 64;
/// A movement that turns by less goes straight on `[rad]`.
const STRAIGHT: f64 = FRAC_PI_4;
/// A movement that turns by more goes back `[rad]`.
const BACK: f64 = PI - FRAC_PI_4 / 2.0;

/// Where a movement leads.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Turn {
    /// To the left.
    Left,
    /// Straight on.
    Straight,
    /// To the right.
    Right,
    /// Back.
    Back,
}

impl Turn {
    /// Its bit in `LightStates::arrows`.
    pub fn bit(self) -> u8 {
        match self {
            Self::Left => 1,
            Self::Straight => 2,
            Self::Right => 4,
            Self::Back => 8,
        }
    }
}

/// Who goes first where two lanes of a junction meet.
#[derive(Clone, Copy)]
pub struct RightOfWay<'a> {
    map: Map<'a>,
    row: &'a ArchivedConflictRow,
}

/// What an answer about right of way rests on.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum Basis {
    /// The file says so: signs, lights, `junction/priority`.
    Written,
    /// It is what a rule of the road says (turning traffic gives way, right before left). Whether that rule holds there, the file
    /// does not say: such rules differ between countries and between kinds of roads, so it is an answer only where the caller names the country.
    Rule,
    /// Nothing decides, or a rule of the road would have to and no country is named.
    Unknown,
}

impl Basis {
    /// `written`, `rule` or `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Written => "written",
            Self::Rule => "rule",
            Self::Unknown => "unknown",
        }
    }

    /// What a reason rests on.
    pub fn of(reason: RelationReason) -> Self {
        match reason {
            RelationReason::Turn | RelationReason::FromTheRight => Self::Rule,
            RelationReason::None | RelationReason::Unknown => Self::Unknown,
            _ => Self::Written,
        }
    }

    /// Who goes first at a stored conflict, where the file says so. What else is stored comes of the directions in which the lanes lead.
    pub(crate) fn written(row: &ArchivedConflictRow) -> Relation {
        match Self::of(RelationReason::from_code(row.reason())) {
            Self::Written => Relation::from_code(row.relation()),
            _ => Relation::Unknown,
        }
    }

    /// What an answer rests on where no country is named.
    pub(crate) fn without_rules(reason: RelationReason) -> Self {
        match Self::of(reason) {
            Self::Rule => Self::Unknown,
            basis => basis,
        }
    }
}

impl<'a> RightOfWay<'a> {
    /// The other lane.
    pub fn other(&self) -> Option<Lane<'a>> {
        Lane::new(self.map, self.row.other())
    }

    /// Who goes first by what the file says: [`Relation::Unknown`] where it does not. [`Self::relation_by`] asks a rule of the road, too.
    pub fn relation(&self) -> Relation {
        Basis::written(self.row)
    }

    /// Who goes first by what the file says, else by a country's rules; none where neither says. The side from which the other comes
    /// counts only where both come by equal roads, as far as the file says: of one type, with one speed limit, and no motorway; and not
    /// where one goes straight on along a road that the other joins from one of fewer lanes, as a ramp does.
    pub fn relation_by(&self, rules: &RoadRules) -> Option<Relation> {
        let (stored, reason) = (Relation::from_code(self.row.relation()), self.reason());
        match Basis::of(reason) {
            Basis::Written => Some(stored),
            Basis::Unknown => None,
            Basis::Rule => {
                let own = Lane::new(self.map, self.row.lane())?;
                by_rules(rules, stored, reason, own.comes_by_equal_road(&self.other()?))
            }
        }
    }

    /// What [`Self::relation`] rests on: [`Basis::Written`] or [`Basis::Unknown`].
    pub fn basis(&self) -> Basis {
        Basis::without_rules(self.reason())
    }

    /// What [`Self::relation_by`] rests on.
    pub fn basis_by(&self, rules: &RoadRules) -> Basis {
        match Basis::of(self.reason()) {
            Basis::Rule if self.relation_by(rules).is_none() => Basis::Unknown,
            basis => basis,
        }
    }

    /// Why; where nothing is written, which rule of the road would have to say.
    pub fn reason(&self) -> RelationReason {
        RelationReason::from_code(self.row.reason())
    }
}

/// The lane of the only id.
fn sole<'a>(map: Map<'a>, mut ids: impl Iterator<Item = LaneId>) -> Option<Lane<'a>> {
    let id = ids.next()?;
    Lane::new(map, id.row()).filter(|_| ids.next().is_none())
}

impl<'a> Signal<'a> {
    /// First lanes of the movements through junctions that this light governs, place by place. Of what is no light, and of a
    /// light for people on foot, none. Looks at all places of the map.
    pub fn movements(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let own = self.signal_id();
        let governed = move |lane: &Lane<'a>| {
            lane.movement_lights().any(|one| one.signal().signal_id() == own)
        };
        let lanes = self.places().flat_map(|place| place.lanes()).filter_map(|one| one.lane());
        lanes.flat_map(|lane| lane.movements_ahead()).filter(governed)
    }
}

impl LightStates {
    /// Whether it is for a movement.
    pub fn governs(&self, turn: Turn) -> bool {
        self.arrows == 0 || self.arrows & turn.bit() != 0
    }
}

/// A signal at the entry of a movement through a junction.
#[derive(Clone, Copy)]
pub struct EntrySignal<'a> {
    /// The signal, as it is for its lane.
    pub signal: LaneSignal<'a>,
    /// How far before the junction it stands `[m]`, negative inside.
    pub distance: f64,
}

/// A lane to which another one gives way.
#[derive(Clone, Copy)]
pub struct YieldsTo<'a> {
    /// The lane that goes first.
    pub lane: Lane<'a>,
    /// Why.
    pub reason: RelationReason,
}

impl<'a> Lane<'a> {
    /// First lanes of the movements that begin on this lane of a junction, or that it leads to near one.
    fn movements_ahead(self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let in_junction = |lane: &Lane<'a>| lane.road().junction_row().is_some();
        let own = Some(self).filter(in_junction).map(|lane| lane.movement_start());
        // The last lane before the junction; what lies between is passed over.
        let last = self.run(false, -self.whole()).last();
        let last = last.map(|(lane, _)| lane).filter(|_| own.is_none());
        let map = self.map;
        let next = last
            .into_iter()
            .flat_map(move |lane| lane.successors().filter_map(move |id| Lane::new(map, id.row())));
        own.into_iter().chain(next.filter(in_junction))
    }

    /// Heading of the reference line as the lane's traffic goes `[rad]`, in (−π, π], at the lane's beginning or end in driving direction: a movement turns
    /// as its road does, whatever its lanes' widths do.
    pub fn road_heading(&self, at_end: bool) -> f64 {
        let section = self.section();
        let forward = self.is_forward();
        let s = if forward == at_end { section.s_end() } else { section.s_start() };
        let line = self.pose_of_reference_line(s, 0.0);
        line.map_or(0.0, |pose| self.heading_along(pose.heading, 0.0))
    }

    /// Lanes of the same junction before (or behind) this one, itself first: one movement in pieces.
    fn pieces(&self, before: bool) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let junction = self.road().junction_row();
        let step = move |lane: &Lane<'a>| {
            let own =
                |other: &Lane<'a>| junction.is_some() && other.road().junction_row() == junction;
            let map = lane.map;
            let lane_of = |id: crate::ids::LaneId| Lane::new(map, id.row());
            if before {
                lane.predecessors().filter_map(lane_of).find(own)
            } else {
                lane.successors().filter_map(lane_of).find(own)
            }
        };
        std::iter::successors(Some(*self), step).take(MOST_PIECES)
    }

    /// First lane of the junction on the way through this one; itself where it is in no junction.
    pub fn movement_start(&self) -> Lane<'a> {
        self.pieces(true).last().unwrap_or(*self)
    }

    /// Where the movement through this lane of a junction leads.
    pub fn turn(&self) -> Turn {
        self.turn_from(self.movement_start().road_heading(false))
    }

    /// As [`Lane::turn`], where the heading with which the movement begins is known `[rad]`.
    #[doc(hidden)]
    pub fn turn_from(&self, from: f64) -> Turn {
        let to = self.pieces(false).last().unwrap_or(*self).road_heading(true);
        let turned = mapd_geometry::normalize_angle(to - from);
        match turned.abs() {
            angle if angle <= STRAIGHT => Turn::Straight,
            angle if angle >= BACK => Turn::Back,
            _ if turned > 0.0 => Turn::Left,
            _ => Turn::Right,
        }
    }

    /// Lanes from which the junction is entered on the way through this one.
    pub fn entries(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        self.movement_start().before()
    }

    /// Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction.
    pub fn movement_lanes(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        self.movement_start().pieces(false)
    }

    /// Lanes that lead to the movement, and those before them as long as each follows one alone and begins less than 30 m before
    /// the junction; each with the distance from its end to the junction `[m]`.
    pub(super) fn approaches(&self) -> impl Iterator<Item = (Lane<'a>, f64)> + use<'a> {
        self.movement_start().led_to_by()
    }

    /// As `approaches`, of a movement that begins on this lane.
    fn led_to_by(&self) -> impl Iterator<Item = (Lane<'a>, f64)> + use<'a> {
        self.before().flat_map(|lane| lane.run(true, 0.0))
    }

    /// Lanes that lead to this one.
    fn before(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let map = self.map;
        self.predecessors().filter_map(move |id| Lane::new(map, id.row()))
    }

    /// As `approaches`, for lanes that the movement leads to: each with the distance from the junction to its beginning.
    pub(super) fn departures(&self) -> impl Iterator<Item = (Lane<'a>, f64)> + use<'a> {
        let map = self.map;
        let last = self.pieces(false).last().unwrap_or(*self);
        let next = last.successors().filter_map(move |id| Lane::new(map, id.row()));
        next.flat_map(|lane| lane.run(false, 0.0))
    }

    /// This lane and those before (or behind) it, near a junction: until there is a fork or another junction, or the reach ends;
    /// each with the lengths of those passed `[m]`, counted from `start`.
    pub(crate) fn run(
        self,
        before: bool,
        start: f64,
    ) -> impl Iterator<Item = (Lane<'a>, f64)> + use<'a> {
        let step = move |(lane, passed): &(Lane<'a>, f64)| {
            let next = if before {
                sole(lane.map, lane.predecessors())
            } else {
                sole(lane.map, lane.successors())
            };
            let next = next.filter(|next| next.road().junction_row().is_none())?;
            let passed = passed + lane.whole();
            (passed <= ENTRY_REACH).then_some((next, passed))
        };
        std::iter::successors(Some((self, start)), step).take(MOST_PIECES)
    }

    /// Length of its centre line `[m]`.
    fn whole(&self) -> f64 {
        let section = self.section();
        self.length_between(section.s_start(), section.s_end())
    }

    /// Signals at the entry of the movement through this lane of a junction: those of its first lane, then those of the lanes
    /// that lead in, up to 30 m before. Lights with arrows only where they are for the movement.
    pub fn entry_signals(&self) -> impl Iterator<Item = EntrySignal<'a>> + use<'a> {
        self.entry_signals_from(self.movement_start())
    }

    /// As [`Lane::entry_signals`], where the movement's first lane is known.
    #[doc(hidden)]
    pub fn entry_signals_from(
        &self,
        start: Lane<'a>,
    ) -> impl Iterator<Item = EntrySignal<'a>> + use<'a> {
        let lane = *self;
        // Only lights ask for it.
        let of_lane = OnceCell::new();
        let forward = start.is_forward();
        let own = start.signals().filter(move |one| one.is_for(forward)).map(move |one| {
            let section = start.section();
            let begin = if forward { section.s_start() } else { section.s_end() };
            EntrySignal { distance: -start.length_between(begin, one.s_on(&start)), signal: one }
        });
        let leading = start.led_to_by().flat_map(move |(lane, after)| {
            let section = lane.section();
            let end = if lane.is_forward() { section.s_end() } else { section.s_start() };
            lane.signals().filter(move |one| one.is_for(lane.is_forward())).map(move |one| {
                EntrySignal {
                    distance: after + lane.length_between(one.s_on(&lane), end),
                    signal: one,
                }
            })
        });
        own.chain(leading.filter(|one| one.distance <= ENTRY_REACH)).filter(move |one| {
            let signal = one.signal.signal();
            !signal.is_invalidated()
                && signal.light().is_none_or(|light| {
                    let turn = || lane.turn_from(start.road_heading(false));
                    light.governs(*of_lane.get_or_init(turn))
                })
        })
    }

    /// Lights that govern the movement through this lane of a junction.
    pub fn movement_lights(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        self.entry_signals().map(|one| one.signal).filter(LaneSignal::is_vehicle_light)
    }

    /// The line at which the movement through this lane of a junction stops: the marked one nearest to the junction.
    pub fn movement_stop_line(&self) -> Option<LaneSignal<'a>> {
        let lines = self.entry_signals().filter(|one| {
            matches!(one.signal.signal().class(), Class::StopLine | Class::WaitingLine)
        });
        lines.min_by(|a, b| a.distance.abs().total_cmp(&b.distance.abs())).map(|one| one.signal)
    }

    /// Who goes first where this lane of a junction meets others, by what the file says; [`RightOfWay::relation_by`] asks a country's rules too.
    pub fn right_of_way(&self) -> impl Iterator<Item = RightOfWay<'a>> + use<'a> {
        let (map, own) = (self.map, self.row_number());
        let rows = map.tables().conflicts;
        let from = rows.partition_point(|row| row.lane() < own);
        let rest = rows.get(from..).unwrap_or(&[]).iter();
        rest.take_while(move |row| row.lane() == own)
            .filter(|row| row.relation() != NO_RELATION)
            .map(move |row| RightOfWay { map, row })
    }

    /// Lanes to which this lane of a junction gives way by what the file says, with the reason; such as are closed to every vehicle
    /// are left out. What a country's rules say where nothing is written is [`RightOfWay::relation_by`].
    pub fn yields_to(&self) -> impl Iterator<Item = YieldsTo<'a>> + use<'a> {
        let yields = self.right_of_way().filter(|one| one.relation() == Relation::Yields);
        let all =
            yields.filter_map(|one| Some(YieldsTo { lane: one.other()?, reason: one.reason() }));
        all.filter(|one| one.lane.nodes().any(|node| node.is_open()))
    }
}
