//! Files that are not what their names say: pipes that nobody writes to, folders, devices that never end, other maps' archives.

use mapd_client::{Attach, Client};
use mapd_tests::small::{in_read_only_folder, in_small_folder};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::two_maps::TwoMaps;
use std::fs;
use std::io::Write;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Bytes of a file system in which no archive of the town fits.
const TOO_SMALL: u64 = 32 << 10;

/// Bytes of one in which a few do.
const ROOM: u64 = 2 << 20;

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

/// The number that a full cache did not take was handed out again, for another map: a reader that had it never saw that one.
#[test]
fn a_full_cache_repeats_no_generation() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let map = maps.path().display().to_string();
    fs::create_dir(place.cache()).expect("made");
    in_small_folder(place.cache(), ROOM, || {
        let generation = || place.state("map").served.expect("served").generation;
        let daemon = place.serve(&[&map]);
        let mut last = generation();
        assert_eq!(daemon.stop(), 0);
        for full in ["filler", "filler2"] {
            // A page less than is left is room for nothing, too.
            let mut filler = fs::File::create(place.cache().join(full)).expect("made");
            while filler.write_all(&[0; 1000]).is_ok() {}
        }
        let mut client = None;
        for (number, is_lost) in [(0, false), (1, true), (0, false), (1, false)] {
            maps.put(number);
            let daemon = place.serve(&[&map]);
            let next = generation();
            assert!(next > last, "{next} after {last}");
            last = next;
            let attach = || Client::connect_as(Attach::Observer, &place.domain(), "map", PATIENCE);
            let client = client.get_or_insert_with(|| attach().expect("attaches"));
            let newest = client.refresh().expect("the newest");
            assert_eq!(newest.generation(), last);
            assert!(maps.is(&newest, number));
            assert_eq!(daemon.stop(), 0);
            if is_lost {
                let _ = fs::remove_dir_all(place.domain().root());
            }
        }
    });
}

/// A cache on a read-only disk ended the start, whatever lay in it.
#[test]
fn a_read_only_cache_is_read() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let map = maps.path().display().to_string();
    assert_eq!(place.serve(&[&map]).stop(), 0);
    let there = files(place.cache());
    in_read_only_folder(place.cache(), || {
        let mut last = 0;
        for (number, from_cache) in [(0, true), (1, false), (0, true)] {
            maps.put(number);
            let mut daemon = place.start(&[&map]);
            let said = daemon.wait_for_serving().expect("serves");
            assert!(said.contains("nothing is added"), "{said}");
            let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
            assert!(maps.is(&client.snapshot(), number));
            let served = place.state("map").served.expect("served");
            assert_eq!(served.from_cache, from_cache, "{said}");
            assert!(served.generation > last);
            last = served.generation;
            drop(client);
            assert_eq!(daemon.stop(), 0);
        }
    });
    assert_eq!(files(place.cache()), there);
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
    let document = folder.path().join("stranger.xodr");
    let map = document.display().to_string();
    let signature = format!("{archive}.minisig");
    for kind in STRANGERS {
        put(kind, &stranger);
        put(kind, &document);
        let mut commands = vec![
            vec!["--load", &town, "--config", &name],
            vec!["--load", &town, "--rules", &name],
            vec!["--load", &town, "--ontology", &name],
            vec!["--load", &archive, "--trust", &name],
        ];
        // A folder stands for the maps in it.
        if kind != "a folder" {
            commands.push(vec!["--load", &name]);
            commands.push(vec!["--load", &map]);
            commands.push(vec!["--load", &map, "--watch"]);
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
        remove(&document);
        remove(Path::new(&signature));
    }
}

/// They reached terminals and logs as they are, where ids of maps do not.
#[test]
fn names_of_files_do_nothing_to_a_terminal() {
    const NAME: &str = "a\u{1b}]0;title\u{7}\r\nforged \u{202e}\u{9b}2Jz";
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let path = |end: &str| folder.path().join(format!("{NAME}{end}")).display().to_string();
    let (map, archive, missing) = (path(".xodr"), path(".mapd"), path("-missing.xodr"));
    let text = fs::read_to_string(town()).expect("the town");
    // With a finding.
    fs::write(&map, text.replacen("<road ", "<road odd=\"1\" ", 1)).expect("written");
    let bad = path("-bad.xodr");
    fs::write(&bad, "<OpenDRIVE>").expect("written");
    let other = folder.path().join("tiles").display().to_string();
    let config = path(".toml");
    fs::write(&config, format!("[[map]]\nfile = {:?}\nname = \"m\"\nwatch = 3", "x.xodr"))
        .expect("written");
    let is_seen = |what: &str, said: &[u8]| {
        let said = String::from_utf8_lossy(said);
        let is_unseen = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!said.contains(is_unseen), "{what}: {said:?}");
        assert!(!said.lines().any(|line| line.starts_with("forged")), "{what}: {said}");
    };
    let run = |args: &[&str]| {
        let output = ends(place.command().args(args).spawn().expect("starts"), NAME);
        is_seen(&format!("{args:?}"), &[&output.stdout[..], b"\n", &output.stderr].concat());
        // A map that is drawn is nothing to tell.
        assert!(args[0] == "export" || output.stdout.len() + output.stderr.len() > 0, "{args:?}");
    };
    for file in [&map, &bad, &missing, &config, &"-\u{1b}c".to_owned()] {
        run(&["check", file]);
        run(&["inspect", file]);
        run(&["inspect", file, "--verify"]);
        run(&["compile", file, "-o", &archive]);
        run(&["compile", file, "-o", &archive, "--max-memory", "4GiB", "--progress-interval", "1"]);
        run(&["compile", file, "--output-dir", &other]);
        run(&["export", file, "--format", "svg", "-o", &missing]);
        run(&["query", file, "nearest"]);
        run(&["doctor", file]);
        run(&["doctor", "--config", file]);
        run(&["sign", file, "--key", &missing]);
        run(&["overlay", "m", "apply", file]);
        run(&["--config", file]);
        run(&["--load", &bad, "--name", "m", "--cache", file]);
        run(&["check", &map, "--rules", file]);
        run(&["check", &map, "--ontology", file]);
        run(&[file, "--help"]);
        run(&["check", &format!("--{file}")]);
    }
    for load in [&bad, &missing] {
        run(&["--load", load]);
        run(&["--load", load, "--name", "m"]);
    }
    // A reload that fails names the file in the log, to who asked for it, and in the status.
    let mut command = place.command();
    let mut child = command.args(["--load", &map, "--name", "m"]).spawn().expect("starts");
    assert!(place.state("m").served.is_some());
    fs::remove_file(&map).expect("removed");
    let _ = place.reload("m");
    run(&["reload", "m"]);
    run(&["status"]);
    run(&["doctor"]);
    let killed = Command::new("kill").arg(child.id().to_string()).status().expect("runs");
    assert!(killed.success());
    let mut said = Vec::new();
    let mut stderr = child.stderr.take().expect("stderr");
    std::io::Read::read_to_end(&mut stderr, &mut said).expect("readable");
    child.wait().expect("ends");
    is_seen("the log", &said);
    assert!(String::from_utf8_lossy(&said).contains("reload: failed"));
}
