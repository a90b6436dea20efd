//! `Table<T>`: a list of plain numbers whose validation takes the same time whatever its length.
//!
//! rkyv's own vector checks each element; for elements that are numbers only every bit pattern is valid, so that bounds
//! and alignment are all there is to check. Measured on 512 MB: 2 ns instead of 50 ms for elements with one `bool`.
#![allow(unsafe_code)]

use crate::error::OpenError;
use bytemuck::{AnyBitPattern, Pod, Zeroable};
use rkyv::bytecheck::{CheckBytes, Verify};
use rkyv::primitive::ArchivedUsize;
use rkyv::rancor::{Fallible, Source};
use rkyv::ser::{Writer, WriterExt};
use rkyv::validation::{ArchiveContext, ArchiveContextExt};
use rkyv::{Archive, Place, Portable, RelPtr, Serialize};
use std::ops::{Deref, DerefMut};

/// A list of plain numbers, as the compiler fills it.
#[derive(Clone, Debug)]
pub struct Table<T>(Vec<T>);

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> From<Vec<T>> for Table<T> {
    fn from(rows: Vec<T>) -> Self {
        Self(rows)
    }
}

impl<T> Deref for Table<T> {
    type Target = Vec<T>;
    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T> DerefMut for Table<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}

/// Rows `first .. first + count` of another table.
#[derive(Archive, Pod, Zeroable, Clone, Copy, Debug, Default, PartialEq, Eq)]
#[rkyv(derive(Pod, Zeroable, Clone, Copy))]
#[repr(C)]
pub struct Range {
    /// First row.
    pub first: u32,
    /// Number of rows.
    pub count: u32,
}

impl Range {
    /// The rows between two lengths of a growing table.
    ///
    /// Errors: `None` if a row number does not fit 32 bits or the table has shrunk.
    pub fn between(before: usize, after: usize) -> Option<Self> {
        let count = u32::try_from(after.checked_sub(before)?).ok()?;
        u32::try_from(after).ok()?;
        Some(Self { first: u32::try_from(before).ok()?, count })
    }

    /// The rows of a table that this range names; empty if it reaches outside (a corrupt archive).
    #[inline]
    pub fn of<T>(self, table: &[T]) -> &[T] {
        let first = self.first as usize;
        table.get(first..first.saturating_add(self.count as usize)).unwrap_or(&[])
    }

    /// The row numbers that this range names; none if it reaches outside a table of so many rows (a corrupt archive).
    #[inline]
    pub fn rows(self, table: usize) -> std::ops::Range<u32> {
        if self.end() <= table as u64 {
            self.first..self.first.saturating_add(self.count)
        } else {
            0..0
        }
    }

    /// One past the last row.
    pub fn end(self) -> u64 {
        u64::from(self.first) + u64::from(self.count)
    }
}

impl ArchivedRange {
    /// The range in the machine's own numbers.
    #[inline]
    pub fn to_native(&self) -> Range {
        Range { first: self.first.to_native(), count: self.count.to_native() }
    }
}

/// A table as it lies in an archive: a relative pointer and a length.
#[derive(Portable, CheckBytes)]
#[bytecheck(crate = rkyv::bytecheck, verify)]
#[repr(C)]
pub struct ArchivedTable<T: AnyBitPattern> {
    #[bytecheck(omit_bounds)]
    pointer: RelPtr<T>,
    length: ArchivedUsize,
}

// SAFETY: the derived part of `CheckBytes` has checked pointer and length as numbers. What remains to be proven is that
// `length` elements at the pointer lie inside the archive's subtree and are aligned; `in_subtree` checks just that. The
// elements themselves need no check because every bit pattern is a valid `T` (`AnyBitPattern`).
unsafe impl<T, C> Verify<C> for ArchivedTable<T>
where
    T: AnyBitPattern + Portable,
    C: Fallible + ArchiveContext + ?Sized,
    C::Error: Source,
{
    fn verify(&self, context: &mut C) -> Result<(), C::Error> {
        let elements = core::ptr::slice_from_raw_parts(
            self.pointer.as_ptr_wrapping(),
            self.length.to_native() as usize,
        );
        context.in_subtree::<[T], ()>(elements, |_| Ok(()))
    }
}

impl<T: AnyBitPattern> ArchivedTable<T> {
    /// The elements, with place and length read exactly once and checked against the body, so that bytes which change
    /// after `rkyv::access` cannot lead outside.
    pub(crate) fn view<'a>(
        &self,
        body: &'a [u8],
        name: &'static str,
    ) -> Result<&'a [T], OpenError> {
        self.view_numbers(body, name)
    }

    /// As `view`, in the machine's own numbers (little-endian machines only; elsewhere this crate does not build).
    pub(crate) fn view_numbers<'a, N: AnyBitPattern>(
        &self,
        body: &'a [u8],
        name: &'static str,
    ) -> Result<&'a [N], OpenError> {
        let length = self.length.to_native() as usize;
        let place = (self.pointer.as_ptr_wrapping() as usize).wrapping_sub(body.as_ptr() as usize);
        let bad = OpenError::Table { table: name, length: length as u64 };
        let Some(end) = length.checked_mul(size_of::<N>()).and_then(|size| place.checked_add(size))
        else {
            return Err(bad);
        };
        let bytes = body.get(place..end).ok_or(bad)?;
        bytemuck::try_cast_slice(bytes)
            .map_err(|_| OpenError::Table { table: name, length: length as u64 })
    }
}

/// Where a table's first element was written.
pub struct TableResolver {
    position: usize,
}

impl<T> Archive for Table<T>
where
    T: Archive + Pod,
    T::Archived: AnyBitPattern + Portable,
{
    type Archived = ArchivedTable<T::Archived>;
    type Resolver = TableResolver;

    fn resolve(&self, resolver: Self::Resolver, out: Place<Self::Archived>) {
        rkyv::munge::munge!(let ArchivedTable { pointer, length } = out);
        RelPtr::emplace(resolver.position, pointer);
        self.0.len().resolve((), length);
    }
}

impl<T, S> Serialize<S> for Table<T>
where
    T: Archive + Pod,
    T::Archived: AnyBitPattern + Portable,
    S: Fallible + Writer + ?Sized,
{
    fn serialize(&self, serializer: &mut S) -> Result<TableResolver, S::Error> {
        const { assert!(size_of::<T>() == size_of::<T::Archived>()) };
        let position = serializer.align_for::<T::Archived>()?;
        // Rows have no padding (`Pod`) and the machine is little-endian: their bytes are the archived bytes.
        serializer.write(bytemuck::cast_slice(&self.0))?;
        Ok(TableResolver { position })
    }
}

/// What a table is called and how much it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableInfo {
    /// Its name in the layout manifest.
    pub name: &'static str,
    /// Number of elements.
    pub count: usize,
    /// Bytes of one element.
    pub element_bytes: usize,
    /// Address of the first element in this process.
    pub address: usize,
}

impl TableInfo {
    pub(crate) fn of<T>(name: &'static str, elements: &[T]) -> Self {
        Self {
            name,
            count: elements.len(),
            element_bytes: size_of::<T>(),
            address: elements.as_ptr() as usize,
        }
    }
}
