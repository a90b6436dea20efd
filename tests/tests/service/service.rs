//! A daemon in service: maps change under readers, and whatever goes wrong has a clear outcome and leaves the served map as
//! it is.

use mapd::control::{ReloadReport, ReloadResult, Request, Response, Trigger};
use mapd_archive::{Feature, FeatureRow};
use mapd_client::Client;
use mapd_tests::test_domain::{Daemon, HeldCompiler, PATIENCE, TestDomain, until};
use mapd_tests::two_maps::TwoMaps;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// A daemon that serves the first of two maps, and a client that has it.
struct Scene {
    place: TestDomain,
    maps: TwoMaps,
    daemon: Daemon,
    client: Client,
}

impl Scene {
    fn new(args: &[&str]) -> Self {
        let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
        let daemon = serve(&place, &maps, args);
        let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
        assert!(maps.is(&client.snapshot(), 0));
        Self { place, maps, daemon, client }
    }

    fn reload(&self) -> ReloadReport {
        self.place.reload("map")
    }

    fn rollback(&self, stage: bool) -> ReloadReport {
        self.place.change("map", &Request::Rollback { map: "map".to_owned(), stage })
    }

    fn stage(&self) -> ReloadReport {
        self.place.change("map", &Request::Reload { map: "map".to_owned(), stage: true })
    }

    fn activate(&self) -> ReloadReport {
        self.place.change("map", &Request::Activate { map: "map".to_owned() })
    }

    /// The client has, after what has happened, the map of this number.
    fn has(&self, number: usize) {
        let snapshot = self.client.refresh().expect("the newest");
        assert!(self.maps.is(&snapshot, number), "generation {}", snapshot.generation());
        let fresh = Client::connect_in(&self.place.domain(), "map", PATIENCE).expect("attaches");
        assert!(self.maps.is(&fresh.snapshot(), number), "a fresh client has something else");
    }

    /// The client gets, in a while, the map of this number.
    fn gets(&self, number: usize) {
        let next = self.client.wait_next(PATIENCE).expect("the next generation");
        assert!(self.maps.is(&next, number), "generation {}", next.generation());
    }

    /// What was asked for makes no sense now: it is refused with this word, and nothing is counted or written over.
    fn refused(&self, request: &Request, word: &str, number: usize) {
        let before = self.place.state("map");
        match self.place.ask("map", request) {
            Some(Response::Refused { reason }) => assert!(reason.contains(word), "{reason}"),
            other => panic!("{other:?}"),
        }
        let state = self.place.state("map");
        assert_eq!((state.failed, state.last_reload), (before.failed, before.last_reload));
        self.has(number);
    }

    fn no_rollback(&self, number: usize) {
        let request = Request::Rollback { map: "map".to_owned(), stage: false };
        self.refused(&request, "nothing to go back to", number);
    }

    fn no_activation(&self, number: usize) {
        self.refused(&Request::Activate { map: "map".to_owned() }, "nothing is staged", number);
    }

    /// Something failed with this word, and the map of this number is served as before.
    fn failed(&self, report: &ReloadReport, word: &str, number: usize) {
        assert_eq!(report.result, ReloadResult::Failed, "{report:?}");
        assert!(report.reason.contains(word), "{word:?} is not in {:?}", report.reason);
        let told = self.place.state("map").last_reload.expect("told");
        assert_eq!(&told, report, "the status says the same");
        self.has(number);
    }
}

fn serve(place: &TestDomain, maps: &TwoMaps, args: &[&str]) -> Daemon {
    let path = maps.path().display().to_string();
    place.serve(&[&[path.as_str()], args].concat())
}

