//! Numbers that are none, or too large: every option refuses them.

use clap::{Arg, Command};
use mapd_tests::command;

/// Not finite, in all spellings that a parser of numbers knows.
const NOT_FINITE: [&str; 7] = ["nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999"];

/// What numbers are, and text is as well.
const ONE: &str = "1";

/// What is no number, and text is.
const TEXT: &str = "x/y";

/// Whether a command takes an option with this value; positional arguments are filled in.
fn takes(line: &[&str], command: &Command, option: &Arg, value: &str) -> bool {
    let mut line: Vec<String> = line.iter().map(|word| (*word).to_owned()).collect();
    for positional in command.get_positionals().filter(|arg| arg.is_required_set()) {
        let known = positional.get_possible_values();
        line.push(known.first().map_or(TEXT, |value| value.get_name()).to_owned());
    }
    line.push(format!("--{}={value}", option.get_long().expect("a name")));
    match mapd::cli::command().try_get_matches_from(line) {
        Ok(_) => true,
        // What goes with it is not given; its value is taken.
        Err(error) => error.kind() == clap::error::ErrorKind::MissingRequiredArgument,
    }
}

#[test]
fn no_option_takes_a_number_that_is_not_finite() {
    let program = mapd::cli::command();
    let mut all = vec![(vec!["mapd"], &program)];
    let commands = program.get_subcommands();
    all.extend(commands.map(|command| (vec!["mapd", command.get_name()], command)));
    let mut numbers = 0;
    for (line, command) in all {
        let options = command.get_arguments().filter(|arg| arg.get_long().is_some());
        for option in options.filter(|arg| arg.get_action().takes_values()) {
            let takes = |value| takes(&line, command, option, value);
            if !takes(ONE) || takes(TEXT) {
                continue;
            }
            numbers += 1;
            for value in NOT_FINITE {
                assert!(!takes(value), "{line:?} --{} {value}", option.get_id());
            }
        }
    }
    assert!(numbers > 30, "{numbers} options take numbers");
}

/// `--jobs 0` and `--scrub 0` were refused with words about types.
#[test]
fn a_zero_is_refused_in_plain_words() {
    let program = env!("CARGO_BIN_EXE_mapd_under_test");
    let road = mapd_tests::carried("one_road.xodr").display().to_string();
    for line in [&["compile", &road, "--jobs", "0"][..], &["--load", &road, "--scrub", "0"]] {
        let output = command::run(program, line, "");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{line:?}: {said}");
        assert!(said.contains("expected a whole number of at least 1"), "{line:?}: {said}");
    }
}

/// `--threads 4000` once did not end.
#[test]
fn threads_are_bounded() {
    let program = env!("CARGO_BIN_EXE_mapd_under_test");
    let road = mapd_tests::carried("one_road.xodr").display().to_string();
    for (threads, code) in [("0", 2), ("513", 2), ("4000", 2), ("512", 0)] {
        let output = command::run(program, &["check", &road, "--threads", threads], "");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{threads}: {said}");
        assert!(code == 0 || said.contains("512"), "{threads}: {said}");
    }
}

/// A document type made every file that has one be rejected.
#[test]
fn a_document_type_is_a_warning() {
    let program = env!("CARGO_BIN_EXE_mapd_under_test");
    let folder = tempfile::tempdir().expect("a folder");
    let (file, archive) = (folder.path().join("m.xodr"), folder.path().join("m.mapd"));
    let [file, archive] = [file, archive].map(|path| path.display().to_string());
    let road = mapd_tests::carried("one_road.xodr");
    let road = std::fs::read_to_string(road).expect("it is carried");
    for kind in ["OpenDRIVE", "OpenDRIVE PUBLIC \"a\" \"b.dtd\"", "OpenDRIVE SYSTEM 'a.dtd' "] {
        let road = road.replacen("<OpenDRIVE", &format!("<!DOCTYPE {kind}><OpenDRIVE"), 1);
        std::fs::write(&file, road).expect("written");
        let output = command::run(program, &["compile", &file, "-o", &archive], "");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{kind}: {said}");
        assert!(said.contains("warning[mapd:xml.well_formed]"), "{kind}: {said}");
        assert!(!said.contains("error["), "{kind}: {said}");
    }
}
