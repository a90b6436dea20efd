//! What mapd's tests share: places of maps, the generators of the town and the quarter that the project carries, domains with daemons and
//! clients as processes, and the tracer that stops a program at its system calls.
//!
//! Tests live in `tests/tests`. Those that need maps from outside the project look for them in `../shared` beside the
//! workspace and say aloud that they skip where it is missing.
//!
//! ```
//! assert!(mapd_tests::carried("one_road.xodr").exists());
//! ```

pub mod annotated;
#[cfg(feature = "processes")]
pub mod browser;
pub mod command;
#[cfg(feature = "processes")]
pub mod coverage;
pub mod crossroads;
pub mod damage;
pub mod drives;
#[cfg(feature = "processes")]
pub mod golden_maps;
pub mod graph_maps;
#[cfg(feature = "processes")]
pub mod json_schema;
#[cfg(feature = "processes")]
pub mod literal;
pub mod long_lane;
#[cfg(feature = "processes")]
pub mod manager;
pub mod maps;
pub mod object_maps;
#[cfg(feature = "processes")]
pub mod other_user;
#[cfg(feature = "overlays")]
pub mod overlays;
pub mod piles;
#[cfg(feature = "processes")]
pub mod plain_route;
pub mod quarter;
pub mod releases;
#[cfg(feature = "processes")]
pub mod small;
#[cfg(feature = "processes")]
pub mod stage;
pub mod sumo;
#[cfg(feature = "processes")]
pub mod test_domain;
pub mod town;
#[cfg(feature = "processes")]
pub mod tracer;
#[cfg(feature = "processes")]
pub mod two_maps;
#[cfg(feature = "processes")]
pub mod view;

use std::path::{Path, PathBuf};

/// Both ends of a stretch, the lower one first.
pub fn ends(range: mapd_query::SRange) -> (f64, f64) {
    (range.low, range.high)
}

/// Says something aloud: on stderr itself, which the test harness does not swallow.
pub fn say(message: &str) {
    use std::io::Write as _;
    // A closed stderr is no reason to fail a test.
    let _ = writeln!(std::io::stderr(), "{message}");
}

/// A number that the environment says, for the long form of a test.
pub fn number<T: std::str::FromStr>(variable: &str, otherwise: T) -> T {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// Root of the workspace.
pub fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_owned).unwrap_or_default()
}

/// A map that the project carries.
pub fn carried(name: &str) -> PathBuf {
    workspace().join("examples/maps").join(name)
}

/// A folder of material outside the project, if it is there.
pub fn shared(name: &str) -> Option<PathBuf> {
    let path = workspace().parent()?.join("shared").join(name);
    path.is_dir().then_some(path)
}

/// All maps of the shared corpus, sorted, as (name such as `carla/Town05`, path).
pub fn corpus() -> Option<Vec<(String, PathBuf)>> {
    let root = shared("maps")?;
    let mut maps = Vec::new();
    for origin in std::fs::read_dir(root).ok()?.flatten().filter(|entry| entry.path().is_dir()) {
        for file in std::fs::read_dir(origin.path()).ok()?.flatten() {
            let path = file.path();
            if path.extension().is_some_and(|extension| extension == "xodr") {
                let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                maps.push((
                    format!("{}/{stem}", origin.file_name().to_string_lossy()),
                    path.clone(),
                ));
            }
        }
    }
    maps.sort();
    Some(maps)
}
