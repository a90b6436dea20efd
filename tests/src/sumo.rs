//! Networks of Eclipse SUMO's tools, where they are installed: on the path or in `$SUMO_HOME/bin`.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A square grid of streets with traffic lights and turn lanes, `crossings` to a side and 150 m apart, made in `folder` by
/// netgenerate and netconvert; `None` where these are not there.
pub fn grid(folder: &Path, crossings: u32) -> Option<PathBuf> {
    let home = std::env::var_os("SUMO_HOME").map(|home| Path::new(&home).join("bin"));
    let tool = |name: &str| {
        let own = home.as_ref().map(|home| home.join(name)).filter(|path| path.exists());
        Command::new(own.unwrap_or_else(|| name.into()))
    };
    let (net, map) = (folder.join("grid.net.xml"), folder.join("grid.xodr"));
    let made = tool("netgenerate")
        .args(["--grid", &format!("--grid.number={crossings}"), "--grid.length=150", "-L", "2"])
        .args(["-j", "traffic_light", "--turn-lanes", "1", "-o"])
        .arg(&net)
        .output()
        .ok()?;
    let converted =
        tool("netconvert").arg("-s").arg(&net).arg("--opendrive-output").arg(&map).output().ok()?;
    (made.status.success() && converted.status.success()).then_some(map)
}
