//! Steps, bends and numbers that are easily missed: each has a finding at its place.

use mapd_compiler::{ReadOptions, check_from};
use mapd_rules::Example::{self, Document, Header, Lanes, Road};
use mapd_xodr::Severity;

const JUMP: &str = "mapd:xodr:1.4.0:lane_smoothness.within_road";
const FOLDED: &str = "mapd:xodr:1.4.0:lane.folded";
const WIDTH: &str = "mapd:xodr:1.4.0:lane.without_width";
const REFERENCE: &str = "mapd:compile.geo_reference";
const UNSAID: &str = "mapd:xodr:1.4.0:lane.mark_without_lane_change";

/// Severities and messages of a rule's findings.
fn told(example: Example, rule: &str) -> Vec<(Severity, String)> {
    let text = example.document(8).expect("a document");
    let checked =
        check_from(|| Ok(text.as_bytes()), &ReadOptions::default(), &mut |_| {}).expect("reads");
    let own = checked.diagnostics.into_iter().filter(|d| d.finding.rule == rule);
    own.map(|d| (d.finding.severity, d.finding.message)).collect()
}

fn check(cases: &[(Example, &str)], rule: &str, severity: Severity) {
    for (example, due) in cases {
        let found = told(*example, rule);
        let is_due = match &found[..] {
            [] => due.is_empty(),
            [(own, message)] => *own == severity && !due.is_empty() && message.contains(due),
            _ => false,
        };
        assert!(is_due, "{example:?}: {due:?}, found {found:?}");
    }
}

