//! Compile throughput against quick-xml's own loop over events, attributes and numbers.

use mapd_benches::{best, maps, print};
use mapd_compiler::{CompileOptions, compile};
use quick_xml::events::Event;
use std::hint::black_box;
use std::path::Path;

/// The floor: every event, every attribute, every number.
fn floor(path: &Path) -> f64 {
    let mut reader = quick_xml::Reader::from_file(path).expect("the map opens");
    let mut buffer = Vec::new();
    let mut sum = 0.0;
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer).expect("well-formed") {
            Event::Start(tag) | Event::Empty(tag) => {
                for attribute in tag.attributes() {
                    let value = attribute.expect("an attribute").value;
                    sum += value.parse::<f64>().unwrap_or(0.0);
                }
            }
            Event::Eof => return sum,
            _ => {}
        }
    }
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        let bytes = std::fs::metadata(&path).expect("the map").len();
        let runs = if bytes > 50_000_000 { 3 } else { 10 };
        let bare = best(runs, || {
            black_box(floor(&path));
        });
        let mut size = 0;
        let whole = best(runs, || {
            let file = std::fs::File::open(&path).expect("the map opens");
            let compiled =
                compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
            let rows = compiled.rows.expect("accepted");
            let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
            size = archive.len();
            mapd_archive::verify(&archive).expect("proves");
        });
        let rate = bytes as f64 / whole.as_secs_f64() / 1e6;
        print(&format!(
            "compile {name}: {bytes} B to a verified archive of {size} B in {whole:.1?} ({rate:.0} MB/s); bare quick-xml loop {bare:.1?}; ratio {:.2}",
            whole.as_secs_f64() / bare.as_secs_f64()
        ));
    }
}
