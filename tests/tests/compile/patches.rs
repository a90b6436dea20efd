//! Patches: roads and junctions that take the place of others while a map is compiled.

use mapd_archive::{AlignedBytes, directory, encode};
use mapd_client::{Map, Snapshot};
use mapd_compiler::{Compilation, CompileOptions, Extra, ReadOptions, Verdict, compile_from};
use mapd_tests::maps::carried_and;
use mapd_tests::town::town;
use mapd_xodr::source::{Inputs, SourceLimits};
use mapd_xodr::{Patch, PatchError, PatchedId};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn compiled(text: &str, patch: Option<Patch>) -> std::io::Result<Compilation> {
    let reading = ReadOptions { patch: patch.map(Arc::new), ..ReadOptions::default() };
    // What comes from which file is not the map's.
    let without = [Extra::Includes].into_iter().collect();
    let options = CompileOptions { without, ..CompileOptions::default() };
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {})
}

/// The file is read again when all is hashed, so it must be there.
fn patch(folder: &Path, text: &str, removed: &[&str]) -> Result<Patch, PatchError> {
    let file = folder.join("patch.xodr");
    std::fs::write(&file, text).expect("written");
    let ids = removed.iter().map(|id| id.parse::<PatchedId>().expect("an id")).collect();
    Patch::removing(ids).with_document(file, text.as_bytes().to_vec())
}

fn archive(compiled: &Compilation) -> AlignedBytes {
    let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    encode(rows, &compiled.provenance).expect("encodes")
}

/// Where a top-level element begins and ends.
fn element(text: &str, name: &str, id: &str) -> (usize, usize) {
    let (open, id) = (format!("<{name} "), format!(" id=\"{id}\""));
    let mut at = 0;
    loop {
        at += text[at..].find(&open).expect("the element");
        let end = at + text[at..].find('>').expect("its end");
        if text[at..end].contains(&id) {
            let close = format!("</{name}>");
            return (at, at + text[at..].find(&close).expect("its end") + close.len());
        }
        at = end;
    }
}

/// A document with these elements of another at the lines and columns where they stood.
fn only(text: &str, elements: &[(usize, usize)]) -> String {
    let begin = text.find("<OpenDRIVE").expect("the root");
    let begin = begin + text[begin..].find('>').expect("its end") + 1;
    let end = text.rfind("</OpenDRIVE").expect("the root's end");
    let is_kept = |at: usize| {
        at < begin || at >= end || elements.iter().any(|(from, to)| (*from..*to).contains(&at))
    };
    let blank = |(at, byte): (usize, u8)| match byte {
        b'\n' => b'\n',
        byte if is_kept(at) => byte,
        _ => b' ',
    };
    String::from_utf8(text.bytes().enumerate().map(blank).collect()).expect("UTF-8")
}

/// Number of the table of edges, which tells the file that each link comes from.
const EDGES: u32 = 40;

/// A patch that has what the map has already changes nothing of the map.
#[test]
fn what_is_replaced_by_itself_is_the_same() {
    for file in carried_and(&["carla/Town05", "esmini/multi_intersections"]) {
        let Ok(text) = std::fs::read_to_string(&file) else { continue };
        let snapshot = Snapshot::from_bytes(archive(&compiled(&text, None).expect("compiles")));
        let snapshot = snapshot.expect("opens");
        let map = snapshot.map();
        let roads = map.roads().step_by(3).map(|road| element(&text, "road", road.id()));
        let own = map.junctions().step_by(2).map(|one| element(&text, "junction", one.id()));
        let elements: Vec<_> = roads.chain(own).collect();
        let folder = tempfile::tempdir().expect("a folder");
        let own = patch(folder.path(), &only(&text, &elements), &[]).expect("a patch");
        let [plain, patched] = [None, Some(own)].map(|p| compiled(&text, p).expect("compiles"));
        let places = |compiled: &Compilation| {
            let all = compiled.diagnostics.iter();
            let mut all: Vec<_> =
                all.map(|d| (d.line, d.column, d.finding.message.clone())).collect();
            all.sort();
            all
        };
        assert_eq!(places(&plain), places(&patched), "{}", file.display());
        let [a, b] = [&plain, &patched].map(archive);
        let [of_a, of_b] = [&a, &b].map(|bytes| directory(bytes).expect("a directory"));
        for (one, other) in of_a.iter().zip(&of_b) {
            assert_eq!((one.number, one.row_bytes), (other.number, other.row_bytes));
            if one.number == EDGES {
                continue;
            }
            let bytes = |bytes: &[u8], of: &mapd_archive::TableEntry| {
                let from = of.offset as usize;
                bytes[from..from + (of.count * u64::from(of.row_bytes)) as usize].to_vec()
            };
            let is_equal = bytes(&a, one) == bytes(&b, other);
            assert!(is_equal, "{}: table {}", file.display(), one.number);
        }
        let edges = |map: Map<'_>| -> Vec<_> {
            let edges = map.lane_nodes().flat_map(|node| node.edges());
            edges.map(|e| (e.target().map(|t| t.s_range()), e.source_position())).collect()
        };
        let patched = Snapshot::from_bytes(b).expect("opens");
        assert_eq!(edges(map), edges(patched.map()), "{}", file.display());
    }
}

