//! Which maps a domain serves.

use super::domain::Domain;
use super::error::AttachError;
use super::protocol::{Channel, Chunk64, GenerationInfo, Ipc, service_name};
use super::subscription::Subscription;
use iceoryx2::prelude::*;
use iceoryx2::service::port_factory::PortFactory as _;
use iceoryx2::service::port_factory::publish_subscribe::PortFactory;
use std::fs::{File, TryLockError};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Ending of a map's lock file in the root folder.
const LOCK_ENDING: &str = "map.lock";
/// Longest wait for one map's header.
const WAIT: Duration = Duration::from_millis(500);

/// A map of a domain.
#[derive(Clone, Debug)]
pub struct MapStatus {
    /// Its name.
    pub name: String,
    /// Whether a daemon serves it now.
    pub alive: bool,
    /// What it was published with; none if no generation could be had.
    pub info: Option<GenerationInfo>,
    /// Clients attached, this look left out.
    pub subscribers: usize,
}

/// Path of a map's lock file, which its daemon holds.
pub fn map_lock(domain: &Domain, map: &str) -> PathBuf {
    domain.root().join(format!("{map}.{LOCK_ENDING}"))
}

/// Maps that are served, or were when their daemon died; in order of their names. Empty where there is no domain.
///
/// Errors: iceoryx2 refuses to be asked.
pub fn list_maps(domain: &Domain) -> Result<Vec<MapStatus>, AttachError> {
    let Ok(entries) = std::fs::read_dir(domain.root()) else { return Ok(Vec::new()) };
    let mut names: Vec<String> = entries
        .flatten()
        .filter_map(|e| {
            Some(e.file_name().to_str()?.strip_suffix(LOCK_ENDING)?.strip_suffix('.')?.to_owned())
        })
        .collect();
    names.sort();
    let mut maps = Vec::new();
    for name in names {
        let alive = File::open(map_lock(domain, &name))
            .is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)));
        if !alive {
            continue;
        }
        let until = Instant::now() + WAIT;
        let subscription = Subscription::connect(domain, &name, until).ok();
        let info = subscription
            .as_ref()
            .and_then(|s| s.wait_newer(0, until).ok())
            .map(|pinned| *pinned.info());
        let subscribers =
            count_subscribers(domain, &name).saturating_sub(usize::from(subscription.is_some()));
        maps.push(MapStatus { name, alive, info, subscribers });
    }
    Ok(maps)
}

fn count_subscribers(domain: &Domain, map: &str) -> usize {
    let count = || {
        let node = NodeBuilder::new()
            .config(&domain.config()?)
            .signal_handling_mode(SignalHandlingMode::Disabled)
            .create::<Ipc>()
            .ok()?;
        let service: PortFactory<Ipc, [Chunk64], GenerationInfo> = node
            .service_builder(&service_name(map, Channel::Archive).ok()?)
            .publish_subscribe::<[Chunk64]>()
            .user_header::<GenerationInfo>()
            .open()
            .ok()?;
        Some(service.dynamic_config().number_of_subscribers())
    };
    count().unwrap_or(0)
}
