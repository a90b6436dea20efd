//! The README's first screen prints what the README says that it prints.

use mapd_tests::command;

/// The block of code of a kind that follows these words.
fn block<'a>(page: &'a str, words: &str, kind: &str) -> &'a str {
    let fence = format!("```{kind}\n");
    let (_, behind) = page.split_once(words).unwrap_or_else(|| panic!("no {words:?}"));
    let (_, block) = behind.split_once(&fence).expect("a block of code");
    block.split_once("```").expect("its end").0
}

#[test]
fn the_first_command_prints_the_sample() {
    let readme = std::fs::read_to_string(mapd_tests::workspace().join("README.md")).expect("read");
    let command = block(&readme, "# mapd", "sh");
    let (_, input) = command.split_once("printf '").expect("an input");
    let input = input.split_once('\'').expect("its end").0.replace("\\n", "\n");
    assert!(command.contains("--load examples/maps/town.xodr"), "{command}");
    let town = mapd_tests::carried("town.xodr").display().to_string();
    let args = ["query", &town, "nearest"];
    let output = command::run(env!("CARGO_BIN_EXE_mapd_under_test"), &args, &input);
    let sample = block(&readme, "The first command prints", "text");
    assert_eq!(String::from_utf8_lossy(&output.stdout), sample);
}
