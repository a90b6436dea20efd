//! From exec to the first answer, fresh processes, interleaved with the same program on plain open and mmap.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_benches::{maps, percentiles, print};
use mapd_client::Domain;
use mapd_compiler::{CompileOptions, compile};
use std::process::Command;
use std::time::{Duration, Instant};

/// Fresh processes of each kind.
const PROCESSES: usize = 60;

fn time(prefix: &str, how: &str, what: &str) -> Duration {
    let start = Instant::now();
    let status = Command::new(env!("CARGO_BIN_EXE_attach_probe"))
        .env("MAPD_PREFIX", prefix)
        .args([how, what])
        .status()
        .expect("the probe runs");
    assert!(status.success(), "the probe found no answer");
    start.elapsed()
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        let prefix = format!("mapdbench{}_", std::process::id());
        let domain = Domain::new(&prefix).expect("a prefix");
        let file = std::fs::File::open(&path).expect("the map opens");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let rows = compiled.rows.expect("accepted");
        let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
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
                        content_hash: [0; 32],
                        input_hash: [0; 32],
                    })
                };
                server.publish(name, bytes.len(), fill).expect("publishes");
                ready.send(()).expect("told");
                server.run(stop_here).expect("serves");
            });
            served.recv().expect("served");
            let (mut shared, mut plain) = (Vec::new(), Vec::new());
            for _ in 0..PROCESSES {
                plain.push(time(&prefix, "file", &saved));
                shared.push(time(&prefix, "shm", name));
            }
            let ((shared, shared99), (plain, plain99)) = (percentiles(shared), percentiles(plain));
            print(&format!(
                "attach {name} ({} B): exec to first answer p50 {shared:.2?} p99 {shared99:.2?}; open+mmap p50 {plain:.2?} p99 {plain99:.2?}; ratio {:.2}",
                archive.len(),
                shared.as_secs_f64() / plain.as_secs_f64()
            ));
            stop.request();
        });
        let _ = std::fs::remove_dir_all(domain.root());
    }
}
