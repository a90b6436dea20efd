//! How many entries hold at one place of a lane.
//!
//! Each piece of a lane lists what holds on it, so entries that lie within each other would make lists as long as all of them together, for each of their ends. A limit
//! on those at one place keeps the tables in proportion to entries and pieces.

use crate::pieces::Mark;
use std::collections::BTreeMap;
use std::ops::Bound::{Excluded, Included, Unbounded};

/// Entries that hold at one place of a lane at most, whether now or at another time; one more is left out whole.
pub(crate) const MOST_AT_A_PLACE: u16 = 256;

/// Entries on a node, from an end of one to the next.
#[derive(Clone, Copy, Default)]
struct Held {
    count: u16,
    /// The one that was counted last, plus 1: it counts once, however many of its places lie there.
    last: u32,
}

/// Entries along nodes of the lane graph.
#[derive(Default)]
pub(crate) struct Depths(BTreeMap<u32, BTreeMap<u64, Held>>);

/// Orders as the number does, which is finite.
fn key(s: f64) -> u64 {
    let bits = s.to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

impl Depths {
    /// Whether another entry may hold where these marks of its lie.
    pub(crate) fn have_room(&self, marks: &[(u32, Mark)]) -> bool {
        marks.iter().all(|(node, mark)| {
            let Some(own) = self.0.get(node) else { return true };
            let (from, to) = (key(mark.s_from), key(mark.s_to));
            let first = own.range(..=from).next_back();
            let within = own.range((Excluded(from), Excluded(to.max(from + 1))));
            first.into_iter().chain(within).all(|(_, held)| held.count < MOST_AT_A_PLACE)
        })
    }

    /// Counts an entry where its marks lie.
    pub(crate) fn add(&mut self, marks: &[(u32, Mark)]) {
        for (node, mark) in marks {
            let own = self.0.entry(*node).or_default();
            let (from, to) = (key(mark.s_from), key(mark.s_to));
            if from >= to {
                continue;
            }
            // At both ends a stretch begins that has what holds there so far.
            for end in [from, to] {
                let before = own.range((Unbounded, Included(end))).next_back();
                let held = before.map_or(Held::default(), |(_, held)| *held);
                own.entry(end).or_insert(held);
            }
            for (_, held) in own.range_mut(from..to) {
                if held.last != mark.entry + 1 {
                    *held = Held { count: held.count.saturating_add(1), last: mark.entry + 1 };
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(entry: u32, s_from: f64, s_to: f64) -> [(u32, Mark); 1] {
        [(7, Mark { s_from, s_to, entry, place: 0 })]
    }

    #[test]
    fn entries_count_where_they_lie() {
        let mut depths = Depths::default();
        for entry in 0..u32::from(MOST_AT_A_PLACE) {
            let own = mark(entry, f64::from(entry) - 300.0, 100.0);
            assert!(depths.have_room(&own));
            // Twice the same place of one entry is one.
            depths.add(&own);
            depths.add(&own);
        }
        let last = f64::from(MOST_AT_A_PLACE) - 301.0;
        for (from, to, has_room) in [
            (-400.0, last, true),
            (-400.0, last + 0.5, false),
            (last, 99.0, false),
            (99.5, 200.0, false),
            (100.0, 200.0, true),
            (0.0, 0.5, false),
        ] {
            assert_eq!(depths.have_room(&mark(1000, from, to)), has_room, "{from} {to}");
        }
        assert!(depths.have_room(&[(8, mark(1000, 0.0, 1.0)[0].1)]), "another node");
    }
}
