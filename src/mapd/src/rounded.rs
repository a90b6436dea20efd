//! Amounts for people; programs get them exactly, with `--json`.

/// Bytes with three digits, in units of 1000.
pub(crate) fn bytes(count: f64) -> String {
    let units = [(1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    // From where on an amount is rounded to the next unit, or to a digit less.
    match units.into_iter().find(|(unit, _)| count >= 0.9995 * unit) {
        Some((unit, name)) => {
            let value = count / unit;
            let digits = if value < 9.995 {
                2
            } else if value < 99.95 {
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
        for (count, text) in [
            (0.0, "0 bytes"),
            (999.0, "999 bytes"),
            (1000.0, "1.00 kB"),
            (9_994.0, "9.99 kB"),
            (9_999.0, "10.0 kB"),
            (61_544.0, "61.5 kB"),
            (99_960.0, "100 kB"),
            (150_000.0, "150 kB"),
            (999_960.0, "1.00 MB"),
            (37e6, "37.0 MB"),
            (2.5e9, "2.50 GB"),
        ] {
            assert_eq!(bytes(count), text, "{count}");
        }
    }
}
