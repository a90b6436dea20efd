//! What is wrong in options and input is refused where it is, not dropped.

use mapd_tests::command;
use std::process::{Command, Output, Stdio};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// Runs a command that is wrong in itself, and checks what it answers before and what it says.
fn refuses(args: &[&str], input: &str, answers: usize, said: &str) {
    let output = command::run(MAPD, args, input);
    let errors = errors(&output);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {errors}");
    assert!(errors.contains(said), "{args:?}: {errors}");
    let lines = output.stdout.iter().filter(|byte| **byte == b'\n').count();
    assert_eq!(lines, answers, "{args:?}: {}", String::from_utf8_lossy(&output.stdout));
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// They were dropped in silence.
#[test]
fn options_that_do_not_fit_the_format() {
    let map = town();
    for (format, option, formats) in [
        ("html", &["--report", "report.csv"][..], "lanelet2"),
        ("svg", &["--layers", "lanes"], "geojson or flatgeobuf"),
        ("flatgeobuf", &["--index-boxes"], "svg"),
        ("html", &["--route", "1,38,-1:3,30,-1"], "svg"),
        ("flatgeobuf", &["--origin", "48,11"], "geojson or lanelet2"),
        ("svg", &["--origin", "48,11"], "geojson or lanelet2"),
        ("geojson", &["--autoware"], "lanelet2"),
    ] {
        let args = [&["export", &map, "--format", format], option].concat();
        refuses(
            &args,
            "",
            0,
            &format!("{} goes with --format {formats}, not with {format}", option[0]),
        );
    }
}
