//! What is wrong in small documents, and exactly where. `¦` marks the place of the finding.

use Severity::{Error, Info, Warning};
use mapd_xodr::{Finding, Item, Limits, Reader, Severity, rule_ids as rule};

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
            let at = reader.position(finding.span.start);
            findings.push((finding.rule, finding.severity, at.line, at.column));
            raw.push(finding);
        }
        match item {
            Some(item) => items.push(item),
            None => return Read { items, findings, raw },
        }
    }
}

const PLAN: &str = "<planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><line/></geometry></planView>";
const LANES: &str = "<lanes><laneSection s=\"0\"><center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"driving\"><width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes>";

/// A sound document of 1.8 with one road; each pair is a text in it and what to put in its place.
fn document(changes: &[(&str, &str)]) -> String {
    let mut text = format!(
        "<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"8\"/>\n<road id=\"1\" length=\"10\" junction=\"-1\">\n{PLAN}\n{LANES}\n</road>\n</OpenDRIVE>"
    );
    for (from, to) in changes {
        assert!(text.contains(from), "{from} is not in {text}");
        text = text.replacen(from, to, 1);
    }
    text
}

/// A document that must have one finding and no other, at the mark.
fn check(marked: &str, expected: (&str, Severity)) {
    let at = marked.find('¦').unwrap_or_else(|| panic!("no mark in {marked}"));
    let text = marked.replacen('¦', "", 1);
    let line = text[..at].matches('\n').count() + 1;
    let column = at - text[..at].rfind('\n').map_or(0, |end| end + 1) + 1;
    let found = read(text.as_bytes());
    let expected = (expected.0, expected.1, line as u32, column as u32);
    assert_eq!(found.findings, [expected], "{marked}\n{:#?}", found.raw);
}

#[test]
fn a_sound_document_has_no_findings() {
    let read = read(document(&[]).as_bytes());
    assert!(read.findings.is_empty(), "{:?}", read.raw);
    assert_eq!(read.items.len(), 2);
}

#[test]
fn values() {
    for (value, rule, severity) in [
        ("¦nan", rule::FINITE, Error),
        ("¦INF", rule::FINITE, Error),
        ("¦1e999", rule::FINITE, Error),
        ("¦abc", rule::VALUE, Error),
        ("¦3.5 m", rule::VALUE, Error),
        ("¦0x10", rule::VALUE, Error),
        ("¦1,500", rule::VALUE, Error),
        ("¦4.0+0", rule::LEXICAL, Warning),
        ("¦1,5", rule::LEXICAL, Warning),
        ("¦", rule::EMPTY, Error),
        ("¦ 1 ", rule::SPACE, Info),
        ("¦-1", rule::RANGE, Error),
    ] {
        let geometry = format!("<geometry s=\"{value}\"");
        check(&document(&[("<geometry s=\"0\"", &geometry)]), (rule, severity));
    }
    let changes = [
        ("revMinor=\"8\"", "revMinor=\"8\" north=\"¦\"", rule::EMPTY, Warning),
        ("length=\"10\" j", "length=\"¦0\" j", rule::RANGE, Error),
        ("junction=\"-1\"", "junction=\"-1\" rule=\"¦UP\"", rule::ENUMERATION, Error),
        ("type=\"driving\"", "type=\"¦sky\"", rule::ENUMERATION, Error),
        ("type=\"driving\"", "type=\"¦ driving\"", rule::SPACE, Info),
        ("type=\"driving\"", "type=\"driving\" level=\"¦1\"", rule::LEXICAL, Warning),
        ("type=\"driving\"", "type=\"driving\" level=\"¦maybe\"", rule::VALUE, Error),
        ("id=\"-1\"", "id=\"¦0\"", rule::RANGE, Error),
        ("id=\"-1\"", "id=\"¦1.5\"", rule::VALUE, Error),
        ("id=\"-1\"", "id=\"¦-3000000000\"", rule::RANGE, Error),
    ];
    for (from, to, rule, severity) in changes {
        check(&document(&[(from, to)]), (rule, severity));
    }
}

