//! Page faults of this process.

/// Field of `/proc/self/stat` behind the program's name that counts minor faults (proc(5): field 10 of all).
const MINOR: usize = 7;

/// Minor page faults of this process since it began; 0 if the system does not say.
pub(crate) fn minor_faults() -> u64 {
    std::fs::read_to_string("/proc/self/stat").ok().and_then(|text| parse(&text)).unwrap_or(0)
}

/// The program's name may hold blanks and parentheses: what counts is behind the last one.
fn parse(stat: &str) -> Option<u64> {
    stat.rsplit_once(')')?.1.split_whitespace().nth(MINOR)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tenth_field() {
        assert_eq!(parse("1 (a) b) R 2 3 4 5 6 7 88 9"), Some(88));
        assert_eq!(parse(""), None);
        assert!(minor_faults() > 0);
    }
}
