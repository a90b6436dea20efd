//! Reload, rollback, activate: what is served changes, or stays what it is with a reason.

use super::child::Refusal;
use super::maps::{Kept, Maps, Staged, UNASKED_RELOADS};
use super::orders::{Change, Job};
use super::prepare::Prepared;
use super::watch::watch_more;
use super::worker::Worker;
use crate::clock::unix_ns;
use crate::control::{ReloadReport, ReloadResult, Response, Trigger};
use crate::oversight::proof::{Proof, prove};
use crate::serve::ServeError;

/// How a change ended.
struct Outcome {
    result: ReloadResult,
    /// The generation that is served or staged now; none where it failed.
    generation: Option<u64>,
    /// Why, or what there is to know; may be empty.
    reason: String,
}

impl Outcome {
    fn failed(reason: impl ToString) -> Self {
        Self { result: ReloadResult::Failed, generation: None, reason: reason.to_string() }
    }
}

impl Maps {
    /// Begins a change; ends it, if nothing has to be compiled.
    pub(super) fn change(&mut self, change: Change, worker: &Worker) {
        if !self.entries.contains_key(&change.map) {
            let reason = format!("this daemon does not serve a map {:?}", change.map);
            return answer(&change, Response::Refused { reason });
        }
        let outcome = match change.trigger {
            Trigger::Activate if !self.is_staged(&change.map) => {
                // Not a change that failed: there was none.
                let reason = format!(
                    "nothing is staged; stage a generation first with `mapd reload {} --stage`",
                    change.map
                );
                return answer(&change, Response::Refused { reason });
            }
            Trigger::Rollback if !self.has_before(&change.map) => {
                let reason = self.nothing_to_go_back_to(&change.map).to_owned();
                return answer(&change, Response::Refused { reason });
            }
            Trigger::Rollback => self.roll_back(&change),
            Trigger::Activate => self.activate(&change.map),
            Trigger::Start | Trigger::Signal | Trigger::Watch | Trigger::Reload => {
                if !self.begin_reload(&change) {
                    return;
                }
                return worker.prepare(Job { change, anew: false });
            }
        };
        self.ended(&change, outcome);
    }

    /// Counts a reload; false for one that was not requested, if another will read the file anyway.
    fn begin_reload(&mut self, change: &Change) -> bool {
        let Some(entry) = self.entries.get_mut(&change.map) else { return false };
        if change.reply.is_none() && entry.reloads >= UNASKED_RELOADS {
            return false;
        }
        entry.reloads += 1;
        self.board.map(&change.map, |state| state.reloading = true);
        true
    }

    fn end_reload(&mut self, change: &Change) {
        let Some(entry) = self.entries.get_mut(&change.map) else { return };
        entry.reloads = entry.reloads.saturating_sub(1);
        let reloading = entry.reloads > 0;
        self.board.map(&change.map, |state| state.reloading = reloading);
    }

    /// Goes on with a reload once its archive is there, or is not.
    pub(super) fn prepared(
        &mut self,
        job: Job,
        prepared: Result<Prepared, Refusal>,
        worker: &Worker,
    ) {
        let change = job.change;
        self.end_reload(&change);
        let prepared = match prepared {
            Ok(prepared) => prepared,
            Err(refusal) => {
                watch_more(&self.watched, &change.map, &refusal);
                return self.ended(&change, Outcome::failed(refusal.reason()));
            }
        };
        self.follow_includes(&change.map, &prepared);
        if let Some(generation) = self.is_served_soundly(&change.map, &prepared) {
            let reason = match self.give_up_staged(&change.map) {
                Some(staged) => format!(
                    "the file yields the archive that is served; generation {staged}, which was staged, is given up"
                ),
                None => "the file yields the archive that is served".to_owned(),
            };
            let result = ReloadResult::Unchanged;
            let outcome = Outcome { result, generation: Some(generation), reason };
            return self.ended(&change, outcome);
        }
        match self.fill(&change.map, &prepared, change.stage) {
            Err(ServeError::Fill { .. }) if prepared.from_cache => {
                if let (Some(cache), Some(key)) = (&self.preparer.cache, &prepared.key) {
                    cache.remove(key);
                }
                if self.begin_reload(&change) {
                    worker.prepare(Job { change, anew: true });
                }
            }
            Err(error) => self.refused(&change, &error),
            Ok(status) => {
                let generation = status.generation;
                let kept = Kept { archive: prepared, status };
                let result = self.take(&change, kept, false);
                let reason = String::new();
                self.ended(&change, Outcome { result, generation: Some(generation), reason });
            }
        }
    }