fn text(output: &Output) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    format!("{:?}: {}{}", output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn a_reload_reaches_readers_and_one_of_the_same_file_does_nothing() {
    let scene = Scene::new(&[]);
    let first = scene.client.snapshot();
    let report = scene.reload();
    assert_eq!(report.result, ReloadResult::Unchanged, "{report:?}");
    assert_eq!(report.generation, Some(first.generation()));
    scene.maps.put(1);
    let report = scene.reload();
    assert_eq!(report.result, ReloadResult::Published, "{report:?}");
    assert_eq!(report.generation, Some(first.generation() + 1));
    scene.has(1);
    assert!(scene.maps.is(&first, 0), "a client keeps the old one while it holds it");
    first.verify().expect("whole");
    let state = scene.place.state("map");
    let served = state.served.expect("served");
    assert_eq!((served.counts.roads, state.rollbacks, state.failed), (56, 1, 0));
    assert_eq!(
        served.content_hash,
        mapd::report::hex(&scene.client.snapshot().header().content_hash)
    );
    assert_eq!(state.memory_bytes, served.bytes);
}

#[test]
fn a_signal_reloads() {
    let scene = Scene::new(&[]);
    scene.maps.put(1);
    scene.daemon.signal("HUP");
    scene.gets(1);
    assert_eq!(scene.place.state("map").last_reload.expect("told").trigger, Trigger::Signal);
}

#[test]
fn a_watched_file_is_reloaded_when_it_is_renamed_or_written_in_place() {
    let scene = Scene::new(&["--watch"]);
    scene.maps.put(1);
    scene.gets(1);
    let one_road = fs::read(mapd_tests::carried("one_road.xodr")).expect("readable");
    fs::write(scene.maps.path(), one_road).expect("written");
    scene.gets(0);
    // Behind a symbolic link that is turned.
    let other = scene.maps.folder().join("other.xodr");
    fs::copy(mapd_tests::carried("town.xodr"), &other).expect("copied");
    let link = scene.maps.folder().join("link");
    std::os::unix::fs::symlink(&other, &link).expect("a link");
    fs::rename(link, scene.maps.path()).expect("renamed");
    scene.gets(1);
    assert_eq!(scene.place.state("map").last_reload.expect("told").trigger, Trigger::Watch);
}

#[test]
fn what_a_map_includes_is_watched_as_well() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let road = |length: f64| {
        format!(
            "<OpenDRIVE><road id=\"1\" length=\"{length}\" junction=\"-1\"><planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"{length}\"><line/></geometry></planView>\
             <lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right><lane id=\"-1\" type=\"driving\"><width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>"
        )
    };
    let map = folder.path().join("map.xodr");
    let part = folder.path().join("part.xml");
    // At once: a file that is found half written is one more reload that fails.
    let put = |file: &Path, text: &str| {
        let beside = folder.path().join("beside");
        fs::write(&beside, text).and_then(|()| fs::rename(&beside, file)).expect("written");
    };
    fs::write(&part, road(100.0)).expect("written");
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><include file=\"part.xml\"/></OpenDRIVE>";
    fs::write(&map, text).expect("written");
    let daemon = place.serve(&[map.to_str().expect("text"), "--watch"]);
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let length = |client: &Client| {
        let snapshot = client.snapshot();
        let road = snapshot.map().roads().next().expect("a road");
        road.length()
    };
    assert_eq!(length(&client), 100.0);
    // In place.
    fs::write(&part, road(50.0)).expect("written");
    client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(length(&client), 50.0);
    let before = place.state("map").failed;
    // One that comes after the document that includes it, and is mended once more.
    put(&map, &text.replace("part.xml", "late.xml"));
    let failed = |more| {
        let times = before + more;
        let until = Instant::now() + PATIENCE;
        while place.state("map").failed < times && Instant::now() < until {
            std::thread::sleep(Duration::from_millis(20));
        }
        assert_eq!(place.state("map").failed, times);
    };
    failed(1);
    let late = folder.path().join("late.xml");
    put(&late, "<OpenDRIVE><road");
    failed(2);
    put(&late, &road(60.0));
    client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(length(&client), 60.0);
    put(&map, text);
    client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(length(&client), 50.0);
    // The archive in the cache is that of both files as they are now.
    assert_eq!(daemon.stop(), 0);
    let _daemon = place.serve(&[map.to_str().expect("text")]);
    assert!(place.state("map").served.expect("served").from_cache);
    client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(length(&client), 50.0);
    fs::write(&part, road(70.0)).expect("written");
    assert_eq!(place.reload("map").result, ReloadResult::Published);
    client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(length(&client), 70.0);
}

