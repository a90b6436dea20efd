//! What signs say of right of way, the same for a junction and outside of one.

use mapd_archive::{Class, Relation, RelationReason};

/// The sign by which traffic comes to a place where it meets other traffic, the weakest right first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum EntrySign {
    /// A stop sign.
    Stop,
    /// A sign to give way.
    Yield,
    /// None of these.
    None,
    /// A sign of priority.
    Priority,
}

impl EntrySign {
    /// What a sign of a class is.
    pub fn of(class: Class) -> Self {
        match class {
            Class::Stop => Self::Stop,
            Class::Yield => Self::Yield,
            Class::PriorityRoad | Class::PriorityAtNextJunction => Self::Priority,
            _ => Self::None,
        }
    }

    /// What several signs come to: the one that takes most counts, a priority sign only where none takes any.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::None, one) | (one, Self::None) => one,
            (a, b) => a.min(b),
        }
    }

    /// Who goes first, of two who come by these signs; none where they are the same.
    pub fn against(self, other: Self) -> Option<(Relation, RelationReason)> {
        let reason = match self.min(other) {
            _ if self == other => return None,
            Self::Stop => RelationReason::StopSign,
            Self::Yield => RelationReason::YieldSign,
            Self::None | Self::Priority => RelationReason::PriorityRoad,
        };
        let relation = if self < other { Relation::Yields } else { Relation::Priority };
        Some((relation, reason))
    }
}
