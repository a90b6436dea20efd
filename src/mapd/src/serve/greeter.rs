//! Answering newcomers: a subscriber gets the served generation when the publisher looks for it, not before.

use super::doorbell::Doorbell;
use super::error::ServeError;
use super::notice::Notice;
use super::served_map::MapPorts;
use super::stop::StopSignal;
use iceoryx2::prelude::{CallbackProgression, SignalHandlingMode, WaitSetBuilder};
use mapd_transport::{AttachLock, TransportService};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// How long newcomers wait, at most, for another daemon of the domain that cleans up; else they are served by the round.
const PATIENCE: Duration = Duration::from_millis(50);

/// Time between two rounds.
const ROUND: Duration = Duration::from_secs(1);

/// What ends greeting.
#[derive(Clone, Copy)]
pub(crate) struct GreetUntil<'a> {
    /// The daemon stops.
    pub(crate) stop: &'a StopSignal,
    /// The caller is wanted elsewhere, if that can happen.
    pub(crate) door: Option<&'a Doorbell>,
}

/// Greets each client that rings, at once, until it is to end; about once a second, next at `next_round`, says that the daemon
/// lives, and calls `round`.
///
/// Errors: waiting fails; `round` fails.
pub(crate) fn greet_until(
    GreetUntil { stop, door }: GreetUntil<'_>,
    next_round: &mut Instant,
    maps: &BTreeMap<String, MapPorts>,
    lock: &AttachLock,
    notify: &dyn Fn(&Notice),
    round: &mut dyn FnMut() -> Result<(), ServeError>,
) -> Result<(), ServeError> {
    let waits = WaitSetBuilder::new()
        .signal_handling_mode(SignalHandlingMode::Disabled)
        .create::<TransportService>()
        .map_err(ServeError::iceoryx("creating a wait set"))?;
    let _stop = waits
        .attach_notification(stop)
        .map_err(ServeError::iceoryx("waiting for the stop signal"))?;
    let at_door = match door {
        Some(door) => Some(
            waits.attach_notification(door).map_err(ServeError::iceoryx("waiting for orders"))?,
        ),
        None => None,
    };
    let mut bells = Vec::new();
    // Where nothing is served yet, there is nothing to greet with; a client that rings meanwhile gets the map when it is first sent.
    for (name, ports) in maps.iter().filter(|(_, ports)| ports.info().is_some()) {
        let Some(subscribing) = &ports.subscribing else { continue };
        let bell = waits
            .attach_notification(&subscribing.woken)
            .map_err(ServeError::iceoryx("waiting for clients"))?;
        bells.push((bell, name, ports));
    }
    let mut called = false;
    while !stop.is_requested() && !called {
        if Instant::now() >= *next_round {
            maps.values().for_each(|ports| ports.record.beat());
            round()?;
            *next_round = Instant::now() + ROUND;
        }
        let mut ringing = Vec::new();
        let left = next_round.saturating_duration_since(Instant::now());
        let collect = |id: iceoryx2::prelude::WaitSetAttachmentId<TransportService>| {
            called |= at_door.as_ref().is_some_and(|door| id.has_event_from(door));
            ringing.extend(bells.iter().filter(|(bell, ..)| id.has_event_from(bell)));
            CallbackProgression::Continue
        };
        waits
            .wait_and_process_once_with_timeout(collect, left)
            .map_err(ServeError::iceoryx("waiting"))?;
        if !ringing.is_empty() {
            let guard = lock.shared(Instant::now() + PATIENCE)?;
            for (_, name, ports) in ringing {
                ports.take_wake_ups();
                if guard.is_some() {
                    ports.greet(name, notify);
                }
            }
        }
    }
    Ok(())
}

/// Does something that takes long while a thread of its own greets newcomers, if there is anything to greet them with.
pub(crate) fn greeting_meanwhile<T>(
    maps: &BTreeMap<String, MapPorts>,
    lock: &AttachLock,
    work: impl FnOnce() -> Result<T, ServeError>,
) -> Result<T, ServeError> {
    /// Stops even if the work panics: the scope waits for the thread.
    struct StopAtEnd<'a>(&'a StopSignal);
    impl Drop for StopAtEnd<'_> {
        fn drop(&mut self) {
            self.0.request();
        }
    }
    if maps.values().all(|ports| ports.info().is_none()) {
        return work();
    }
    let stop = StopSignal::new().map_err(ServeError::io("socket pair"))?;
    std::thread::scope(|scope| {
        let _at_end = StopAtEnd(&stop);
        // If it fails, or no thread can be had, newcomers wait until the work is done, as they would without it.
        let _ = std::thread::Builder::new().name("greet".to_owned()).spawn_scoped(scope, || {
            greet_until(
                GreetUntil { stop: &stop, door: None },
                &mut Instant::now(),
                maps,
                lock,
                &|_| {},
                &mut || Ok(()),
            )
        });
        work()
    })
}
