//! What a daemon is to do.

use super::child::Means;
use super::overlays::OverlayRules;
use super::proposals::ProposalPolicy;
use crate::args::CompileArguments;
use crate::cache::Cache;
use crate::oversight::OversightSettings;
use mapd_client::Domain;
use mapd_transport::Share;
use std::path::PathBuf;

/// What a daemon is to do.
#[derive(Debug)]
pub(crate) struct Settings {
    pub(crate) domain: Domain,
    /// Where archives are kept.
    pub(crate) cache: Option<Cache>,
    /// What compiling may take.
    pub(crate) means: Means,
    /// The key whose archives alone are served, as the configuration file says.
    pub(crate) trust: Option<PathBuf>,
    /// Oversight, as the configuration file says.
    pub(crate) oversight: OversightSettings,
    /// Whether what is served is kept from swap.
    pub(crate) lock_memory: bool,
    /// Who may read what is served.
    pub(crate) share: Share,
    /// What may be laid over maps.
    pub(crate) overlay: OverlayRules,
    /// The policy for proposals; none: no proposal is accepted.
    pub(crate) proposals: Option<ProposalPolicy>,
    pub(crate) maps: Vec<MapSettings>,
}

/// What is to be done with a map.
#[derive(Clone, Debug)]
pub(crate) struct MapSettings {
    pub(crate) name: String,
    /// The file that it comes from: OpenDRIVE or an archive.
    pub(crate) source: PathBuf,
    pub(crate) options: CompileArguments,
    /// Reload it whenever its files change.
    pub(crate) watch: bool,
    /// Reloads by signal and watch are staged.
    pub(crate) stage: bool,
    /// At the start, serve what was served last if the file yields no map.
    pub(crate) last_good: bool,
    /// Largest archive \[bytes\].
    pub(crate) max_bytes: Option<u64>,
}
