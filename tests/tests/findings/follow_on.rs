//! What is missing is said once: no other finding takes it for 0, or for what nobody wrote.

use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};
use mapd_rules::Example::{self, Junction, Lanes, Objects, PlanView};
use mapd_xodr::{Severity, rule_ids};
use std::collections::BTreeSet;

fn compiled(text: &[u8]) -> Compilation {
    compile_from(|| Ok(text), &ReadOptions::default(), &CompileOptions::default(), &mut |_| {})
        .expect("reading from memory works")
}

/// Rules of findings that are no information.
fn rules(compiled: &Compilation) -> BTreeSet<&'static str> {
    let told = compiled.counts.iter().filter(|(severity, ..)| *severity > Severity::Info);
    told.map(|(_, rule, _)| rule).collect()
}

/// "A spiral whose curvature changes, found 0 at both ends" was said of one without curvatures.
#[test]
fn a_missing_number_is_not_zero() {
    const CASES: [Example; 10] = [
        PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><spiral/></geometry>"#),
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><spiral curvStart="0"/></geometry>"#,
        ),
        PlanView(r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><arc/></geometry>"#),
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry><geometry x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>"#,
        ),
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0"><line/></geometry><geometry s="50" x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry>"#,
        ),
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><paramPoly3 aU="0" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/></geometry>"#,
        ),
        Lanes(
            r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection><laneSection><center><lane id="0" type="none"/></center></laneSection>"#,
        ),
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none" radius="0.1"><repeat s="10" distance="5" tStart="4" tEnd="4" zOffsetStart="0" zOffsetEnd="0" heightStart="1" heightEnd="1"/></object>"#,
        ),
        Objects(r#"<bridge id="1" name="" s="90" type="concrete"/>"#),
        Junction(r#"<junction id="9" name="" type="virtual" mainRoad="1" orientation="+"/>"#),
    ];
    for case in CASES {
        let text = case.document(8).expect("a document");
        let compiled = compiled(text.as_bytes());
        let found = rules(&compiled);
        assert_eq!(found, [rule_ids::MISSING].into(), "{text}\n{:#?}", compiled.diagnostics);
    }
}

/// A file that is no map "has no roads".
#[test]
fn what_cannot_be_read_has_no_content_to_speak_of() {
    let gzip = [0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3];
    for (text, rule) in [
        (&b""[..], rule_ids::ROOT),
        (b"  \n", rule_ids::ROOT),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", rule_ids::ENCODING),
        (b"<?xml version=\"1.0\"?><osm version=\"0.6\"><node id=\"1\"/></osm>", rule_ids::ROOT),
        (b"{\"type\": \"FeatureCollection\"}", rule_ids::XML),
        (b"<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/>", rule_ids::XML),
        (&gzip, rule_ids::COMPRESSION),
    ] {
        let compiled = compiled(text);
        assert_eq!(rules(&compiled), [rule].into(), "{:#?}", compiled.diagnostics);
    }
    let none = compiled(b"<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/></OpenDRIVE>");
    assert!(rules(&none).contains("mapd:compile.no_roads"), "{:#?}", none.diagnostics);
    // Its road is there, and cannot be used.
    let text = PlanView("<geometry/>").document(8).expect("a document");
    let broken = compiled(text.as_bytes());
    assert!(!rules(&broken).contains("mapd:compile.no_roads"), "{:#?}", broken.diagnostics);
}
