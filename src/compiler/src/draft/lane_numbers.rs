//! Numbers of lanes that something is for.

use std::sync::Arc;

/// Lanes that validities name: looked up, however many there are. Copies share them.
#[derive(Clone, Default)]
pub(crate) struct LaneNumbers(Arc<[(i32, i32)]>);

impl LaneNumbers {
    /// Of ranges, each with its lower number first.
    pub(crate) fn new(ranges: &[(i32, i32)]) -> Self {
        let mut ascending = ranges.to_vec();
        ascending.sort_unstable();
        let mut apart: Vec<(i32, i32)> = Vec::with_capacity(ranges.len());
        for (from, to) in ascending {
            match apart.last_mut().filter(|last| from <= last.1.saturating_add(1)) {
                Some(last) => last.1 = last.1.max(to),
                None => apart.push((from, to)),
            }
        }
        Self(apart.into())
    }

    /// Whether nothing is said about lanes.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn contains(&self, number: i32) -> bool {
        let after = self.0.partition_point(|(from, _)| *from <= number);
        let own = after.checked_sub(1).and_then(|own| self.0.get(own));
        own.is_some_and(|(_, to)| number <= *to)
    }

    /// Whether lane 0 alone is named.
    pub(crate) fn is_center_alone(&self) -> bool {
        *self.0 == [(0, 0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_all_ranges() {
        for ranges in [
            &[][..],
            &[(0, 0)],
            &[(0, 0), (0, 0)],
            &[(-3, -1), (-1, -1), (2, 4)],
            &[(5, 9), (-9, 9), (i32::MIN, -12), (7, i32::MAX)],
            &[(1, 2), (3, 4), (6, 6)],
        ] {
            let numbers = LaneNumbers::new(ranges);
            assert_eq!(numbers.is_empty(), ranges.is_empty());
            let is_center = !ranges.is_empty() && ranges.iter().all(|range| *range == (0, 0));
            assert_eq!(numbers.is_center_alone(), is_center, "{ranges:?}");
            for number in (-15..15).chain([i32::MIN, i32::MAX]) {
                let is_named = ranges.iter().any(|(from, to)| (*from..=*to).contains(&number));
                assert_eq!(numbers.contains(number), is_named, "{number} of {ranges:?}");
            }
        }
    }
}
