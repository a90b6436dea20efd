//! One process that compiles a map and encodes its archive: `pile_probe PATH`, for counting instructions. It prints the bytes of the archive, 0 where the map is
//! rejected, and the most memory `[bytes]` that the process has had.

use mapd_compiler::{CompileOptions, ReadOptions, compile_from};
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(path) = std::env::args().nth(1) else { return ExitCode::from(2) };
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let from = || std::fs::File::open(&path);
    let Ok(compiled) = compile_from(from, &reading, &options, &mut |_| {}) else {
        return ExitCode::from(1);
    };
    let encoded =
        compiled.rows.as_ref().map(|rows| mapd_archive::encode(rows, &compiled.provenance));
    let bytes = match encoded {
        Some(Ok(archive)) => archive.len(),
        Some(Err(_)) => return ExitCode::from(1),
        None => 0,
    };
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let peak = peak.and_then(|line| line.trim().trim_end_matches(" kB").parse::<usize>().ok());
    match writeln!(std::io::stdout(), "{bytes} {}", peak.unwrap_or_default() * 1024) {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::from(1),
    }
}
