//! The `mapd` program, built with the tests so that they find it.

#[global_allocator]
static ALLOCATOR: mapd::Allocator = mapd::Allocator;

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
