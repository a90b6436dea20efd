//! Writes questions with their answers by Rust, for programs in other languages to be compared with bit by bit.
//!
//! `answers FOLDER [COUNT]`: for each map that the project carries `FOLDER/MAP.mapd`, an overlay for it, `FOLDER/MAP.overlay`, and
//! `FOLDER/MAP.answers`, with COUNT questions of every kind
//! (default 1000). A line is a question's kind, its numbers, `|` and the answer's numbers, in hexadecimal: bits of doubles, ids as
//! `row + content * 2^32`, counts and codes as they are, texts as their FNV-1a. An answer that is an option begins with 1 or is 0; a list begins with
//! its count. Programs skip kinds that their language has no form for, and say which.
//!
//! A kind that not every map can have, or that not every try yields, is asked on where it can be had, until the maps together have five times COUNT. How many there are of
//! each kind is printed, and too few are an error.

mod along;
mod driving;
mod localising;
mod numbers;
mod parts;
mod places;
mod requests;
mod today;
mod tracking;

use localising::Localising;
use mapd_archive::encode;
use mapd_client::Bounds;
use mapd_client::glam::DVec2;
use mapd_client::route::RouteScratch;
use mapd_client::{Lane, Map, Road, Snapshot};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::overlays::over;
use numbers::Numbers;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Maps that the project carries, and the town with signals and streets above streets, which none of them has.
const MAPS: &[&str] = &["town", "objects", "marks", "surfaces", "one_road", SIGNALS];
const SIGNALS: &str = "signals";
/// Questions of every kind are COUNT times as many.
const TIMES: u32 = 5;

/// Radii of searches `[m]`: few, so that many questions go into one batch.
const RADII: &[f64] = &[0.5, 3.0, 10.0, 30.0];

/// Steele, Lea and Flood's SplitMix64: the same questions everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() % all.len() as u64) as usize]
    }
}

fn place<'a>(lanes: &[Lane<'a>], random: &mut Random) -> (Lane<'a>, f64) {
    let lane = random.one_of(lanes);
    let section = lane.section();
    (lane, random.between(section.s_start() - 1.0, section.s_end() + 1.0))
}

/// Memory of searches.
#[derive(Default)]
struct Memory {
    routes: RouteScratch,
    localising: Localising,
}

/// Asks questions that belong together.
type Ask = for<'a, 'b> fn(&mut Asker<'a>, &'b mut Memory) -> Result<()>;

/// Which kinds are asked together.
const GROUPS: &[(&[&str], Ask)] = &[
    (&["nearest", "near", "objects", "landmarks", "around", "track", "geodetic"], |asker, _| {
        asker.points()
    }),
    (&["inertial", "surface"], |asker, _| asker.roads()),
    (
        &[
            "pose",
            "position",
            "edges",
            "at",
            "lane",
            "movement",
            "line",
            "ahead",
            "sequences",
            "junction",
        ],
        |asker, _| asker.lanes(),
    ),
    (&["route", "reachable", "lines", "path", "along", "room"], |asker, memory| {
        asker.routes(&mut memory.routes)
    }),
    (&["ground", "mark", "match", "trace"], |asker, memory| asker.poses(&mut memory.localising)),
    (&["tracker", "stance", "sees", "paint"], |asker, _| asker.drive()),
    (&["comes"], |asker, memory| asker.comes(&mut memory.routes)),
    (&["request"], |asker, memory| asker.requests(&mut memory.routes)),
    (&["today"], |asker, memory| asker.today(&mut memory.routes)),
    (&["road"], |asker, _| asker.numbers_of_a_road()),
    (&["region"], |asker, _| asker.region()),
    (&["details"], |asker, _| asker.details()),
    (&["sign"], |asker, _| asker.sign()),
    (&["thing"], |asker, _| asker.thing()),
    (&["earth"], |asker, _| asker.earth()),
];

/// How often more than COUNT a map is asked for what it has too little of.
const TRIES: u32 = 100;

/// How many questions there are of each kind.
type Counts = BTreeMap<&'static str, u32>;

