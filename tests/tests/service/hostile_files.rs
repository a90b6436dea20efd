//! Files that are not what their names say: pipes that nobody writes to, folders, devices that never end, other maps' archives.

use mapd_client::Client;
use mapd_tests::small::in_small_folder;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::two_maps::TwoMaps;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Bytes of a file system in which no archive of the town fits.
const TOO_SMALL: u64 = 32 << 10;

/// What may stand in a file's place.
const STRANGERS: [&str; 3] = ["a pipe", "a folder", "a file without an end"];

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

fn put(stranger: &str, path: &Path) {
    match stranger {
        "a pipe" => {
            assert!(Command::new("mkfifo").arg(path).status().expect("mkfifo runs").success());
        }
        "a folder" => fs::create_dir(path).expect("made"),
        _ => symlink("/dev/zero", path).expect("a link"),
    }
}

fn remove(path: &Path) {
    if fs::remove_file(path).is_err() {
        fs::remove_dir_all(path).expect("removed");
    }
}

/// The output of a process that has to end by itself.
fn ends(mut child: Child, what: &str) -> Output {
    let until = Instant::now() + PATIENCE;
    while child.try_wait().expect("looked at").is_none() {
        if Instant::now() >= until {
            child.kill().expect("killed");
            panic!("{what}: does not end");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    child.wait_with_output().expect("ended")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    entries.map(|entry| entry.path()).collect()
}

#[test]
fn an_archive_of_another_map_in_the_cache_is_not_served() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let map = maps.path().display().to_string();
    let archives = || {
        let all = files(place.cache()).into_iter();
        all.filter(|path| path.extension().is_some_and(|e| e == "mapd")).collect::<Vec<_>>()
    };
    maps.put(0);
    assert_eq!(place.serve(&[&map]).stop(), 0);
    let first = archives();
    maps.put(1);
    assert_eq!(place.serve(&[&map]).stop(), 0);
    let second = archives().into_iter().find(|path| !first.contains(path)).expect("another");
    let [first] = first.as_slice() else { panic!("{first:?}") };
    fs::copy(first, &second).expect("copied over");
    for args in [vec![map.as_str()], vec![map.as_str(), "--last-good"]] {
        let daemon = place.serve(&args);
        let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
        assert!(maps.is(&client.snapshot(), 1), "{args:?}");
        drop(client);
        assert_eq!(daemon.stop(), 0);
    }
}

/// A pipe in the cache once held the start up, past SIGTERM; a folder ended it.
#[test]
fn nothing_in_the_cache_keeps_a_map_from_being_served() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    maps.put(0);
    let map = maps.path().display().to_string();
    assert_eq!(place.serve(&[&map]).stop(), 0);
    let mut names = files(place.cache());
    assert!(names.len() >= 3, "{names:?}");
    names.extend([".new-1-2-3", "x.generation.new"].map(|name| place.cache().join(name)));
    let generation = names.iter().find(|name| name.to_string_lossy().ends_with("map.generation"));
    let mut left = generation.expect("the last generation").as_os_str().to_owned();
    left.push(".new");
    names.push(left.into());
    for stranger in STRANGERS {
        for name in &names {
            if name.exists() {
                remove(name);
            }
            put(stranger, name);
            let daemon = place.serve(&[&map, "--last-good"]);
            let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
            assert!(maps.is(&client.snapshot(), 0), "{stranger} as {}", name.display());
            drop(client);
            assert_eq!(daemon.stop(), 0, "{stranger} as {}", name.display());
            if fs::symlink_metadata(name).is_ok() {
                remove(name);
            }
        }
    }
}

/// A full cache once ended the start.
#[test]
fn a_full_cache_is_done_without() {
    let place = TestDomain::new(MAPD);
    fs::create_dir(place.cache()).expect("made");
    in_small_folder(place.cache(), TOO_SMALL, || {
        let daemon = place.serve(&[&town()]);
        let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
        client.snapshot().verify().expect("proves");
        let served = place.state("town").served.expect("served");
        assert!(served.bytes > TOO_SMALL && !served.from_cache, "{served:?}");
        assert_eq!(daemon.stop(), 0);
        let archives = files(place.cache()).into_iter();
        assert_eq!(archives.filter(|f| f.extension().is_some_and(|e| e == "mapd")).count(), 0);
    });
}

/// Whatever a daemon opens at its start, it opens no pipe that nobody writes to, and reads nothing that has no end.
#[test]
fn files_that_are_none_end_the_start_with_a_reason() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let archive = folder.path().join("town.mapd");
    let mut compile = place.command();
    let compiled = compile.args(["compile", &town(), "-o"]).arg(&archive).output().expect("runs");
    assert!(compiled.status.success());
    let key = folder.path().join("map.pub");
    fs::write(
        &key,
        "untrusted comment: a key\nRWQf6LRCGA9i53mlYecO4IzT51TGPpvWucNSCh1CBM0QTaLn73Y7GFO3\n",
    )
    .expect("written");
    let (town, archive) = (town(), archive.display().to_string());
    let (key, stranger) = (key.display().to_string(), folder.path().join("stranger.mapd"));
    let name = stranger.display().to_string();
    let signature = format!("{archive}.minisig");
    for kind in STRANGERS {
        put(kind, &stranger);
        let mut commands = vec![
            vec!["--load", &town, "--config", &name],
            vec!["--load", &town, "--rules", &name],
            vec!["--load", &town, "--ontology", &name],
            vec!["--load", &archive, "--trust", &name],
        ];
        // A folder stands for the maps in it.
        if kind != "a folder" {
            commands.push(vec!["--load", &name]);
        }
        for args in commands {
            let child = place.command().args(&args).spawn().expect("starts");
            let output = ends(child, &format!("{kind}: {args:?}"));
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!([Some(1), Some(2)].contains(&output.status.code()), "{kind}: {args:?}: {said}");
            assert!(said.contains("not a file"), "{kind}: {args:?}: {said}");
        }
        put(kind, Path::new(&signature));
        let args = ["--load", &archive, "--trust", &key];
        let output = ends(place.command().args(args).spawn().expect("starts"), kind);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(4) && said.contains("not a file"), "{kind}: {said}");
        remove(&stranger);
        remove(Path::new(&signature));
    }
}
