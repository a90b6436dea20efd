//! Reads documents on standard input, each behind a line with its length in bytes: for each finding one line of fields between
//! tabs, then an empty line. The comparison with other validators (`tests/differential/structure.py`) drives it.

use mapd_xodr::{Finding, Limits, Reader};
use std::io::{self, BufRead, Read, Write};

fn main() -> io::Result<()> {
    let mut input = io::stdin().lock();
    let mut output = io::BufWriter::new(io::stdout().lock());
    let mut line = String::new();
    loop {
        line.clear();
        if input.read_line(&mut line)? == 0 {
            return output.flush();
        }
        let length = line.trim().parse().map_err(io::Error::other)?;
        let mut document = vec![0; length];
        input.read_exact(&mut document)?;
        let mut reader =
            Reader::new(&document[..], Limits { findings_of_a_kind: 10_000, ..Limits::default() });
        while reader.next()?.is_some() {}
        for finding in reader.take_findings() {
            print(&reader, &finding, &mut output)?;
        }
        writeln!(output)?;
        output.flush()?;
    }
}

/// Line, severity, rule, what it is about, path, message.
fn print(reader: &Reader<'_>, finding: &Finding, output: &mut impl Write) -> io::Result<()> {
    let line = reader.position(finding.span.start).line;
    let Finding { rule, severity, subject, path, message, .. } = finding;
    let fields = format!("{line}\t{severity:?}\t{rule}\t{subject}\t{path}\t{message}");
    writeln!(output, "{}", fields.replace(['\r', '\n'], " "))
}
