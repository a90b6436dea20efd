//! A daemon's status as Prometheus reads it.

use crate::control::{CheckStatus, DaemonStatus, MapState, ReloadResult};
use mapd_transport::free_bytes;
use prometheus_client::encoding::{EncodeLabelSet, text::encode};
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::info::Info;
use prometheus_client::registry::Registry;
use std::sync::atomic::AtomicU64;

#[derive(Clone, Debug, Hash, PartialEq, Eq, EncodeLabelSet)]
struct OfMap {
    map: String,
}

#[derive(Clone, Debug, Hash, PartialEq, Eq, EncodeLabelSet)]
struct OfCheck {
    map: String,
    check: &'static str,
    result: &'static str,
}

#[derive(Clone, Debug, Hash, PartialEq, Eq, EncodeLabelSet)]
struct Build {
    version: String,
    prefix: String,
}

type Value = fn(&MapState) -> Option<f64>;

/// What goes up and down, for each map; left out where there is nothing to tell.
const GAUGES: [(&str, &str, Value); 16] = [
    ("generation", "Generation that is served", |m| Some(m.served.as_ref()?.generation as f64)),
    ("staged_generation", "Generation that waits to be activated", |m| {
        Some(m.staged.as_ref()?.generation as f64)
    }),
    ("archive_bytes", "Length of the served archive", |m| Some(m.served.as_ref()?.bytes as f64)),
    ("memory_bytes", "Shared memory of the served and the staged generation", |m| {
        Some(m.memory_bytes as f64)
    }),
    ("published_timestamp_seconds", "When the served generation was published, since 1970", |m| {
        Some(m.served.as_ref()?.published_unix_ns as f64 / 1e9)
    }),
    ("clients", "Subscriptions", |m| Some(m.subscribers? as f64)),
    ("held_generations", "Generations before that readers hold", |m| Some(m.held.len() as f64)),
    ("held_bytes", "Shared memory of generations before that readers hold", |m| {
        Some(m.held.iter().map(|held| held.bytes).sum::<u64>() as f64)
    }),
    ("overlay_revision", "Revision of what is laid over the map", |m| {
        Some(m.overlay.revision as f64)
    }),
    ("overlay_entries", "Entries of what is laid over the map", |m| Some(m.overlay.entries as f64)),
    ("overlay_unplaced", "Entries that do not fit the served map, or not all of them", |m| {
        Some((m.overlay.unplaced + m.overlay.in_part) as f64)
    }),
    ("lanes", "Lanes of the served map", |m| Some(m.served.as_ref()?.counts.lanes as f64)),
    ("quarantined_parts", "Parts that are left out of the served map", |m| {
        Some(m.served.as_ref()?.counts.quarantined as f64)
    }),
    ("reloading", "1 while the map is compiled or published", |m| Some(f64::from(m.reloading))),
    ("last_reload_ok", "0 if the last reload, rollback or activation failed, else 1", |m| {
        Some(f64::from(m.last_reload.as_ref()?.result != ReloadResult::Failed))
    }),
    ("last_reload_seconds", "How long the last reload, rollback or activation took", |m| {
        Some(m.last_reload.as_ref()?.seconds)
    }),
];

type Count = fn(&MapState) -> u64;

/// What only rises, for each map.
const COUNTERS: [(&str, &str, Count); 2] = [
    ("publications", "Generations published since the daemon started", |m| m.published),
    ("reload_failures", "Reloads, rollbacks and activations that failed", |m| m.failed),
];

type Check = fn(&MapState) -> &CheckStatus;

/// What the daemon examines by itself.
const CHECKS: [(&str, Check); 2] = [("self_query", |m| &m.self_queries), ("scrub", |m| &m.scrubs)];

