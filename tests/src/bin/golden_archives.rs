//! Writes archives of this release's layout, with what they answer, to `tests/data/archives`, where every later build opens and asks them:
//! `cargo run -p mapd-tests --bin golden_archives`, once for each release. What is there stays as it is.

use mapd_client::Snapshot;
use mapd_tests::{golden_maps, overlays, releases};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::UNIX_EPOCH;

/// Something of each kind, on the map `furnished`; one entry holds on another day.
const ENTRIES: &str = r#"{"entries":[
 {"id":"closed","kind":"closed","lanes":[{"road":"0","s":[20,40.5],"lane":1}],"source":"works","text":"Road works","confidence":0.75,"until":"2026-06-01T00:00:00Z"},
 {"id":"only","kind":"only","vehicles":["bus","truck"],"lanes":[{"road":"12"}]},
 {"id":"open","kind":"open","vehicles":["bicycle"],"lanes":[{"key":"1:0:1"}]},
 {"id":"slow","kind":"speed","value":5.5,"lanes":[{"road":"1","s":[10,90]}],"weekly":[{"days":["mon","tue"],"from":"06:30","until":"15:00"}]},
 {"id":"fast","kind":"speed","value":30,"lanes":[{"road":"2"}]},
 {"id":"overtaking","kind":"no-overtaking","lanes":[{"road":"3"}]},
 {"id":"wet","kind":"wet","lanes":[{"road":"01"}]},
 {"id":"signal","kind":"signal-off","signals":["L0","V1"]},
 {"id":"sunday","kind":"closed","lanes":[{"road":"3"}],"weekly":[{"days":["sun"],"from":"00:00","until":"12:00"}]},
 {"id":"warning","kind":"warning","lanes":[{"road":"21"}],"text":"Geese"}]}"#;

fn main() -> Result<(), Box<dyn Error>> {
    for golden in golden_maps::all() {
        let file =
            releases::golden().join(format!("{}-{}.mapd", env!("CARGO_PKG_VERSION"), golden.name));
        if !file.exists() {
            fs::write(&file, golden.compile()?)?;
            write_texts(&file)?;
        }
    }
    // Archives of earlier releases have the texts of their time; a new kind of text begins with this one.
    releases::kept().iter().try_for_each(|file| write_texts(file))?;
    let name = format!("{}-furnished", env!("CARGO_PKG_VERSION"));
    let file = releases::golden().join(format!("{name}.overlay"));
    if !file.exists() {
        let map = Snapshot::open(releases::golden().join(format!("{name}.mapd")))?;
        let (bytes, resolved) = overlays::over(map.map(), ENTRIES, true);
        if let Some(unplaced) = resolved.unplaced.first() {
            return Err(format!("{unplaced:?}").into());
        }
        fs::write(&file, &bytes)?;
        let snapshot = map.with_overlay(bytes)?;
        let answers = releases::answers_today(snapshot.view(UNIX_EPOCH + releases::MOMENT))?;
        fs::write(releases::golden().join(format!("{name}.overlay.txt")), answers)?;
    }
    Ok(())
}

/// Writes the texts of an archive that it does not have yet.
fn write_texts(archive: &Path) -> Result<(), Box<dyn Error>> {
    for (extension, text) in releases::texts(Snapshot::open(archive)?.map())? {
        let file = archive.with_extension(extension);
        if !file.exists() {
            fs::write(file, text)?;
        }
    }
    Ok(())
}