    /// Notes what is served or staged now.
    fn take(&mut self, change: &Change, kept: Kept, back: bool) -> ReloadResult {
        if !change.stage {
            self.now_served(&change.map, kept, back);
            self.look();
            return ReloadResult::Published;
        }
        self.board.map(&change.map, |state| state.staged = Some(kept.status.clone()));
        if let Some(entry) = self.entries.get_mut(&change.map) {
            entry.staged = Some(Staged { kept, is_back: back });
        }
        ReloadResult::Staged
    }

    fn refused(&mut self, change: &Change, error: &ServeError) {
        // What was staged has been given up for it.
        self.forget_staged(&change.map);
        self.ended(change, Outcome::failed(error));
    }

    /// Gives up what is staged: the file does not hold it any more. Its generation.
    fn give_up_staged(&mut self, map: &str) -> Option<u64> {
        let staged = self.entries.get_mut(map)?.staged.take()?;
        self.server.give_up_staged(map);
        self.forget_staged(map);
        Some(staged.kept.status.generation)
    }

    fn is_staged(&self, map: &str) -> bool {
        self.server.maps().iter().any(|served| served.name == map && served.staged.is_some())
    }

    fn forget_staged(&mut self, map: &str) {
        if self.is_staged(map) {
            return;
        }
        if let Some(entry) = self.entries.get_mut(map) {
            entry.staged = None;
        }
        self.board.map(map, |state| state.staged = None);
    }

    /// The generation that is served, if it is the same and not known to be damaged: it is proved first, so that a reload
    /// repairs what has gone bad in memory.
    fn is_served_soundly(&self, map: &str, prepared: &Prepared) -> Option<u64> {
        let generation = self.is_served(map, prepared)?;
        let proof = self.server.meanwhile(|| prove(&self.domain, &self.board, map));
        match proof {
            Ok(Proof::Damaged { reason, .. }) => {
                tracing::error!(map = %map, error = %reason, "map {map}: the served archive fails verification, and is published anew: {reason}");
                None
            }
            // A generation that could not be examined is not known to be damaged.
            Ok(Proof::Sound(_) | Proof::NotExamined(_)) | Err(_) => Some(generation),
        }
    }

    /// The generation that is served, if it was made of the same input and is the same.
    fn is_served(&self, map: &str, prepared: &Prepared) -> Option<u64> {
        let served = self.entries.get(map)?.served.as_ref()?;
        (served.archive.header == prepared.header).then_some(served.status.generation)
    }

    fn roll_back(&mut self, change: &Change) -> Outcome {
        let mut lost = Vec::new();
        while let Some(back) =
            self.entries.get(&change.map).and_then(|entry| entry.before.back()).cloned()
        {
            let before = back.status.generation;
            match self.fill(&change.map, &back.archive, change.stage) {
                Ok(status) => {
                    let generation = status.generation;
                    let kept = Kept { archive: back.archive, status };
                    let result = self.take(change, kept, true);
                    lost.insert(0, format!("what generation {before} was"));
                    let (generation, reason) = (Some(generation), lost.join("; "));
                    return Outcome { result, generation, reason };
                }
                Err(error @ ServeError::Fill { .. }) => {
                    // Its file has been written over: it can never be gone back to.
                    lost.push(format!("generation {before} is lost: {error}"));
                    self.forget_back(&change.map);
                }
                Err(error) => {
                    self.forget_staged(&change.map);
                    return Outcome::failed(error);
                }
            }
        }
        self.forget_staged(&change.map);
        lost.insert(0, self.nothing_to_go_back_to(&change.map).to_owned());
        Outcome::failed(lost.join("; "))
    }

    fn has_before(&self, map: &str) -> bool {
        self.entries.get(map).is_some_and(|entry| !entry.before.is_empty())
    }

