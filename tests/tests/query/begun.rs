//! Rows that begin at or before a place are counted as a binary search counts them.

use mapd_query::compiling::begun;

#[test]
fn counts_as_a_binary_search_does() {
    for count in 0..40 {
        // Some begin at the same place.
        let rows: Vec<f64> = (0..count).map(|i| f64::from(i / 3)).collect();
        for at in [-1.0, 0.0, 0.5, 1.0, 4.0, 4.5, 20.0, f64::NAN] {
            let due = rows.partition_point(|row| *row <= at);
            assert_eq!(begun(&rows, at, |row| *row), due, "{count} rows at {at}");
        }
    }
}
