//! Asks everything of damaged archives and overlays, one after another: a panic, or a question that takes longer than any should, is told, and its bytes are kept.
//!
//! ```text
//! damaged SECONDS SEED FOLDER [MAP.xodr ...]
//! ```
//!
//! `FOLDER` gets the bytes. Damage is the same for a seed. Arithmetic that leaves its type is a panic where the build says so, as debug builds do.

use mapd_archive::{AlignedBytes, HEADER_LENGTH, TableEntry, open, open_overlay};
use mapd_tests::damage::random::{Random, damage, places};
use mapd_tests::damage::{ask_everything, ask_under};
use mapd_tests::overlays::{over, todays_entries};
use mapd_tests::{carried, maps, say};
use std::ops::Range;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// All questions of one archive that take more of the processor's time do not end.
const PATIENCE: Duration = Duration::from_secs(60);
/// One of so many cases damages the overlay over a map.
const OVERLAYS: usize = 4;

/// A whole archive with its overlay, and where their tables lie.
struct Good {
    map: AlignedBytes,
    overlay: AlignedBytes,
    map_tables: Vec<(Range<usize>, usize)>,
    overlay_tables: Vec<(Range<usize>, usize)>,
}

/// What is asked now, for who watches.
static NOW: Mutex<Option<(Duration, u64, AlignedBytes, AlignedBytes)>> = Mutex::new(None);

/// Time for which the first thread, which asks, has had a processor.
fn worked() -> Duration {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let spent = text.split_whitespace().next().and_then(|number| number.parse().ok());
    Duration::from_nanos(spent.unwrap_or(0))
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [seconds, seed, folder, files @ ..] = args.as_slice() else { usage() };
    let (Ok(seconds), Ok(seed)) = (seconds.parse(), seed.parse::<u64>()) else { usage() };
    let folder = PathBuf::from(folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let names = ["one_road.xodr", "surfaces.xodr", "marks.xodr", "objects.xodr", "town.xodr"];
    let own = names.map(carried).into_iter().chain(files.iter().map(PathBuf::from));
    let texts = [mapd_tests::crossroads::furnished()];
    let all: Vec<Good> = own
        .map(|path| maps::open(&path))
        .chain(texts.iter().map(|text| maps::open_text(text)))
        .map(|snapshot| {
            let map = snapshot.map();
            let (overlay, _) = over(map, &todays_entries(map), true);
            good(aligned(snapshot.bytes()), overlay)
        })
        .collect();
    let watched = folder.clone();
    std::thread::spawn(move || watch(&watched));
    let end = Instant::now() + Duration::from_secs(seconds);
    let (mut case, mut found) = (seed, 0);
    while Instant::now() < end {
        found += usize::from(!survives(&all, case, &folder));
        case += 1;
    }
    say(&format!("{} cases from {seed} on, {found} found", case - seed));
    std::process::exit(i32::from(found > 0));
}

fn usage() -> ! {
    say("usage: damaged SECONDS SEED FOLDER [MAP.xodr ...]");
    std::process::exit(2)
}

fn aligned(bytes: &[u8]) -> AlignedBytes {
    let mut out = AlignedBytes::with_capacity(bytes.len());
    out.extend_from_slice(bytes);
    out
}

fn good(map: AlignedBytes, overlay: AlignedBytes) -> Good {
    let map_tables = places(&open(&map).expect("opens").tables.infos(), map.as_ptr() as usize);
    let opened = open_overlay(&overlay).expect("opens");
    let first = HEADER_LENGTH + opened.header.tables as usize * size_of::<TableEntry>();
    // Rows of overlays consist of words.
    let overlay_tables = vec![(first..overlay.len(), size_of::<u64>())];
    Good { map, overlay, map_tables, overlay_tables }
}

/// Whether one case is answered without a panic.
fn survives(all: &[Good], case: u64, folder: &Path) -> bool {
    let mut random = Random::new(case);
    let good = &all[random.below(all.len())];
    let (mut map, mut overlay) = (good.map.clone(), good.overlay.clone());
    let is_overlay = random.below(OVERLAYS) == 0;
    match is_overlay {
        true => damage(&mut overlay, &good.overlay_tables, &mut random),
        false => damage(&mut map, &good.map_tables, &mut random),
    }
    *NOW.lock().expect("whole") = Some((worked(), case, map.clone(), overlay.clone()));
    let asked = (map.clone(), overlay.clone());
    let answer = catch_unwind(move || match is_overlay {
        true => ask_under(asked.0, asked.1),
        false => ask_everything(asked.0),
    });
    if answer.is_err() {
        keep(folder, "panic", case, &map, &overlay);
    }
    answer.is_ok()
}

/// Ends the program where a case takes too long.
fn watch(folder: &Path) {
    loop {
        std::thread::sleep(Duration::from_secs(1));
        let now = NOW.lock().expect("whole");
        if let Some((since, case, map, overlay)) = &*now
            && worked().saturating_sub(*since) > PATIENCE
        {
            keep(folder, "endless", *case, map, overlay);
            std::process::exit(3);
        }
    }
}

fn keep(folder: &Path, what: &str, case: u64, map: &[u8], overlay: &[u8]) {
    say(&format!("{what}: case {case}"));
    for (bytes, kind) in [(map, "mapd"), (overlay, "overlay")] {
        let path = folder.join(format!("{what}-{case}.{kind}"));
        if let Err(error) = std::fs::write(&path, bytes) {
            say(&format!("{}: {error}", path.display()));
        }
    }
}
