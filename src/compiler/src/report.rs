//! What a compilation yields besides rows.

use crate::findings::reading::{
    for_each_about, innermost, is_about_curve, is_small, is_unreadable, raise, without_message,
};
use crate::quarantine::{Cause, Exclusions, QuarantinedPart, Unit, Units, is_outside};
use mapd_archive::{Provenance, Rows};
use mapd_rules::Settings;
use mapd_rules::catalog::building;
use mapd_xodr::source::Places;
use mapd_xodr::{CountedFindings, Finding, Item, Severity, rule_ids};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

/// The verdict on a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There is an archive of all of the map. The file may still violate the standard, as its findings say.
    Accepted,
    /// There is an archive without some parts, which it lists.
    Quarantined,
    /// Something that the map is built from is missing or unusable; there is no archive.
    Rejected,
}

/// How far a compilation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Reading and lowering.
    Reading {
        /// Bytes of input read.
        bytes: u64,
        /// Roads so far.
        roads: usize,
    },
    /// Resolving links.
    Linking {
        /// Roads in all.
        roads: usize,
    },
    /// Sampling lanes.
    Sampling {
        /// Lanes in all.
        lanes: usize,
    },
    /// Completing the lane graph: lengths, components, conflicts, landmarks, and what is wrong with it.
    Graph {
        /// Nodes in all.
        nodes: usize,
    },
    /// Building the index.
    Indexing {
        /// Bytes of the points of all lines.
        bytes: usize,
    },
}

/// A finding with its place in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// The finding.
    pub finding: Finding,
    /// Whether the map is rejected, or some part of it left out, because of it.
    pub rejects: bool,
    /// Name of the included file that it stands in; empty for the document itself.
    pub file: Arc<str>,
    /// Line, from 1.
    pub line: u32,
    /// Column in bytes, from 1.
    pub column: u32,
}

/// Revisions of the standard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Version {
    /// What the document states, such as `1.7`; empty where it states none.
    pub stated: String,
    /// What it was checked against.
    pub checked: &'static str,
}

/// Everything a compilation yields.
pub struct Compilation {
    /// The tables; `None` for a rejected map.
    pub rows: Option<Rows>,
    /// Where they come from.
    pub provenance: Provenance,
    /// Files that the document included, each as it can be opened, in the order in which it did.
    pub included: Vec<PathBuf>,
    /// Files that it wanted to include and that cannot be read.
    pub missing: Vec<PathBuf>,
    /// The document's revision.
    pub version: Version,
    /// Findings in file order. One of them may stand for several that were only counted.
    pub diagnostics: Vec<Diagnostic>,
    /// How many findings there are of each severity and rule, whether kept or only counted.
    pub counts: Counts,
    /// How many more there are than `diagnostics`, by severity: information, warnings, errors.
    pub dropped: [usize; 3],
    /// Whether there are more errors than are kept.
    pub(crate) lacks_errors: bool,
    /// Parts that are not in the map as the document has them, in the order of the document.
    pub quarantined: Vec<QuarantinedPart>,
    /// The verdict on the map.
    pub verdict: Verdict,
}

/// Numbers of findings by severity and rule.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts(BTreeMap<(Severity, &'static str), usize>);

impl Counts {
    /// Adds what a finding stands for.
    pub(crate) fn add(&mut self, finding: &Finding) {
        let count = finding.count as usize;
        if count > 0 {
            *self.0.entry((finding.severity, finding.rule)).or_default() += count;
        }
    }

