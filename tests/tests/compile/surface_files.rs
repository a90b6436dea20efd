//! Surfaces as files write them: the same heights as worked out in `surfaces.rs`.

use mapd_client::Snapshot;
use mapd_client::glam::DVec3;
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::maps::open_text;

/// Rounding of coordinates of some hundred metres `[m]`.
const ROUNDING: f64 = 1e-12;

/// A road of 100 m from (x, 0) along x at a height of 10 m, with lanes 1, −1 and −2 of 3.5 m.
fn road(id: &str, x: f64, junction: &str, lateral: &str, lane: &str) -> String {
    let side = |ids: &[i32]| -> String {
        let one = |id: &i32| {
            format!(
                "<lane id=\"{id}\" type=\"driving\" level=\"false\"><width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/>{lane}</lane>"
            )
        };
        ids.iter().map(one).collect()
    };
    format!(
        "<road id=\"{id}\" length=\"100\" junction=\"{junction}\">\
         <planView><geometry s=\"0\" x=\"{x}\" y=\"0\" hdg=\"0\" length=\"100\"><line/></geometry></planView>\
         <elevationProfile><elevation s=\"0\" a=\"10\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile>\
         <lateralProfile>{lateral}</lateralProfile>\
         <lanes><laneSection s=\"0\"><left>{}</left><center><lane id=\"0\" type=\"none\"/></center><right>{}</right></laneSection></lanes></road>",
        side(&[1]),
        side(&[-1, -2])
    )
}

fn open(inside: &str) -> Snapshot {
    let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/>{inside}</OpenDRIVE>");
    open_text(&text)
}

/// Heights of the surface of road 1 at places (s, t).
#[track_caller]
fn check(snapshot: &Snapshot, heights: &[(f64, f64, f64)]) {
    let road = snapshot.map().road_by_id("1").expect("the road");
    for (s, t, z) in heights {
        let found = road.surface_at(*s, *t).expect("a surface").position;
        assert!(
            found.distance(DVec3::new(*s, *t, *z)) <= ROUNDING,
            "({s}, {t}): {found} instead of {z}"
        );
    }
}

#[test]
fn shapes() {
    // Out of order on purpose. At s = 0: h = 0.5 + 0.1·(t + 5) below t = 0, 1 + 0.02·t above; at s = 50: 0.2 everywhere.
    let lateral = "<shape s=\"50\" t=\"-5\" a=\"0.2\" b=\"0\" c=\"0\" d=\"0\"/>\
                   <shape s=\"0\" t=\"0\" a=\"1\" b=\"0.02\" c=\"0\" d=\"0\"/>\
                   <shape s=\"0\" t=\"-5\" a=\"0.5\" b=\"0.1\" c=\"0\" d=\"0\"/>";
    let snapshot = open(&road("1", 0.0, "-1", lateral, ""));
    // Half way between (0, −3), 0.7, and (50, −3), 0.2: 0.45.
    check(
        &snapshot,
        &[(0.0, -3.0, 10.7), (0.0, 2.0, 11.04), (25.0, -3.0, 10.45), (80.0, 2.0, 10.2)],
    );
}

#[test]
fn crossfalls() {
    let angle = 0.02f64.atan();
    let lateral = format!(
        "<crossfall side=\"both\" s=\"0\" a=\"{angle:e}\" b=\"0\" c=\"0\" d=\"0\"/>\
         <crossfall side=\"right\" s=\"50\" a=\"0\" b=\"0\" c=\"0\" d=\"0\"/>"
    );
    let snapshot = open(&road("1", 0.0, "-1", &lateral, ""));
    check(
        &snapshot,
        &[(20.0, 3.0, 9.94), (20.0, -3.0, 9.94), (60.0, 3.0, 9.94), (60.0, -3.0, 10.0)],
    );
}