fn codes(compiled: &Compilation, file: &str) -> Vec<(u32, u32, String)> {
    let own = compiled.diagnostics.iter().filter(|one| one.file.ends_with(file));
    own.map(|one| (one.line, one.column, one.finding.message.clone())).collect()
}

/// A road that is shifted, one that is new, one that goes.
#[test]
fn replaced_added_removed() {
    let text = town(3, 3);
    let folder = tempfile::tempdir().expect("a folder");
    let (from, to) = element(&text, "road", "1");
    let road = &text[from..to];
    let wider = road.replace("a=\"3.5\"", "a=\"4.5\"");
    assert_ne!(road, wider);
    let new = road.replace(" id=\"1\"", " id=\"777\"");
    let link = new.find("<link>").zip(new.find("</link>"));
    let (a, b) = link.expect("links");
    let new =
        format!("{}{}", &new[..a], &new[b + "</link>".len()..]).replace(" y=\"0", " y=\"-900");
    let document = format!("<OpenDRIVE>\n<!-- <road id=\"2\"/> -->\n{wider}{new}</OpenDRIVE>");
    let own = patch(folder.path(), &document, &[]).expect("a patch");
    let found = compiled(&text, Some(own)).expect("compiles");
    let snapshot = Snapshot::from_bytes(archive(&found)).expect("opens");
    let map = snapshot.map();
    let width = |id: &str| {
        let told = codes(&found, "");
        let road = map.road_by_id(id).unwrap_or_else(|| panic!("no road {id}: {told:?}"));
        let section = road.section(0).expect("a section");
        section.lane(-1).expect("a lane").width_at(10.0)
    };
    assert_eq!((width("1"), width("2")), (4.5, 3.5));
    assert!((width("777") - 3.5).abs() < 1e-9);
    let plain = compiled(&text, None).expect("compiles");
    let roads = |found: &Compilation| found.rows.as_ref().expect("rows").roads.len();
    assert_eq!(roads(&found), roads(&plain) + 1);
    assert_eq!(found.included, [folder.path().join("patch.xodr")]);

    // What a road that is gone leaves is told: links to it, and what is left out for it.
    let gone = compiled(&text, Some(Patch::removing(vec!["road:1".parse().expect("an id")])));
    let gone = gone.expect("compiles");
    let told: Vec<_> = codes(&gone, "");
    assert!(told.len() > codes(&plain, "").len(), "{told:?}");
    assert_eq!(gone.quarantined.is_empty(), gone.verdict == Verdict::Accepted, "never silent");
    assert_eq!(roads(&gone) + gone.quarantined.len(), roads(&plain) - 1, "{:?}", gone.quarantined);
}

