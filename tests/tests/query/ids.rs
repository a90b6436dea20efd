//! Ids as plain integers.

use mapd_client::LaneId;
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
