//! A client killed at every system call of attaching, asking and detaching, while a daemon serves.

use crate::check::{Witness, nothing_left, settles};
use crate::report::{Choice, Killing, Report};
use crate::watchdog;
use mapd_client::Attach;
use mapd_tests::stage::{Checked, Stage};
use mapd_tests::tracer::{Moment, Then, Traced};
use nix::sys::signal::Signal;
use std::os::unix::process::ExitStatusExt;
use std::process::Stdio;

/// After so many kills the daemon is given the time to clean up, and must have done so.
const SETTLE_EVERY: usize = 100;

pub(crate) fn run(stage: &Stage, attach: Attach, choice: Choice<'_>) -> Checked<Report> {
    let mut daemon = stage.serve()?;
    let witness = Witness::new(stage)?;
    let mut moments = Vec::new();
    victim(stage, attach, |moment| {
        moments.push(*moment);
        Then::Continue
    })?;
    let chosen = choice.of(&moments);
    let mut report = Report::new(format!("client, {attach:?}"), moments.len(), chosen.len());
    let before = stage.files();
    for (i, moment) in chosen.iter().enumerate() {
        watchdog::step(&format!("client killed {moment}"));
        report.ran(moment.kill(|at| victim(stage, attach, at))?);
        if let Some(time) = report.note(moment, stage.fresh_client()) {
            report.attached(time);
        }
        report.note(moment, witness.still_reads());
        if !daemon.is_running() {
            report.note(moment, Err::<(), _>("the daemon has ended".to_owned()));
            daemon = stage.serve()?;
        }
        if (i + 1) % SETTLE_EVERY == 0 || i + 1 == chosen.len() {
            watchdog::step("settling");
            report.note(&format!("up to {moment}"), settles(stage, &before));
        }
    }
    drop(witness);
    let end = daemon.stop().and_then(|()| nothing_left(stage));
    report.note(&"everywhere, in the end", end);
    Ok(report)
}

/// Runs the victim; whether it was killed.
fn victim(stage: &Stage, attach: Attach, at: impl FnMut(&Moment) -> Then) -> Checked<bool> {
    let start = Traced::start(&stage.client_command(attach), stage.question(), Stdio::null());
    let status = start.and_then(|(traced, _)| traced.run(at)).map_err(|error| error.to_string())?;
    Ok(status.signal() == Some(Signal::SIGKILL as i32))
}