#[test]
fn structure() {
    let planview = "<planView>";
    let changes = [
        (" length=\"10\" j", " j", "<road", rule::MISSING, Error),
        (PLAN, "", "<road", rule::ELEMENT, Error),
        (LANES, "", "<road", rule::ELEMENT, Error),
        ("<line/>", "", "<geometry", rule::CHOICE, Error),
        ("<line/>", "<line/><arc curvature=\"0\"/>", "<geometry", rule::CHOICE, Error),
        ("<line/>", "<line/><line/>", "", rule::OCCURRENCE, Error),
        ("id=\"1\"", "id=\"1\" colour=\"¦red\"", "", rule::UNKNOWN_ATTRIBUTE, Warning),
        (planview, "¦<tree/><planView>", "", rule::UNKNOWN_ELEMENT, Warning),
        (planview, "¦text<planView>", "", rule::TEXT, Warning),
        (planview, "¦<![CDATA[text]]><planView>", "", rule::TEXT, Warning),
        ("<lane id=\"0\"/>", "<lane id=\"0\" type=\"¦none\"/>", "", rule::DEPRECATED, Info),
    ];
    for (from, to, place, rule, severity) in changes {
        let mut text = document(&[(from, to)]);
        if rule == rule::OCCURRENCE {
            text = text.replacen("<line/><line/>", "<line/>¦<line/>", 1);
        } else if !place.is_empty() {
            text = text.replacen(place, &format!("¦{place}"), 1);
        }
        check(&text, (rule, severity));
    }
    let swapped = document(&[(PLAN, ""), (LANES, &format!("{LANES}¦{PLAN}"))]);
    check(&swapped, (rule::ORDER, Warning));
    let no_road = "¦<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"7\"/></OpenDRIVE>";
    check(no_road, (rule::ELEMENT, Error));
}

#[test]
fn versions() {
    let minor = |minor: &str| format!("revMinor=\"{minor}\"");
    let of = |number: &str, from: &str, to: &str| {
        document(&[("revMinor=\"8\"", &minor(number)), (from, to)])
    };
    let center = "<lane id=\"0\"/>";
    let typed = "<lane id=\"0\" type=\"none\"/>";
    for (text, rule, severity) in [
        (of("4", "id=\"1\"", "id=\"1\" rule=\"¦RHT\""), rule::OTHER_VERSION, Warning),
        (of("7", center, "¦<lane id=\"0\"/>"), rule::MISSING, Error),
        (
            of("7", "type=\"driving\"", "type=\"driving\" direction=\"¦both\"")
                .replace(center, typed),
            rule::OTHER_VERSION,
            Warning,
        ),
        (
            of("6", "type=\"driving\"", "type=\"¦slipLane\"").replace(center, typed),
            rule::OTHER_VERSION,
            Warning,
        ),
    ] {
        check(&text, (rule, severity));
    }
    for unknown in ["3", "10", "99"] {
        let text = of(unknown, "<header", "¦<header");
        let found = read(text.replacen('¦', "", 1).as_bytes()).findings;
        assert_eq!(found[0], (rule::VERSION, Warning, 2, 1), "{unknown}");
    }
}

#[test]
fn variants_and_what_only_the_text_requires() {
    let junction = |text: &str| document(&[("</road>\n", &format!("</road>\n{text}\n"))]);
    let link = "<laneLink from=\"-1\" to=\"-1\"/></connection></junction>";
    for (text, rule) in [
        (
            "<junction id=\"5\" type=\"direct\"><connection id=\"0\" incomingRoad=\"1\" linkedRoad=\"1\" connectingRoad=\"¦1\" contactPoint=\"start\">",
            rule::VARIANT,
        ),
        (
            "<junction id=\"5\" type=\"direct\">¦<connection id=\"0\" incomingRoad=\"1\" contactPoint=\"start\">",
            rule::MISSING,
        ),
        (
            "<junction id=\"5\" mainRoad=\"¦1\"><connection id=\"0\" incomingRoad=\"1\" connectingRoad=\"1\" contactPoint=\"start\">",
            rule::VARIANT,
        ),
        (
            "<junction id=\"5\">¦<connection id=\"0\" incomingRoad=\"1\" contactPoint=\"start\">",
            rule::MISSING,
        ),
    ] {
        check(&junction(&format!("{text}{link}")), (rule, Warning));
    }
}

