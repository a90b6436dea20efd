//! Blocks of lanes tell the sections and roads that the lanes' rows lead to.

use mapd_archive::packed_index::LANES_PER_BLOCK;
use mapd_compiler::{CompileOptions, compile};
use std::path::Path;

/// Each lane's section is told, and its road unless the lane is of a temporary layer: those sections follow all others, and their
/// roads need not follow each other.
fn check(path: &Path) {
    let file = std::fs::File::open(path).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("accepted");
    assert_eq!(rows.lane_blocks.len(), rows.lanes.len().div_ceil(LANES_PER_BLOCK as usize));
    let of_layers = rows.lane_layers.iter().map(|layer| layer.sections.first).min();
    let mut told = (0, 0);
    for (number, lane) in rows.lanes.iter().enumerate() {
        let (block, at) =
            (&rows.lane_blocks[number / LANES_PER_BLOCK as usize], number as u32 % LANES_PER_BLOCK);
        let step = |starts: u64| (starts >> at & 1) as u32;
        told = match at {
            0 => (block.section, block.road),
            _ => (told.0 + step(block.section_starts), told.1 + step(block.road_starts)),
        };
        assert_eq!(told.0, lane.section, "{}: lane {number}", path.display());
        if of_layers.is_none_or(|first| lane.section < first) {
            let road = rows.sections[lane.section as usize].road;
            assert_eq!(told.1, road, "{}: lane {number}", path.display());
        }
    }
}

#[test]
fn sections_and_roads_are_told() {
    for name in ["one_road.xodr", "town.xodr"] {
        check(&mapd_tests::carried(name));
    }
    // With temporary layers.
    check(&mapd_tests::workspace().join("tests/data/coverage/lanes.xodr"));
    match mapd_tests::shared("maps") {
        Some(maps) => check(&maps.join("carla/Town05.xodr")),
        None => mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace"),
    }
}
