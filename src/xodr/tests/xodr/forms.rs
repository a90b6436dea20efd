//! Documents in all their forms, read to the end: compressed, in other encodings, in several files. Values, findings and their
//! places are those of the plain text.

use flate2::{Compression, write::GzEncoder};
use mapd_xodr::source::{Inputs, SourceLimits};
use mapd_xodr::{ExtensionKind, Item, Limits, Reader};
use std::fs;
use std::io::Write as _;
use std::path::Path;
use tempfile::TempDir;

/// Items without offsets, and findings as `file:line:column rule`.
struct Outcome {
    items: String,
    names: Vec<String>,
    findings: Vec<String>,
    extensions: Vec<(ExtensionKind, String)>,
}

fn finish(mut reader: Reader<'_>) -> Outcome {
    let (mut items, mut names) = (String::new(), Vec::new());
    while let Some(item) = reader.next().expect("reading does not fail") {
        items += &without_offsets(&format!("{item:?}\n"));
        names.push(match &item {
            Item::Road(road) => road.id.as_ref().map_or("?", |id| &id.value).to_owned(),
            Item::Header(_) => "header".to_owned(),
            other => format!("{other:?}"),
        });
    }
    let findings = reader.take_findings();
    let findings = findings.iter().map(|finding| {
        let place = reader.places().place(finding.span.start);
        let file = Path::new(&*place.file).file_name().unwrap_or_default().to_string_lossy();
        let at = place.position;
        format!("{file}:{}:{} {}", at.line, at.column, finding.rule)
    });
    let kept = reader.extensions().as_slice().iter();
    let extensions = kept.map(|kept| (kept.kind, kept.text.to_string())).collect();
    Outcome { items, names, findings: findings.collect(), extensions }
}

/// Offsets count from the start of the file, which has a declaration of its own length in each form.
fn without_offsets(text: &str) -> String {
    let mut out = String::new();
    for (at, part) in text.split("start: ").enumerate() {
        out += if at == 0 { part } else { part.trim_start_matches(|c: char| c.is_ascii_digit()) };
    }
    out
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("memory does not fail");
    encoder.finish().expect("memory does not fail")
}

fn utf_16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

/// Characters beyond ASCII in a name, behind which a value is no number, and an element that nothing knows.
const BODY: &str = "<OpenDRIVE>\n<header revMajor='1' revMinor='7' name='Straße'/>\n\
    <road name='Größe €' id='1' length='zehn' junction='-1'>\n<planView/><été/></road>\n</OpenDRIVE>\n";

#[test]
fn every_transport_form() {
    let declared = |encoding: &str| format!("<?xml version='1.0' encoding='{encoding}'?>\n{BODY}");
    let plain = declared("UTF-8");
    let expected = finish(Reader::new(plain.as_bytes(), Limits::default()));
    assert_eq!(expected.names, ["header", "1"]);
    let at = |rule: &str| expected.findings.iter().find(|finding| finding.ends_with(rule)).cloned();
    // Columns are bytes of the decoded text.
    assert_eq!(at("mapd:value.type").as_deref(), Some(":4:41 mapd:value.type"));
    assert_eq!(at("unknown_element").as_deref(), Some(":5:12 mapd:structure.unknown_element"));

    let windows_1252: Vec<u8> = declared("windows-1252")
        .chars()
        .map(|c| if c == '€' { 0x80 } else { u8::try_from(u32::from(c)).expect("Latin-1") })
        .collect();
    let forms = [
        ("UTF-8 with a mark", format!("\u{feff}{plain}").into_bytes()),
        ("UTF-8 undeclared", format!("<?xml version='1.0'?>\n{BODY}").into_bytes()),
        ("UTF-16 LE", utf_16(&format!("\u{feff}{}", declared("UTF-16")), u16::to_le_bytes)),
        ("UTF-16 BE", utf_16(&format!("\u{feff}{}", declared("utf-16")), u16::to_be_bytes)),
        ("Windows-1252", windows_1252.clone()),
        ("gzip", gzip(plain.as_bytes())),
        ("gzip of Windows-1252", gzip(&windows_1252)),
        (
            "gzip of UTF-16",
            gzip(&utf_16(&format!("\u{feff}{}", declared("UTF-16")), u16::to_be_bytes)),
        ),
        (
            "gzip in two members",
            [gzip(&plain.as_bytes()[..70]), gzip(&plain.as_bytes()[70..])].concat(),
        ),
    ];
    let folder = TempDir::new().expect("a folder");
    for (name, bytes) in forms {
        let memory = finish(Reader::new(&bytes[..], Limits::default()));
        assert_eq!(memory.items, expected.items, "{name}");
        assert_eq!(memory.findings, expected.findings, "{name}");
        // Whatever it is called.
        for file in ["map.xodr", "map.xodrz", "map.gz", "map"] {
            let path = folder.path().join(file);
            fs::write(&path, &bytes).expect("a file");
            let read = finish(Reader::open(&path, Limits::default()).expect("it is there"));
            assert_eq!(read.items, expected.items, "{name} as {file}");
            let named: Vec<String> =
                expected.findings.iter().map(|f| format!("{file}{f}")).collect();
            assert_eq!(read.findings, named, "{name} as {file}");
        }
    }
    let latin_1 = declared("ISO-8859-1").replace('€', "$");
    let bytes: Vec<u8> =
        latin_1.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
    let read = finish(Reader::new(&bytes[..], Limits::default()));
    let expected = finish(Reader::new(plain.replace('€', "$").as_bytes(), Limits::default()));
    assert_eq!((read.items, read.findings), (expected.items, expected.findings));
}

