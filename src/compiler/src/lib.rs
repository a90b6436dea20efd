//! From an OpenDRIVE document to the tables of an archive.
//!
//! [`compile`] reads a stream road by road, checks each, lowers it to flat rows, then resolves links, samples lanes and
//! builds the spatial index on the compact network. What is wrong with the map comes back as findings with line and
//! column; `Err` is for the environment.
//!
//! Invariants: the document is never whole in memory; geometry is evaluated by the very functions that queries use; the
//! same bytes and options give the same archive on every machine and for every number of threads. Deliberately absent:
//! files, shared memory, printing.
//!
//! ```
//! let map = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>
//! <road id="1" length="10" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="10"><line/></geometry></planView>
//! <lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
//! </road></OpenDRIVE>"#;
//! let compiled = mapd_compiler::compile(map.as_bytes(), &Default::default(), &mut |_| {}).unwrap();
//! let bytes = mapd_archive::encode(compiled.rows.as_ref().unwrap(), &compiled.provenance).unwrap();
//! assert_eq!(mapd_archive::verify(&bytes).unwrap().tables.lanes.len(), 2);
//! ```

mod allowance;
mod annotations;
mod cuts;
mod decoded;
mod flatten;
mod frame;
mod georeference;
mod graph;
mod hashing;
mod index;
mod lanes;
mod links;
mod lower;
mod objects;
mod options;
mod origin;
mod packed;
mod part;
mod quarantine;
mod report;
mod rounds;
mod signals;
mod stream;
mod too_large;

pub use annotations::{Extra, Without};
pub use mapd_geodesy::{Target, TargetError};
pub use options::{CompileOptions, CyclePolicy, OffsetSign, OptionsError};
pub use quarantine::{OnError, PartKind, Policy, QuarantinedPart, Treatment};
pub use report::{Compilation, Diagnostic, Progress, Verdict, Version};

use hashing::HashingReader;
use lower::Lowering;
use mapd_archive::{Provenance, Rows};
use mapd_rules::{Checker, Rule};
use mapd_xodr::source::{Inputs, Places};
use mapd_xodr::{Finding, Item, Limits, Reader, Severity};
use part::{Element, Plan};
use quarantine::{Exclusions, Units};
use report::Collector;
use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::Arc;
use stream::{Next, Stream};
pub(crate) use too_large::TooLarge;
use too_large::{too_large, too_many_ids, too_many_overlaps, unfit};

/// How a document is read and what becomes of its errors. It never shapes the tables of a map without errors.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Bounds on what the document may ask for.
    pub limits: Limits,
    /// The folder that files may be included from; none: nothing is included, and a map that wants to is rejected.
    pub include_folder: Option<PathBuf>,
    /// Which rules apply, and how bad their findings are.
    pub rules: mapd_rules::Settings,
    /// What becomes of a map with errors.
    pub policy: Policy,
    /// What signals and objects mean.
    pub ontology: mapd_ontology::Ontology,
    /// Bytes of text that a thread reads, checks and lowers at once, at least; none: 256 KiB. It does not show in the archive.
    pub batch_bytes: Option<usize>,
}

impl ReadOptions {
    /// First bytes of the BLAKE3 of all that shapes an archive, as its header carries them.
    pub fn hash(&self, options: &CompileOptions) -> [u8; 8] {
        let tables = self.ontology.user_texts();
        let plain = self.rules == mapd_rules::Settings::default();
        if plain && self.policy == Policy::default() && tables.is_empty() {
            return options.hash();
        }
        let mut hasher = blake3::Hasher::new();
        hasher.update(&options.hash());
        // Both are plain values with names, the same in every build of one version.
        hasher.update(format!("{:?} {:?}", self.rules, self.policy).as_bytes());
        for text in tables {
            hasher.update(blake3::hash(text.as_bytes()).as_bytes());
        }
        let mut out = [0; 8];
        out.copy_from_slice(&hasher.finalize().as_bytes()[..8]);
        out
    }
}

