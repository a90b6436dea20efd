//! Inputs made to exhaust memory or time. Each is read in a process of its own, whose largest memory is measured; times are
//! printed.

use flate2::{Compression, write::GzEncoder};
use mapd_xodr::source::Inputs;
use mapd_xodr::{Finding, Limits, Patch, Reader, Severity, rule_ids};
use std::io::{self, Read, Write as _};
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Memory that reading any input may take, in KiB.
const MEMORY: u64 = 100 << 10;
/// Names the bomb to a process that is to read it.
const VARIABLE: &str = "MAPD_TEST_BOMB";
const GB: u64 = 1 << 30;

/// `before`, then `piece` over and over for about `length` bytes, then `after`: made while it is read.
struct Repeat {
    before: io::Cursor<Vec<u8>>,
    block: Vec<u8>,
    place: usize,
    left: u64,
    after: io::Cursor<Vec<u8>>,
}

impl Repeat {
    fn new(before: &[u8], piece: &[u8], length: u64, after: &[u8]) -> Self {
        let block = piece.repeat((1 << 16) / piece.len() + 1);
        Self {
            before: io::Cursor::new(before.to_vec()),
            left: length / block.len() as u64 * block.len() as u64,
            block,
            place: 0,
            after: io::Cursor::new(after.to_vec()),
        }
    }
}

impl Read for Repeat {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.before.read(buffer)?;
        if count > 0 {
            return Ok(count);
        }
        if self.left == 0 {
            return self.after.read(buffer);
        }
        let count = self.block[self.place..].len().min(buffer.len());
        buffer[..count].copy_from_slice(&self.block[self.place..self.place + count]);
        self.place = (self.place + count) % self.block.len();
        self.left -= count as u64;
        Ok(count)
    }
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).expect("memory does not fail");
    encoder.finish().expect("memory does not fail")
}

/// Made of counted pieces while it is read: memory stays small however many there are.
struct Count<F> {
    next: u64,
    end: u64,
    make: F,
    block: io::Cursor<Vec<u8>>,
}

impl<F: Fn(u64) -> String> Count<F> {
    fn new(end: u64, make: F) -> Self {
        Self { next: 0, end, make, block: io::Cursor::new(Vec::new()) }
    }
}

impl<F: Fn(u64) -> String> Read for Count<F> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.block.read(buffer)?;
        if count > 0 || self.next == self.end {
            return Ok(count);
        }
        let mut block = String::new();
        while self.next < self.end && block.len() < 1 << 16 {
            block += &(self.make)(self.next);
            self.next += 1;
        }
        self.block = io::Cursor::new(block.into_bytes());
        self.block.read(buffer)
    }
}

/// Reads to the end and lets go of every element.
fn drain(mut reader: Reader<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    while reader.next().expect("the input does not fail").is_some() {
        findings.append(&mut reader.take_findings());
    }
    findings.append(&mut reader.take_findings());
    findings
}

fn read(input: impl Read + Send) -> Vec<Finding> {
    drain(Reader::new(input, Limits::default()))
}

fn read_file(path: &Path) -> Vec<Finding> {
    drain(Reader::open(path, Limits::default()).expect("it is there"))
}

/// `piece` over and over between two texts that belong around it.
fn between(before: &str, piece: &str, length: u64, after: &str) -> Vec<Finding> {
    read(Repeat::new(before.as_bytes(), piece.as_bytes(), length, after.as_bytes()))
}

/// As [`between`], with a patch that removes the road that begins before.
fn patched(before: &str, piece: &str, length: u64, after: &str) -> Vec<Finding> {
    let patch = Patch::removing(vec!["road:1".parse().expect("an id")]);
    let input = Repeat::new(before.as_bytes(), piece.as_bytes(), length, after.as_bytes());
    let limits = Limits::default();
    let mut inputs = Inputs::new(limits.source);
    let source = inputs.open_patched(Box::new(input), "", &patch);
    drain(Reader::with_source(inputs, source, limits))
}

/// Counted pieces within the root.
fn counted(end: u64, make: impl Fn(u64) -> String + Send) -> Vec<Finding> {
    read(ROOT.as_bytes().chain(Count::new(end, make)).chain("</OpenDRIVE>".as_bytes()))
}

const ROOT: &str = "<OpenDRIVE>";
/// The root and the beginning of a road.
const ROAD: &str = "<OpenDRIVE><road id='1' length='1' junction='-1'>";

/// An entity that would expand to 10^9 times its size.
fn laughs() -> String {
    let mut text = String::from("<!DOCTYPE OpenDRIVE [<!ENTITY e0 'ha'>");
    for level in 1..10 {
        let inner = format!("&e{};", level - 1).repeat(10);
        text += &format!("<!ENTITY e{level} '{inner}'>");
    }
    text + "]><OpenDRIVE><header name='&e9;'/></OpenDRIVE>"
}

/// A folder with files.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("a file");
    }
    folder
}