#[test]
fn a_bad_map_leaves_the_old_one_served_and_says_why() {
    let scene = Scene::new(&[]);
    scene.maps.put_text(b"<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\"");
    scene.failed(&scene.reload(), "rejected", 0);
    fs::remove_file(scene.maps.path()).expect("removed");
    scene.failed(&scene.reload(), "map.xodr", 0);
    assert_eq!(scene.place.state("map").failed, 2);
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published);
    scene.has(1);
}

#[test]
fn rollback_goes_back_step_by_step_under_new_numbers() {
    let scene = Scene::new(&[]);
    scene.no_rollback(0);
    let first = scene.client.snapshot().generation();
    scene.maps.put(1);
    scene.reload();
    scene.maps.put(0);
    scene.reload();
    for number in [1, 0] {
        // What is gone back to needs no name in the cache.
        let _ = fs::remove_dir_all(scene.place.cache());
        let report = scene.rollback(false);
        assert_eq!(report.result, ReloadResult::Published, "{report:?}");
        scene.has(number);
    }
    assert_eq!(scene.client.snapshot().generation(), first + 4);
    scene.no_rollback(0);
}

#[test]
fn without_a_cache_there_is_nothing_to_go_back_to_but_reloads_work() {
    let scene = Scene::new(&["--no-cache"]);
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published);
    scene.has(1);
    let request = Request::Rollback { map: "map".to_owned(), stage: false };
    scene.refused(&request, "--cache", 1);
    assert!(!scene.place.cache().exists());
}

#[test]
fn a_staged_generation_is_pending_until_it_is_activated() {
    let scene = Scene::new(&[]);
    let first = scene.client.snapshot().generation();
    assert!(scene.client.pending().is_none());
    scene.no_activation(0);
    scene.maps.put(1);
    let staged = scene.stage();
    assert_eq!(staged.result, ReloadResult::Staged, "{staged:?}");
    scene.has(0);
    let pending = scene.client.pending().expect("pending");
    assert_eq!(Some(pending.generation), staged.generation);
    assert!(pending.generation > first);
    let state = scene.place.state("map");
    let bytes =
        |status: &Option<mapd::control::GenerationStatus>| status.as_ref().map_or(0, |g| g.bytes);
    assert_eq!(state.memory_bytes, bytes(&state.served) + bytes(&state.staged));
    assert!(bytes(&state.staged) > 0);
    // Two that must change together agree on the number; both have it, or neither.
    let mut waiting: Vec<_> = (0..2)
        .map(|_| {
            let mut command = scene.place.command_of(PROBE);
            command.args(["require", "map", &pending.generation.to_string(), "10000"]);
            command.spawn().expect("starts")
        })
        .collect();
    std::thread::sleep(Duration::from_millis(200));
    assert!(waiting.iter_mut().all(|child| matches!(child.try_wait(), Ok(None))), "they wait");
    assert_eq!(scene.activate().generation, staged.generation);
    for child in waiting {
        let told = text(&child.wait_with_output().expect("ends"));
        assert!(told.contains(&format!("required {}\n", pending.generation)), "{told}");
    }
    scene.has(1);
    assert!(scene.client.pending().is_none() && scene.place.state("map").staged.is_none());
    // One that is no longer served is not to be had any more.
    let error = scene.client.require(first, PATIENCE).err().expect("superseded");
    assert!(error.to_string().contains("is served already"), "{error}");
    assert!(scene.client.require(pending.generation, PATIENCE).is_ok());
    let late = scene.client.require(pending.generation + 1, Duration::from_millis(100));
    assert!(late.is_err(), "it has not come");
}