/// What is wrong in a patch is told by its line and column, as are findings on what it has; what does not fit the map is an error.
#[test]
fn what_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let check = |text: &str, removed: &[&str], expected: &str| {
        let error = patch(folder.path(), text, removed).expect_err(text).to_string();
        assert!(error.contains(expected), "{text}: {error}");
    };
    check("", &[], "patch.xodr:1:1: ends");
    check("<OpenDRIVE>", &[], ":1:12: ends");
    check("<OpenDRIVE>\n <road", &[], ":2:7: ends");
    check("<road id=\"1\"/>", &[], ":1:1: expected one element OpenDRIVE");
    check("<OpenDRIVE/><OpenDRIVE/>", &[], ":1:13: expected one");
    check("<OpenDRIVE>\n  <controller id=\"1\"/></OpenDRIVE>", &[], ":2:3: a patch has roads");
    check("<OpenDRIVE><road/></OpenDRIVE>", &[], ":1:12: has no id");
    check("<OpenDRIVE><road id='a'/>\n<road id=\"a\"/></OpenDRIVE>", &[], ":2:1: a second road:a");
    check("<OpenDRIVE><road id='a'></junction></OpenDRIVE>", &[], ":1:25: the end of what");
    check("<OpenDRIVE><road id='a'/></OpenDRIVE>", &["road:a"], "road:a is to be removed");
    for wrong in ["road", "road:", "lane:1", ""] {
        assert!(wrong.parse::<PatchedId>().is_err(), "{wrong}");
    }
    let text = town(2, 2);
    let none = Patch::removing(vec!["junction:none".parse().expect("an id")]);
    let error = compiled(&text, Some(none)).err().expect("not there");
    assert!(error.to_string().contains("no junction:none to remove"), "{error}");
    // A finding on what the patch has: in the patch, where it stands.
    let (from, to) = element(&text, "road", "1");
    let broken = text[from..to].replacen("length=\"", "length=\"-", 1);
    let own = patch(folder.path(), &format!("<OpenDRIVE>\n\n   {broken}</OpenDRIVE>"), &[]);
    let found = compiled(&text, Some(own.expect("a patch"))).expect("compiles");
    let told = codes(&found, "patch.xodr");
    assert!(told.iter().any(|(line, column, _)| (*line, *column) == (3, 4)), "{told:?}");
    // What stands behind it in the map is told at its place in the map.
    let second = element(&text, "road", "2").0;
    let (before, behind) = text.split_at(second);
    let broken = before.to_owned() + &behind.replacen("\"driving\"", "\"surprise\"", 1);
    let own =
        patch(folder.path(), &format!("<OpenDRIVE>\n\n{}\n</OpenDRIVE>", &text[from..to]), &[]);
    let found = compiled(&broken, Some(own.expect("a patch"))).expect("compiles");
    let plain = compiled(&broken, None).expect("compiles");
    let surprise = |found: &Compilation| {
        let mut all = found.diagnostics.iter();
        let own = all.find(|one| one.finding.message.contains("surprise")).expect("a finding");
        (own.file.to_string(), own.line, own.column)
    };
    assert_eq!(surprise(&found), surprise(&plain));
    let latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><OpenDRIVE/>";
    let nothing = Patch::removing(Vec::new());
    let error = compiled(latin, Some(nothing)).err().expect("not UTF-8").to_string();
    assert!(error.contains("only UTF-8"), "{error}");
    assert_eq!(Patch::default().file(), None::<&PathBuf>);
}

/// Hands out so many bytes at a time.
struct Slowly<'a>(&'a [u8], usize);

impl std::io::Read for Slowly<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.1.min(buffer.len());
        self.0.read(&mut buffer[..count])
    }
}

/// What stands in comments, sections of characters, instructions, values and elements of the same name within does not end an element.
#[test]
fn where_elements_end() {
    let road = "<road id=\"1\" name='>'>\n<!-- </road> --><userData><road id=\"2\"/><road id='1'>x</road ></userData>\
        <lane a='/>'/><![CDATA[</road>]]><?p </road>?><roadMark></roadMark><roads/>\
        <!----><!--<road>--><![CDATA[]]><![CDATA[<road>]]><road></road><road><road/></road><!-- > -->5\" ='<x/>\
        </road\n>";
    spliced_whole(road);
}

/// `<` in a value is a finding, and reading goes on behind the value: what stands there neither ends an element nor hides its end.
#[test]
fn where_elements_end_with_markup_in_values() {
    let tags = [
        "<a name=\"<!-- x\"/>",
        "<a name='<!-- x'></a>",
        "<a value=\"<road>\"/>",
        "<a value=\"</road>\"/>",
        "<a value = '<b c=\"1\"/> </road> <road >' d=\"<?p\"/>",
        "<a v=\"it's\" value=\"<![CDATA[\">='</a>",
        "<a v='a=' w=''/><!-- <road> --><a value='<b>><road/>'/>",
    ];
    for tag in tags {
        spliced_whole(&format!("<road id=\"1\">{tag}</road>"));
    }
    // Longer than what is read at once, so that a piece ends within a value.
    for length in [60_000, 65_000, 200_000] {
        let filler = "<lane id=\"1\"/>".repeat(length / 14);
        let value = "x".repeat(length);
        for markup in ["</road>", "<road>", "<!-- "] {
            let tag = format!("<a value='{value}{markup}{value}'/>");
            spliced_whole(&format!("<road id=\"1\">{filler}{tag}<a b='{value}</road>'/></road>"));
        }
    }
}

