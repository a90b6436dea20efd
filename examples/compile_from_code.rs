//! Compiles a map from code and queries it in the same process, as a planner's tests do without a daemon.

use anyhow::{Context, Result, bail};
use mapd_archive::encode;
use mapd_client::{Snapshot, Track};
use mapd_compiler::{CompileOptions, compile};
use std::io::Write;
use std::path::Path;

fn main() -> Result<()> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("maps/one_road.xodr");
    let file = std::fs::File::open(&path)?;
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {})?;
    let mut out = std::io::stdout().lock();
    for d in &compiled.diagnostics {
        writeln!(out, "{}:{}: {}", d.line, d.column, d.finding.message)?;
    }
    let Some(rows) = &compiled.rows else { bail!("the map was rejected") };

    // The same bytes could be written to a file (`Snapshot::open`) or published.
    let snapshot = Snapshot::from_bytes(encode(rows, &compiled.provenance)?)?;
    let map = snapshot.map();
    let road = map.road_by_id("1").context("the map has no road 1")?;
    for s in [0.0, 60.0, 100.0, 160.0, 200.0] {
        let pose = road.to_inertial(Track { s, t: -1.75, h: 0.0 })?;
        let p = pose.position;
        writeln!(
            out,
            "s = {s:5.1} m: ({:.3}, {:.3}, {:.3}), heading {:.4} rad",
            p.x, p.y, p.z, pose.heading
        )?;
    }
    Ok(())
}