#[test]
fn a_reload_takes_the_place_of_what_is_staged() {
    let scene = Scene::new(&[]);
    scene.maps.put(1);
    let staged = scene.stage().generation.expect("a number");
    // Staged goes back, too.
    scene.maps.put(0);
    assert_eq!(scene.reload().result, ReloadResult::Unchanged);
    assert!(scene.client.pending().is_none(), "the file does not hold it any more");
    scene.maps.put(1);
    let staged = scene.stage().generation.max(Some(staged)).expect("a number");
    scene.maps.put_text(b"nonsense");
    scene.failed(&scene.reload(), "rejected", 0);
    assert!(scene.client.pending().is_some(), "a map that is rejected takes no place");
    scene.maps.put(1);
    let report = scene.reload();
    assert!(report.result == ReloadResult::Published && report.generation > Some(staged));
    assert!(scene.client.pending().is_none());
    scene.no_activation(1);
    assert_eq!(scene.rollback(true).result, ReloadResult::Staged);
    scene.has(1);
    assert_eq!(scene.activate().result, ReloadResult::Published);
    scene.has(0);
}

#[test]
fn signal_and_watch_stage_where_they_are_told_to() {
    let scene = Scene::new(&["--watch", "--stage"]);
    scene.maps.put(1);
    let until = Instant::now() + PATIENCE;
    while scene.client.pending().is_none() && Instant::now() < until {
        std::thread::sleep(Duration::from_millis(20));
    }
    scene.has(0);
    scene.activate();
    scene.has(1);
}

#[test]
fn a_restart_publishes_from_the_cache() {
    let scene = Scene::new(&[]);
    assert!(!scene.place.state("map").served.expect("served").from_cache);
    let Scene { place, maps, daemon, client } = scene;
    let mut last = client.snapshot().generation();
    daemon.kill();
    let restart = |from_cache: bool, last: u64| {
        let daemon = serve(&place, &maps, &[]);
        let served = place.state("map").served.expect("served");
        assert_eq!(served.from_cache, from_cache);
        assert!(served.generation > last, "{} after {last}", served.generation);
        let next = client.wait_next(PATIENCE).expect("the next generation");
        assert!(maps.is(&next, 0));
        daemon.kill();
        served.generation
    };
    last = restart(true, last);
    // A damaged archive is found out, thrown away, and made anew.
    let archives = || -> Vec<_> {
        let entries = fs::read_dir(place.cache()).expect("the cache").flatten();
        entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "mapd")).collect()
    };
    let [archive] = archives().try_into().expect("one archive");
    let whole = fs::read(&archive).expect("readable");
    for damage in [0, 20, 200, whole.len() / 2, whole.len() - 1] {
        let mut bytes = whole.clone();
        bytes[damage] ^= 1;
        fs::write(&archive, bytes).expect("written");
        last = restart(false, last);
        assert!(fs::read(&archive).expect("readable") == whole, "byte {damage}: made anew");
        last = restart(true, last);
    }
    fs::write(&archive, &whole[..whole.len() / 2]).expect("cut");
    last = restart(false, last);
    fs::remove_dir_all(place.cache()).expect("deleted");
    last = restart(false, last);
    restart(true, last);
}

#[test]
fn what_was_served_last_stands_in_where_it_may() {
    let Scene { place, maps, daemon, client } = Scene::new(&[]);
    maps.put(1);
    place.reload("map");
    maps.put_text(b"nonsense");
    assert_eq!(place.reload("map").result, ReloadResult::Failed);
    daemon.kill();
    let refused = place.command().arg("--load").arg(maps.path()).output().expect("ends");
    assert_eq!(refused.status.code(), Some(4), "not without being told to: {}", text(&refused));
    let daemon = serve(&place, &maps, &["--last-good"]);
    let next = client.wait_next(PATIENCE).expect("the next generation");
    assert!(maps.is(&next, 1));
    let report = place.state("map").last_reload.expect("told");
    assert!(report.trigger == Trigger::Start && report.result == ReloadResult::Failed);
    assert!(report.reason.contains("rejected"), "{report:?}");
    // The right file comes, as ever.
    maps.put(0);
    assert_eq!(place.reload("map").result, ReloadResult::Published);
    assert_eq!(daemon.stop(), 0);
    fs::remove_dir_all(place.cache()).expect("deleted");
    maps.put_text(b"nonsense");
    let mut command = place.command();
    let refused = command.arg("--last-good").arg("--load").arg(maps.path()).output();
    assert_eq!(refused.expect("ends").status.code(), Some(4), "there is nothing to stand in");
}

