//! `mapd status`.

use crate::report::hex;
use anyhow::Result;
use mapd_client::Domain;
use mapd_client::transport::{MapStatus, list_maps};
use serde::Serialize;
use std::io::Write;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

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
    subscribers: usize,
    published_unix_ns: Option<u64>,
}

impl From<MapStatus> for Status {
    fn from(map: MapStatus) -> Self {
        let info = map.info;
        Self {
            name: map.name,
            alive: map.alive,
            pid: info.map(|i| i.daemon_pid),
            generation: info.map(|i| i.generation),
            bytes: info.map(|i| i.length),
            layout_id: info.map(|i| hex(&i.layout_id[..16])),
            content_hash: info.map(|i| hex(&i.content_hash)),
            input_hash: info.map(|i| hex(&i.input_hash)),
            subscribers: map.subscribers,
            published_unix_ns: info.map(|i| i.published_unix_ns),
        }
    }
}

/// Lists the maps of a domain.
pub(crate) fn run(domain: &Domain, json: bool, out: &mut dyn Write) -> Result<()> {
    let maps: Vec<Status> = list_maps(domain)?.into_iter().map(Status::from).collect();
    if json {
        serde_json::to_writer_pretty(&mut *out, &maps)?;
        writeln!(out)?;
        return Ok(());
    }
    if maps.is_empty() {
        writeln!(out, "no maps are served (prefix {})", domain.prefix())?;
        return Ok(());
    }
    let head = ("map", "generation", "bytes", "readers", "since", "content");
    writeln!(
        out,
        "{:<20} {:>10} {:>12} {:>8} {:>10}  {}",
        head.0, head.1, head.2, head.3, head.4, head.5
    )?;
    for map in maps {
        let number = |n: Option<u64>| n.map(|n| n.to_string()).unwrap_or_else(|| "-".to_owned());
        let content =
            map.content_hash.map(|hash| hash[..16].to_owned()).unwrap_or_else(|| "-".to_owned());
        let since = if map.alive { age(map.published_unix_ns) } else { "no daemon".to_owned() };
        writeln!(
            out,
            "{:<20} {:>10} {:>12} {:>8} {:>10}  {content}",
            map.name,
            number(map.generation),
            number(map.bytes),
            map.subscribers,
            since
        )?;
    }
    Ok(())
}

/// How long ago something was published.
fn age(published_unix_ns: Option<u64>) -> String {
    let Some(published) = published_unix_ns else { return "-".to_owned() };
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    let seconds = now.saturating_sub(Duration::from_nanos(published)).as_secs();
    match seconds {
        0..120 => format!("{seconds} s"),
        120..7200 => format!("{} min", seconds / 60),
        _ => format!("{} h", seconds / 3600),
    }
}