/// Asks about one map.
struct Asker<'a> {
    map: Map<'a>,
    /// The same map under an overlay.
    under: &'a Snapshot,
    lanes: Vec<Lane<'a>>,
    roads: Vec<Road<'a>>,
    random: Random,
    out: String,
    counts: Counts,
    /// Whether expected lanes have changed an answer: of the ground, of a stance.
    told_by_expected: [bool; 2],
    /// What is written, where not everything is.
    only: Option<BTreeSet<&'static str>>,
}

impl<'a> Asker<'a> {
    fn point(&mut self) -> DVec2 {
        let Bounds { low, high } = self.map.bounds();
        let x = self.random.between(low.x - 10.0, high.x + 10.0);
        DVec2::new(x, self.random.between(low.y - 10.0, high.y + 10.0))
    }

    /// A lane, and an s that may lie a little outside.
    fn place(&mut self) -> (Lane<'a>, f64) {
        place(&self.lanes, &mut self.random)
    }

    /// Writes a question and its answer, if its kind is wanted: whether it is.
    fn write(&mut self, kind: &'static str, question: &Numbers, answer: &Numbers) -> bool {
        if self.only.as_ref().is_some_and(|only| !only.contains(kind)) {
            return false;
        }
        *self.counts.entry(kind).or_default() += 1;
        self.out.push_str(kind);
        for number in &question.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push_str(" |");
        for number in &answer.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push('\n');
        true
    }
}

