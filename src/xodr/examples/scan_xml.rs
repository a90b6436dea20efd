//! Judges documents on standard input, each behind a line with its length in bytes: one line of output per document, `ok` or
//! the first error with its place. The comparison with libxml2 (`tests/differential/well_formed.py`) drives it.

use mapd_xodr::source::{Inputs, Places, SourceLimits};
use mapd_xodr::well_formed::scan;
use mapd_xodr::{Limits, Severity};
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
        writeln!(output, "{}", judge(&document)?)?;
        output.flush()?;
    }
}

/// The verdict on one document.
fn judge(document: &[u8]) -> io::Result<String> {
    let mut inputs = Inputs::new(SourceLimits::default());
    let source = inputs.open(Box::new(document), "");
    let scan = scan(source, &Limits { depth: 256, ..Limits::default() })?;
    let faults = scan.faults.iter().filter(|(_, fault)| fault.severity() == Severity::Error);
    let faults = faults.map(|(start, fault)| (*start, fault.to_string()));
    let notes = scan.notes.iter().filter(|note| note.kind.is_error());
    let notes = notes.map(|note| (note.start, note.kind.to_string()));
    let refusal = scan.refusal.iter().map(|refusal| (refusal.start, refusal.to_string()));
    let deep = scan.too_deep.iter().map(|start| (*start, "too deep".to_owned()));
    let first = faults.chain(notes).chain(refusal).chain(deep).min_by_key(|(start, _)| *start);
    let tolerated = scan.faults.iter().map(|(_, fault)| fault.to_string());
    let tolerated = tolerated.chain(scan.notes.iter().map(|note| note.kind.to_string())).next();
    Ok(match (first, tolerated) {
        (Some((start, message)), _) => {
            let place = inputs.places().place(Places::start(0, start)).position;
            format!("error {}:{} {message}", place.line, place.column)
        }
        (None, Some(message)) => format!("tolerated {message}"),
        (None, None) => "ok".to_owned(),
    })
}
