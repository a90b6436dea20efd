//! Where daemons and clients meet.

use crate::exit::UsageError;
use anyhow::Result;
use clap::Args;
use mapd_client::Domain;

/// Where daemons and clients meet.
#[derive(Args)]
pub(crate) struct DomainArgs {
    /// Prefix of everything in shared memory; daemons and clients meet where it is equal (letters and digits, one _ at the end) [default: mapd_]
    #[arg(long, env = "MAPD_PREFIX", value_name = "PREFIX")]
    prefix: Option<String>,
}

impl DomainArgs {
    /// The domain, if one is named.
    ///
    /// Errors: as [`DomainArgs::domain`].
    pub(crate) fn named(&self) -> Result<Option<Domain>> {
        self.prefix.is_some().then(|| self.domain()).transpose()
    }

    /// The domain: this one, or that of the environment.
    ///
    /// Errors: it cannot be a prefix.
    pub(crate) fn domain(&self) -> Result<Domain> {
        let domain = match &self.prefix {
            Some(prefix) => Domain::new(prefix),
            None => Domain::from_env(),
        };
        domain.map_err(|error| UsageError(error.to_string()).into())
    }
}
