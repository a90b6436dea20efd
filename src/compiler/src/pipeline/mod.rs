//! The single path: a document is read and lowered part by part, its ids resolved, its lanes sampled, its graph completed.

mod hashing;
mod in_order;
mod part;
mod rounds;
mod stream;

use crate::draft::{Draft, Links};
use crate::findings::{
    no_roads, too_large, too_large_in, too_many_ids, too_many_overlaps, too_much_behind, unfit,
};
use crate::options::{CompileOptions, Lowering, ReadOptions};
use crate::quarantine::{Cause, Exclusions, QuarantinedPart, Units};
use crate::report::{Collector, Compilation, Progress, Verdict, Version};
use crate::{frame, graph, index, objects, resolve, sample, signals};
use hashing::HashingReader;
use in_order::InOrder;
use mapd_archive::{Provenance, Rows};
use mapd_rules::{Checker, Network};
use mapd_xodr::source::{Inputs, Places};
use mapd_xodr::{Item, Limits, Reader};
use part::{Element, Lowered, Plan};
use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::Arc;
use stream::{Next, Stream};

/// As [`crate::compile_with`].
pub(crate) fn compile_once(
    input: impl Read + Send,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let round = round(input, reading, &Exclusions::default(), options, progress)?;
    build(round.rows, round.compilation, reading, options, progress)
}

/// As [`crate::compile_from`].
pub(crate) fn compile<R: Read + Send>(
    open: &mut dyn FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    let (rows, compilation) = rounds::read(open, reading, options, progress)?;
    build(rows, compilation, reading, options, progress)
}

/// As [`crate::check`].
pub(crate) fn check_once(
    input: impl Read + Send,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    Ok(round(input, reading, &Exclusions::default(), options, progress)?.compilation)
}

