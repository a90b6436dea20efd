//! Compiling many files at once, each in a process of its own: what ends one of them leaves the others alone.
//!
//! Each of the jobs has an equal share of the memory. A tile that fails, for which that may have been too little, is compiled
//! again when the others are done, alone and with all of it.

use super::inputs::Tile;
use super::table::Row;
use super::up_to_date;
use crate::args::CompileArguments;
use crate::args::ThreadCount;
use crate::child::{self, End, Output, Work};
use crate::draft;
use crate::exit::Exit;
use crate::printable::printable;
use crate::progress::{Manner, Meter, decoded_bytes};
use anyhow::{Context, Result};
use mapd_compiler::Progress;
use signal_hook::consts::{SIGINT, SIGTERM};
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// What is to be done.
pub(super) struct Plan<'a> {
    pub(super) tiles: &'a [Tile],
    pub(super) arguments: &'a CompileArguments,
    /// Hash of all that shapes an archive but its input.
    pub(super) options: [u8; 8],
    /// Also what is up to date.
    pub(super) force: bool,
    /// Tiles at once.
    pub(super) jobs: NonZeroUsize,
    /// Threads for each of them.
    pub(super) threads: ThreadCount,
    /// For all of them together \[bytes\].
    pub(super) memory: Option<u64>,
}

/// Compiles all tiles; a row for each, in their order.
///
/// Errors: handlers of signals cannot be installed. Whatever fails about a tile is in its row.
pub(super) fn run(plan: &Plan<'_>, manner: Manner) -> Result<Vec<Row>> {
    let cancelled = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // A second signal ends the process without waiting for cleanup.
        signal_hook::flag::register_conditional_default(signal, cancelled.clone())
            .and_then(|_| signal_hook::flag::register(signal, cancelled.clone()))
            .context("installing the handlers of SIGINT and SIGTERM")?;
    }
    let work = Shared {
        plan,
        meter: Tally::new(plan.tiles, manner),
        cancelled,
        next: AtomicUsize::new(0),
        rows: Mutex::new(plan.tiles.iter().map(|_| None).collect()),
    };
    let first = Try {
        memory: plan.memory.map(|memory| memory / plan.jobs.get() as u64),
        threads: plan.threads,
        is_last: plan.jobs.get() == 1 || plan.memory.is_none(),
    };
    std::thread::scope(|scope| {
        for _ in 1..plan.jobs.get() {
            // Where no more threads can be had, fewer tiles are compiled at a time.
            let _ = std::thread::Builder::new().spawn_scoped(scope, || work.through(first));
        }
        work.through(first);
    });
    work.again(Try { memory: plan.memory, threads: plan.threads.times(plan.jobs), is_last: true });
    work.meter.finish();
    let rows = work.rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(rows.into_iter().flatten().collect())
}

/// What a tile may take.
#[derive(Clone, Copy)]
struct Try {
    /// \[bytes\]
    memory: Option<u64>,
    threads: ThreadCount,
    /// Whether there will be no other with more.
    is_last: bool,
}

/// What the threads share.
struct Shared<'a> {
    plan: &'a Plan<'a>,
    meter: Tally,
    cancelled: Arc<AtomicBool>,
    next: AtomicUsize,
    /// `None`: not done, or to be done again.
    rows: Mutex<Vec<Option<Row>>>,
}

