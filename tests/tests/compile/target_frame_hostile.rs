//! Maps that make no sense, compiled into another frame: findings or a sound archive, never a panic; and one road astray does not
//! take the others with it.

use mapd_client::Snapshot;
use mapd_compiler::{
    CompileOptions, OnError, Policy, ReadOptions, Treatment, Verdict, compile_from,
};
use mapd_tests::damage::ask_everything;

/// What is put in the place of a number.
const SPECIAL: [&str; 14] = [
    "0",
    "-0",
    "1e-300",
    "-1e-9",
    "1e-5",
    "0.7",
    "1e3",
    "-3e5",
    "6.4e6",
    "1e9",
    "-1e15",
    "1e100",
    "-1e300",
    "1.7976931348623157e308",
];
const TARGETS: [&str; 4] = [
    "utm",
    "enu:48,12",
    "+proj=tmerc +lat_0=0 +lon_0=12 +k=1 +x_0=4500000 +datum=potsdam",
    "+proj=stere +lat_0=90 +lon_0=0 +k=1 +datum=WGS84",
];

/// A map with numbers in the places marked by @.
const MAP: &str = r#"<OpenDRIVE><header revMajor="1" revMinor="8"><geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference><offset x="@700000@" y="@5300000@" z="@5@" hdg="@0.1@"/></header>
<road id="1" length="60" junction="-1"><planView><geometry s="0" x="@20@" y="@10@" hdg="@0.5@" length="@20@"><line/></geometry><geometry s="20" x="37" y="19" hdg="0.5" length="20"><arc curvature="@0.01@"/></geometry><geometry s="40" x="54" y="31" hdg="0.7" length="20"><paramPoly3 aU="0" bU="@20@" cU="0" dU="@0@" aV="0" bV="0" cV="@2@" dV="0" pRange="normalized"/></geometry></planView>
<elevationProfile><elevation s="@10@" a="@2@" b="@0.01@" c="0" d="@0@"/></elevationProfile>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
<signals><signal id="7" s="20" t="4" dynamic="no" orientation="+" zOffset="2" type="206" subtype="-1"><positionInertial x="@30@" y="@8@" z="@3.5@" hdg="@0.25@"/></signal></signals></road></OpenDRIVE>"#;

fn compiled(text: &str, crs: &str) -> mapd_compiler::Compilation {
    let crs = Some(crs.parse().expect("a target"));
    let options = CompileOptions { crs, landmarks: 0, ..CompileOptions::default() };
    let policy = Policy { on_error: OnError::Quarantine, ..Policy::default() };
    let reading = ReadOptions { policy, ..ReadOptions::default() };
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

#[test]
fn no_number_makes_it_panic() {
    let parts: Vec<&str> = MAP.split('@').collect();
    let numbers = parts.len() / 2;
    assert!(numbers > 15 && parts.len() % 2 == 1);
    let mut accepted = 0;
    for at in 0..numbers {
        for (round, special) in SPECIAL.into_iter().enumerate() {
            let mut parts = parts.clone();
            parts[2 * at + 1] = special;
            let text = parts.concat();
            // Each number meets each target with some values.
            let crs = TARGETS[(at + round) % TARGETS.len()];
            let compiled = compiled(&text, crs);
            let Some(rows) = &compiled.rows else {
                assert!(compiled.diagnostics.iter().any(|told| told.rejects), "{text}");
                continue;
            };
            let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
            mapd_archive::verify(&bytes).unwrap_or_else(|e| panic!("{e}: {crs} {text}"));
            if (at + round) % 5 == 0 {
                ask_everything(bytes);
            }
            accepted += 1;
        }
    }
    assert!(accepted > 50, "{accepted}");
}

#[test]
fn a_road_astray_is_left_out_alone() {
    let road = |id: u32, x: f64| {
        format!(
            r#"<road id="{id}" length="100" junction="-1"><planView><geometry s="0" x="{x}" y="5300000" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        )
    };
    let roads = [(1, 7e5), (2, 7.001e5), (3, 9e10), (4, 7.002e5)].map(|(id, x)| road(id, x));
    let text = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"><geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference></header>{}</OpenDRIVE>"#,
        roads.concat()
    );
    let compiled = compiled(&text, "epsg:32633");
    assert_eq!(compiled.verdict, Verdict::Quarantined);
    let [part] = &compiled.quarantined[..] else { panic!("{:?}", compiled.quarantined) };
    assert_eq!((part.id.as_str(), part.treatment), ("3", Treatment::Dropped));
    assert_eq!(part.rule, "mapd:compile.target_frame");
    let rows = compiled.rows.as_ref().expect("accepted");
    let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
    let snapshot = Snapshot::from_bytes(bytes).expect("opens");
    let ids: Vec<_> = snapshot.map().roads().map(|road| road.id().to_owned()).collect();
    assert_eq!(ids, ["1", "2", "4"]);
    assert!(snapshot.map().file_frame().is_some());
}