#[test]
fn cross_section_surfaces() {
    // The middle at t = 1, to its left 2 m that fall by 0.1 per metre, then a rise of 0.2 per metre from that edge.
    let coefficients =
        |name: &str, a: f64| format!("<{name}><coefficients s=\"0\" a=\"{a}\"/></{name}>");
    let lateral = format!(
        "<crossSectionSurface>{}<surfaceStrips>\
         <strip id=\"1\" mode=\"independent\">{}{}</strip><strip id=\"2\" mode=\"relative\">{}</strip>\
         </surfaceStrips></crossSectionSurface>",
        coefficients("tOffset", 1.0),
        coefficients("width", 2.0),
        coefficients("linear", -0.1),
        coefficients("linear", 0.2)
    );
    let snapshot = open(&road("1", 0.0, "-1", &lateral, ""));
    check(&snapshot, &[(50.0, 2.0, 9.9), (50.0, 4.0, 10.0), (50.0, -1.0, 10.0)]);
}

#[test]
fn heights_and_materials() {
    let lane = "<material sOffset=\"0\" surface=\"asphalt\" friction=\"0.9\" roughness=\"0.01\"/>\
                <material sOffset=\"40\" friction=\"0.3\"/>\
                <height sOffset=\"40\" inner=\"0.1\" outer=\"0.2\"/>";
    let snapshot = open(&road("1", 0.0, "-1", "", lane));
    // Lane −2 lies from t = −3.5 to −7: 0.15 m in its middle from s = 40 on.
    check(&snapshot, &[(20.0, -5.25, 10.0), (50.0, -5.25, 10.15), (50.0, 1.75, 10.15)]);
    let road = snapshot.map().road_by_id("1").expect("the road");
    let at = |s: f64| road.surface_at(s, -5.0).expect("a surface").material.expect("a material");
    assert_eq!(
        (at(20.0).surface, at(20.0).friction, at(20.0).roughness),
        ("asphalt", Some(0.9), Some(0.01))
    );
    assert_eq!((at(50.0).surface, at(50.0).friction, at(50.0).roughness), ("", Some(0.3), None));
}

#[test]
fn elevation_grids() {
    // The grid of `surfaces.rs`, 12 + 0.1·x + 0.05·y; the joint is the end of road 0, which arrives at x = 0.
    let rows: String = (0..=10)
        .map(|i| {
            let center = 12.0 + f64::from(i);
            format!(
                "<elevation left=\"{}\" center=\"{center}\" right=\"{}\"/>",
                center + 0.5,
                center - 0.5
            )
        })
        .collect();
    let junction = format!(
        "<junction id=\"7\" name=\"\" type=\"default\">\
         <planView><geometry s=\"0\" x=\"-20\" y=\"0\" hdg=\"0\" length=\"200\"><line/></geometry></planView>\
         <boundary><segment type=\"joint\" roadId=\"0\" contactPoint=\"end\" jointLaneStart=\"1\" jointLaneEnd=\"-2\" transitionLength=\"20\"/></boundary>\
         <elevationGrid sStart=\"20\" gridSpacing=\"10\">{rows}</elevationGrid></junction>"
    );
    let roads = road("0", -100.0, "-1", "", "") + &road("1", 0.0, "7", "", "");
    let snapshot = open(&format!("{roads}{junction}"));
    check(
        &snapshot,
        &[(34.0, 2.0, 15.5), (5.0, 0.0, 10.390_625), (0.0, -2.0, 10.0), (20.0, 0.0, 14.0)],
    );
}

#[test]
fn grids_that_cannot_be_used_are_named() {
    let junction = "<junction id=\"7\" name=\"\"><elevationGrid sStart=\"0\" gridSpacing=\"x\"><elevation center=\"1\"/></elevationGrid></junction>";
    let text = format!(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/>{}{junction}</OpenDRIVE>",
        road("1", 0.0, "7", "", "")
    );
    let compiled =
        compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works");
    assert!(
        compiled.diagnostics.iter().any(|d| d.finding.rule == "mapd:compile.elevation_grid"),
        "{:?}",
        compiled.diagnostics
    );
    assert!(compiled.rows.is_some_and(|rows| rows.elevation_grids.is_empty()));
}
