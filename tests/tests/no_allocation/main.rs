//! Queries do not allocate, and what attaching takes is given back: an allocator counts.
#![allow(unsafe_code)]

// Thousands of attaches and opened files: no byte, mapping or file descriptor is kept.
mod kept;
// Lists and batches of places, marks and landmarks.
mod places;
// Single queries, into buffers with room.
mod queries;
// Searches, paths, trackers and batches: their buffers grow once.
mod requests;
// Views: what they add to a map's answers.
mod views;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
    /// Bytes that this thread has allocated, less those that it has freed; below 0 where it freed what others had allocated.
    static LIVE: Cell<i64> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every call is passed on to the system's allocator; counting touches nothing of it.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        LIVE.with(|live| live.set(live.get() + layout.size() as i64));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // Destructors of a thread that ends may come after the counter's own.
        let _ = LIVE.try_with(|live| live.set(live.get() - layout.size() as i64));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What a question answers, and how often this thread allocated while it was asked.
fn counted<T>(ask: impl FnOnce() -> T) -> (T, usize) {
    let before = COUNT.with(Cell::get);
    let answer = ask();
    (answer, COUNT.with(Cell::get) - before)
}

/// A round of questions allocates in its first call at most. It answers how much it saw of each kind: more than `least`, and the same in each call.
fn settles<const KINDS: usize>(
    what: &str,
    least: usize,
    mut round: impl FnMut() -> [usize; KINDS],
) {
    let first = round();
    let (again, allocations) = counted(round);
    assert!(first.iter().all(|seen| *seen > least) && first == again, "{first:?}, {again:?}");
    assert_eq!(allocations, 0, "{what} allocated");
}
