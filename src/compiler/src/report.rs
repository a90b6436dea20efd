//! What a compilation yields besides rows.

use crate::findings::reading::{
    for_each_about, innermost, is_of_curve, is_small, is_unreadable, raise, without_message,
};
use crate::quarantine::{Cause, Exclusions, QuarantinedPart, Unit, Units, is_outside};
use mapd_archive::{Provenance, Rows};
use mapd_rules::Settings;
use mapd_rules::catalog::building;
use mapd_xodr::source::Places;
use mapd_xodr::{CountedFindings, Finding, Item, Severity, rule_ids};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::PathBuf;
use std::sync::Arc;

/// The verdict on a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There is an archive of all of the map, and no error; there may be warnings.
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
    /// Whether something is wrong that nothing more can be built from.
    is_stopped: bool,
    /// Why something is left out: of each part one at least, however many findings are kept. Else reading again and again would take out some after the others.
    causes: Vec<Cause>,
    /// Starts of the parts that have a cause, and whether it is one that nothing more can be built from.
    parts: HashSet<(u64, bool)>,
    units: Units,
    /// How many errors of reading there are among those only counted, where others of their kind are warnings.
    counted_errors: BTreeMap<ReadKind, u32>,
    /// How findings of reading and building are graded.
    pub(crate) settings: Settings,
    /// Errors of the whole document, where parts of it are left out: others come of that.
    errors: Option<Arc<BTreeSet<(u64, &'static str)>>>,
}

/// What findings of reading have in common that one finding stands for: the rule, the element's tag, the attribute.
type ReadKind = (&'static str, String, Box<str>);

/// What comes of a finding.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Effect {
    /// It is told.
    Told,
    /// It is told for others, each of which takes its part out.
    ToldForOthers,
    /// Its part is taken out, although it could be built: what else there is to find is found all the same.
    TakesOut,
    /// Its part cannot be built.
    Stops,
}

