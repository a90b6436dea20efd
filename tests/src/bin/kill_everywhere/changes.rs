//! A daemon killed at every system call of reloading, rolling back, staging and activating, those of its compiler among them;
//! and the client that asks for it, at every system call of asking.

use crate::QUESTION;
use crate::check::{Witness, is_found_whole_or_not, nothing_left, settles};
use crate::report::{Choice, Killing, Report};
use crate::watchdog;
use mapd_tests::stage::{Checked, Stage};
use mapd_tests::tracer::{Moment, Then, Traced};
use nix::sys::signal::{Signal, kill};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Stdio;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use syscalls::Sysno;

/// What a daemon is asked, one after the other; the map's file has changed before each.
const ASKED: [&[&str]; 4] = [&["reload"], &["rollback"], &["reload", "--stage"], &["activate"]];

/// The arguments of what a daemon is asked to do with a map.
pub(crate) type Asked = Vec<Vec<String>>;

/// A domain of its own, with a map that can be changed.
pub(crate) fn stage(mapd: &Path) -> Checked<(Stage, tempfile::TempDir)> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let map = folder.path().join("one_road.xodr");
    let from = mapd_tests::carried("one_road.xodr");
    std::fs::copy(from, &map).map_err(|error| error.to_string())?;
    Ok((Stage::new(mapd, &map, QUESTION)?, folder))
}

pub(crate) fn daemon(mapd: &Path, choice: Choice<'_>) -> Checked<Report> {
    let (stage, _folder) = stage(mapd)?;
    let whole = |what: &[&str]| {
        let own = [&stage.name(), "--wait", "5"];
        what.iter().chain(&own).map(|arg| (*arg).to_owned()).collect()
    };
    let asked: Asked = ASKED.into_iter().map(whole).collect();
    killed(&stage, "daemon, while it changes what it serves", &asked, choice, None)
}

/// Which of what was asked is served whole; none where nobody serves.
pub(crate) type Serves = fn(&Stage) -> Checked<Option<usize>>;

/// Which of what was asked may be served: what was answered last, and what was asked since.
struct Served(Mutex<Vec<usize>>);

impl Served {
    fn asked(&self, what: usize) {
        self.lock().push(what);
    }

    /// Nothing else may be served.
    fn answered(&self, what: usize) {
        *self.lock() = vec![what];
    }

    /// What a reader found: nothing older may be served any more. It is written down before readers see it, so newer may be.
    fn seen(&self, found: usize) -> Checked<()> {
        let mut may = self.lock();
        let Some(at) = may.iter().position(|one| *one == found) else {
            return Err(format!("number {found} is served, where {may:?} may be"));
        };
        may.drain(..at);
        Ok(())
    }

    fn lock(&self) -> MutexGuard<'_, Vec<usize>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Kills a daemon wherever it is asked to change something. With `serves`, what it was asked outlives it: then it is killed wherever it starts with that, too, and after each
/// kill, and after the next daemon's start, what was answered is served, or what was asked since.
pub(crate) fn killed(
    stage: &Stage,
    name: &str,
    asked: &Asked,
    choice: Choice<'_>,
    serves: Option<Serves>,
) -> Checked<Report> {
    let first = stage.serve()?;
    let mut witness = Witness::new(stage)?;
    first.stop()?;
    let served = Served(Mutex::default());
    if serves.is_some() {
        serving(stage, asked, &served, |_| Then::Continue)?;
    }
    let mut moments = Vec::new();
    let mut first_wait = None;
    serving(stage, asked, &served, |moment| {
        moments.push(*moment);
        if first_wait.is_none() && waits(moment) {
            first_wait = Some(moments.len());
        }
        Then::Continue
    })?;
    let last = asked.len() - 1;
    if *served.lock() != [last] {
        return Err(format!("{name}: not all was answered: {:?}", served.lock()));
    }
    if serves.is_none() {
        // Starting is another victim's matter.
        moments = moments.split_off(first_wait.unwrap_or_default());
    }
    let chosen = choice.of(&moments);
    let mut report = Report::new(name, moments.len(), chosen.len());
    let daemon = stage.serve()?;
    witness.follows()?;
    daemon.stop()?;
    let before = stage.files();
    for moment in &chosen {
        watchdog::step(&format!("{name}, killed {moment}"));
        report.ran(moment.kill(|at| serving(stage, asked, &served, at))?);
        report.note(moment, is_found_whole_or_not(stage));
        if let Some(serves) = serves {
            let found = serves(stage).and_then(|found| found.map_or(Ok(()), |n| served.seen(n)));
            report.note(moment, found);
        }
        report.note(moment, witness.still_reads());
        // What the killed one served last is as right.
        report.note(moment, witness.keeps_up());
        let start = Instant::now();
        let Some(daemon) = report.note(moment, stage.serve()) else { continue };
        report.started(start.elapsed());
        if let Some(time) = report.note(moment, stage.fresh_client()) {
            report.attached(time);
        }
        if let Some(serves) = serves {
            let found = serves(stage).and_then(|found| found.ok_or("nobody serves".to_owned()));
            let seen = found.and_then(|found| served.seen(found).map(|()| served.answered(found)));
            report.note(moment, seen);
        }
        report.note(moment, witness.follows());
        report.note(moment, daemon.stop());
        report.note(moment, settles(stage, &before));
    }
    drop(witness);
    let end = stage.serve().and_then(|daemon| daemon.stop()).and_then(|()| nothing_left(stage));
    report.note(&"everywhere, in the end", end);
    Ok(report)
}

fn waits(moment: &Moment) -> bool {
    moment.thread == 0 && matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait)
}

