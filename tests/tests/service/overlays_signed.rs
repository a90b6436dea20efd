//! Signed entries of overlays: what the trusted key signed is laid over the map and kept, everything else is refused with its reason.

use super::trust::write_keys;
use mapd_client::signature_path;
use mapd_tests::test_domain::{Daemon, PATIENCE, TestDomain};
use mapd_tests::town::town;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Output};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

const REJECTED: i32 = 4;

/// A town, two pairs of keys, and files of entries.
struct Scene {
    place: TestDomain,
    folder: tempfile::TempDir,
}

impl Scene {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("town.xodr"), town(3, 3)).expect("written");
        write_keys(folder.path());
        Self { place: TestDomain::new(MAPD), folder }
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    /// A daemon that trusts this key.
    fn serve(&self, key: &str) -> Daemon {
        self.place.serve(&[&self.path("town.xodr"), "--overlay-trust", &self.path(key)])
    }

    /// A daemon with these options, which serves nothing.
    fn serves_nothing(&self, options: &[&str], words: &str) {
        let map = self.path("town.xodr");
        let said = self.run(&[&["--load", &map][..], options].concat(), REJECTED);
        assert!(said.contains(words), "{said}");
    }

    fn run(&self, args: &[&str], code: i32) -> String {
        let output: Output = self.place.command().args(args).output().expect("runs");
        let said = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
        said
    }

    /// Writes a file of entries that close lanes of road 1.
    fn write(&self, file: &str, ids: &[&str]) -> PathBuf {
        let entry = |id: &&str| {
            format!(
                r#"{{"id":"{id}","kind":"closed","lanes":[{{"road":"1","s":[10.1,20.3],"lane":-1}}]}}"#
            )
        };
        let entries: Vec<String> = ids.iter().map(entry).collect();
        let path = self.folder.path().join(file);
        fs::write(&path, format!(r#"{{"entries":[{}]}}"#, entries.join(","))).expect("written");
        path
    }

    fn sign(&self, file: &Path, key: &str) {
        self.run(&["sign", file.to_str().expect("a name"), "--key", &self.path(key)], 0);
    }

    fn apply(&self, file: &Path, code: i32) -> String {
        self.run(&["overlay", "town", "apply", file.to_str().expect("a name")], code)
    }

    /// Ids of the entries that hold.
    fn active(&self) -> Vec<String> {
        let list = self.run(&["overlay", "town", "list", "--json"], 0);
        let list: Value = serde_json::from_str(&list).expect("JSON");
        let entries = list["entries"].as_array().expect("a list").iter();
        let active = entries.filter(|one| one["state"] == "active");
        active.map(|one| one["id"].as_str().expect("a name").to_owned()).collect()
    }

    fn state(&self) -> PathBuf {
        self.place.cache().join(format!("{}town.overlay.json", self.place.domain().prefix()))
    }
}

/// Replaces a text in a file, which has it.
fn replace(path: &Path, what: &str, with: &str) {
    let text = fs::read_to_string(path).expect("read");
    assert!(text.contains(what), "{what:?} is not in {text}");
    fs::write(path, text.replace(what, with)).expect("written");
}

#[test]
fn what_is_signed_is_laid_over_the_map() {
    let scene = Scene::new();
    let _daemon = scene.serve("ours.pub");
    let file = scene.write("works.json", &["works"]);
    let refused = |words: &str| {
        let said = scene.apply(&file, 2);
        assert!(said.contains(words) && said.contains("nothing is changed"), "{said}");
        assert!(scene.active().is_empty());
    };
    refused("are not signed");
    scene.sign(&file, "theirs.key");
    refused("is signed with another key");
    fs::write(signature_path(&file), "no signature").expect("written");
    refused("expected a minisign signature");
    scene.sign(&file, "ours.key");
    replace(&file, "10.1", "10.2");
    refused("is not what was signed");
    replace(&file, "10.2", "10.1");
    scene.apply(&file, 0);
    assert_eq!(scene.active(), ["works"]);
    // A document with a good signature that is wrong otherwise.
    let wrong = scene.write("wrong.json", &["far"]);
    replace(&wrong, r#""road":"1""#, r#""road":"99999""#);
    scene.sign(&wrong, "ours.key");
    assert!(scene.apply(&wrong, 2).contains("lanes[0].road"));
    // Taking away needs no signature.
    scene.run(&["overlay", "town", "remove", "works"], 0);
    assert!(scene.active().is_empty());
}

/// A daemon without a key takes signed and unsigned entries.
#[test]
fn without_a_key_signatures_say_nothing() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&[&scene.path("town.xodr")]);
    let file = scene.write("works.json", &["works"]);
    scene.apply(&file, 0);
    scene.sign(&file, "theirs.key");
    scene.apply(&file, 0);
    assert_eq!(scene.active(), ["works"]);
}

