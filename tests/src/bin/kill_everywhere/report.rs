//! What was seen.

use mapd_tests::say;
use mapd_tests::stage::Checked;
use mapd_tests::tracer::{Moment, Then};
use std::fmt;
use std::time::{Duration, Instant};

/// What was seen with one victim.
pub(crate) struct Report {
    victim: String,
    begun: Instant,
    moments: usize,
    chosen: usize,
    killed: usize,
    failures: Vec<String>,
    attach: Vec<Duration>,
    start: Vec<Duration>,
}

impl Report {
    pub(crate) fn new(victim: impl Into<String>, moments: usize, chosen: usize) -> Self {
        Self {
            victim: victim.into(),
            begun: Instant::now(),
            moments,
            chosen,
            killed: 0,
            failures: Vec::new(),
            attach: Vec::new(),
            start: Vec::new(),
        }
    }

    /// Counts a run: whether the victim was killed, or ended before the moment came.
    pub(crate) fn ran(&mut self, killed: bool) {
        self.killed += usize::from(killed);
    }

    /// A fresh client needed so long to start, attach, answer and end.
    pub(crate) fn attached(&mut self, time: Duration) {
        self.attach.push(time);
    }

    /// A daemon needed so long until it served.
    pub(crate) fn started(&mut self, time: Duration) {
        self.start.push(time);
    }

    /// Notes, and says at once, what a check found.
    pub(crate) fn note<T>(&mut self, when: &dyn fmt::Display, result: Checked<T>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                let failure = format!("killed {when}: {error}");
                say(&format!("FAILED {}: {failure}", self.victim));
                self.failures.push(failure);
                None
            }
        }
    }

    pub(crate) fn is_good(&self) -> bool {
        self.failures.is_empty() && self.killed > 0
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.victim)?;
        if self.moments > 0 {
            write!(f, "{} moments, {} chosen, ", self.moments, self.chosen)?;
        }
        write!(f, "{} killed", self.killed)?;
        if self.chosen > self.killed {
            write!(f, " ({} runs ended before their moment)", self.chosen - self.killed)?;
        }
        write!(f, ", {} failures", self.failures.len())?;
        for (what, times) in [("fresh client", &self.attach), ("daemon start", &self.start)] {
            let mut times = times.clone();
            times.sort_unstable();
            if let (Some(median), Some(worst)) = (times.get(times.len() / 2), times.last()) {
                write!(f, ", {what} {median:.1?} median {worst:.1?} worst")?;
            }
        }
        write!(f, ", {:.0?} in all", self.begun.elapsed())
    }
}

/// Which of a victim's moments it is killed at.
#[derive(Clone, Copy)]
pub(crate) struct Choice<'a> {
    /// At most so many, evenly spread over all of them.
    pub(crate) most: usize,
    /// Only at calls of these names; all, if there are none.
    pub(crate) calls: &'a [String],
}

impl Choice<'_> {
    pub(crate) fn of(self, moments: &[Moment]) -> Vec<Moment> {
        let named = |moment: &&Moment| {
            self.calls.is_empty() || self.calls.contains(&moment.name.to_string())
        };
        let named: Vec<Moment> = moments.iter().filter(named).copied().collect();
        let step = named.len().div_ceil(self.most.max(1)).max(1);
        named.into_iter().step_by(step).collect()
    }
}

/// Runs of a victim until it comes to a moment. Threads race, and with them what each has to do.
const TRIES: usize = 5;

/// A moment at which a victim is killed.
pub(crate) trait Killing {
    /// Runs a victim and kills it here; whether it came here in one of [`TRIES`] runs. `victim` tells whether it was
    /// killed.
    fn kill(
        &self,
        victim: impl Fn(&mut dyn FnMut(&Moment) -> Then) -> Checked<bool>,
    ) -> Checked<bool>;
}

impl Killing for Moment {
    fn kill(
        &self,
        victim: impl Fn(&mut dyn FnMut(&Moment) -> Then) -> Checked<bool>,
    ) -> Checked<bool> {
        for _ in 0..TRIES {
            let killed = victim(&mut |now| {
                let is_it = (now.thread, now.call, now.side) == (self.thread, self.call, self.side);
                if is_it { Then::Kill } else { Then::Continue }
            })?;
            if killed {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
