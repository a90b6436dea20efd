//! Texts of both sides.

use crate::code::{Failure, Outcome, mapd_code};
use crate::list::{get, put_raw};
use std::ffi::{CStr, c_char};

/// A text in the snapshot: UTF-8, not terminated by 0. It is valid as long as a handle of the snapshot's content is open: the snapshot
/// itself, its clones and what was made from it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_text {
    /// Its first byte; never null.
    pub data: *const c_char,
    /// Its length in bytes.
    pub size: usize,
}

impl From<&str> for mapd_text {
    fn from(text: &str) -> Self {
        Self { data: text.as_ptr().cast(), size: text.len() }
    }
}

/// A caller's text.
///
/// # Safety
///
/// `text` is null or terminated by 0 and valid for reads for `'a`.
pub(crate) unsafe fn given<'a>(
    text: *const c_char,
    what: &'static str,
) -> Result<&'a str, Failure> {
    // SAFETY: as promised above.
    let first = unsafe { get(text, what) }?;
    // SAFETY: not null, and terminated as promised above.
    let text = unsafe { CStr::from_ptr(first) };
    text.to_str().map_err(|_| Failure::argument(format!("{what} is not UTF-8")))
}

/// A caller's text that may be missing.
///
/// # Safety
///
/// As [`given`].
pub(crate) unsafe fn given_or_null<'a>(
    text: *const c_char,
    what: &'static str,
) -> Result<Option<&'a str>, Failure> {
    if text.is_null() {
        return Ok(None);
    }
    // SAFETY: as promised above.
    unsafe { given(text, what) }.map(Some)
}

/// Writes a text into the caller's buffer, terminated by 0, and its length without that; says so if it is too small.
///
/// # Safety
///
/// `out` is null or valid for writes of `capacity` bytes, `length` null or valid for writes.
pub(crate) unsafe fn copy_out(
    text: &str,
    out: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> Outcome {
    if out.is_null() && capacity > 0 {
        return Err(Failure::null("the text"));
    }
    // SAFETY: as promised above.
    unsafe { put_raw(length, text.len()) }?;
    if capacity == 0 {
        return Ok(mapd_code::TOO_SMALL);
    }
    let mut end = text.len().min(capacity - 1);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    // SAFETY: `end` is less than `capacity`, and the buffer has as many bytes, as promised above.
    unsafe {
        std::ptr::copy_nonoverlapping(text.as_ptr().cast(), out, end);
        out.add(end).write(0);
    }
    Ok(if end < text.len() { mapd_code::TOO_SMALL } else { mapd_code::OK })
}
