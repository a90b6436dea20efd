//! Round after round, until nothing more has to be left out.

use super::Round;
use crate::findings::finding;
use crate::options::{CompileOptions, ReadOptions};
use crate::quarantine::{Exclusions, OnError, Treatment};
use crate::report::{Compilation, Counts, Diagnostic, Progress, Verdict};
use mapd_archive::Rows;
use mapd_rules::catalog::building;
use mapd_xodr::{Severity, Span};
use std::collections::BTreeSet;
use std::io::{self, Read};

/// Rounds at most. Each leaves out all that it finds; a chain of parts of which each shows only without the one before it is
/// longer in no known map than two.
const ROUNDS: usize = 16;

/// Reads a document as often as the policy needs.
///
/// Errors: reading failed, or the document changed in between.
pub(crate) fn read<R: Read + Send>(
    open: &mut dyn FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<(Option<Rows>, Compilation)> {
    let mut round = super::round(open()?, reading, &Exclusions::default(), options, progress)?;
    let mut without = Exclusions::with_errors(errors(&round.compilation));
    let mut told = RoundOutcome::new(&round.compilation);
    for _ in 1..ROUNDS {
        if round.compilation.verdict != Verdict::Rejected {
            break;
        }
        if reading.policy.on_error == OnError::Reject
            || !leave_out(&mut round, reading, &mut without)
        {
            break;
        }
        let next = super::round(open()?, reading, &without, options, progress)?;
        if next.compilation.provenance.input_hash != round.compilation.provenance.input_hash {
            return Err(io::Error::other("the document changed while it was read"));
        }
        round = next;
        told.add(&round.compilation);
    }
    let mut compilation = round.compilation;
    told.finish(&mut compilation);
    judge(&mut compilation, round.roads, round.length, reading);
    Ok((round.rows, compilation))
}

/// Errors by place and rule; none where there are more than are kept.
fn errors(whole: &Compilation) -> Option<BTreeSet<(u64, &'static str)>> {
    let errors = whole.diagnostics.iter().filter(|d| d.rejects);
    (!whole.lacks_errors).then(|| errors.map(|d| (d.finding.span.start, d.finding.rule)).collect())
}

/// Leaves out every part that has an error: first those with which nothing can be built, so that building finds what it does in the others; then those
/// that could be built. False where something has one that is no part.
fn leave_out(round: &mut Round, reading: &ReadOptions, without: &mut Exclusions) -> bool {
    let keep = reading.policy.on_error == OnError::ReferenceLine;
    // Two errors in one part are one reason.
    let mut seen = BTreeSet::new();
    let stops = round.causes.iter().any(|cause| cause.stops);
    round.causes.iter().filter(|cause| cause.stops == stops).all(|cause| {
        let Some(unit) = round.units.of(cause.start).filter(|_| cause.can_be_left_out()) else {
            return false;
        };
        if !seen.insert(unit.start) {
            return true;
        }
        // What cannot be mended by leaving out the part may be by leaving out what it is in.
        let mut parts = vec![unit];
        while let Some(around) = parts.last().and_then(|unit| round.units.around(*unit)) {
            parts.push(around);
        }
        let top = parts.last().map_or(unit.start, |top| top.start);
        parts.into_iter().any(|part| without.add(part, top, cause.clone(), keep))
    })
}

/// Findings of all rounds.
struct RoundOutcome {
    diagnostics: Vec<Diagnostic>,
    counts: Counts,
    seen: BTreeSet<(u64, &'static str)>,
}

impl RoundOutcome {
    fn new(first: &Compilation) -> Self {
        let seen =
            first.diagnostics.iter().map(|d| (d.finding.span.start, d.finding.rule)).collect();
        Self { diagnostics: first.diagnostics.clone(), counts: first.counts.clone(), seen }
    }

    /// Adds what only shows without the parts left out, and takes something out itself, and signals without lanes: lanes are
    /// only looked at where nothing more is wrong. That links lead to what is left out is no matter of the document's.
    fn add(&mut self, later: &Compilation) {
        let counts = |d: &&Diagnostic| d.rejects || d.finding.rule == building::SIGNAL_LANES.id;
        for d in later.diagnostics.iter().filter(counts) {
            if self.seen.insert((d.finding.span.start, d.finding.rule)) {
                self.counts.add(&d.finding);
                self.diagnostics.push(d.clone());
            }
        }
    }

    fn finish(mut self, compilation: &mut Compilation) {
        self.diagnostics.sort_by_key(|d| d.finding.span.start);
        compilation.diagnostics = self.diagnostics;
        compilation.counts = self.counts;
        compilation.dropped = compilation.counts.beyond(&compilation.diagnostics);
    }
}

/// What becomes of a map of which some parts may be left out; it has so many roads of a length `[m]`.
fn judge(compilation: &mut Compilation, roads: usize, length: f64, reading: &ReadOptions) {
    if compilation.verdict == Verdict::Rejected {
        compilation.quarantined.clear();
        return;
    }
    if compilation.quarantined.is_empty() {
        return;
    }
    compilation.verdict = Verdict::Quarantined;
    let of = |treatment: Treatment| -> f64 {
        let parts = compilation.quarantined.iter().filter(|part| part.treatment == treatment);
        parts.map(|part| part.length).filter(|length| length.is_finite()).sum()
    };
    let (dropped, bare) = (of(Treatment::Dropped), of(Treatment::ReferenceLine));
    // Of a map that is left without roads, the findings say why.
    if roads == 0 {
        compilation.verdict = Verdict::Rejected;
        compilation.quarantined.clear();
        return;
    }
    let parts = compilation.quarantined.len();
    if let Some(message) = reading.policy.exceeded(parts, dropped, bare, length) {
        let finding = finding(
            &building::QUARANTINE,
            Severity::Error,
            Span::default(),
            "OpenDRIVE".to_owned(),
            message,
            "",
        );
        compilation.reject(finding);
    }
}
