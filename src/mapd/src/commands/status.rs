//! `mapd status`.

use crate::args::DomainArgs;
use crate::clock::since_epoch;
use crate::control::{CacheStatus, DaemonStatus, MapState, OverlayStatus, Request, Response, ask};
use crate::exit::Exit;
use crate::printable::printable;
use crate::report::hex;
use crate::rounded;
use anyhow::Result;
use clap::Args;
use mapd_client::Domain;
use mapd_transport::{MapStatus, count_subscriptions, heartbeat_age, list_maps};
use serde::Serialize;
use std::io::Write;
use std::time::Duration;

/// Longest wait for a daemon's own account: what everybody can see is told without it.
const WAIT: Duration = Duration::from_secs(1);

/// Least width of the column of names.
const LEAST_NAME: usize = 20;

/// What is said where newcomers find no generation although one is served.
const UNREADABLE: &str = "the record of what is served is missing or damaged, so that new readers cannot attach; mend it with `mapd reload`";

/// A map: what everybody can see of it, and what its daemon says.
#[derive(Serialize)]
struct Status {
    name: String,
    alive: bool,
    pid: Option<u64>,
    generation: Option<u64>,
    bytes: Option<u64>,
    layout_id: Option<String>,
    content_hash: Option<String>,
    input_hash: Option<String>,
    /// `None` if they cannot be counted.
    subscribers: Option<usize>,
    /// How long ago its daemon last said that it lives.
    heard_seconds: Option<f64>,
    published_unix_ns: Option<u64>,
    /// What its daemon says about it; `None` if it does not answer.
    state: Option<MapState>,
    /// What its daemon says about itself.
    daemon: Option<Daemon>,
    /// Whether its daemon would answer this user; to others its heartbeat says that it lives.
    #[serde(skip)]
    may_ask: bool,
}

/// A daemon, its maps left out.
#[derive(Clone, Serialize)]
struct Daemon {
    version: String,
    pid: u32,
    started_unix_ns: u64,
    uptime_seconds: f64,
    cache: Option<CacheStatus>,
    without_subscribers: Option<String>,
}

impl Status {
    fn of(
        map: MapStatus,
        subscribers: Option<usize>,
        heard: Option<Duration>,
        daemon: Option<&DaemonStatus>,
        may_ask: bool,
    ) -> Self {
        let info = map.info;
        let state = daemon.and_then(|daemon| daemon.maps.iter().find(|m| m.name == map.name));
        Self {
            name: map.name,
            alive: map.alive,
            pid: info.map(|i| i.daemon_pid),
            generation: info.map(|i| i.generation),
            bytes: info.map(|i| i.length),
            layout_id: info.map(|i| hex(&i.layout_id[..16])),
            content_hash: info.map(|i| hex(&i.content_hash)),
            input_hash: info.map(|i| hex(&i.input_hash)),
            subscribers,
            heard_seconds: heard.map(|age| age.as_secs_f64()),
            published_unix_ns: info.map(|i| i.published_unix_ns),
            state: state.cloned(),
            daemon: daemon.map(|daemon| Daemon {
                version: daemon.version.clone(),
                pid: daemon.pid,
                started_unix_ns: daemon.started_unix_ns,
                uptime_seconds: daemon.uptime_seconds,
                cache: daemon.cache.clone(),
                without_subscribers: daemon.without_subscribers.clone(),
            }),
            may_ask,
        }
    }
}

impl Status {
    /// Why this map is not as it should be.
    fn trouble(&self) -> Option<String> {
        let name = &self.name;
        match &self.state {
            _ if !self.alive => Some(format!("{name}: no daemon")),
            None if self.may_ask => Some(format!("{name}: its daemon does not answer")),
            None => None,
            Some(state) if state.self_queries.last_failed == Some(true) => {
                Some(format!("{name}: {}", state.self_queries.last_error))
            }
            Some(state) if state.scrubs.last_failed == Some(true) => {
                Some(format!("{name}: {}", state.scrubs.last_error))
            }
            Some(_) => self.is_unreadable().then(|| format!("{name}: {UNREADABLE}")),
        }
    }

