//! A daemon's arguments, and what they and the configuration file make together.

use super::child::Means;
use super::config::Configuration;
use super::log::say;
use super::overlays::OverlayRules;
use super::proposals::ProposalPolicy;
use super::settings::{MapSettings, Settings};
use super::sources;
use crate::args::CompileArguments;
use crate::args::ThreadsArg;
use crate::args::{ShareWith, Size};
use crate::cache::{self, Cache};
use crate::exit::{UsageError, explained};
use crate::source;
use anyhow::{Context, Result, bail};
use clap::Args;
use mapd_client::{Domain, TrustedKey};
use mapd_overlay::{Limits, Policy};
use mapd_transport::{Share, check_map_name};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Longest document of overlay entries that a daemon can be told to take \[bytes\]: as text in a request it is up to three times as long.
const LONGEST_OVERLAY: u64 = 5 << 20;

/// What a daemon is to do.
#[derive(Args)]
pub(crate) struct DaemonArgs {
    /// Serve a map, or every map of a folder; may be repeated
    ///
    /// Maps are .xodr, .xodrz and .mapd files.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub(crate) load: Vec<PathBuf>,

    /// Name of the served map [default: the file's stem]
    #[arg(long, requires = "load")]
    name: Option<String>,

    /// Settings and maps to serve (docs/service.md)
    ///
    /// Command-line arguments override it.
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) config: Option<PathBuf>,

    /// Reload a map whenever its file changes
    #[arg(long)]
    watch: bool,

    /// Leave reloads by SIGHUP and --watch pending, for `mapd activate`
    #[arg(long)]
    stage: bool,

    /// If a file cannot be compiled at the start, serve the map that was served last, from the cache
    #[arg(long)]
    last_good: bool,

    /// Folder for compiled archives and generation numbers [default: $XDG_CACHE_HOME/mapd or ~/.cache/mapd, for root /var/cache/mapd]
    #[arg(long, env = "MAPD_CACHE", hide_env_values = true, value_name = "DIR")]
    cache: Option<PathBuf>,

    /// Keep no archives; this disables `mapd rollback`
    #[arg(long)]
    no_cache: bool,

    /// Largest size of the cache, such as 4GiB [default: 4GiB]
    #[arg(long, value_name = "SIZE")]
    cache_size: Option<Size>,

    /// Memory limit for compiling, such as 8GiB [default: three quarters of what is free]
    #[arg(long, visible_alias = "max-memory", value_name = "SIZE")]
    compile_memory: Option<Size>,

    #[command(flatten)]
    threads: ThreadsArg,

    /// Let overlays allow more than the map: open lanes, raise speed limits (docs/overlay.md)
    #[arg(long)]
    overlay_may_loosen: bool,

    /// Most entries of an overlay [default: 10000]
    #[arg(long, value_name = "N")]
    overlay_entries: Option<usize>,

    /// Longest document of overlay entries, at most 5MiB [default: 4MiB]
    #[arg(long, value_name = "SIZE")]
    overlay_bytes: Option<Size>,

    /// Take entries of overlays that processes on board propose, as this policy allows (docs/overlay.md) [default: none]
    #[arg(long, value_name = "FILE")]
    overlay_from: Option<PathBuf>,

    /// Take only entries of overlays that are signed with this minisign key; the signature is in FILE.minisig (docs/overlay.md)
    #[arg(long, value_name = "KEY.pub")]
    overlay_trust: Option<PathBuf>,

    /// Keep served maps in memory, never in swap; the limit of locked memory (ulimit -l) must allow twice the largest map
    #[arg(long)]
    lock_memory: bool,

    /// Let members of this group read what is served, as observers (--owner); nobody else writes anything [default: private]
    #[arg(long, value_name = "group:NAME")]
    share: Option<ShareWith>,
}

/// Whether a map may have this name beside those that others have already.
///
/// Errors: it is no name, or another map has it.
pub(crate) fn check_name(name: &str, taken: &mut BTreeSet<String>) -> Result<(), UsageError> {
    check_map_name(name).map_err(|error| UsageError(error.to_string()))?;
    if taken.insert(name.to_owned()) {
        return Ok(());
    }
    Err(UsageError(format!(
        "two maps would be named {name}; give one another name (of a folder's maps, list the files one by one), or serve it from a daemon of its own with --name"
    )))
}

impl DaemonArgs {
    /// Whether there is anything to serve.
    pub(crate) fn is_wanted(&self) -> bool {
        !self.load.is_empty() || self.config.is_some()
    }