/// The page that Prometheus reads, in OpenMetrics' text format.
///
/// Errors: none in practice; the text cannot be written.
pub(crate) fn text(status: &DaemonStatus) -> Result<String, std::fmt::Error> {
    let mut registry = Registry::with_prefix("mapd");
    let build = Build { version: status.version.clone(), prefix: status.prefix.clone() };
    registry.register("build", "Version, and prefix of the domain", Info::new(build));
    let alone = |registry: &mut Registry, name: &str, help: &str, value: f64| {
        let gauge = Gauge::<f64, AtomicU64>::default();
        gauge.set(value);
        registry.register(name, help, gauge);
    };
    alone(&mut registry, "uptime_seconds", "Time since the daemon started", status.uptime_seconds);
    alone(
        &mut registry,
        "serves_subscribers",
        "0 while another user holds a name that subscribers need, else 1",
        f64::from(status.without_subscribers.is_none()),
    );
    if let Some(free) = free_bytes() {
        alone(
            &mut registry,
            "shared_memory_free_bytes",
            "Room that is left in /dev/shm",
            free as f64,
        );
    }
    if let Some(cache) = &status.cache {
        alone(&mut registry, "cache_bytes", "Archives in the cache", cache.bytes as f64);
        alone(&mut registry, "cache_limit_bytes", "What the cache may hold", cache.limit as f64);
    }
    let of = |map: &MapState| OfMap { map: map.name.clone() };
    for (name, help, value) in GAUGES {
        let family = Family::<OfMap, Gauge<f64, AtomicU64>>::default();
        for map in &status.maps {
            if let Some(value) = value(map) {
                family.get_or_create(&of(map)).set(value);
            }
        }
        registry.register(format!("map_{name}"), help, family);
    }
    for (name, help, count) in COUNTERS {
        let family = Family::<OfMap, Counter>::default();
        for map in &status.maps {
            family.get_or_create(&of(map)).inc_by(count(map));
        }
        registry.register(format!("map_{name}"), help, family);
    }
    let counts = Family::<OfCheck, Counter>::default();
    let seconds = Family::<OfCheck, Gauge<f64, AtomicU64>>::default();
    for map in &status.maps {
        for (check, state) in CHECKS {
            let state = state(map);
            let of = |result| OfCheck { map: map.name.clone(), check, result };
            counts.get_or_create(&of("ok")).inc_by(state.ok);
            counts.get_or_create(&of("failed")).inc_by(state.failures);
            counts.get_or_create(&of("skipped")).inc_by(state.skipped);
            if state.ok > 0 {
                seconds.get_or_create(&of("ok")).set(state.last_seconds);
            }
        }
    }
    registry.register("checks", "Self-queries, and verifications of the served archives", counts);
    registry.register("check_seconds", "How long the last one took that succeeded", seconds);
    let mut out = String::new();
    encode(&mut out, &registry)?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::GenerationStatus;
    use std::time::Duration;

    #[test]
    fn every_line_is_a_metric_and_names_are_escaped() {
        let served = GenerationStatus { generation: 7, bytes: 100, ..GenerationStatus::default() };
        let (name, subscribers) = ("a".into(), Some(2));
        let mut map = MapState { name, served: Some(served), subscribers, ..MapState::default() };
        map.scrubs.succeeded(Duration::from_millis(250));
        map.scrubs.failed("bad".into());
        let status = DaemonStatus { maps: vec![map], ..DaemonStatus::default() };
        let text = text(&status).expect("a text");
        for line in [
            "mapd_map_generation{map=\"a\"} 7.0",
            "mapd_map_publications_total{map=\"a\"} 0",
            "mapd_checks_total{map=\"a\",check=\"scrub\",result=\"ok\"} 1",
            "mapd_checks_total{map=\"a\",check=\"scrub\",result=\"failed\"} 1",
            "mapd_check_seconds{map=\"a\",check=\"scrub\",result=\"ok\"} 0.25",
            "mapd_map_clients{map=\"a\"} 2.0",
            "mapd_serves_subscribers 1.0",
            "# EOF",
        ] {
            assert!(text.lines().any(|l| l == line), "{line} is missing in\n{text}");
        }
        assert!(!text.contains("staged_generation{"), "nothing is staged:\n{text}");
    }
}
