//! One copy of a map in memory, however many read it, and little of each reader's own; and queries without page faults.
//!
//! ```text
//! cargo test -p mapd-tests --test shared_once -- --nocapture                              a small map
//! MAPD_TEST_ARCHIVE=big104.mapd cargo test -p mapd-tests --test shared_once -- --nocapture   another one
//! ```

use mapd_tests::test_domain::TestDomain;
use mapd_tests::{say, town};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Stdio};

const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// Readers beside the daemon.
const CLIENTS: usize = 33;

/// What a client may have of its own above an empty process with iceoryx2 \[KiB\].
const PRIVATE: u64 = 2 << 10;

/// Of a segment beside the archive: header of the sample, state of the allocator, rounding to pages \[KiB\].
const SEGMENT: u64 = 64;

/// An archive that is served: the one that the environment names, or that of a generated town.
struct Served {
    place: TestDomain,
    archive: PathBuf,
    _folder: tempfile::TempDir,
}

impl Served {
    fn new() -> Self {
        let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
        let folder = tempfile::tempdir().expect("a folder");
        let archive = match std::env::var_os("MAPD_TEST_ARCHIVE") {
            Some(path) => path.into(),
            None => {
                let (map, archive) = (folder.path().join("m.xodr"), folder.path().join("m.mapd"));
                std::fs::write(&map, town::town(20, 20)).expect("written");
                let mut compile = place.command();
                let output = compile.arg("compile").arg(&map).arg("-o").arg(&archive).output();
                assert!(output.expect("runs").status.success());
                archive
            }
        };
        Self { place, archive, _folder: folder }
    }

    fn path(&self) -> String {
        self.archive.display().to_string()
    }
}

/// A process that waits until it is let go.
struct Held(Child);

impl Held {
    fn new(place: &TestDomain, args: &[&str]) -> Self {
        let mut child =
            place.command_of(PROBE).args(args).stdin(Stdio::piped()).spawn().expect("starts");
        let mut line = String::new();
        let out = child.stdout.as_mut().expect("stdout");
        BufReader::new(out).read_line(&mut line).expect("a line");
        assert!(line.starts_with("held "), "{line}");
        Self(child)
    }

    /// Sums of `/proc/PID/smaps` by field \[KiB\]: of everything, and of the map's data alone.
    fn memory(&self) -> [BTreeMap<String, u64>; 2] {
        memory_of(self.0.id())
    }

    /// What would be freed if it ended.
    fn private(&self) -> u64 {
        let [all, _] = self.memory();
        all["Private_Clean"] + all["Private_Dirty"]
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        // Its stdin ends with it.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn memory_of(pid: u32) -> [BTreeMap<String, u64>; 2] {
    let smaps = std::fs::read_to_string(format!("/proc/{pid}/smaps")).expect("smaps");
    let mut sums = [BTreeMap::new(), BTreeMap::new()];
    let mut is_map = false;
    for line in smaps.lines() {
        let mut words = line.split_whitespace();
        let first = words.next().unwrap_or_default();
        match first.strip_suffix(':') {
            None => is_map = line.contains("/dev/shm/") && line.trim_end().ends_with(".data"),
            Some(field) => {
                let Some(value) = words.next().and_then(|word| word.parse::<u64>().ok()) else {
                    continue;
                };
                for (sum, counts) in sums.iter_mut().zip([true, is_map]) {
                    *sum.entry(field.to_owned()).or_insert(0) += if counts { value } else { 0 };
                }
            }
        }
    }
    sums
}

#[test]
fn one_copy_for_all_and_little_for_each() {
    let served = Served::new();
    let place = &served.place;
    let daemon = place.serve(&[&served.path(), "--name", "m"]);
    let archive = std::fs::metadata(&served.archive).expect("an archive").len().div_ceil(1024);
    // Two of them: what they share with each other, clients share as well.
    let empty = [Held::new(place, &["empty"]), Held::new(place, &["empty"])];
    let clients: Vec<Held> = (0..CLIENTS).map(|_| Held::new(place, &["hold", "m"])).collect();
    let floor = empty.iter().map(Held::private).min().expect("two");
    let mut own: Vec<u64> = clients.iter().map(|c| c.private().saturating_sub(floor)).collect();
    own.sort_unstable();
    // Every reader has all of it mapped; proportional shares say how much of it there is.
    let (mut resident, mut shares) = (Vec::new(), 0);
    for client in &clients {
        let [_, data] = client.memory();
        resident.push(data["Rss"]);
        shares += data["Pss"];
        assert_eq!(data["Private_Dirty"], 0, "a reader has a copy");
    }
    shares += memory_of(daemon.id())[1]["Pss"];
    let on_tmpfs: u64 = place
        .segments()
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "data"))
        .map(|path| std::os::unix::fs::MetadataExt::blocks(&path.metadata().expect("there")) / 2)
        .sum();
    say(&format!(
        "archive {archive} KiB | {CLIENTS} clients have mapped {} KiB each | one copy: {on_tmpfs} KiB in /dev/shm, {shares} KiB by shares | \
         private above an empty process ({floor} KiB): median {} KiB, largest {} KiB",
        resident.iter().min().expect("clients"),
        own[CLIENTS / 2],
        own[CLIENTS - 1]
    ));
    assert!(resident.iter().all(|rss| *rss >= archive), "not all is mapped: {resident:?}");
    assert!((archive..=archive + SEGMENT).contains(&on_tmpfs), "{on_tmpfs} KiB in /dev/shm");
    assert!(shares <= archive + SEGMENT + CLIENTS as u64, "{shares} KiB by shares");
    assert!(own[CLIENTS - 1] <= PRIVATE, "of a client's own: {own:?} KiB");
}

#[test]
fn no_query_faults_on_a_populated_map() {
    let served = Served::new();
    let _daemon = served.place.serve(&[&served.path(), "--name", "m"]);
    let mut probe = served.place.command_of(PROBE);
    let output = probe.args(["populated", "m", &served.path()]).output().expect("runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let count = |name: &str| -> u64 {
        let line = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
        line.and_then(|count| count.parse().ok()).unwrap_or_else(|| panic!("no {name} in {text}"))
    };
    say(&format!(
        "page faults of a query at every lane: {} without, {} with",
        count("without"),
        count("with")
    ));
    assert!(count("without") > 0, "nothing to save: {text}");
    assert_eq!(count("with"), 0, "{text}");
}
