//! Options of callers: structs that begin with their size, so that later releases may append to them.

use crate::code::{Failure, Outcome};
use crate::list::{get, put};

/// Options of a caller's; none for null.
///
/// # Safety
///
/// `options` is null or valid for reads of as many bytes as its first field, a `size_t`, says.
#[inline(always)]
pub(crate) unsafe fn given_options<'a, T>(
    options: *const T,
    init: &'static str,
) -> Result<Option<&'a T>, Failure> {
    if options.is_null() {
        return Ok(None);
    }
    // SAFETY: as promised above; the size comes first in every release.
    let size = unsafe { *get(options.cast::<usize>(), "options")? };
    // A caller whose options are shorter than the first release's was not built for this library.
    if size != size_of::<T>() {
        return Err(other_size(size, size_of::<T>(), init));
    }
    // SAFETY: as promised above; every value of every field is one.
    unsafe { get(options, "options") }.map(Some)
}

#[cold]
#[inline(never)]
fn other_size(found: usize, expected: usize, init: &'static str) -> Failure {
    Failure::argument(format!(
        "expected options of {expected} bytes, found size {found}; set them with {init}"
    ))
}

/// Writes the defaults where the caller knows the options as this library does.
///
/// # Safety
///
/// `options` is null or valid for writes.
pub(crate) unsafe fn put_defaults<T>(options: *mut T, size: usize, defaults: T) -> Outcome {
    if size != size_of::<T>() {
        return Err(Failure::argument(format!(
            "expected options of {} bytes, found {size}; header and library are of different releases",
            size_of::<T>()
        )));
    }
    // SAFETY: as promised above.
    unsafe { put(options, defaults) }
}
