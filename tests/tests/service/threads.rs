//! Many threads read while generations change under them: every answer belongs to the generation it was asked of.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_archive::{AlignedBytes, encode};
use mapd_client::{Client, LaneId, Nearest, NearestOptions, Snapshot, glam::DVec2};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::test_domain::{PATIENCE, TestDomain, until};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Generations published one after the other.
const GENERATIONS: u64 = 100;

/// Threads that ask.
const READERS: usize = 4;

/// Old generations that one thread keeps and goes on asking.
const KEPT: usize = 6;

fn archive(name: &str) -> AlignedBytes {
    let file = std::fs::File::open(mapd_tests::carried(name)).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
}

fn hit(snapshot: &Snapshot) -> Nearest {
    let nearest = snapshot.map().nearest_lane(DVec2::new(50.0, -1.75), &NearestOptions::default());
    nearest.expect("an answer").expect("a lane")
}

/// The lane of a place in both maps, with all digits of its coordinates.
fn ask(snapshot: &Snapshot) -> (String, [u64; 2]) {
    let hit = hit(snapshot);
    let key = snapshot.map().lane(hit.lane).expect("known").key().to_string();
    (key, [hit.position.s, hit.position.t].map(f64::to_bits))
}

#[test]
fn generations_change_under_readers() {
    let archives = [archive("one_road.xodr"), archive("town.xodr")];
    let whole =
        archives.each_ref().map(|bytes| Snapshot::from_bytes(bytes.clone()).expect("opens"));
    let answers = whole.each_ref().map(ask);
    assert_ne!(whole[0].header().content_hash, whole[1].header().content_hash);
    // A lane's id of one map must be refused by the other.
    let foreign: [LaneId; 2] = whole.each_ref().map(|snapshot| hit(snapshot).lane);

    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let domain = place.domain();
    let stop = StopSignal::new().expect("a signal");
    let (ended, asked) = (AtomicBool::new(false), AtomicU64::new(0));
    let check = |snapshot: &Snapshot| {
        let is_second = snapshot.header().content_hash == whole[1].header().content_hash;
        let which = usize::from(is_second);
        assert_eq!(ask(snapshot), answers[which], "generation {}", snapshot.generation());
        assert!(snapshot.map().lane(foreign[which]).is_ok());
        assert!(snapshot.map().lane(foreign[1 - which]).is_err(), "a foreign id is taken");
        asked.fetch_add(1, Ordering::Relaxed);
    };
    let are_asked = |questions| asked.load(Ordering::Relaxed) >= questions;
    let (tell, first) = std::sync::mpsc::channel();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut server = Server::start(&domain).expect("starts");
            for generation in 0..GENERATIONS {
                let bytes = &archives[(generation % 2) as usize];
                let fill = |loan: &mut [u8]| {
                    loan.copy_from_slice(bytes);
                    let content_hash = mapd_archive::open(loan)?.header.content_hash;
                    Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
                };
                let number = server.publish("map", bytes.len(), fill).expect("publishes");
                let _ = tell.send(number);
                if generation == 0 {
                    // Else all of them may be there before anybody asks.
                    until("the first questions", || are_asked(READERS as u64).then_some(()));
                }
            }
            server.run(&stop).expect("serves");
        });
        let client = Client::connect_in(&domain, "map", PATIENCE).expect("attaches");
        let client = Arc::new(client);
        let (check, are_asked, ended, stop) = (&check, &are_asked, &ended, &stop);
        for _ in 0..READERS {
            let client = Arc::clone(&client);
            scope.spawn(move || {
                let mut last = 0;
                while !ended.load(Ordering::Acquire) {
                    let snapshot = client.refresh().expect("the newest");
                    assert!(snapshot.generation() >= last, "time runs backwards");
                    last = snapshot.generation();
                    check(&snapshot);
                }
            });
        }
        // Keeps old generations alive, asks them again, lets the oldest go.
        let holder = Arc::clone(&client);
        scope.spawn(move || {
            let mut kept = VecDeque::new();
            while !ended.load(Ordering::Acquire) {
                kept.push_back(holder.snapshot());
                kept.iter().for_each(check);
                if kept.len() > KEPT {
                    kept.pop_front();
                }
            }
            kept.iter().for_each(|snapshot| snapshot.verify().expect("still whole"));
        });
        // Ends everything when the last generation has come and enough was asked, or something has failed.
        scope.spawn(move || {
            let mut newest = client.snapshot().generation();
            let last = first.recv().expect("a number") + GENERATIONS - 1;
            while newest < last {
                match client.wait_next(PATIENCE) {
                    Ok(next) => newest = next.generation(),
                    // Another thread has taken it, or it comes no more.
                    Err(_) if client.snapshot().generation() > newest => {
                        newest = client.snapshot().generation();
                    }
                    Err(_) => break,
                }
            }
            let until = Instant::now() + PATIENCE;
            while newest == last && !are_asked(GENERATIONS) && Instant::now() < until {
                std::thread::sleep(Duration::from_millis(1));
            }
            ended.store(true, Ordering::Release);
            stop.request();
            assert_eq!(newest, last);
        });
    });
    assert!(are_asked(GENERATIONS), "too few questions were asked");
}
