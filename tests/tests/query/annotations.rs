//! What files say of their parts beyond what anything is built from: each arrives with its owner, its place and its text.

use mapd_compiler::{CompileOptions, Extra, ReadOptions, compile_from};
use mapd_query::vocabulary::{AnnotationKind, JunctionGroupKind};
use mapd_tests::annotated::{NESTED, document, road, roundabout};
use mapd_tests::object_maps::open;

/// One annotation: owner, kind, path, name, value, text.
type Expected<'a> = (&'a str, AnnotationKind, &'a str, &'a str, &'a str, &'a str);

/// All annotations of a document, in order.
fn check(text: &str, expected: &[Expected<'_>]) {
    let snapshot = open(text);
    let map = snapshot.map();
    let found: Vec<Expected<'_>> = map
        .annotations()
        .map(|a| (a.owner_kind().name(), a.kind(), a.path(), a.name(), a.value(), a.text()))
        .collect();
    assert_eq!(found, expected, "{text}");
}

use AnnotationKind::{Attribute, DataQuality, ForeignElement, Include, UnknownElement, UserData};

const PLAIN: &str = r#"<userData code="c" value="&lt;1&gt;"/>"#;

#[test]
fn a_map_that_says_nothing_besides_has_no_annotations() {
    check(&document(8, "", &road("1", 0.0, "", "", "")), &[]);
}

#[test]
fn user_data_belong_to_the_innermost_part_that_has_a_row() {
    let one = |at: &str, path: &str| {
        let plain = PLAIN.to_owned();
        let (mut header, mut inside, mut lane, mut root) = Default::default();
        match at {
            "header" => header = plain,
            "document" => root = plain,
            "lane" => lane = plain,
            "signal" => {
                inside = format!(
                    r#"<signals><signal id="s" s="1" t="1" zOffset="0" type="-1" subtype="-1" orientation="+" dynamic="no" value="1">{plain}</signal></signals>"#
                )
            }
            "object" => {
                inside = format!(
                    r#"<objects><object id="o" s="1" t="1" zOffset="0" orientation="none" type="tree">{plain}</object></objects>"#
                )
            }
            _ => inside = plain,
        }
        let text = document(5, &header, &format!("{}{root}", road("1", 0.0, "", &inside, &lane)));
        let owner = if at == "header" { "document" } else { at };
        check(&text, &[(owner, UserData, path, "c", "<1>", "")]);
    };
    one("document", "");
    one("header", "header");
    one("road", "");
    one("lane", "");
    one("signal", "");
    one("object", "");
}

#[test]
fn what_stands_inside_user_data_is_text() {
    let text = document(5, "", &road("1", 0.0, "", NESTED, ""));
    check(&text, &[("road", UserData, "", "vendor", "v", r#"<a b="1"><c/></a>"#)]);
}

#[test]
fn parts_without_rows_are_named_by_their_path() {
    let width =
        r#"<width sOffset="5" a="3" b="0" c="0" d="0"><userData code="w" value="2"/></width>"#;
    let text = document(5, "", &road("1", 0.0, "", "", width));
    check(&text, &[("lane", UserData, "width[2]", "w", "2", "")]);
    let junction = r#"<junction id="j" name=""><userData code="j" value=""/><connection id="c" incomingRoad="1" connectingRoad="2" contactPoint="start"><userData code="c" value=""/><laneLink from="-1" to="-1"><userData code="l" value=""/></laneLink></connection></junction>"#;
    let roads = road("1", 0.0, "", "", "") + &road("2", 9.0, "junction=\"j\"", "", "");
    check(
        &document(5, "", &(roads + junction)),
        &[
            ("junction", UserData, "", "j", "", ""),
            ("connection", UserData, "", "c", "", ""),
            ("connection", UserData, "laneLink[1]", "l", "", ""),
        ],
    );
}

#[test]
fn quality_of_data_is_kept_value_by_value() {
    let quality = r#"<dataQuality><error xyAbsolute="0.1" zAbsolute="0.2" xyRelative="0.3" zRelative="0.4"/></dataQuality>"#;
    let value = |name, value| ("road", DataQuality, "dataQuality/error", name, value, "");
    check(
        &document(8, "", &road("1", 0.0, "", quality, "")),
        &[
            value("xyAbsolute", "0.1"),
            value("zAbsolute", "0.2"),
            value("xyRelative", "0.3"),
            value("zRelative", "0.4"),
            ("road", DataQuality, "", "dataQuality", "", quality),
        ],
    );
}

#[test]
fn elements_that_the_standard_does_not_have_are_text() {
    let odd = r#"<oddity at="1"><deeper/></oddity>"#;
    check(
        &document(8, "", &road("1", 0.0, "", odd, "")),
        &[("road", UnknownElement, "", "oddity", "", odd)],
    );
    let foreign = r#"<x:oddity xmlns:x="http://example.com/x" at="1"/>"#;
    check(
        &document(8, "", &road("1", 0.0, "", foreign, "")),
        &[("road", ForeignElement, "", "x:oddity", "", foreign)],
    );
}

#[test]
fn attributes_that_nothing_is_built_from_are_kept() {
    let license = r#"<license name="CC-BY" spdxid="CC-BY-4.0" text="t" resource="r"/>"#;
    let of = |name, value| ("document", Attribute, "header/license", name, value, "");
    check(
        &document(8, license, &road("1", 0.0, "", "", "")),
        &[of("name", "CC-BY"), of("spdxid", "CC-BY-4.0"), of("text", "t"), of("resource", "r")],
    );
}

#[test]
fn lanes_say_how_far_one_sees_and_rules_in_words() {
    let records = r#"<visibility sOffset="0" forward="50" back="40" left="30" right="0"/><visibility sOffset="4" forward="5" back="4" left="3" right="2"/><rule sOffset="2" value="no stopping at any time"/>"#;
    let snapshot = open(&document(5, "", &road("1", 0.0, "", "", records)));
    let road = snapshot.map().road_by_id("1").expect("the road");
    let lane = road.section(0).expect("a section").lane(-1).expect("the lane");
    let seen = |s| {
        let seen = lane.visibility_at(s).expect("a record");
        [seen.forward, seen.back, seen.left, seen.right].map(|distance| distance.expect("given"))
    };
    assert_eq!(seen(0.0), [50.0, 40.0, 30.0, 0.0]);
    assert_eq!(seen(4.0), [5.0, 4.0, 3.0, 2.0]);
    assert_eq!(lane.visibilities().len(), 2);
    assert!(lane.rule_at(1.9).is_none());
    assert_eq!(lane.rule_at(9.0).expect("a rule").value, "no stopping at any time");
    assert_eq!(snapshot.map().annotations().len(), 0);
}

#[test]
fn a_roundabout_knows_its_junctions_and_the_lanes_of_its_ring() {
    let group = |kind: &str| {
        format!(
            r#"<junctionGroup id="g" name="Kreisel" type="{kind}"><junctionReference junction="A"/><junctionReference junction="B"/><junctionReference junction="Z"/></junctionGroup>"#
        )
    };
    let ring = |kind: &str| {
        let snapshot = open(&roundabout(&group(kind)));
        let map = snapshot.map();
        let group = map.junction_by_id("B").expect("B").group().expect("its group");
        assert_eq!((group.id(), group.name(), group.kind().name()), ("g", "Kreisel", kind));
        let members: Vec<_> = group.members().map(|m| (m.id(), m.junction().is_some())).collect();
        assert_eq!(members, [("A", true), ("B", true), ("Z", false)]);
        let key = |lane| map.lane(lane).expect("a lane").key().to_string();
        group.ring().map(key).collect::<Vec<_>>()
    };
    assert_eq!(
        ring(JunctionGroupKind::Roundabout.name()),
        ["1:0:-1", "2:0:-1", "3:0:-1", "4:0:-1"]
    );
    assert_eq!(ring("complexJunction"), [""; 0]);
    let snapshot = open(&roundabout(""));
    assert!(snapshot.map().junction_by_id("B").expect("B").group().is_none());
}

/// A map that says something of each kind.
fn everything() -> String {
    let records = r#"<visibility sOffset="0" forward="50" back="40" left="30" right="20"/><rule sOffset="0" value="no stopping"/>"#;
    let group = r#"<junctionGroup id="g" name="" type="unknown"><junctionReference junction="j"/></junctionGroup>"#;
    let quality = r#"<dataQuality><error xyAbsolute="0.1" zAbsolute="0.2" xyRelative="0.3" zRelative="0.4"/></dataQuality>"#;
    let inside = format!(
        r#"{NESTED}{quality}<oddity/><surface><CRG file="f" sStart="0" sEnd="1" orientation="same" mode="attached"/></surface>"#
    );
    let roads: String =
        (0..20).map(|i| road(&i.to_string(), 9.0 * f64::from(i), "", &inside, records)).collect();
    document(5, "", &(roads + group))
}

#[test]
fn what_is_left_out_is_not_there_and_all_else_is() {
    let text = everything();
    let compile = |without: &[Extra], batch_bytes: Option<usize>| {
        let options = CompileOptions {
            without: without.iter().copied().collect(),
            ..CompileOptions::default()
        };
        let reading = ReadOptions { batch_bytes, ..ReadOptions::default() };
        let threads = if batch_bytes.is_some() { 3 } else { 1 };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let compiled = pool.install(|| {
            compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reads")
        });
        let rows = compiled.rows.expect("accepted");
        mapd_archive::encode(&rows, &compiled.provenance).expect("encodes").to_vec()
    };
    let whole = compile(&[], None);
    // Lowered in parts, owners are the same.
    assert!(compile(&[], Some(1)) == whole, "other bytes in batches");
    let counts = |bytes: &[u8]| {
        let archive = mapd_archive::verify(bytes).expect("proves");
        let t = archive.tables;
        let of = |kind: AnnotationKind| {
            t.all_annotations().filter(|a| a.row.kind() == kind.code()).count()
        };
        [
            of(UserData),
            of(DataQuality),
            of(Include),
            of(UnknownElement) + of(ForeignElement),
            of(Attribute),
            t.lane_visibilities.len(),
            t.lane_rules.len(),
            t.junction_groups.len() + t.junction_group_members.len(),
        ]
    };
    let all = counts(&whole);
    assert_eq!(all, [20, 100, 0, 20, 100, 20, 20, 2]);
    for extra in Extra::ALL {
        let found = counts(&compile(&[*extra], None));
        let mut expected = all;
        expected[*extra as usize] = 0;
        assert_eq!(found, expected, "{}", extra.name());
    }
    let bare = compile(Extra::ALL, None);
    let inside = bare.windows(7).any(|bytes| bytes == b"xyAbsol" || bytes == b"no stop");
    assert!(!inside, "texts of what is left out are in the archive");
}

#[test]
fn parts_of_an_included_file_say_so() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("parts")).expect("a folder");
    let part = folder.path().join("parts/more.xml");
    let inside = road("2", 9.0, "", PLAIN, "");
    std::fs::write(part, format!("<OpenDRIVE>{inside}</OpenDRIVE>")).expect("written");
    let text =
        document(5, "", &(road("1", 0.0, "", "", "") + "<include file=\"parts/more.xml\"/>"));
    let reading =
        ReadOptions { include_folder: Some(folder.path().to_owned()), ..ReadOptions::default() };
    let options = CompileOptions::default();
    let compiled =
        compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reads");
    let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).expect("proves");
    let snapshot = mapd_client::Snapshot::from_bytes(archive).expect("opens");
    let map = snapshot.map();
    let files: Vec<_> =
        map.included_files().map(|file| (file.name(), file.source_position())).collect();
    assert_eq!(files.len(), 1);
    assert_eq!(files[0].0, "parts/more.xml");
    let of = |id: &str| map.road_by_id(id).expect("a road").annotations();
    assert_eq!(of("1").len(), 0);
    let found: Vec<_> = of("2").map(|a| (a.kind(), a.name(), a.file().map(|f| f.name()))).collect();
    let file = Some("parts/more.xml");
    assert_eq!(
        found,
        [(AnnotationKind::SourceFile, "parts/more.xml", file), (UserData, "c", file)]
    );
}
