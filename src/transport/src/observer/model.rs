//! The record's protocol, searched exhaustively: `page.rs` itself runs on a memory as weak as the language allows.
//!
//! A writer depends on no reader. So all its stores are made first, each with what it hands on to its reader; then a reader runs once for
//! every sequence of stores that its loads may meet: for each load, any store that is not older than what the reader has seen of that word. That is all
//! that release, acquire and relaxed operations and fences promise, for a reader that stores nothing. A kill between any two stores is a shorter
//! list of stores, which a successor goes on with.

/// Words of a slot here: few enough to be searched.
const WORDS: usize = 3;

#[path = "page.rs"]
#[allow(dead_code, clippy::duplicate_mod)]
mod page;

use page::{MAGIC, Page};
use std::cell::RefCell;
use std::collections::BTreeSet;

/// For each word the latest store that is known.
type View = Vec<usize>;

/// A store.
#[derive(Clone)]
struct Store {
    value: u64,
    /// What a reader that loads it with acquire, or before an acquire fence, knows from then on.
    hands_on: View,
}

#[derive(Clone, Copy, PartialEq)]
enum Role {
    Writer,
    Reader,
}

struct Memory {
    role: Role,
    fences: bool,
    /// All stores to each word.
    stores: Vec<Vec<Store>>,
    /// How many stores the writer makes before it is killed.
    left: usize,
    knows: View,
    /// The writer's knowledge at its last releasing fence; what the reader will know at its next acquiring one.
    fenced: View,
    /// Which of the possible stores each load meets, and how many there were.
    choices: Vec<(usize, usize)>,
    next: usize,
}

thread_local! {
    static MEMORY: RefCell<Memory> = RefCell::new(Memory::new(true, 0));
}

/// Words of a page.
const PLACES: usize = 4 + 2 * WORDS;

impl Memory {
    fn new(fences: bool, left: usize) -> Self {
        let first = |place| {
            let value = if place == 0 { MAGIC } else { 0 };
            vec![Store { value, hands_on: vec![0; PLACES] }]
        };
        Self {
            role: Role::Writer,
            fences,
            stores: (0..PLACES).map(first).collect(),
            left,
            knows: vec![0; PLACES],
            fenced: vec![0; PLACES],
            choices: Vec::new(),
            next: 0,
        }
    }

    fn load(&mut self, place: usize, ordering: atomic::Ordering) -> u64 {
        let stores = self.stores[place].len();
        if self.role == Role::Writer {
            // The kernel hands the map's claim on, and with it all that was stored before.
            return self.stores[place][stores - 1].value;
        }
        let possible = stores - self.knows[place];
        if self.next == self.choices.len() {
            self.choices.push((0, possible));
        }
        let met = self.knows[place] + self.choices[self.next].0;
        self.next += 1;
        self.knows[place] = met;
        let store = self.stores[place][met].clone();
        join(&mut self.fenced, &store.hands_on);
        if ordering == atomic::Ordering::Acquire {
            join(&mut self.knows, &store.hands_on);
        }
        store.value
    }

    fn store(&mut self, place: usize, value: u64, ordering: atomic::Ordering) {
        assert!(self.role == Role::Writer, "a reader stores nothing");
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        self.knows[place] = self.stores[place].len();
        let is_releasing = ordering == atomic::Ordering::Release;
        let mut hands_on = if is_releasing { self.knows.clone() } else { self.fenced.clone() };
        hands_on[place] = self.knows[place];
        self.stores[place].push(Store { value, hands_on });
    }

    fn fence(&mut self, ordering: atomic::Ordering) {
        match (self.fences, ordering) {
            (true, atomic::Ordering::Release) => self.fenced = self.knows.clone(),
            (true, atomic::Ordering::Acquire) => {
                let fenced = self.fenced.clone();
                join(&mut self.knows, &fenced);
            }
            _ => {}
        }
    }

    /// The next way for the loads to go; false after the last.
    fn next_choices(&mut self) -> bool {
        while let Some((choice, possible)) = self.choices.pop() {
            if choice + 1 < possible {
                self.choices.push((choice + 1, possible));
                return true;
            }
        }
        false
    }
}

fn join(into: &mut View, other: &View) {
    for (one, other) in into.iter_mut().zip(other) {
        *one = (*one).max(*other);
    }
}

/// Atomics of that memory.
mod atomic {
    use super::MEMORY;
    pub(super) use std::sync::atomic::Ordering;

