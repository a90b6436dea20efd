//! The `mapd` program, built with the tests so that they find it.

mapd::program!();

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
