//! Maps whose archives are kept for later releases: together they fill every table that a map can fill.

use crate::annotated::{document, road, roundabout};
use crate::{carried, crossroads, workspace};
use mapd_archive::{AlignedBytes, encode};
use mapd_compiler::{CompileOptions, ReadOptions, compile_from};
use std::error::Error;
use std::fs;
use std::path::PathBuf;

/// Documents that hold every element and attribute of OpenDRIVE; the files that they include lie in `parts`.
const COVERAGE: [&str; 10] = [
    "crossing",
    "junction",
    "lanes",
    "links",
    "objects",
    "old",
    "railway",
    "semantics_as_elements",
    "shapes",
    "signals",
];

/// A roundabout of both of its junctions.
const GROUP: &str = r#"<junctionGroup id="g" name="" type="roundabout"><junctionReference junction="A"/><junctionReference junction="B"/></junctionGroup>"#;

/// A sign whose limit only its name states.
const NAMED_SIGN: &str = r#"<objects><object id="1" name="Speed_30" s="5" t="-4" zOffset="0" orientation="none" width="1" length="1" height="1"/></objects>"#;

/// A tree whose place is no number.
const BROKEN_TREE: &str =
    r#"<objects><object id="2" type="tree" s="here" t="4" zOffset="0" radius="1"/></objects>"#;

/// A limit in towns.
const TOWN: &str = r#"<defaultRegulations><roadRegulations type="town"><semantics><speed type="maximum" value="50" unit="km/h"/></semantics></roadRegulations></defaultRegulations>"#;

/// A zone, and within it a limit that ends with the junction behind.
const SPEED_SIGNS: &str = r#"<signals><signal id="Z" s="4" t="-4" zOffset="2" orientation="+" dynamic="no" country="DE" type="274.1" subtype="-1" value="30" unit="km/h"/><signal id="V" s="6" t="-4" zOffset="2" orientation="+" dynamic="no" country="DE" type="274" subtype="-1" value="20" unit="km/h"/></signals>"#;

/// A file that a map includes, with a broken road.
const BROKEN_PART: &str = "broken.xml";

/// A map to be kept.
pub struct GoldenMap {
    /// Its name, behind the release's.
    pub name: String,
    text: String,
    /// Frame that it is moved into: `utm`.
    crs: Option<&'static str>,
}

/// All of them. Panics where a file of the project cannot be read.
pub fn all() -> Vec<GoldenMap> {
    let map = |name: &str, text: String| GoldenMap { name: name.into(), text, crs: None };
    let read = |path: PathBuf| fs::read_to_string(path).expect("a file of the project");
    let covered = |name: &str| read(coverage().join(format!("{name}.xodr")));
    let mut maps = vec![
        map("furnished", crossroads::furnished()),
        map("lane-blocks", read(carried("town.xodr"))),
        map("lane-lengths", crate::long_lane::long_lane(40, true)),
        map("objects", read(carried("objects.xodr"))),
        map("roundabout", roundabout(GROUP)),
        map("surfaces", read(carried("surfaces.xodr"))),
        map("speeds", {
            let (before, behind) =
                (road("1", 0.0, "", SPEED_SIGNS, ""), road("2", 0.0, "", "", ""));
            let linked = linked(&before, "successor", "2", "start")
                + &linked(&behind, "predecessor", "1", "end")
                    .replace("s=\"0\" x=\"0\"", "s=\"0\" x=\"10\"");
            let town = road("3", 9.0, "", "", "")
                .replace("<planView>", "<type s=\"0\" type=\"town\"/><planView>");
            document(9, TOWN, &(linked + &town))
        }),
        map("half-broken", {
            let wide = road("2", 9.0, "", "", "").replace("a=\"3\"", "a=\"wide\"");
            document(8, "", &(road("1", 0.0, "", "", "") + &wide))
        }),
        map("named-sign", document(8, "", &road("1", 0.0, "", NAMED_SIGN, ""))),
        map("broken", {
            let sound = road("1", 0.0, "", BROKEN_TREE, "");
            let broken = broken_road("3", 18.0, NAMED_SIGN);
            document(8, "", &format!("{sound}{broken}<include file=\"{BROKEN_PART}\"/>"))
        }),
        GoldenMap { crs: Some("utm"), ..map("moved", covered("shapes")) },
    ];
    maps.extend(COVERAGE.map(|name| map(&format!("all-{name}"), covered(name))));
    maps
}

/// A road with a link of its own and of its lane.
fn linked(road: &str, to: &str, id: &str, contact: &str) -> String {
    let link = format!(
        "<link><{to} elementType=\"road\" elementId=\"{id}\" contactPoint=\"{contact}\"/></link>"
    );
    road.replace("<planView>", &format!("{link}<planView>"))
        .replace("<width", &format!("<link><{to} id=\"-1\"/></link><width"))
}

/// A road whose length is no number.
fn broken_road(id: &str, y: f64, inside: &str) -> String {
    road(id, y, "", inside, "").replace("length=\"10\"", "length=\"far\"")
}

fn coverage() -> PathBuf {
    workspace().join("tests/data/coverage")
}

impl GoldenMap {
    /// Its archive, as this release writes it.
    ///
    /// Errors: the map cannot be read, is rejected, or is too large.
    pub fn compile(&self) -> Result<AlignedBytes, Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        for part in fs::read_dir(coverage().join("parts"))? {
            let part = part?;
            fs::copy(part.path(), folder.path().join(part.file_name()))?;
        }
        let broken = broken_road("2", 9.0, "");
        fs::write(folder.path().join(BROKEN_PART), format!("<OpenDRIVE>{broken}</OpenDRIVE>"))?;
        let include_folder = Some(folder.path().to_owned());
        let reading = ReadOptions { include_folder, ..ReadOptions::default() };
        let crs = self.crs.map(str::parse).transpose()?;
        let options = CompileOptions { crs, ..CompileOptions::default() };
        let text = self.text.as_bytes();
        let compiled = compile_from(|| Ok(text), &reading, &options, &mut |_| {})?;
        let rows = compiled.rows.ok_or_else(|| format!("{} is rejected", self.name))?;
        Ok(encode(&rows, &compiled.provenance)?)
    }
}
