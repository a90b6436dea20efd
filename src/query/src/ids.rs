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

            /// The whole id as a number, for programs in other languages of the same process.
            pub fn to_bits(self) -> u64 {
                u64::from(self.row) | u64::from(self.content) << 32
            }

            /// The id of [`Self::to_bits`]. Any number is one: a map refuses what it has not handed out, as an id of other content
            /// or of no row.
            pub fn from_bits(bits: u64) -> Self {
                Self { row: bits as u32, content: (bits >> 32) as u32 }
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