    /// Whether its daemon serves something, and no newcomer finds it.
    fn is_unreadable(&self) -> bool {
        let is_served = self.state.as_ref().is_some_and(|state| state.served.is_some());
        is_served && self.generation.is_none()
    }
}

/// What the daemons of these maps say, each asked once.
fn daemons(domain: &Domain, maps: &[MapStatus]) -> Vec<DaemonStatus> {
    let mut daemons: Vec<DaemonStatus> = Vec::new();
    for map in maps.iter().filter(|map| map.alive) {
        if daemons.iter().any(|daemon| daemon.maps.iter().any(|m| m.name == map.name)) {
            continue;
        }
        // One that does not answer is about to begin or end, or busy beyond measure.
        if let Ok(Response::Status(daemon)) = ask(domain, &map.name, &Request::Status, WAIT) {
            daemons.push(*daemon);
        }
    }
    daemons
}

/// Which maps to list, and how.
#[derive(Args)]
pub(crate) struct StatusCommand {
    /// Print JSON: also sources, counts, memory, staged generation, result of the last reload
    #[arg(long)]
    json: bool,
    /// Health check: exit with 1 if no map is served, a daemon does not answer, a map failed its last self-query or scrub, or new readers cannot find it
    #[arg(long)]
    healthy: bool,
    #[command(flatten)]
    domain: DomainArgs,
}

impl StatusCommand {
    /// Lists the maps that are served.
    ///
    /// Errors: as [`list`].
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let maps = list(&self.domain.domain()?, self.json, out)?;
        if !self.healthy {
            return Ok(Exit::Done);
        }
        let ill: Vec<String> = maps.iter().filter_map(Status::trouble).collect();
        for trouble in &ill {
            writeln!(std::io::stderr(), "mapd: {}", printable(trouble))?;
        }
        let is_healthy = !maps.is_empty() && ill.is_empty();
        Ok(if is_healthy { Exit::Done } else { Exit::Environment })
    }
}

/// What everybody can see of a map and what its daemon says of it, as JSON; `null` if there is no such map.
///
/// Errors: the domain cannot be read.
pub(crate) fn of_map(domain: &Domain, name: &str) -> Result<String> {
    let maps = list_maps(domain)?.into_iter().filter(|map| map.name == name).collect();
    Ok(serde_json::to_string(&all(domain, maps).first())?)
}

/// Maps, with what their daemons say.
fn all(domain: &Domain, maps: Vec<MapStatus>) -> Vec<Status> {
    let daemons = daemons(domain, &maps);
    // The socket is the owner's alone, as all that has mode 0600.
    let user = rustix::process::geteuid();
    let may_ask = user.is_root() || user.as_raw() == domain.owner();
    let of = |map: MapStatus| {
        let its = |daemon: &&DaemonStatus| daemon.maps.iter().any(|m| m.name == map.name);
        let daemon = daemons.iter().find(its);
        // Before the first generation there is nothing to subscribe to.
        let none = map.info.is_none().then_some(0);
        let subscribers = count_subscriptions(domain, &map.name).or(none);
        let heard = heartbeat_age(domain, &map.name);
        Status::of(map, subscribers, heard, daemon, may_ask)
    };
    maps.into_iter().map(of).collect()
}

