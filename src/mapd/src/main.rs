//! The `mapd` program: see the library.

#[global_allocator]
static ALLOCATOR: mapd::Allocator = mapd::Allocator;

fn main() -> std::process::ExitCode {
    mapd::cli::run()
}
