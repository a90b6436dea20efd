//! What is laid over the maps: kept as it was given, in a file that outlives the daemon, and resolved anew for each generation before it is served.

use super::ByName;
use super::desk::{Desk, OWN_MAP, on_archive};
use super::kept::{self, Kept, Signed};
use super::maps::Maps;
use super::prepare::Prepared;
use super::proposals::{Audit, Line};
use crate::clock::{since_epoch, unix_ns};
use crate::control::{ListedEntry, OverlayAction, OverlayReport, OverlayStatus, Response};
use crate::exit::explained;
use crate::serve::{OverlayBytes, ServeError};
use anyhow::{Context, Result, bail};
use mapd_archive::{HEADER_LENGTH, Header, encode_overlay};
use mapd_client::{Attach, Client, Map, TrustedKey};
use mapd_overlay::{Document, Limits, Moment, Policy, Unplaced};
use mapd_transport::{Domain, replace_text_durably};
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::Sender;

/// Suffix of the file that keeps a map's entries.
const SUFFIX: &str = ".overlay.json";

/// Longest such file, for each byte that a document may have: it has entries of many documents, in the longest form.
const STATE_PER_BYTE: u64 = 4;

/// Names of entries that a line of the audit log has at most.
const MOST_TOLD: usize = 50;

/// What may be laid over maps.
#[derive(Clone, Debug, Default)]
pub(crate) struct OverlayRules {
    pub(crate) limits: Limits,
    pub(crate) policy: Policy,
    /// The key that must have signed entries, except those of proposals; none: no signature is needed.
    pub(crate) trust: Option<TrustedKey>,
}

/// Something to be done with an overlay, and where the outcome goes.
pub(crate) struct OverlayOrder {
    pub(crate) map: String,
    pub(crate) action: Action,
    pub(crate) reply: Sender<Response>,
    /// Whether a process proposed it; else it is the operator's command.
    pub(crate) is_proposed: bool,
}

/// What is to be done, read.
pub(crate) enum Action {
    Apply {
        document: Document,
        feed: Option<String>,
        unread: Vec<String>,
        ended: Vec<String>,
        signed: Option<Signed>,
    },
    List,
    Remove {
        ids: Vec<String>,
    },
    Clear,
}

/// What requests are read with, in threads of their own.
pub(crate) struct Reader {
    pub(crate) limits: Limits,
    pub(crate) trust: Option<TrustedKey>,
    pub(crate) desk: Arc<Desk>,
}

impl Reader {
    /// Reads what is asked, and works out where new entries hold: the main thread has only to put them together.
    ///
    /// Errors: what is wrong with it, or with its signature.
    pub(crate) fn read(&self, map: &str, action: OverlayAction) -> Result<Action> {
        Ok(match action {
            OverlayAction::Apply { document, feed, unread, ended, signature } => {
                let (from, trust) = (feed.as_deref(), self.trust.as_ref());
                let (document, signed) =
                    kept::take(document, signature, from, trust, &self.limits)?;
                self.desk.place_on_served(map, &document);
                // That a feed has ended nobody signs.
                let ended = if trust.is_some() { Vec::new() } else { ended };
                Action::Apply { document, feed, unread, ended, signed }
            }
            OverlayAction::List => Action::List,
            OverlayAction::Remove { ids } => Action::Remove { ids },
            OverlayAction::Clear => Action::Clear,
        })
    }
}

/// What is to be laid over a generation that is about to be served.
#[derive(Default)]
pub(super) struct Next {
    pub(super) bytes: Option<OverlayBytes>,
    pub(super) unplaced: Vec<Unplaced>,
}

/// What is laid over all maps.
pub(super) struct Overlays {
    rules: OverlayRules,
    pub(super) domain: Domain,
    /// Where entries are kept; without it they end with the daemon.
    folder: Option<PathBuf>,
    pub(super) desk: Arc<Desk>,
    /// Where it is told what was laid over maps, if proposals are taken.
    pub(super) audit: Option<Arc<Audit>>,
    maps: ByName<Kept>,
}

fn now() -> Moment {
    Moment { unix_seconds: since_epoch().as_secs_f64() }
}

impl Overlays {
    pub(super) fn new(rules: OverlayRules, domain: Domain, folder: Option<PathBuf>) -> Self {
        let desk = Arc::new(Desk::new(rules.policy, domain.clone()));
        Self { rules, domain, folder, desk, audit: None, maps: ByName::new() }
    }

    fn file(&self, map: &str) -> Option<PathBuf> {
        let name = format!("{}{map}{SUFFIX}", self.domain.prefix());
        self.folder.as_ref().map(|folder| folder.join(name))
    }

