//! One process that compiles a map a number of times, without landmarks: `compile_probe PATH PATCH COUNT`, for counting
//! instructions. PATCH is `-` for none.

use mapd_compiler::{CompileOptions, ReadOptions, compile_from};
use mapd_xodr::Patch;
use std::hint::black_box;
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, patch, count] = args.as_slice() else { return ExitCode::from(2) };
    let Ok(count) = count.parse::<usize>() else { return ExitCode::from(2) };
    let options = CompileOptions { landmarks: 0, ..CompileOptions::default() };
    for _ in 0..count {
        let mut reading = ReadOptions::default();
        if patch != "-" {
            let Ok(text) = std::fs::read(patch) else { return ExitCode::from(1) };
            let read = Patch::removing(Vec::new()).with_document(patch.into(), text);
            let Ok(read) = read else { return ExitCode::from(1) };
            reading.patch = Some(Arc::new(read));
        }
        let from = || std::fs::File::open(path);
        let compiled = compile_from(from, &reading, &options, &mut |_| {});
        let Some(rows) = compiled.ok().and_then(|compiled| compiled.rows) else {
            return ExitCode::from(1);
        };
        black_box(rows);
    }
    ExitCode::SUCCESS
}