/// Compiles a document that includes no files. `progress` is told after each top-level element and at each stage.
///
/// Errors: reading failed. A map that is rejected is no error: see [`Compilation::verdict`].
pub fn compile(
    input: impl Read + Send,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    compile_with(input, &ReadOptions::default(), options, progress)
}

/// Compiles a document that can be read once. An error rejects the map: to leave out the part that has it, the document must
/// be read again, which [`compile_from`] does.
///
/// Errors: reading failed. A map that is rejected is no error: see [`Compilation::verdict`].
pub fn compile_with(
    input: impl Read + Send,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let round = round(input, reading, &Exclusions::default(), options, progress)?;
    build(round.rows, round.compilation, reading, options, progress)
}

/// Compiles a document. `open` yields it from its start, as often as it is called: parts with errors are treated as
/// [`ReadOptions::policy`] says.
///
/// Errors: reading failed, or the document changed in between. A map that is rejected is no error: see
/// [`Compilation::verdict`].
pub fn compile_from<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let (rows, compilation) = rounds::read(&mut open, reading, options, progress)?;
    build(rows, compilation, reading, options, progress)
}

/// Finds everything that [`compile_with`] finds, without building the map: there are no rows.
///
/// Errors: reading failed.
pub fn check(
    input: impl Read + Send,
    reading: &ReadOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    Ok(round(input, reading, &Exclusions::default(), &options, progress)?.compilation)
}

/// Finds everything that [`compile_from`] finds, without building the map: there are no rows.
///
/// Errors: reading failed, or the document changed in between.
pub fn check_from<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    check_with(&mut open, reading, &CompileOptions::default(), progress)
}

/// As [`check_from`], for a map that is to be compiled with these options.
///
/// Errors: reading failed, or the document changed in between.
pub fn check_with<R: Read + Send>(
    mut open: impl FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let options = CompileOptions { landmarks: 0, ..options.clone() };
    Ok(rounds::read(&mut open, reading, &options, progress)?.1)
}

/// Builds the index of a map that is not rejected.
fn build(
    rows: Option<Rows>,
    mut compiled: Compilation,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    compiled.provenance.options_hash = reading.hash(options);
    if let Some(mut rows) = rows.filter(|_| compiled.verdict != Verdict::Rejected) {
        progress(Progress::Indexing { bytes: rows.points.len() });
        objects::index(&mut rows);
        signals::index(&mut rows);
        match index::build(&mut rows, options) {
            Ok(()) => compiled.rows = Some(rows),
            Err(error) => {
                let finding = too_large(&error);
                let file = "".into();
                let told = Diagnostic { finding, rejects: true, file, line: 1, column: 1 };
                compiled.diagnostics.insert(0, told);
                compiled.quarantined.clear();
                compiled.verdict = Verdict::Rejected;
            }
        }
    }
    Ok(compiled)
}

/// What reading a document once yields.
struct Round {
    /// Tables but for the index; none where something is wrong.
    rows: Option<Rows>,
    compilation: Compilation,
    causes: Vec<report::Cause>,
    units: Units,
    /// Number of roads in the map.
    roads: usize,
    /// Their length together `[m]`.
    length: f64,
}

