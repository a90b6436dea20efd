//! Limits of a process: a daemon that may open too few files, a client likewise, files that may not grow, memory that is not there.
//! Each ends with an exit code and a reason, never by a signal.

use mapd_tests::test_domain::TestDomain;
use std::process::{Command, Output, Stdio};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Steps above the least memory in which the program starts at all \[KiB\].
const STEP: u64 = 512;

/// How many of them are tried; the last has room for everything.
const STEPS: u64 = 64;

/// What a client waits under each limit \[s\]: many of them time out. A busy machine may be too slow for a short wait, which says nothing of the limit: then it waits
/// longer. After the last one the outcome counts whatever it is.
const WAITS: [&str; 4] = ["0.05", "0.5", "4", "20"];

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// The program with these arguments, within a limit.
fn within(place: &TestDomain, limit: &str, args: &[&str]) -> Command {
    let mut command = place.command_of("sh");
    command.args(["-c", &format!("ulimit {limit}; exec \"$0\" \"$@\""), MAPD]).args(args);
    command
}

fn run(place: &TestDomain, limit: &str, args: &[&str]) -> (Option<i32>, String) {
    let Output { status, stderr, .. } = within(place, limit, args).output().expect("ends");
    (status.code(), String::from_utf8_lossy(&stderr).into_owned())
}

/// Too few descriptors once were `InternalFailure`, with the advice to stop every process of the domain.
#[test]
fn too_few_descriptors_are_named() {
    let place = TestDomain::new(MAPD);
    let town = town();
    let is_named = |said: &str| said.contains("ulimit -n") || said.contains("Too many open files");
    let (mut served, mut refused) = (0, 0);
    for most in 5..48 {
        let limit = format!("-n {most}");
        let mut daemon = place.spawn(within(&place, &limit, &["--no-cache", "--load", &town]));
        match daemon.wait_for_serving() {
            Ok(_) => {
                served += 1;
                daemon.stop();
            }
            Err(said) => {
                refused += 1;
                assert!(is_named(&said) && !said.contains("stop every"), "{most}: {said}");
            }
        }
    }
    assert!(served > 0 && refused > 0, "{served} served, {refused} refused");
    let daemon = place.serve(&[&town]);
    for attach in ["subscriber", "observer"] {
        let (mut answered, mut refused) = (0, 0);
        for most in 5..48 {
            let limit = format!("-n {most}");
            let (mut code, mut said) = (None, String::new());
            for wait in WAITS {
                let args = ["inspect", "shm:town", "--wait", wait, "--attach", attach];
                (code, said) = run(&place, &limit, &args);
                // Only that a wait ran out says nothing of the limit.
                let is_orderly = matches!(code, Some(0 | 1)) && !said.contains("stop every");
                assert!(is_orderly, "{most}, {wait} s: {code:?} {said}");
                if code == Some(0) || is_named(&said) {
                    break;
                }
            }
            match code {
                Some(0) => answered += 1,
                _ => {
                    refused += 1;
                    assert!(code == Some(1) && is_named(&said), "{most}: {code:?} {said}");
                    assert!(!said.contains("stop every"), "{most}: {said}");
                }
            }
        }
        // An observer needs one at a time.
        let as_it_should = (refused > 0) == (attach == "subscriber");
        assert!(answered > 0 && as_it_should, "{attach}: {answered} answered, {refused} refused");
    }
    drop(daemon);
}

/// SIGXFSZ once ended a process that wrote beyond the limit.
#[test]
fn a_limit_of_file_sizes_is_an_error() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let archive = folder.path().join("town.mapd").display().to_string();
    let town = town();
    // Blocks of 512 bytes or of 1,024, as the shell has it: too few in both.
    for args in [&["compile", &town, "-o", &archive][..], &["--load", &town]] {
        let (code, said) = run(&place, "-f 8", args);
        assert!(code == Some(1) && said.contains("File too large"), "{args:?}: {code:?} {said}");
    }
    assert!(!std::path::Path::new(&archive).exists());
}

/// The least address space in which the program says its version \[KiB\], to a step.
fn least(place: &TestDomain) -> u64 {
    let starts = |kib: u64| run(place, &format!("-v {kib}"), &["--version"]).0 == Some(0);
    let (mut too_few, mut enough) = (0, 1 << 21);
    assert!(starts(enough), "2 GiB are enough to say a version");
    while enough - too_few > STEP {
        let middle = (too_few + enough) / 2;
        if starts(middle) { enough = middle } else { too_few = middle }
    }
    enough
}

/// Want of address space was told as want of what --max-memory allows.
#[test]
fn a_limit_of_address_space_is_named() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let archive = folder.path().join("town.mapd").display().to_string();
    let town = town();
    let args = ["compile", &town, "-o", &archive, "--quiet", "--max-memory", "64GiB"];
    let (mut named, mut done) = (0, 0);
    let least = least(&place);
    for step in 0..STEPS {
        let limit = format!("-v {}", least + step * STEP);
        let (code, said) = run(&place, &limit, &args);
        assert!(!said.contains("--max-memory"), "{limit}: {code:?} {said}");
        named += usize::from(code == Some(1) && said.contains("ulimit -v"));
        done += usize::from(code == Some(0));
    }
    assert!(named > 0 && done > 0, "{named} named, {done} done");
}

/// Just above the least memory in which it starts, a program once ended by SIGABRT or a panic.
#[test]
fn too_little_memory_is_an_exit_code() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let archive = folder.path().join("town.mapd").display().to_string();
    let town = town();
    let enough = least(&place);
    for args in [
        &["compile", &town, "-o", &archive, "--quiet"][..],
        &["check", &town],
        &["query", &town, "nearest"],
    ] {
        let mut codes = Vec::new();
        for step in 0..STEPS {
            let limit = format!("-v {}", enough + step * STEP);
            let mut command = within(&place, &limit, args);
            let output = command.stdin(Stdio::null()).output().expect("ends");
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            let code = output.status.code();
            // 2: a query of nothing has no columns.
            let is_known = matches!(code, Some(0..=3));
            assert!(is_known, "{args:?} {limit}: {:?} {said}", output.status);
            codes.push(code);
        }
        assert!(codes.contains(&Some(1)), "{args:?}: the first steps are not enough: {codes:?}");
        assert_ne!(codes.last(), Some(&Some(1)), "{args:?}: the last one is: {codes:?}");
    }
}
