//! A daemon killed at every system call of starting, publishing and stopping.

use crate::check::{Witness, is_found_whole_or_not, nothing_left, settles};
use crate::report::{Choice, Killing, Report};
use crate::watchdog;
use mapd_tests::stage::{Checked, Stage};
use mapd_tests::tracer::{Moment, Then, Traced};
use nix::sys::signal::{Signal, kill};
use std::os::unix::process::ExitStatusExt;
use std::process::Stdio;
use std::time::Instant;
use syscalls::Sysno;

pub(crate) fn run(stage: &Stage, with_client: bool, choice: Choice<'_>) -> Checked<Report> {
    let mut witness = None;
    if with_client {
        let daemon = stage.serve()?;
        witness = Some(Witness::new(stage)?);
        daemon.stop()?;
    }
    let mut moments = Vec::new();
    victim(stage, with_client, |moment| {
        moments.push(*moment);
        Then::Continue
    })?;
    let chosen = choice.of(&moments);
    let name = if with_client { "daemon, with a living client" } else { "daemon, alone" };
    let mut report = Report::new(name, moments.len(), chosen.len());
    // What a living client keeps is as much after every generation.
    let daemon = stage.serve()?;
    if let Some(witness) = &mut witness {
        witness.follows()?;
    }
    daemon.stop()?;
    let before = stage.files();
    for moment in &chosen {
        watchdog::step(&format!("{name}, killed {moment}"));
        report.ran(moment.kill(|at| victim(stage, with_client, at))?);
        report.note(moment, is_found_whole_or_not(stage));
        if let Some(witness) = &witness {
            report.note(moment, witness.still_reads());
        }
        let start = Instant::now();
        let Some(daemon) = report.note(moment, stage.serve()) else { continue };
        report.started(start.elapsed());
        if let Some(time) = report.note(moment, stage.fresh_client()) {
            report.attached(time);
        }
        if let Some(witness) = &mut witness {
            report.note(moment, witness.follows());
        }
        report.note(moment, daemon.stop());
        match &witness {
            Some(_) => report.note(moment, settles(stage, &before)),
            None => report.note(moment, nothing_left(stage)),
        };
    }
    drop(witness);
    let end = stage.serve().and_then(|daemon| daemon.stop()).and_then(|()| nothing_left(stage));
    report.note(&"everywhere, in the end", end);
    Ok(report)
}

/// Runs the victim, which is asked to stop as soon as it waits for clients; whether it was killed.
fn victim(stage: &Stage, with_client: bool, mut at: impl FnMut(&Moment) -> Then) -> Checked<bool> {
    if !with_client {
        // Beside a client archives come from the cache; alone, every one is compiled.
        stage.forget_cache();
    }
    let (traced, _) = Traced::start(&stage.daemon_command(), "", Stdio::null())
        .map_err(|error| error.to_string())?;
    let pid = traced.pid();
    let mut asked = false;
    let status = traced.run(|moment| {
        let waits = matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait);
        if waits && moment.thread == 0 && !asked {
            asked = true;
            // Fails only if it has ended.
            let _ = kill(pid, Signal::SIGTERM);
        }
        at(moment)
    });
    let status = status.map_err(|error| error.to_string())?;
    Ok(status.signal() == Some(Signal::SIGKILL as i32))
}
