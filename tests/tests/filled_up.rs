//! Shared memory that somebody fills up at a system call of a daemon, whichever it is: a clear error or success, never a
//! signal, and nothing is left behind.

use mapd_client::{Attach, Client};
use mapd_tests::say;
use mapd_tests::small::{Filler, SameRoom, in_small_shared_memory};
use mapd_tests::stage::{DAEMON_PATIENCE, Stage};
use mapd_tests::tracer::{Moment, Side, Then, Traced};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::io::Read;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use syscalls::Sysno;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Room for one map and all that serves it; filling it takes some milliseconds.
const SHARED_MEMORY: u64 = 8 << 20;

/// One of so many moments may be the one; a prime, so that no pattern of calls is left out.
const STEP: usize = 5;

/// Likewise of a reload, which is longer: it has a compiler.
const RELOAD_STEP: usize = 23;

/// Of the rooms that are tried at least this share has to be met again: threads take turns, so that a moment may not come twice.
const MET: f64 = 1.0 / 3.0;

/// Moments at which a program meets the same room: filled up at any of them, it goes on alike.
struct Room(Vec<Moment>);

impl Room {
    /// The rooms that one of so many moments meets, by their numbers of [`SameRoom`].
    fn all(moments: &[(Moment, usize)], step: usize) -> Vec<Self> {
        let before: Vec<_> =
            moments.iter().filter(|(moment, _)| moment.side == Side::Before).collect();
        let mut numbers: Vec<usize> = before.iter().step_by(step).map(|(_, room)| *room).collect();
        numbers.dedup();
        let of = |number: usize| before.iter().filter(move |(_, room)| *room == number);
        numbers.into_iter().map(|n| Self(of(n).map(|(moment, _)| *moment).collect())).collect()
    }

    /// Fills it up, unless that is done or this is another moment.
    fn fill(&self, filled: &mut Option<(Filler, Moment)>, moment: &Moment) {
        let place = |moment: &Moment| (moment.thread, moment.call, moment.side);
        if filled.is_none() && self.0.iter().any(|own| place(own) == place(moment)) {
            *filled = Filler::fill().ok().map(|filler| (filler, *moment));
        }
    }
}

/// What came of filling rooms up.
#[derive(Default)]
struct Outcome {
    well: usize,
    told: usize,
    /// Neither: the room was not met again.
    missed: usize,
    /// Neither: it ended as it should, and said so elsewhere.
    quiet: usize,
}

impl Outcome {
    fn check(&self, moments: usize) {
        let Self { well, told, missed, quiet } = *self;
        let filled = well + told + quiet;
        say(&format!(
            "{moments} moments; rooms: {well} ended well, {told} with a clear error, {quiet} otherwise, {missed} not met"
        ));
        assert!(well > 0 && told > 0, "both happen");
        assert!(filled as f64 >= MET * (filled + missed) as f64, "{missed} rooms not met");
    }
}

/// One test at a time: a process that is being forked by one holds, for a moment, the locks of clients of the other, as if they
/// were still there.
static ALONE: Mutex<()> = Mutex::new(());

fn stage() -> Stage {
    let map = mapd_tests::carried("one_road.xodr");
    Stage::new(Path::new(MAPD), &map, "x,y\n10,-1.5\n").expect("the map answers from its file")
}

/// Deadline of one attempt to attach: where there is no room it runs out.
const ATTEMPT: Duration = Duration::from_millis(200);

/// Whether an error says that shared memory is full.
fn says_full(error: &str) -> bool {
    error.contains("of shared memory")
}

/// A client of a daemon that is traced, and therefore slow.
///
/// Errors: there is no room; it cannot attach for long, for another reason.
fn attach(stage: &Stage, attach: Attach) -> Result<Client, String> {
    let until = Instant::now() + DAEMON_PATIENCE;
    loop {
        match stage.client(attach, ATTEMPT).map_err(|error| error.to_string()) {
            Err(error) if !says_full(&error) && Instant::now() < until => {}
            outcome => return outcome,
        }
    }
}

/// Runs a program and does something at each of its moments; how it ended and what it said.
fn run(command: &Command, at: impl FnMut(Pid, &Moment)) -> (ExitStatus, String) {
    let (traced, stderr) = Traced::start(command, "", Stdio::piped()).expect("starts");
    let (pid, mut at) = (traced.pid(), at);
    let run = traced.run(|moment| {
        at(pid, moment);
        Then::Continue
    });
    let (status, mut said) = (run.expect("ends"), String::new());
    stderr.expect("piped").read_to_string(&mut said).expect("text");
    (status, said)
}

/// A daemon is asked to stop as soon as it waits for clients.
fn stop_when_waiting(pid: Pid, moment: &Moment) {
    if moment.thread == 0 && matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait) {
        // Fails only if it has ended.
        let _ = kill(pid, Signal::SIGTERM);
    }
}

