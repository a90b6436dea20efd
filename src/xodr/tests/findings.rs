//! What is wrong in small documents, and exactly where.

use mapd_xodr::{Finding, Item, Limits, Reader, Severity, rule_ids};

struct Read {
    items: Vec<Item>,
    /// Rule, severity, line, column.
    findings: Vec<(&'static str, Severity, u32, u32)>,
    raw: Vec<Finding>,
}

fn read(text: &[u8]) -> Read {
    let mut reader = Reader::new(text, Limits::default());
    let (mut items, mut findings, mut raw) = (Vec::new(), Vec::new(), Vec::new());
    loop {
        let item = reader.next().expect("reading from memory works");
        for finding in reader.take_findings() {
            let at = reader.line_index().position(finding.span.start);
            findings.push((finding.rule, finding.severity, at.line, at.column));
            raw.push(finding);
        }
        match item {
            Some(item) => items.push(item),
            None => return Read { items, findings, raw },
        }
    }
}

/// A document whose road has `inner`; `inner` begins at line 2, column 28.
fn road(inner: &str) -> String {
    format!(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>\n<road id=\"1\" length=\"10\">  {inner}</road></OpenDRIVE>"
    )
}

const PLAN: &str = "<planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><line/></geometry></planView>";
const LANES: &str = "<lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center></laneSection></lanes>";

/// A document with one thing wrong, and the finding that must come first.
fn check(text: &str, expected: (&'static str, Severity, u32, u32)) {
    let found = read(text.as_bytes()).findings;
    assert_eq!(found.first(), Some(&expected), "{text}\n{found:?}");
}

#[test]
fn a_sound_document_has_no_findings() {
    let read = read(road(&format!("{PLAN}{LANES}")).as_bytes());
    assert!(read.findings.is_empty(), "{:?}", read.raw);
    assert_eq!(read.items.len(), 2);
}

#[test]
fn values_that_are_no_numbers() {
    use Severity::{Error, Warning};
    for (value, expected) in [
        ("nan", (rule_ids::FINITE, Error, 2, 55)),
        ("INF", (rule_ids::FINITE, Error, 2, 55)),
        ("abc", (rule_ids::VALUE, Error, 2, 55)),
        ("4.0+0", (rule_ids::VALUE, Error, 2, 55)),
        ("1,5", (rule_ids::VALUE, Error, 2, 55)),
        ("0x10", (rule_ids::VALUE, Error, 2, 55)),
        ("", (rule_ids::VALUE, Error, 2, 55)),
        (" 1 ", (rule_ids::SPACE, Warning, 2, 55)),
    ] {
        let plan = PLAN.replacen("s=\"0\"", &format!("s=\"{value}\""), 1);
        let text = road(&format!("{plan}{LANES}")).replace("length=\"10\">  <", "length=\"10\"><");
        let (rule, severity, line, _) = expected;
        let place =
            text.lines().nth(1).and_then(|l| l.find("geometry s=\"")).expect("the value") + 13;
        check(&text, (rule, severity, line, place as u32));
    }
}

#[test]
fn what_is_missing_or_unknown() {
    use Severity::{Error, Warning};
    check(&road(LANES), (rule_ids::ELEMENT, Error, 2, 1));
    check(&road(PLAN), (rule_ids::ELEMENT, Error, 2, 1));
    let no_length = road(&format!("{PLAN}{LANES}")).replacen(" length=\"10\"", "", 1);
    check(&no_length, (rule_ids::MISSING, Error, 2, 1));
    let rule = road(&format!("{PLAN}{LANES}")).replacen("id=\"1\"", "id=\"1\" rule=\"UP\"", 1);
    check(&rule, (rule_ids::ENUMERATION, Warning, 2, 20));
    let lane = road(&format!("{PLAN}{LANES}")).replacen("type=\"none\"", "type=\"sky\"", 1);
    assert_eq!(read(lane.as_bytes()).findings[0].0, rule_ids::ENUMERATION);
    check("<OpenDRIVE></OpenDRIVE>", (rule_ids::ELEMENT, Warning, 1, 1));
    check("<OpenDRIVE><header/></OpenDRIVE>", (rule_ids::VERSION, Warning, 1, 12));
}

#[test]
fn documents_that_are_not_well_formed() {
    for (text, rule, line, column) in [
        ("", rule_ids::ROOT, 1, 1),
        ("<Map/>", rule_ids::ROOT, 1, 1),
        ("text", rule_ids::XML, 1, 5),
        ("<OpenDRIVE>\n<header", rule_ids::XML, 2, 1),
        ("<OpenDRIVE>\n<header>", rule_ids::XML, 2, 9),
        ("<?xml version=\"1.0\" encoding=\"UTF-16\"?><OpenDRIVE/>", rule_ids::ENCODING, 1, 1),
    ] {
        let found = read(text.as_bytes()).findings;
        let first = found
            .iter()
            .find(|f| f.1 == Severity::Error)
            .unwrap_or_else(|| panic!("{text:?}: {found:?}"));
        assert_eq!((first.0, first.2, first.3), (rule, line, column), "{text:?}: {found:?}");
    }
    for text in [&b"\xff\xfeO\0"[..], b"<OpenDRIVE>\xff</OpenDRIVE>", b"<OpenDRIVE a=\"\xff\"/>"] {
        assert!(read(text).findings.iter().any(|f| f.1 == Severity::Error), "{text:?}");
    }
}

#[test]
fn what_stands_before_the_declaration_is_read_over() {
    let text = format!(" <?xml version=\"1.0\"?>\n{}", road(&format!("{PLAN}{LANES}")));
    let read_text = read(text.as_bytes());
    assert_eq!(read_text.items.len(), 2, "{:?}", read_text.raw);
}

#[test]
fn namespaces_and_foreign_elements() {
    let text = "<o:OpenDRIVE xmlns:o=\"u\"><o:header revMajor=\"1\" revMinor=\"7\"/><x:road id=\"9\"/><userData><road id=\"8\"/></userData></o:OpenDRIVE>";
    let read = read(text.as_bytes());
    assert_eq!(read.items.len(), 1, "{:?}", read.items);
}

#[test]
fn hostile_sizes_are_refused() {
    let deep = format!("<OpenDRIVE>{}", "<a>".repeat(100_000));
    assert!(read(deep.as_bytes()).findings.iter().any(|f| f.0 == rule_ids::LIMIT));
    let wide = format!("<OpenDRIVE a=\"{}\"/>", "x".repeat(5 << 20));
    assert!(read(wide.as_bytes()).findings.iter().any(|f| f.0 == rule_ids::LIMIT));
}

#[test]
fn no_prefix_of_a_document_upsets_the_reader() {
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/maps/one_road.xodr");
    let text = std::fs::read(map).expect("the carried map");
    let whole = text.windows(7).position(|w| w == b"</road>").expect("a road") + 7;
    for length in (0..text.len()).step_by(9).chain(whole - 9..whole) {
        let read = read(&text[..length]);
        assert!(
            read.findings.iter().any(|f| f.1 == Severity::Error),
            "a cut at {length} is not found"
        );
        assert!(
            read.items.len() < 2 || length >= whole,
            "a road that is cut off was handed out at {length}"
        );
    }
}

#[test]
fn lines_and_columns_are_those_of_the_text() {
    let mut text = String::from("<OpenDRIVE>");
    for i in 0..5000 {
        text += &"\n".repeat(1 + i % 3);
        text += &" ".repeat(i * 7 % 400);
        text += "<a/>";
    }
    let mut reader = Reader::new(text.as_bytes(), Limits::default());
    while reader.next().expect("reading works").is_some() {}
    for offset in (0..text.len()).step_by(997) {
        let before = &text[..offset];
        let line = before.matches('\n').count() + 1;
        let column = offset - before.rfind('\n').map_or(0, |at| at + 1) + 1;
        let found = reader.line_index().position(offset as u64);
        assert_eq!((found.line as usize, found.column as usize), (line, column), "offset {offset}");
    }
}