/// As [`crate::check_with`].
pub(crate) fn check<R: Read + Send>(
    open: &mut dyn FnMut() -> io::Result<R>,
    reading: &ReadOptions,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Compilation> {
    Ok(rounds::read(open, reading, options, progress)?.1)
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
        index::objects(&mut rows);
        index::signals(&mut rows);
        index::lane_blocks(&mut rows);
        match index::lanes(&mut rows, options) {
            Ok(()) => compiled.rows = Some(rows),
            Err(error) => {
                compiled.reject(too_large(&error, &rows, &[]));
                compiled.quarantined.clear();
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
    causes: Vec<Cause>,
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
    let mut document = read(input, reading, without, options.lowering(), progress)?;
    let roads = document.draft.rows.roads.len();
    let length = document.draft.rows.roads.iter().map(|road| road.length).sum();
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
    draft: Draft,
    /// What the file says about the lane graph.
    graph: graph::WrittenLinks,
    /// What the file says about signals.
    signals: resolve::Resolved,
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
        if self.collector.is_stopped() {
            return Ok(None);
        }
        let mut draft = std::mem::take(&mut self.draft);
        progress(Progress::Sampling { lanes: draft.rows.lanes.len() });
        let mut findings = Vec::new();
        let frame = frame::apply(&mut draft, &mut self.signals, options, &mut findings);
        self.collector.add_late(findings, &self.places);
        if self.collector.is_stopped() {
            return Ok(None);
        }
        let placed = draft.placed.clone();
        let written = std::mem::take(&mut draft.objects);
        let road_spans = std::mem::take(&mut draft.road_spans);
        let mut rows = resolve::tables(draft, options);
        let allowance = sample::Allowance::of(&rows);
        let lanes = match sample::lanes(&mut rows, options, &allowance) {
            Ok(_) if allowance.is_exceeded() => {
                self.collector.add_late(vec![allowance.finding()], &self.places);
                return Ok(None);
            }
            Ok(lanes) => lanes,
            Err(error) => {
                let found = too_large(&error, &rows, &road_spans);
                self.collector.add_late(vec![found], &self.places);
                return Ok(None);
            }
        };
        let lost = lanes.iter().map(|lane| unfit(&rows, *lane, &road_spans)).collect::<Vec<_>>();
        if !lost.is_empty() {
            self.collector.add_late(lost, &self.places);
            return Ok(None);
        }
        index::lane_lengths(&mut rows);
        progress(Progress::Graph { nodes: rows.lane_nodes.len() });
        let mut findings =
            graph::complete(&mut rows, &self.graph, options, &self.collector.settings);
        graph::rings(&mut rows);
        frame::complete(&mut rows, &placed, frame.as_ref(), options, &mut findings);
        self.collector.add_late(findings, &self.places);
        match objects::build(&mut rows, written, options) {
            Ok(findings) => self.collector.add_late(findings, &self.places),
            Err(error) => {
                let found = too_large(&error, &rows, &road_spans);
                self.collector.add_late(vec![found], &self.places);
            }
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
    without: &Exclusions,
    lowering: Lowering,
    progress: &mut dyn FnMut(Progress),
) -> io::Result<Document> {
    let mut hashing = HashingReader::new(input);
    let ontology = Arc::new(reading.ontology.clone());
    let mut draft = Draft::new(Arc::clone(&ontology), lowering);
    let mut collector = Collector::new(without, &reading.rules);
    let mut quarantined = Vec::new();
    let (to_hash, networks) = (hashing.hashing(), Arc::new(InOrder::new(Network::default(), add)));
    let to_add = Arc::clone(&networks);
    let between = Arc::new(move || {
        to_hash.help();
        to_add.help();
    });
    let (places, version, mut checker, read) = rayon::in_place_scope_fifo(|scope| {
        let mut inputs = Inputs::new(reading.limits.source);
        if let Some(folder) = &reading.include_folder {
            inputs = inputs.with_include_folder(folder);
        }
        let source = match &reading.patch {
            None => inputs.open(Box::new(&mut hashing), ""),
            Some(patch) => inputs.open_patched(Box::new(&mut hashing), "", patch),
        };
        let places_of_all = reading.rules.has_errors_by_themselves();
        let limits = Limits { places_of_all, ..reading.limits };
        let reader = Reader::with_source(inputs, source, limits);
        let mut stream = Stream::new(reader, reading.batch_bytes, scope, between);
        let places = stream.reader.places().clone();
        let none_near = places.near(0, 0);
        let mut checker = Checker::new(&reading.rules);
        // What was lowered on other threads, and the roads before it.
        let (mut elements, mut before) = (VecDeque::new(), 0);
        // Whether the network is put together beside this.
        let mut is_apart = false;
        let mut set_apart = |checker: &mut Checker, apart: bool| {
            if is_apart != apart {
                std::mem::swap(checker.network_mut(), &mut networks.settled());
                is_apart = apart;
            }
        };
        loop {
            // What is left out is so before anything looks at it.
            let plan =
                || without.is_empty().then(|| Plan::new(&checker, &ontology, &places, lowering));
            let Some(next) = stream.next(&plan)? else { break };
            let (read, counted) = (stream.reader.take_findings(), stream.reader.take_counted());
            let mut checked = Vec::new();
            let mut roads = None;
            match next {
                Next::Part(mut part) => {
                    before = draft.roads();
                    collector.append_units(std::mem::take(&mut part.units));
                    draft.append(&mut part.draft);
                    elements = std::mem::take(&mut part.elements);
                    set_apart(&mut checker, true);
                    networks.push(part);
                    collector.add_read(read, &counted, checked, &places, without);
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
                    set_apart(&mut checker, false);
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
                        part::lower(&mut draft, item, &line, &none_near, &mut checked);
                    }
                }
            }
            collector.add_read(read, &counted, checked, &places, without);
            let (bytes, roads) = (stream.reader.bytes_read(), roads.unwrap_or(draft.roads()));
            progress(Progress::Reading { bytes, roads });
        }
        set_apart(&mut checker, false);
        let reader = &mut stream.reader;
        let stated = reader.stated_version().to_owned();
        let version = Version { stated, checked: reader.checked_version() };
        draft.annotate_root(reader.extensions().as_slice(), &none_near);
        io::Result::Ok((places, version, checker, reader.take_findings()))
    })?;
    progress(Progress::Linking { roads: draft.roads() });
    let mut late = Vec::new();
    let whole = checker.whole();
    let lacks_ids = whole.lacks_ids();
    let has_roads = whole.network().has_roads();
    let links = Links::new(&draft.road_spans, whole.network());
    // Nodes are made beside the rules. Where those reject the map, it is as if there were none.
    let is_sound = !collector.is_stopped();
    let (examined, (signals, cuts)) = rayon::join(
        || part::examine(&whole),
        || {
            draft.finish_reading(&mut late);
            resolve::links(&mut draft, &links, &mut late);
            resolve::groups(&mut draft);
            let signals = resolve::signals(&mut draft, &links, &places, &mut late);
            resolve::annotations(&mut draft, &places, reading.include_folder.as_deref());
            (signals, is_sound.then(|| graph::nodes(&mut draft, &links)))
        },
    );
    if whole.has_more_overlaps() {
        late.push(too_many_overlaps());
    }
    let (network, rest) = checker.end(whole, examined).into_links();
    free(rest);
    collector.add_last_read(read, &places, without);
    collector.add(checker.take_findings(), &places);
    // Of a document that cannot be read, nobody knows.
    if !has_roads && collector.is_read() {
        late.push(no_roads());
    }
    if lacks_ids {
        late.push(too_many_ids());
    }
    collector.add(late, &places);
    let mut graph = graph::WrittenLinks::default();
    if let Some(cuts) = cuts.filter(|_| !collector.is_stopped()) {
        let mut late = Vec::new();
        let links = Links::new(&draft.road_spans, &network);
        let settings = &collector.settings;
        let made = cuts
            .and_then(|cuts| graph::edges(&mut draft, &links, &cuts, &places, settings, &mut late));
        match made {
            Ok(made) => graph = made,
            Err(error) => late.push(too_large_in(&error, |road| draft.road_named(road))),
        }
        collector.add_late(late, &places);
    }
    let most = reading.limits.source.decoded_bytes;
    let input_hash = match hashing.finish(included(&places), most)? {
        Some(hash) => hash,
        // Nothing is made of it that the hash would have to name.
        None => {
            if !collector.is_rejected() {
                collector.add_late(vec![too_much_behind(most)], &places);
            }
            [0; 32]
        }
    };
    let provenance =
        Provenance { input_hash, options_hash: [0; 8], compiler_version: compiler_version() };
    resolve::quarantined(&mut draft, &quarantined);
    free(network);
    Ok(Document { draft, graph, signals, collector, places, provenance, version, quarantined })
}

/// Puts what the rules on the network need of a batch behind what they need of those before, and frees what is left of the batch.
fn add(network: &mut Network, part: Box<Lowered>) {
    network.append(part.network);
}

/// Frees what is no longer needed, beside what comes next if there are several threads.
fn free(done: impl Send + 'static) {
    if rayon::current_num_threads() > 1 {
        rayon::spawn(move || drop(done));
    }
}

/// The files that the document included, in the order in which it did.
fn included(places: &Places) -> impl Iterator<Item = PathBuf> {
    let start = |file: usize| Places::start(u16::try_from(file).unwrap_or(u16::MAX), 0);
    (1..places.files()).map(move |file| PathBuf::from(&*places.place(start(file)).file))
}

/// This crate's version as numbers.
fn compiler_version() -> [u16; 3] {
    let mut parts = env!("CARGO_PKG_VERSION").split('.').map(|part| part.parse().unwrap_or(0));
    std::array::from_fn(|_| parts.next().unwrap_or(0))
}
