//! Decides about proposals.

use super::audit::{Audit, Line, now};
use super::policy::{ProposalPolicy, Rule};
use crate::control::Response;
use crate::daemon::desk::Desk;
use crate::daemon::kept::PROPOSED;
use crate::daemon::orders::{Order, Orders};
use crate::daemon::overlays::{Action, OverlayOrder};
use mapd_client::overlay::Decision;
use mapd_overlay::{Document, Entry, EntryLocation, Limits, Moment};
use std::path::Path;
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Proposals that wait for others at a time, of all maps; the oldest gives way.
const MOST_WAITING: usize = 1_000;

/// Refusals that the audit log has in a minute, of all maps; those beyond are counted.
const MOST_REFUSALS: u32 = 120;

/// Largest extent of a place on Earth \[deg\]: what is seen from a vehicle is near to it.
const LARGEST_EXTENT: f64 = 0.2;

const MINUTE: Duration = Duration::from_secs(60);

/// Decides about proposals, and writes down what it decides.
pub(crate) struct Judge {
    policy: ProposalPolicy,
    pub(crate) audit: Arc<Audit>,
    desk: Arc<Desk>,
    orders: Mutex<Orders>,
    state: Mutex<State>,
}

struct State {
    waiting: Vec<Waiting>,
    /// Of each rule, proposals since the minute began.
    counts: Vec<u32>,
    refusals: u32,
    minute: Instant,
}

/// What was said, and waits for others to say the same.
struct Waiting {
    map: String,
    source: String,
    entry: Entry,
    location: EntryLocation,
    until: Instant,
}

impl Judge {
    pub(crate) fn new(
        policy: ProposalPolicy,
        (folder, prefix): (&Path, &str),
        desk: Arc<Desk>,
        orders: Orders,
    ) -> Self {
        let state = State {
            waiting: Vec::new(),
            counts: vec![0; policy.rules.len()],
            refusals: 0,
            minute: Instant::now(),
        };
        let audit = Arc::new(Audit::new(folder, prefix));
        Self { policy, audit, desk, orders: Mutex::new(orders), state: Mutex::new(state) }
    }

    /// Decides about a proposal of a process of this user: the name of a source, a line break, an entry.
    pub(crate) fn decide(&self, map: &str, user: u32, text: &[u8]) -> Decision {
        let text = String::from_utf8_lossy(text);
        let (source, entry) = text.split_once('\n').unwrap_or((&text, ""));
        let source: String = source.chars().take(super::policy::LONGEST_SOURCE).collect();
        let (entry, decision) = match self.judged(map, &source, user, entry) {
            Ok((entry, decision)) => (Some(entry), decision),
            Err(reason) => (None, Decision::Refused { reason }),
        };
        let (word, reason) = match &decision {
            Decision::Accepted => ("accepted", String::new()),
            Decision::Waiting { agree, needed } => ("waiting", format!("{agree} of {needed}")),
            Decision::Refused { reason } => ("refused", reason.clone()),
        };
        let line = Line {
            time: now(),
            source: &source,
            user: Some(user),
            decision: word,
            reason: &reason,
            entry: entry.as_ref(),
        };
        // What is accepted was told before it was.
        if word != "accepted"
            && self.may_tell(word == "refused")
            && let Err(error) = self.audit.write(map, &line)
        {
            tracing::warn!(map, "map {map}: the audit log cannot be written: {error}");
        }
        decision
    }

    /// Whether a line that is no acceptance is written: floods of refusals do not fill the disk.
    fn may_tell(&self, is_refusal: bool) -> bool {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.turn();
        state.refusals += u32::from(is_refusal);
        !is_refusal || state.refusals <= MOST_REFUSALS
    }