/// A road; what is inside begins on its third line.
fn road(id: &str, inner: &str) -> String {
    format!(
        "<road id='{id}' length='1' junction='-1'>\n<planView>\n{inner}\n</planView>\n<lanes/></road>"
    )
}

const GEOMETRY: &str = "<geometry s='0' x='0' y='0' hdg='0' length='1'><line/></geometry>";
const HEADER: &str = "<header revMajor='1' revMinor='7'/>";

fn write(folder: &Path, files: &[(&str, &[u8])]) {
    for (name, bytes) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }
}

fn read(folder: &TempDir) -> Outcome {
    finish(Reader::open(&folder.path().join("main.xodr"), Limits::default()).expect("it is there"))
}

#[test]
fn includes_stand_for_what_they_include() {
    let folder = TempDir::new().expect("a folder");
    let whole = format!(
        "<OpenDRIVE>{HEADER}\n{}\n{}\n{}</OpenDRIVE>",
        road("1", GEOMETRY),
        road("2", &format!("{GEOMETRY}\n{GEOMETRY}")),
        road("3", GEOMETRY)
    );
    let first = format!(
        "<?xml version='1.0'?>\n<OpenDRIVE>\n{}\n</OpenDRIVE>\n<!-- end -->\n",
        road("1", GEOMETRY)
    );
    let plan = format!("<planView>{GEOMETRY}</planView>");
    write(
        folder.path(),
        &[
            (
                "main.xodr",
                format!(
                    "<OpenDRIVE>{HEADER}\n<include file='roads/first.xodr'/>\n{}\n{}</OpenDRIVE>",
                    road("2", &format!("{GEOMETRY}<include file='plan.xodrz'></include>")),
                    road("3", "<include file='roads/deep/../up.xodr'/>"),
                )
                .as_bytes(),
            ),
            // In other encodings than the including file's, compressed or not.
            ("roads/first.xodr", &utf_16(&format!("\u{feff}{first}"), u16::to_le_bytes)),
            ("plan.xodrz", &gzip(plan.as_bytes())),
            ("roads/deep/empty", b""),
            // Relative to the file in which it stands, which an include includes.
            ("roads/up.xodr", b"<planView>\n<include file='../plan.xodrz'/></planView>"),
        ],
    );
    let expected = finish(Reader::new(whole.as_bytes(), Limits::default()));
    let read = read(&folder);
    let wrong = |finding: &&String| finding.contains("include") || finding.contains(":xml.");
    assert_eq!(read.findings.iter().find(wrong), None);
    assert_eq!(read.names, ["header", "1", "2", "3"]);
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    for (read, expected) in lines(&read.items).iter().zip(lines(&expected.items)) {
        // The tags of the including and the included element may differ in length.
        assert_eq!(read, &expected);
    }
}

