//! Which of several lanes is nearer.

use crate::lane::Lane;
use crate::map::Map;
use std::cmp::Ordering;

/// What candidates are compared by.
#[derive(Clone, Copy)]
pub(crate) struct Rank {
    pub(crate) lane: u32,
    pub(crate) distance: f64,
    pub(crate) heading_difference: f64,
    pub(crate) z_difference: f64,
    pub(crate) offset: f64,
    pub(crate) s: f64,
    pub(crate) t: f64,
}

impl Rank {
    /// Distance; then heading difference, z difference, width or none, |offset|, key, and where two stretches of one lane meet, s and t:
    /// the answer does not depend on which is visited first.
    #[inline]
    pub(crate) fn order(&self, other: &Self, map: Map<'_>) -> Ordering {
        self.distance
            .total_cmp(&other.distance)
            .then(self.heading_difference.total_cmp(&other.heading_difference))
            .then(self.z_difference.total_cmp(&other.z_difference))
            .then_with(|| self.order_by_width(other, map))
            .then(self.offset.abs().total_cmp(&other.offset.abs()))
            .then_with(|| self.order_by_key(other, map))
    }

    /// A lane that has no width there comes last: on the edge of another it has the smaller offset.
    #[inline]
    fn order_by_width(&self, other: &Self, map: Map<'_>) -> Ordering {
        // Two stretches of one lane meet everywhere; and within lanes, one that is a line has no offset.
        let is_inside = self.distance == 0.0 && self.offset != 0.0 && other.offset != 0.0;
        if is_inside || self.lane == other.lane {
            return Ordering::Equal;
        }
        self.is_line(map).cmp(&other.is_line(map))
    }

    #[cold]
    #[inline(never)]
    fn is_line(&self, map: Map<'_>) -> bool {
        let edges = Lane::new(map, self.lane).map(|lane| lane.edges_at(self.s));
        edges.is_some_and(|edges| edges.inner == edges.outer)
    }

    #[cold]
    fn order_by_key(&self, other: &Self, map: Map<'_>) -> Ordering {
        let key = |rank: &Self| {
            let lane = Lane::new(map, rank.lane)?;
            Some((lane.road.id(), lane.section.number(), lane.number()))
        };
        key(self).cmp(&key(other)).then(self.s.total_cmp(&other.s)).then(self.t.total_cmp(&other.t))
    }
}
