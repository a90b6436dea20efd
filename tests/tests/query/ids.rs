//! Ids as plain integers.

use mapd_client::LaneId;

#[test]
fn bits_are_content_then_row_then_tile() {
    let id = LaneId::from_bits(0x0000_0000_0000_0007_1122_3344_5566_7788);
    assert_eq!(id.row(), 7);
    assert_eq!(size_of::<LaneId>(), 16);
    for bits in [0, 1, u128::MAX, id.to_bits(), 1 << 64, 1 << 96] {
        assert_eq!(LaneId::from_bits(bits).to_bits(), bits);
    }
    assert_ne!(LaneId::from_bits(1 << 96), LaneId::from_bits(0), "the tile is a part of the id");
}
