//! Writes the town that the project carries to stdout: `cargo run -p mapd-tests --bin make_town > examples/maps/town.xodr`.

use std::io::Write;

fn main() -> std::io::Result<()> {
    std::io::stdout().write_all(mapd_tests::town::town(3, 3).as_bytes())
}
