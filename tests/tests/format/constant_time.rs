//! Attaching costs the same for every size, and nobody but the daemon can write: counted faults, mapped rights.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_archive::{Provenance, Rows, encode_into, encoded_length};
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::collections::BTreeMap;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;
use std::sync::{Mutex, PoisonError, mpsc};

const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// Pages that the checked access may touch for the first time: that of the header and that of the tables' places.
const FAULTS: u64 = 2;

/// Signal number of a forbidden access to memory.
const SIGSEGV: i32 = 11;

/// One test at a time looks how much room there is, and takes it.
static ROOM: Mutex<()> = Mutex::new(());

/// Rows of about this many bytes; the large table is plain numbers, as all are.
fn rows(bytes: usize) -> Rows {
    let mut rows = Rows::default();
    rows.coefficients.resize(bytes / size_of::<f64>(), 1.0);
    rows
}

/// Runs the probe and returns its report.
fn probe(place: &TestDomain, kind: &str) -> (BTreeMap<String, String>, std::process::ExitStatus) {
    let output = place.command_of(PROBE).args([kind, "big"]).output().expect("the probe runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let pair = |line: &str| line.split_once(' ').map(|(k, v)| (k.to_owned(), v.to_owned()));
    (text.lines().filter_map(pair).collect(), output.status)
}

/// Serves an archive of this size while `work` runs.
fn while_serving(place: &TestDomain, bytes: usize, work: impl FnOnce()) {
    let rows = rows(bytes);
    let length = encoded_length(&rows).expect("a length");
    let stop = StopSignal::new().expect("a signal");
    let (ready, served) = mpsc::channel();
    std::thread::scope(|scope| {
        let (domain, stopped) = (place.domain(), &stop);
        scope.spawn(move || {
            let mut server = Server::start(&domain).expect("starts");
            let fill = |loan: &mut [u8]| {
                encode_into(&rows, &Provenance::default(), loan)?;
                let content_hash = mapd_archive::open(loan)?.header.content_hash;
                Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
            };
            server.publish("big", length, fill).expect("publishes");
            drop(rows);
            ready.send(()).expect("told");
            server.run(stopped).expect("serves");
        });
        served.recv_timeout(PATIENCE * 6).expect("served");
        let end = StopAtEnd(&stop);
        work();
        drop(end);
    });
}

/// Ends the server also when an assertion fails.
struct StopAtEnd<'a>(&'a StopSignal);

impl Drop for StopAtEnd<'_> {
    fn drop(&mut self) {
        self.0.request();
    }
}

/// Free bytes of shared memory.
fn room() -> u64 {
    let output = Command::new("df").args(["--output=avail", "-B1", "/dev/shm"]).output();
    let text = output.map(|o| String::from_utf8_lossy(&o.stdout).into_owned()).unwrap_or_default();
    text.lines().nth(1).and_then(|line| line.trim().parse().ok()).unwrap_or(0)
}

#[test]
fn the_checked_access_touches_two_pages_whatever_the_size() {
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let mut counts = Vec::new();
    let _alone = ROOM.lock().unwrap_or_else(PoisonError::into_inner);
    for bytes in [1 << 20, 512 << 20] {
        if room() < 2 * bytes {
            say(&format!("SKIPPED for {bytes} bytes: /dev/shm has only {} free", room()));
            continue;
        }
        while_serving(&place, bytes as usize, || {
            for _ in 0..3 {
                let (report, status) = probe(&place, "faults");
                assert!(status.success(), "{report:?}");
                let found: u64 = report["bytes"].parse().expect("a number");
                assert!(found >= bytes, "{found} bytes are served");
                let faults: u64 = report["faults"].parse().expect("a number");
                assert!(faults <= FAULTS, "{faults} faults for {found} bytes");
                counts.push(faults);
            }
        });
    }
    assert!(counts.windows(2).all(|pair| pair[0] == pair[1]), "not the same: {counts:?}");
}

/// Page faults of an observer's whole attach: the record's page, the two of the checked access, and what the heap may need.
const ATTACH_FAULTS: u64 = 6;

#[test]
fn an_observer_touches_as_many_pages_whatever_the_size() {
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let mut counts = Vec::new();
    let _alone = ROOM.lock().unwrap_or_else(PoisonError::into_inner);
    for bytes in [1 << 20, 512 << 20] {
        if room() < 2 * bytes {
            say(&format!("SKIPPED for {bytes} bytes: /dev/shm has only {} free", room()));
            continue;
        }
        while_serving(&place, bytes as usize, || {
            let (report, status) = probe(&place, "steps");
            assert!(status.success(), "{report:?}");
            let found: u64 = report["bytes"].parse().expect("a number");
            assert!(found >= bytes, "{found} bytes are served");
            counts.push(report["faults"].parse::<u64>().expect("a number"));
        });
    }
    say(&format!("page faults of an observer's attach: {counts:?}"));
    assert!(counts.iter().all(|count| *count <= ATTACH_FAULTS), "{counts:?}");
    assert!(counts.windows(2).all(|pair| pair[0] == pair[1]), "not the same: {counts:?}");
}

#[test]
fn the_segment_is_read_only_for_everyone() {
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    while_serving(&place, 1 << 20, || {
        let (report, status) = probe(&place, "faults");
        assert!(status.success(), "{report:?}");
        assert_eq!(report["mapping"], "r--s");
        let mode = std::fs::metadata(&report["segment"]).expect("the segment").permissions().mode();
        assert_eq!(mode & 0o777, 0o400, "{}", report["segment"]);
        let output = place.command_of(PROBE).args(["write", "big"]).output().expect("runs");
        assert_eq!(output.status.signal(), Some(SIGSEGV), "{:?}", output.status);
        assert_eq!(String::from_utf8_lossy(&output.stdout), "writing\n");
    });
}