    /// All settings. `options` are those of the command line, `domain` is its domain if it says one.
    ///
    /// Errors: wrong usage; files that cannot be read; two maps of one name.
    pub(crate) fn settings(
        &self,
        options: &CompileArguments,
        domain: Option<Domain>,
    ) -> Result<Settings> {
        let mut file = match &self.config {
            Some(path) => {
                Configuration::read(path).map_err(|error| UsageError(format!("{error:#}")))?
            }
            None => Configuration::default(),
        };
        let domain = match (domain, file.domain.take()) {
            (Some(domain), _) | (None, Some(domain)) => domain,
            (None, None) => Domain::from_env().map_err(|error| UsageError(error.to_string()))?,
        };
        let mut maps = Vec::new();
        for mut map in std::mem::take(&mut file.maps) {
            map.options = options.or(&map.options);
            map.watch |= self.watch;
            map.stage |= self.stage;
            map.last_good |= self.last_good;
            maps.push(map);
        }
        let files = sources::expand(&self.load)?;
        if self.name.is_some() && files.len() != 1 {
            bail!(UsageError(format!("--name goes with one map, found {}", files.len())));
        }
        for source in files {
            maps.push(MapSettings {
                name: match &self.name {
                    Some(name) => name.clone(),
                    None => sources::stem(&source)?,
                },
                source,
                options: options.or(&file.options),
                watch: self.watch || file.watch,
                stage: self.stage || file.stage,
                last_good: self.last_good || file.last_good,
                max_bytes: None,
            });
        }
        let mut names = BTreeSet::new();
        for map in &maps {
            let place = |error| UsageError(format!("{}: {error}", map.source.display()));
            check_name(&map.name, &mut names).map_err(place)?;
            if source::is_archive(&map.source)
                && let Some(option) = map.options.shaping()
            {
                bail!(UsageError(format!(
                    "map {}: {option} holds when a map is compiled; {} keeps what it was compiled with",
                    map.name,
                    map.source.display()
                )));
            }
            // What makes no sense is wrong usage now, and not a reload that fails later.
            let wrong = |error: anyhow::Error| UsageError(format!("map {}: {error:#}", map.name));
            map.options.parse().map_err(wrong)?;
        }
        if maps.is_empty() {
            bail!(UsageError(
                "there is no map to serve: name one with --load or in the configuration".into()
            ));
        }
        let means = Means {
            memory: self.compile_memory.or(file.compile_memory).map(|size| size.0),
            threads: self.threads.get().or(file.threads),
        };
        if self.is_without_cache(&file) {
            let map = maps.iter().find(|map| map.last_good);
            let last_good = map.map(|map| format!("map {}: --last-good", map.name));
            let size = self.cache_size.map(|_| "--cache-size".to_owned());
            if let Some(option) = last_good.or(size) {
                bail!(UsageError(format!("{option} needs the cache, which --no-cache turns off")));
            }
        }
        let cache = self.cache(&file)?;
        let lock_memory = self.lock_memory || file.lock_memory;
        let share = self.share.or(file.share).map_or(Share::Private, |with| with.0);
        let overlay = self.overlay(&file)?;
        let policy = self.overlay_from.as_ref().or(file.overlay_from.as_ref());
        let read = |path: &PathBuf| ProposalPolicy::read(path, &domain);
        let proposals = policy.map(read).transpose();
        let proposals = proposals.map_err(|error| UsageError(explained(&error)))?;
        let (trust, oversight) = (file.trust, file.oversight);
        Ok(Settings {
            domain,
            cache,
            means,
            trust,
            oversight,
            lock_memory,
            share,
            overlay,
            proposals,
            maps,
        })
    }

    fn overlay(&self, file: &Configuration) -> Result<OverlayRules> {
        let default = Limits::default();
        let bytes = self.overlay_bytes.or(file.overlay_bytes).map_or(default.bytes as u64, |s| s.0);
        if bytes > LONGEST_OVERLAY {
            bail!(UsageError(format!(
                "--overlay-bytes: expected at most {}",
                Size(LONGEST_OVERLAY)
            )));
        }
        let entries = self.overlay_entries.or(file.overlay_entries).unwrap_or(default.entries);
        let may_loosen = self.overlay_may_loosen || file.overlay_may_loosen;
        let limits = Limits { entries, bytes: bytes as usize };
        let trust = self.overlay_trust.as_ref().or(file.overlay_trust.as_ref());
        let trust = trust.map(TrustedKey::open).transpose()?;
        Ok(OverlayRules { limits, policy: Policy { may_loosen }, trust })
    }

    /// Whether the cache is turned off: on the command line, or in a configuration that the command line does not contradict.
    fn is_without_cache(&self, file: &Configuration) -> bool {
        self.no_cache || (file.no_cache && self.cache.is_none())
    }

    /// The cache. One that was asked for must be readable; the default one is done without if it is not.
    fn cache(&self, file: &Configuration) -> Result<Option<Cache>> {
        if self.is_without_cache(file) {
            return Ok(None);
        }
        let limit = self.cache_size.or(file.cache_size).map_or(cache::DEFAULT_LIMIT, |size| size.0);
        let named = self.cache.as_ref().or(file.cache.as_ref());
        let Some(folder) = named.cloned().or_else(Cache::default_folder) else { return Ok(None) };
        match Cache::open(&folder, limit) {
            Ok(cache) => {
                // Now, and not when a map has been compiled.
                if let Err(error) = cache.check_writable() {
                    let folder = folder.display();
                    tracing::warn!(%error, "cache {folder}: {error}; the archives in it are served, and nothing is added");
                }
                Ok(Some(cache))
            }
            Err(error) if named.is_none() => {
                say(&format!("continuing without a cache: {}: {error}", folder.display()));
                Ok(None)
            }
            Err(error) => Err(error).with_context(|| format!("cache {}", folder.display())),
        }
    }
}
