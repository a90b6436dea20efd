//! Who goes first by a country's rules of the road, where nothing is written.

use super::Turn;
use crate::ids::RoadId;
use crate::lane::Lane;
use mapd_archive::{FromSide, Relation, RelationReason, RoadRules, RoadType};

/// Who goes first by a country's rules; none where they say nothing of it. `relation` and `reason` are the map's, `alike` is
/// [`Lane::comes_by_equal_road`].
pub(crate) fn by_rules(
    rules: &RoadRules,
    relation: Relation,
    reason: RelationReason,
    alike: bool,
) -> Option<Relation> {
    match reason {
        RelationReason::Turn => rules.turn.then_some(relation),
        // The rule of the side is one of crossings of equal roads.
        RelationReason::FromTheRight if alike => match rules.from_side? {
            FromSide::Right => Some(relation),
            FromSide::Left => Some(match relation {
                Relation::Yields => Relation::Priority,
                Relation::Priority => Relation::Yields,
                other => other,
            }),
        },
        _ => None,
    }
}

/// A road where a junction is entered or left, in one direction.
struct Arm {
    road: RoadId,
    forward: bool,
    written: Written,
    /// Lanes of the direction that are open to some vehicle.
    lanes: usize,
}

/// What the file says of a road at a place.
#[derive(PartialEq)]
struct Written {
    kind: Option<RoadType>,
    /// `[m/s]`
    limit: Option<f64>,
}

impl Arm {
    /// Of a lane, where its traffic leaves it or comes onto it.
    fn new(lane: &Lane<'_>, at_end: bool) -> Self {
        let (section, forward) = (lane.section(), lane.is_forward());
        let s = if forward == at_end { section.s_end() } else { section.s_start() };
        let kind = lane.road().types().take_while(|record| record.s <= s).last();
        let kind = kind.map(|record| record.kind);
        let is_open =
            |own: &Lane<'_>| own.nodes().any(|node| node.is_forward() == forward && node.is_open());
        Self {
            road: lane.road().road_id(),
            forward,
            written: Written { kind, limit: lane.recorded_speed_limit_at(s) },
            lanes: section.lanes().filter(is_open).count(),
        }
    }
}

impl Lane<'_> {
    /// Whether the rule of the side may hold between the ways through this lane and through another: the junction is entered by equal roads, as
    /// far as the file says (of one type, with one speed limit, and no motorway), and neither way joins the road on which the other goes straight on.
    pub(crate) fn comes_by_equal_road(&self, other: &Lane<'_>) -> bool {
        let entry = |lane: &Lane<'_>| Some(Arm::new(&lane.entries().next()?, true));
        let (Some(own), Some(theirs)) = (entry(self), entry(other)) else { return false };
        own.written == theirs.written
            && own.written.kind != Some(RoadType::Motorway)
            && !self.is_joined(&own, other, &theirs)
            && !other.is_joined(&theirs, self, &own)
    }

    /// Whether the way through this lane goes straight on along a road that another way joins as a ramp does: both leave to one road in one direction,
    /// which has the type, the limit and the number of lanes of the road by which this one comes; the other comes by fewer lanes.
    fn is_joined(&self, entry: &Arm, other: &Lane<'_>, ramp: &Arm) -> bool {
        if ramp.lanes >= entry.lanes || self.turn() != Turn::Straight {
            return false;
        }
        let exit = |lane: &Lane<'_>| Some(Arm::new(&lane.departures().next()?.0, false));
        let (Some(exit), Some(theirs)) = (exit(self), exit(other)) else { return false };
        (exit.road, exit.forward) == (theirs.road, theirs.forward)
            && exit.written == entry.written
            && exit.lanes == entry.lanes
    }
}
