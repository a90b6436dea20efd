//! A planner's first screen: which lane is a point on? Waits for the map at boot; daemon and planner may start in any order.
#![allow(clippy::print_stdout)]

use mapd_client::{Client, NearestOptions, glam::DVec2};
use std::time::Duration;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Daemon or client may start first.
    let client = Client::connect("town", Duration::from_secs(30))?;
    // Pins one generation; share it between threads.
    let snapshot = client.snapshot();
    let map = snapshot.map();
    if let Some(hit) = map.nearest_lane(DVec2::new(50.0, -1.75), &NearestOptions::default())? {
        println!("lane {} at s = {}", map.lane(hit.lane)?.key(), hit.position.s);
    }
    Ok(())
}
