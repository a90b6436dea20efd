//! Speed limits along a path.

use super::Path;
use crate::signals::{SpeedOrigin, SpeedRule};

impl Path<'_, '_> {
    /// The speed limit at S, which is moved to the path's nearer end where it lies outside. In a junction what came in with the vehicle
    /// holds where nothing else is written: the limit where the path enters it. None for an S that is not finite.
    pub fn speed_at(&self, along: f64) -> Option<SpeedRule> {
        if !along.is_finite() {
            return None;
        }
        let along = mapd_geometry::clamp(along, 0.0, self.length());
        let (_, lane, s) = self.driven_at(along)?;
        let rule = lane.speed_rule_at(s);
        if !matches!(rule.origin, SpeedOrigin::Entry | SpeedOrigin::Depends) {
            return Some(rule);
        }
        // What holds on the last lane before the junction; a path that begins within it has none.
        let junction = lane.road().junction_row();
        let before = self.lanes().take_while(|own| own.along[0] <= along).filter_map(|own| {
            let lane = crate::lane::Lane::new(self.map, own.lane.row())?;
            (lane.road().junction_row() != junction).then(|| (lane, own.s[1]))
        });
        let entry = before.last().map(|(lane, s)| lane.speed_rule_at(s));
        let entry = entry.filter(|rule| rule.max.is_some());
        Some(entry.map_or(rule, |entry| SpeedRule { origin: SpeedOrigin::Entry, ..entry }))
    }
}
