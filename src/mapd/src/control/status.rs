//! What a daemon says about itself.

use crate::cache::Cache;
use crate::clock::unix_ns;
use crate::serve::HeldGeneration;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::Duration;

/// A daemon and all its maps, at one moment. What `mapd status --json`, logs and metrics are made of.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DaemonStatus {
    /// Version of mapd.
    pub version: String,
    /// Process id, in the daemon's own process namespace.
    pub pid: u32,
    /// Prefix of the domain.
    pub prefix: String,
    /// When it started \[ns since the Unix epoch\].
    pub started_unix_ns: u64,
    /// How long it has been running \[s\], by a clock that nobody sets.
    pub uptime_seconds: f64,
    /// Where compiled archives are kept; `None` without a cache.
    pub cache: Option<CacheStatus>,
    /// Why nobody can subscribe, and only observers are served: what another user has under a name that subscribers need; `None` as a rule.
    #[serde(default)]
    pub without_subscribers: Option<String>,
    /// The maps, by name.
    pub maps: Vec<MapState>,
}

/// The cache of compiled archives.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CacheStatus {
    /// The folder.
    pub folder: PathBuf,
    /// Bytes of archives in it when it was last used.
    pub bytes: u64,
    /// Bytes that it may hold.
    pub limit: u64,
}

impl CacheStatus {
    /// Of a cache, now.
    pub fn of(cache: &Cache) -> Self {
        Self { folder: cache.folder().to_owned(), bytes: cache.bytes(), limit: cache.limit() }
    }
}

/// One map of a daemon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MapState {
    /// Name.
    pub name: String,
    /// The file that it is compiled from.
    pub source: PathBuf,
    /// What is served; `None` until the first publication.
    pub served: Option<GenerationStatus>,
    /// What waits for `mapd activate`.
    pub staged: Option<GenerationStatus>,
    /// Generations before that `mapd rollback` can go back to.
    pub rollbacks: usize,
    /// Subscriptions; `None` where they could not be counted.
    pub subscribers: Option<usize>,
    /// Shared memory of the served and the staged generation \[bytes\]; older ones are in `held`.
    pub memory_bytes: u64,
    /// Generations that are not served any more, and that readers hold, when last looked.
    #[serde(default)]
    pub held: Vec<HeldGeneration>,
    /// What is laid over the map.
    #[serde(default)]
    pub overlay: OverlayStatus,
    /// Whether the source is watched.
    pub watched: bool,
    /// Whether the map is being compiled or published just now.
    pub reloading: bool,
    /// Generations published since the daemon started.
    pub published: u64,
    /// Reloads, rollbacks and activations that failed since the daemon started.
    pub failed: u64,
    /// What became of the last reload, rollback or activation; `None` if there was none since the first publication.
    pub last_reload: Option<ReloadReport>,
    /// Queries that the daemon asks as a client would.
    #[serde(default)]
    pub self_queries: CheckStatus,
    /// Proofs of what is served; see `--scrub`.
    #[serde(default)]
    pub scrubs: CheckStatus,
}

/// What is laid over a map.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct OverlayStatus {
    /// Rises with each change that readers see.
    pub revision: u64,
    /// Entries that are kept.
    pub entries: u64,
    /// Those of them that do not fit the map that is served, and are left out.
    pub unplaced: u64,
    /// Those of which a part is left out.
    pub in_part: u64,
}

/// A generation.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct GenerationStatus {
    /// Its number.
    pub generation: u64,
    /// Length of the archive \[bytes\].
    pub bytes: u64,
    /// When it was published, or staged \[ns since the Unix epoch\].
    pub published_unix_ns: u64,
    /// Hash of the archive's content, of the very bytes that readers see, as hexadecimal digits.
    pub content_hash: String,
    /// Hash of what it was compiled from, as hexadecimal digits.
    pub input_hash: String,
    /// Whether the archive came from the cache.
    pub from_cache: bool,
    /// What it holds.
    pub counts: MapCounts,
}

/// How much a map holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct MapCounts {
    /// Roads.
    pub roads: u64,
    /// Junctions.
    pub junctions: u64,
    /// Lanes, lane 0 not among them.
    pub lanes: u64,
    /// Signals.
    pub signals: u64,
    /// Objects.
    pub objects: u64,
    /// Parts in quarantine.
    pub quarantined: u64,
}

/// What became of a reload, rollback or activation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReloadReport {
    /// What caused it.
    pub trigger: Trigger,
    /// How it ended.
    pub result: ReloadResult,
    /// The generation that it published or staged, or that was served already.
    pub generation: Option<u64>,
    /// Why it ended as it did, where that needs a word.
    pub reason: String,
    /// When it ended \[ns since the Unix epoch\].
    pub at_unix_ns: u64,
    /// How long it took from the request to the end \[s\].
    pub seconds: f64,
}

/// What caused a change of what is served.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Trigger {
    /// The daemon started.
    Start,
    /// SIGHUP.
    Signal,
    /// The source changed.
    Watch,
    /// `mapd reload`.
    Reload,
    /// `mapd rollback`.
    Rollback,
    /// `mapd activate`.
    Activate,
}

/// How a reload, rollback or activation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReloadResult {
    /// A new generation is served.
    Published,
    /// A new generation waits for `mapd activate`.
    Staged,
    /// The archive would be the one that is served: nothing was published.
    Unchanged,
    /// The generation before is still served; the reason says why.
    Failed,
}

/// What came of something that the daemon examines by itself again and again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CheckStatus {
    /// Times that it succeeded.
    pub ok: u64,
    /// Times that it failed.
    pub failures: u64,
    /// Times that it could not be done for want of room, which says nothing of what is examined.
    #[serde(default)]
    pub skipped: u64,
    /// Whether it failed the last time that it was done; `None` before the first.
    pub last_failed: Option<bool>,
    /// How long the last one took that succeeded \[s\].
    pub last_seconds: f64,
    /// When it was last done \[ns since the Unix epoch\].
    pub last_unix_ns: u64,
    /// Why it failed last, or could not be done; empty if that never happened.
    pub last_error: String,
}

impl CheckStatus {
    /// Writes down that it succeeded, and how long it took.
    pub fn succeeded(&mut self, taken: Duration) {
        self.ok += 1;
        self.last_failed = Some(false);
        self.last_seconds = taken.as_secs_f64();
        self.last_unix_ns = unix_ns();
    }

    /// Writes down that it could not be done, and why.
    pub fn skipped(&mut self, error: String) {
        self.skipped += 1;
        self.last_unix_ns = unix_ns();
        self.last_error = error;
    }

    /// Writes down that it failed, and why.
    pub fn failed(&mut self, error: String) {
        self.failures += 1;
        self.last_failed = Some(true);
        self.last_unix_ns = unix_ns();
        self.last_error = error;
    }
}
