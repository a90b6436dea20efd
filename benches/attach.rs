//! From exec to the first answer, fresh processes, interleaved with the same program on plain open and mmap.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_benches::{percentiles, print};
use mapd_client::Domain;
use mapd_compiler::{CompileOptions, compile};
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Fresh processes of each kind.
const PROCESSES: usize = 60;

/// From before the process is made until its answer is here, and what else it says.
fn time(prefix: &str, how: &str, what: &str) -> (Duration, String) {
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_attach_probe"))
        .env("MAPD_PREFIX", prefix)
        .args([how, what])
        .stdout(Stdio::piped())
        .spawn()
        .expect("the probe runs");
    let mut out = child.stdout.take().expect("a pipe");
    let answered = out.read_exact(&mut [0]);
    let taken = start.elapsed();
    answered.expect("the probe found no answer");
    let mut rest = String::new();
    out.read_to_string(&mut rest).expect("the rest");
    assert!(child.wait().expect("ends").success());
    (taken, rest)
}

/// Medians of the phases of an attach.
fn phases(reports: &[String]) -> String {
    let names = ["lock", "node", "service", "subscriber", "receive"];
    let median = |(i, name): (usize, &&str)| {
        let mut values: Vec<u64> =
            reports.iter().filter_map(|report| report.split(' ').nth(i)?.parse().ok()).collect();
        values.sort_unstable();
        format!("{name} {} \u{b5}s", values.get(values.len() / 2).unwrap_or(&0))
    };
    names.iter().enumerate().map(median).collect::<Vec<_>>().join(", ")
}

/// An archive of half a gigabyte: the first map's, with a table blown up.
const LARGE: usize = 512 << 20;

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let (name, path) = mapd_benches::small_map();
    for (size, bytes) in [("as it is", 0), ("blown up", LARGE)] {
        let prefix = format!("mapdbench{}_", std::process::id());
        let domain = Domain::new(&prefix).expect("a prefix");
        let file = std::fs::File::open(&path).expect("the map opens");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let mut rows = compiled.rows.expect("accepted");
        let numbers = rows.coefficients.len().max(bytes / size_of::<f64>());
        rows.coefficients.resize(numbers, 0.0);
        let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
        drop(rows);
        let saved = folder.path().join(format!("{name}.mapd"));
        std::fs::write(&saved, &archive).expect("written");
        let saved = saved.display().to_string();
        let stop = StopSignal::new().expect("a signal");
        let (ready, served) = std::sync::mpsc::channel();
        std::thread::scope(|scope| {
            let (domain, stop_here, bytes) = (&domain, &stop, &archive);
            scope.spawn(move || {
                let mut server = Server::start(domain).expect("starts");
                let fill = |loan: &mut [u8]| {
                    loan.copy_from_slice(bytes);
                    Ok(PublishMeta {
                        layout_id: [0; 32],
                        content_hash: mapd_archive::open(bytes)?.header.content_hash,
                        input_hash: [0; 32],
                    })
                };
                server.publish(name, bytes.len(), fill).expect("publishes");
                ready.send(()).expect("told");
                server.run(stop_here).expect("serves");
            });
            served.recv().expect("served");
            let (mut plain, mut reports) = (Vec::new(), Vec::new());
            let mut shared = [("observer", "shm"), ("subscriber", "subscriber")]
                .map(|(title, how)| (title, how, Vec::new()));
            for _ in 0..PROCESSES {
                plain.push(time(&prefix, "file", &saved).0);
                for (_, how, times) in &mut shared {
                    let (taken, report) = time(&prefix, how, name);
                    times.push(taken);
                    reports.extend(Some(report).filter(|report| !report.is_empty()));
                }
            }
            let (plain, plain99) = percentiles(plain);
            for (title, _, times) in shared {
                let (shared, shared99) = percentiles(times);
                print(&format!(
                    "attach {name} {size} ({} B) as {title}: exec to first answer p50 {shared:.2?} p99 {shared99:.2?}; open+mmap p50 {plain:.2?} p99 {plain99:.2?}; ratio {:.2}",
                    archive.len(),
                    shared.as_secs_f64() / plain.as_secs_f64()
                ));
            }
            print(&format!("  phases, medians: {}", phases(&reports)));
            stop.request();
        });
        let _ = std::fs::remove_dir_all(domain.root());
    }
}
