//! Compiles any bytes as a document: what is accepted is an archive that proves, and everything can be asked of it.
//!
//! The first byte chooses: the rest as a document of its own, or as a list of replacements (place, value) in a good one, in which
//! values of attributes become extreme ones.
#![no_main]

use libfuzzer_sys::fuzz_target;
use mapd_archive::{encode, verify};
use mapd_compiler::{CompileOptions, ReadOptions, compile_from};
use mapd_tests::carried;
use mapd_tests::damage::ask_everything;
use std::sync::OnceLock;

/// Replacements of one input.
const REPLACEMENTS: usize = 8;

/// Values that arithmetic may leave its type with, and some that parts do without.
const VALUES: [&str; 16] = [
    "-2147483648",
    "2147483647",
    "65535",
    "-65535",
    "4294967295",
    "-1e308",
    "1e308",
    "-1e9",
    "1e9",
    "1e-308",
    "0",
    "-1",
    "1",
    "0.5",
    "true",
    "",
];

/// A good document, and where the values of its attributes lie.
fn good() -> &'static (String, Vec<std::ops::Range<usize>>) {
    static GOOD: OnceLock<(String, Vec<std::ops::Range<usize>>)> = OnceLock::new();
    GOOD.get_or_init(|| {
        let text = std::fs::read_to_string(carried("one_road.xodr")).expect("the map can be read");
        let (mut values, mut at) = (Vec::new(), 0);
        while let Some(start) = text[at..].find("=\"").map(|found| at + found + 2) {
            let end = start + text[start..].find('"').expect("values end");
            values.push(start..end);
            at = end + 1;
        }
        (text, values)
    })
}

/// The good document with these replacements.
fn replaced(list: &[u8]) -> String {
    let (text, values) = good();
    let mut places: Vec<_> = list
        .chunks_exact(2)
        .take(REPLACEMENTS)
        .filter_map(|pair| {
            let value = VALUES[usize::from(pair[1]) % VALUES.len()];
            Some((values.get(usize::from(pair[0]) % values.len())?.clone(), value))
        })
        .collect();
    // From the end, so that places stay; of two at one place the first.
    places.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    places.dedup_by_key(|(range, _)| range.start);
    let mut text = text.clone();
    for (range, value) in places {
        text.replace_range(range, value);
    }
    text
}

fuzz_target!(|data: &[u8]| {
    let Some((choice, rest)) = data.split_first() else { return };
    let text = if choice & 1 == 0 { rest.to_vec() } else { replaced(rest).into_bytes() };
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    let open = || Ok(text.as_slice());
    let compiled = compile_from(open, &ReadOptions::default(), &options, &mut |_| {});
    let compiled = compiled.expect("memory does not fail");
    let Some(rows) = &compiled.rows else { return };
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    verify(&bytes).expect("what is accepted proves");
    ask_everything(bytes);
});
