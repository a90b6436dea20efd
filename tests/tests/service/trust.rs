//! Signed archives: what is signed by the trusted key is served and queried, everything else is refused with its reason.

use mapd_client::{Client, Snapshot, TrustError, TrustedKey, signature_path};
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

const REJECTED: Option<i32> = Some(4);

/// Two pairs of keys, an archive and a place.
struct Signed {
    place: TestDomain,
    folder: TempDir,
    archive: PathBuf,
}

impl Signed {
    fn new() -> Self {
        let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
        let folder = tempfile::tempdir().expect("a folder");
        write_keys(folder.path());
        let archive = folder.path().join("town.mapd");
        let this = Self { place, folder, archive };
        let town = mapd_tests::carried("town.xodr").display().to_string();
        this.run(&["compile", &town, "-o", &this.archive()], Some(0));
        this
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    fn archive(&self) -> String {
        self.archive.display().to_string()
    }

    fn signature(&self) -> PathBuf {
        signature_path(&self.archive)
    }

    fn sign(&self, key: &str) {
        self.run(&["sign", &self.archive(), "--key", &self.path(key)], Some(0));
    }

    fn run(&self, args: &[&str], code: Option<i32>) -> Output {
        let output = self.place.command().args(args).output().expect("runs");
        assert_eq!(output.status.code(), code, "{args:?}: {}", said(&output));
        output
    }

    /// Every way in refuses, with these words.
    fn refused(&self, source: &str, words: &str) {
        let key = self.path("ours.pub");
        for args in [
            &["--load", source, "--trust", &key][..],
            &["inspect", source, "--trust", &key],
            &["query", source, "nearest", "--trust", &key],
            &["export", source, "--format", "svg", "--trust", &key],
        ] {
            let output = self.run(args, REJECTED);
            assert!(said(&output).contains(words), "{args:?}: {}", said(&output));
        }
        assert!(self.place.segments().is_empty(), "something is left behind");
    }
}

/// Two pairs of keys without passwords: `ours.pub` and `ours.key`, `theirs.pub` and `theirs.key`.
pub(super) fn write_keys(folder: &Path) {
    for name in ["ours", "theirs"] {
        let pair = minisign::KeyPair::generate_unencrypted_keypair().expect("keys");
        let write = |ending: &str, text: String| {
            std::fs::write(folder.join(format!("{name}.{ending}")), text).expect("written");
        };
        write("pub", pair.pk.to_box().expect("a key").into_string());
        write("key", pair.sk.to_box(None).expect("a key").into_string());
    }
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Changes a byte in the middle of a file.
fn alter(path: &Path) {
    let mut bytes = std::fs::read(path).expect("read");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    std::fs::write(path, bytes).expect("written");
}

#[test]
fn what_is_signed_is_served_and_answers() {
    let signed = Signed::new();
    signed.sign("ours.key");
    let key = signed.path("ours.pub");
    signed.run(&["inspect", &signed.archive(), "--trust", &key, "--verify"], Some(0));
    let daemon = signed.place.serve(&[&signed.archive(), "--trust", &key]);
    let client = Client::connect_in(&signed.place.domain(), "town", PATIENCE).expect("attaches");
    let snapshot = client.snapshot();
    // A client that trusts the key alone proves what the daemon serves.
    let signature = std::fs::read_to_string(signed.signature()).expect("read");
    let [ours, theirs] =
        ["ours.pub", "theirs.pub"].map(|name| TrustedKey::open(signed.path(name)).expect("a key"));
    snapshot.verify_signature(&ours, &signature).expect("signed");
    snapshot.verify_signature(&theirs, &signature).expect_err("another key");
    drop((snapshot, client));
    assert_eq!(daemon.stop(), 0);
}

#[test]
fn a_reload_of_what_is_not_signed_leaves_what_is_served() {
    let signed = Signed::new();
    signed.sign("ours.key");
    let key = signed.path("ours.pub");
    let _daemon = signed.place.serve(&[&signed.archive(), "--trust", &key]);
    let client = Client::connect_in(&signed.place.domain(), "town", PATIENCE).expect("attaches");
    let before = client.snapshot();
    let other = mapd_tests::carried("one_road.xodr").display().to_string();
    signed.run(&["compile", &other, "-o", &signed.archive()], Some(0));
    let refuse = |words: &str| {
        let output = signed.place.command().args(["reload", "town"]).output().expect("runs");
        let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), said(&output));
        assert!(!output.status.success() && text.contains(words), "{text}");
        assert_eq!(client.refresh().expect("no error").generation(), before.generation());
    };
    refuse("is not what was signed");
    std::fs::remove_file(signed.signature()).expect("removed");
    refuse("is not signed");
    signed.sign("theirs.key");
    refuse("another key");
    signed.sign("ours.key");
    signed.run(&["reload", "town"], Some(0));
    let after = client.refresh().expect("no error");
    assert_ne!(after.map().content_hash(), before.map().content_hash());
    // What is gone back to keeps the signature it had.
    signed.run(&["rollback", "town"], Some(0));
    let back = client.refresh().expect("no error");
    assert_eq!(back.map().content_hash(), before.map().content_hash());
}

