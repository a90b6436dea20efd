//! Finds what becomes of every element and attribute of OpenDRIVE, and writes `docs/coverage.md`.

use mapd_tests::{coverage, say, workspace};
use std::process::ExitCode;

fn main() -> ExitCode {
    let table = coverage::table();
    let (found, missing) = coverage::run(&table);
    for one in &missing {
        say(&format!("nothing shows {one}"));
    }
    let path = workspace().join("docs/coverage.md");
    if let Err(error) = std::fs::write(&path, coverage::page(&table, &found)) {
        say(&format!("{}: {error}", path.display()));
        return ExitCode::FAILURE;
    }
    if missing.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