#[test]
fn generations_rise_whatever_the_clock_does() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let generation = || {
        let daemon = serve(&place, &maps, &[]);
        let generation = place.state("map").served.expect("served").generation;
        assert_eq!(daemon.stop(), 0);
        assert!(!place.domain().root().exists(), "nothing but the cache knows it");
        generation
    };
    let first = generation();
    let second = generation();
    assert!(second > first, "{second} after {first}");
    // As handed out while the clock was ten years ahead.
    let ahead = first + 10 * 365 * 24 * 3_600_000;
    let kept = format!("{}map.generation", place.domain().prefix());
    fs::write(place.cache().join(kept), ahead.to_string()).expect("written");
    assert_eq!(generation(), ahead + 1, "the clock is back, the numbers are not");
}

/// A file that an editor had left in a folder stopped the start, and a name that is none was not said to be which file's.
#[test]
fn hidden_files_of_a_folder_are_no_maps() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let town = fs::read(mapd_tests::carried("town.xodr")).expect("the town");
    for name in [".hidden.xodr", "town.xodr"] {
        fs::write(folder.path().join(name), &town).expect("written");
    }
    let load = folder.path().display().to_string();
    let daemon = place.serve(&[&load]);
    Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(daemon.stop(), 0);
    let dash = folder.path().join("-dash.xodr");
    fs::write(&dash, &town).expect("written");
    let refused = place.command().args(["--load", &load]).output().expect("ends");
    assert!(refused.status.code() == Some(2), "{}", text(&refused));
    assert!(text(&refused).contains(&dash.display().to_string()), "{}", text(&refused));
}

/// A watched file that was gone left no trace, and a pipe in its place held up the reloads of all maps.
#[test]
fn a_watched_file_that_is_gone_is_told() {
    let scene = Scene::new(&["--watch"]);
    let file = scene.maps.path();
    let fails = |word: &str| {
        until(word, || {
            let report = scene.place.state("map").last_reload?;
            (report.result == ReloadResult::Failed && report.reason.contains(word)).then_some(())
        });
        scene.has(0);
    };
    fs::remove_file(&file).expect("removed");
    fails("No such file");
    assert!(Command::new("mkfifo").arg(&file).status().expect("mkfifo runs").success());
    fails("not a file");
    fs::remove_file(&file).expect("removed");
    scene.maps.put(1);
    scene.gets(1);
}

/// Without --watch, the compiler waited for who writes into it, and all other reloads for the compiler.
#[test]
fn a_pipe_in_the_place_of_a_map_is_told() {
    let scene = Scene::new(&[]);
    fs::remove_file(scene.maps.path()).expect("removed");
    let made = Command::new("mkfifo").arg(scene.maps.path()).status().expect("mkfifo runs");
    assert!(made.success());
    scene.failed(&scene.reload(), "not a file", 0);
}

#[test]
fn a_stop_during_a_reload_ends_at_once() {
    let scene = Scene::new(&[]);
    scene.maps.put_slow(1);
    let mut asking = scene.place.command();
    let asking = asking.args(["reload", "map"]).spawn().expect("starts");
    let _held = HeldCompiler::of(&scene.maps.path());
    assert!(scene.place.state("map").reloading);
    scene.has(0);
    let held = scene.client.snapshot();
    let start = Instant::now();
    assert_eq!(scene.daemon.stop(), 0);
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
    let told = text(&asking.wait_with_output().expect("ends"));
    assert!(told.contains("daemon end"), "{told}");
    held.verify().expect("a client keeps what it holds");
    assert!(scene.maps.is(&held, 0));
}

