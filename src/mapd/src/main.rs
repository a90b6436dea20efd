//! The `mapd` program: see the library.

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
