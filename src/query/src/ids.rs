//! Dense ids: rows of the archive's tables, valid for one map content.

use std::fmt;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => { $(
        $(#[$doc])*
        ///
        /// Dense and cheap, but bound to the content it came from: a map with other content refuses it. What may leave
        /// a process is a name (`LaneKey`, OpenDRIVE's own ids).
        #[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name {
            pub(crate) row: u32,
            pub(crate) content: u32,
        }

        impl $name {
            /// Row in the archive's table.
            pub fn row(self) -> u32 {
                self.row
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{}({})", stringify!($name), self.row)
            }
        }
    )* };
}

ids! {
    /// A road.
    RoadId;
    /// A lane section.
    LaneSectionId;
    /// A lane of a section.
    LaneId;
    /// A junction.
    JunctionId;
    /// A node of the lane graph.
    NodeId;
    /// A signal.
    SignalId;
    /// A controller.
    ControllerId;
    /// An object.
    ObjectId;
}
