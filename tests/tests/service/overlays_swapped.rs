//! Overlays and new generations: readers have what belongs together, under swaps, stages, and changes of the overlay in between.

use super::overlays::{Scene, closed, closes};
use mapd::control::{ReloadResult, Request};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Attach, AttachError, Client, ClientError, Snapshot};
use mapd_tests::test_domain::until;
use mapd_tests::town::town;
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// No reader sees a generation without what is laid over it; what does not fit a new map is told, and comes back with the old one.
#[test]
fn swaps_never_open_what_is_closed() {
    let scene = Scene::new();
    let log = scene.folder.path().join("log");
    let mut command = scene.place.command();
    command.arg("--load").args(scene.args());
    command.stderr(fs::File::create(&log).expect("a file"));
    let _daemon = scene.place.spawn(command);
    let said = || fs::read_to_string(&log).expect("read");
    until("a served map", || said().contains("serving town").then_some(()));
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let (done, texts) = (AtomicBool::new(false), [town(3, 3), town(3, 2)]);
    // How many generations each reader saw.
    let seen = [(); 3].map(|()| AtomicUsize::new(0));
    std::thread::scope(|scope| {
        let attaches = [Attach::Observer, Attach::Observer, Attach::Subscriber];
        for (attach, seen) in attaches.into_iter().zip(&seen) {
            let client = scene.client(attach);
            let done = &done;
            scope.spawn(move || {
                let mut last = 0;
                while !done.load(Ordering::Relaxed) {
                    let snapshot = client.refresh().expect("the newest");
                    assert_eq!(closes(&snapshot).as_deref(), Some("works"), "{attach:?}");
                    assert!(snapshot.generation() >= last);
                    if snapshot.generation() > last {
                        seen.fetch_add(1, Ordering::Relaxed);
                    }
                    last = snapshot.generation();
                }
            });
        }
        for round in 1..=10 {
            fs::write(&scene.map, &texts[round % 2]).expect("written");
            scene.place.reload("town");
            scene.ends(&["apply", "-"], &closed("works", -1), 0);
            if round == 5 {
                // However busy the machine is, each reader sees swaps.
                let saw = |one: &AtomicUsize| one.load(Ordering::Relaxed) > 0;
                until("a generation in each reader", || seen.iter().all(saw).then_some(()));
                seen.iter().for_each(|one| one.store(0, Ordering::Relaxed));
            }
        }
        let saw = |one: &AtomicUsize| one.load(Ordering::Relaxed) > 0;
        until("a later one in each reader", || seen.iter().all(saw).then_some(()));
        done.store(true, Ordering::Relaxed);
    });
    // A map without road 1.
    let other = town(3, 3).replace(r#"id="1" junction"#, r#"id="90001" junction"#);
    fs::write(&scene.map, other).expect("written");
    scene.place.reload("town");
    let words = "overlay entry \"works\" does not fit the new map and is left out: lanes[0].road: the map has no road \"1\"";
    let lines: Vec<String> =
        said().lines().filter(|l| l.contains("left out")).map(str::to_owned).collect();
    assert!(lines.len() == 1 && lines[0].contains(words), "{lines:?}");
    let list = scene.list();
    assert_eq!(list["entries"][0]["state"], "unplaced");
    let told = scene.place.state("town").overlay;
    assert_eq!((told.entries, told.unplaced, told.in_part), (1, 1, 0));
    assert!(list["entries"][0]["why"].as_str().is_some_and(|why| why.contains("road")), "{list}");
    fs::write(&scene.map, &texts[0]).expect("written");
    scene.place.reload("town");
    assert_eq!(scene.list()["entries"][0]["state"], "active");
    assert_eq!(closes(&scene.client(Attach::Observer).snapshot()).as_deref(), Some("works"));
}

/// What does not fit the served map is kept as long as it was said to hold, and no longer.
#[test]
fn what_does_not_fit_is_kept_until_it_ends() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let other = town(3, 3).replace(r#"id="1" junction"#, r#"id="90001" junction"#);
    let states = || -> Vec<(String, String)> {
        let list = scene.list();
        let text = |value: &serde_json::Value| value.as_str().expect("a text").to_owned();
        let entries = list["entries"].as_array().expect("a list").iter();
        entries.map(|one| (text(&one["id"]), text(&one["state"]))).collect()
    };
    // A busy machine gets more time until the other map is served.
    let end = [2, 10, 50, 250].into_iter().find_map(|seconds| {
        fs::write(&scene.map, town(3, 3)).expect("written");
        scene.place.reload("town");
        let now = SystemTime::now().duration_since(UNIX_EPOCH).expect("after 1970");
        let end = now.as_secs() + seconds;
        let mut date = Command::new("date");
        let date = date.args(["-u", "-d", &format!("@{end}"), "+%FT%TZ"]).output().expect("ends");
        let moment = String::from_utf8(date.stdout).expect("text");
        let times = format!(r#""until":"{}","kind""#, moment.trim());
        scene.ends(&["apply", "-"], &closed("works", -1).replace(r#""kind""#, &times), 0);
        fs::write(&scene.map, &other).expect("written");
        scene.place.reload("town");
        let found = states();
        let end = UNIX_EPOCH + Duration::from_secs(end);
        let is_early = SystemTime::now() < end;
        assert!(!is_early || found == [("works".to_owned(), "unplaced".to_owned())], "{found:?}");
        is_early.then_some(end)
    });
    let end = end.expect("a reload in time");
    until("its end", || (SystemTime::now() > end).then_some(()));
    let more = r#"{"entries":[{"id":"more","kind":"closed","lanes":[{"road":"2","lane":-1}]}]}"#;
    scene.ends(&["apply", "-"], more, 0);
    assert_eq!(states(), [("more".to_owned(), "active".to_owned())]);
}

/// A daemon is killed right after it has laid another overlay, and its successor has removed that and not published yet: readers go on with what they have, and newcomers wait.
#[test]
fn what_a_killed_daemon_laid_last_may_be_gone() {
    let scene = Scene::new();
    let daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("first", -1), 0);
    let clients = [Attach::Observer, Attach::Subscriber].map(|attach| scene.client(attach));
    let first = clients[0].snapshot().overlay_revision();
    scene.ends(&["apply", "-"], &closed("second", -1), 0);
    daemon.kill();
    // As the successor does when it claims the map.
    let is_overlay = |path: &PathBuf| path.to_string_lossy().contains("town.overlay-");
    let files = fs::read_dir(scene.place.domain().root()).expect("a folder").flatten();
    let gone: Vec<_> = files.map(|file| file.path()).filter(is_overlay).collect();
    assert_eq!(gone.len(), 1, "{gone:?}");
    gone.iter().for_each(|path| fs::remove_file(path).expect("removed"));
    let short = Duration::from_millis(300);
    for client in &clients {
        let kept = client.refresh().expect("what is had");
        assert!(kept.overlay_revision() == first && closes(&kept).is_some());
        assert!(!client.wait_change(short).expect("no error"));
        let error = client.wait_next(short).err().expect("nothing new");
        assert!(matches!(error, ClientError::Attach(AttachError::NoGeneration { .. })), "{error}");
    }
    let domain = scene.place.domain();
    let error = Client::connect_in(&domain, "town", short).err().expect("never without it");
    assert!(matches!(error, ClientError::Attach(AttachError::NoGeneration { .. })), "{error}");
    let _successor = scene.place.serve(&scene.args());
    for client in &clients {
        until("the overlay", || {
            let next = client.refresh().expect("no error");
            (next.overlay_revision() > first && closes(&next).is_some()).then_some(())
        });
    }
}

/// An entry that closes lane −1 of a road and says the number of its overlay.
fn numbered(road: &str, number: u64) -> String {
    let entry = closed(&format!("road {road}"), -1)
        .replace(r#""road":"1""#, &format!(r#""road":"{road}""#));
    entry.replace(r#""kind""#, &format!(r#""text":"{number}","kind""#))
}

/// What an overlay says: the number of each entry, which is exactly where it was given, on the map that it comes with. `road 12` holds where there is that road, and only there.
fn said(snapshot: &Snapshot) -> u64 {
    let (map, view) = (snapshot.map(), snapshot.view(UNIX_EPOCH));
    let closes = |id: &str| {
        let road = map.road_by_id(id)?;
        let lane = road.section(0).and_then(|section| section.lane(-1)).expect("a lane").lane_id();
        let answer = view.allows(lane, 15.0, VehicleClass::PassengerCar).expect("an answer");
        let one = answer.restriction.unwrap_or_else(|| panic!("road {id} is open"));
        let place = (one.entry.id(), one.lane, one.s_from, one.s_to);
        assert_eq!(place, (format!("road {id}").as_str(), lane, 10.0, 20.0));
        Some(one.entry.text().parse::<u64>().expect("a number"))
    };
    let first = closes("1").expect("road 1");
    let entries = view.entries().count();
    assert_eq!(entries, if map.road_by_id("12").is_some() { 2 } else { 1 });
    assert!(closes("12").is_none_or(|other| other == first), "torn");
    first
}

/// Staging, activating and going back under an overlay, with changes of it in between: readers have the overlay of their generation, and never an older one again.
#[test]
fn what_is_staged_comes_with_what_is_said_when_it_is_activated() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let own = scene.client(Attach::Observer);
    let both = |number: u64| {
        let [first, second] = ["1", "12"].map(|road| numbered(road, number));
        first.replace("]}]}", "]},") + &second.replace(r#"{"entries":["#, "")
    };
    let change = |request: fn(String) -> Request| {
        let report = scene.place.change("town", &request("town".to_owned()));
        (report.result, report.generation.expect("a number"))
    };
    let stage = |map| Request::Reload { map, stage: true };
    let stage_back = |map| Request::Rollback { map, stage: true };
    let back = |map| Request::Rollback { map, stage: false };
    let activate = |map| Request::Activate { map };
    scene.ends(&["apply", "-"], &both(0), 0);
    let done = AtomicBool::new(false);
    // Number and roads of what is served, as a reader has them.
    let now = || {
        let snapshot = own.refresh().expect("the newest");
        (said(&snapshot), snapshot.generation(), snapshot.map().road_by_id("12").is_some())
    };
    // Generation and number that each reader saw last.
    let seen = [(); 3].map(|()| Mutex::new((0, 0)));
    let all_see = |number: u64, generation: u64| {
        let last = |one: &Mutex<(u64, u64)>| *one.lock().expect("a reader that goes on");
        let all = || seen.iter().all(|one| last(one) == (generation, number)).then_some(());
        until("what is served, in each reader", all);
    };
    std::thread::scope(|scope| {
        let attaches = [Attach::Observer, Attach::Observer, Attach::Subscriber];
        let readers = attaches.into_iter().zip(&seen).map(|(attach, seen)| {
            let client = scene.client(attach);
            let done = &done;
            scope.spawn(move || {
                while !done.load(Ordering::Relaxed) {
                    let snapshot = client.refresh().expect("the newest");
                    let now = (snapshot.generation(), said(&snapshot));
                    let mut last = seen.lock().expect("what this reader saw");
                    assert!(now.0 >= last.0 && now.1 >= last.1, "{now:?} after {last:?}");
                    *last = now;
                }
            })
        });
        let readers: Vec<_> = readers.collect();
        let run = || {
            let (_, first, _) = now();
            fs::write(&scene.map, town(3, 2)).expect("written");
            let (result, staged) = change(stage);
            assert_eq!((result, now()), (ReloadResult::Staged, (0, first, true)));
            all_see(0, first);
            scene.ends(&["apply", "-"], &both(1), 0);
            assert_eq!(now(), (1, first, true));
            assert!(scene.place.state("town").staged.is_some(), "it waits on");
            assert_eq!(change(activate), (ReloadResult::Published, staged));
            assert_eq!(now(), (1, staged, false));
            all_see(1, staged);
            let list = scene.list();
            assert_eq!(
                (&list["entries"][0]["state"], &list["entries"][1]["state"]),
                (&"active".into(), &"unplaced".into())
            );
            // What only the generation before has a place for is refused, and what is served stays.
            let refused = scene.ends(&["apply", "-"], &both(2), 2);
            assert!(refused.contains("\"road 12\", lanes[0].road"), "{refused}");
            assert_eq!(now(), (1, staged, false));
            let (result, again) = change(back);
            assert_eq!((result, now()), (ReloadResult::Published, (1, again, true)));
            all_see(1, again);
            assert_eq!(scene.list()["entries"][1]["state"], "active");
            // The same, but going back is staged.
            let (_, next) = change(|map| Request::Reload { map, stage: false });
            assert_eq!(now(), (1, next, false));
            let (result, staged) = change(stage_back);
            assert_eq!((result, now()), (ReloadResult::Staged, (1, next, false)));
            scene.ends(&["apply", "-"], &numbered("1", 1), 0);
            assert_eq!(now(), (1, next, false));
            assert_eq!(change(activate), (ReloadResult::Published, staged));
            assert_eq!(now(), (1, staged, true));
            all_see(1, staged);
        };
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
        done.store(true, Ordering::Relaxed);
        for reader in readers {
            reader.join().expect("a reader that always has what belongs together");
        }
        outcome.expect("the changes");
    });
}

/// An archive whose file is written over in place: as generation before it is left out when going back, as what is staged it is served all the same, both under an overlay.
#[test]
fn what_is_written_over_is_no_obstacle() {
    let scene = Scene::new();
    let archives = ["a", "b", "c"].map(|name| scene.folder.path().join(name));
    for (archive, (columns, rows)) in archives.iter().zip([(3, 3), (3, 2), (4, 2)]) {
        fs::write(&scene.map, town(columns, rows)).expect("written");
        let mut command = scene.place.command();
        command.args(["compile", scene.args()[0], "-o"]).arg(archive);
        assert!(command.output().expect("ends").status.success());
    }
    let served = scene.folder.path().join("town.mapd");
    let put = |number: usize| fs::rename(&archives[number], &served).expect("renamed");
    put(0);
    let _daemon = scene.place.serve(&[served.to_str().expect("a name")]);
    let change = |request: Request| {
        let report = scene.place.change("town", &request);
        assert_ne!(report.result, ReloadResult::Failed, "{report:?}");
        report
    };
    let town = || "town".to_owned();
    scene.ends(&["apply", "-"], &numbered("1", 0), 0);
    scene.ends(&["apply", "-"], &numbered("12", 0), 0);
    let own = scene.client(Attach::Observer);
    let roads = || {
        let snapshot = own.refresh().expect("the newest");
        assert_eq!(said(&snapshot), 0);
        snapshot.map().roads().count()
    };
    let first = roads();
    // Kept open by the daemon, under another name here.
    let aside = scene.folder.path().join("aside");
    put(1);
    change(Request::Reload { map: town(), stage: false });
    let second = roads();
    fs::rename(&served, &aside).expect("renamed");
    put(2);
    change(Request::Reload { map: town(), stage: true });
    fs::write(&served, "written over").expect("written");
    assert_eq!(roads(), second);
    change(Request::Activate { map: town() });
    assert_ne!(roads(), second, "what was staged");
    fs::write(&aside, "written over").expect("written");
    let report = change(Request::Rollback { map: town(), stage: false });
    assert!(report.reason.contains("is lost"), "{report:?}");
    assert_eq!(roads(), first, "what was before what is lost");
}

/// Applies, readers and swaps of the short form; `MAPD_OVERLAYS=1000,16,50` is the long one.
const STORM: [usize; 3] = [100, 4, 5];
const VARIABLE: &str = "MAPD_OVERLAYS";

/// Every answer under a storm of applies and swaps is that of one overlay, made for the map that it comes with.
#[test]
fn no_answer_is_torn() {
    let text = std::env::var(VARIABLE).unwrap_or_default();
    let wanted: Vec<usize> = text.split(',').filter_map(|n| n.parse().ok()).collect();
    let [applies, readers, swaps] = wanted.try_into().unwrap_or(STORM);
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let texts = [town(3, 3), town(3, 2)];
    let (done, answers) = (AtomicBool::new(false), AtomicUsize::new(0));
    // Each entry closes lane −1 of road 1 on a metre of its own, and says the number of its overlay.
    let document = |number: usize| {
        let entry = |i: usize| {
            let (from, to) = (10 + i, 11 + i);
            format!(
                r#"{{"id":"{i}","kind":"closed","text":"{number}","lanes":[{{"road":"1","s":[{from},{to}],"lane":-1}}]}}"#
            )
        };
        let all: Vec<String> = (0..8).map(entry).collect();
        format!(r#"{{"entries":[{}]}}"#, all.join(","))
    };
    scene.ends(&["apply", "-"], &document(0), 0);
    std::thread::scope(|scope| {
        for i in 0..readers {
            let attach = if i % 4 == 0 { Attach::Subscriber } else { Attach::Observer };
            let client = scene.client(attach);
            let (done, answers) = (&done, &answers);
            scope.spawn(move || {
                let mut last = (0, 0);
                while !done.load(Ordering::Relaxed) {
                    let snapshot = client.refresh().expect("the newest");
                    let now = (snapshot.generation(), snapshot.overlay_revision());
                    assert!(now >= last, "{now:?} after {last:?}");
                    last = now;
                    let view = snapshot.view(UNIX_EPOCH);
                    let road = snapshot.map().road_by_id("1").expect("a road");
                    let lane = road.section(0).and_then(|s| s.lane(-1)).expect("a lane").lane_id();
                    let said = |i: u32| {
                        let s = f64::from(10 + i) + 0.5;
                        let answer = view.allows(lane, s, VehicleClass::PassengerCar);
                        let one = answer.expect("an answer").restriction.expect("closed");
                        assert_eq!(one.entry.id(), i.to_string());
                        one.entry.text()
                    };
                    let first = said(0);
                    assert!((1..8).all(|i| said(i) == first), "torn");
                    answers.fetch_add(1, Ordering::Relaxed);
                }
            });
        }
        for number in 1..=applies {
            scene.ends(&["apply", "-"], &document(number), 0);
            if number % (applies / swaps).max(1) == 0 {
                fs::write(&scene.map, &texts[number / (applies / swaps).max(1) % 2])
                    .expect("written");
                scene.place.reload("town");
            }
        }
        done.store(true, Ordering::Relaxed);
    });
    let answers = answers.into_inner();
    mapd_tests::say(&format!(
        "{applies} applies, {swaps} swaps, {readers} readers: {answers} answers"
    ));
    assert!(answers > applies);
}