#[test]
fn while_a_daemon_starts_publishes_and_stops() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    in_small_shared_memory(SHARED_MEMORY, || {
        let stage = stage();
        let (mut moments, mut room) = (Vec::new(), SameRoom::default());
        run(&stage.daemon_command(), |pid, moment| {
            moments.push((*moment, room.number(moment).expect("shared memory")));
            stop_when_waiting(pid, moment);
        });
        let mut outcome = Outcome::default();
        for room in Room::all(&moments, STEP) {
            let mut filled = None;
            let (status, said) = run(&stage.daemon_command(), |pid, moment| {
                room.fill(&mut filled, moment);
                stop_when_waiting(pid, moment);
            });
            let Some((filler, moment)) = filled else {
                outcome.missed += 1;
                continue;
            };
            drop(filler);
            let end = format!("filled up {moment}: {status}: {said}");
            if status.success() {
                outcome.well += 1;
            } else {
                assert_eq!(status.signal(), None, "{end}");
                assert!(said.contains("bytes of shared memory"), "{end}");
                outcome.told += 1;
            }
            let left = stage.files();
            assert!(left.is_empty(), "{end}\nleft behind: {left:?}");
        }
        outcome.check(moments.len());
    });
}

/// A daemon that is asked to reload as soon as it serves, and to stop once it has: how it ended, what the reload told, and
/// what a client found that held the generation before.
fn reloading(
    stage: &Stage,
    mut at: impl FnMut(&Moment),
) -> (ExitStatus, String, Result<(), String>) {
    let outcome = Mutex::new((String::new(), Ok(())));
    let (status, _) = std::thread::scope(|scope| {
        let mut asked = false;
        run(&stage.daemon_command(), |pid, moment| {
            let waits = matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait);
            if moment.thread == 0 && waits && !asked {
                asked = true;
                let outcome = &outcome;
                scope.spawn(move || {
                    let reload = || {
                        let clients =
                            [attach(stage, Attach::Observer)?, attach(stage, Attach::Subscriber)?];
                        let held = clients.each_ref().map(Client::snapshot);
                        stage.touch_map()?;
                        let mut ask = stage.ask_command(&["reload"]);
                        let asked = ask.stdout(Stdio::piped()).output();
                        let asked = asked.map_err(|error| error.to_string())?;
                        let said = String::from_utf8_lossy(&asked.stdout).into_owned();
                        for (client, held) in clients.iter().zip(held) {
                            held.verify().map_err(|error| format!("held: {error}"))?;
                            let newest =
                                client.refresh().map_err(|error| format!("newest: {error}"))?;
                            newest.verify().map_err(|error| format!("newest: {error}"))?;
                        }
                        Ok::<_, String>(said)
                    };
                    let (said, held) = match reload() {
                        Ok(said) => (said, Ok(())),
                        Err(error) => (String::new(), Err(error)),
                    };
                    *outcome.lock().expect("no panic") = (said, held);
                    // Fails only if it has ended.
                    let _ = kill(pid, Signal::SIGTERM);
                });
            }
            at(moment);
        })
    });
    let (said, held) = outcome.into_inner().expect("no panic");
    (status, said, held)
}

#[test]
fn while_a_daemon_reloads() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    in_small_shared_memory(SHARED_MEMORY, || {
        let folder = tempfile::tempdir().expect("a folder");
        let map = folder.path().join("one_road.xodr");
        std::fs::copy(mapd_tests::carried("one_road.xodr"), &map).expect("copied");
        let stage = Stage::new(Path::new(MAPD), &map, "x,y\n10,-1.5\n").expect("answers");
        let (mut moments, mut room) = (Vec::new(), SameRoom::default());
        let mut begun = None;
        let (_, _, first) = reloading(&stage, |moment| {
            moments.push((*moment, room.number(moment).expect("shared memory")));
            let waits = matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait);
            if moment.thread == 0 && waits && begun.is_none() {
                begun = Some(moments.len());
            }
        });
        first.expect("a reload with room");
        let moments = moments.split_off(begun.expect("it serves"));
        let mut outcome = Outcome::default();
        for room in Room::all(&moments, RELOAD_STEP) {
            let mut filled = None;
            let (status, said, held) = reloading(&stage, |moment| room.fill(&mut filled, moment));
            let Some((filler, moment)) = filled else {
                outcome.missed += 1;
                continue;
            };
            drop(filler);
            let end = format!("filled up {moment}: {status}: {said}");
            assert!(status.success(), "the daemon serves on: {end}");
            // A client that comes when it is full is told so; one that was there keeps what it has.
            held.or_else(|error| says_full(&error).then_some(()).ok_or(error))
                .unwrap_or_else(|error| panic!("{end}: {error}"));
            if said.contains("now serving") {
                outcome.well += 1;
            } else if says_full(&said) {
                outcome.told += 1;
            } else {
                outcome.quiet += 1;
            }
            let left = stage.files();
            assert!(left.is_empty(), "{end}\nleft behind: {left:?}");
        }
        outcome.check(moments.len());
    });
}
