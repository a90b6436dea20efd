//! Bringing what will be read from memory into the processor's caches, without waiting for it.
#![allow(unsafe_code)]

/// Bytes that a processor brings at once.
const LINE: usize = 64;

/// Brings a value into the processor's caches while the program goes on: what is read of it later is waited for less. It changes the cost of
/// reads alone, and does nothing on processors other than x86-64 and AArch64.
///
/// A read of the value would do the same, but a processor that waits for one soon runs out of room for what comes after.
#[inline(always)]
pub fn prefetch<T: ?Sized>(value: &T) {
    let first = std::ptr::from_ref(value).cast::<u8>();
    let size = size_of_val(value);
    let mut line = 0;
    while line < size {
        prefetch_line(first.wrapping_add(line));
        line += LINE;
    }
    // It may begin within a line and then ends in one more.
    prefetch_line(first.wrapping_add(size.saturating_sub(1)));
}

#[inline(always)]
fn prefetch_line(address: *const u8) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: every x86-64 has the instruction. It changes no memory that the program sees, and nothing happens where an address is not mapped.
    unsafe {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        _mm_prefetch::<_MM_HINT_T0>(address.cast());
    }
    #[cfg(target_arch = "aarch64")]
    // SAFETY: as above, on every AArch64; it changes no register and no flag.
    unsafe {
        std::arch::asm!(
            "prfm pldl1keep, [{}]",
            in(reg) address,
            options(nostack, preserves_flags, readonly)
        );
    }
    #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
    let _ = address;
}