/// Before the first record, a profile is 0.
#[test]
fn a_first_record_that_begins_late_may_be_a_step() {
    let cases = [
        (
            Road(
                r#"<elevationProfile><elevation s="20" a="1" b="0" c="0" d="0"/></elevationProfile>"#,
            ),
            "expected 0 m, as before the first record at s = 20, found 1.000 m",
        ),
        (
            Road(
                r#"<elevationProfile><elevation s="20" a="0" b="0.1" c="0" d="0"/></elevationProfile>"#,
            ),
            "",
        ),
        (
            Road(
                r#"<elevationProfile><elevation s="0" a="1" b="0" c="0" d="0"/></elevationProfile>"#,
            ),
            "",
        ),
        (
            Road(
                r#"<elevationProfile><elevation s="200" a="1" b="0" c="0" d="0"/></elevationProfile>"#,
            ),
            "",
        ),
        (
            Road(
                r#"<lateralProfile><superelevation s="20" a="-0.2" b="0" c="0" d="0"/></lateralProfile>"#,
            ),
            "expected 0 rad, as before the first record at s = 20, found -0.200 rad",
        ),
        (
            Lanes(
                r#"<laneOffset s="20" a="3.5" b="0" c="0" d="0"/><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            "expected 0 m, as before the first record at s = 20, found 3.500 m",
        ),
        // Lanes are counted anew there.
        (
            Lanes(
                r#"<laneOffset s="20" a="3.5" b="0" c="0" d="0"/><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection><laneSection s="20"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            "",
        ),
    ];
    check(&cases, JUMP, Severity::Warning);
}

/// Only lanes of one of two roads have a width, or a border.
#[test]
fn a_lane_without_width_is_told() {
    let cases = [
        (
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"/></right></laneSection>"#,
            ),
            "found none; it is 0 m wide",
        ),
        (
            Lanes(
                r#"<laneSection s="0"><left><lane id="1" type="border"/></left><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            "found none; it is 0 m wide",
        ),
        (
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
            "",
        ),
        (
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="0" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
            "",
        ),
    ];
    check(&cases, WIDTH, Severity::Warning);
}

/// A turn within a centimetre lies between the places that were looked at.
#[test]
fn a_bend_shorter_than_a_step_folds_lanes() {
    /// Straight on, this geometry of 1 cm from s = 50.4 on, and straight on in its end's heading.
    macro_rules! bent {
        ($shape:literal, $x:literal, $y:literal, $hdg:literal, $lane:literal) => {
            Document(concat!(
                r#"<road id="1" length="100.41" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="50.4"><line/></geometry><geometry s="50.4" x="50.4" y="0" hdg="0" length="0.01">"#,
                $shape,
                r#"</geometry><geometry s="50.41" x=""#, $x, r#"" y=""#, $y, r#"" hdg=""#, $hdg,
                r#"" length="50"><line/></geometry></planView><lanes><laneSection s="0">"#, $lane, "</laneSection></lanes></road>"
            ))
        };
    }
    let cases = [
        (
            bent!(
                r#"<spiral curvStart="0" curvEnd="150"/>"#,
                "50.4094520",
                "0.0024013",
                "0.75",
                r#"<left><lane id="1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center>"#
            ),
            "a lane that goes on along its road",
        ),
        (
            bent!(
                r#"<arc curvature="-75"/>"#,
                "50.4090885",
                "-0.0035775",
                "-0.75",
                r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>"#
            ),
            "a lane that goes on along its road",
        ),
        // On the outer side nothing folds.
        (
            bent!(
                r#"<arc curvature="75"/>"#,
                "50.4090885",
                "0.0035775",
                "0.75",
                r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>"#
            ),
            "",
        ),
    ];
    check(&cases, FOLDED, Severity::Warning);
}

/// UTM has its own origin and scale; PROJ reads no others.
#[test]
fn parameters_that_utm_does_not_read_are_told() {
    let cases = [
        (
            Header(
                "<geoReference>+proj=utm +zone=33 +datum=WGS84 +x_0=-182182 +y_0=-5705914</geoReference>",
            ),
            "no effect with +proj=utm, which has its own: +x_0=-182182 +y_0=-5705914",
        ),
        (
            Header("<geoReference>+proj=utm +zone=33 +datum=WGS84 +k=1 +lon_0=9</geoReference>"),
            "+lon_0=9 +k=1",
        ),
        (
            Header("<geoReference>+proj=utm +zone=33 +south +datum=WGS84 +y_0=0</geoReference>"),
            "+y_0=0",
        ),
        // Its own.
        (
            Header(
                "<geoReference>+proj=utm +zone=33 +datum=WGS84 +x_0=500000 +y_0=0 +k_0=0.9996 +lat_0=0 +lon_0=15</geoReference>",
            ),
            "",
        ),
        (Header("<geoReference>+proj=utm +zone=33 +datum=WGS84</geoReference>"), ""),
        (
            Header(
                "<geoReference>+proj=tmerc +lat_0=48 +lon_0=9 +x_0=5 +datum=WGS84</geoReference>",
            ),
            "",
        ),
    ];
    for (example, due) in cases {
        let found = told(example, REFERENCE);
        let about = |told: &&(Severity, String)| told.1.contains("no effect");
        let own: Vec<_> = found.iter().filter(about).collect();
        match &own[..] {
            [] => assert!(due.is_empty(), "{example:?}: {found:?}"),
            [(severity, message)] => {
                assert!(!due.is_empty() && message.contains(due), "{example:?}: {message}");
                assert_eq!(*severity, Severity::Warning);
            }
            _ => panic!("{example:?}: {found:?}"),
        }
    }
}

/// The standard allows changes across two solid lines that do not say otherwise.
#[test]
fn two_solid_lines_without_a_lane_change_are_told() {
    let cases = [
        (
            Example::Lane(r#"<roadMark sOffset="0" type="solid solid" color="white"/>"#),
            "--marks type",
        ),
        (
            Example::Lane(
                r#"<roadMark sOffset="0" type="solid solid" color="white" laneChange="both"/>"#,
            ),
            "",
        ),
        (Example::Lane(r#"<roadMark sOffset="0" type="solid" color="white"/>"#), ""),
        (
            Example::Section(
                r#"<center><lane id="0" type="none"><roadMark sOffset="0" type="solid solid" color="white"/></lane></center>"#,
            ),
            "--marks type",
        ),
    ];
    check(&cases, UNSAID, Severity::Info);
}
