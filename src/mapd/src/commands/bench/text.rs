//! Figures as a table.

use super::Report;
use super::figures::{Comparison, Figures};
use crate::printable::printable;
use crate::rounded;
use std::io::{self, Write};

/// Width of the first column.
const WHAT: usize = 36;

/// Prints everything.
///
/// Errors: writing fails.
pub(super) fn print(report: &Report<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "{}: generation {}, {}, {} lanes, content {}",
        printable(&report.source),
        report.generation,
        rounded::bytes(report.bytes as f64),
        report.lanes,
        report.content_hash
    )?;
    writeln!(out, "{} cores, Linux {}", report.cores, report.kernel)?;
    if report.debug_build {
        writeln!(out, "this program was built without optimisation: build it with --release")?;
    }
    writeln!(
        out,
        "\n{:WHAT$}{:>8}  {:^39}  {:^39}  {:>6}",
        "", "", "served", "open + mmap", "ratio"
    )?;
    let head = |out: &mut dyn Write| {
        for name in ["p50", "p90", "p99", "max"] {
            write!(out, "{name:>9} ")?;
        }
        write!(out, " ")
    };
    write!(out, "{:WHAT$}{:>8} ", "what", "count")?;
    head(out)?;
    head(out)?;
    writeln!(out, "{:>6}", "p50")?;
    for line in report.boot.comparisons.iter().chain(&report.queries) {
        row(line, out)?;
    }
    let [shared, file] = report.boot.all_answered_ns.map(span);
    writeln!(
        out,
        "\nall clients at once: the last had its answer after {shared}, with open + mmap after {file}"
    )?;
    let [shared, file] = report.boot.first_query_faults;
    writeln!(out, "minor page faults of the first query: {shared}, with open + mmap {file}")
}

fn row(line: &Comparison, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{:WHAT$}{:>8} ", line.what, line.shared.count)?;
    for Figures { p50_ns, p90_ns, p99_ns, max_ns, .. } in [line.shared, line.file] {
        for time in [p50_ns, p90_ns, p99_ns, max_ns] {
            write!(out, "{:>9} ", span(time))?;
        }
        write!(out, " ")?;
    }
    writeln!(out, "{:>6.2}", line.ratio_p50)
}

/// A time with three digits and its unit.
fn span(nanoseconds: u64) -> String {
    let time = nanoseconds as f64;
    match nanoseconds {
        0..1_000 => format!("{nanoseconds} ns"),
        1_000..10_000 => format!("{:.2} \u{b5}s", time / 1e3),
        10_000..1_000_000 => format!("{:.0} \u{b5}s", time / 1e3),
        1_000_000..100_000_000 => format!("{:.2} ms", time / 1e6),
        100_000_000..1_000_000_000 => format!("{:.0} ms", time / 1e6),
        _ => format!("{:.2} s", time / 1e9),
    }
}
