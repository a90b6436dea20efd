//! Reading in batches gives the items and findings of reading one element after the other, wherever the text is cut.

use mapd_tests::{carried, corpus, say};
use mapd_xodr::source::{Inputs, Places};
use mapd_xodr::{CountedFinding, Finding, Item, Limits, Reader, RestOfDocument};
use std::path::Path;

/// Everything that a reader yields: items, each with the findings up to it, and those at the end.
#[derive(Debug, PartialEq)]
struct Yield {
    items: Vec<(Item, Vec<Finding>)>,
    rest: Vec<Finding>,
    /// What is only counted about items.
    counted: Vec<CountedFinding>,
    extensions: usize,
    error: Option<String>,
    /// Whether a batch was taken as it was read by itself.
    #[allow(dead_code, reason = "compared apart")]
    accepted: Same,
}

/// A number that is no part of a comparison.
#[derive(Debug)]
struct Same(usize);

impl PartialEq for Same {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

fn reader<'a>(text: &'a [u8], folder: Option<&Path>, limits: Limits) -> Reader<'a> {
    let mut inputs = Inputs::new(limits.source);
    if let Some(folder) = folder {
        inputs = inputs.with_include_folder(folder);
    }
    let source = inputs.open(Box::new(text), "");
    Reader::with_source(inputs, source, limits)
}

fn one_by_one(mut reader: Reader<'_>) -> Yield {
    let mut all = Yield {
        items: Vec::new(),
        rest: Vec::new(),
        counted: Vec::new(),
        extensions: 0,
        error: None,
        accepted: Same(0),
    };
    loop {
        match reader.next() {
            Ok(Some(item)) => {
                all.items.push((item, reader.take_findings()));
                all.counted.extend(reader.take_counted().iter());
            }
            Ok(None) => break,
            Err(error) => {
                all.error = Some(error.to_string());
                break;
            }
        }
    }
    all.rest = reader.take_findings();
    all.extensions = reader.extensions().as_slice().len();
    all
}

/// Reads in batches of at least so many bytes, the header apart; always so many are cut before one is read.
fn in_batches(mut reader: Reader<'_>, bytes: usize) -> Yield {
    let (mut items, mut counted) = (Vec::new(), Vec::new());
    while let Ok(Some(item)) = reader.next() {
        let is_header = matches!(item, Item::Header(_));
        items.push((item, reader.take_findings()));
        counted.extend(reader.take_counted().iter());
        if is_header {
            break;
        }
    }
    let mut accepted = 0;
    if let Some(RestOfDocument { context, cutter }) = reader.split() {
        let mut cutter = cutter.with_batch_bytes(bytes);
        let mut cut: std::collections::VecDeque<_> =
            std::iter::from_fn(|| cutter.next()).take(3).collect();
        let mut refused = None;
        while let Some(batch) = cut.pop_front() {
            cut.extend(cutter.next());
            if let Err(batch) = reader.accept(context.read(batch)) {
                refused = Some(batch);
                break;
            }
            accepted += 1;
            while let Some(item) = reader.accepted() {
                items.push((item, reader.take_findings()));
                counted.extend(reader.take_counted().iter());
            }
        }
        reader.go_on(refused.into_iter().chain(cut), cutter);
    }
    let rest = one_by_one(reader);
    items.extend(rest.items);
    counted.extend(rest.counted);
    Yield { items, counted, accepted: Same(accepted), ..rest }
}

/// Findings between two elements may come with the one or the other: those of all elements, by place.
fn placed(all: &Yield) -> Vec<&Finding> {
    let of_items = all.items.iter().flat_map(|(_, findings)| findings);
    let mut findings: Vec<_> = of_items.chain(&all.rest).collect();
    findings.sort_by_key(|finding| finding.span.start);
    findings
}

/// What is only counted, by place.
fn counted(all: &Yield) -> Vec<&CountedFinding> {
    let mut counted: Vec<_> = all.counted.iter().collect();
    counted.sort_by_key(|one| (one.start, one.rule, &one.subject));
    counted
}

/// Compares for batches of several sizes; yields how many were taken.
fn check(name: &str, text: &[u8], folder: Option<&Path>, limits: Limits) -> usize {
    let expected = one_by_one(reader(text, folder, limits));
    let mut accepted = 0;
    for bytes in [1, 300, 4096, 100_000] {
        let found = in_batches(reader(text, folder, limits), bytes);
        let items = |all: &Yield| all.items.len();
        assert_eq!(items(&found), items(&expected), "{name}, batches of {bytes} bytes");
        for ((found, _), (expected, _)) in found.items.iter().zip(&expected.items) {
            assert_eq!(found, expected, "{name}, batches of {bytes} bytes");
        }
        assert_eq!(placed(&found), placed(&expected), "{name}, batches of {bytes} bytes");
        assert_eq!(counted(&found), counted(&expected), "{name}, batches of {bytes} bytes");
        assert_eq!(found.extensions, expected.extensions, "{name}");
        assert_eq!(found.error, expected.error, "{name}");
        accepted += found.accepted.0;
    }
    accepted
}

/// A document around elements.
fn document(elements: &str) -> String {
    format!("<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"7\"/>\n{elements}\n</OpenDRIVE>\n")
}

