//! One broken part of each kind: the map still loads, its neighbours answer, ways do not cross the hole, and answers near it
//! say so.

use mapd_archive::{encode, verify};
use mapd_client::{Map, NearestOptions, Snapshot};
use mapd_compiler::{
    Compilation, CompileOptions, OnError, Policy, ReadOptions, Treatment, Verdict, compile_from,
};
use mapd_query::Region;
use mapd_query::glam::DVec2;

/// Roads 1, 2 and 3 in a row along x, each 100 m long; 3 leads into junction 9, within which road 5 leads on to road 6.
const MAP: &str = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>
<road id="1" length="100" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="100" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/><successor elementType="road" elementId="3" contactPoint="start"/></link><planView><geometry s="0" x="100" y="0" hdg="0" length="50"><line/></geometry><geometry s="50" x="150" y="0" hdg="0" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a="0" b="0" c="0" d="0"/><elevation s="50" a="0" b="0.01" c="0" d="0"/></elevationProfile>
<lanes><laneOffset s="0" a="0" b="0" c="0" d="0"/><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="shoulder"><width sOffset="0" a="1" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
<objects><object id="o1" type="pole" s="50" t="4" zOffset="0" orientation="none"/></objects>
<signals><signal id="s1" s="40" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"/><signal id="s2" s="60" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"><dependency id="s1"/></signal></signals></road>
<road id="3" length="100" junction="-1"><link><predecessor elementType="road" elementId="2" contactPoint="end"/><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="200" y="0" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="5" length="20" junction="9"><link><predecessor elementType="road" elementId="3" contactPoint="end"/><successor elementType="road" elementId="6" contactPoint="start"/></link><planView><geometry s="0" x="300" y="0" hdg="0" length="20"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="6" length="100" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="320" y="0" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name=""><connection id="c0" incomingRoad="3" connectingRoad="5" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>
</OpenDRIVE>"#;

/// What is broken: a name, what is written, what is written instead, kind and id of each part that is lost.
type Case = (&'static str, &'static str, &'static str, &'static [(&'static str, &'static str)]);

const ROAD: &[(&str, &str)] = &[("road", "2")];

