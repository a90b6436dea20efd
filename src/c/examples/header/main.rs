//! Writes `include/mapd.h` from the crate's sources. `--check` only says whether it is what they yield.

mod text;

use std::process::ExitCode;

fn main() -> ExitCode {
    let check = std::env::args().skip(1).any(|argument| argument == "--check");
    let (path, header) = (text::path(), text::header());
    let is_same = std::fs::read_to_string(&path).is_ok_and(|old| old == header);
    if is_same {
        return ExitCode::SUCCESS;
    }
    if !check && std::fs::write(&path, header).is_ok() {
        return ExitCode::SUCCESS;
    }
    use std::io::Write as _;
    let remedy = "is not what the sources yield; run `cargo run -p mapd-c --example header`";
    let _ = writeln!(std::io::stderr(), "{} {remedy}", path.display());
    ExitCode::FAILURE
}
