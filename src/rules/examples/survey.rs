//! How many findings of each rule each map has: `survey FILE…`. What to look at before a rule's severity is chosen.

use mapd_rules::{Checker, Profile, Settings};
use mapd_xodr::{Limits, Reader, Severity};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;

fn main() -> io::Result<()> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let profile = match arguments.first().and_then(|first| first.strip_prefix("--profile=")) {
        Some(name) => Profile::named(name).unwrap_or_default(),
        None => Profile::Default,
    };
    arguments.retain(|argument| !argument.starts_with("--"));
    let mut out = io::stdout().lock();
    let settings = Settings { profile, ..Settings::default() };
    for file in &arguments {
        let start = Instant::now();
        let mut reader = Reader::open(Path::new(file), Limits::default())?;
        let mut checker = Checker::new(&settings);
        let mut checking = 0.0;
        while let Some(mut item) = reader.next()? {
            let before = Instant::now();
            checker.item(&mut item);
            checking += before.elapsed().as_secs_f64();
        }
        let before = Instant::now();
        checker.finish();
        let network = before.elapsed().as_secs_f64();
        let total = start.elapsed().as_secs_f64();
        writeln!(
            out,
            "== {file} total {total:.2} s, elements {checking:.2} s, network {network:.2} s"
        )?;
        let mut counts: BTreeMap<(Severity, &str), (usize, String)> = BTreeMap::new();
        for finding in checker.take_findings() {
            let entry = counts.entry((finding.severity, finding.rule)).or_insert_with(|| {
                let place = reader.position(finding.span.start);
                (0, format!("{}:{} {}", place.line, finding.path, finding.message))
            });
            entry.0 += 1;
        }
        for ((severity, rule), (count, first)) in counts.iter().rev() {
            writeln!(out, "{severity:?}\t{count}\t{rule}\t{first}")?;
        }
    }
    Ok(())
}
