//! Who goes first by a country's rules of the road, where nothing is written.

use crate::lane::Lane;
use mapd_archive::{FromSide, Relation, RelationReason, RoadRules, RoadType};

/// Who goes first by a country's rules; none where they say nothing of it. `relation` and `reason` are the map's, `alike` is whether
/// both come by equal roads.
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

impl Lane<'_> {
    /// Whether the junction is entered by equal roads on the ways through this lane and through another, as far as the file says: of one
    /// type, with one speed limit, and no motorway.
    pub(crate) fn comes_by_equal_road(&self, other: &Lane<'_>) -> bool {
        let written = |lane: &Lane<'_>| {
            let entry = lane.entries().next()?;
            let section = entry.section();
            let s = if entry.is_forward() { section.s_end() } else { section.s_start() };
            let kind = entry.road().types().take_while(|record| record.s <= s).last();
            Some((kind.map(|record| record.kind), entry.speed_limit_at(s)))
        };
        let (own, other) = (written(self), written(other));
        let motorway = own.is_some_and(|(kind, _)| kind == Some(RoadType::Motorway));
        own.is_some() && own == other && !motorway
    }
}
