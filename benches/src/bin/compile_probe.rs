//! One process that compiles a map a number of times, without landmarks: `compile_probe PATH COUNT`, for counting
//! instructions.

use mapd_compiler::{CompileOptions, compile};
use std::hint::black_box;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, count] = args.as_slice() else { return ExitCode::from(2) };
    let Ok(count) = count.parse::<usize>() else { return ExitCode::from(2) };
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    for _ in 0..count {
        let Ok(file) = std::fs::File::open(path) else { return ExitCode::from(1) };
        let compiled = compile(file, &options, &mut |_| {});
        let Some(rows) = compiled.ok().and_then(|compiled| compiled.rows) else {
            return ExitCode::from(1);
        };
        black_box(rows);
    }
    ExitCode::SUCCESS
}