    /// Severity, rule and number, of those that were found at all.
    pub fn iter(&self) -> impl Iterator<Item = (Severity, &'static str, usize)> + '_ {
        self.0.iter().map(|((severity, rule), count)| (*severity, *rule, *count))
    }

    /// Number of findings of a severity.
    pub fn of(&self, severity: Severity) -> usize {
        self.iter().filter(|(of, ..)| *of == severity).map(|(_, _, count)| count).sum()
    }

    /// How many more there are than those kept, by severity: information, warnings, errors.
    pub(crate) fn beyond(&self, kept: &[Diagnostic]) -> [usize; 3] {
        [Severity::Info, Severity::Warning, Severity::Error].map(|severity| {
            let kept = kept.iter().filter(|d| d.finding.severity == severity).count();
            self.of(severity).saturating_sub(kept)
        })
    }
}

impl Compilation {
    /// Adds a finding about the document as a whole because of which there is no archive.
    pub(crate) fn reject(&mut self, finding: Finding) {
        self.counts.add(&finding);
        let file = "".into();
        let told = Diagnostic { finding, rejects: true, file, line: 1, column: 1 };
        self.diagnostics.insert(0, told);
        self.verdict = Verdict::Rejected;
    }
}

/// Findings of one severity that are kept; a file with an error in every line must not fill the memory.
const KEPT: usize = 10_000;

/// Collects findings and places them.
#[derive(Default)]
pub(crate) struct Collector {
    diagnostics: Vec<Diagnostic>,
    counts: Counts,
    /// Entries so far by severity, kept or not.
    told: [usize; 3],
    lacks_errors: bool,
    rejecting: usize,
    causes: Vec<Cause>,
    units: Units,
    /// How findings of reading and building are graded.
    pub(crate) settings: Settings,
    /// Errors of the whole document, where parts of it are left out: others come of that.
    errors: Option<Arc<BTreeSet<(u64, &'static str)>>>,
}

fn rank(severity: Severity) -> usize {
    match severity {
        Severity::Info => 0,
        Severity::Warning => 1,
        Severity::Error => 2,
    }
}

impl Collector {
    pub(crate) fn new(without: &Exclusions, settings: &Settings) -> Self {
        Self { errors: without.errors(), settings: settings.clone(), ..Self::default() }
    }

    /// Findings as the configuration grades them, without those that it switches off.
    fn graded(&self, findings: Vec<Finding>) -> Vec<Finding> {
        if self.settings.grades.is_empty() {
            return findings;
        }
        findings.into_iter().filter_map(|finding| self.settings.graded(finding)).collect()
    }

    /// Whether an error is there only because something else is left out, as where a link leads to a road that is gone: the
    /// document without anything left out shows all its errors but those of the late stages.
    fn is_consequence(&self, finding: &Finding) -> bool {
        let errors = self.errors.as_ref();
        errors.is_some_and(|errors| !errors.contains(&(finding.span.start, finding.rule)))
    }

    /// Adds the reader's findings about an element, and those of checking and building it.
    ///
    /// An error of the reader's says that the file violates the standard. It rejects the map only if the document cannot be
    /// read on, or if the compiler finds the very thing unusable; then it stands for the compiler's finding. So does an error of the
    /// rule on curves. Where either is graded milder or switched off, the compiler's finding says why a part is left out.
    ///
    /// What concerns parts that are left out already is no longer looked at. An error that is only counted does the same, but is not told: the
    /// compiler's is told in its place, and does not count once more.
    pub(crate) fn add_read(
        &mut self,
        read: Vec<Finding>,
        counted: &CountedFindings,
        built: Vec<Finding>,
        places: &Places,
        without: &Exclusions,
    ) {
        let (mut unusable, built): (Vec<Finding>, Vec<Finding>) =
            built.into_iter().partition(|finding| finding.rule == building::UNUSABLE.id);
        unusable.sort_by_key(|finding| finding.span.start);
        let mut explained = vec![false; unusable.len()];
        for one in counted.iter() {
            let tag = one.tag;
            let Some((finding, is_small)) = self.about_part(without_message(one), without) else {
                continue;
            };
            for_each_about(&finding, &mut unusable, |_, unusable| unusable.count = 0);
            if finding.severity == Severity::Error && is_small && is_unreadable(tag, &finding) {
                self.count_cause(finding, places);
            }
        }
        for finding in read {
            let Some((finding, is_small)) = self.about_part(finding, without) else { continue };
            let is_error = finding.severity == Severity::Error;
            let mut rejects = is_error && !rule_ids::is_structural(finding.rule);
            rejects |= is_error && is_small && is_unreadable(innermost(&finding.path), &finding);
            for_each_about(&finding, &mut unusable, |at, _| {
                explained[at] = true;
                rejects = true;
            });
            self.push(finding, rejects, places);
        }
        for (finding, explained) in unusable.into_iter().zip(explained) {
            if !explained && !built.iter().any(|one| is_about_curve(one, &finding)) {
                self.push(finding, true, places);
            }
        }
        self.add(built, places);
    }

