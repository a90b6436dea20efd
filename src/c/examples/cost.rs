//! What a call costs in Rust, for `tests/cost.c` to be compared with: `cost ARCHIVE KIND COUNT` asks COUNT questions of a kind, and prints a sum of the answers.

use mapd_client::glam::DVec2;
use mapd_client::{NearestOptions, Snapshot, Track};
use std::io::Write as _;
use std::process::ExitCode;

/// What can be asked. Those by id look a lane or road up in each call, as C does; the others hold it.
const KINDS: [&str; 6] =
    ["nearest", "position", "position_by_id", "track", "track_by_id", "inertial"];

/// Numbers between two others, the same in C: Knuth's MMIX.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }
}

fn run() -> Option<f64> {
    let mut args = std::env::args().skip(1);
    let snapshot = Snapshot::open(args.next()?).ok()?;
    let (kind, count) = (args.next()?, args.next()?.parse::<u32>().ok()?);
    let (map, mut random) = (snapshot.map(), Random(1));
    let (bounds, options) = (map.bounds(), NearestOptions::default());
    let lane = map.lanes().next()?;
    let road = lane.road();
    let mut sum = 0.0;
    // Looked up once: what the loop does besides its call is to be as little as in C.
    let kind = KINDS.iter().position(|one| *one == kind)?;
    let (lane_id, road_id) = (lane.lane_id(), road.road_id());
    for _ in 0..count {
        let x = random.between(bounds.low.x, bounds.high.x);
        let point = DVec2::new(x, random.between(bounds.low.y, bounds.high.y));
        sum += match kind {
            0 => map.nearest_lane(point, &options).ok()?.map_or(0.0, |hit| hit.position.s),
            1 => lane.position_of(point).ok()?.offset,
            2 => map.lane(lane_id).ok()?.position_of(point).ok()?.offset,
            3 => road.to_track(point).ok()?.t,
            4 => map.road(road_id).ok()?.to_track(point).ok()?.t,
            _ => {
                let s = random.between(0.0, road.length());
                road.to_inertial(Track { s, t: 1.0, h: 0.0 }).ok()?.position.x
            }
        };
    }
    Some(sum)
}

fn main() -> ExitCode {
    let Some(sum) = run() else { return ExitCode::FAILURE };
    let is_written = writeln!(std::io::stdout(), "{sum:.6}").is_ok();
    if is_written { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
