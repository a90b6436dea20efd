//! Ids: dense numbers bound to one map content.

use mapd_client::{JunctionId, LaneId, NodeId, ObjectId, RoadId, SignalId};

/// Row of an id that names nothing.
pub const MAPD_NO_ROW: u32 = u32::MAX;

/// A road. Bound to the map content that it came from, and refused by any other; a row of `MAPD_NO_ROW` names nothing.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_road_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

/// A lane of a section; as `mapd_road_id` otherwise. What may leave the process is the lane's key: `mapd_lane_key`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_lane_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

/// A junction; as `mapd_road_id` otherwise.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_junction_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

/// A node of the lane graph: a lane, or a piece of one, travelled in one direction; as `mapd_road_id` otherwise.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_node_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

/// A signal; as `mapd_road_id` otherwise.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_signal_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

/// An object; as `mapd_road_id` otherwise.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct mapd_object_id {
    /// Row in the archive's table.
    pub row: u32,
    /// The tile of a set of maps: 0.
    pub tile: u32,
    /// First eight bytes of the content's hash.
    pub content: u64,
}

macro_rules! ids {
    ($($c:ident $rust:ident;)*) => { $(
        impl $c {
            pub(crate) const NONE: Self = Self { row: MAPD_NO_ROW, tile: 0, content: 0 };
        }

        impl From<$rust> for $c {
            #[inline]
            fn from(id: $rust) -> Self {
                let bits = id.to_bits();
                Self { row: id.row(), tile: (bits >> 96) as u32, content: bits as u64 }
            }
        }

        impl From<Option<$rust>> for $c {
            #[inline]
            fn from(id: Option<$rust>) -> Self {
                id.map_or(Self::NONE, Self::from)
            }
        }

        impl From<$c> for $rust {
            #[inline]
            fn from(id: $c) -> Self {
                let row = u128::from(id.row) << 64 | u128::from(id.tile) << 96;
                Self::from_bits(row | u128::from(id.content))
            }
        }
    )* };
}

ids! {
    mapd_road_id RoadId;
    mapd_lane_id LaneId;
    mapd_junction_id JunctionId;
    mapd_node_id NodeId;
    mapd_signal_id SignalId;
    mapd_object_id ObjectId;
}
