//! Answers on their way into the caller's memory.

use crate::code::{Failure, Outcome, mapd_code};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a pointer of the caller's points to.
///
/// # Safety
///
/// `pointer` is null or valid for reads for `'a`.
#[inline]
pub(crate) unsafe fn get<'a, T>(pointer: *const T, what: &'static str) -> Result<&'a T, Failure> {
    check(pointer, what)?;
    // SAFETY: not null and aligned as just proven, else as promised above.
    Ok(unsafe { &*pointer })
}

/// As [`get`], for a handle that the call changes.
///
/// # Safety
///
/// `pointer` is null or valid for reads and writes for `'a`, and nobody else uses it meanwhile.
#[inline]
pub(crate) unsafe fn get_mut<'a, T>(
    pointer: *mut T,
    what: &'static str,
) -> Result<&'a mut T, Failure> {
    check(pointer, what)?;
    // SAFETY: not null and aligned as just proven, else as promised above.
    Ok(unsafe { &mut *pointer })
}

#[inline]
fn check<T>(pointer: *const T, what: &'static str) -> Result<(), Failure> {
    if pointer.is_null() {
        return Err(Failure::null(what));
    }
    if !pointer.is_aligned() {
        return Err(Failure::misaligned(what));
    }
    Ok(())
}

/// The caller's entries.
///
/// # Safety
///
/// `first` is null or valid for reads of `count` entries for `'a`.
#[inline]
pub(crate) unsafe fn entries<'a, T>(
    first: *const T,
    count: usize,
    what: &'static str,
) -> Result<&'a [T], Failure> {
    if count == 0 {
        return Ok(&[]);
    }
    check(first, what)?;
    check_size::<T>(count)?;
    // SAFETY: not null, aligned and of a possible size as just proven, else as promised above.
    Ok(unsafe { std::slice::from_raw_parts(first, count) })
}

/// Errors: more entries than memory has bytes.
#[inline]
fn check_size<T>(count: usize) -> Result<(), Failure> {
    match count.checked_mul(size_of::<T>()) {
        Some(bytes) if bytes <= isize::MAX as usize => Ok(()),
        _ => Err(Failure::too_many(count)),
    }
}

/// Writes an answer.
///
/// # Safety
///
/// `out` is null or valid for writes.
#[inline(always)]
pub(crate) unsafe fn put<T>(out: *mut T, value: T) -> Outcome {
    check(out, "the answer")?;
    // SAFETY: as just proven and promised above.
    unsafe { out.write(value) };
    Ok(mapd_code::OK)
}

/// Writes an answer if there is one.
///
/// # Safety
///
/// As [`put`].
#[inline(always)]
pub(crate) unsafe fn put_some<T>(out: *mut T, value: Option<T>) -> Outcome {
    check(out, "the answer")?;
    let Some(value) = value else { return Ok(mapd_code::NONE) };
    // SAFETY: as promised above.
    unsafe { put(out, value) }
}

/// Writes what a query came to, if it came to something: from where the query left it, without a copy in between.
///
/// # Safety
///
/// As [`put`].
#[inline(always)]
pub(crate) unsafe fn put_found<A: Copy, T: From<A>, E: Into<Failure>>(
    out: *mut T,
    found: Result<Option<A>, E>,
) -> Outcome {
    match found {
        // SAFETY: as promised above.
        Ok(Some(ref found)) => unsafe { put_from(out, found) },
        Ok(None) => check(out, "the answer").map(|()| mapd_code::NONE),
        Err(error) => Err(error.into()),
    }
}

/// Writes what a query came to; as [`put_found`].
///
/// # Safety
///
/// As [`put`].
#[inline(always)]
pub(crate) unsafe fn put_answer<A: Copy, T: From<A>, E: Into<Failure>>(
    out: *mut T,
    found: Result<A, E>,
) -> Outcome {
    match found {
        // SAFETY: as promised above.
        Ok(ref found) => unsafe { put_from(out, found) },
        Err(error) => Err(error.into()),
    }
}

/// As [`put`], converted on the way. The value is read after the check: the compiler would otherwise copy it to the stack first.
///
/// # Safety
///
/// As [`put`].
#[inline(always)]
unsafe fn put_from<A: Copy, T: From<A>>(out: *mut T, value: &A) -> Outcome {
    check(out, "the answer")?;
    // SAFETY: as just proven and promised above.
    unsafe { out.write(T::from(*value)) };
    Ok(mapd_code::OK)
}