    /// Forgets the generation that would be gone back to first.
    fn forget_back(&mut self, map: &str) {
        let Some(entry) = self.entries.get_mut(map) else { return };
        entry.before.pop_back();
        let rollbacks = entry.before.len();
        self.board.map(map, |state| state.rollbacks = rollbacks);
    }

    fn nothing_to_go_back_to(&self, map: &str) -> &'static str {
        let served = self.entries.get(map).and_then(|entry| entry.served.as_ref());
        match (&self.preparer.cache, served) {
            (None, Some(served)) if !served.archive.is_on_disk => {
                "there is nothing to go back to, for there is no cache (--cache DIR)"
            }
            _ => {
                "there is nothing to go back to: nothing else has been served since the daemon started, or all of it has been gone back to"
            }
        }
    }

    fn activate(&mut self, map: &str) -> Outcome {
        let staged = self.entries.get(map).and_then(|entry| entry.staged.as_ref());
        let Some(archive) = staged.map(|staged| staged.kept.archive.clone()) else {
            return Outcome::failed("nothing is staged");
        };
        let activated = self.activate_staged(map, &archive);
        let generation = match activated {
            Ok(generation) => generation,
            Err(error) => {
                self.forget_staged(map);
                return Outcome::failed(error);
            }
        };
        let staged = self.entries.get_mut(map).and_then(|entry| entry.staged.take());
        if let Some(Staged { mut kept, is_back }) = staged {
            kept.status.published_unix_ns = unix_ns();
            self.now_served(map, kept, is_back);
            self.look();
        }
        let (result, reason) = (ReloadResult::Published, String::new());
        Outcome { result, generation: Some(generation), reason }
    }

    /// Files that the document includes since it was read again are watched as well.
    fn follow_includes(&self, map: &str, prepared: &Prepared) {
        let mut list = self.watched.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(watched) = list.get_mut(map)
            && watched.files != prepared.files
        {
            watched.read = super::watch::identities(&prepared.files);
            watched.files = prepared.files.clone();
        }
    }

    /// Says how a change ended: to the log, to the board, to who asked.
    fn ended(&mut self, change: &Change, Outcome { result, generation, reason }: Outcome) {
        let seconds = change.begun.elapsed().as_secs_f64();
        let (trigger, at_unix_ns) = (change.trigger, unix_ns());
        let report = ReloadReport { trigger, result, generation, reason, at_unix_ns, seconds };
        let map = &change.map;
        match report.result {
            ReloadResult::Failed => {
                tracing::warn!(map, error = report.reason, "map {map}: {}", sentence(&report))
            }
            _ => tracing::info!(map, generation, "map {map}: {}", sentence(&report)),
        }
        let kept = report.clone();
        self.board.map(&change.map, |state| {
            state.failed += u64::from(kept.result == ReloadResult::Failed);
            state.last_reload = Some(kept);
        });
        answer(change, Response::Done(report));
    }
}

fn answer(change: &Change, response: Response) {
    if let Some(reply) = &change.reply {
        // Who does not wait any more finds it in the status.
        let _ = reply.send(response);
    }
}

/// A report in words.
pub(crate) fn sentence(report: &ReloadReport) -> String {
    let what = match report.trigger {
        Trigger::Start => "start",
        Trigger::Signal => "reload by SIGHUP",
        Trigger::Watch => "reload, for the file changed",
        Trigger::Reload => "reload",
        Trigger::Rollback => "rollback",
        Trigger::Activate => "activation",
    };
    let number =
        report.generation.map(|number| format!(" generation {number}")).unwrap_or_default();
    let end = match report.result {
        ReloadResult::Published => format!("now serving{number}"),
        ReloadResult::Staged => format!("staged{number}, which `mapd activate` will serve"),
        ReloadResult::Unchanged => format!("unchanged, still serving{number}"),
        ReloadResult::Failed => "failed, still serving the generation before".to_owned(),
    };
    let reason =
        if report.reason.is_empty() { String::new() } else { format!(": {}", report.reason) };
    format!("{what}: {end} after {:.3} s{reason}", report.seconds)
}