#[test]
fn documents_that_are_not_well_formed() {
    for (text, rule, line, column) in [
        ("", rule::ROOT, 1, 1),
        ("<Map/>", rule::ROOT, 1, 1),
        ("<OpenDRIVE>\n<header", rule::XML, 2, 1),
        ("<OpenDRIVE>\n<header>", rule::XML, 2, 9),
        ("<OpenDRIVE>\n<header></road>", rule::XML, 2, 9),
        ("<OpenDRIVE>\n<header a=1/>", rule::XML, 2, 11),
        ("<OpenDRIVE a=\"1\" a=\"2\"/>", rule::XML, 1, 18),
        ("<OpenDRIVE>\n&nbsp;</OpenDRIVE>", rule::XML, 2, 1),
        ("<OpenDRIVE/>\n<OpenDRIVE/>", rule::XML, 2, 1),
    ] {
        let found = read(text.as_bytes()).findings;
        assert!(found.contains(&(rule, Error, line, column)), "{text:?}: {found:?}");
    }
    for text in [&b"\xff\xfeO\0"[..], b"<OpenDRIVE>\xff</OpenDRIVE>", b"<OpenDRIVE a=\"\xff\"/>"] {
        assert!(read(text).findings.iter().any(|f| f.1 == Error), "{text:?}");
    }
}

/// The reader once gave a document type without its beginning to what looks at it, which then knew none.
#[test]
fn document_types_are_warnings() {
    let body = document(&[]);
    for kind in [" OpenDRIVE", "\nOpenDRIVE SYSTEM 'a.dtd'", " OpenDRIVE PUBLIC \"a\" \"b.dtd\" "] {
        check(&format!("¦<!DOCTYPE{kind}>{body}"), (rule::XML, Warning));
    }
    for bad in
        ["<!DOCTYPE>", "<!DOCTYPEOpenDRIVE>", "<!DOCTYPE 1>", "<!DOCTYPE a [<!ENTITY b 'c'>]>"]
    {
        check(&format!("¦{bad}{body}"), (rule::XML, Error));
    }
}

#[test]
fn what_stands_before_the_declaration_is_read_over() {
    let text = format!(" <?xml version=\"1.0\"?>\n{}", document(&[]));
    let read_text = read(text.as_bytes());
    assert_eq!(read_text.items.len(), 2, "{:?}", read_text.raw);
    assert_eq!(read_text.findings, [(rule::BEFORE_DECLARATION, Warning, 1, 2)]);
}

#[test]
fn namespaces_and_what_lies_beyond_the_standard() {
    let text = "<o:OpenDRIVE xmlns:o=\"http://www.opendrive.org\"><o:header revMajor=\"1\" revMinor=\"7\"/><x:road id=\"9\"/><o:userData code=\"a\"><road id=\"8\"/></o:userData></o:OpenDRIVE>";
    let found = read(text.as_bytes());
    assert_eq!(found.items.len(), 1, "{:?}", found.items);
    let road = document(&[(
        "<planView>",
        "<userData code=\"a\" value=\"1\"><x a='>'/></userData><planView>",
    )]);
    let found = read(road.as_bytes());
    let Some(Item::Road(road)) = found.items.get(1) else { panic!("{:?}", found.items) };
    let [kept] = road.extensions.as_slice() else { panic!("{:?}", road.extensions) };
    assert_eq!(&*kept.text, "<userData code=\"a\" value=\"1\"><x a='>'/></userData>");
}

#[test]
fn hostile_sizes_are_refused() {
    let deep = format!("<OpenDRIVE>{}", "<a>".repeat(100_000));
    assert!(read(deep.as_bytes()).findings.iter().any(|f| f.0 == rule::LIMIT));
    let wide = format!("<OpenDRIVE a=\"{}\"/>", "x".repeat(5 << 20));
    assert!(read(wide.as_bytes()).findings.iter().any(|f| f.0 == rule::LIMIT));
}

#[test]
fn many_findings_of_a_kind_are_counted() {
    let limits = Limits { findings_of_a_kind: 3, ..Limits::default() };
    let text = document(&[("<line/>", &format!("<line/>{}", "<tree/>".repeat(10)))]);
    let mut reader = Reader::new(text.as_bytes(), limits);
    while reader.next().expect("reading works").is_some() {}
    let found = reader.take_findings();
    assert_eq!(found.len(), 4, "{found:?}");
    assert!(found[3].message.starts_with("7 more"), "{found:?}");
    assert_eq!(found.iter().map(|finding| finding.count).sum::<u32>(), 10);
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
        let found = reader.position(offset as u64);
        assert_eq!((found.line as usize, found.column as usize), (line, column), "offset {offset}");
    }
}