/// How many questions all maps together have of each kind.
fn sum(askers: &[Asker<'_>]) -> Counts {
    let mut all: Counts =
        GROUPS.iter().flat_map(|(kinds, _)| *kinds).map(|kind| (*kind, 0)).collect();
    for (kind, count) in askers.iter().flat_map(|asker| &asker.counts) {
        // Of what a map has only once there cannot be enough.
        if let Some(sum) = all.get_mut(kind) {
            *sum += count;
        }
    }
    all
}

/// Asks on until there are enough questions of every kind.
fn ask_on(askers: &mut [Asker<'_>], enough: u32, memory: &mut Memory) -> Result<Counts> {
    for _ in 0..TRIES.saturating_mul(enough) {
        let counts = sum(askers);
        let few: BTreeSet<&str> =
            counts.iter().filter(|(_, count)| **count < enough).map(|(kind, _)| *kind).collect();
        if few.is_empty() {
            return Ok(counts);
        }
        let mut can_have_any = false;
        for asker in &mut *askers {
            // A map that has had none of a kind cannot have any.
            let own: BTreeSet<&str> =
                few.iter().copied().filter(|kind| asker.counts.contains_key(kind)).collect();
            for (kinds, ask) in GROUPS {
                if kinds.iter().any(|kind| own.contains(kind)) {
                    can_have_any = true;
                    asker.only = Some(own.clone());
                    ask(asker, memory)?;
                }
            }
        }
        if !can_have_any {
            break;
        }
    }
    Err(format!("fewer than {enough} questions of a kind: {:?}", sum(askers)).into())
}

/// Asks on until expected lanes have changed an answer of each kind that takes them.
fn ask_what_is_expected(askers: &mut [Asker<'_>], memory: &mut Memory) -> Result<()> {
    for (i, kind) in ["ground", "stance"].into_iter().enumerate() {
        let is_told = |askers: &[Asker<'_>]| askers.iter().any(|asker| asker.told_by_expected[i]);
        for _ in 0..TRIES {
            if is_told(askers) {
                break;
            }
            for asker in &mut *askers {
                asker.only = Some([kind].into());
                asker.poses(&mut memory.localising)?;
                asker.drive()?;
            }
        }
        if !is_told(askers) {
            return Err(format!("no answer of {kind} depends on the expected lane").into());
        }
    }
    Ok(())
}

/// A map's text with signals on every road: a limit, a stop sign that names another signal, and a light.
fn with_signals(text: &str) -> String {
    let mut out = String::new();
    for (i, part) in text.split("</road>").enumerate() {
        if i > 0 {
            out.push_str("</road>");
        }
        out.push_str(part);
        if part.contains("<road ") {
            let common = r#"zOffset="2" country="DE" unit="km/h" height="0.6" width="0.6""#;
            let _ = write!(
                out,
                r#"<signals><signal s="1" t="-4" id="limit-{i}" name="" dynamic="no" orientation="+" type="274" subtype="-1" value="30" {common}/><signal s="2" t="-4" id="stop-{i}" name="" dynamic="no" orientation="+" type="206" subtype="-1" {common}><dependency id="light-{i}" type="off"/><reference elementId="limit-{i}" elementType="signal" type="limit"/></signal><signal s="2.5" t="-4" id="light-{i}" name="" dynamic="yes" orientation="+" type="1000001" subtype="-1" {common}/></signals>"#
            );
        }
    }
    out
}

/// Streets that are above others, and how far `[m]`.
const ABOVE: usize = 12;
const HEIGHT: f64 = 6.0;

/// A map's text in which its first roads lie twice, above each other; those above lead nowhere.
fn with_streets_above(text: &str) -> String {
    let mut above = String::new();
    for (i, part) in text.split("<road ").skip(1).take(ABOVE).enumerate() {
        let road = part.split_inclusive("</road>").next().unwrap_or_default();
        let (id, link) = (format!(r#"id="{}" junction"#, i + 1), road.find("<link>"));
        let rest =
            link.and_then(|link| road[link..].split_once("</link>").map(|(_, rest)| (link, rest)));
        let Some((link, rest)) = rest else { continue };
        let (_, lanes) = rest.split_once("</planView>").unwrap_or_default();
        let plan = &rest[..rest.len() - lanes.len()];
        let lanes = lanes.split("<signals>").next().unwrap_or_default();
        let head = road[..link].replace(&id, &format!(r#"id="above-{i}" junction"#));
        let _ = write!(
            above,
            r#"<road {head}{plan}<elevationProfile><elevation s="0" a="{HEIGHT}" b="0.01" c="0" d="0"/></elevationProfile>{lanes}{end}"#,
            end = if lanes.contains("</road>") { "" } else { "</road>" },
        );
    }
    text.replacen("<road ", &format!("{above}<road "), 1)
}

fn main() -> Result<()> {
    let mut args = std::env::args().skip(1);
    let folder = args.next().ok_or("usage: answers FOLDER [COUNT]")?;
    let count: u32 = args.next().map_or(Ok(1000), |text| text.parse())?;
    std::fs::create_dir_all(&folder)?;
    let mut maps = Vec::new();
    for name in MAPS {
        let of = if *name == SIGNALS { "town" } else { name };
        let mut text = std::fs::read_to_string(mapd_tests::carried(&format!("{of}.xodr")))?;
        if *name == SIGNALS {
            text = with_streets_above(&with_signals(&text));
        }
        let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {})?;
        let rows = compiled.rows.as_ref().ok_or("the map was rejected")?;
        let bytes = encode(rows, &compiled.provenance)?;
        let path = Path::new(&folder).join(name);
        std::fs::write(path.with_extension("mapd"), &bytes[..])?;
        let snapshot = Snapshot::from_bytes(bytes)?;
        let mut random = Random(0x6d61_7064);
        let said = today::said(snapshot.map(), &mut random);
        let (overlay, _) = over(snapshot.map(), &said, true);
        std::fs::write(path.with_extension("overlay"), &overlay[..])?;
        let under = snapshot.with_overlay(overlay)?;
        maps.push((path, snapshot, under, random));
    }
    let mut memory = Memory::default();
    let mut askers = Vec::new();
    for (_, snapshot, under, random) in &maps {
        let map = snapshot.map();
        let (lanes, roads) = (map.lanes().collect(), map.roads().collect());
        let (random, out) = (Random(random.0), String::new());
        let (counts, told_by_expected) = (Counts::new(), [false; 2]);
        let mut asker =
            Asker { map, under, lanes, roads, random, out, counts, told_by_expected, only: None };
        for _ in 0..count {
            for (_, ask) in GROUPS {
                ask(&mut asker, &mut memory)?;
            }
        }
        asker.whole();
        askers.push(asker);
    }
    ask_what_is_expected(&mut askers, &mut memory)?;
    let enough = count * TIMES;
    let counts = ask_on(&mut askers, enough, &mut memory)?;
    for ((path, ..), asker) in maps.iter().zip(&askers) {
        std::fs::write(path.with_extension("answers"), &asker.out)?;
    }
    let counts: Vec<String> =
        counts.iter().map(|(kind, count)| format!("{kind} {count}")).collect();
    writeln!(std::io::stdout(), "{}", counts.join(", "))?;
    Ok(())
}
