//! Maps for tests of queries, compiled in memory.

use crate::{carried, say, shared, workspace};
use mapd_archive::{encode, verify};
use mapd_client::Bounds;
use mapd_client::{Map, Snapshot, glam::DVec2};
use mapd_compiler::{CompileOptions, ReadOptions, compile, compile_from};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// What became of maps that nobody changes, by their paths. Most tests ask about the same few: each is compiled once in a process. Not to be asked for in a
/// thread of rayon's pool: compiling may run another task of the pool meanwhile, which would wait for itself.
static COMPILED: Mutex<BTreeMap<PathBuf, Arc<OnceLock<Option<Snapshot>>>>> =
    Mutex::new(BTreeMap::new());

/// A map that must be accepted, compiled with parts in quarantine if need be.
pub fn open(path: &Path) -> Snapshot {
    open_accepted(path).unwrap_or_else(|| panic!("{} is rejected", path.display()))
}

/// A compiled map; none for one that is rejected.
pub fn open_accepted(path: &Path) -> Option<Snapshot> {
    // What a test itself has written may be another map the next time.
    let carried_or_shared = [Some(workspace().join("examples")), shared("maps"), shared("found")];
    if !carried_or_shared.iter().flatten().any(|folder| path.starts_with(folder)) {
        return compiled(path);
    }
    let mut known = COMPILED.lock().unwrap_or_else(PoisonError::into_inner);
    let own = known.entry(path.to_owned()).or_default().clone();
    drop(known);
    own.get_or_init(|| compiled(path)).clone()
}

fn compiled(path: &Path) -> Option<Snapshot> {
    let file = || std::fs::File::open(path);
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let compiled = compile_from(file, &reading, &options, &mut |_| {}).expect("reading works");
    let archive = encode(&compiled.rows?, &compiled.provenance).expect("encodes");
    Some(Snapshot::from_bytes(archive).expect("opens"))
}

/// Compiles a map that is written out, which must be accepted, and proves its archive.
pub fn open_text(text: &str) -> Snapshot {
    open_text_with(text, &CompileOptions::default())
}

/// As [`open_text`], with these options.
pub fn open_text_with(text: &str, options: &CompileOptions) -> Snapshot {
    let compiled = compile(text.as_bytes(), options, &mut |_| {}).expect("reading works");
    let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let bytes = encode(&rows, &compiled.provenance).expect("encodes");
    verify(&bytes).expect("the rows are sound");
    Snapshot::from_bytes(bytes).expect("opens")
}

/// The carried maps, and these of the shared corpus, such as `carla/Town05`, where it is there.
pub fn carried_and(corpus: &[&str]) -> Vec<PathBuf> {
    let mut maps = vec![carried("town.xodr"), carried("one_road.xodr")];
    match shared("maps") {
        Some(folder) => maps.extend(corpus.iter().map(|name| folder.join(format!("{name}.xodr")))),
        None => say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    maps
}

/// A file of the folder `found` of the shared material, such as `maps/Town04.xodr`, if it is there.
pub fn found(name: &str) -> Option<PathBuf> {
    let path = shared("found").map(|folder| folder.join(name)).filter(|path| path.is_file());
    if path.is_none() {
        say(&format!("SKIPPED in part: no {name} beside the workspace"));
    }
    path
}

/// Small numbers that look random, the same in every run (Marsaglia's xorshift).
pub struct Random(pub u64);

impl Random {
    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A point in the map's bounds, widened by ten metres.
    pub fn point(&mut self, map: Map<'_>) -> DVec2 {
        let Bounds { low, high } = map.bounds();
        let (low, size) = (low.truncate() - 10.0, (high - low).truncate() + 20.0);
        low + DVec2::new(self.unit() * size.x, self.unit() * size.y)
    }
}

/// Every how many roads of a map one is in its patch.
const PATCHED: usize = 50;

/// A patch that replaces some of a map's roads by themselves.
pub fn own_roads(text: &str) -> String {
    let ends = text.match_indices("</road>").map(|(at, tag)| at + tag.len());
    let roads = ends.step_by(PATCHED).map(|end| {
        let begin = text[..end].rfind("<road ").expect("a road begins");
        &text[begin..end]
    });
    format!("<OpenDRIVE>{}</OpenDRIVE>", roads.collect::<Vec<_>>().concat())
}
