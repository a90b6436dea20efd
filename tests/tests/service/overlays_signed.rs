//! Signed entries of overlays: what the trusted key signed is laid over the map and kept, everything else is refused with its reason.

use super::trust::write_keys;
use mapd_client::{
    Attach, Client, SignedEntries, Snapshot, TrustedKey, read_signature, signature_path,
};
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

/// What a reader finds that has these documents and trusts this key and not the daemon: ids that the overlay does not have, or why it is not trusted.
fn proved(
    scene: &Scene,
    snapshot: &Snapshot,
    key: &str,
    files: &[&Path],
) -> Result<String, String> {
    let key = TrustedKey::open(scene.path(key)).expect("a key");
    let texts: Vec<(String, String)> = files
        .iter()
        .map(|file| {
            let text = fs::read_to_string(file).expect("read");
            (text, read_signature(file).expect("signed"))
        })
        .collect();
    let documents: Vec<SignedEntries<'_>> = texts
        .iter()
        .map(|(document, signature)| SignedEntries { name: "works", document, signature })
        .collect();
    let missing = snapshot.verify_overlay_signatures(&key, &documents);
    missing.map(|ids| ids.join(" ")).map_err(|error| error.to_string())
}

/// A reader needs not trust the daemon: here one that takes whatever it is given.
#[test]
fn readers_prove_overlays_themselves() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&[&scene.path("town.xodr")]);
    let client = Client::connect_as(Attach::Observer, &scene.place.domain(), "town", PATIENCE)
        .expect("attaches");
    let first = scene.write("first.json", &["a", "b", "c"]);
    let second = scene.write("second.json", &["b", "d"]);
    let both = [&*first, &*second];
    for file in both {
        scene.sign(file, "ours.key");
    }
    let bare = client.refresh().expect("served").clone();
    assert_eq!(proved(&scene, &bare, "ours.pub", &both), Ok("a b c d".to_owned()));
    for file in both {
        scene.apply(file, 0);
    }
    let good = client.refresh().expect("served").clone();
    assert_eq!(proved(&scene, &good, "ours.pub", &both), Ok(String::new()));
    let refused = |snapshot: &Snapshot, key: &str, files: &[&Path], words: &str| {
        let why = proved(&scene, snapshot, key, files).expect_err("refused");
        assert!(why.contains(words), "{why}");
    };
    refused(&good, "theirs.pub", &both, "another key");
    refused(&good, "ours.pub", &both[1..], "entry \"a\" of its overlay is in none");
    // An entry that says so is seen to be missing.
    scene.run(&["overlay", "town", "remove", "a"], 0);
    let without = client.refresh().expect("served").clone();
    assert_eq!(proved(&scene, &without, "ours.pub", &both), Ok("a".to_owned()));
    // The same entries for another map.
    fs::write(scene.path("town.xodr"), town(4, 3)).expect("written");
    scene.run(&["reload", "town"], 0);
    let swapped = client.refresh().expect("served").clone();
    assert_ne!(swapped.header().content_hash, without.header().content_hash);
    assert_eq!(proved(&scene, &swapped, "ours.pub", &both), Ok("a".to_owned()));
    // An entry of a good name that says something else, or is elsewhere.
    for (what, with) in [("[10.1,20.3]", "[10.1,20.2]"), ("closed", "wet"), ("\"1\"", "\"2\"")] {
        let forged = scene.write("forged.json", &["d"]);
        replace(&forged, what, with);
        scene.apply(&forged, 0);
        let forged = client.refresh().expect("served").clone();
        refused(&forged, "ours.pub", &both, "is not what the signed documents say");
    }
    // What is signed and is no document, which `mapd sign` would not sign.
    let other = scene.folder.path().join("other.json");
    fs::write(&other, "{}").expect("written");
    let key = fs::read_to_string(scene.path("ours.key")).expect("read");
    let key = minisign::SecretKeyBox::from_string(&key)
        .and_then(|sealed| sealed.into_unencrypted_secret_key());
    let signature = minisign::sign(None, &key.expect("a key"), &b"{}"[..], None, None);
    let signature = signature.expect("signed").into_string();
    fs::write(signature_path(&other), signature).expect("written");
    refused(&bare, "ours.pub", &[&other], "no document of entries");
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
    // A file that goes takes nothing with it.
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
