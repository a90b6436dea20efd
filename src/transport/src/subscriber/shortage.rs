//! Whether there is what a subscriber needs.

use crate::error::AttachError;
use crate::room::{ATTACH_DESCRIPTORS, ATTACH_ROOM, Descriptors, descriptors, free_bytes};

/// Those of them that are needed last, to receive a generation.
pub(crate) const RECEIVE_DESCRIPTORS: u64 = 4;

/// Checks that there is [`ATTACH_ROOM`].
///
/// Errors: [`AttachError::NoRoom`].
pub(crate) fn check_room() -> Result<(), AttachError> {
    match free_bytes() {
        Some(available) if available < ATTACH_ROOM => Err(AttachError::NoRoom { available }),
        _ => Ok(()),
    }
}

/// Checks that there are so many. Looks at each descriptor, so it is for callers that have failed already.
///
/// Errors: [`AttachError::NoDescriptors`].
pub(crate) fn check_descriptors(needed: u64) -> Result<(), AttachError> {
    match descriptors() {
        Some(Descriptors { left, limit }) if left < needed => {
            Err(AttachError::NoDescriptors { left, limit })
        }
        _ => Ok(()),
    }
}

impl AttachError {
    pub(crate) fn iceoryx(error: impl std::fmt::Debug) -> Self {
        Self::Iceoryx(format!("{error:?}"))
    }

    /// The same, or what there is too little of, if there is: whatever failed, failed for that.
    pub(crate) fn or_shortage(self) -> Self {
        match self {
            Self::Iceoryx(_) | Self::Io { .. } => check_room()
                .and_then(|()| check_descriptors(ATTACH_DESCRIPTORS))
                .err()
                .unwrap_or(self),
            other => other,
        }
    }
}