#[test]
fn a_compiler_that_is_killed_hurts_nobody() {
    let scene = Scene::new(&[]);
    scene.maps.put_slow(1);
    let report = std::thread::scope(|scope| {
        let asked = scope.spawn(|| scene.reload());
        HeldCompiler::of(&scene.maps.path()).kill();
        asked.join().expect("no panic")
    });
    scene.failed(&report, "signal: 9", 0);
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published);
    scene.has(1);
}

#[test]
fn a_compiler_that_needs_too_much_memory_hurts_nobody() {
    for option in ["--compile-memory", "--max-memory"] {
        let Scene { place, maps, daemon, client } = Scene::new(&[]);
        assert_eq!(daemon.stop(), 0);
        // From the cache: nothing is compiled yet.
        let daemon = serve(&place, &maps, &[option, "1MiB"]);
        client.wait_next(PATIENCE).expect("the next generation");
        let scene = Scene { place, maps, daemon, client };
        scene.maps.put(1);
        scene.failed(&scene.reload(), "memory", 0);
        let refused = scene.place.command().args(["reload", "map"]).output().expect("ends");
        assert_eq!(refused.status.code(), Some(4), "{}", text(&refused));
    }
}

#[test]
fn an_archive_larger_than_its_map_may_be_is_refused() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let config = maps.folder().join("mapd.toml");
    let largest = 50_000;
    fs::write(&config, format!("[[map]]\nfile = 'map.xodr'\nmax_bytes = {largest}\n"))
        .expect("written");
    let mut command = place.command();
    command.arg("--config").arg(&config);
    let mut daemon = place.spawn(command);
    daemon.wait_until_serving();
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let scene = Scene { place, maps, daemon, client };
    scene.maps.put(1);
    scene.failed(&scene.reload(), "max_bytes", 0);
}

#[test]
fn a_file_of_settings_names_maps_and_errors_name_lines() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let config = maps.folder().join("mapd.toml");
    let run = |text: &str| {
        fs::write(&config, text).expect("written");
        let mut command = place.command();
        command.arg("--config").arg(&config);
        command
    };
    let wrong = "watch = false\n\n[[map]]\nfile = 'map.xodr'\noptions.landmark = 3\n";
    let output = run(wrong).output().expect("ends");
    let told = text(&output);
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(
        told.contains("mapd.toml") && told.contains("line 5") && told.contains("landmarks"),
        "{told}"
    );
    let twice = "[[map]]\nfile = 'map.xodr'\n[[map]]\nfile = 'map.xodr'\n";
    assert!(text(&run(twice).output().expect("ends")).contains("two maps would be named map"));
    let town = mapd_tests::carried("town.xodr");
    let good = format!(
        "[[map]]\nfile = 'map.xodr'\nname = 'a'\n[[map]]\nfile = '{}'\nname = 'b'\noptions.landmarks = 0\n",
        town.display()
    );
    let mut daemon = place.spawn(run(&good));
    daemon.wait_until_serving();
    let of = |map| Client::connect_in(&place.domain(), map, PATIENCE).expect("attaches").snapshot();
    assert!(maps.is(&of("a"), 0));
    // Another option is another archive, and not that of the map without it.
    assert_eq!(of("b").map().roads().count(), 56);
    assert_eq!(of("b").map().tables().landmark_lengths.len(), 0);
    let refused = place.change_refused("c");
    assert!(refused.contains("no daemon answers; served are a, b"), "{refused}");
}

