//! Dense ids: rows of the archive's tables, bound to one map content.

use std::fmt;

/// The tile of an id: maps are not parts of a larger set yet, so each is its only tile.
pub(crate) const ONLY_TILE: u32 = 0;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => { $(
        $(#[$doc])*
        ///
        /// Dense and cheap, but bound to the content that it came from: a map with other content refuses it, one with the same content
        /// takes it, also in another process. What names the same part in another content is its key (`LaneKey`) or OpenDRIVE's own id.
        #[repr(C)]
        #[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name {
            pub(crate) row: u32,
            pub(crate) tile: u32,
            pub(crate) content: u64,
        }

        impl $name {
            #[inline]
            pub(crate) fn new(row: u32, content: u64) -> Self {
                Self { row, tile: ONLY_TILE, content }
            }

            /// Row in the archive's table.
            pub fn row(self) -> u32 {
                self.row
            }

            /// The id as a plain integer: bits 0 to 63 are the first eight bytes of the content's hash (little-endian), bits 64 to 95
            /// the row, bits 96 to 127 the tile, which is 0.
            pub const fn to_bits(self) -> u128 {
                self.content as u128 | (self.row as u128) << 64 | (self.tile as u128) << 96
            }

            /// The id of [`Self::to_bits`]. Every integer is an id; a map answers one that it has not handed out with
            /// [`QueryError::ForeignId`](crate::QueryError::ForeignId), or [`QueryError::Corrupt`](crate::QueryError::Corrupt) if
            /// only the row does not exist; one whose row is `u32::MAX` names nothing: [`QueryError::NoId`](crate::QueryError::NoId).
            pub const fn from_bits(bits: u128) -> Self {
                Self { row: (bits >> 64) as u32, tile: (bits >> 96) as u32, content: bits as u64 }
            }
        }

        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            /// As the 32 hexadecimal digits of [`Self::to_bits`]: few languages have integers of 128 bits.
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                to.collect_str(&format_args!("{:032x}", self.to_bits()))
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let digits = String::deserialize(from)?;
                let bits = u128::from_str_radix(&digits, 16).map_err(|_| {
                    serde::de::Error::custom(format_args!("expected the digits of an id, found {digits:?}"))
                })?;
                Ok(Self::from_bits(bits))
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
