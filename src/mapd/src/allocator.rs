//! Memory that is given back to the system, and the end of a process that gets none.
//!
//! The C library raises its own limits when large blocks are freed: from then on tables of tens of megabytes come from the
//! heap, whose middle is never given back. On a map of 104 MB that holds 242 to 278 MB at the peak, without it 175.
//!
//! Where there is no memory the standard library ends the process by SIGABRT, as if it were at fault. [`Allocator`] says the
//! same words and ends it with the exit code of a failing environment; it counts nothing, and costs a comparison.
#![allow(unsafe_code)]

use crate::exit::Exit;
use rustix::fs::{Mode, OFlags};
use rustix::process::Resource;
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Blocks from this size on are mapped one by one, and go back when freed `[bytes]`: the C library's own limit at its start.
const MAPPED_FROM: i32 = 128 << 10;
/// Free bytes at the end of a thread's heap from which on it shrinks: more than a road takes while it is read, so that its pages
/// are those of the next one.
const TRIMMED_FROM: i32 = 4 << 20;

/// Keeps the limits where they are. To be called before anything large is allocated; elsewhere than on Linux with glibc it
/// does nothing.
pub(crate) fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: both calls set a number inside the allocator, under its own lock; the parameters exist in every glibc.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, MAPPED_FROM);
        libc::mallopt(libc::M_TRIM_THRESHOLD, TRIMMED_FROM);
    }
}

/// What is said where there is no memory, after the words of the standard library.
pub(crate) const NO_MEMORY_IS_LEFT: &str = "mapd: no memory is left to this process; see `ulimit -v`, --max-memory, the control group, and what is free";

/// The same, where it is address space that is not left.
pub(crate) const NO_ADDRESS_SPACE_IS_LEFT: &str =
    "mapd: no address space is left to this process; raise the limit (`ulimit -v`, LimitAS=)";

/// The system's allocator, for the programs: `#[global_allocator]`.
pub struct Allocator;

// SAFETY: every call is handed on to the system's allocator as it came, and its answer is handed back; where that is no
// block, the call does not return.
unsafe impl GlobalAlloc for Allocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's duty.
        there(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's duty.
        there(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller's duty.
        there(unsafe { System.realloc(block, layout, size) }, size)
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller's duty.
        unsafe { System.dealloc(block, layout) }
    }
}

#[inline]
fn there(block: *mut u8, size: usize) -> *mut u8 {
    if block.is_null() {
        end(size);
    }
    block
}

/// Whether less is left of the address space than of the memory that this process may have (`ulimit -v`, `-d`). Takes no memory.
fn is_address_space_short() -> bool {
    let limit = |of| rustix::process::getrlimit(of).current;
    let Some(address_space) = limit(Resource::As) else { return false };
    // Pages: all, in memory, shared, code, unused, data and stack.
    let mut text = [0; 128];
    let read = rustix::fs::open("/proc/self/statm", OFlags::RDONLY, Mode::empty())
        .and_then(|file| rustix::io::read(file, &mut text));
    let text = read.ok().and_then(|length| std::str::from_utf8(text.get(..length)?).ok());
    let mut numbers = text.unwrap_or_default().split_ascii_whitespace().map(str::parse::<u64>);
    let (Some(Ok(all)), Some(Ok(data))) = (numbers.next(), numbers.nth(4)) else { return true };
    let page = rustix::param::page_size() as u64;
    let left = |limit: u64, pages: u64| limit.saturating_sub(pages.saturating_mul(page));
    limit(Resource::Data).is_none_or(|of_data| left(address_space, all) <= left(of_data, data))
}

/// Says that there is no memory, without taking any, and ends the process.
#[cold]
fn end(size: usize) -> ! {
    static IS_SAID: AtomicBool = AtomicBool::new(false);
    // One thread speaks, and ends all the others.
    while IS_SAID.swap(true, Ordering::Relaxed) {
        std::thread::sleep(Duration::from_secs(1));
    }
    let mut text = [0; 256];
    let mut rest = text.as_mut_slice();
    // It fits; and if it did not, the process would end all the same.
    let what = if is_address_space_short() { NO_ADDRESS_SPACE_IS_LEFT } else { NO_MEMORY_IS_LEFT };
    let _ = writeln!(rest, "memory allocation of {size} bytes failed\n{what}");
    let unused = rest.len();
    let said = text.len() - unused;
    // In one piece, and past the lock of the standard library's stderr, which this thread may hold.
    let _ = rustix::io::write(rustix::stdio::stderr(), text.get(..said).unwrap_or_default());
    // SAFETY: ends the process at once; no destructor or exit handler runs, which might ask for memory.
    unsafe { libc::_exit(i32::from(Exit::Environment.code())) }
}
