//! A fault takes out no more than cannot be used for it: a lane link alone, a record out of order nothing, an object not for a
//! name that it lacks.

use mapd_archive::{AlignedBytes, Provenance, encode, verify};
use mapd_compiler::Verdict::{self, Accepted, Quarantined};
use mapd_compiler::{Compilation, CompileOptions, OnError, Policy, ReadOptions, compile_from};
use mapd_rules::{Grade, Profile, Settings};
use mapd_tests::graph_maps::{self as graph, Line};
use mapd_tests::object_maps::{ObjectRoad, PLAIN, document};
use mapd_xodr::Severity;

fn compile(text: &str) -> Compilation {
    compile_without(text, &[])
}

/// With these rules switched off.
fn compile_without(text: &str, off: &[&str]) -> Compilation {
    let grades = off.iter().map(|rule| (Box::from(*rule), Grade::Off)).collect();
    let rules = Settings { grades, ..Settings::default() };
    let reading = ReadOptions { rules, ..ReadOptions::default() };
    let options = CompileOptions::default();
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

/// The archive, proven, as if it were made of one document whatever the input was.
fn archive(compiled: &Compilation) -> AlignedBytes {
    let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let provenance = Provenance { input_hash: [0; 32], ..compiled.provenance };
    let bytes = encode(rows, &provenance).expect("encodes");
    verify(&bytes).expect("verifies");
    bytes
}

/// The severities of a rule's findings, by name.
fn told(compiled: &Compilation, rule: &str) -> Vec<String> {
    let of_rule = compiled.diagnostics.iter().filter(|told| told.finding.rule == rule);
    of_rule.map(|told| format!("{:?}", told.finding.severity)).collect()
}

/// What becomes of a map: the verdict, and the parts that are lost, by name.
fn check(what: &str, compiled: &Compilation, verdict: Verdict, lost: &[&str]) {
    let parts: Vec<String> = compiled.quarantined.iter().map(|part| part.name()).collect();
    assert_eq!(
        (compiled.verdict, parts),
        (verdict, lost.iter().map(|l| l.to_string()).collect()),
        "{what}: {:?}",
        compiled.diagnostics
    );
}

/// A road of two lanes into a junction, whose connecting road has two lanes, with these lane links.
fn fork(links: &str) -> String {
    let lanes = |links: &str| graph::lane(-1, links) + &graph::lane(-2, links);
    let section = |lanes: String| graph::section(0.0, "", &lanes);
    let line = |x: f64| Line(x, 0.0, 0.0, 50.0, 0.0);
    let ends = graph::link("p road 1 end");
    let attributes = r#"id="c" incomingRoad="1" connectingRoad="2" contactPoint="start""#;
    graph::document(
        &(graph::road(
            "1",
            "junction=\"-1\"",
            line(0.0),
            &graph::link("s junction 9"),
            &section(lanes("")),
        ) + &graph::road("2", "junction=\"9\"", line(50.0), &ends, &section(lanes("")))
            + &graph::junction("9", "", &graph::connection(attributes, links))),
    )
}

#[test]
fn a_bad_lane_link_is_left_out_alone() {
    check("sound", &compile(&fork("-1>-1 -2>-2")), Accepted, &[]);
    for (what, links, lost) in [
        ("a lane that is not there", "-1>-1 -2>-7", "laneLink c:-2:-7 of junction 9"),
        ("a number that is none", "-1>-1 -2>two", "laneLink c:-2:? of junction 9"),
        // Without any, the connection would join lanes of equal numbers, which it does not say.
        ("the only one", "-1>-7", "connection c of junction 9"),
    ] {
        let compiled = compile(&fork(links));
        check(what, &compiled, Quarantined, &[lost]);
        let snapshot = mapd_client::Snapshot::from_bytes(archive(&compiled)).expect("opens");
        let map = snapshot.map();
        let lane =
            map.road_by_id("1").and_then(|road| road.section(0)?.lane(-1)).expect("is there");
        let goes_on = lane.successors().count() == 1;
        assert_eq!(goes_on, lost.starts_with("laneLink"), "{what}");
        let kind = map.quarantined().next().map(|part| part.kind().name());
        assert_eq!(kind, lost.split(' ').next(), "{what}");
    }
}

#[test]
fn a_lanes_own_link_to_nothing_takes_nothing_out() {
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let sections = graph::section(0.0, "", &graph::lane(-1, "s-5"))
        + &graph::section(50.0, "", &graph::lane(-1, ""));
    let compiled =
        compile(&graph::document(&graph::road("1", "junction=\"-1\"", line, "", &sections)));
    check("a link to a lane that is not there", &compiled, Accepted, &[]);
    assert_eq!(told(&compiled, "mapd:graph.missing_lane"), ["Warning"]);
}

/// The lane graph is begun beside the rules on the network. What it finds in a map that they reject may follow from what is wrong.
#[test]
fn the_lane_graph_of_a_map_that_rules_reject_says_nothing() {
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let sections = graph::section(0.0, "", &graph::lane(-1, "s-5"))
        + &graph::section(50.0, "", &graph::lane(-1, ""));
    let road = graph::road("1", "junction=\"-1\"", line, "", &sections);
    let policy = Policy { on_error: OnError::Reject, ..Policy::default() };
    let reading = ReadOptions { policy, ..ReadOptions::default() };
    for (roads, verdict, named) in
        [(road.clone(), Accepted, vec!["Warning"]), (road.repeat(2), Verdict::Rejected, vec![])]
    {
        let text = graph::document(&roads);
        let options = CompileOptions::default();
        let open = || Ok(text.as_bytes());
        let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
        check("roads of one id", &compiled, verdict, &[]);
        assert_eq!(told(&compiled, "mapd:graph.missing_lane"), named);
    }
}

/// A road of 100 m with these elements in the road, in lane 0 and in lane −1.
fn with_records(road: &str, center: &str, lane: &str) -> String {
    let width = if lane.contains("<width") || lane.contains("<border") {
        ""
    } else {
        r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#
    };
    let lanes = format!(
        r#"<laneSection s="0"><center><lane id="0">{center}</lane></center><right><lane id="-1" type="driving">{width}{lane}</lane></right></laneSection></lanes>"#
    );
    let lanes = match road.split_once("<lanes>") {
        Some((before, after)) => format!("{before}<lanes>{after}{lanes}"),
        None => format!("{road}<lanes>{lanes}"),
    };
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="100" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>{lanes}</road></OpenDRIVE>"#
    )
}

