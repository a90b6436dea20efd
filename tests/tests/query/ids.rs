//! Ids as plain integers.

use mapd_client::{LaneId, NodeId, QueryError, RoadId, SignalId};
use mapd_tests::carried;
use mapd_tests::maps::open;

#[test]
fn bits_are_content_then_row_then_tile() {
    let id = LaneId::from_bits(0x0000_0000_0000_0007_1122_3344_5566_7788);
    assert_eq!(id.row(), 7);
    assert_eq!(size_of::<LaneId>(), 16);
    for bits in [0, 1, u128::MAX, id.to_bits(), 1 << 64, 1 << 96] {
        assert_eq!(LaneId::from_bits(bits).to_bits(), bits);
    }
    let snapshot = open(&carried("town.xodr"));
    let lane = snapshot.map().lanes().next().expect("a lane").lane_id();
    let content = snapshot.map().content_hash();
    assert_eq!((lane.to_bits() as u64).to_le_bytes(), content[..8]);
    assert_eq!((lane.to_bits() >> 64) as u32, lane.row());
    assert_ne!(LaneId::from_bits(1 << 96), LaneId::from_bits(0), "the tile is a part of the id");
}

/// What stands where nothing was found is neither of another map nor a sign of damage.
#[test]
fn an_id_that_names_nothing_is_told_from_a_foreign_one() {
    let snapshot = open(&carried("town.xodr"));
    let map = snapshot.map();
    let own = u64::from_le_bytes(map.content_hash()[..8].try_into().expect("eight bytes"));
    let nothing = Some(QueryError::NoId);
    for content in [0, own, 1] {
        let bits = u128::from(u32::MAX) << 64 | u128::from(content);
        assert_eq!(map.lane(LaneId::from_bits(bits)).err(), nothing);
        assert_eq!(map.road(RoadId::from_bits(bits)).err(), nothing);
        assert_eq!(map.signal(SignalId::from_bits(bits)).err(), nothing);
        assert_eq!(map.lane_node(NodeId::from_bits(bits)).err(), nothing);
    }
    let last = u128::from(u32::MAX - 1) << 64;
    assert_eq!(map.lane(LaneId::from_bits(last)).err(), Some(QueryError::ForeignId));
    let beyond = LaneId::from_bits(last | u128::from(own));
    assert_eq!(map.lane(beyond).err(), Some(QueryError::Corrupt));
}
