//! Asking all maps round after round, so that the watchdog hears in time however many they are.

use super::self_query::{Answered, SelfQueryError, WAIT};
use crate::control::{Board, MapState};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Rounds in one interval of the watchdog: one may fail, and the next come late, before the service manager acts.
const PER_INTERVAL: u32 = 3;

/// Share of a round's wait within which maps are asked: a map that is asked has the rest of it at least, and the daemon does not
/// spend all its time asking.
const ASKING: u32 = 2;

/// What the rounds need of the world.
pub(super) trait Surroundings {
    /// Asks a map, whose generation must not be older than `before`.
    fn ask(&self, map: &str, before: u64, wait: Duration) -> Result<Answered, SelfQueryError>;

    /// The time.
    fn now(&self) -> Instant;

    /// Sleeps, at most so long; whether it is time to end.
    fn sleep(&self, time: Duration) -> bool;

    /// Tells the service manager that all is well.
    fn ping(&self);
}

/// The outcome of a self-query, the most urgent first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Answer {
    Wrong,
    /// None arrived within its wait, which was shorter than usual.
    Late,
    /// There was no room to ask.
    NoRoom,
    Right,
}

/// A map, and the outcome of its last self-query.
struct QueriedMap {
    name: String,
    /// The newest generation that has answered.
    seen: u64,
    last: Option<Answer>,
}

/// All maps.
pub(super) struct Maps {
    board: Arc<Board>,
    maps: Vec<QueriedMap>,
    /// Whose turn it is in the next round.
    next: usize,
}

impl Maps {
    pub(super) fn new(board: &Arc<Board>, names: &[String]) -> Self {
        let asked = |name: &String| QueriedMap { name: name.clone(), seen: 0, last: None };
        Self { board: board.clone(), maps: names.iter().map(asked).collect(), next: 0 }
    }

    pub(super) fn names(&self) -> String {
        let names: Vec<&str> = self.maps.iter().map(|map| map.name.as_str()).collect();
        names.join(", ")
    }

    /// Asks the maps that have not answered yet; whether none is left. Those that have are not asked again: what has become of
    /// them is for the rounds to find.
    pub(super) fn have_all_answered(&mut self, around: &impl Surroundings) -> bool {
        for map in self.maps.iter_mut().filter(|map| map.last != Some(Answer::Right)) {
            if around.sleep(Duration::ZERO) {
                return false;
            }
            map.ask(&self.board, around, WAIT, WAIT);
        }
        self.maps.iter().all(|map| map.last == Some(Answer::Right))
    }

    /// Pings as long as the maps are sound, until it is time to end.
    pub(super) fn attend(&mut self, interval: Duration, around: &impl Surroundings) {
        let pause = interval / PER_INTERVAL;
        let mut begun = around.now();
        // From one beginning to the next, so that a round that waited does not put off the one that may ping.
        while !around.sleep((begun + pause).saturating_duration_since(around.now())) {
            begun = around.now();
            if self.are_sound(WAIT.min(pause), around) {
                around.ping();
            }
        }
    }

    /// Asks as many maps as there is time for; whether none is known to be wrong.
    fn are_sound(&mut self, wait: Duration, around: &impl Surroundings) -> bool {
        let begun = around.now();
        for (asked, place) in self.order().into_iter().enumerate() {
            if around.sleep(Duration::ZERO) {
                return false;
            }
            // For all maps together, so that the watchdog hears in time also where each query waits for room.
            let spent = around.now().saturating_duration_since(begun);
            if asked > 0 && spent >= wait / ASKING {
                break;
            }
            let left = if asked == 0 { wait } else { wait.saturating_sub(spent) };
            let Some(map) = self.maps.get_mut(place) else { break };
            if map.urgency().is_none() {
                self.next = place + 1;
            }
            map.ask(&self.board, around, left, wait);
        }
        let scrubs_fail = |status: &MapState| status.scrubs.last_failed == Some(true);
        !self.maps.iter().any(|map| map.last == Some(Answer::Wrong))
            && !self.board.status().maps.iter().any(scrubs_fail)
    }

    /// First the maps that keep the watchdog waiting, and those that had too little time; then the others, in turn.
    fn order(&self) -> Vec<usize> {
        let count = self.maps.len();
        let mut order: Vec<usize> = (0..count).map(|i| (self.next + i) % count).collect();
        order.sort_by_key(|place| {
            self.maps.get(*place).and_then(QueriedMap::urgency).unwrap_or(Answer::Right)
        });
        order
    }
}

impl QueriedMap {
    /// Why it is asked before its turn, if it is.
    fn urgency(&self) -> Option<Answer> {
        self.last.filter(|last| matches!(last, Answer::Wrong | Answer::Late))
    }