#[test]
fn maps_read_in_batches_are_the_same() {
    let mut maps = vec![carried("town.xodr"), carried("one_road.xodr")];
    match corpus() {
        Some(all) => maps.extend(all.into_iter().map(|(_, path)| path)),
        None => say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    let mut accepted = 0;
    for path in maps {
        // The largest ones are compared where it is fast.
        let text = std::fs::read(&path).expect("the map can be read");
        if cfg!(debug_assertions) && text.len() > 4_000_000 {
            continue;
        }
        accepted += check(&path.display().to_string(), &text, path.parent(), Limits::default());
    }
    assert!(accepted > 20, "{accepted}");
}

#[test]
fn odd_documents_read_in_batches_are_the_same() {
    let road = |id: u32| {
        format!(
            "<road id=\"{id}\" length=\"1\" junction=\"-1\"><planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"1\"><line/></geometry></planView></road>\n"
        )
    };
    let roads = (0..40).map(road).collect::<String>();
    let junction = "<junction id=\"9\"><controller id=\"3\"></controller></junction>\n";
    let cases = [
        ("a comment with an end", format!("{roads}<!-- </road> {roads} --> {roads}")),
        (
            "a section with an end",
            format!("{roads}<userData><![CDATA[ </road> ]]></userData>{roads}"),
        ),
        ("an instruction with an end", format!("{roads}<?x </road> ?>{roads}")),
        ("an end with space", roads.replace("</road>", "</road\n>")),
        ("junctions first", format!("{junction}{roads}{junction}")),
        ("junctions in between", format!("{roads}{junction}{roads}{junction}{roads}")),
        ("roads behind junctions, many times", format!("{junction}{roads}").repeat(8)),
        ("a second header", format!("{roads}<header revMajor=\"1\" revMinor=\"4\"/>{roads}")),
        ("an element too many", format!("{roads}</road>{roads}")),
        ("an element without end", format!("{roads}<road id=\"x\">{roads}")),
        ("text between elements", format!("{roads} here {roads}")),
        ("unknown elements", format!("{roads}<thing><road></road></thing>{roads}")),
        ("a file that is not there", format!("{roads}<include file=\"none.xml\"/>{roads}")),
        ("missing things, many times", roads.replace("length=\"1\"", "").repeat(8)),
        ("bad numbers", roads.replace("hdg=\"0\"", "hdg=\"x\"")),
        (
            "attributes of many names",
            (0..3000).map(|i| format!("<road a{i}=\"\"></road>")).collect(),
        ),
        ("attributes twice", roads.replace("x=\"0\"", "x=\"0\" x=\"1\"")),
        ("namespaces", format!("{roads}<road xmlns=\"urn:x\"></road>{roads}")),
        ("nothing", String::new()),
    ];
    let mut accepted = 0;
    for (name, elements) in &cases {
        let text = document(elements);
        accepted += check(name, text.as_bytes(), None, Limits::default());
        let tight = Limits { tag_bytes: 64, text_bytes: 64, item_bytes: 2000, ..Limits::default() };
        check(name, text.as_bytes(), None, tight);
        let few = Limits { findings_of_a_kind: 1, ..Limits::default() };
        check(name, text.as_bytes(), None, few);
        for cut in [text.len() - 20, text.len() / 2, text.len() / 2 + 7] {
            check(name, text.as_bytes().get(..cut).expect("a part"), None, Limits::default());
        }
        let mut bytes = text.clone().into_bytes();
        let middle = bytes.len() / 2;
        bytes[middle] = 0xff;
        check(&format!("{name}, not UTF-8"), &bytes, None, Limits::default());
        bytes[middle] = 0x01;
        check(&format!("{name}, a control character"), &bytes, None, Limits::default());
    }
    assert!(accepted > 100, "{accepted}");
    let prefixed = document(&roads).replace('<', "<o:").replace("<o:/", "</o:");
    let prefixed = prefixed.replacen(
        "<o:OpenDRIVE",
        "<o:OpenDRIVE xmlns:o=\"http://code.asam.net/simulation/standard/opendrive_schema\"",
        1,
    );
    assert!(check("a prefix", prefixed.as_bytes(), None, Limits::default()) > 10);
}

#[test]
fn included_files_read_in_batches_are_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let road = |id: u32| format!("<road id=\"{id}\" length=\"1\" junction=\"-1\"></road>\n");
    let some = (0..30).map(road).collect::<String>();
    std::fs::write(folder.path().join("more.xml"), format!("<OpenDRIVE>{some}</OpenDRIVE>"))
        .expect("a file");
    let text = document(&format!("{some}<include file=\"more.xml\"/>{some}"));
    assert!(check("an include", text.as_bytes(), Some(folder.path()), Limits::default()) > 3);
    let count =
        one_by_one(reader(text.as_bytes(), Some(folder.path()), Limits::default())).items.len();
    assert_eq!(count, 91);
    // Places are those of the files, also of what comes behind.
    let mut inputs = Inputs::new(Limits::default().source).with_include_folder(folder.path());
    let source = inputs.open(Box::new(text.as_bytes()), "main");
    let mut reader = Reader::with_source(inputs, source, Limits::default());
    while reader.next().expect("reads").is_some() {}
    assert_eq!(
        Places::file_of(reader.places().included_at(Places::start(1, 0)).expect("a place")),
        0
    );
}