/// Writes if there is where to; null is fine.
///
/// # Safety
///
/// As [`put`].
pub(crate) unsafe fn put_raw<T>(out: *mut T, value: T) -> Result<(), Failure> {
    if !out.is_null() {
        check(out, "the answer")?;
        // SAFETY: as just proven and promised above.
        unsafe { out.write(value) };
    }
    Ok(())
}

/// Makes a handle.
///
/// # Safety
///
/// As [`put`].
pub(crate) unsafe fn hand_out<T>(out: *mut *mut T, handle: T) -> Outcome {
    check(out, "the handle")?;
    // SAFETY: as just proven and promised above.
    unsafe { out.write(Box::into_raw(Box::new(handle))) };
    Ok(mapd_code::OK)
}

/// Ends a handle and sets it to null; one that is null already is fine.
///
/// # Safety
///
/// `handle` is null or valid for reads and writes, and holds null or what [`hand_out`] wrote.
pub(crate) unsafe fn close<T>(handle: *mut *mut T) {
    // SAFETY: as promised above.
    let Some(handle) = (unsafe { handle.as_mut() }) else { return };
    let own = std::mem::replace(handle, std::ptr::null_mut());
    if !own.is_null() {
        // SAFETY: `hand_out` made it, and nobody else has it, for the caller's own pointer is null now. A panic while dropping would
        // be a bug in another crate; it ends here.
        let _ = catch_unwind(AssertUnwindSafe(|| drop(unsafe { Box::from_raw(own) })));
    }
}

/// A caller's buffer for a list.
pub(crate) struct List<T> {
    pub(crate) out: *mut T,
    pub(crate) capacity: usize,
    pub(crate) count: *mut usize,
}

impl<T> List<T> {
    /// Writes as many entries as there is room for, and how many there are.
    ///
    /// # Safety
    ///
    /// `out` is null or valid for writes of `capacity` entries, `count` null or valid for writes.
    #[inline]
    pub(crate) unsafe fn write(self, all: impl Iterator<Item = T>) -> Outcome {
        check(self.count, "the count")?;
        if self.capacity > 0 {
            check(self.out, "the list")?;
            check_size::<T>(self.capacity)?;
        }
        let mut count = 0;
        for one in all {
            if count < self.capacity {
                // SAFETY: inside the buffer, which is as long as promised above.
                unsafe { self.out.add(count).write(one) };
            }
            count += 1;
        }
        // SAFETY: as just proven and promised above.
        unsafe { self.count.write(count) };
        Ok(if count > self.capacity { mapd_code::TOO_SMALL } else { mapd_code::OK })
    }

    /// As [`List::write`], of entries whose number is known: none is looked at that there is no room for. The first error ends it.
    ///
    /// # Safety
    ///
    /// As [`List::write`].
    pub(crate) unsafe fn write_counted<E: Into<Failure>>(
        self,
        all: impl ExactSizeIterator<Item = Result<T, E>>,
    ) -> Outcome {
        let (capacity, count, there_are) = (self.capacity, self.count, all.len());
        let mut failed = None;
        let fitting = all.take(capacity).map_while(|one| one.map_err(|e| failed = Some(e)).ok());
        // SAFETY: as promised above.
        let code = unsafe { self.write(fitting) }?;
        if let Some(error) = failed {
            return Err(error.into());
        }
        // SAFETY: written to before, thus valid.
        unsafe { count.write(there_are) };
        Ok(if there_are > capacity { mapd_code::TOO_SMALL } else { code })
    }
}

/// Writes an answer for each of the caller's questions; those before one that has none stay written, and the error has its number.
///
/// # Safety
///
/// `out` is null or valid for writes of as many entries as there are questions.
#[inline]
pub(crate) unsafe fn fill<Q, A, E: Into<Failure>>(
    out: *mut A,
    questions: &[Q],
    mut ask: impl FnMut(&Q) -> Result<A, E>,
) -> Outcome {
    if !questions.is_empty() {
        check(out, "the answers")?;
        check_size::<A>(questions.len())?;
    }
    for (i, question) in questions.iter().enumerate() {
        let found = ask(question).map_err(|error| error.into().of_entry(i))?;
        // SAFETY: within the entries that are promised above.
        unsafe { out.add(i).write(found) };
    }
    Ok(mapd_code::OK)
}

/// A number that has to be finite.
#[inline]
pub(crate) fn finite(number: f64) -> Result<f64, Failure> {
    if number.is_finite() { Ok(number) } else { Err(mapd_client::QueryError::NotFinite.into()) }
}
