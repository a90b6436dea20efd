//! Names and sizes that daemon and clients must agree on.
//!
//! iceoryx2 freezes a service's limits while any process has it open, so they are constants of a transport revision:
//! a change of one raises [`TRANSPORT_REVISION`], which gives the services new names.

use crate::error::AttachError;

/// Revision of everything that both sides must agree on: limits, user header, records, lock protocol. Part of
/// service names.
pub const TRANSPORT_REVISION: u32 = 4;

/// Subscriptions that clients of one map can have at a time.
pub const MAX_SUBSCRIBERS: usize = 64;

/// Subscriptions that one map can have in all: beyond those of clients some for daemons, which look at what they serve, and
/// for clients that come at one moment.
pub const MAX_SUBSCRIPTIONS: usize = MAX_SUBSCRIBERS + 8;

/// Nodes that can have one map open at a time: one per subscription and per daemon, and room for killed ones that the
/// daemon has not cleaned up yet (it does so about once a second).
pub const MAX_NODES: usize = 96;

/// Publishers of one map at a time: the served generation, the next one, and one of a killed daemon not yet cleaned up.
pub const MAX_PUBLISHERS: usize = 3;

/// Samples that a late joiner receives: the served generation.
pub const HISTORY: usize = 1;

/// Undelivered samples per subscription and publisher: each publisher sends only one.
pub const SUBSCRIBER_BUFFER: usize = 1;

/// Samples that a subscription can hold per publisher. Old and new generation come from different publishers, so both can
/// be held.
pub const SUBSCRIBER_BORROWED: usize = 1;

/// Generations that one subscription can keep pinned at a time. iceoryx2 must know it beforehand and aborts when it is
/// exceeded, so a subscription refuses to receive more.
pub const MAX_PINNED: usize = 16;

/// Ports on the seldom-used side of each event service (daemons), with room for killed ones.
pub const MAX_EVENT_DAEMONS: usize = 4;

/// Longest map name in bytes.
pub const MAX_MAP_NAME_LENGTH: usize = 100;

/// Name of a daemon's nodes, by which they are told from those of clients; process ids do not, for containers have their own.
pub const DAEMON_NODE: &str = "mapd";

/// Name of the publish-subscribe service of a map.
pub fn service_name(map: &str) -> String {
    format!("mapd/{map}/{TRANSPORT_REVISION}")
}

/// Name of the event service by which a client tells the daemon that it has arrived: history is delivered only when the
/// publisher looks.
pub fn wake_name(map: &str) -> String {
    format!("mapd/{map}/{TRANSPORT_REVISION}/wake")
}

/// Name of the event service by which the daemon tells clients of a new generation.
pub fn changed_name(map: &str) -> String {
    format!("mapd/{map}/{TRANSPORT_REVISION}/changed")
}

/// Checks a map name: 1 to [`MAX_MAP_NAME_LENGTH`] ASCII letters, digits, `.`, `_`, `-`, the first a letter, digit or `_`.
/// The name is part of file and service names.
///
/// Errors: [`AttachError::MapName`].
pub fn check_map_name(map: &str) -> Result<(), AttachError> {
    let allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-');
    let starts_well = !map.starts_with(['.', '-']);
    if !map.is_empty()
        && map.len() <= MAX_MAP_NAME_LENGTH
        && starts_well
        && map.chars().all(allowed)
    {
        Ok(())
    } else {
        Err(AttachError::MapName { map: map.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn map_names() {
        let longest = "m".repeat(MAX_MAP_NAME_LENGTH);
        for good in ["town", "Town01", "a.b-c_d", "_x", "7", longest.as_str()] {
            assert!(check_map_name(good).is_ok(), "{good}");
        }
        let long = "m".repeat(MAX_MAP_NAME_LENGTH + 1);
        for bad in ["", ".attach", "-x", "a/b", "a b", "stra\u{df}e", "..", "a\0", long.as_str()] {
            assert!(check_map_name(bad).is_err(), "{bad}");
        }
    }

    #[cfg(feature = "iceoryx2")]
    #[test]
    fn the_longest_names_fit_iceoryx2() {
        let map = "m".repeat(MAX_MAP_NAME_LENGTH);
        for name in [service_name(&map), wake_name(&map), changed_name(&map)] {
            assert!(iceoryx2::prelude::ServiceName::new(&name).is_ok(), "{name}");
        }
    }
}
