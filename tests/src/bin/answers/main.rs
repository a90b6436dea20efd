//! Writes questions with their answers by Rust, for programs in other languages to be compared with bit by bit.
//!
//! `answers FOLDER [COUNT]`: for each map that the project carries `FOLDER/MAP.mapd`, an overlay for it, `FOLDER/MAP.overlay`, and
//! `FOLDER/MAP.answers`, with COUNT questions of every kind
//! (default 1000). A line is a question's kind, its numbers, `|` and the answer's numbers, in hexadecimal: bits of doubles, ids as
//! `row + content * 2^32`, counts and codes as they are, texts as their FNV-1a. An answer that is an option begins with 1 or is 0; a list begins with
//! its count. Programs skip kinds that their language has no form for, and say which.

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
use std::fmt::Write as _;
use std::path::Path;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Maps that the project carries.
const MAPS: &[&str] = &["town", "objects", "marks", "surfaces", "one_road"];

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

/// Asks about one map.
struct Asker<'a> {
    map: Map<'a>,
    lanes: Vec<Lane<'a>>,
    roads: Vec<Road<'a>>,
    random: Random,
    out: String,
}

impl<'a> Asker<'a> {
    fn point(&mut self) -> DVec2 {
        let Bounds { low, high } = self.map.bounds();
        let x = self.random.between(low.x - 10.0, high.x + 10.0);
        DVec2::new(x, self.random.between(low.y - 10.0, high.y + 10.0))
    }

    /// A lane, and an s that may lie a little outside.
    fn place(&mut self) -> (Lane<'a>, f64) {
        let lane = self.random.one_of(&self.lanes);
        let section = lane.section();
        (lane, self.random.between(section.s_start() - 1.0, section.s_end() + 1.0))
    }

    fn write(&mut self, kind: &str, question: &Numbers, answer: &Numbers) {
        self.out.push_str(kind);
        for number in &question.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push_str(" |");
        for number in &answer.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push('\n');
    }
}

fn main() -> Result<()> {
    let mut args = std::env::args().skip(1);
    let folder = args.next().ok_or("usage: answers FOLDER [COUNT]")?;
    let count: u32 = args.next().map_or(Ok(1000), |text| text.parse())?;
    std::fs::create_dir_all(&folder)?;
    for name in MAPS {
        let file = std::fs::File::open(mapd_tests::carried(&format!("{name}.xodr")))?;
        let compiled = compile(file, &CompileOptions::default(), &mut |_| {})?;
        let rows = compiled.rows.as_ref().ok_or("the map was rejected")?;
        let bytes = encode(rows, &compiled.provenance)?;
        let path = Path::new(&folder).join(name);
        std::fs::write(path.with_extension("mapd"), &bytes[..])?;
        let snapshot = Snapshot::from_bytes(bytes)?;
        let map = snapshot.map();
        let random = Random(0x6d61_7064);
        let (lanes, roads) = (map.lanes().collect(), map.roads().collect());
        let mut asker = Asker { map, lanes, roads, random, out: String::new() };
        let (overlay, _) = over(map, &asker.said(), true);
        std::fs::write(path.with_extension("overlay"), &overlay[..])?;
        let under = snapshot.with_overlay(overlay)?;
        let (mut scratch, mut localising) = (RouteScratch::default(), Localising::default());
        for _ in 0..count {
            asker.points()?;
            asker.roads()?;
            asker.lanes()?;
            asker.routes(&mut scratch)?;
            asker.poses(&mut localising)?;
            asker.drive()?;
            asker.comes(&mut scratch)?;
            asker.requests(&mut scratch)?;
            asker.today(&under, &mut scratch)?;
            asker.parts()?;
        }
        asker.whole();
        std::fs::write(path.with_extension("answers"), asker.out)?;
    }
    Ok(())
}
