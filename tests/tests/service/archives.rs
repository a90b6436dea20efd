//! Archives that a daemon is given: what it is told besides holds or is refused, and what they are without is told.

use mapd_tests::test_domain::TestDomain;
use serde_json::Value;
use std::fs;
use std::process::Output;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A town whose first street has no heading, and its archive, which is without it.
struct Broken {
    place: TestDomain,
    folder: tempfile::TempDir,
}

impl Broken {
    fn new() -> Self {
        let broken =
            Self { place: TestDomain::new(MAPD), folder: tempfile::tempdir().expect("a folder") };
        let text = fs::read_to_string(mapd_tests::carried("town.xodr")).expect("read");
        let text = text.replacen("hdg=\"0\"", "hdg=\"nan\"", 1);
        fs::write(broken.path("q.xodr"), text).expect("written");
        let (map, archive) = (broken.path("q.xodr"), broken.path("q.mapd"));
        let output = broken.run(&["compile", &map, "-o", &archive]);
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        broken
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    fn run(&self, args: &[&str]) -> Output {
        self.place.command().args(args).output().expect("runs")
    }

    /// A daemon that is given the archive and these options ends with this code; what it says.
    fn check(&self, options: &[&str], code: i32, words: &str) {
        let output = self.run(&[&["--load", &self.path("q.mapd"), "--no-cache"], options].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{options:?}: {said}");
        assert!(said.contains(words), "{options:?}: {said}");
    }
}

/// All of these were dropped without a word, and the archive was served.
#[test]
fn options_hold_for_an_archive_or_are_refused() {
    let broken = Broken::new();
    let patch = broken.path("patch.xodr");
    fs::write(&patch, "<OpenDRIVE/>").expect("written");
    for (options, code, words) in [
        (&["--max-quarantined", "0"][..], 4, "at most 0 parts in quarantine, found 1"),
        (&["--max-quarantined-share", "0.001"], 4, "at most the share 0.001"),
        (&["--on-error", "reject"], 4, "road 1 is left out"),
        (&["--on-error", "reference-line"], 2, "--on-error holds when"),
        (&["--profile", "strict"], 2, "--profile holds when"),
        (&["--without", "user-data"], 2, "--without holds when"),
        (&["--landmarks", "3"], 2, "--landmarks holds when"),
        (&["--remove", "road:2"], 2, "--remove holds when"),
        (&["--patch", &patch], 2, "--patch holds when"),
    ] {
        broken.check(options, code, words);
    }
    let file = broken.path("mapd.toml");
    for (options, code, words) in
        [("max_quarantined = 0", 4, "found 1"), ("profile = 'strict'", 2, "--profile holds when")]
    {
        let text = format!("no_cache = true\n[[map]]\nfile = 'q.mapd'\noptions.{options}\n");
        fs::write(&file, text).expect("written");
        let output = broken.run(&["--config", &file]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{options}: {said}");
        assert!(said.contains(words), "{options}: {said}");
    }
    // Within the bounds it is served, and a reload judges what the file then holds.
    let archive = broken.path("q.mapd");
    let daemon = broken.place.serve(&[&archive, "--max-quarantined", "1"]);
    let (whole, map) = (broken.path("whole.mapd"), mapd_tests::carried("town.xodr"));
    let compiled = broken.run(&["compile", &map.display().to_string(), "-o", &whole]);
    assert_eq!(compiled.status.code(), Some(0), "{compiled:?}");
    fs::rename(&whole, &archive).expect("renamed");
    assert_eq!(broken.run(&["reload", "q"]).status.code(), Some(0));
    assert_eq!(daemon.stop(), 0);
}

/// Only the run that compiled the map told what it is without; one from the cache, or of an archive, told nothing.
#[test]
fn what_is_left_out_is_told_by_every_run() {
    let broken = Broken::new();
    for (run, file) in
        [("compiled", "q.xodr"), ("from the cache", "q.xodr"), ("an archive", "q.mapd")]
    {
        let args = ["--log", "json", "--log-level", "warn"];
        let mut command = broken.place.command();
        command.arg("--load").arg(broken.path(file)).args(args);
        let mut child = command.spawn().expect("starts");
        let status = || String::from_utf8_lossy(&broken.run(&["status"]).stdout).into_owned();
        let told = mapd_tests::test_domain::until("the status", || {
            Some(status()).filter(|text| text.contains("in quarantine: 1 parts"))
        });
        assert!(told.contains("shm:q"), "{run}: {told}");
        let pid = child.id().to_string();
        let stopped = std::process::Command::new("kill").args(["-TERM", &pid]).status();
        assert!(stopped.is_ok_and(|status| status.success()), "{run}");
        let mut said = String::new();
        let stderr = child.stderr.as_mut().expect("stderr");
        std::io::Read::read_to_string(stderr, &mut said).expect("text");
        assert!(child.wait().expect("ends").success(), "{run}: {said}");
        let events = said.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
        let messages: Vec<String> = events.map(|event| event["message"].to_string()).collect();
        assert!(messages.iter().any(|text| text.contains("nan")), "{run}: {messages:?}");
        let counts = messages.iter().filter(|text| text.contains("1 parts are in quarantine"));
        assert_eq!(counts.count(), usize::from(run != "compiled"), "{run}: {messages:?}");
    }
}
