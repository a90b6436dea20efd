//! The daemon: serves maps, and changes what it serves under running readers.
//!
//! ```text
//!   SIGHUP ─┐                                       ┌─ thread `prepare`: cache, or a child process that compiles
//!   watch ──┤ orders, a bell     ┌──────────────┐   │
//!   control ┴───────────────────►│ main thread  │◄──┘ an archive in a file
//!                                │ owns Server  │──► copied into the loan, proved there, sent or staged
//!   threads `control`, `request` ◄── Board ─────┘
//! ```
//!
//! Only the main thread touches iceoryx2, and it never waits for a compiler. Whatever fails, what was served is served on,
//! and the reason is in the log and in the status.

mod args;
mod changes;
mod child;
mod config;
mod desk;
mod kept;
mod left_out;
mod log;
mod maps;
mod orders;
mod overlays;
mod prepare;
mod proposals;
mod settings;
mod sources;
mod watch;
mod worker;

pub(crate) use args::{DaemonArgs, check_name};
pub(crate) use changes::sentence;
pub(crate) use config::Configuration;

use crate::control::{Board, CacheStatus, ControlListener, Request, Response, Trigger};
use crate::exit::{Exit, UsageError, explained};
use crate::oversight::{Oversight, OversightArgs};
use crate::serve::{Doorbell, ServeError, Server, StopSignal};
use anyhow::{Context, Result, bail};
use log::say;
use mapd_client::TrustedKey;
use mapd_transport::Share;
use maps::{FirstServing, Maps};
use orders::{Change, Order, Orders};
use overlays::{OverlayOrder, Overlays, Reader};
use prepare::{Prepared, Preparer};
use proposals::Judge;
use rustix::fs::Mode;
use settings::Settings;
use signal_hook::consts::SIGHUP;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use watch::{WatchList, Watched, Watcher};
use worker::Worker;

/// Longest wait of a status for what readers hold now; then it has what they held a moment ago.
const LOOK_PATIENCE: Duration = Duration::from_millis(100);

/// What is said of a stop during the start.
const STOPPED_BEFORE: &str = "stopped before anything was served";

