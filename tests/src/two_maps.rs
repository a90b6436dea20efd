//! A file that holds one of two maps in turn, and what is true in each.

use mapd_archive::AlignedBytes;
use mapd_client::{NearestOptions, Snapshot, glam::DVec2};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Points of both maps.
const POINTS: [DVec2; 3] = [DVec2::new(10.0, -1.5), DVec2::new(50.0, -1.75), DVec2::new(90.0, 1.6)];

/// The two maps.
const MAPS: [&str; 2] = ["one_road.xodr", "town.xodr"];

/// The archives of two maps.
///
/// # Panics
///
/// If the maps that the project carries cannot be read.
pub fn archives() -> [AlignedBytes; 2] {
    MAPS.map(|name| {
        let path = crate::carried(name);
        let compiled = mapd::source::compile_file(&path, &Default::default(), &mut |_| {});
        let compiled = compiled.expect("readable");
        let rows = compiled.rows.expect("accepted");
        mapd_archive::encode(&rows, &compiled.provenance).expect("encodes")
    })
}

/// A file that holds one of two maps in turn.
pub struct TwoMaps {
    folder: tempfile::TempDir,
    texts: [Vec<u8>; 2],
    /// Of each map, what the nearest lanes of [`POINTS`] are: lines of content hash, x, y, lane.
    truth: String,
}

impl Default for TwoMaps {
    fn default() -> Self {
        Self::new()
    }
}

impl TwoMaps {
    /// The file holds the first map.
    ///
    /// # Panics
    ///
    /// If the maps that the project carries cannot be read.
    pub fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let mut truth = String::new();
        for bytes in archives() {
            let snapshot = Snapshot::from_bytes(bytes).expect("opens");
            for point in POINTS {
                let hit = snapshot.map().nearest_lane(point, &NearestOptions::default());
                let lane = hit.expect("an answer").expect("a lane").lane;
                let key = snapshot.map().lane(lane).expect("known").key().to_string();
                let hash = mapd::report::hex(&snapshot.header().content_hash);
                writeln!(truth, "{hash} {} {} {key}", point.x, point.y).expect("a string");
            }
        }
        let texts = MAPS.map(|name| std::fs::read(crate::carried(name)).expect("readable"));
        let maps = Self { folder, texts, truth };
        maps.put(0);
        std::fs::write(maps.truth(), &maps.truth).expect("written");
        maps
    }

    /// The file, `map.xodr`.
    pub fn path(&self) -> PathBuf {
        self.folder.path().join("map.xodr")
    }

    /// The folder of the file.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The file of what is true, for `planner_probe follow`.
    pub fn truth(&self) -> PathBuf {
        self.folder.path().join("truth")
    }

    /// Replaces the file by the map of this number, as 0 and 1 in turn.
    ///
    /// # Panics
    ///
    /// If the file cannot be replaced.
    pub fn put(&self, number: usize) {
        self.put_text(&self.texts[number % 2]);
    }

    /// Replaces the file by the same map in a text that takes a while: see [`slow`](crate::test_domain::slow).
    ///
    /// # Panics
    ///
    /// If the file cannot be replaced.
    pub fn put_slow(&self, number: usize) {
        self.put_text(&crate::test_domain::slow(&self.texts[number % 2]));
    }

    /// Replaces the file by this text, at once.
    ///
    /// # Panics
    ///
    /// If the file cannot be replaced.
    pub fn put_text(&self, text: &[u8]) {
        let new = self.folder.path().join("new");
        std::fs::write(&new, text).expect("written");
        std::fs::rename(new, self.path()).expect("renamed");
    }

    /// Whether a snapshot is of the map of this number, and answers so.
    ///
    /// # Panics
    ///
    /// If it has no answer.
    pub fn is(&self, snapshot: &Snapshot, number: usize) -> bool {
        let hash = mapd::report::hex(&snapshot.header().content_hash);
        self.truth.lines().skip(number % 2 * POINTS.len()).zip(POINTS).all(|(line, point)| {
            let hit = snapshot.map().nearest_lane(point, &NearestOptions::default());
            let lane = hit.expect("an answer").expect("a lane").lane;
            let key = snapshot.map().lane(lane).expect("known").key();
            line == format!("{hash} {} {} {key}", point.x, point.y)
        })
    }
}
