//! What the reader's findings mean for the parts that they stand in, and which of the compiler's they stand for.

use crate::quarantine::{PartKind, Unit};
use mapd_rules::catalog::COMPUTABLE;
use mapd_xodr::{CountedFinding, Finding, Severity, Span, rule_ids};

/// Whether a part is small enough to be left out where one of its values cannot be read.
pub(crate) fn is_small(unit: Unit) -> bool {
    matches!(unit.kind, PartKind::Object | PartKind::Signal)
}

/// An empty place of an object or signal is an error, as if it were missing.
pub(crate) fn raise(finding: &mut Finding, is_small: bool) {
    if is_small && finding.rule == rule_ids::EMPTY && is_place(finding) {
        finding.severity = Severity::Error;
    }
}

/// A finding that is only counted, as one: what the value is, is not known any more.
pub(crate) fn without_message(counted: CountedFinding) -> Finding {
    let CountedFinding { rule, severity, tag: _, top, subject, start } = counted;
    let message = match rule {
        rule_ids::MISSING => format!("expected @{subject}, found none"),
        rule_ids::EMPTY => format!("expected a value in @{subject}, found none"),
        rule_ids::VALUE | rule_ids::FINITE | rule_ids::RANGE | rule_ids::ENUMERATION => {
            format!("expected a value in @{subject}, found what is none")
        }
        _ => format!("expected {subject} as the standard has it, found it otherwise"),
    };
    let (span, subject) = (Span { start, len: 0 }, (*subject).into());
    let (path, hint) = (format!("OpenDRIVE/{top}"), String::new());
    Finding { rule, severity, span, path, subject, message, hint, count: 0 }
}

/// Does something to each of the compiler's findings, which are in file order, that a finding of the reader's is about; with its number.
pub(crate) fn for_each_about(
    read: &Finding,
    unusable: &mut [Finding],
    mut each: impl FnMut(usize, &mut Finding),
) {
    // Start tags do not overlap: it can only be about the one that begins last before it.
    let after = unusable.partition_point(|one| one.span.start <= read.span.start);
    let tag = after.checked_sub(1).and_then(|last| unusable.get(last)).map(|one| one.span);
    let first = unusable.partition_point(|one| Some(one.span.start) < tag.map(|t| t.start));
    for (at, one) in unusable.iter_mut().enumerate().take(after).skip(first) {
        if is_about(read, one) {
            each(at, one);
        }
    }
}

/// Elements of an object that neither place nor shape it: a value in one of them hinders nothing else.
const BESIDE_THE_SHAPE: [&str; 6] =
    ["marking", "cornerReference", "border", "material", "parkingSpace", "CRG"];
/// Without its place a repetition is none: the object stands alone, where its own place is.
const REPEAT: &str = "repeat";
/// Attributes that name what is there all the same.
const NAMES: [&str; 2] = ["id", "outlineId"];

/// Name of the innermost element of a path.
pub(crate) fn innermost(path: &str) -> &str {
    path.rsplit('/').next().and_then(|element| element.split('[').next()).unwrap_or_default()
}

/// Whether an object or signal cannot be used for what it says: a value of such an element that places or shapes it, or that it shows, cannot be
/// read, or it has no place.
pub(crate) fn is_unreadable(element: &str, read: &Finding) -> bool {
    match read.rule {
        rule_ids::VALUE | rule_ids::FINITE => {
            !BESIDE_THE_SHAPE.contains(&element) && !NAMES.contains(&&*read.subject)
        }
        rule_ids::MISSING | rule_ids::EMPTY => element != REPEAT && is_place(read),
        _ => false,
    }
}

/// Whether a finding is about a place along a road.
fn is_place(read: &Finding) -> bool {
    matches!(&*read.subject, "s" | "t")
}

/// Whether a finding of the reader's is about a value that the compiler has a finding about.
fn is_about(read: &Finding, unusable: &Finding) -> bool {
    let tag = unusable.span.start..unusable.span.start + u64::from(unusable.span.len);
    tag.contains(&{ read.span.start }) && read.subject == unusable.subject
}

/// Whether a rule says of a geometry, as an error, that it is no curve.
pub(crate) fn is_of_curve(found: &Finding) -> bool {
    found.rule == COMPUTABLE && found.severity == Severity::Error
}
