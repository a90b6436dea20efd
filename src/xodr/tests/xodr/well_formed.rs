//! Small documents, and what is not well-formed in each, with its place. libxml2 gives the same verdicts but where
//! `tests/differential/well_formed.py` lists the difference.

use mapd_xodr::Limits;
use mapd_xodr::source::{Inputs, SourceLimits};
use mapd_xodr::well_formed::{Fault, Scan, scan};

fn read(document: &[u8], limits: &Limits) -> Scan {
    let source = Inputs::new(SourceLimits::default()).open(Box::new(document), "");
    scan(source, limits).expect("memory does not fail")
}

#[track_caller]
fn check(document: &str, expected: &[(u64, Fault)]) {
    let scan = read(document.as_bytes(), &Limits::default());
    assert_eq!(scan.faults, expected, "{document}");
    assert_eq!(scan.refusal, None, "{document}");
    let bad = expected.iter().any(|(_, fault)| fault.severity() == mapd_xodr::Severity::Error);
    assert_eq!(scan.is_well_formed(), !bad, "{document}");
}

#[test]
fn sound_documents() {
    for document in [
        "<a/>",
        "<?xml version='1.0' encoding='UTF-8' standalone='yes'?>\n<!-- - -->\n<a/>\n<?pi?><!---->\n",
        "<?xml version=\"1.1\" ?><a></a >",
        "<a b = '1'\n\tc\n=\n\"2\" />",
        "<a b='>' c='\"' d=\"'\">></a>",
        "<a>]] ]> &amp;&lt;&gt;&quot;&apos;&#65;&#x1F6E3;<![CDATA[ ]] < & ]]></a>",
        "<\u{e4} \u{f6}\u{b7}='\u{20ac}'/>",
        "<x:a y:b='1' xmlns:x='u'/>",
        "<a><?xml-stylesheet x?></a>",
        "\n",
    ] {
        let expected: &[_] = if document == "\n" { &[(1, Fault::NoRoot)] } else { &[] };
        check(document, expected);
    }
}

#[test]
fn tags() {
    use Fault::*;
    check("<a b='1'c='2'/>", &[(8, NoSpace)]);
    check("<a b='1'b='2'/>", &[(8, NoSpace), (8, Duplicate)]);
    check("<a b='1' c='2' b='3'/>", &[(15, Duplicate)]);
    check("<a b/>", &[(3, NoValue)]);
    check("<a b c='1'/>", &[(3, NoValue)]);
    check("<a b=/>", &[(3, NoValue)]);
    check("<a b=1 c='2'/>", &[(5, NoQuotes)]);
    check("<a b='<' c='&'/>", &[(6, LessThan), (12, Ampersand)]);
    check(
        "<a b='&x; &#0; &#xD800; &amp'/>",
        &[(6, Entity), (10, CharacterReference), (15, CharacterReference), (24, Ampersand)],
    );
    check("<a 1='2' -b='3' c='4'/>", &[(3, Name), (9, Name)]);
    check("<a b='1' / >x</a>", &[(9, Name)]);
    check("<1/>", &[(1, Name)]);
    check("<a></1></a>", &[(3, Mismatch)]);
    check("< a/>", &[(1, Name), (2, NoValue)]);
    check("<a \u{d7}='1'/>", &[(3, Name)]);
    check("<a \u{b7}='1'/>", &[(3, Name)]);
    check("<a ='1'/>", &[(3, Name)]);
}

#[test]
fn text_and_markup() {
    use Fault::*;
    check("<a>]]></a>", &[(3, SectionEnd)]);
    check("<a>& b</a>", &[(3, Ampersand)]);
    check("<a>&b</a>", &[(3, Ampersand)]);
    check("<a>&b;</a>", &[(3, Entity)]);
    check("<a>&#1;</a>", &[(3, CharacterReference)]);
    check("<a>&;</a>", &[(3, Ampersand)]);
    check("<a><!-- -- --></a>", &[(8, Hyphens)]);
    check("<a><!-- ---></a>", &[(8, Hyphens)]);
    check("<a><?XML x?></a>", &[(5, ReservedTarget)]);
    check("<a><?1?></a>", &[(5, Name)]);
    check("<a><? x?></a>", &[(5, Name)]);
    check("<a><!x></a>", &[(3, UnknownMarkup)]);
}