/// Where records stand.
#[derive(Clone, Copy, PartialEq)]
enum At {
    Road(&'static str, &'static str),
    Center,
    Lane,
}

/// The kind of record, the rule on its order, where it stands, and two records in order.
type Records = (&'static str, At, [&'static str; 2]);

#[rustfmt::skip]
const RECORDS: &[Records] = &[
    ("road.elevation", At::Road("<elevationProfile>", "</elevationProfile>"), [r#"<elevation s="0" a="1" b="0" c="0" d="0"/>"#, r#"<elevation s="50" a="2" b="0" c="0" d="0"/>"#]),
    ("road.superelevation", At::Road("<lateralProfile>", "</lateralProfile>"), [r#"<superelevation s="0" a="0" b="0" c="0" d="0"/>"#, r#"<superelevation s="50" a="0.1" b="0" c="0" d="0"/>"#]),
    ("road.shape", At::Road("<lateralProfile>", "</lateralProfile>"), [r#"<shape s="0" t="0" a="0" b="0.1" c="0" d="0"/>"#, r#"<shape s="50" t="0" a="1" b="0" c="0" d="0"/>"#]),
    ("road.type", At::Road("", ""), [r#"<type s="0" type="town"/>"#, r#"<type s="50" type="rural"/>"#]),
    ("road.lanes.lane_offset", At::Road("<lanes>", ""), [r#"<laneOffset s="0" a="0" b="0" c="0" d="0"/>"#, r#"<laneOffset s="50" a="1" b="0" c="0" d="0"/>"#]),
    ("road.lane.width", At::Lane, [r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#, r#"<width sOffset="50" a="4" b="0" c="0" d="0"/>"#]),
    ("road.lane.border", At::Lane, [r#"<border sOffset="0" a="-3" b="0" c="0" d="0"/>"#, r#"<border sOffset="50" a="-4" b="0" c="0" d="0"/>"#]),
    ("road.lane.height", At::Lane, [r#"<height sOffset="0" inner="0" outer="0.1"/>"#, r#"<height sOffset="50" inner="0.1" outer="0.2"/>"#]),
    ("road.lane.material", At::Lane, [r#"<material sOffset="0" friction="0.8"/>"#, r#"<material sOffset="50" friction="0.4"/>"#]),
    ("road.lane.speed", At::Lane, [r#"<speed sOffset="0" max="50" unit="km/h"/>"#, r#"<speed sOffset="50" max="30" unit="km/h"/>"#]),
    ("road.lane.access", At::Lane, [r#"<access sOffset="0" rule="deny"><restriction type="bus"/></access>"#, r#"<access sOffset="50" rule="deny"><restriction type="truck"/></access>"#]),
    ("road.lane.rule", At::Lane, [r#"<rule sOffset="0" value="no stopping at any time"/>"#, r#"<rule sOffset="50" value="disabled parking"/>"#]),
    ("road.lane.road_mark", At::Lane, [r#"<roadMark sOffset="0" type="solid" color="white" laneChange="none"/>"#, r#"<roadMark sOffset="50" type="broken" color="white"/>"#]),
    ("road.lane.road_mark", At::Center, [r#"<roadMark sOffset="0" type="solid" color="white" laneChange="none"/>"#, r#"<roadMark sOffset="50" type="broken" color="white"/>"#]),
];

#[test]
fn records_out_of_order_are_sorted_and_said() {
    for (name, at, [first, second]) in RECORDS {
        let text = |records: &str| match at {
            At::Road(open, close) => with_records(&format!("{open}{records}{close}"), "", ""),
            At::Center => with_records("", records, ""),
            At::Lane => with_records("", "", records),
        };
        let rule = format!("asam.net:xodr:1.4.0:{name}.elem_asc_order");
        let sound = compile(&text(&format!("{first}{second}")));
        check(&rule, &sound, Accepted, &[]);
        assert_eq!(told(&sound, &rule), [""; 0], "{rule}");
        // Far out of order, and by a rounding.
        let fallen = compile(&text(&format!("{second}{first}")));
        check(&rule, &fallen, Accepted, &[]);
        assert_eq!(told(&fallen, &rule), ["Warning"], "{rule}");
        assert!(
            archive(&fallen)[..] == archive(&sound)[..],
            "{rule}: another map than that in order"
        );
        let near = first.replace("=\"0\"", "=\"49.999999\"");
        let near = compile(&text(&format!("{first}{second}{near}")));
        check(&rule, &near, Accepted, &[]);
        assert_eq!(told(&near, &rule), ["Warning"], "{rule}");
    }
}

/// Geometries in any order are one line if each begins where the one before it in s ends; else nobody knows which one it continues.
#[test]
fn geometries_out_of_order_are_sorted_if_they_are_one_line() {
    const RULE: &str = "asam.net:xodr:1.4.0:road.geometry.elem_asc_order";
    let section = |s: f64| {
        format!(
            r#"<laneSection s="{s}"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>"#
        )
    };
    let map = |geometries: &[&str], sections: [f64; 2], rule: &str| {
        let road = |id: u32, geometries: &str, sections: &str| {
            format!(
                r#"<road id="{id}" length="100" junction="-1"{rule}><planView>{geometries}</planView><lanes>{sections}</lanes></road>"#
            )
        };
        let other = r#"<geometry s="0" x="0" y="99" hdg="0" length="100"><line/></geometry>"#;
        format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/>{}{}</OpenDRIVE>"#,
            road(1, &geometries.concat(), &sections.map(section).concat()),
            road(2, other, &section(0.0))
        )
    };
    const A: &str = r#"<geometry s="0" x="0" y="0" hdg="0" length="40"><line/></geometry>"#;
    const B: &str =
        r#"<geometry s="40" x="40" y="0" hdg="0" length="20"><arc curvature="0.02"/></geometry>"#;
    // Where the arc ends: its turn is 0.4 rad.
    const C: &str =
        r#"<geometry s="60" x="59.4709171" y="3.9469503" hdg="0.4" length="40"><line/></geometry>"#;
    let order = [0.0, 50.0];
    let sound = compile(&map(&[A, B, C], order, ""));
    check("in order", &sound, Accepted, &[]);
    assert_eq!(told(&sound, RULE), [""; 0]);
    for traffic in ["", " rule=\"LHT\""] {
        let sound = compile(&map(&[A, B, C], order, traffic));
        for geometries in [[C, A, B], [B, A, C], [C, B, A]] {
            let compiled = compile(&map(&geometries, order, traffic));
            check("one line", &compiled, Accepted, &[]);
            let of_line = compiled.counts.iter().filter(|(severity, rule, _)| {
                *severity > Severity::Info && rule.contains("geometry")
            });
            assert!(of_line.into_iter().all(|(_, rule, _)| rule == RULE), "{geometries:?}");
            assert!(told(&compiled, RULE).iter().all(|severity| severity == "Warning"));
            assert!(!told(&compiled, RULE).is_empty());
            assert!(archive(&compiled)[..] == archive(&sound)[..], "another map");
        }
    }
    for (what, from, to) in [
        ("a gap", "y=\"3.9469503\"", "y=\"3.96\""),
        ("a kink", "hdg=\"0.4\"", "hdg=\"0.402\""),
        ("a gap along s", "s=\"60\"", "s=\"60.01\""),
        ("twice the same s", "s=\"60\"", "s=\"40\""),
        ("no curve", "<line/>", "<arc curvature=\"1e300\"/>"),
    ] {
        assert!(C.contains(from), "{what}");
        let compiled = compile(&map(&[&C.replace(from, to), A, B], order, ""));
        check(what, &compiled, Quarantined, &["road 1"]);
        assert!(told(&compiled, RULE).contains(&"Error".to_owned()), "{what}");
    }
    for profile in [Profile::Strict, Profile::Asam] {
        let reading = ReadOptions {
            rules: Settings { profile, ..Settings::default() },
            ..ReadOptions::default()
        };
        let (text, options) = (map(&[B, A, C], order, ""), CompileOptions::default());
        let open = || Ok(text.as_bytes());
        let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
        assert_eq!(told(&compiled, RULE), ["Error"], "{profile:?}");
        assert!(compiled.quarantined.iter().any(|part| part.name() == "road 1"), "{profile:?}");
    }
    check("sections", &compile(&map(&[A, B, C], [50.0, 0.0], "")), Quarantined, &["road 1"]);
}

#[test]
fn a_missing_name_takes_no_object_or_signal_out() {
    const OBJECT: &str = r#"<object id="1" type="pole" s="30" t="4" zOffset="0" length="2" width="2" height="3" orientation="none"><outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/><cornerLocal id="1" u="-1" v="1" z="0" height="1"/><cornerLocal id="2" u="0" v="-1" z="0" height="1"/></outline></outlines><material friction="0.5"/></object><objectReference id="1" s="5" t="0" orientation="none"/>"#;
    const SIGNAL: &str = r#"<signal id="s" s="20" t="-7" zOffset="2" orientation="+" dynamic="no" country="OpenDRIVE" type="206" subtype="-1"/>"#;
    for (what, from, to, lost) in [
        ("sound", "<object id", "<object id", None),
        ("id of a corner", r#"<cornerLocal id="1""#, "<cornerLocal", None),
        ("id of a corner that is none", r#"<cornerLocal id="1""#, r#"<cornerLocal id="b""#, None),
        ("id of an outline", r#"<outline id="0">"#, "<outline>", None),
        ("id of an object", r#"<object id="1""#, "<object", None),
        ("id of a signal", r#"<signal id="s""#, "<signal", None),
        ("friction", r#"friction="0.5""#, r#"friction="icy""#, None),
        (
            "object that is referred to",
            r#"<objectReference id="1""#,
            "<objectReference",
            Some("object  of road 1"),
        ),
        ("place", r#"s="30""#, "", Some("object 1 of road 1")),
        ("corner", r#"u="-1""#, r#"u="left""#, Some("object 1 of road 1")),
    ] {
        for version in ["1.5", "1.8"] {
            let text = document(&ObjectRoad { version, ..PLAIN }, OBJECT)
                .replace("</objects>", &format!("</objects><signals>{SIGNAL}</signals>"));
            assert!(text.contains(from), "{what}");
            let compiled = compile(&text.replacen(from, to, 1));
            let verdict = if lost.is_some() { Quarantined } else { Accepted };
            check(what, &compiled, verdict, lost.as_slice());
            let rows = compiled.rows.as_ref().expect("there is a map");
            let there = if lost.is_some_and(|lost| lost.starts_with("object 1")) { 0 } else { 1 };
            assert_eq!((rows.objects.len(), rows.signals.len()), (there, 1), "{what}");
            archive(&compiled);
        }
    }
}

/// The object was lost, with two findings, of which one said that the repetition alone is.
#[test]
fn a_repetition_without_its_place_leaves_the_object_alone() {
    const REPEAT: [(&str, &str); 9] = [
        ("s", "20"),
        ("length", "36"),
        ("distance", "4"),
        ("tStart", "-3.4"),
        ("tEnd", "-0.1"),
        ("heightStart", "0.5"),
        ("heightEnd", "0.5"),
        ("zOffsetStart", "0"),
        ("zOffsetEnd", "0"),
    ];
    let object = |written: &dyn Fn(&str) -> Option<String>| {
        let repeat: String = REPEAT
            .iter()
            .filter_map(|(name, value)| {
                let value = written(name).unwrap_or_else(|| (*value).to_owned());
                (value != "-").then(|| format!(" {name}=\"{value}\""))
            })
            .collect();
        format!(
            r#"<object id="1" type="obstacle" s="50" t="-3.4" zOffset="0" orientation="-" height="0.5" radius="0.35"><repeat{repeat}/></object>"#
        )
    };
    let sound = |version| document(&ObjectRoad { version, ..PLAIN }, &object(&|_| None));
    for version in ["1.4", "1.5", "1.7", "1.9"] {
        let warnings = |compiled: &Compilation| compiled.counts.of(Severity::Warning);
        let due = warnings(&compile(&sound(version)));
        for (missing, _) in REPEAT {
            for value in ["-", ""] {
                let object = object(&|name| (name == missing).then(|| value.to_owned()));
                let compiled = compile(&document(&ObjectRoad { version, ..PLAIN }, &object));
                let what = format!("{version} {missing}={value:?}");
                check(&what, &compiled, Accepted, &[]);
                let rows = compiled.rows.as_ref().expect("there is a map");
                let is_alone = ["s", "length", "distance"].contains(&missing);
                let copies = if is_alone { 0 } else { 10 };
                assert_eq!((rows.objects.len(), rows.object_copies.len()), (1, copies), "{what}");
                // In 1.4 nothing is required.
                let more = if is_alone { 1..=1 } else { 0..=1 };
                let more_found = warnings(&compiled) - due;
                assert!(more.contains(&more_found), "{what}: {:?}", compiled.diagnostics);
                archive(&compiled);
            }
        }
    }
}

#[test]
fn a_geometry_with_two_shapes_is_an_error() {
    let geometry = |shapes: &str| {
        document(&ObjectRoad { geometry: shapes, ..PLAIN }, "")
            .replace("</OpenDRIVE>", r#"<road id="2" length="9"><planView><geometry s="0" x="0" y="99" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road></OpenDRIVE>"#)
    };
    check("one", &compile(&geometry(r#"<arc curvature="0.01"/>"#)), Accepted, &[]);
    for shapes in [
        r#"<arc curvature="0.01"/><spiral curvStart="0" curvEnd="0.02"/>"#,
        r#"<line/><arc curvature="0.01"/>"#,
        r#"<line/><spiral curvStart="0" curvEnd="0.02"/><arc curvature="0.01"/>"#,
    ] {
        let compiled = compile(&geometry(shapes));
        check(shapes, &compiled, Quarantined, &["road 1"]);
        assert_eq!(told(&compiled, "mapd:structure.choice"), ["Error"], "{shapes}");
    }
}

#[test]
fn an_id_twice_is_said_once_and_not_where_its_rule_is_off() {
    let line = |y: f64| Line(0.0, y, 0.0, 50.0, 0.0);
    let road = |id: &str, y: f64, lanes: &str| {
        graph::road(id, "junction=\"-1\"", line(y), "", &graph::section(0.0, "", lanes))
    };
    let one = graph::lane(-1, "");
    let lanes = one.clone() + &graph::wide(-1, "", "", "a=\"9\" b=\"0\" c=\"0\" d=\"0\"", "");
    const IN_SECTION: &str = "asam.net:xodr:1.4.0:ids.id_unique_in_lane_section";
    const IN_CLASS: &str = "asam.net:xodr:1.4.0:ids.id_unique_in_class";
    let apart = road("9", 90.0, &one);
    for (what, map, rule, lost) in [
        ("lane", road("1", 0.0, &lanes), IN_SECTION, &["road 1"][..]),
        ("road", road("1", 0.0, &one) + &road("1", 30.0, &one), IN_CLASS, &["road 1", "road 1"]),
        (
            "junction",
            graph::junction("5", "", "") + &graph::junction("5", "", ""),
            IN_CLASS,
            &["junction 5"],
        ),
    ] {
        let text = graph::document(&(map + &apart));
        let compiled = compile(&text);
        check(what, &compiled, Quarantined, lost);
        let errors = compiled.diagnostics.iter().filter(|told| told.rejects);
        let rules: Vec<_> = errors.map(|told| told.finding.rule).collect();
        assert_eq!(rules, vec![rule; lost.len()], "{what}");
        let compiled = compile_without(&text, &[rule]);
        check(what, &compiled, Accepted, &[]);
        assert_eq!(told(&compiled, rule), [""; 0], "{what}");
        archive(&compiled);
    }
    // Of lanes with one id, the first is meant.
    let compiled = compile_without(&graph::document(&road("1", 0.0, &lanes)), &[IN_SECTION]);
    let snapshot = mapd_client::Snapshot::from_bytes(archive(&compiled)).expect("opens");
    let road = snapshot.map().road_by_id("1").expect("is there");
    let section = road.section(0).expect("is there");
    assert_eq!(section.lanes().filter(|lane| lane.number() == -1).count(), 1);
}

/// What cannot be read counted as 0, and rules told of what followed: a road shorter than its geometries, objects beyond its end.
#[test]
fn what_cannot_be_read_is_told_once() {
    let sound = document(
        &ObjectRoad { version: "1.7", ..PLAIN },
        r#"<object id="7" type="pole" s="30" t="4" zOffset="0" orientation="none" radius="0.1" height="1"><repeat s="20" length="10" distance="5" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#,
    );
    let tags: [(&str, &str); 4] =
        [("road", "length"), ("geometry", "length"), ("width", "a"), ("object", "t")];
    for (tag, attribute) in tags {
        for (value, rule) in [("abc", "mapd:value.type"), ("nan", "mapd:value.finite")] {
            let start = sound.find(&format!("<{tag} ")).expect("a tag");
            let from =
                start + sound[start..].find(&format!(" {attribute}=\"")).expect("an attribute");
            let from = from + attribute.len() + 3;
            let to = from + sound[from..].find('"').expect("an end");
            let text = format!("{}{value}{}", &sound[..from], &sound[to..]);
            let compiled = compile(&text);
            let mut rules: Vec<&str> =
                compiled.diagnostics.iter().map(|told| told.finding.rule).collect();
            // Of a map whose only road is left out, this is true.
            rules.retain(|rule| *rule != "mapd:compile.no_roads");
            assert_eq!(rules, [rule], "{tag}/@{attribute}: {:?}", compiled.diagnostics);
        }
    }
}