    /// Reads what was laid over a map when a daemon served it last.
    ///
    /// Errors: the file is there and cannot be read. A closure must not be forgotten in silence.
    pub(super) fn load(&mut self, map: &str) -> Result<()> {
        let mut kept = Kept::default();
        if let Some(path) = self.file(map) {
            let (trust, proposals) = (self.rules.trust.as_ref(), self.audit.is_some());
            kept = Kept::load(&path, self.longest_state(), trust, proposals).with_context(|| {
                format!(
                    "reading {}, which keeps what is laid over the map; remove it to go on without",
                    path.display()
                )
            })?;
        }
        kept.revision = unix_ns() / 1_000_000;
        self.desk.note(map, &kept.document);
        self.maps.insert(map.to_owned(), kept);
        Ok(())
    }

    /// Longest file that keeps entries \[bytes\]: a longer one is not written.
    fn longest_state(&self) -> u64 {
        STATE_PER_BYTE.saturating_mul(self.rules.limits.bytes as u64)
    }

    fn save(&self, map: &str, state: &str) -> Result<()> {
        let Some(path) = self.file(map) else { return Ok(()) };
        replace_text_durably(&path, state).context("keeping what is laid over the map")
    }

    /// The overlay of a generation that is about to be served, whose bytes `read` gives; none where nothing is said. [`Overlays::took`] is told once it is served.
    ///
    /// Errors: the archive cannot be read.
    pub(super) fn for_next(
        &mut self,
        map: &str,
        archive: &Prepared,
        read: impl FnOnce(&mut [u8]) -> io::Result<()>,
    ) -> Result<Next, ServeError> {
        let Some(kept) = self.maps.get_mut(map) else { return Ok(Next::default()) };
        kept.document.forget_ended(now());
        if kept.document.entries.is_empty() {
            return Ok(Next::default());
        }
        let desk = &self.desk;
        let made = on_archive(map, archive, read, |next| make(desk, map, next, kept));
        made.map(|(bytes, unplaced)| Next { bytes, unplaced })
    }

    /// Notes, and tells, what does not fit the generation that is served from now on.
    pub(super) fn took(&mut self, map: &str, unplaced: Vec<Unplaced>) {
        for unfit in &unplaced {
            tracing::warn!(
                map,
                entry = unfit.id,
                "map {map}: overlay entry {:?} does not fit the new map and is left out{}: {}: {}",
                unfit.id,
                if unfit.is_part { " in part" } else { "" },
                unfit.field,
                unfit.why
            );
        }
        if let Some(kept) = self.maps.get_mut(map) {
            kept.unplaced = unplaced;
        }
    }
}

/// Resolves what is kept under its next revision; none where no entry is left.
fn make(
    desk: &Desk,
    name: &str,
    map: Map<'_>,
    kept: &mut Kept,
) -> (Option<OverlayBytes>, Vec<Unplaced>) {
    let resolved = desk.resolve(name, map, &kept.document);
    kept.revision += 1;
    let none_left = resolved.rows.entries.is_empty();
    let bytes = encode_overlay(&resolved.rows, map.content_hash()).ok().filter(|_| !none_left);
    let overlay = bytes.and_then(|bytes| {
        let content_hash = Header::decode(bytes.get(..HEADER_LENGTH)?).ok()?.content_hash;
        Some(OverlayBytes { revision: kept.revision, content_hash, bytes: bytes.to_vec() })
    });
    (overlay, resolved.unplaced)
}

impl Overlays {
    /// Tells what the operator did, where it is told what processes on board do.
    fn tell_operator(&self, map: &str, what: &str, ids: &[String]) {
        let Some(audit) = &self.audit else { return };
        let told = ids.iter().take(MOST_TOLD).map(String::as_str).collect::<Vec<_>>().join(", ");
        let more = ids.len().saturating_sub(MOST_TOLD);
        let reason = if more > 0 { format!("{told} and {more} more") } else { told };
        let line = Line {
            time: now(),
            source: "operator",
            user: None,
            decision: what,
            reason: &reason,
            entry: None,
        };
        if let Err(error) = audit.write(map, &line) {
            tracing::warn!(map, "map {map}: the audit log cannot be written: {error}");
        }
    }

    /// What is laid over a map, in numbers.
    fn status(&self, map: &str) -> OverlayStatus {
        let Some(kept) = self.maps.get(map) else { return OverlayStatus::default() };
        let count = |is_part| kept.unplaced.iter().filter(|one| one.is_part == is_part).count();
        OverlayStatus {
            revision: kept.revision,
            entries: kept.document.entries.len() as u64,
            unplaced: count(false) as u64,
            in_part: count(true) as u64,
        }
    }
}

impl Maps {
    /// Writes down what is laid over a map.
    pub(super) fn tell_overlay(&self, map: &str) {
        let overlay = self.overlays.status(map);
        self.board.map(map, |state| state.overlay = overlay);
    }

