//! The `mapd` program: see the library.

mapd::program!();

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