/// Serves every map until stopped. All are prepared before the first is published: either all are served or none.
///
/// Errors: files, shared memory, or another daemon that serves a map of the same name.
pub(crate) fn run(
    settings: Settings,
    trust: Option<TrustedKey>,
    oversight: &OversightArgs,
) -> Result<Exit> {
    // First of all: a signal that comes while maps are compiled is obeyed, not died of.
    let stop = StopSignal::install().context("installing the handlers of SIGINT and SIGTERM")?;
    let door = Doorbell::new().context("a socket pair")?;
    let hangup = Arc::new(AtomicBool::new(false));
    // The flag is set before the bell rings: handlers run in the order they were registered.
    signal_hook::flag::register(SIGHUP, hangup.clone())
        .and_then(|_| door.ring_on(SIGHUP))
        .context("installing the handler of SIGHUP")?;
    let metrics = oversight.open_metrics()?;
    let cancelled = stop.flag();
    let Settings { domain, cache, means, lock_memory, share, overlay, proposals, maps, .. } =
        settings;
    let preparer = Preparer { cache, means, trust, cancelled };
    let watched: WatchList = Arc::default();
    let (mut ready, mut fallbacks) = (Vec::new(), Vec::new());
    let mut exit = Exit::Done;
    for map in &maps {
        let before = watch::identities(std::slice::from_ref(&map.source));
        match preparer.prepare(map, false) {
            Ok(prepared) => {
                watch(&watched, map, &prepared, before);
                ready.push((map.clone(), prepared));
            }
            Err(_) if stop.is_requested() => break,
            Err(refusal) => {
                child::tell(&map.name, &refusal);
                match preparer.last_served(&domain, map) {
                    Some(prepared) => {
                        say(&format!("map {}: serving the map that was served last", map.name));
                        watch(&watched, map, &prepared, before);
                        watch::watch_more(&watched, &map.name, &refusal);
                        ready.push((map.clone(), prepared));
                        fallbacks.push((map.name.clone(), refusal.reason().to_owned()));
                    }
                    None => exit = exit.worst(refusal.exit()),
                }
            }
        }
    }
    if stop.is_requested() {
        say(STOPPED_BEFORE);
        return Ok(Exit::Done);
    }
    if exit != Exit::Done {
        say("nothing is served: a map was rejected, or could not be compiled");
        return Ok(exit);
    }
    let (orders, received) = Orders::new(door.ringer().context("a socket pair")?);
    let mut server = Server::start_with(&domain, crate::oversight::log::notice)?;
    server.lock_memory(lock_memory);
    if share != Share::Private {
        // What a group may read in, it must not write: nothing is made with rights that are taken away only afterwards.
        rustix::process::umask(Mode::RWXG | Mode::RWXO);
    }
    server.share(share)?;
    if let Some(cache) = &preparer.cache {
        server.keep_generations_in(cache.folder());
    }
    let folder = preparer.cache.as_ref().map(|cache| cache.folder().to_owned());
    let mut overlays = Overlays::new(overlay.clone(), domain.clone(), folder.clone());
    let judge = match (proposals, &folder) {
        (None, _) => None,
        (Some(_), None) => bail!(UsageError(
            "--overlay-from: the audit log is kept in the cache folder; there is none".to_owned()
        )),
        (Some(policy), Some(folder)) => {
            let place = (folder.as_path(), domain.prefix());
            let judge = Judge::new(policy, place, overlays.desk.clone(), orders.clone());
            overlays.audit = Some(judge.audit.clone());
            Some(judge)
        }
    };
    let board = Arc::new(Board::new(&domain, preparer.cache.as_ref().map(CacheStatus::of)));
    if let Some(in_the_way) = server.without_subscribers() {
        board.without_subscribers(in_the_way.to_string());
    }
    let names: Vec<String> = maps.iter().map(|map| map.name.clone()).collect();
    let mut state = Maps::new(server, overlays, board.clone(), preparer.clone(), watched.clone());
    match state.begin_all(ready) {
        Ok(FirstServing::All) => {}
        Ok(FirstServing::Stopped { served: 0 }) => {
            say(STOPPED_BEFORE);
            return Ok(Exit::Done);
        }
        Ok(FirstServing::Stopped { .. }) => {
            drop(state);
            say("stopped");
            return Ok(Exit::Done);
        }
        // Bytes that do not prove: no other start makes them good.
        Err(error)
            if matches!(error.downcast_ref::<ServeError>(), Some(ServeError::Fill { .. })) =>
        {
            say(&format!("nothing is served: {}", explained(&error)));
            return Ok(Exit::Rejected);
        }
        Err(error) => return Err(error),
    }
    for (map, reason) in &fallbacks {
        state.fell_back(map, reason);
    }
    let desk = state.overlays.desk.clone();
    let reader = Reader { limits: overlay.limits, trust: overlay.trust, desk: desk.clone() };
    let control = answer_with(board.clone(), orders.clone(), reader);
    // Maps are served without control rather than not at all.
    let control = ControlListener::start(&domain, &names, control)
        .inspect_err(|error| say(&format!("continuing without `mapd reload`: {error}")));
    let proposals = judge.and_then(|judge| {
        let maps = names.clone();
        let decide = move |map: usize, user: u32, text: &[u8]| {
            judge.decide(maps.get(map).map_or("", String::as_str), user, text)
        };
        ControlListener::start_for_proposals(&domain, &names, share, decide)
            .inspect_err(|error| say(&format!("continuing without proposals: {error}")))
            .ok()
    });
    let worker =
        Worker::start(preparer, maps.clone(), board, desk, orders.clone()).context("a thread")?;
    let watcher = match maps.iter().any(|map| map.watch) {
        true => Some(Watcher::start(watched, orders).context("a thread")?),
        false => None,
    };
    for name in &names {
        state.say_served(name);
    }
    let watched_over = Oversight::start(oversight, metrics, &domain, &state.board, names)?;
    while !stop.is_requested() {
        state.server.run_until(&stop, &door)?;
        door.answer();
        if hangup.swap(false, Ordering::SeqCst) {
            for map in &maps {
                let (map, stage) = (map.name.clone(), map.stage);
                let (trigger, begun) = (Trigger::Signal, Instant::now());
                state.change(Change { map, trigger, stage, begun, reply: None }, &worker);
            }
        }
        obey(&received, &mut state, &worker, &stop);
    }
    // Clients that wait for an answer are told that there is none, the compiler is ended, and the sockets are removed while the
    // maps are still claimed.
    // What watches over the daemon may be attaching at this moment, and is greeted until it has ended.
    state.server.meanwhile(|| drop(watched_over))?;
    drop((watcher, received, worker, control, proposals));
    drop(state);
    say("stopped");
    Ok(Exit::Done)
}

