//! Fresh client processes: one after the other, and all at once as at boot.

use super::client::{From, Taken, start};
use super::figures::{Comparison, Figures};
use anyhow::Result;
use mapd_client::{Attach, Domain};
use serde::Serialize;
use std::sync::Barrier;
use std::time::{Duration, Instant};

/// What fresh processes took.
#[derive(Debug, Serialize)]
pub(crate) struct Boot {
    pub(crate) comparisons: Vec<Comparison>,
    /// All clients started at once: until the last has its first answer `[ns]`, on the served map and on the file.
    pub(crate) all_answered_ns: [u64; 2],
    /// Minor faults of the first query, on the served map and on the file; medians.
    pub(crate) first_query_faults: [u64; 2],
}

/// Starts clients of the served map and of the file.
///
/// Errors: a client fails.
pub(crate) fn run(
    domain: &Domain,
    attach: Attach,
    map: &str,
    file: &str,
    clients: usize,
) -> Result<Boot> {
    let shared = if attach == Attach::Subscriber { From::Subscriber } else { From::Shm };
    let sources = [(shared, map), (From::File, file)];
    let mut alone: [Vec<Taken>; 2] = Default::default();
    for _ in 0..clients {
        for ((from, what), taken) in sources.iter().zip(&mut alone) {
            taken.push(start(domain, *from, what)?);
        }
    }
    let mut together: [Vec<Taken>; 2] = Default::default();
    let mut all_answered_ns = [0; 2];
    for (i, (from, what)) in sources.into_iter().enumerate() {
        let (taken, until_last) = at_once(domain, from, what, clients)?;
        together[i] = taken;
        all_answered_ns[i] = u64::try_from(until_last.as_nanos()).unwrap_or(u64::MAX);
    }
    let compare = |what, taken: &[Vec<Taken>; 2], which: fn(&Taken) -> Duration| {
        let [shared, file] = taken.each_ref().map(|taken| taken.iter().map(which).collect());
        Comparison::new(what, shared, file)
    };
    let comparisons = [
        compare("exec to first answer", &alone, |taken| taken.exec),
        compare("attach", &alone, |taken| taken.attach),
        compare("first query", &alone, |taken| taken.first_query),
        compare("all at once: exec to first answer", &together, |taken| taken.exec),
        compare("all at once: attach", &together, |taken| taken.attach),
    ];
    let median = |taken: &Vec<Taken>| {
        let faults = taken.iter().map(|taken| Duration::from_nanos(taken.faults)).collect();
        Figures::of(faults).map_or(0, |figures| figures.p50_ns)
    };
    Ok(Boot {
        comparisons: comparisons.into_iter().flatten().collect(),
        all_answered_ns,
        first_query_faults: alone.each_ref().map(median),
    })
}

/// Starts all clients at the same moment; also how long it took until the last one's answer.
fn at_once(
    domain: &Domain,
    from: From,
    what: &str,
    clients: usize,
) -> Result<(Vec<Taken>, Duration)> {
    let barrier = Barrier::new(clients);
    let results: Vec<Result<(Instant, Taken)>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..clients)
            .map(|_| {
                scope.spawn(|| {
                    barrier.wait();
                    let begun = Instant::now();
                    Ok((begun, start(domain, from, what)?))
                })
            })
            .collect();
        let joined = |thread: std::thread::ScopedJoinHandle<'_, _>| {
            thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        threads.into_iter().map(joined).collect()
    });
    let timed = results.into_iter().collect::<Result<Vec<_>>>()?;
    let first = timed.iter().map(|(begun, _)| *begun).min();
    let last = timed.iter().map(|(begun, taken)| *begun + taken.exec).max();
    let until_last = first.zip(last).map_or(Duration::ZERO, |(first, last)| last - first);
    Ok((timed.into_iter().map(|(_, taken)| taken).collect(), until_last))
}
