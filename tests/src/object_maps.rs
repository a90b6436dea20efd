//! Small maps of one road with objects, as text.

use mapd_client::Snapshot;
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};

/// What the road of such a map is made of.
pub struct ObjectRoad<'a> {
    /// Version, such as 1.8.
    pub version: &'a str,
    /// The geometry's element, from (x, y, hdg).
    pub geometry: &'a str,
    /// Start: x, y, hdg.
    pub start: [f64; 3],
    /// Elevation over s: a and b.
    pub elevation: [f64; 2],
    /// Superelevation `[rad]`.
    pub superelevation: f64,
}

/// 100 m from the origin along x, without height.
pub const PLAIN: ObjectRoad<'_> = ObjectRoad {
    version: "1.8",
    geometry: "<line/>",
    start: [0.0, 0.0, 0.0],
    elevation: [0.0, 0.0],
    superelevation: 0.0,
};

/// A document of one road of 100 m, id 1, with lanes 2 (sidewalk, 2 m), 1, −1 (driving, 3.5 m) and −2 (parking, 2.5 m), and
/// these elements inside `objects`.
pub fn document(road: &ObjectRoad<'_>, objects: &str) -> String {
    let (_, minor) = road.version.split_once('.').unwrap_or(("1", "8"));
    let [x, y, hdg] = road.start;
    let [a, b] = road.elevation;
    let lane = |id: i32, kind: &str, width: f64| {
        format!(
            r#"<lane id="{id}" type="{kind}" level="false"><width sOffset="0" a="{width}" b="0" c="0" d="0"/></lane>"#
        )
    };
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="{minor}"/><road id="1" length="100" junction="-1">
<planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="{hdg:?}" length="100">{}</geometry></planView>
<elevationProfile><elevation s="0" a="{a:?}" b="{b:?}" c="0" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="{:?}" b="0" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><left>{}{}</left><center><lane id="0" type="none" level="false"/></center><right>{}{}</right></laneSection></lanes>
<objects>
{objects}
</objects></road></OpenDRIVE>"#,
        road.geometry,
        road.superelevation,
        lane(2, "sidewalk", 2.0),
        lane(1, "driving", 3.5),
        lane(-1, "driving", 3.5),
        lane(-2, "parking", 2.5),
    )
}

/// Compiles a document.
pub fn compile(text: &str) -> Compilation {
    let open = || Ok(text.as_bytes());
    compile_from(open, &ReadOptions::default(), &CompileOptions::default(), &mut |_| {})
        .expect("reading works")
}

/// Opens a document's map, proven.
pub fn open(text: &str) -> Snapshot {
    let compiled = compile(text);
    let rows = compiled.rows.unwrap_or_else(|| panic!("rejected: {:?}", compiled.diagnostics));
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).unwrap_or_else(|error| panic!("{error}"));
    Snapshot::from_bytes(archive).expect("opens")
}
