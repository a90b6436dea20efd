//! `--trust KEY`: only archives that are signed by this key.

use anyhow::Result;
use clap::Args;
use mapd_client::TrustedKey;
use std::path::PathBuf;

/// Trusted keys.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct TrustArgs {
    /// Accept only archives signed with this minisign key; the signature is in FILE.mapd.minisig
    #[arg(long, value_name = "KEY.pub")]
    trust: Option<PathBuf>,
}

impl TrustArgs {
    /// This key, or if none is named, that of the configuration file.
    pub(crate) fn or(self, file: Option<&PathBuf>) -> Self {
        Self { trust: self.trust.or_else(|| file.cloned()) }
    }

    /// The key, if one is named.
    ///
    /// Errors: it cannot be read.
    pub(crate) fn key(&self) -> Result<Option<TrustedKey>> {
        Ok(self.trust.as_ref().map(TrustedKey::open).transpose()?)
    }
}
