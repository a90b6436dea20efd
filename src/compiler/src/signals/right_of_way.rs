//! Who goes first where lanes of a junction meet.
//!
//! Examined at in this order: lights, signs at the entry, `junction/priority`, turns across oncoming traffic, traffic from the
//! right. The first that tells the two apart decides.

use crate::sample::view;
use mapd_archive::{
    ConflictKind, ConflictRow, JunctionPriorityRow, NONE, Relation, RelationReason, Rows,
};
use mapd_geometry::normalize_angle;
use mapd_query::compiling::{ByRow as _, EntrySign};
use mapd_query::rules::Turn;
use mapd_query::{Lane, Map, RoadId};
use rayon::prelude::*;
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_4;

/// Who enters against each other's way by at least this much is oncoming `[rad]`: three eighths of a turn.
const ONCOMING: f64 = 3.0 * FRAC_PI_4;
/// Who enters across by more than this and less than oncoming comes from the side `[rad]`.
const BESIDE: f64 = FRAC_PI_4;

/// What counts of a movement.
struct Movement {
    /// Road and direction by which the junction is entered, the first of several.
    entry: Option<(RoadId, bool)>,
    connecting: RoadId,
    junction: Option<u32>,
    heading: f64,
    turn: Turn,
    /// Turning to this side crosses oncoming traffic.
    across: Turn,
    /// Controllers of its lights, by row; a light without any stands for itself.
    lights: Vec<LightGroup>,
    sign: EntrySign,
}

/// Lights that switch together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LightGroup {
    Controller(u32),
    Light(u32),
}

/// The first row of `junction/priority` by junction, road with priority and road without.
struct Priorities(HashMap<(u32, u32, u32), u32>);

impl Priorities {
    fn new(rows: &[JunctionPriorityRow]) -> Self {
        let mut first = HashMap::new();
        for (number, row) in (0u32..).zip(rows) {
            first.entry((row.junction, row.high, row.low)).or_insert(number);
        }
        Self(first)
    }
}

/// Who goes first by each row of `conflicts`; none where no rule tells.
pub(super) struct RightOfWay(Vec<Option<(Relation, RelationReason)>>);

impl RightOfWay {
    /// Looks at a map whose signals are placed.
    pub(super) fn find(rows: &Rows) -> Self {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        // They come by lane.
        let mut numbers: Vec<u32> = rows.conflicts.iter().map(|row| row.lane).collect();
        numbers.dedup();
        let read = |number: &u32| Some(movement(&map.lane_by_row(*number)?));
        let movements: Vec<Option<Movement>> = numbers.par_iter().map(read).collect();
        let mut of_lanes = vec![NONE; rows.lanes.len()];
        for (movement, lane) in (0u32..).zip(&numbers) {
            if let Some(of_lane) = of_lanes.get_mut(*lane as usize) {
                *of_lane = movement;
            }
        }
        let of_lane = |lane: u32| {
            let movement = *of_lanes.get(lane as usize)?;
            movements.get(movement as usize).and_then(Option::as_ref)
        };
        let priorities = Priorities::new(&rows.junction_priorities);
        let of = |row: &ConflictRow| {
            // Where roads cross on another level of meaning (crossings of 1.8), no rule of junctions applies.
            if row.kind == ConflictKind::Crossing.code() {
                return None;
            }
            let (own, other) = (of_lane(row.lane)?, of_lane(row.other)?);
            let one_entry = own.entry.is_some() && own.entry == other.entry;
            (!one_entry).then(|| relation(own, other, &priorities))
        };
        Self(rows.conflicts.par_iter().map(of).collect())
    }

    /// Says so in the rows.
    pub(super) fn store(self, rows: &mut Rows) {
        for (row, found) in rows.conflicts.iter_mut().zip(self.0) {
            if let Some((relation, reason)) = found {
                (row.relation, row.reason) = (relation.code(), reason.code());
            }
        }
    }
}

fn movement(lane: &Lane<'_>) -> Movement {
    let start = lane.movement_start();
    let heading = start.road_heading(false);
    let entry = start.entries().next().map(|lane| (lane.road().road_id(), lane.is_forward()));
    let mut lights: Vec<LightGroup> = Vec::new();
    let mut sign = EntrySign::None;
    for entry in lane.entry_signals_from(start) {
        let one = entry.signal;
        let signal = one.signal();
        sign = sign.and(EntrySign::of(signal.class()));
        if one.is_vehicle_light() {
            let before = lights.len();
            let controllers = signal.controllers();
            lights.extend(controllers.map(|c| LightGroup::Controller(c.controller_id().row())));
            if lights.len() == before {
                lights.push(LightGroup::Light(signal.signal_id().row()));
            }
        }
    }
    let across = if lane.road().is_left_hand_traffic() { Turn::Right } else { Turn::Left };
    Movement {
        entry,
        connecting: lane.road().road_id(),
        junction: lane.road().junction().map(|junction| junction.junction_id().row()),
        heading,
        turn: lane.turn_from(heading),
        across,
        lights,
        sign,
    }
}

fn relation(
    own: &Movement,
    other: &Movement,
    priorities: &Priorities,
) -> (Relation, RelationReason) {
    let both_lit = !own.lights.is_empty() && !other.lights.is_empty();
    let together = own.lights.iter().any(|light| other.lights.contains(light));
    let angle = normalize_angle(other.heading - own.heading);
    // Oncoming lights are green together more often than not, whether or not one controller has both. Those from the side never
    // are: exporters that write one controller for a whole junction do not mean that they switch together.
    let apart = !together || angle.abs() > BESIDE;
    if both_lit && apart && angle.abs() < ONCOMING {
        return (Relation::Lights, RelationReason::Lights);
    }
    if !both_lit
        && let Some(found) =
            own.sign.against(other.sign).or_else(|| by_priority(own, other, priorities))
    {
        return found;
    }
    by_direction(own, other, angle)
}

fn by_priority(
    own: &Movement,
    other: &Movement,
    priorities: &Priorities,
) -> Option<(Relation, RelationReason)> {
    let junction = own.junction?;
    let (mine, theirs) = (roads(own), roads(other));
    let is_of = |roads: [Option<u32>; 2], road: u32| roads.contains(&Some(road));
    let mut found: Option<(u32, bool)> = None;
    // Of all rows that could tell the two apart, the first counts.
    for (high, low) in [(mine, theirs), (theirs, mine)] {
        for high in high.into_iter().flatten() {
            for low in low.into_iter().flatten() {
                let wins = is_of(mine, high) && is_of(theirs, low);
                let loses = is_of(mine, low) && is_of(theirs, high);
                let row = priorities.0.get(&(junction, high, low)).filter(|_| wins != loses);
                if let Some(row) = row
                    && found.is_none_or(|(first, _)| *row < first)
                {
                    found = Some((*row, loses));
                }
            }
        }
    }
    found.map(|(_, loses)| (yields_if(loses), RelationReason::JunctionPriority))
}

/// Rows of the roads by which `junction/priority` may name a movement: the connecting one, and the one that leads to it.
fn roads(movement: &Movement) -> [Option<u32>; 2] {
    [Some(movement.connecting.row()), movement.entry.map(|(entry, _)| entry.row())]
}

fn by_direction(own: &Movement, other: &Movement, angle: f64) -> (Relation, RelationReason) {
    if angle.abs() >= ONCOMING {
        let across =
            |movement: &Movement| movement.turn == movement.across || movement.turn == Turn::Back;
        return match (across(own), across(other)) {
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

fn yields_if(yields: bool) -> Relation {
    if yields { Relation::Yields } else { Relation::Priority }
}