#[test]
fn findings_name_the_included_file() {
    let folder = TempDir::new().expect("a folder");
    write(folder.path(), &[
        (
            "main.xodr",
            format!("<OpenDRIVE>{HEADER}\n\n  <include file='a.xodr'/>\n<road id='3' length='three' junction='-1'/>\n</OpenDRIVE>")
                .as_bytes(),
        ),
        (
            "a.xodr",
            &utf_16(
                "\u{feff}<OpenDRIVE>\n <road id='1' length='one' junction='-1'/>\n <include file='b.xodr'/>\n\
                 <road id='4' length='four' junction='-1'/></OpenDRIVE>",
                u16::to_be_bytes,
            ),
        ),
        ("b.xodr", &gzip(b"<!-- two -->\n\n<OpenDRIVE>\n<road\n id='2' length='two' junction='-1'/></OpenDRIVE>")),
    ]);
    let read = read(&folder);
    assert_eq!(read.names, ["header", "1", "2", "4", "3"]);
    let types: Vec<&str> =
        read.findings.iter().filter_map(|f| f.strip_suffix(" mapd:value.type")).collect();
    assert_eq!(types, ["a.xodr:2:23", "b.xodr:5:17", "a.xodr:4:22", "main.xodr:4:22"]);
}

/// What is wrong with an include, and the finding that says so. Reading goes on behind it, but where the included file is no
/// XML: then nothing after it can be trusted.
#[test]
fn includes_that_cannot_be_read() {
    let two = "<OpenDRIVE/><OpenDRIVE/>";
    let cases: [(&str, &str, &str, bool); 9] = [
        ("absent.xodr", "", "main.xodr:3:1 mapd:xml.include", true),
        ("../outside.xodr", "", "main.xodr:3:1 mapd:xml.include", true),
        ("main.xodr", "", "main.xodr:3:1 mapd:xml.include", true),
        ("http://example.com/b.xodr", "", "main.xodr:3:1 mapd:xml.include", true),
        ("b.xodr", "<road id='9'/>", "b.xodr:1:1 mapd:xml.include", true),
        ("b.xodr", "<OpenDRIVE>\n<road id='2'/>", "b.xodr:2:15 mapd:xml.well_formed", false),
        ("b.xodr", two, "b.xodr:1:13 mapd:xml.well_formed", false),
        ("b.xodr", "<OpenDRIVE/> text", "b.xodr:1:14 mapd:xml.well_formed", false),
        ("b.xodr", "", "b.xodr:1:1 mapd:xml.well_formed", false),
    ];
    for (reference, included, expected, goes_on) in cases {
        let folder = TempDir::new().expect("a folder");
        let text = format!(
            "<OpenDRIVE>{HEADER}\n\n<include file='{reference}'/>\n<road id='1'/></OpenDRIVE>"
        );
        write(folder.path(), &[("main.xodr", text.as_bytes()), ("b.xodr", included.as_bytes())]);
        let read = read(&folder);
        assert!(
            read.findings.iter().any(|f| f == expected),
            "{reference} {included}: {:?}",
            read.findings
        );
        assert_eq!(read.names.contains(&"1".to_owned()), goes_on, "{reference} {included}");
    }
}

#[test]
fn includes_of_a_document_in_memory() {
    let text = format!(
        "<OpenDRIVE>{HEADER}<include file='a.xodr'/><road id='1'/><userData code='c'/></OpenDRIVE>"
    );
    let read = finish(Reader::new(text.as_bytes(), Limits::default()));
    assert!(read.findings.iter().any(|f| f.ends_with("mapd:xml.include")), "{:?}", read.findings);
    assert_eq!(read.names, ["header", "1"]);
    let kept = |kind, text: &str| (kind, text.to_owned());
    assert_eq!(
        read.extensions,
        [
            kept(ExtensionKind::Include, "<include file='a.xodr'/>"),
            kept(ExtensionKind::UserData, "<userData code='c'/>"),
        ]
    );
    // A folder may be given.
    let folder = TempDir::new().expect("a folder");
    write(folder.path(), &[("a.xodr", b"<OpenDRIVE><road id='0'/></OpenDRIVE>")]);
    let mut inputs = Inputs::new(SourceLimits::default()).with_include_folder(folder.path());
    let source = inputs.open(Box::new(text.as_bytes()), "memory");
    let read = finish(Reader::with_source(inputs, source, Limits::default()));
    assert_eq!(read.names, ["header", "0", "1"]);
    assert_eq!(read.extensions, [kept(ExtensionKind::UserData, "<userData code='c'/>")]);
}
