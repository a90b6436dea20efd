//! Writes `include/mapd.h` and `include/mapd/queries.hpp` from the crate's sources. `--check` only says whether they are what the sources yield.

mod cpp;
mod text;

use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let check = std::env::args().skip(1).any(|argument| argument == "--check");
    let of_cpp = match cpp::header(text::SOURCES) {
        Ok(header) => header,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "{error}");
            return ExitCode::FAILURE;
        }
    };
    let mut verdict = ExitCode::SUCCESS;
    for (path, header) in [(text::path(), text::header()), (cpp::path(), of_cpp)] {
        let is_same = std::fs::read_to_string(&path).is_ok_and(|old| old == header);
        if is_same || !check && std::fs::write(&path, header).is_ok() {
            continue;
        }
        let remedy = "is not what the sources yield; run `cargo run -p mapd-c --example header`";
        let _ = writeln!(std::io::stderr(), "{} {remedy}", path.display());
        verdict = ExitCode::FAILURE;
    }
    verdict
}