    /// One of the reader's findings as it is graded, and whether it is about an object or a signal; none if it is off, or about what is left out.
    fn about_part(
        &mut self,
        mut finding: Finding,
        without: &Exclusions,
    ) -> Option<(Finding, bool)> {
        let unit = self.units.of(finding.span.start).filter(|_| !is_outside(&finding));
        if !without.is_empty() && unit.is_some_and(|unit| self.is_left_out(unit, without)) {
            return None;
        }
        let is_small = unit.is_some_and(is_small);
        raise(&mut finding, is_small);
        Some((self.settings.graded(finding)?, is_small))
    }

    /// Whether a part, or one that it is in, is left out already.
    fn is_left_out(&mut self, unit: Unit, without: &Exclusions) -> bool {
        let mut part = Some(unit);
        while let Some(unit) = part {
            if without.dropped(unit.start) {
                return true;
            }
            part = self.units.around(unit);
        }
        false
    }

    /// Adds findings of which each error rejects the map.
    pub(crate) fn add(&mut self, findings: Vec<Finding>, places: &Places) {
        for finding in self.graded(findings) {
            let rejects = finding.severity == Severity::Error;
            self.push(finding, rejects, places);
        }
    }

    /// As [`Collector::add`], for stages that only a document without errors so far reaches: the lane graph and what comes
    /// after it.
    pub(crate) fn add_late(&mut self, findings: Vec<Finding>, places: &Places) {
        for finding in self.graded(findings) {
            let rejects = finding.severity == Severity::Error;
            self.keep(finding, rejects, places);
        }
    }

    fn push(&mut self, finding: Finding, rejects: bool, places: &Places) {
        let rejects = rejects && !self.is_consequence(&finding);
        self.keep(finding, rejects, places);
    }

    fn keep(&mut self, finding: Finding, rejects: bool, places: &Places) {
        self.counts.add(&finding);
        let told = &mut self.told[rank(finding.severity)];
        // Those that say why there is no archive are kept beyond the others.
        let kept = *told < KEPT || (rejects && self.rejecting < KEPT);
        *told += 1;
        self.lacks_errors |= !kept && finding.severity == Severity::Error;
        self.rejecting += usize::from(rejects);
        if kept {
            let place = places.place(finding.span.start);
            let (line, column) = (place.position.line, place.position.column);
            if rejects {
                self.causes.push(Cause::new(&finding, &place));
            }
            self.diagnostics.push(Diagnostic { finding, rejects, file: place.file, line, column });
        }
    }

    /// An error that is counted elsewhere takes out a part.
    fn count_cause(&mut self, finding: Finding, places: &Places) {
        if self.is_consequence(&finding) {
            return;
        }
        let kept = self.rejecting < KEPT;
        self.lacks_errors |= !kept;
        self.rejecting += 1;
        if kept {
            self.causes.push(Cause::new(&finding, &places.place(finding.span.start)));
        }
    }

    /// Takes the places of an element's parts.
    pub(crate) fn add_units(&mut self, item: &Item) {
        self.units.add(item);
    }

    /// Takes the places of the parts of the elements that come next.
    pub(crate) fn append_units(&mut self, units: Units) {
        self.units.append(units);
    }

    pub(crate) fn is_rejected(&self) -> bool {
        self.rejecting > 0
    }

    /// Everything but the rows; the findings because of which something is left out; which part each place is in.
    pub(crate) fn finish(
        mut self,
        provenance: Provenance,
        version: Version,
        quarantined: Vec<QuarantinedPart>,
    ) -> (Compilation, Vec<Cause>, Units) {
        self.diagnostics.sort_by_key(|d| d.finding.span.start);
        let verdict = if self.is_rejected() { Verdict::Rejected } else { Verdict::Accepted };
        let dropped = self.counts.beyond(&self.diagnostics);
        let compilation = Compilation {
            rows: None,
            provenance,
            included: Vec::new(),
            missing: Vec::new(),
            version,
            diagnostics: self.diagnostics,
            counts: self.counts,
            dropped,
            lacks_errors: self.lacks_errors,
            quarantined,
            verdict,
        };
        (compilation, self.causes, self.units)
    }
}
