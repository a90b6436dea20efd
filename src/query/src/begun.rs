//! Where a place falls among rows that ascend.

/// Rows that are looked at side by side.
pub(crate) const TOGETHER: usize = 8;

/// Number of rows that begin at or before a place, of rows whose starts ascend.
///
/// Halving a list waits for one row's memory after the other; few rows are therefore all compared, so that their waits pass side by side.
#[inline(always)]
pub fn begun<T>(mut rows: &[T], at: f64, start: impl Fn(&T) -> f64) -> usize {
    let mut before = 0;
    while rows.len() > TOGETHER {
        let (lower, upper) = rows.split_at(rows.len() / 2);
        if upper.first().is_some_and(|row| start(row) <= at) {
            before += lower.len();
            rows = upper;
        } else {
            rows = lower;
        }
    }
    before + rows.iter().map(|row| usize::from(start(row) <= at)).sum::<usize>()
}