/// Reads a document without some parts, samples lanes and completes the lane graph.
fn round(
    input: impl Read + Send,
    reading: &ReadOptions,
    without: &Exclusions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Round> {
    let mut document = read(input, reading, (without, options.without), progress)?;
    let roads = document.lowering.rows.roads.len();
    let length = document.lowering.rows.roads.iter().map(|road| road.length).sum();
    let rows = document.sample(options, progress)?;
    let files = included(&document.places).collect();
    let (mut compilation, causes, units) =
        document.collector.finish(document.provenance, document.version, document.quarantined);
    compilation.included = files;
    compilation.missing = document.places.missing();
    Ok(Round { rows, compilation, causes, units, roads, length })
}

/// A document that has been read and checked, and whose links are resolved.
struct Document {
    lowering: Lowering,
    /// What the file says about the lane graph.
    graph: graph::Written,
    /// What the file says about signals.
    signals: signals::Resolved,
    collector: Collector,
    places: Places,
    provenance: Provenance,
    version: Version,
    /// Parts that were left out.
    quarantined: Vec<QuarantinedPart>,
}

impl Document {
    /// Samples lanes and completes the lane graph, which may find more that is wrong; none for a rejected map.
    fn sample(
        &mut self,
        options: &CompileOptions,
        progress: &mut dyn FnMut(Progress),
    ) -> io::Result<Option<Rows>> {
        if self.collector.is_rejected() {
            return Ok(None);
        }
        let mut lowering = std::mem::take(&mut self.lowering);
        progress(Progress::Sampling { lanes: lowering.rows.lanes.len() });
        let mut findings = Vec::new();
        let frame = frame::apply(&mut lowering, &mut self.signals, options, &mut findings);
        self.collector.add_late(findings, &self.places);
        if self.collector.is_rejected() {
            return Ok(None);
        }
        let placed = lowering.placed.clone();
        let written = std::mem::take(&mut lowering.objects);
        let road_spans = std::mem::take(&mut lowering.links.road_spans);
        let mut rows = lowering.into_rows(options);
        let allowance = allowance::Allowance::of(&rows);
        let lanes = match lanes::sample(&mut rows, options, &allowance) {
            Ok(_) if allowance.is_exceeded() => {
                self.collector.add_late(vec![allowance.finding()], &self.places);
                return Ok(None);
            }
            Ok(lanes) => lanes,
            Err(error) => {
                self.collector.add_late(vec![too_large(&error)], &self.places);
                return Ok(None);
            }
        };
        let lost = lanes.iter().map(|lane| unfit(&rows, *lane, &road_spans)).collect::<Vec<_>>();
        if !lost.is_empty() {
            self.collector.add_late(lost, &self.places);
            return Ok(None);
        }
        progress(Progress::Graph { nodes: rows.lane_nodes.len() });
        let mut findings =
            graph::complete(&mut rows, &self.graph, options, &self.collector.settings);
        annotations::rings(&mut rows);
        georeference::complete(&mut rows, &placed, frame.as_ref(), options, &mut findings);
        self.collector.add_late(findings, &self.places);
        match objects::build(&mut rows, written, options) {
            Ok(findings) => self.collector.add_late(findings, &self.places),
            Err(error) => self.collector.add_late(vec![too_large(&error)], &self.places),
        }
        let findings = signals::complete(&mut rows, &self.signals, options);
        self.collector.add_late(findings, &self.places);
        Ok(Some(rows).filter(|_| !self.collector.is_rejected()))
    }
}

/// Reads and checks a document without some parts and resolves its links.
fn read(
    input: impl Read + Send,
    reading: &ReadOptions,
    (without, extras): (&Exclusions, Without),
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Document> {
    let mut hashing = HashingReader::new(input);
    let ontology = Arc::new(reading.ontology.clone());
    let mut lowering = Lowering::new(Arc::clone(&ontology), extras);
    let mut collector = Collector::new(without, &reading.rules);
    let mut quarantined = Vec::new();
    let (places, version, mut checker, read) = {
        let mut inputs = Inputs::new(reading.limits.source);
        if let Some(folder) = &reading.include_folder {
            inputs = inputs.with_include_folder(folder);
        }
        let source = inputs.open(Box::new(&mut hashing), "");
        let reader = Reader::with_source(inputs, source, reading.limits);
        let mut stream = Stream::new(reader, reading.batch_bytes);
        let places = stream.reader.places().clone();
        let mut checker = Checker::new(&reading.rules);
        // What was lowered on other threads, and the roads before it.
        let (mut elements, mut before) = (VecDeque::new(), 0);
        loop {
            // What is left out is so before anything looks at it.
            let plan =
                || without.is_empty().then(|| Plan::new(&checker, &ontology, &places, extras));
            let Some(next) = stream.next(&plan)? else { break };
            let read = stream.reader.take_findings();
            let mut checked = Vec::new();
            let mut roads = None;
            match next {
                Next::Part(part) => {
                    before = lowering.roads();
                    checker.add_network(part.network);
                    collector.append_units(part.units);
                    lowering.append(part.lowering);
                    elements = part.elements;
                    collector.add_read(read, checked, &places, without);
                    continue;
                }
                Next::Lowered => {
                    let mut element: Element = elements.pop_front().unwrap_or_default();
                    checker.examined(element.examined);
                    checked = checker.take_findings();
                    checked.append(&mut element.built);
                    roads = Some(before + element.roads);
                }
                Next::Item(item) => {
                    collector.add_units(&item);
                    if let Some(mut item) = without.filter(item, &mut quarantined) {
                        let line = match &item {
                            // What refers to its lanes and links is seen as if it were not there.
                            Item::Road(road) if without.is_bare(road.span.start) => {
                                checker.item_apart(&mut item)
                            }
                            _ => checker.item(&mut item),
                        };
                        checked = checker.take_findings();
                        part::lower(&mut lowering, (item, &line), &places, &mut checked);
                    }
                }
            }
            collector.add_read(read, checked, &places, without);
            let (bytes, roads) = (stream.reader.bytes_read(), roads.unwrap_or(lowering.roads()));
            progress(Progress::Reading { bytes, roads });
        }
        let reader = &mut stream.reader;
        let stated = reader.stated_version().to_owned();
        let version = Version { stated, checked: reader.checked_version() };
        lowering.annotate_root(reader.extensions().as_slice(), &places);
        (places, version, checker, reader.take_findings())
    };
    progress(Progress::Linking { roads: lowering.roads() });
    let mut late = Vec::new();
    let whole = checker.whole();
    let lacks_ids = whole.lacks_ids();
    let (examined, signals) = rayon::join(
        || part::examine(&whole),
        || {
            lowering.finish_reading(&mut late);
            links::resolve(&mut lowering, without, &mut late);
            lowering.resolve_groups();
            signals::resolve(&mut lowering, &places, &mut late)
        },
    );
    if whole.has_more_overlaps() {
        late.push(too_many_overlaps());
    }
    checker.end(whole, examined);
    collector.add_read(read, checker.take_findings(), &places, without);
    if lacks_ids {
        late.push(too_many_ids());
    }
    collector.add(late, &places);
    let mut graph = graph::Written::default();
    if !collector.is_rejected() {
        let mut late = Vec::new();
        graph = graph::build(&mut lowering, &places, &collector.settings, &mut late)
            .map_err(io::Error::other)?;
        collector.add_late(late, &places);
    }
    let most = reading.limits.source.decoded_bytes;
    let input_hash = match hashing.finish(included(&places), most)? {
        Some(hash) => hash,
        // Nothing is made of it that the hash would have to name.
        None if collector.is_rejected() => [0; 32],
        None => {
            return Err(io::Error::other(format!("more than {most} bytes follow the document")));
        }
    };
    let provenance =
        Provenance { input_hash, options_hash: [0; 8], compiler_version: crate::version() };
    lowering.finish_annotations(&places, reading.include_folder.as_deref());
    lowering.quarantine(&quarantined);
    Ok(Document { lowering, graph, signals, collector, places, provenance, version, quarantined })
}

/// The files that the document included, in the order in which it did.
fn included(places: &Places) -> impl Iterator<Item = PathBuf> {
    let start = |file: usize| Places::start(u16::try_from(file).unwrap_or(u16::MAX), 0);
    (1..places.files()).map(move |file| PathBuf::from(&*places.place(start(file)).file))
}

/// This crate's version as numbers.
fn version() -> [u16; 3] {
    let mut parts = env!("CARGO_PKG_VERSION").split('.').map(|part| part.parse().unwrap_or(0));
    std::array::from_fn(|_| parts.next().unwrap_or(0))
}

/// A finding of the compiler's own: as bad as its rule's usual ones, or milder.
fn finding(
    rule: &'static Rule,
    severity: Severity,
    span: mapd_xodr::Span,
    path: String,
    message: String,
    hint: &str,
) -> Finding {
    let severity = severity.min(rule.severity);
    let (rule, subject, hint) = (rule.id, "".into(), hint.to_owned());
    Finding { rule, severity, span, path, subject, message, hint }
}