/// Lists the maps of a domain, and hands them on.
fn list(domain: &Domain, json: bool, out: &mut dyn Write) -> Result<Vec<Status>> {
    let maps = all(domain, list_maps(domain)?);
    if json {
        serde_json::to_writer_pretty(&mut *out, &maps)?;
        writeln!(out)?;
        return Ok(maps);
    }
    if maps.is_empty() {
        writeln!(out, "no maps are served (prefix {})", domain.prefix())?;
        return Ok(maps);
    }
    let head = ("map", "generation", "size", "readers", "since", "content");
    let lengths = maps.iter().map(|map| map.name.chars().count());
    let width = lengths.max().unwrap_or(0).max(LEAST_NAME);
    writeln!(
        out,
        "{:<width$} {:>14} {:>12} {:>8} {:>10}  {}",
        head.0, head.1, head.2, head.3, head.4, head.5
    )?;
    for map in &maps {
        let number = |n: Option<u64>| n.map(|n| n.to_string()).unwrap_or_else(|| "-".to_owned());
        let content = map
            .content_hash
            .as_ref()
            .map(|hash| hash[..16].to_owned())
            .unwrap_or_else(|| "-".to_owned());
        let since = if map.alive { age(map.published_unix_ns) } else { "no daemon".to_owned() };
        writeln!(
            out,
            "{:<width$} {:>14} {:>12} {:>8} {:>10}  {content}",
            map.name,
            number(map.generation),
            map.bytes.map_or_else(|| "-".to_owned(), size),
            map.subscribers.map_or_else(|| "-".to_owned(), |count| count.to_string()),
            since
        )?;
        if let (false, Some(heard)) = (map.alive, map.heard_seconds) {
            let when = time(Duration::from_secs_f64(heard));
            writeln!(out, "    its daemon was killed, and last heard of {when} ago")?;
        }
        let Some(state) = &map.state else {
            if map.alive && map.may_ask {
                writeln!(out, "    its daemon does not answer")?;
            }
            continue;
        };
        if map.is_unreadable() {
            writeln!(out, "    {UNREADABLE}")?;
        }
        let daemon = map.daemon.as_ref();
        if let Some(reason) = daemon.and_then(|daemon| daemon.without_subscribers.as_ref()) {
            writeln!(out, "    without subscribers, who need that name: {reason}")?;
        }
        if let Some(staged) = &state.staged {
            writeln!(out, "    staged: generation {}, {}", staged.generation, size(staged.bytes))?;
        }
        let left_out = state.served.as_ref().map_or(0, |served| served.counts.quarantined);
        if left_out > 0 {
            writeln!(
                out,
                "    in quarantine: {left_out} parts, which `mapd inspect shm:{}` lists",
                map.name
            )?;
        }
        if state.overlay.entries > 0 {
            let OverlayStatus { revision, entries, unplaced, in_part } = state.overlay;
            write!(out, "    overlay: revision {revision}, {entries} entries")?;
            for (count, what) in [(unplaced, "do not fit"), (in_part, "fit in part")] {
                if count > 0 {
                    write!(out, ", {count} {what}")?;
                }
            }
            writeln!(out)?;
        }
        for held in &state.held {
            writeln!(
                out,
                "    held by readers: generation {}, {}",
                held.generation,
                size(held.bytes)
            )?;
        }
        for (what, check) in [("query of its own", &state.self_queries), ("scrub", &state.scrubs)] {
            if check.last_failed == Some(true) {
                writeln!(out, "    {what} failed: {}", printable(&check.last_error))?;
            }
        }
        if let Some(report) = &state.last_reload {
            writeln!(out, "    {}", printable(&crate::daemon::sentence(report)))?;
        }
    }
    Ok(maps)
}

/// How large an archive is.
fn size(bytes: u64) -> String {
    rounded::bytes(bytes as f64)
}

/// How long ago something was published.
fn age(published_unix_ns: Option<u64>) -> String {
    let Some(published) = published_unix_ns else { return "-".to_owned() };
    time(since_epoch().saturating_sub(Duration::from_nanos(published)))
}

/// A time in whole units.
fn time(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..120 => format!("{seconds} s"),
        seconds @ 120..7200 => format!("{} min", seconds / 60),
        seconds => format!("{} h", seconds / 3600),
    }
}
