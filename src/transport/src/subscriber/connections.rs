//! Queues from publishers, whose names strangers can foresee.
//!
//! A queue is named after its publisher and its subscriber, and iceoryx2 opens whatever has the name. A new publisher's name is seen in `/dev/shm` a moment before it
//! makes its queues: a stranger who is faster would have the subscriber map a file that he can truncate, which ends it by SIGBUS.

use super::attach::{MapService, MapSubscriber};
use crate::domain::{Domain, SHARED_MEMORY_FOLDER};
use crate::error::AttachError;
use crate::user::{not_owned, trusts};
use iceoryx2::prelude::CallbackProgression;
use iceoryx2::service::port_factory::PortFactory as _;
use std::collections::BTreeSet;
use std::path::Path;

/// Hash of the type that a queue holds, which stands in its name after the prefix.
const KIND: &str = "b9fc73e5c1f646968758453273c6c65cb372831b";

/// The publishers whose queues have been looked at.
#[derive(Default)]
pub(super) struct KnownPublishers(BTreeSet<u128>);

impl KnownPublishers {
    /// Looks whose the queues of new publishers are. Under the attach lock, during which a daemon makes none; what its user has made once nobody else can replace.
    ///
    /// Errors: another user has the name of one.
    pub(super) fn check(
        &mut self,
        domain: &Domain,
        service: &MapService,
        subscriber: &MapSubscriber,
    ) -> Result<(), AttachError> {
        let mut listed = BTreeSet::new();
        service.dynamic_config().list_publishers(|publisher| {
            listed.insert(publisher.publisher_id.value());
            CallbackProgression::Continue
        });
        let (us, to) = (rustix::process::geteuid().as_raw(), subscriber.id().value());
        for from in listed.difference(&self.0) {
            let name = format!("{}{KIND}_{from}_{to}.connection", domain.prefix());
            let path = Path::new(SHARED_MEMORY_FOLDER).join(name);
            if let Ok(found) = rustix::fs::lstat(&path)
                && !trusts(us, found.st_uid)
            {
                return Err(not_owned(&path, found.st_uid, us));
            }
        }
        self.0 = listed;
        Ok(())
    }
}
