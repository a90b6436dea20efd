//! The wall clock. Only for what people and other machines read: deadlines use one that does not jump.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Time since the Unix epoch; none for a clock that stands before it.
pub(crate) fn since_epoch() -> Duration {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
}

/// Now \[ns since the Unix epoch\]; the largest number after the year 2554.
pub(crate) fn unix_ns() -> u64 {
    u64::try_from(since_epoch().as_nanos()).unwrap_or(u64::MAX)
}
