//! Percentiles.

use serde::Serialize;
use std::time::Duration;

/// Has the compiler compute a value that nobody uses.
pub(crate) fn keep<T>(value: T) {
    std::hint::black_box(value);
}

/// The distribution of some times, by nearest rank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Figures {
    pub(crate) count: usize,
    pub(crate) p50_ns: u64,
    pub(crate) p90_ns: u64,
    pub(crate) p99_ns: u64,
    pub(crate) max_ns: u64,
}

impl Figures {
    /// `None` without times.
    pub(crate) fn of(mut times: Vec<Duration>) -> Option<Self> {
        times.sort_unstable();
        let count = times.len();
        let rank = |percent: usize| {
            let rank = (count * percent).div_ceil(100).saturating_sub(1);
            times.get(rank).map(|time| u64::try_from(time.as_nanos()).unwrap_or(u64::MAX))
        };
        Some(Self {
            count,
            p50_ns: rank(50)?,
            p90_ns: rank(90)?,
            p99_ns: rank(99)?,
            max_ns: rank(100)?,
        })
    }
}

/// The same work on the served map and on the mapped file, in one run.
#[derive(Debug, Serialize)]
pub(crate) struct Comparison {
    pub(crate) what: &'static str,
    /// On the generation in shared memory.
    pub(crate) shared: Figures,
    /// On a file with the same bytes, by plain open and mmap.
    pub(crate) file: Figures,
    /// Median on the first by median on the second; 0 where the clock cannot tell.
    pub(crate) ratio_p50: f64,
}

impl Comparison {
    /// `None` if either side has no times.
    pub(crate) fn new(
        what: &'static str,
        shared: Vec<Duration>,
        file: Vec<Duration>,
    ) -> Option<Self> {
        let (shared, file) = (Figures::of(shared)?, Figures::of(file)?);
        let ratio_p50 = match file.p50_ns {
            0 => 0.0,
            file => shared.p50_ns as f64 / file as f64,
        };
        Some(Self { what, shared, file, ratio_p50 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks() {
        let times = |n: u64| (1..=n).rev().map(Duration::from_nanos).collect();
        let figures =
            |n: u64| Figures::of(times(n)).map(|f| [f.p50_ns, f.p90_ns, f.p99_ns, f.max_ns]);
        assert_eq!(figures(0), None);
        assert_eq!(figures(1), Some([1, 1, 1, 1]));
        assert_eq!(figures(2), Some([1, 2, 2, 2]));
        assert_eq!(figures(100), Some([50, 90, 99, 100]));
        assert_eq!(figures(1000), Some([500, 900, 990, 1000]));
    }
}