#[test]
fn two_domains_know_nothing_of_each_other() {
    let [one, two] = [Scene::new(&[]), Scene::new(&[])];
    one.maps.put(1);
    one.reload();
    one.has(1);
    two.has(0);
    assert_eq!(one.daemon.stop(), 0);
    two.maps.put(1);
    two.reload();
    two.has(1);
}

#[test]
fn a_second_daemon_for_a_name_does_not_disturb_the_first() {
    let scene = Scene::new(&[]);
    let path = scene.maps.path().display().to_string();
    let output = scene.place.command().args(["--load", &path]).output().expect("ends");
    assert_eq!(output.status.code(), Some(1), "{}", text(&output));
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published, "the first is still heard");
    scene.has(1);
}

/// The program is replaced by another while it runs, as an upgrade does; then the daemon is.
#[test]
fn an_upgrade_under_a_living_client() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let program = maps.folder().join("mapd");
    fs::copy(MAPD, &program).expect("copied");
    let start = || {
        let mut command = place.command_of(&program);
        command.arg("--load").arg(maps.path());
        let mut daemon = place.spawn(command);
        daemon.wait_until_serving();
        daemon
    };
    let old = start();
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let held = client.snapshot();
    fs::remove_file(&program).expect("removed");
    fs::copy(MAPD, &program).expect("copied");
    let scene = Scene { place, maps, daemon: old, client };
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published, "by the program that runs");
    scene.has(1);
    let Scene { place, maps, daemon, client } = scene;
    assert_eq!(daemon.stop(), 0);
    assert!(maps.is(&client.snapshot(), 1), "between the two");
    let mut command = place.command_of(&program);
    command.arg("--load").arg(maps.path());
    let mut new = place.spawn(command);
    new.wait_until_serving();
    // Another program has compiled what the cache holds.
    assert!(!place.state("map").served.expect("served").from_cache);
    let next = client.wait_next(PATIENCE).expect("the next generation");
    assert!(maps.is(&next, 1) && maps.is(&held, 0));
}

/// Somebody removes the root folder under the daemon: what is held stays, what needs the folder fails with its name, and a
/// new start is as the first.
#[test]
fn a_root_folder_that_is_removed() {
    let Scene { place, maps, daemon, client } = Scene::new(&[]);
    let held = client.snapshot();
    fs::remove_dir_all(place.domain().root()).expect("removed");
    held.verify().expect("whole");
    assert!(maps.is(&client.snapshot(), 0));
    let error = Client::connect_in(&place.domain(), "map", Duration::from_millis(200)).err();
    assert!(error.expect("no daemon to be seen").to_string().contains("no daemon"));
    maps.put(1);
    daemon.signal("HUP");
    std::thread::sleep(Duration::from_millis(500));
    held.verify().expect("whole");
    let _ = daemon.stop();
    drop(client);
    let _daemon = serve(&place, &maps, &[]);
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    assert!(maps.is(&client.snapshot(), 1) && maps.is(&held, 0));
}

#[test]
fn nonsense_on_the_socket_hurts_nobody() {
    use std::io::{Read, Write};
    use std::os::unix::net::UnixStream;
    let scene = Scene::new(&[]);
    let root = scene.place.domain().root().to_owned();
    let sockets: Vec<_> = fs::read_dir(root)
        .expect("the root folder")
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with("control-"))
        .map(|entry| entry.path())
        .collect();
    let [socket] = sockets.try_into().expect("one socket");
    for nonsense in
        ["", "\n", "{}\n", "[[[[\n", "{\"command\":\"reload\",\"map\":\"other\",\"stage\":false}\n"]
    {
        let mut stream = UnixStream::connect(&socket).expect("connects");
        stream.write_all(nonsense.as_bytes()).expect("written");
        stream.shutdown(std::net::Shutdown::Write).expect("shut down");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("answered");
        assert!(nonsense.is_empty() || answer.contains("refused"), "{nonsense:?}: {answer}");
    }
    // Some who connect and say nothing keep nobody else from being heard.
    let _silent: Vec<_> =
        (0..16).map(|_| UnixStream::connect(&socket).expect("connects")).collect();
    scene.maps.put(1);
    assert_eq!(scene.reload().result, ReloadResult::Published);
    scene.has(1);
}