const CASES: [Case; 19] = [
    ("length", r#"<road id="2" length="100""#, r#"<road id="2" length="long""#, ROAD),
    ("length not finite", r#"<road id="2" length="100""#, r#"<road id="2" length="INF""#, ROAD),
    ("x", r#"x="100" y="0""#, r#"x="NaN" y="0""#, ROAD),
    ("heading", r#"x="150" y="0" hdg="0""#, r#"x="150" y="0" hdg="east""#, ROAD),
    (
        "no shape",
        r#"x="150" y="0" hdg="0" length="50"><line/>"#,
        r#"x="150" y="0" hdg="0" length="50">"#,
        ROAD,
    ),
    ("torn reference line", r#"x="150" y="0""#, r#"x="150" y="30""#, ROAD),
    ("turn at a point", r#"x="150" y="0" hdg="0""#, r#"x="150" y="0" hdg="2""#, ROAD),
    ("gap in s", r#"s="50" x="150""#, r#"s="60" x="150""#, ROAD),
    (
        "a curve that stands still",
        r#"x="150" y="0" hdg="0" length="50"><line/>"#,
        r#"x="150" y="0" hdg="0" length="50"><paramPoly3 aU="0" bU="0" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="normalized"/>"#,
        ROAD,
    ),
    (
        "two shapes",
        r#"x="150" y="0" hdg="0" length="50"><line/>"#,
        r#"x="150" y="0" hdg="0" length="50"><line/><arc curvature="0.01"/>"#,
        ROAD,
    ),
    ("elevation", r#"a="0" b="0.01""#, r#"a="0" b="0.0.1""#, ROAD),
    ("lane offset", r#"<laneOffset s="0" a="0""#, r#"<laneOffset s="0" a="""#, ROAD),
    ("section without s", r#"d="0"/><laneSection s="0">"#, r#"d="0"/><laneSection>"#, ROAD),
    ("lane id twice", r#"<lane id="-2""#, r#"<lane id="-1""#, ROAD),
    ("width", r#"<width sOffset="0" a="1""#, r#"<width sOffset="0" a="one""#, ROAD),
    ("road id twice", r#"<road id="6""#, r#"<road id="2""#, &[("road", "2"), ("road", "2")]),
    ("place of an object", r#"s="50" t="4""#, r#"s="50" t="4+2i""#, &[("object", "o1")]),
    ("signal without s", r#"<signal id="s1" s="40""#, r#"<signal id="s1""#, &[("signal", "s1")]),
    ("lane link", r#"<laneLink from="-1""#, r#"<laneLink from="one""#, &[("connection", "c0")]),
];

fn compiled(text: &str, policy: &Policy) -> Compilation {
    let reading = ReadOptions { policy: policy.clone(), ..ReadOptions::default() };
    let options = CompileOptions::default();
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

fn snapshot(compiled: &Compilation) -> Snapshot {
    let rows = compiled.rows.as_ref().expect("there is a map");
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    verify(&bytes).expect("verifies");
    Snapshot::from_bytes(bytes).expect("opens")
}

fn under(map: Map<'_>, x: f64) -> Option<String> {
    let options = NearestOptions { radius: 5.0, ..NearestOptions::default() };
    let hit = map.nearest_lane(DVec2::new(x, -1.5), &options).expect("finite")?;
    Some(map.lane(hit.lane).expect("own id").key().to_string())
}

#[test]
fn a_sound_map_has_no_holes() {
    let compiled = compiled(MAP, &Policy::default());
    assert_eq!(compiled.verdict, Verdict::Accepted, "{:?}", compiled.diagnostics);
    let snapshot = snapshot(&compiled);
    assert_eq!(snapshot.map().quarantined().len(), 0);
}

#[test]
fn one_broken_part_of_each_kind() {
    for (name, written, instead, lost) in CASES {
        assert_eq!(MAP.matches(written).count(), 1, "{name}: {written} must occur once");
        let text = MAP.replace(written, instead);
        let compiled = compiled(&text, &Policy::default());
        assert_eq!(compiled.verdict, Verdict::Quarantined, "{name}: {:#?}", compiled.diagnostics);
        let parts: Vec<(&str, &str)> =
            compiled.quarantined.iter().map(|part| (part.kind.name(), &*part.id)).collect();
        // Nothing else is lost with it.
        assert_eq!(parts, lost, "{name}");
        let snapshot = snapshot(&compiled);
        let map = snapshot.map();
        assert_eq!(map.quarantined().len(), parts.len(), "{name}");
        assert_eq!(map.quarantined().next().map(|part| part.id()), Some(parts[0].1), "{name}");
        // Neighbours answer.
        assert_eq!(under(map, 50.0).as_deref(), Some("1:0:-1"), "{name}");
        assert_eq!(under(map, 250.0).as_deref(), Some("3:0:-1"), "{name}");
        let is_gone = lost.contains(&("road", "2"));
        assert_eq!(under(map, 150.0).as_deref(), (!is_gone).then_some("2:0:-1"), "{name}");
        // Ways do not cross the hole.
        let before = map.road_by_id("1").and_then(|r| r.section(0)?.lane(-1)).expect("lane");
        assert_eq!(before.successors().count(), usize::from(!is_gone), "{name}");
        let into = map.road_by_id("3").and_then(|r| r.section(0)?.lane(-1)).expect("lane");
        let has_connection = !lost.contains(&("connection", "c0"));
        assert_eq!(into.successors().count(), usize::from(has_connection), "{name}");
        // A query near the hole reports it, where its place is known.
        if let Some(part) = map.quarantined().find(|part| part.extent().is_some()) {
            let Region { low: min, high: max } = part.extent().expect("known");
            let told =
                map.quarantined_near((min + max) / 2.0, 1.0).any(|near| near.id() == part.id());
            assert!(told, "{name}");
        }
        assert_eq!(map.quarantined_near(DVec2::new(0.0, 5000.0), 10.0).count(), 0, "{name}");
    }
}

#[test]
fn a_lane_with_more_points_than_the_index_can_name_takes_its_road_out() {
    // Forty rounds of 6 km, in millimetres.
    let long =
        MAP.replace(r#"<road id="6" length="100""#, r#"<road id="6" length="250000""#).replace(
            r#"x="320" y="0" hdg="0" length="100"><line/>"#,
            r#"x="320" y="0" hdg="0" length="250000"><arc curvature="0.001"/>"#,
        );
    let options = CompileOptions { index_tolerance: 0.001, ..CompileOptions::default() };
    let open = || Ok(long.as_bytes());
    let compiled = compile_from(open, &ReadOptions::default(), &options, &mut |_| {});
    let compiled = compiled.expect("reading works");
    assert_eq!(compiled.verdict, Verdict::Quarantined, "{:#?}", compiled.diagnostics);
    let lost: Vec<_> = compiled.quarantined.iter().map(|part| (part.name(), part.rule)).collect();
    assert_eq!(lost, [("road 6".to_owned(), "mapd:compile.too_large")]);
    assert!(compiled.quarantined[0].message.contains("lane -1 of road 6"));
}

/// Where a road or signal lies a thousand times farther than Neptune, all others are as they would be without.
#[test]
fn what_lies_too_far_away_takes_no_digits_of_the_rest() {
    let astray = |x: &str, y: &str| {
        format!(
            r#"<road id="7" length="100" junction="-1"><planView>
<geometry s="0" x="{x}" y="{y}" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        )
    };
    let with = |road: &str| MAP.replace("<junction", &format!("{road}<junction"));
    let sound = compiled(MAP, &Policy::default()).rows.expect("rows");
    let keep = Policy { on_error: OnError::ReferenceLine, ..Policy::default() };
    for (x, y) in [("1e15", "0"), ("0", "-1.1e9"), ("1e300", "1e300")] {
        for policy in [&Policy::default(), &keep] {
            let far = compiled(&with(&astray(x, y)), policy);
            let [part] = &far.quarantined[..] else { panic!("{x}, {y}: {:?}", far.quarantined) };
            assert_eq!((&*part.name(), part.treatment), ("road 7", Treatment::Dropped));
            assert_eq!((part.rule, part.line, part.column), ("mapd:compile.unusable", 15, 1));
            assert!(part.message.contains("1000000000 m, found"), "{}", part.message);
            let rows = far.rows.as_ref().expect("rows");
            assert!(rows.geometries.as_slice() == sound.geometries.as_slice(), "{x}, {y}");
            assert!(rows.points.as_slice() == sound.points.as_slice(), "{x}, {y}");
        }
    }
    assert_eq!(compiled(&with(&astray("1e9", "-1e9")), &keep).verdict, Verdict::Accepted);
    let stated = |x: &str| {
        let own =
            format!(r#"country="DE"><positionInertial x="{x}" y="0" z="0" hdg="0"/></signal>"#);
        MAP.replacen(r#"country="DE"/>"#, &own, 1).replace("revMinor=\"7\"", "revMinor=\"8\"")
    };
    let lost = |x: &str| {
        let parts = compiled(&stated(x), &Policy::default()).quarantined;
        parts.iter().map(|part| part.name()).collect::<Vec<_>>()
    };
    assert_eq!(lost("140"), [""; 0]);
    assert_eq!(lost("-1e10"), ["signal s1 of road 2"]);
}

#[test]
fn a_part_is_named_with_what_it_belongs_to() {
    for (written, instead, name) in [
        (r#"s="50" t="4""#, r#"s="50" t="4+2i""#, "object o1 of road 2"),
        (r#"<signal id="s1" s="40""#, r#"<signal id="s1""#, "signal s1 of road 2"),
        (r#"<laneLink from="-1""#, r#"<laneLink from="one""#, "connection c0 of junction 9"),
        (r#"<road id="2" length="100""#, r#"<road id="2" length="long""#, "road 2"),
    ] {
        let compiled = compiled(&MAP.replace(written, instead), &Policy::default());
        assert_eq!(compiled.quarantined[0].name(), name);
        let snapshot = snapshot(&compiled);
        let part = snapshot.map().quarantined().next().expect("it is listed");
        let (own, owner) = (&compiled.quarantined[0], part.owner_kind().name());
        assert_eq!((owner, part.owner()), (own.owner_kind.name(), &*own.owner), "{name}");
    }
}

#[test]
fn a_strict_profile_loses_no_more_than_what_is_wrong() {
    let rules = mapd_rules::Settings {
        profile: mapd_rules::Profile::Strict,
        ..mapd_rules::Settings::default()
    };
    let reading = ReadOptions { rules, ..ReadOptions::default() };
    let compiled = |text: &str| {
        let options = CompileOptions::default();
        compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reads")
    };
    let parts = |compiled: &Compilation| -> Vec<String> {
        compiled.quarantined.iter().map(|part| part.name()).collect()
    };
    // Without the step between roads 2 and 3.
    let level = MAP.replace(r#"b="0.01""#, r#"b="0""#);
    let sound = compiled(&level);
    assert_eq!(parts(&sound), [""; 0], "{:#?}", sound.diagnostics);
    // The neighbours' links lead to a road that is not there any more: that is not their fault.
    let broken = compiled(&level.replace(r#"<lane id="-2""#, r#"<lane id="-1""#));
    assert_eq!(parts(&broken), ["road 2"], "{:#?}", broken.diagnostics);
}

#[test]
fn a_policy_may_reject() {
    let text = MAP.replace(r#"<road id="2" length="100""#, r#"<road id="2" length="long""#);
    let reject = Policy { on_error: OnError::Reject, ..Policy::default() };
    assert_eq!(compiled(&text, &reject).verdict, Verdict::Rejected);
    let none = Policy { max_parts: Some(0), ..Policy::default() };
    assert_eq!(compiled(&text, &none).verdict, Verdict::Rejected);
    // 100 m of 420 m are lost where the length can be read.
    let torn = MAP.replace(r#"x="150" y="0""#, r#"x="150" y="30""#);
    for (share, verdict) in [(0.3, Verdict::Quarantined), (0.2, Verdict::Rejected)] {
        let policy = Policy { max_share: Some(share), ..Policy::default() };
        assert_eq!(compiled(&torn, &policy).verdict, verdict, "{share}");
    }
}

#[test]
fn a_road_may_stay_as_its_reference_line() {
    let policy = Policy { on_error: OnError::ReferenceLine, ..Policy::default() };
    let text = MAP.replace(r#"<lane id="-2""#, r#"<lane id="-1""#);
    let compiled = compiled(&text, &policy);
    assert_eq!(compiled.verdict, Verdict::Quarantined, "{:#?}", compiled.diagnostics);
    assert_eq!(compiled.quarantined[0].treatment, Treatment::ReferenceLine);
    // What was linked to its lanes stays as it is.
    assert_eq!(compiled.quarantined.len(), 1, "{:#?}", compiled.quarantined);
    let snapshot = snapshot(&compiled);
    let map = snapshot.map();
    assert!(map.quarantined().next().is_some_and(|part| part.is_reference_line()));
    let road = map.road_by_id("2").expect("its line stays");
    assert_eq!(road.length(), 100.0);
    assert!(road.successor().is_none() && road.predecessor().is_none());
    assert_eq!(
        road.sections().flat_map(|section| section.lanes()).filter(|l| l.number() != 0).count(),
        0
    );
    assert_eq!(under(map, 150.0), None);
}

#[test]
fn a_map_without_any_road_left_is_rejected_and_one_that_never_had_any_is_not() {
    let road =
        &MAP[MAP.find("<road id=\"1\"").expect("road")..MAP.find("<road id=\"2\"").expect("road")];
    let alone = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{road}</OpenDRIVE>");
    let broken = alone.replace(r#"length="100" junction"#, r#"length="" junction"#);
    assert_eq!(compiled(&broken, &Policy::default()).verdict, Verdict::Rejected);
    let empty = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/></OpenDRIVE>";
    assert_eq!(compiled(empty, &Policy::default()).verdict, Verdict::Accepted);
}
