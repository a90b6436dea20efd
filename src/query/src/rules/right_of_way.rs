//! Who goes first where two movements through a junction meet.
//!
//! Examined in this order: lights, signs at the entry, `junction/priority`, turns across oncoming traffic, traffic from the
//! right. The first that tells the two apart decides.

use super::{EntrySign, Turn};
use crate::ids::{RoadId, SignalId};
use crate::lane::Lane;
use crate::signals::Signal;
use mapd_archive::{Relation, RelationReason};
use mapd_geometry::normalize_angle;
use std::f64::consts::FRAC_PI_4;

/// Who enters against each other's way by at least this much is oncoming `[rad]`: three eighths of a turn.
const ONCOMING: f64 = 3.0 * FRAC_PI_4;
/// Who enters across by more than this and less than oncoming comes from the side `[rad]`.
const BESIDE: f64 = FRAC_PI_4;

/// What counts of a movement.
pub struct Movement {
    /// Road and direction by which the junction is entered, the first of several.
    pub entry: Option<(RoadId, bool)>,
    connecting: RoadId,
    junction: Option<u32>,
    heading: f64,
    turn: Turn,
    /// Turning to this side crosses oncoming traffic.
    across: Turn,
    is_lit: bool,
    sign: EntrySign,
}

/// Lights that switch together, by row: those of a controller, or one without any by itself.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum LightGroup {
    /// A controller's.
    Controller(u32),
    /// One without a controller.
    Light(u32),
}

impl LightGroup {
    /// Those of a light.
    pub fn of<'a>(light: &Signal<'a>) -> impl Iterator<Item = Self> + use<'a> {
        let controllers =
            light.controllers().map(|one| Self::Controller(one.controller_id().row()));
        let mut controllers = controllers.peekable();
        let alone = controllers.peek().is_none().then_some(Self::Light(light.signal_id().row()));
        controllers.chain(alone)
    }
}

impl Movement {
    /// The movement through a lane. Lights of vehicles count as far as `works` says of them.
    pub fn of<'a>(lane: &Lane<'a>, mut works: impl FnMut(&Signal<'a>) -> bool) -> Self {
        let start = lane.movement_start();
        let heading = start.road_heading(false);
        let entry = start.entries().next().map(|lane| (lane.road().road_id(), lane.is_forward()));
        let (mut is_lit, mut sign) = (false, EntrySign::None);
        for entry in lane.entry_signals_from(start) {
            let signal = entry.signal.signal();
            sign = sign.and(EntrySign::of(signal.class()));
            is_lit |= entry.signal.is_vehicle_light() && works(&signal);
        }
        let across = if lane.road().is_left_hand_traffic() { Turn::Right } else { Turn::Left };
        Self {
            entry,
            connecting: lane.road().road_id(),
            junction: lane.road().junction().map(|junction| junction.junction_id().row()),
            heading,
            turn: lane.turn_from(heading),
            across,
            is_lit,
            sign,
        }
    }

    /// Rows of the roads by which `junction/priority` may name a movement: the connecting one, and the one that leads to it.
    fn roads(&self) -> [Option<u32>; 2] {
        [Some(self.connecting.row()), self.entry.map(|(entry, _)| entry.row())]
    }

    /// Who goes first, this movement or another. `together`: whether lights of both switch together; `priority`: the number of the first row of
    /// `junction/priority` that gives one road of a junction priority over another.
    pub fn against(
        &self,
        other: &Self,
        together: impl FnOnce() -> bool,
        priority: impl Fn(u32, u32, u32) -> Option<u32>,
    ) -> (Relation, RelationReason) {
        let both_lit = self.is_lit && other.is_lit;
        let angle = normalize_angle(other.heading - self.heading);
        // Oncoming lights are green together more often than not, whether or not one controller has both. Those from the side never
        // are: exporters that write one controller for a whole junction do not mean that they switch together.
        if both_lit && angle.abs() < ONCOMING && (angle.abs() > BESIDE || !together()) {
            return (Relation::Lights, RelationReason::Lights);
        }
        let written =
            || self.sign.against(other.sign).or_else(|| self.by_priority(other, priority));
        let found = if both_lit { None } else { written() };
        found.unwrap_or_else(|| self.by_direction(other, angle))
    }

    fn by_priority(
        &self,
        other: &Self,
        priority: impl Fn(u32, u32, u32) -> Option<u32>,
    ) -> Option<(Relation, RelationReason)> {
        let junction = self.junction?;
        let (mine, theirs) = (self.roads(), other.roads());
        let is_of = |roads: [Option<u32>; 2], road: u32| roads.contains(&Some(road));
        let mut found: Option<(u32, bool)> = None;
        // Of all rows that could tell the two apart, the first counts.
        for (high, low) in [(mine, theirs), (theirs, mine)] {
            for high in high.into_iter().flatten() {
                for low in low.into_iter().flatten() {
                    let wins = is_of(mine, high) && is_of(theirs, low);
                    let loses = is_of(mine, low) && is_of(theirs, high);
                    if wins == loses {
                        continue;
                    }
                    if let Some(row) = priority(junction, high, low)
                        && found.is_none_or(|(first, _)| row < first)
                    {
                        found = Some((row, loses));
                    }
                }
            }
        }
        found.map(|(_, loses)| (yields_if(loses), RelationReason::JunctionPriority))
    }

    fn by_direction(&self, other: &Self, angle: f64) -> (Relation, RelationReason) {
        if angle.abs() >= ONCOMING {
            let across =
                |movement: &Self| movement.turn == movement.across || movement.turn == Turn::Back;
            return match (across(self), across(other)) {
                (true, false) => (Relation::Yields, RelationReason::Turn),
                (false, true) => (Relation::Priority, RelationReason::Turn),
                _ => (Relation::Open, RelationReason::None),
            };
        }
        if angle.abs() > BESIDE {
            // Who drives to one's left comes from the right.
            return (yields_if(angle > 0.0), RelationReason::FromTheRight);
        }
        (Relation::Open, RelationReason::None)
    }
}

fn yields_if(yields: bool) -> Relation {
    if yields { Relation::Yields } else { Relation::Priority }
}

/// Who goes first where two lanes of a junction meet and some lights do not work: none where all that govern either do, and the stored answer holds.
pub(crate) fn without_lights<'a>(
    own: &Lane<'a>,
    other: &Lane<'a>,
    works: impl Fn(SignalId) -> bool,
) -> Option<(Relation, RelationReason)> {
    let works = |signal: &Signal<'a>| works(signal.signal_id());
    let lights = |lane: &Lane<'a>| lane.movement_lights().map(|light| light.signal());
    if lights(own).chain(lights(other)).all(|light| works(&light)) {
        return None;
    }
    let groups = |lane| lights(lane).filter(works).flat_map(|light| LightGroup::of(&light));
    let together = || groups(own).any(|one| groups(other).any(|another| another == one));
    let rows = own.map.tables().junction_priorities;
    let priority = |junction, high, low| {
        let is_it = |row: &mapd_archive::ArchivedJunctionPriorityRow| {
            (row.junction(), row.high(), row.low()) == (junction, high, low)
        };
        rows.iter().position(is_it).map(|number| number as u32)
    };
    let [mine, theirs] = [own, other].map(|lane| Movement::of(lane, works));
    Some(mine.against(&theirs, together, priority))
}