fn obey(received: &Receiver<Order>, state: &mut Maps, worker: &Worker, stop: &StopSignal) {
    while let Ok(order) = received.try_recv() {
        if stop.is_requested() {
            return;
        }
        match order {
            Order::Look(done) => {
                state.look();
                // Who does not wait any more needs no word.
                let _ = done.send(());
            }
            Order::Change(change) => state.change(change, worker),
            Order::Overlay(order) => state.overlay(order),
            Order::Prepared(job, result) => state.prepared(*job, result, worker),
        }
    }
}

/// Notes which files a map was made of.
fn watch(
    list: &WatchList,
    map: &settings::MapSettings,
    prepared: &Prepared,
    source: watch::Identities,
) {
    if !map.watch {
        return;
    }
    let mut read = watch::identities(&prepared.files);
    // The document itself as it was before it was read.
    if let (Some(first), Some(before)) = (read.first_mut(), source.into_iter().next()) {
        *first = before;
    }
    let watched = Watched { files: prepared.files.clone(), read, stage: map.stage };
    let mut list = list.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    list.insert(map.name.clone(), watched);
}

/// Answers requests: the status at once from the board, everything else by an order.
fn answer_with(
    board: Arc<Board>,
    orders: Orders,
    reader: Reader,
) -> impl Fn(Request) -> Response + Send + Sync {
    // `Sender`s are not `Sync` in every version of the standard library that is supported.
    let orders = Mutex::new(orders);
    move |request| {
        let orders = orders.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
        let begun = Instant::now();
        let (map, trigger, stage) = match request {
            Request::Status => {
                let (done, looked) = channel();
                orders.give(Order::Look(done));
                // The main thread may be copying a large map: then the board says what was so before.
                let _ = looked.recv_timeout(LOOK_PATIENCE);
                return Response::Status(Box::new(board.status_with_subscribers()));
            }
            Request::Reload { map, stage } => (map, Trigger::Reload, stage),
            Request::Rollback { map, stage } => (map, Trigger::Rollback, stage),
            Request::Activate { map } => (map, Trigger::Activate, false),
            Request::Overlay { map, action } => {
                let action = match reader.read(&map, action) {
                    Ok(action) => action,
                    Err(error) => return Response::Wrong { reason: explained(&error) },
                };
                let (reply, outcome) = channel();
                orders.give(Order::Overlay(OverlayOrder {
                    map,
                    action,
                    reply,
                    is_proposed: false,
                }));
                return outcome.recv().unwrap_or_else(|_| ended());
            }
        };
        let (reply, outcome) = channel();
        let change = Change { map, trigger, stage, begun, reply: Some(reply) };
        orders.give(Order::Change(change));
        outcome.recv().unwrap_or_else(|_| ended())
    }
}

fn ended() -> Response {
    Response::Refused { reason: "the daemon ends".to_owned() }
}

/// What is said about several maps, by name.
type ByName<T> = BTreeMap<String, T>;
