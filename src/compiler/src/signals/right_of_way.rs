//! Who goes first where lanes of a junction meet, as [`Movement`] tells.

use crate::sample::view;
use mapd_archive::{
    ConflictKind, ConflictRow, JunctionPriorityRow, NONE, Relation, RelationReason, Rows,
};
use mapd_query::compiling::{ByRow as _, LightGroup, Movement};
use mapd_query::{Lane, Map};
use rayon::prelude::*;
use std::collections::HashMap;

/// A movement, and its lights in groups that switch together.
struct Lit {
    movement: Movement,
    lights: Vec<LightGroup>,
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
        let read = |number: &u32| Some(lit(&map.lane_by_row(*number)?));
        let movements: Vec<Option<Lit>> = numbers.par_iter().map(read).collect();
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
            let entry = own.movement.entry;
            let one_entry = entry.is_some() && entry == other.movement.entry;
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

fn lit(lane: &Lane<'_>) -> Lit {
    let mut lights = Vec::new();
    let movement = Movement::of(lane, |light| {
        lights.extend(LightGroup::of(light));
        true
    });
    Lit { movement, lights }
}

fn relation(own: &Lit, other: &Lit, priorities: &Priorities) -> (Relation, RelationReason) {
    let together = || own.lights.iter().any(|light| other.lights.contains(light));
    let priority = |junction, high, low| priorities.0.get(&(junction, high, low)).copied();
    own.movement.against(&other.movement, together, priority)
}
