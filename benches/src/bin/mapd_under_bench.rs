//! The `mapd` program, built with the benchmarks so that they find it.

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
