//! Amounts for people; programs get them exactly, with `--json`.

/// Bytes with three digits, in units of 1000.
pub(crate) fn bytes(count: f64) -> String {
    let units = [(1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    match units.into_iter().find(|(unit, _)| count >= *unit) {
        Some((unit, name)) => {
            let value = count / unit;
            let digits = if value < 10.0 {
                2
            } else if value < 100.0 {
                1
            } else {
                0
            };
            format!("{value:.digits$} {name}")
        }
        None => format!("{count:.0} bytes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits() {
        let sizes = [0.0, 999.0, 1000.0, 61_544.0, 150_000.0, 37e6, 2.5e9].map(bytes);
        let expected =
            ["0 bytes", "999 bytes", "1.00 kB", "61.5 kB", "150 kB", "37.0 MB", "2.50 GB"];
        assert_eq!(sizes, expected);
    }
}