#[test]
fn what_is_kept_is_proved_again() {
    let scene = Scene::new();
    let daemon = scene.serve("ours.pub");
    for (file, ids) in [("first.json", &["a", "b", "c"][..]), ("second.json", &["b", "d"])] {
        let path = scene.write(file, ids);
        scene.sign(&path, "ours.key");
        scene.apply(&path, 0);
    }
    scene.run(&["overlay", "town", "remove", "a"], 0);
    assert_eq!(daemon.stop(), 0);
    let ours = ["--overlay-trust", &scene.path("ours.pub")];
    let daemon = scene.serve("ours.pub");
    let mut active = scene.active();
    active.sort();
    assert_eq!(active, ["b", "c", "d"], "what was removed stays so");
    daemon.kill();
    let good = fs::read_to_string(scene.state()).expect("read");
    scene.serves_nothing(
        &["--overlay-trust", &scene.path("theirs.pub")],
        "is signed with another key",
    );
    replace(&scene.state(), "20.3", "20.4");
    scene.serves_nothing(&ours, "is not what was signed");
    fs::write(scene.state(), &good).expect("written");
    let added = r#""entries":[{"id":"more","kind":"wet","lanes":[{"road":"1"}]}],"signed""#;
    replace(&scene.state(), r#""entries":[],"signed""#, added);
    scene.serves_nothing(&ours, "entry \"more\" is not signed");
    // Only a daemon that takes proposals has some.
    replace(&scene.state(), "\"more\"", "\"proposed/camera/more\"");
    scene.serves_nothing(&ours, "is not signed");
    fs::write(scene.state(), &good).expect("written");
    // A daemon without a key reads what one with a key kept.
    let daemon = scene.place.serve(&[&scene.path("town.xodr")]);
    assert_eq!(scene.active().len(), 3);
    scene.apply(&scene.write("own.json", &["c"]), 0);
    drop(daemon);
    scene.serves_nothing(&ours, "entry \"c\" is not signed");
}

/// Documents of which nothing is left are forgotten.
#[test]
fn documents_without_entries_are_forgotten() {
    let scene = Scene::new();
    let _daemon = scene.serve("ours.pub");
    let file = scene.write("works.json", &["works"]);
    let mut lengths = Vec::new();
    for _ in 0..3 {
        scene.sign(&file, "ours.key");
        scene.apply(&file, 0);
        lengths.push(fs::metadata(scene.state()).expect("there").len());
    }
    assert!(lengths.iter().all(|length| *length < lengths[0] + 100), "{lengths:?}");
    scene.run(&["overlay", "town", "clear"], 0);
    assert_eq!(fs::read_to_string(scene.state()).expect("read"), r#"{"entries":[]}"#);
}

/// What a daemon keeps its successor can read: more than that is refused.
#[test]
fn what_is_kept_can_be_read_again() {
    let scene = Scene::new();
    let options = [&scene.path("town.xodr"), "--overlay-bytes", "512"];
    let daemon = scene.place.serve(&options);
    let mut kept = Vec::new();
    let said = loop {
        let id = format!("{}-{}", kept.len(), "x".repeat(190));
        let file = scene.write("works.json", &[&id]);
        let output = scene.place.command().args(["overlay", "town", "apply"]).arg(file).output();
        let output = output.expect("runs");
        if !output.status.success() {
            break String::from_utf8_lossy(&output.stderr).into_owned();
        }
        kept.push(id);
        assert!(kept.len() < 20, "no end");
    };
    assert!(said.contains("--overlay-bytes") && said.contains("nothing is changed"), "{said}");
    assert!(kept.len() > 1);
    assert_eq!(daemon.stop(), 0);
    let _daemon = scene.place.serve(&options);
    assert_eq!(scene.active(), kept);
}

/// A followed folder: signatures are no documents, and a file whose signature comes later is applied then.
#[test]
fn a_folder_of_signed_files_is_followed() {
    /// Ends with the test.
    struct Ended(Child);
    impl Drop for Ended {
        fn drop(&mut self) {
            let _ = self.0.kill().and_then(|()| self.0.wait());
        }
    }
    let scene = Scene::new();
    let _daemon = scene.serve("ours.pub");
    let folder = scene.folder.path().join("works");
    fs::create_dir(&folder).expect("a folder");
    let said = scene.folder.path().join("said");
    let mut command = scene.place.command();
    command.args(["overlay", "town", "apply", "--watch", folder.to_str().expect("a name")]);
    command.stderr(fs::File::create(&said).expect("a file"));
    let _follows = Ended(command.spawn().expect("starts"));
    let until = |what: &dyn Fn() -> bool| {
        let end = Instant::now() + PATIENCE;
        while !what() {
            let said = fs::read_to_string(&said).expect("read");
            assert!(Instant::now() < end, "{:?}: {said}", scene.active());
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    let has_said = |words: &str| fs::read_to_string(&said).expect("read").contains(words);
    let file = scene.write("works/a.json", &["a"]);
    until(&|| has_said("are not signed"));
    scene.sign(&file, "ours.key");
    until(&|| scene.active() == ["a"]);
    // Who can only write the folder opens nothing: a file that goes takes nothing with it.
    fs::write(&said, "").expect("emptied");
    fs::remove_file(&file).expect("removed");
    fs::remove_file(signature_path(&file)).expect("removed");
    until(&|| has_said("are not signed"));
    assert_eq!(scene.active(), ["a"]);
    // What is signed says what holds.
    let file = scene.write("works/a.json", &[]);
    scene.sign(&file, "ours.key");
    until(&|| scene.active().is_empty());
}