/// Runs a daemon, which is asked everything as soon as it serves, and then to stop; whether it was killed.
fn serving(
    stage: &Stage,
    asked: &Asked,
    served: &Served,
    mut at: impl FnMut(&Moment) -> Then,
) -> Checked<bool> {
    let (traced, _) = Traced::start(&stage.daemon_command(), "", Stdio::null())
        .map_err(|error| error.to_string())?;
    let pid = traced.pid();
    std::thread::scope(|scope| {
        let mut has_asked = false;
        let status = traced.run(|moment| {
            if waits(moment) && !has_asked {
                has_asked = true;
                scope.spawn(move || {
                    for (i, what) in asked.iter().enumerate() {
                        let _ = stage.touch_map();
                        let args: Vec<&str> = what.iter().map(String::as_str).collect();
                        let mut command = stage.command(&args);
                        served.asked(i);
                        if !command.stderr(Stdio::null()).status().is_ok_and(|end| end.success()) {
                            // A client that asks a killed daemon for more gets no answer either.
                            break;
                        }
                        served.answered(i);
                    }
                    // Fails only if it has ended.
                    let _ = kill(pid, Signal::SIGTERM);
                });
            }
            at(moment)
        });
        let status = status.map_err(|error| error.to_string())?;
        Ok(status.signal() == Some(Signal::SIGKILL as i32))
    })
}

pub(crate) fn asker(mapd: &Path, choice: Choice<'_>) -> Checked<Report> {
    let (stage, _folder) = stage(mapd)?;
    let mut daemon = stage.serve()?;
    let mut witness = Witness::new(&stage)?;
    let mut moments = Vec::new();
    asking(&stage, |moment| {
        moments.push(*moment);
        Then::Continue
    })?;
    witness.follows()?;
    let chosen = choice.of(&moments);
    let mut report = Report::new("who asks for a reload", moments.len(), chosen.len());
    let before = stage.files();
    for moment in &chosen {
        watchdog::step(&format!("asker killed {moment}"));
        report.ran(moment.kill(|at| asking(&stage, at))?);
        report.note(moment, witness.still_reads());
        if let Some(time) = report.note(moment, stage.fresh_client()) {
            report.attached(time);
        }
        report.note(moment, witness.keeps_up());
        // The next one who asks is heard.
        let asked = stage.touch_map().and_then(|()| {
            stage.ask_command(&["reload"]).status().map_err(|error| error.to_string())
        });
        let heard = asked.and_then(|status| match status.success() {
            true => Ok(()),
            false => Err(format!("the next reload ends with {status}")),
        });
        report.note(moment, heard);
        report.note(moment, witness.follows());
        if !daemon.is_running() {
            report.note(moment, Err::<(), _>("the daemon has ended".to_owned()));
            daemon = stage.serve()?;
        }
    }
    report.note(&"everywhere", settles(&stage, &before));
    drop(witness);
    let end = daemon.stop().and_then(|()| nothing_left(&stage));
    report.note(&"everywhere, in the end", end);
    Ok(report)
}

/// Runs one who asks for a reload; whether it was killed.
fn asking(stage: &Stage, at: impl FnMut(&Moment) -> Then) -> Checked<bool> {
    stage.touch_map()?;
    let start = Traced::start(&stage.ask_command(&["reload"]), "", Stdio::null());
    let status = start.and_then(|(traced, _)| traced.run(at)).map_err(|error| error.to_string())?;
    Ok(status.signal() == Some(Signal::SIGKILL as i32))
}