/// A patch for the road 1, which is this, and for the road 2 gives the text with the patch in it; all else is as it was.
fn spliced_whole(road: &str) {
    let text = format!(
        "<?xml version=\"1.0\"?><!-- <road id=\"1\"/> -->\n<OpenDRIVE><header><road id=\"1\"/></header>{road}\
         <road id=\"2\"/>\n<road id=\"3\"><a></a></road><junction id=\"1\"/></OpenDRIVE>\n<!-- end -->"
    );
    let folder = tempfile::tempdir().expect("a folder");
    let own = "<road id=\"1\"><b/></road>";
    let spliced = |prefix: &str, step: usize| {
        let named = |text: &str| {
            text.replace("<road", &format!("<{prefix}road"))
                .replace("</road", &format!("</{prefix}road"))
        };
        let document = named(&format!("<OpenDRIVE>{own}</OpenDRIVE>"));
        let patch = patch(folder.path(), &document, &["road:2"]).expect("a patch");
        let mut inputs = Inputs::new(SourceLimits::default());
        let text = named(&text);
        let mut made = String::new();
        let input = Box::new(Slowly(text.as_bytes(), step));
        let mut source = inputs.open_patched(input, "map.xodr", &patch);
        source.read_to_string(&mut made).expect("reads");
        let [gone, new] = [road, own].map(named);
        assert!(text.contains(&gone), "{road}");
        let expected = text.replace(&gone, &new).replace(&named("<road id=\"2\"/>\n"), "\n");
        assert!(made == expected, "{prefix}, {step}: {:.1000}\n{made:.1000}", text);
        let third = named("<road id=\"3\">");
        let [at, before] = [&made, &text].map(|text| text.find(&third).expect("the third"));
        let lines = text[..before].matches('\n').count() as u32;
        let position = inputs.places().position(at as u64);
        assert_eq!((position.line, position.column), (lines + 1, 1), "{prefix}, {step}");
    };
    for (prefix, step) in [("", usize::MAX), ("", 1), ("", 7), ("o:", usize::MAX), ("o:", 3)] {
        spliced(prefix, step);
    }
}

/// What an input has wrong as bytes is told with a patch as without, and all places before the first patched element are those of the file.
#[test]
fn text_before_the_declaration_and_encodings() {
    let town = town(2, 2).replacen("\"driving\"", "\"surprise\"", 1);
    let body = &town[town.find("<OpenDRIVE").expect("the root")..];
    let (from, to) = element(body, "road", "2");
    let folder = tempfile::tempdir().expect("a folder");
    let own = || patch(folder.path(), &only(body, &[(from, to)]), &[]).expect("a patch");
    let latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n";
    let ascii = "<?xml version=\"1.0\" encoding=\"US-ASCII\"?>\n";
    let wide = "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n";
    let starts = [
        ("".to_owned(), 0),
        ("\n\n one\ntwo ".to_owned(), 1),
        (format!("'junk\n\n\" {ascii}"), 1),
        (format!("\u{feff}{latin}"), 1),
        (format!("\u{feff}\u{feff}{ascii}"), 1),
        (wide.to_owned(), 1),
    ];
    let named = body.replacen("id=\"1\"", "id=\"1\" name=\"\u{e9}\u{1}\"", 1);
    for (start, notes) in starts {
        let text = start.clone() + &named;
        let told = |patch: Option<Patch>| {
            let found = compiled(&text, patch).expect("compiles");
            let all = found.diagnostics.iter();
            let mut all: Vec<_> =
                all.map(|d| (d.line, d.column, d.finding.message.clone())).collect();
            all.sort();
            all
        };
        let plain = told(None);
        let own_notes = plain.iter().filter(|(_, _, told)| {
            told.contains("passed over") || told.contains("declared encoding")
        });
        assert_eq!(own_notes.count(), notes, "{start:?}: {plain:?}");
        assert!(plain.iter().any(|(_, _, told)| told.contains("surprise")), "{start:?}");
        assert_eq!(plain, told(Some(Patch::removing(Vec::new()))), "{start:?}");
        let patched = told(Some(own()));
        let lines = body[..from].matches('\n').count();
        let before = |all: &[(u32, u32, String)]| -> Vec<_> {
            let until = (start.matches('\n').count() + lines) as u32;
            all.iter().filter(|(line, ..)| *line <= until).cloned().collect()
        };
        assert_eq!(before(&plain), before(&patched), "{start:?}");
    }
}