type Bomb = (&'static str, &'static str, fn() -> Vec<Finding>);

/// Every bomb, the rule of an error that it must end in or bring, and how it is read.
const BOMBS: &[Bomb] = &[
    ("entity expansion", rule_ids::XML, || read(laughs().as_bytes())),
    ("attribute of 1 GB", rule_ids::LIMIT, || {
        between("<OpenDRIVE><header name='", "x", GB, "'/></OpenDRIVE>")
    }),
    ("tag of 1 GB of attributes", rule_ids::LIMIT, || {
        between("<OpenDRIVE><header", " b='1'", GB, "/></OpenDRIVE>")
    }),
    ("a million different attributes", rule_ids::LIMIT, || {
        let tag = Count::new(1_000_000, |n| format!(" a{n}=''"));
        read("<OpenDRIVE><header".as_bytes().chain(tag).chain("/></OpenDRIVE>".as_bytes()))
    }),
    ("name of 1 GB", rule_ids::LIMIT, || between("<OpenDRIVE><a", "a", GB, "/></OpenDRIVE>")),
    ("white space of 1 GB in a tag", rule_ids::LIMIT, || {
        between("<OpenDRIVE><header", " ", GB, "/></OpenDRIVE>")
    }),
    ("text of 1 GB", rule_ids::LIMIT, || between(ROOT, "x", GB, "</OpenDRIVE>")),
    ("content of 1 GB", rule_ids::LIMIT, || {
        between(
            "<OpenDRIVE><header><geoReference>",
            "x",
            GB,
            "</geoReference></header></OpenDRIVE>",
        )
    }),
    ("CDATA of 1 GB", rule_ids::LIMIT, || {
        let end = "]]></geoReference></header></OpenDRIVE>";
        between("<OpenDRIVE><header><geoReference><![CDATA[", "x", GB, end)
    }),
    ("1 GB of CDATA sections", rule_ids::LIMIT, || {
        let end = "</geoReference></header></OpenDRIVE>";
        between("<OpenDRIVE><header><geoReference>", "<![CDATA[x]]>", GB, end)
    }),
    ("comment of 1 GB", rule_ids::LIMIT, || between("<!--", "x", GB, "--><OpenDRIVE/>")),
    ("instruction of 1 GB", rule_ids::LIMIT, || between("<?p ", "x", GB, "?><OpenDRIVE/>")),
    ("document type of 1 GB", rule_ids::LIMIT, || {
        between("<!DOCTYPE OpenDRIVE [", "<!ENTITY a 'a'>", GB, "]><OpenDRIVE/>")
    }),
    ("reference of 1 GB", rule_ids::LIMIT, || between("<OpenDRIVE>&", "x", GB, ";</OpenDRIVE>")),
    ("end tag of 1 GB", rule_ids::LIMIT, || between("<OpenDRIVE></OpenDRIVE", " ", GB, ">")),
    ("1 GB before the first tag", rule_ids::XML, || between("", "x", GB, "<OpenDRIVE/>")),
    ("10 million levels", rule_ids::LIMIT, || between(ROOT, "<a>", 30_000_000, "")),
    ("10 million levels of one element", rule_ids::LIMIT, || {
        between(ROOT, "<userData>", 30_000_000, "")
    }),
    ("user data of 4 MB", rule_ids::ELEMENT, || {
        between("<OpenDRIVE><userData>", "<vector a='1'/>", 4 << 20, "</userData></OpenDRIVE>")
    }),
    ("100,000 roads that lack everything", rule_ids::MISSING, || {
        between(ROOT, "<road/>", 700_000, "</OpenDRIVE>")
    }),
    ("100,000 elements of other names", rule_ids::ELEMENT, || {
        counted(100_000, |n| format!("<element{n} a='1'/>"))
    }),
    ("100,000 attributes of other names", rule_ids::ELEMENT, || {
        counted(100_000, |n| format!("<road a{n}='1'/>"))
    }),
    ("2 MB of illegal characters", rule_ids::XML, || {
        between(ROOT, "<userData/>\x01", 2 << 20, "</OpenDRIVE>")
    }),
    ("2 MB of references that mean nothing", rule_ids::XML, || {
        between(ROOT, "<userData/>&x;", 2 << 20, "</OpenDRIVE>")
    }),
    ("gzip of 16 GB of white space", rule_ids::LIMIT, || {
        let member = gzip(&vec![b' '; 16 << 20]);
        read(Repeat::new(&gzip(ROOT.as_bytes()), &member, 1000 * member.len() as u64, b""))
    }),
    ("gzip of 20 GB of elements", rule_ids::LIMIT, || {
        let member = gzip(&format!("<a b='{}'/>", "x".repeat(500)).repeat(40_000).into_bytes());
        read(Repeat::new(&gzip(ROOT.as_bytes()), &member, 1000 * member.len() as u64, b""))
    }),
    ("1 MB names nested in each other", rule_ids::LIMIT, || {
        let name = "a".repeat(1_000_000);
        counted(100, |n| format!("<{name}{n}>"))
    }),
    ("1 MB of id before many findings", rule_ids::MISSING, || {
        let id = "1".repeat(1_000_000);
        let road = format!("<OpenDRIVE><road id='{id}'>");
        between(&road, "<link b='1'><a/></link>", 5_000_000, "</road></OpenDRIVE>")
    }),
    ("road of 1 GB of geometries", rule_ids::LIMIT, || {
        between(
            &(ROAD.to_owned() + "<planView>"),
            "<geometry/>",
            GB,
            "</planView></road></OpenDRIVE>",
        )
    }),
    ("patched road of 16 MiB of comments", rule_ids::XML, || {
        patched(ROAD, "<!---->", 16 << 20, "</road>")
    }),
    ("patched road of 16 MiB of sections of characters", rule_ids::XML, || {
        patched(ROAD, "<![CDATA[]]>", 16 << 20, "</road>")
    }),
    ("patched road of 16 MiB of roads", rule_ids::XML, || {
        patched(ROAD, "<road/>", 16 << 20, "</road>")
    }),
    ("patched road of 16 MiB of values with markup", rule_ids::XML, || {
        patched(ROAD, "<a b='<!--'/>", 16 << 20, "</road>")
    }),
    ("patched road with a comment of 1 GB", rule_ids::LIMIT, || {
        patched(&(ROAD.to_owned() + "</road><!--"), "x", GB, "--></OpenDRIVE>")
    }),
    ("value of 1 GB in a patched map", rule_ids::LIMIT, || {
        patched("<OpenDRIVE><road id='2'><a b='", "x", GB, "'/></road></OpenDRIVE>")
    }),
    ("text of 1 GB in a patched map", rule_ids::LIMIT, || patched(ROOT, "x", GB, "</OpenDRIVE>")),
    ("include of itself", rule_ids::INCLUDE, || {
        let text = |file| format!("<OpenDRIVE><include file='{file}'/></OpenDRIVE>");
        let folder = folder(&[("a.xodr", &text("b.xodr")), ("b.xodr", &text("a.xodr"))]);
        read_file(&folder.path().join("a.xodr"))
    }),
    ("includes that double at each level", rule_ids::LIMIT, || {
        let text = |level| {
            let include = format!("<include file='{level}.xodr'/>");
            format!("<OpenDRIVE>{include}{include}{include}{include}</OpenDRIVE>")
        };
        let names: Vec<String> = (0..20).map(|level| format!("{level}.xodr")).collect();
        let texts: Vec<String> = (1..21).map(text).collect();
        let files: Vec<(&str, &str)> =
            names.iter().map(String::as_str).zip(texts.iter().map(String::as_str)).collect();
        let folder = folder(&files);
        read_file(&folder.path().join("0.xodr"))
    }),
    ("include of a file outside", rule_ids::INCLUDE, || {
        let up = "../".repeat(32) + "etc/passwd";
        let text = format!("<OpenDRIVE><include file='{up}'/></OpenDRIVE>");
        let folder = folder(&[("a.xodr", &text)]);
        read_file(&folder.path().join("a.xodr"))
    }),
];