#[test]
fn what_is_not_signed_by_this_key_or_altered_is_refused() {
    let signed = Signed::new();
    signed.refused(&signed.archive(), "is not signed");
    signed.sign("theirs.key");
    signed.refused(&signed.archive(), "another key");
    std::fs::write(signed.signature(), "no signature").expect("written");
    signed.refused(&signed.archive(), "expected a minisign signature");
    signed.sign("ours.key");
    // The trusted comment is signed too.
    let good = std::fs::read_to_string(signed.signature()).expect("read");
    std::fs::write(signed.signature(), good.replace("file:town", "file:city")).expect("written");
    signed.refused(&signed.archive(), "is not what was signed");
    std::fs::write(signed.signature(), good).expect("written");
    let bytes = std::fs::read(&signed.archive).expect("read");
    alter(&signed.archive);
    signed.refused(&signed.archive(), "is not what was signed");
    // Bytes behind the end are not signed either; whether its length or its signature is found wrong first is all one.
    std::fs::write(&signed.archive, [&bytes[..], &[0; 64]].concat()).expect("written");
    let key = signed.path("ours.pub");
    let output =
        signed.place.command().args(["inspect", &signed.archive(), "--trust", &key]).output();
    assert!(matches!(output.expect("runs").status.code(), Some(1 | 4)));
    std::fs::write(&signed.archive, bytes).expect("written");
    let snapshot = Snapshot::open_trusted(
        &signed.archive,
        &TrustedKey::open(signed.path("ours.pub")).expect("a key"),
    );
    snapshot.expect("whole again");
}

#[test]
fn sources_that_no_signature_covers_are_refused() {
    let signed = Signed::new();
    let town = mapd_tests::carried("town.xodr").display().to_string();
    signed.refused(&town, "--trust goes with archives");
    let key = signed.path("ours.pub");
    let output = signed.run(&["inspect", "shm:town", "--trust", &key], REJECTED);
    assert!(said(&output).contains("start its daemon with --trust"), "{}", said(&output));
}

#[test]
fn keys_that_cannot_be_used_are_named() {
    let signed = Signed::new();
    signed.sign("ours.key");
    for (key, words) in
        [("missing.pub", "missing.pub"), ("town.mapd", "expected a minisign public key")]
    {
        let output =
            signed.run(&["inspect", &signed.archive(), "--trust", &signed.path(key)], Some(1));
        assert!(said(&output).contains(words), "{}", said(&output));
    }
    let parsed = TrustedKey::parse("nonsense", "here");
    assert!(matches!(parsed, Err(TrustError::Key { name, .. }) if name == "here"));
    let output =
        signed.run(&["sign", &signed.archive(), "--key", &signed.path("ours.pub")], Some(1));
    assert!(said(&output).contains("ours.pub is a public key"), "{}", said(&output));
    for (name, text) in [("rows.csv", "x,y\n1,2\n"), ("empty", ""), ("short", "\nRWQ=\n")] {
        std::fs::write(signed.path(name), text).expect("written");
        let output = signed.run(&["sign", &signed.archive(), "--key", &signed.path(name)], Some(1));
        let expected = format!("{name} is no minisign secret key");
        assert!(said(&output).contains(&expected), "{}", said(&output));
    }
}

#[test]
fn a_secret_key_with_a_password() {
    let signed = Signed::new();
    let pair =
        minisign::KeyPair::generate_encrypted_keypair(Some("open sesame".into())).expect("keys");
    std::fs::write(signed.path("sealed.key"), pair.sk.to_box(None).expect("a key").into_string())
        .expect("written");
    std::fs::write(signed.path("sealed.pub"), pair.pk.to_box().expect("a key").into_string())
        .expect("written");
    let sign = |password: Option<&str>| {
        let mut command = signed.place.command();
        if let Some(password) = password {
            command.env("MAPD_SIGN_PASSWORD", password);
        }
        command.args(["sign", &signed.archive(), "--key", &signed.path("sealed.key")]);
        command.output().expect("runs")
    };
    assert!(said(&sign(None)).contains("MAPD_SIGN_PASSWORD"));
    assert!(said(&sign(Some("wrong"))).contains("another password"));
    assert!(!signed.signature().exists());
    let output = sign(Some("open sesame"));
    assert!(output.status.success(), "{}", said(&output));
    let key = signed.path("sealed.pub");
    signed.run(&["inspect", &signed.archive(), "--trust", &key], Some(0));
}

/// The program minisign and mapd read each other's keys and signatures.
#[test]
fn minisign_agrees() {
    let signed = Signed::new();
    let minisign = |args: &[&str]| {
        let mut command = signed.place.command_of("minisign");
        let output = command.args(args).current_dir(signed.folder.path()).output().expect("runs");
        assert!(output.status.success(), "{args:?}: {}", said(&output));
    };
    if std::process::Command::new("minisign").arg("-v").output().is_err() {
        return say("SKIPPED: there is no minisign (Debian: apt-get install minisign)");
    }
    minisign(&["-G", "-W", "-p", "its.pub", "-s", "its.key"]);
    signed.sign("its.key");
    minisign(&["-Vm", "town.mapd", "-p", "its.pub"]);
    std::fs::remove_file(signed.signature()).expect("removed");
    minisign(&["-Sm", "town.mapd", "-s", "its.key"]);
    signed.run(&["inspect", &signed.archive(), "--trust", &signed.path("its.pub")], Some(0));
}

/// Only archives that prove are signed.
#[test]
fn a_damaged_archive_is_not_signed() {
    let signed = Signed::new();
    alter(&signed.archive);
    signed.run(&["sign", &signed.archive(), "--key", &signed.path("ours.key")], Some(1));
    assert!(!signed.signature().exists());
}