impl Shared<'_> {
    /// Takes tiles until none is left.
    fn through(&self, means: Try) {
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(tile) = self.plan.tiles.get(number) else { return };
            self.done(number, self.tile(number, tile, means));
        }
    }

    /// Compiles what is left, one after the other, with what there is for all of them.
    fn again(&self, means: Try) {
        for (number, tile) in self.plan.tiles.iter().enumerate() {
            if lock(&self.rows).get(number).is_some_and(Option::is_none) {
                self.done(number, self.tile(number, tile, means));
            }
        }
    }

    fn done(&self, number: usize, row: Option<Row>) {
        if let Some(place) = lock(&self.rows).get_mut(number) {
            *place = row;
        }
    }

    /// Compiles a tile, or finds it up to date. `None`: it needs more memory, and there will be another try.
    fn tile(&self, number: usize, tile: &Tile, means: Try) -> Option<Row> {
        let begun = Instant::now();
        let mut row = Row::new(tile);
        if self.cancelled.load(Ordering::Relaxed) {
            row.fail("interrupted".to_owned());
            return Some(row);
        }
        let known =
            if self.plan.force { None } else { up_to_date::known(tile, &self.plan.options) };
        if let Some(known) = known {
            row.is_up_to_date = true;
            remove_left(tile);
            row.finish(known.exit, known.counts, Some(known.facts));
        } else if !self.compile(number, tile, means, &mut row) {
            return None;
        }
        row.seconds = begun.elapsed().as_secs_f64();
        self.meter.done(number, row.roads());
        Some(row)
    }

    /// False where it is to be tried again.
    fn compile(&self, number: usize, tile: &Tile, means: Try, row: &mut Row) -> bool {
        if let Some(folder) = tile.archive.parent()
            && let Err(error) = std::fs::create_dir_all(folder)
        {
            self.fail(row, format!("making the folder {}: {error}", folder.display()));
            return true;
        }
        let work = Work {
            source: &tile.source,
            output: Output::At { archive: &tile.archive, report: Some(&tile.report) },
            options: self.plan.arguments,
            memory: means.memory,
            threads: Some(means.threads),
            has_input: false,
        };
        // What is said about a tile stays together.
        let mut said = String::new();
        let mut hear = |line: &str| {
            said.push_str(line);
            said.push('\n');
        };
        let mut reading = |progress| {
            if let Progress::Reading { bytes, roads } = progress {
                self.meter.read(number, bytes, roads);
            }
        };
        let ended = child::run(&work, &mut hear, &mut reading, &self.cancelled, None);
        let whole = matches!(ended, Ok((End::Exit(_), _)));
        if !whole {
            remove_left(tile);
        }
        match ended {
            // Want of memory has many faces: threads that cannot be had, files that cannot be mapped.
            Ok((End::Exit(Exit::Environment) | End::OutOfMemory { .. } | End::Broken(_), _))
                if !means.is_last =>
            {
                return false;
            }
            Ok((End::Exit(exit @ (Exit::Environment | Exit::Usage)), _)) => {
                // It has said so itself.
                self.meter.say(&said);
                let last = said.lines().last().unwrap_or("failed without a word");
                row.fail(last.strip_prefix("mapd: ").unwrap_or(last).to_owned());
                row.exit = exit;
            }
            Ok((End::Exit(exit), told)) => {
                self.meter.say(&said);
                row.finish(exit, told.counts, told.archive);
            }
            Ok((end, _)) => {
                self.meter.say(&said);
                self.fail(row, end.reason(means.memory, "--max-memory"));
            }
            Err(error) => self.fail(row, format!("the compiler: {error}")),
        }
        true
    }

    fn fail(&self, row: &mut Row, reason: String) {
        self.meter.say(&format!("mapd: {}: {}\n", printable(&row.tile), printable(&reason)));
        row.fail(reason);
    }
}

/// Removes what a run that was killed has left of a tile.
fn remove_left(tile: &Tile) {
    draft::remove_left(&tile.archive);
    draft::remove_left(&tile.report);
}

/// How far all tiles are, together.
struct Tally {
    meter: Meter,
    sizes: Vec<u64>,
    so_far: Mutex<TilesDone>,
}

#[derive(Default)]
struct TilesDone {
    /// Bytes and roads of each tile.
    tiles: Vec<(u64, usize)>,
    bytes: u64,
    roads: usize,
    done: usize,
}

impl Tally {
    fn new(tiles: &[Tile], manner: Manner) -> Self {
        let sizes: Vec<u64> = tiles.iter().map(|tile| decoded_bytes(&tile.source)).collect();
        let meter = Meter::new("compiling", sizes.iter().sum(), manner);
        let so_far = TilesDone { tiles: vec![(0, 0); tiles.len()], ..TilesDone::default() };
        Self { meter, sizes, so_far: Mutex::new(so_far) }
    }

    /// A tile is read so far.
    fn read(&self, number: usize, bytes: u64, roads: usize) {
        let mut so_far = lock(&self.so_far);
        // Included files are more, a second reading begins again.
        let most = self.sizes.get(number).copied().unwrap_or(0);
        so_far.set(number, bytes.min(most), roads);
        self.show(&so_far);
    }

    /// A tile is done.
    fn done(&self, number: usize, roads: usize) {
        let mut so_far = lock(&self.so_far);
        so_far.set(number, self.sizes.get(number).copied().unwrap_or(0), roads);
        so_far.done += 1;
        self.show(&so_far);
    }

    fn show(&self, so_far: &TilesDone) {
        let (done, all) = (so_far.done, self.sizes.len());
        self.meter.read(so_far.bytes, || format!("{done} of {all} tiles, {} roads", so_far.roads));
    }

    fn say(&self, text: &str) {
        self.meter.say(text);
    }

    fn finish(&self) {
        self.meter.finish();
    }
}

impl TilesDone {
    fn set(&mut self, number: usize, bytes: u64, roads: usize) {
        if let Some(tile) = self.tiles.get_mut(number) {
            let bytes = bytes.max(tile.0);
            self.bytes += bytes - tile.0;
            self.roads = (self.roads + roads).saturating_sub(tile.1);
            *tile = (bytes, roads);
        }
    }
}

/// A poisoned lock is taken all the same: a thread that panicked has left numbers that are still usable.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