/// What a later release could write that this one must not read.
const FEATURE: Feature = Feature { bit: 62, name: "lanes in the air", release: [7, 8, 9] };

/// An archive of a later release, with something that a reader has to know of.
fn of_a_later_release(maps: &TwoMaps) -> Vec<u8> {
    let compiled = mapd::source::compile_file(&maps.path(), &Default::default(), &mut |_| {});
    let compiled = compiled.expect("readable");
    let mut rows = compiled.rows.expect("accepted");
    rows.features.push(FeatureRow::of(&FEATURE));
    mapd_archive::encode(&rows, &compiled.provenance).expect("encodes").to_vec()
}

#[test]
fn what_this_release_must_not_read_is_named_and_leaves_what_is_held() {
    use mapd::serve::{PublishMeta, Server, StopSignal};
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let daemon = serve(&place, &maps, &[]);
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let other = of_a_later_release(&maps);
    assert_eq!(daemon.stop(), 0);
    // As a map's source.
    let archive = maps.folder().join("map.mapd");
    fs::write(&archive, &other).expect("written");
    let refused = place.command().args(["--load", archive.to_str().expect("text")]).output();
    let refused = text(&refused.expect("ends"));
    let named = |told: &str| told.contains(FEATURE.name) && told.contains("mapd 7.8.9");
    assert!(named(&refused), "{refused}");
    // As what a daemon of another release publishes under a living client.
    let stop = StopSignal::new().expect("a signal");
    let (domain, bytes, ready) = (place.domain(), &other, std::sync::Barrier::new(2));
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut server = Server::start(&domain).expect("starts");
            let fill = |loan: &mut [u8]| {
                loan.copy_from_slice(bytes);
                let none = [0; 32];
                Ok(PublishMeta { layout_id: [0xab; 32], content_hash: none, input_hash: none })
            };
            server.publish("map", bytes.len(), fill).expect("publishes");
            ready.wait();
            server.run(&stop).expect("serves");
        });
        ready.wait();
        let told = client.wait_next(PATIENCE).err().expect("refused").to_string();
        assert!(named(&told), "{told}");
        // Not the first time alone.
        for _ in 0..2 {
            let told = client.refresh().err().expect("refused").to_string();
            assert!(named(&told), "{told}");
        }
        assert!(maps.is(&client.snapshot(), 0), "what is held stays");
        let fresh = Client::connect_in(&domain, "map", PATIENCE).err().expect("refused");
        assert!(named(&fresh.to_string()), "{fresh}");
        stop.request();
    });
    // A daemon of this release comes back.
    let _daemon = serve(&place, &maps, &[]);
    let next = client.wait_next(PATIENCE).expect("the next generation");
    assert!(maps.is(&next, 0));
}

#[test]
fn an_archive_is_served_as_it_is_and_replaced_by_renaming() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let archive = maps.folder().join("map.mapd");
    let compile = || {
        let mut command = place.command();
        command.arg("compile").arg(maps.path()).arg("-o").arg(&archive);
        assert!(command.output().expect("ends").status.success());
    };
    compile();
    let daemon = place.serve(&[archive.to_str().expect("text"), "--watch"]);
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let scene = Scene { place, maps, daemon, client };
    let other = of_a_later_release(&scene.maps);
    let new = archive.with_extension("new");
    fs::write(&new, other).and_then(|()| fs::rename(&new, &archive)).expect("replaced");
    scene.failed(&scene.reload(), FEATURE.name, 0);
    scene.maps.put(1);
    let mut command = scene.place.command();
    command.arg("compile").arg(scene.maps.path()).arg("-o").arg(&archive);
    assert!(command.output().expect("ends").status.success());
    scene.gets(1);
    assert_eq!(scene.rollback(false).result, ReloadResult::Published);
    scene.has(0);
}