    /// Asks, waiting for as long as is `left`, and records the outcome. `usual` is the wait of a round with enough time.
    fn ask(&mut self, board: &Board, around: &impl Surroundings, left: Duration, usual: Duration) {
        let map = self.name.as_str();
        let answer = match around.ask(map, self.seen, left) {
            Ok(answered) => {
                self.seen = answered.generation;
                board.map(map, |state| state.self_queries.succeeded(answered.taken));
                Answer::Right
            }
            Err(error) if error.is_no_verdict() => {
                let text = error.to_string();
                tracing::warn!(map = %map, error = %text, "map {map}: no room for a self-query: {text}");
                board.map(map, |state| state.self_queries.skipped(text));
                Answer::NoRoom
            }
            Err(error) if left < usual && error.may_be_late() => {
                let text = error.to_string();
                tracing::debug!(map = %map, error = %text, "map {map}: no time left for a self-query: {text}");
                board.map(map, |state| state.self_queries.skipped(text));
                // Nothing new: what was wrong stays so until it has answered.
                if self.last == Some(Answer::Wrong) { Answer::Wrong } else { Answer::Late }
            }
            Err(error) => {
                let text = error.to_string();
                tracing::error!(map = %map, error = %text, "map {map}: a self-query failed: {text}");
                board.map(map, |state| state.self_queries.failed(text));
                Answer::Wrong
            }
        };
        self.last = Some(answer);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mapd_client::{AttachError, ClientError, Domain};
    use std::cell::{Cell, RefCell};

    /// What systemd's units have in the examples.
    const INTERVAL: Duration = Duration::from_secs(10);
    /// What one of the maps takes to answer.
    const USUAL: Duration = Duration::from_millis(100);
    /// So many that a pass takes [`ROUNDS`].
    const MAPS: usize = 60;
    /// Rounds in which every map has its turn.
    const ROUNDS: u32 = 6;
    /// No answer at all.
    const NEVER: Duration = Duration::MAX;
    /// When a test ends.
    const END: Duration = Duration::from_secs(70);

    /// What the `n`-th query takes, of this map, at this time.
    type Takes<'a> = &'a dyn Fn(usize, usize, Duration) -> Duration;

    /// A world with a time of its own.
    struct World<'a> {
        start: Instant,
        now: Cell<Duration>,
        takes: Takes<'a>,
        asked: RefCell<Vec<usize>>,
        pings: RefCell<Vec<Duration>>,
    }

    impl Surroundings for World<'_> {
        fn ask(&self, map: &str, _: u64, wait: Duration) -> Result<Answered, SelfQueryError> {
            let number = map.parse().expect("a number");
            let taken = (self.takes)(self.asked.borrow().len(), number, self.now.get());
            self.asked.borrow_mut().push(number);
            self.now.set(self.now.get() + taken.min(wait));
            if taken <= wait {
                return Ok(Answered { generation: 1, taken });
            }
            let map = map.to_owned();
            let late = AttachError::NoGeneration { map, newer_than: 0, daemon_alive: true };
            Err(ClientError::Attach(late).into())
        }

        fn now(&self) -> Instant {
            self.start + self.now.get()
        }

        fn sleep(&self, time: Duration) -> bool {
            self.now.set(self.now.get() + time);
            self.now.get() >= END
        }

        fn ping(&self) {
            self.pings.borrow_mut().push(self.now.get());
        }
    }

    /// Attends to maps; which were asked one after the other, and when the service manager heard of it, which begins to wait
    /// at 0.
    fn attend(takes: Takes<'_>) -> (Vec<usize>, Vec<Duration>) {
        let domain = Domain::new("rounds_").expect("a prefix");
        let names: Vec<String> = (0..MAPS).map(|number| number.to_string()).collect();
        let world = World {
            start: Instant::now(),
            now: Cell::default(),
            takes,
            asked: RefCell::default(),
            pings: RefCell::new(vec![Duration::ZERO]),
        };
        Maps::new(&Arc::new(Board::new(&domain, None)), &names).attend(INTERVAL, &world);
        (world.asked.into_inner(), world.pings.into_inner())
    }

    /// The longest time between two pings.
    fn gap(pings: &[Duration]) -> Duration {
        pings.windows(2).map(|two| two[1] - two[0]).max().unwrap_or(END)
    }

    #[test]
    fn all_maps_are_asked_in_turn_and_pings_come_in_time() {
        let (asked, pings) = attend(&|_, _, _| USUAL);
        assert!(asked.len() > 2 * MAPS, "{} queries", asked.len());
        assert!(asked.iter().enumerate().all(|(turn, map)| *map == turn % MAPS), "{asked:?}");
        assert!(gap(&pings) <= INTERVAL / PER_INTERVAL + WAIT, "{pings:?}");
    }

    /// One late answer once had the daemon killed: its map was asked again only when its turn came.
    #[test]
    fn whichever_map_is_late_once_the_watchdog_hears_in_time() {
        let (queries, _) = attend(&|_, _, _| USUAL);
        for late in 0..queries.len() {
            for taken in [WAIT * 19 / 20, NEVER] {
                let (_, pings) = attend(&|query, _, _| if query == late { taken } else { USUAL });
                let most = 2 * INTERVAL / PER_INTERVAL + WAIT;
                assert!(gap(&pings) <= most && most < INTERVAL, "query {late}: {pings:?}");
            }
        }
    }

    /// A wait that was cut short is no verdict, but the next one is not cut short.
    #[test]
    fn a_map_that_never_answers_silences_the_watchdog_until_it_does() {
        let pause = INTERVAL / PER_INTERVAL;
        let (from, to) = (Duration::from_secs(5), Duration::from_secs(45));
        for ill in 0..MAPS {
            let takes =
                |_, map, now| if map == ill && now >= from && now < to { NEVER } else { USUAL };
            let (asked, pings) = attend(&takes);
            let rounds = ROUNDS + 2;
            let (silent, again) = (from + rounds * pause, to + pause + 2 * WAIT);
            let silence: Vec<_> =
                pings.iter().filter(|ping| **ping > silent && **ping < to).collect();
            assert!(silence.is_empty(), "map {ill}: {silence:?}");
            assert!(pings.iter().any(|ping| *ping >= to && *ping <= again), "map {ill}: {pings:?}");
            assert!((0..MAPS).all(|map| asked.contains(&map)), "map {ill}");
        }
    }
}
