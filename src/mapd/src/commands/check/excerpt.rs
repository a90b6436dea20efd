//! The lines of a file that findings stand in.

use crate::printable::printable;
use mapd_compiler::Diagnostic;
use mapd_xodr::source::{Inputs, Places, SourceLimits};
use std::io::BufRead as _;
use std::path::Path;

/// Bytes of a line that are shown before and after a place.
const SHOWN: u64 = 80;

/// A part of a line.
pub(super) struct Excerpt {
    /// The text, with `…` where the line goes on.
    pub(super) text: String,
    /// Characters before the place.
    pub(super) before: usize,
}

/// Bytes around a place, while they are collected.
struct Around {
    /// Rank of the diagnostic.
    rank: usize,
    /// Offset of the place, of the first byte wanted and behind the last one.
    place: u64,
    begin: u64,
    end: u64,
    /// Whether the line begins before `begin`.
    cut: bool,
    bytes: Vec<u8>,
}

/// An excerpt for each diagnostic; none where its file cannot be read again.
pub(super) fn excerpts(main: &Path, diagnostics: &[Diagnostic]) -> Vec<Option<Excerpt>> {
    let mut out: Vec<Option<Excerpt>> = diagnostics.iter().map(|_| None).collect();
    let mut files: Vec<&str> = diagnostics.iter().map(|d| &*d.file).collect();
    files.sort_unstable();
    files.dedup();
    for file in files {
        let mut wanted: Vec<Around> = diagnostics
            .iter()
            .enumerate()
            .filter(|(_, d)| *d.file == *file && d.column > 0)
            .map(|(rank, d)| around(rank, d))
            .collect();
        wanted.sort_by_key(|around| around.begin);
        let path = if file.is_empty() { main } else { Path::new(file) };
        collect(path, &mut wanted);
        for around in wanted {
            if let Some(place) = out.get_mut(around.rank) {
                *place = finish(&around);
            }
        }
    }
    out
}

fn around(rank: usize, diagnostic: &Diagnostic) -> Around {
    let place = Places::offset_of(diagnostic.finding.span.start);
    let line = place.saturating_sub(u64::from(diagnostic.column - 1));
    let begin = line.max(place.saturating_sub(SHOWN));
    Around { rank, place, begin, end: place + SHOWN, cut: begin > line, bytes: Vec::new() }
}

/// Reads the file up to the last place. What fails was told when it was checked.
fn collect(path: &Path, wanted: &mut [Around]) {
    // A pipe is not read twice, and may have no end.
    if !path.metadata().is_ok_and(|found| found.is_file()) {
        return;
    }
    // The limits held when the file was checked.
    let limits =
        SourceLimits { decoded_bytes: u64::MAX, gzip_ratio: u64::MAX, ..SourceLimits::default() };
    let Ok(mut source) = Inputs::new(limits).open_file(path) else { return };
    let mut first = 0;
    while first < wanted.len() {
        let Ok(chunk) = source.fill_buf() else { return };
        let count = chunk.len();
        if count == 0 {
            return;
        }
        // The chunk has been handed out, so that the offset is that of its first byte.
        let chunk = chunk.to_vec();
        let base = source.offset();
        let chunk_end = base + count as u64;
        for around in wanted.iter_mut().skip(first).take_while(|a| a.begin < chunk_end) {
            let from = around.begin.max(base) - base;
            let to = around.end.min(chunk_end).saturating_sub(base);
            let part = usize::try_from(from).ok().zip(usize::try_from(to).ok());
            around.bytes.extend_from_slice(
                part.and_then(|(from, to)| chunk.get(from..to)).unwrap_or_default(),
            );
        }
        while wanted.get(first).is_some_and(|around| around.end <= chunk_end) {
            first += 1;
        }
        source.consume(count);
    }
}

fn finish(around: &Around) -> Option<Excerpt> {
    let at = usize::try_from(around.place - around.begin).ok()?;
    let (before, after) = around.bytes.split_at_checked(at)?;
    let end = after.iter().position(|byte| *byte == b'\n');
    let more = end.is_none() && around.bytes.len() as u64 == around.end - around.begin;
    let after = after.get(..end.unwrap_or(after.len()))?;
    // Characters may be cut at both ends.
    let after = after.strip_suffix(b"\r").unwrap_or(after);
    let [before, after] =
        [before, after].map(|bytes| printable(&String::from_utf8_lossy(bytes)).into_owned());
    let before = before.trim_start_matches('\u{fffd}');
    let after = after.trim_end_matches('\u{fffd}');
    let (head, tail) = (if around.cut { "…" } else { "" }, if more { "…" } else { "" });
    let before = format!("{head}{before}");
    Some(Excerpt { before: before.chars().count(), text: format!("{before}{after}{tail}") })
}
