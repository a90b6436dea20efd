//! Where daemons and clients meet.

use crate::exit::UsageError;
use anyhow::Result;
use clap::Args;
use mapd_client::Domain;

/// Where daemons and clients meet.
#[derive(Args)]
pub(crate) struct DomainArgs {
    /// Prefix of all names in shared memory [default: mapd_]
    ///
    /// Daemon and clients need the same one: letters and digits, one _ at the end.
    #[arg(long, env = "MAPD_PREFIX", hide_env_values = true, value_name = "PREFIX")]
    prefix: Option<String>,

    /// Trust the daemon of this user, by name or number; it has to share (--share) [default: this process's user]
    #[arg(long, env = "MAPD_OWNER", hide_env_values = true, value_name = "USER")]
    owner: Option<String>,
}

impl DomainArgs {
    /// The domain, if one is named.
    ///
    /// Errors: as [`DomainArgs::domain`].
    pub(crate) fn named(&self) -> Result<Option<Domain>> {
        (self.prefix.is_some() || self.owner.is_some()).then(|| self.domain()).transpose()
    }

    /// The domain: this one, or that of the environment.
    ///
    /// Errors: it cannot be a prefix; there is no such owner.
    pub(crate) fn domain(&self) -> Result<Domain> {
        let domain = match &self.prefix {
            Some(prefix) => Domain::new(prefix),
            None => Domain::from_env(),
        };
        let domain = domain.and_then(|domain| match &self.owner {
            Some(owner) => domain.owned_by(owner),
            None => Ok(domain),
        });
        domain.map_err(|error| UsageError(error.to_string()).into())
    }
}
