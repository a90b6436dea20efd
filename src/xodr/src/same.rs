//! Whether short texts are the same, without a call: names of elements and attributes are asked for by the million.

/// Whether two texts are the same.
#[inline]
pub(crate) fn same(a: &[u8], b: &[u8]) -> bool {
    if a.len() != b.len() {
        return false;
    }
    // The first and the last so many bytes, which overlap where there are fewer.
    match a.len() {
        8..=16 => ends::<8>(a) == ends::<8>(b),
        4..=7 => ends::<4>(a) == ends::<4>(b),
        0..=3 => a.iter().zip(b).all(|(a, b)| a == b),
        _ => a == b,
    }
}

#[inline]
fn ends<const N: usize>(text: &[u8]) -> (Option<&[u8; N]>, Option<&[u8; N]>) {
    (text.first_chunk(), text.last_chunk())
}

/// A name without its prefix, which most documents do not have.
#[inline]
pub(crate) fn without_prefix<'t>(name: &'t [u8], prefix: &[u8]) -> Option<&'t [u8]> {
    if prefix.is_empty() { Some(name) } else { name.strip_prefix(prefix) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_the_same_if_all_bytes_are() {
        let text: Vec<u8> = (b'a'..).take(24).collect();
        let copy = text.clone();
        for length in 0..=text.len() {
            let one = &text[..length];
            assert!(same(one, &copy[..length]), "{length}");
            for changed in 0..length {
                let mut other = one.to_vec();
                other[changed] ^= 1;
                assert!(!same(one, &other), "{length}, {changed}");
            }
            assert_eq!(same(one, &text), length == text.len());
        }
    }

    #[test]
    fn a_prefix_is_taken_off() {
        assert_eq!(without_prefix(b"road", b""), Some(&b"road"[..]));
        assert_eq!(without_prefix(b"o:road", b"o:"), Some(&b"road"[..]));
        assert_eq!(without_prefix(b"road", b"o:"), None);
    }
}
