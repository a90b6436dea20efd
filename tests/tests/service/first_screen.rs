//! The program on the README's first screen, word for word, works at boot in any order of starting.

use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::process::Child;
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_first_screen");

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// What the README shows is what is built, but for the lines that say what the file is and how it is checked.
#[test]
fn the_readme_shows_this_program() {
    let read =
        |path: &str| std::fs::read_to_string(mapd_tests::workspace().join(path)).expect("read");
    let program = read("examples/first_screen.rs");
    let code = program
        .lines()
        .filter(|line| !line.starts_with("//!") && !line.starts_with("#!["))
        .collect::<Vec<_>>()
        .join("\n");
    let readme = read("README.md");
    assert!(readme.contains(code.trim()), "the README shows another program than\n{code}");
}

fn start(place: &TestDomain) -> Child {
    place.command_of(PROGRAM).spawn().expect("starts")
}

/// It ends well, with its answer.
fn answers(child: Child) {
    let output = child.wait_with_output().expect("ends");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "lane 1:0:-1 at s = 38\n");
}

#[test]
fn in_any_order_of_starting() {
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    // Before there is any daemon.
    let first = start(&place);
    std::thread::sleep(Duration::from_millis(300));
    // While it compiles: started and not waited for.
    let mut daemon = place.start(&[&town()]);
    let during = start(&place);
    daemon.wait_until_serving();
    let after = start(&place);
    [first, during, after].into_iter().for_each(answers);
    // Between two daemons, one of which was killed.
    daemon.kill();
    let between = start(&place);
    std::thread::sleep(Duration::from_millis(300));
    let _successor = place.serve(&[&town()]);
    let begun = Instant::now();
    answers(between);
    assert!(begun.elapsed() < PATIENCE);
    // Ten at once with another daemon for another map, as at boot.
    let one_road = mapd_tests::carried("one_road.xodr").display().to_string();
    let _other = place.start(&[&one_road]);
    let all: Vec<Child> = (0..10).map(|_| start(&place)).collect();
    all.into_iter().for_each(answers);
}