    pub(super) struct AtomicU64(pub(super) usize);
    pub(super) struct AtomicU32(pub(super) usize);

    impl AtomicU64 {
        pub(super) fn load(&self, ordering: Ordering) -> u64 {
            MEMORY.with_borrow_mut(|memory| memory.load(self.0, ordering))
        }

        pub(super) fn store(&self, value: u64, ordering: Ordering) {
            MEMORY.with_borrow_mut(|memory| memory.store(self.0, value, ordering));
        }
    }

    impl AtomicU32 {
        pub(super) fn load(&self, ordering: Ordering) -> u32 {
            AtomicU64(self.0).load(ordering) as u32
        }

        pub(super) fn store(&self, value: u32, ordering: Ordering) {
            AtomicU64(self.0).store(value.into(), ordering);
        }
    }

    pub(super) fn fence(ordering: Ordering) {
        MEMORY.with_borrow_mut(|memory| memory.fence(ordering));
    }
}

fn page() -> Page {
    use atomic::{AtomicU32, AtomicU64};
    let slot = |slot| std::array::from_fn(|word| AtomicU64(4 + slot * WORDS + word));
    Page {
        magic: AtomicU64(0),
        revision: AtomicU32(1),
        sequence: AtomicU32(2),
        heartbeat: AtomicU64(3),
        slots: [slot(0), slot(1)],
    }
}

/// Publications of a writer; those of its successor say something else under the same sequence.
const PUBLICATIONS: u32 = 3;

/// Stores of one publication: the words of a slot, and the sequence.
const STORES: usize = WORDS + 1;

fn words(sequence: u32, writer: u64) -> [u64; WORDS] {
    std::array::from_fn(|i| 1000 * u64::from(sequence) + 10 * writer + i as u64)
}

fn publish(page: &Page, writer: u64) {
    for _ in 0..PUBLICATIONS {
        let next = Page::next(page.sequence.load(atomic::Ordering::Relaxed));
        page.write(next, &words(next, writer));
        page.hold(next);
    }
}

/// What a reader may read, of a writer that is killed after so many stores, and its successor.
fn readings(killed_after: usize, fences: bool) -> BTreeSet<Option<(u32, [u64; WORDS])>> {
    let page = page();
    MEMORY.set(Memory::new(fences, killed_after));
    publish(&page, 1);
    // The successor lives.
    MEMORY.with_borrow_mut(|memory| {
        memory.left = usize::MAX;
        memory.fenced = vec![0; PLACES];
    });
    publish(&page, 2);
    let mut found = BTreeSet::new();
    loop {
        MEMORY.with_borrow_mut(|memory| {
            memory.role = Role::Reader;
            memory.knows = vec![0; PLACES];
            memory.fenced = vec![0; PLACES];
            memory.next = 0;
        });
        found.insert(page.read());
        if !MEMORY.with_borrow_mut(Memory::next_choices) {
            return found;
        }
    }
}

/// Whether this is what some writer had hold under that sequence.
fn is_whole(reading: &Option<(u32, [u64; WORDS])>, killed_after: usize) -> bool {
    // The killed writer had so many hold; the next ones are its successor's.
    let by_the_first = (killed_after / STORES) as u32;
    match reading {
        None => true,
        // Says that nothing is served, whatever its slot holds.
        Some((0, _)) => true,
        Some((sequence, said)) => {
            let writer = if *sequence <= by_the_first { 1 } else { 2 };
            *said == words(*sequence, writer)
        }
    }
}

#[test]
fn no_reader_sees_half_a_slot() {
    for killed_after in 0..=STORES * PUBLICATIONS as usize {
        let found = readings(killed_after, true);
        for reading in &found {
            assert!(is_whole(reading, killed_after), "killed after {killed_after}: {reading:?}");
        }
        let by_the_first = (killed_after / STORES) as u32;
        let sequences: BTreeSet<u32> =
            found.iter().flatten().map(|(sequence, _)| *sequence).collect();
        assert!((1..=by_the_first + PUBLICATIONS).all(|sequence| sequences.contains(&sequence)));
    }
}

/// The search finds what the fences are for.
#[test]
fn without_fences_a_reader_does() {
    let found = readings(STORES * PUBLICATIONS as usize, false);
    let is_torn = |reading: &_| !is_whole(reading, STORES * PUBLICATIONS as usize);
    assert!(found.iter().any(is_torn), "{found:?}");
}