impl Effect {
    /// That of a finding of building, or of a rule.
    fn of(finding: &Finding) -> Self {
        if finding.severity == Severity::Error { Self::Stops } else { Self::Told }
    }
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
    /// An error of the reader's says that the schema forbids something. Where the document cannot be read on, or the compiler finds the very thing
    /// unusable, nothing can be built; then it stands for the compiler's finding. So does an error of the rule on curves. Where either is graded
    /// milder or switched off, the compiler's finding says why a part is left out. A finding of the reader's about a missing value stands for the compiler's
    /// warning about it, too. All other errors of the reader's are warnings, unless the
    /// settings say that they are errors by themselves.
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
        let (mut missed, mut built): (Vec<Finding>, Vec<Finding>) =
            built.into_iter().partition(|finding| !finding.subject.is_empty());
        for list in [&mut unusable, &mut missed] {
            list.sort_by_key(|finding| finding.span.start);
        }
        let mut explained = vec![false; unusable.len()];
        let mut said = vec![false; missed.len()];
        for one in counted.iter() {
            let tag = one.tag;
            let Some((finding, is_small)) = self.about_part(without_message(one), without) else {
                continue;
            };
            for_each_about(&finding, &mut missed, |at, _| said[at] = true);
            if finding.severity < Severity::Error {
                continue;
            }
            let is_unreadable = is_small && is_unreadable(tag, &finding);
            let mut stops = is_unreadable;
            for_each_about(&finding, &mut unusable, |_, unusable| {
                unusable.count = 0;
                stops = true;
            });
            if self.settings.is_error_by_itself(finding.rule) {
                if !stops {
                    self.count_cause(finding, Effect::TakesOut, places);
                    continue;
                }
            } else if stops {
                let kind = (finding.rule, tag.to_owned(), finding.subject.clone());
                *self.counted_errors.entry(kind).or_default() += 1;
            }
            if is_unreadable {
                self.count_cause(finding, Effect::Stops, places);
            }
        }
        for finding in read {
            let Some((finding, is_small)) = self.about_part(finding, without) else { continue };
            let is_error = finding.severity == Severity::Error;
            let mut stops =
                is_error && is_small && is_unreadable(innermost(&finding.path), &finding);
            for_each_about(&finding, &mut missed, |at, _| said[at] = true);
            if is_error {
                for_each_about(&finding, &mut unusable, |at, _| {
                    explained[at] = true;
                    stops = true;
                });
            }
            self.push_read(finding, stops, places);
        }
        let curves: HashSet<u64> =
            built.iter().filter(|one| is_of_curve(one)).map(|one| one.span.start).collect();
        for (finding, explained) in unusable.into_iter().zip(explained) {
            // Then a rule says, as an error, what the compiler finds: that a geometry is no curve.
            let is_told = finding.subject.is_empty() && curves.contains(&{ finding.span.start });
            if !explained && !is_told {
                self.push(finding, Effect::Stops, places);
            }
        }
        let missed = missed.into_iter().zip(said);
        built.extend(missed.filter(|(_, said)| !said).map(|(finding, _)| finding));
        self.add(built, places);
    }

    /// Adds what the reader finds at the end of a document: about the root, and how many more there are of each kind. Of those that are errors only
    /// where nothing can be built, one finding tells the errors and one the others.
    pub(crate) fn add_last_read(
        &mut self,
        read: Vec<Finding>,
        places: &Places,
        without: &Exclusions,
    ) {
        let read: Vec<_> =
            read.into_iter().filter_map(|finding| self.about_part(finding, without)).collect();
        let mut errors = vec![0; read.len()];
        let mut left = std::mem::take(&mut self.counted_errors);
        // One finding may stand for several kinds, where there are very many.
        for is_exact in [true, false] {
            for ((finding, _), errors) in read.iter().zip(&mut errors) {
                for ((rule, tag, subject), count) in &mut left {
                    let is_own = *tag == innermost(&finding.path) && *subject == finding.subject;
                    if finding.rule == *rule && (is_own || !is_exact) {
                        let more = (*count).min(finding.count - *errors);
                        (*count, *errors) = (*count - more, *errors + more);
                    }
                }
            }
        }
        for ((finding, _), errors) in read.into_iter().zip(errors) {
            let (all, message) = (finding.count, finding.message.clone());
            let part = |count| match count == all {
                true => message.clone(),
                false => format!("{count} of {message}"),
            };
            if errors > 0 {
                let finding = Finding { count: errors, message: part(errors), ..finding.clone() };
                self.push(finding, Effect::ToldForOthers, places);
            }
            if errors < all {
                let finding =
                    Finding { count: all - errors, message: part(all - errors), ..finding };
                self.push_read(finding, false, places);
            }
        }
    }

    /// Adds one of the reader's findings, as it is graded; whether something cannot be built because of it.
    fn push_read(&mut self, mut finding: Finding, stops: bool, places: &Places) {
        let effect = match finding.severity {
            _ if stops => Effect::Stops,
            Severity::Error if !rule_ids::is_structural(finding.rule) => Effect::Stops,
            Severity::Error if self.settings.is_error_by_itself(finding.rule) => Effect::TakesOut,
            Severity::Error => {
                finding.severity = Severity::Warning;
                Effect::Told
            }
            _ => Effect::Told,
        };
        self.push(finding, effect, places);
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
            let effect = Effect::of(&finding);
            self.push(finding, effect, places);
        }
    }

    /// As [`Collector::add`], for stages that only a document without errors so far reaches: the lane graph and what comes
    /// after it.
    pub(crate) fn add_late(&mut self, findings: Vec<Finding>, places: &Places) {
        for finding in self.graded(findings) {
            let effect = Effect::of(&finding);
            self.keep(finding, effect, places);
        }
    }

    fn push(&mut self, finding: Finding, effect: Effect, places: &Places) {
        let effect = if self.is_consequence(&finding) { Effect::Told } else { effect };
        self.keep(finding, effect, places);
    }

    fn keep(&mut self, finding: Finding, effect: Effect, places: &Places) {
        self.counts.add(&finding);
        let told = &mut self.told[rank(finding.severity)];
        // Those that say why there is no archive are kept beyond the others.
        let rejects = effect > Effect::Told;
        let kept = *told < KEPT || (rejects && self.rejecting < KEPT);
        *told += 1;
        self.lacks_errors |= !kept && finding.severity == Severity::Error;
        self.reject_for(effect);
        let takes_out = effect >= Effect::TakesOut;
        let is_cause = takes_out && (self.is_first_of_part(&finding, effect) || kept);
        if kept || is_cause {
            let place = places.place(finding.span.start);
            let (line, column) = (place.position.line, place.position.column);
            if is_cause {
                self.causes.push(Cause::new(&finding, &place, effect == Effect::Stops));
            }
            if !kept {
                return;
            }
            self.diagnostics.push(Diagnostic { finding, rejects, file: place.file, line, column });
        }
    }

    /// Notes that a finding takes out the part that it is in; whether it is the first one that does so in this way.
    fn is_first_of_part(&mut self, finding: &Finding, effect: Effect) -> bool {
        let (unit, stops) = (self.units.of(finding.span.start), effect == Effect::Stops);
        unit.is_some_and(|unit| self.parts.insert((unit.start, stops)))
    }

    /// An error that is counted elsewhere takes out a part.
    fn count_cause(&mut self, finding: Finding, effect: Effect, places: &Places) {
        if self.is_consequence(&finding) {
            return;
        }
        let kept = self.rejecting < KEPT;
        self.lacks_errors |= !kept;
        self.reject_for(effect);
        if self.is_first_of_part(&finding, effect) || kept {
            let (place, stops) = (places.place(finding.span.start), effect == Effect::Stops);
            self.causes.push(Cause::new(&finding, &place, stops));
        }
    }

    /// Counts a finding that takes something out.
    fn reject_for(&mut self, effect: Effect) {
        self.rejecting += usize::from(effect >= Effect::TakesOut);
        self.is_stopped |= effect == Effect::Stops;
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

    /// Whether the document was read to its end.
    pub(crate) fn is_read(&self) -> bool {
        !self.causes.iter().any(Cause::hides_parts)
    }

    /// Whether nothing more is built of the document.
    pub(crate) fn is_stopped(&self) -> bool {
        self.is_stopped
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
