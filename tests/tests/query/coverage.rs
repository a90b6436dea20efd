//! Every value of the schema arrives: written in two ways, it makes two archives.

use mapd_tests::{coverage, workspace};

#[test]
fn the_page_says_what_becomes_of_every_value() {
    let table = coverage::table();
    let (found, missing) = coverage::run(&table);
    assert!(missing.is_empty(), "nothing shows {missing:?}");
    let page = std::fs::read_to_string(workspace().join("docs/coverage.md")).expect("the page");
    let new = coverage::page(&table, &found);
    let differs = page.lines().zip(new.lines()).find(|(old, new)| old != new);
    assert!(page == new, "run `cargo run -p mapd-tests --bin coverage`: {differs:?}");
}
