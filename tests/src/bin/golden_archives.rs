//! Writes archives of this release's layout, with what they answer, to `tests/data/archives`, where every later build opens and asks them:
//! `cargo run -p mapd-tests --bin golden_archives`, once for each release.

use mapd_client::Snapshot;
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::{carried, crossroads, releases};
use std::error::Error;
use std::fs;

fn main() -> Result<(), Box<dyn Error>> {
    let objects = fs::read_to_string(carried("objects.xodr"))?;
    for (name, text) in [("crossing", crossroads::furnished()), ("objects", objects)] {
        let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {})?;
        let rows = compiled.rows.ok_or("the map is rejected")?;
        let bytes = mapd_archive::encode(&rows, &compiled.provenance)?;
        let file = releases::golden().join(format!("{}-{name}.mapd", env!("CARGO_PKG_VERSION")));
        fs::write(&file, &bytes)?;
        let snapshot = Snapshot::from_bytes(bytes)?;
        fs::write(file.with_extension("txt"), releases::answers(snapshot.map())?)?;
    }
    Ok(())
}