    /// Does what is asked, and answers.
    pub(super) fn overlay(&mut self, order: OverlayOrder) {
        let OverlayOrder { map, action, reply, is_proposed } = order;
        let response = match self.overlays.maps.contains_key(&map) {
            true => self.overlaid(&map, action, is_proposed),
            false => {
                Response::Refused { reason: format!("this daemon does not serve a map {map:?}") }
            }
        };
        // Who does not wait any more finds it by `mapd overlay … list`.
        let _ = reply.send(response);
    }

    fn overlaid(&mut self, map: &str, action: Action, is_proposed: bool) -> Response {
        let Some(before) = self.overlays.maps.get(map).cloned() else {
            return Response::Refused { reason: "nothing is served".to_owned() };
        };
        let mut next = before.clone();
        next.document.forget_ended(now());
        let limits = &self.overlays.rules.limits;
        let (what, applied, from) = match action {
            Action::List => return self.listed(map),
            Action::Apply { document, feed, unread, ended, signed } => {
                if let Some(feed) = &feed {
                    next.document.forget_of_feed(feed, &document, &unread);
                }
                for feed in &ended {
                    next.document.forget_of_feed(feed, &Document::default(), &[]);
                }
                let ids: Vec<String> = document.entries.iter().map(|e| e.id.clone()).collect();
                match next.document.apply(document, limits) {
                    Ok(()) => ("applied", ids, signed),
                    Err(error) => return Response::Wrong { reason: error.to_string() },
                }
            }
            Action::Remove { ids } => match next.document.remove(&ids) {
                Ok(()) => ("removed", ids, None),
                Err(id) => return Response::Wrong { reason: format!("there is no entry {id:?}") },
            },
            Action::Clear => {
                next.document.entries.clear();
                ("cleared", Vec::new(), None)
            }
        };
        next.settle(&applied, from);
        match self.lay(map, next, &applied) {
            Ok(None) => {
                let entries = self.overlays.maps.get(map).map_or(0, |k| k.document.entries.len());
                tracing::info!(map, entries, "map {map}: overlay {what}, {entries} entries");
                if !is_proposed {
                    self.overlays.tell_operator(map, what, &applied);
                }
                self.listed(map)
            }
            Ok(Some(reason)) => Response::Wrong { reason },
            Err(error) => Response::Refused { reason: explained(&error) },
        }
    }

    /// Has readers see what is to be kept; a reason where an entry that is new does not fit, and then nothing is changed.
    fn lay(&mut self, map: &str, mut next: Kept, applied: &[String]) -> Result<Option<String>> {
        let served = Client::connect_as(Attach::Observer, &self.domain, map, OWN_MAP)?;
        let snapshot = served.snapshot();
        let (overlay, unplaced) = make(&self.overlays.desk, map, snapshot.map(), &mut next);
        let is_refused = |unfit: &&Unplaced| !unfit.is_part && applied.contains(&unfit.id);
        if let Some(unfit) = unplaced.iter().find(is_refused) {
            return Ok(Some(format!("entry {:?}, {}: {}", unfit.id, unfit.field, unfit.why)));
        }
        next.unplaced = unplaced;
        let Some(before) = self.overlays.maps.get(map).cloned() else { bail!("nothing is served") };
        let (state, longest) = (next.text()?, self.overlays.longest_state());
        if self.overlays.file(map).is_some() && state.len() as u64 > longest {
            let length = state.len();
            return Ok(Some(format!(
                "all entries would take {length} bytes with what is laid over the map already; at most {longest} are kept, {STATE_PER_BYTE} times --overlay-bytes"
            )));
        }
        self.overlays.save(map, &state)?;
        if let Err(error) = self.server.lay(map, overlay.as_ref()) {
            // What readers see is what is kept.
            self.overlays.save(map, &before.text()?)?;
            return Err(error.into());
        }
        self.overlays.desk.note(map, &next.document);
        self.overlays.maps.insert(map.to_owned(), next);
        self.tell_overlay(map);
        Ok(None)
    }

    fn listed(&self, map: &str) -> Response {
        let Some(kept) = self.overlays.maps.get(map) else {
            return Response::Refused { reason: "nothing is served".to_owned() };
        };
        let entries = kept.document.entries.iter().map(|entry| {
            let why = |is_part| {
                let own = |unfit: &&Unplaced| unfit.id == entry.id && unfit.is_part == is_part;
                let unfit = kept.unplaced.iter().find(own)?;
                Some(format!("{}: {}", unfit.field, unfit.why))
            };
            ListedEntry { entry: entry.clone(), unplaced: why(false), part: why(true) }
        });
        Response::Overlay(OverlayReport { revision: kept.revision, entries: entries.collect() })
    }
}