    fn judged(
        &self,
        map: &str,
        source: &str,
        user: u32,
        text: &str,
    ) -> Result<(Entry, Decision), String> {
        let is_own = |rule: &&Rule| rule.source == source && rule.user == user;
        // The kinds of a source may be in several rules: the first that has one decides for all that can be said before the kind is known.
        let number = self.policy.rules.iter().position(|rule| is_own(&rule));
        let number =
            number.ok_or_else(|| format!("the policy does not know {source:?} of user {user}"))?;
        self.count(number)?;
        let limits = Limits { entries: 1, ..Limits::default() };
        let document = format!(r#"{{"entries":[{text}]}}"#);
        let document = Document::read(document.as_bytes(), &limits).map_err(|e| e.to_string())?;
        let [entry] = <[Entry; 1]>::try_from(document.entries).map_err(|_| "expected one entry")?;
        let own = self.policy.rules.iter().filter(is_own);
        let kind = entry.kind;
        let rule = own.clone().find(|rule| rule.kinds.contains(&kind));
        let rule = rule.ok_or_else(|| format!("{source:?} may not say `{}`", kind.name()))?;
        let entry = admitted(entry, rule, now())?;
        let document = Document { entries: vec![entry] };
        // The name of its source has made it longer.
        document.check(&limits).map_err(|error| error.to_string())?;
        let location = self.desk.location(map, &document)?;
        let [entry] = <[Entry; 1]>::try_from(document.entries).map_err(|_| "expected one entry")?;
        if self.desk.count(map, &format!("{PROPOSED}{source}/"), &entry.id) >= rule.most {
            return Err(format!("{source:?} has {} entries already", rule.most));
        }
        let others = self.others(map, source, &entry, &location);
        let agree = others.len() as u32 + 1;
        if agree < rule.agree {
            self.wait(Waiting {
                map: map.to_owned(),
                source: source.to_owned(),
                entry: entry.clone(),
                location,
                until: Instant::now() + rule.within,
            });
            return Ok((entry, Decision::Waiting { agree, needed: rule.agree }));
        }
        let mut agreed = entry;
        agreed.source =
            std::iter::once(source.to_owned()).chain(others).collect::<Vec<_>>().join(", ");
        let line = Line {
            time: now(),
            source,
            user: Some(user),
            decision: "accepted",
            reason: "",
            entry: Some(&agreed),
        };
        let told = self.audit.write(map, &line);
        told.map_err(|error| format!("the audit log cannot be written: {error}"))?;
        let decision = self.lay(map, agreed.clone());
        Ok((agreed, decision))
    }

    /// Counts a proposal of a rule.
    ///
    /// Errors: there were too many in this minute.
    fn count(&self, rule: usize) -> Result<(), String> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.turn();
        let most = self.policy.rules.get(rule).map_or(0, |rule| rule.rate);
        let Some(count) = state.counts.get_mut(rule) else { return Ok(()) };
        *count = count.saturating_add(1);
        if *count > most {
            return Err(format!("more than {most} proposals in a minute"));
        }
        Ok(())
    }

    /// Other sources that have said the same of a place that meets this one.
    fn others(
        &self,
        map: &str,
        source: &str,
        entry: &Entry,
        location: &EntryLocation,
    ) -> Vec<String> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        state.waiting.retain(|one| one.until > now);
        let says_so = |one: &&Waiting| {
            one.map == map
                && one.source != source
                && one.entry.kind == entry.kind
                && one.entry.vehicles == entry.vehicles
                && one.location.overlaps(location)
        };
        let mut others: Vec<String> =
            state.waiting.iter().filter(says_so).map(|one| one.source.clone()).collect();
        others.sort();
        others.dedup();
        others
    }

    fn wait(&self, waiting: Waiting) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.waiting.retain(|one| one.map != waiting.map || one.entry.id != waiting.entry.id);
        if state.waiting.len() >= MOST_WAITING {
            state.waiting.remove(0);
        }
        state.waiting.push(waiting);
    }

    fn lay(&self, map: &str, entry: Entry) -> Decision {
        let document = Document { entries: vec![entry] };
        self.desk.place_on_served(map, &document);
        let (reply, outcome) = channel();
        let action = Action::Apply {
            document,
            feed: None,
            unread: Vec::new(),
            ended: Vec::new(),
            signed: None,
        };
        let order = OverlayOrder { map: map.to_owned(), action, reply, is_proposed: true };
        self.orders.lock().unwrap_or_else(PoisonError::into_inner).give(Order::Overlay(order));
        match outcome.recv() {
            Ok(Response::Overlay(_)) => Decision::Accepted,
            Ok(Response::Wrong { reason } | Response::Refused { reason }) => {
                Decision::Refused { reason }
            }
            _ => Decision::Refused { reason: "the daemon ends".to_owned() },
        }
    }
}

impl State {
    /// Begins another minute, if it is time.
    fn turn(&mut self) {
        if self.minute.elapsed() >= MINUTE {
            if self.refusals > MOST_REFUSALS {
                let untold = self.refusals - MOST_REFUSALS;
                tracing::warn!("{untold} proposals were refused that the audit log does not have");
            }
            self.minute = Instant::now();
            self.refusals = 0;
            self.counts.iter_mut().for_each(|count| *count = 0);
        }
    }
}

/// An entry as it is laid over the map: under a name of its source, and for as long as the rule allows.
///
/// Errors: what the rule does not allow.
fn admitted(mut entry: Entry, rule: &Rule, now: Moment) -> Result<Entry, String> {
    if entry.confidence < rule.confidence {
        return Err(format!(
            "confidence: {} must be at least {}",
            entry.confidence, rule.confidence
        ));
    }
    if !entry.feed.is_empty() {
        return Err("feed: a proposal is of none".to_owned());
    }
    for place in &entry.places {
        let points = || place.line.iter().chain(&place.area);
        let extent = |axis: usize| {
            let all = || points().map(|point| point[axis]);
            all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
        };
        if extent(0).max(extent(1)) > LARGEST_EXTENT {
            return Err(format!("places: larger than {LARGEST_EXTENT}°"));
        }
    }
    let latest = now.unix_seconds + rule.longest.as_secs_f64();
    let until = entry.until.map_or(latest, |until| until.unix_seconds.min(latest));
    if until <= now.unix_seconds || entry.from.is_some_and(|from| from.unix_seconds >= until) {
        return Err("until: it ends before it begins".to_owned());
    }
    entry.until = Some(Moment { unix_seconds: until });
    entry.id = format!("{PROPOSED}{}/{}", rule.source, entry.id);
    rule.source.clone_into(&mut entry.source);
    Ok(entry)
}