/// Largest memory of this process so far, in KiB, where the system says it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// Reads one bomb, in the process that [`bombs`] started for it.
#[test]
fn one_bomb() {
    let Ok(name) = std::env::var(VARIABLE) else { return };
    let (_, rule, read) = BOMBS.iter().find(|(bomb, ..)| *bomb == name).expect("a known bomb");
    let before = peak();
    let start = Instant::now();
    let findings = read();
    say(&format!(
        "{name}: {:.2} s, {:?} KiB, {:?} before, {} findings",
        start.elapsed().as_secs_f64(),
        peak(),
        before,
        findings.len()
    ));
    let is_it = |finding: &Finding| finding.rule == *rule && finding.severity == Severity::Error;
    let words: Vec<_> = findings.iter().map(|f| (f.rule, &f.message)).take(10).collect();
    assert!(findings.iter().any(is_it), "{name}: expected an error of {rule}, found {words:?}");
    assert!(peak().is_none_or(|peak| peak < MEMORY), "{name} took {:?} KiB", peak());
}

#[test]
fn bombs() {
    let program = std::env::current_exe().expect("the test's own program");
    let mut failures = String::new();
    for (name, ..) in BOMBS {
        let run = Command::new(&program)
            .args(["--exact", "bombs::one_bomb", "--nocapture"])
            .env(VARIABLE, name)
            .output()
            .expect("the test's own program runs");
        let words = String::from_utf8_lossy(&run.stderr);
        let lines: Vec<&str> = words.lines().filter(|line| line.starts_with(name)).collect();
        if !run.status.success() || lines.is_empty() {
            failures += &format!("{name}: {}\n{words}", run.status);
        }
        lines.iter().for_each(|line| say(line));
    }
    assert!(failures.is_empty(), "{failures}");
}

/// Past the test harness, which swallows what is printed.
fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}