#[test]
fn the_order_of_parts() {
    use Fault::*;
    check("<a/><b/>", &[(4, SecondRoot)]);
    check("<a></a><b></b>", &[(7, SecondRoot)]);
    check("<a/> x", &[(5, TextOutside)]);
    check("<a/>&amp;", &[(4, TextOutside)]);
    check("<a/><![CDATA[]]>", &[(4, TextOutside)]);
    check("<!-- --><![CDATA[]]><a/>", &[(8, TextOutside)]);
    check("", &[(0, NoRoot)]);
    check("<!-- -->", &[(8, NoRoot)]);
    check("<a>", &[(3, Unclosed)]);
    check("<a><b></b>", &[(10, Unclosed)]);
    check("<a></b>", &[(3, Mismatch)]);
    check("</a>", &[(0, Mismatch)]);
    check("<a/></a>", &[(4, Mismatch)]);
    for cut in ["<a", "<a b='", "<!-- ", "<?pi", "<a><![CDATA[", "<!DOCTYPE a", "<a><"] {
        let start = cut.rfind('<').unwrap_or_default() as u64;
        check(cut, &[(start, Truncated)]);
    }
}

#[test]
fn declarations_and_document_types() {
    use Fault::*;
    check("\n<?xml version='1.0'?><a/>", &[(1, LateDeclaration)]);
    check("<!-- --><?xml version='1.0'?><a/>", &[(8, LateDeclaration)]);
    check("<?xml version='1.0'?><?xml version='1.0'?><a/>", &[(21, ReservedTarget)]);
    check("<a/><?xml version='1.0'?>", &[(4, ReservedTarget)]);
    check("<a><?xml version='1.0'?></a>", &[(3, ReservedTarget)]);
    for content in [
        "",
        " ",
        " encoding='utf-8'",
        " version='2.0'",
        " version='1.'",
        " version='1.0' x='y'",
        " standalone='yes' version='1.0'",
        " version='1.0' standalone='maybe'",
        " version='1.0' standalone='no' encoding='utf-8'",
    ] {
        check(&format!("<?xml{content}?><a/>"), &[(2, Declaration)]);
    }
    check("<?xml version='1.0'encoding='utf-8'?><a/>", &[(19, NoSpace)]);
    check("<!DOCTYPE a><a/>", &[(0, DocumentType)]);
    check("<!DOCTYPE a SYSTEM 'http://x/a.dtd'><a/>", &[(0, DocumentType)]);
    check("<!DOCTYPE a [<!ENTITY e 'x'>]><a>&e;</a>", &[(0, InternalSubset), (33, Entity)]);
    check(
        "<!DOCTYPE a><!DOCTYPE a><a/>",
        &[(0, DocumentType), (12, MisplacedDocumentType), (12, DocumentType)],
    );
    check("<a/><!DOCTYPE a>", &[(4, MisplacedDocumentType), (4, DocumentType)]);
    check("<!DOCTYPE a PUBLIC 'a' \"b.dtd\" ><a/>", &[(0, DocumentType)]);
    check("<!doctype a><a/>", &[(0, UnknownMarkup)]);
    check("<!DOCTYPEa><a/>", &[(0, UnknownMarkup)]);
}

#[test]
fn places_count_from_the_text_behind_the_byte_order_mark() {
    check("\u{feff}<a b/>", &[(3, Fault::NoValue)]);
    let scan = read(b"junk<a b/>", &Limits::default());
    assert_eq!(scan.faults, [(7, Fault::NoValue)]);
}

#[test]
fn hostile_sizes() {
    let limits = Limits { depth: 10, ..Limits::default() };
    assert_eq!(read("<a>".repeat(100_000).as_bytes(), &limits).too_deep, Some(30));
    let tag = format!("<a {}/>", "b='' ".repeat(100_000));
    let scan = read(tag.as_bytes(), &Limits::default());
    assert_eq!(scan.faults.len(), 1000);
    let long = format!("<a b='{}'/>", "x".repeat(3 << 20));
    assert!(read(long.as_bytes(), &Limits::default()).refusal.is_some());
    let many = format!("<a>{}</a>", "&x;".repeat(200_000));
    assert_eq!(read(many.as_bytes(), &Limits::default()).faults.len(), 1000);
}

#[test]
fn every_fault_says_what_was_expected() {
    assert_eq!(Fault::NoSpace.to_string(), "expected white space before an attribute, found none");
}
