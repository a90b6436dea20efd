//! What the command line says and does about a map that lost parts.

use mapd_tests::command;
use mapd_tests::graph_maps::*;
use std::path::{Path, PathBuf};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Standard output, standard error and exit code of a command.
fn run(args: &[&str], input: &str) -> (String, String, Option<i32>) {
    let output = command::run(MAPD, args, input);
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    (text(output.stdout), text(output.stderr), output.status.code())
}

/// Two roads side by side, 100 m long; along the second one an object and a signal.
fn two_roads() -> String {
    let one = |id: &str, y: f64| {
        let line = Line(0.0, y, 0.0, 100.0, 0.0);
        road(id, "junction=\"-1\"", line, "", &section(0.0, "", &lane(-1, "")))
    };
    let along = "<objects><object id=\"o1\" type=\"pole\" s=\"50\" t=\"4\" zOffset=\"0\" orientation=\"none\"/></objects>\
         <signals><signal id=\"s1\" s=\"40\" t=\"-4\" zOffset=\"2\" dynamic=\"no\" orientation=\"+\" type=\"274\" \
         subtype=\"50\" country=\"DE\"/></signals></road>\n";
    let second = one("2", 20.0).replace("</road>\n", along);
    document(&(one("1", 0.0) + &second))
}

/// Writes a map with one thing broken.
fn broken(folder: &Path, written: &str, instead: &str) -> PathBuf {
    let text = two_roads();
    assert_eq!(text.matches(written).count(), 1, "{written} must occur once");
    let file = folder.join("map.xodr");
    std::fs::write(&file, text.replace(written, instead)).expect("written");
    file
}

/// Compiles a map with options; proves how that ends, and what it and `check` say in the end.
fn check(file: &Path, options: &[&str], code: i32, said: &str) {
    let path = file.display().to_string();
    let archive = file.with_extension("mapd").display().to_string();
    let what = options.join(" ");
    let (_, err, ended) = run(&[&["compile", &path, "-o", &archive], options].concat(), "");
    assert_eq!(ended, Some(code), "compile {what}: {err}");
    assert!(err.contains(said), "compile {what}: expected {said:?} in\n{err}");
    let (out, err, ended) = run(&[&["check", &path], options].concat(), "");
    assert_eq!(ended, Some(code), "check {what}: {err}");
    assert!(out.contains(said), "check {what}: expected {said:?} in\n{out}");
    // No archive of a rejected map.
    assert_eq!(Path::new(&archive).exists(), code != 4, "{what}");
    let _ = std::fs::remove_file(&archive);
}

#[test]
fn policies_and_thresholds_decide() {
    let folder = tempfile::tempdir().expect("a folder");
    // One of two roads of equal length.
    let file = broken(folder.path(), "x=\"0\" y=\"20\" hdg=\"0\"", "x=\"0\" y=\"20\" hdg=\"east\"");
    check(&file, &[], 3, "road 2 is left out: mapd:value.type");
    check(&file, &["--on-error", "reject"], 4, "rejected");
    check(&file, &["--max-quarantined", "1"], 3, "left out");
    check(&file, &["--max-quarantined", "0"], 4, "at most 0 parts in quarantine, found 1");
    check(&file, &["--max-quarantined-share", "0.6"], 3, "left out");
    check(&file, &["--max-quarantined-share", "0.4"], 4, "at most the share 0.4");
    let file = broken(
        folder.path(),
        "<lane id=\"-1\" type=\"driving\"><link></link><width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/></lane>\n</right>\n</laneSection>\n</lanes>\n<objects>",
        "<lane id=\"-1\" type=\"driving\"/><lane id=\"-1\" type=\"driving\"/></right>\n</laneSection>\n</lanes>\n<objects>",
    );
    let said = "road 2 is kept as its reference line";
    check(&file, &["--on-error", "reference-line"], 3, said);
    // The file has the same choices.
    let rules = folder.path().join("rules.toml");
    std::fs::write(&rules, "on_error = \"reject\"\n").expect("written");
    check(&file, &["--rules", &rules.display().to_string()], 4, "rejected");
}

#[test]
fn what_is_left_out_is_told_by_every_command() {
    let folder = tempfile::tempdir().expect("a folder");
    for (written, instead, name) in [
        ("s=\"50\" t=\"4\"", "s=\"50\" t=\"4+2i\"", "object o1 of road 2"),
        ("s=\"40\" t=\"-4\"", "s=\"40\" t=\"\"", "signal s1 of road 2"),
    ] {
        let file = broken(folder.path(), written, instead);
        check(&file, &[], 3, &format!("{name} is left out"));
        let path = file.display().to_string();
        let archive = folder.path().join("hole.mapd").display().to_string();
        assert_eq!(run(&["compile", &path, "-o", &archive], "").2, Some(3), "{name}");
        let (out, err, code) = run(&["inspect", &archive, "--verify"], "");
        assert_eq!(code, Some(0), "{err}");
        assert!(out.contains(&format!("quarantine    1 part\n  {name}: line ")), "{out}");
        let (out, ..) = run(&["inspect", &archive, "--json"], "");
        assert!(out.contains("\"owner_kind\": \"road\""), "{out}");
        // Near the hole and far from it.
        let (out, err, code) = run(&["query", &archive, "nearest"], "x,y\n45,18\n95,-1\n");
        assert_eq!(code, Some(0), "{err}");
        let rows: Vec<&str> = out.lines().collect();
        assert!(rows[0].ends_with("quarantined,error"), "{out}");
        assert!(rows[1].contains(name) && !rows[2].contains(name), "{out}");
    }
}

/// Such a query was answered as if the file had no such part.
#[test]
fn what_is_asked_of_a_part_in_quarantine_says_so_with_rule_file_and_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = broken(folder.path(), "x=\"0\" y=\"20\" hdg=\"0\"", "x=\"0\" y=\"20\" hdg=\"east\"");
    let path = file.display().to_string();
    let text = std::fs::read_to_string(&file).expect("read");
    let line = 1 + text.lines().position(|line| line.contains("east")).expect("there");
    let archive = folder.path().join("hole.mapd").display().to_string();
    assert_eq!(run(&["compile", &path, "-o", &archive], "").2, Some(3));
    for (source, document) in [(&path, path.as_str()), (&archive, "the document")] {
        let reason =
            format!("road 2 is left out: mapd:value.type in {document}, line {line}, column ");
        for (kind, input) in [
            ("inertial", "road_id,s,t\n2,5,0\n"),
            ("surface", "road_id,s,t\n2,5,0\n"),
            ("lane", "road_id,s,lane_id\n2,5,-1\n"),
            ("track", "road_id,x,y\n2,5,20\n"),
            ("successors", "road_id,s,lane_id\n2,5,-1\n"),
            ("signals", "road_id,s,lane_id,distance\n2,5,-1,50\n"),
            ("route", "from_road,from_s,from_lane,to_road,to_s,to_lane\n1,5,-1,2,9,-1\n"),
        ] {
            let (out, err, code) = run(&["query", source, kind], input);
            assert_eq!(code, Some(0), "{kind}: {err}");
            let row = out.lines().nth(1).unwrap_or_default();
            assert!(
                row.contains("the map has no road \"\"2\"\"") && row.contains(&reason),
                "{kind}: {out}"
            );
        }
    }
    // A road that is kept as its bare line has no lanes.
    let file = broken(
        folder.path(),
        "<lane id=\"-1\" type=\"driving\"><link></link><width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/></lane>\n</right>\n</laneSection>\n</lanes>\n<objects>",
        "<lane id=\"-1\" type=\"driving\"/><lane id=\"-1\" type=\"driving\"/></right>\n</laneSection>\n</lanes>\n<objects>",
    );
    let archive = folder.path().join("line.mapd").display().to_string();
    let path = file.display().to_string();
    let options = ["compile", &path, "-o", &archive, "--on-error", "reference-line"];
    assert_eq!(run(&options, "").2, Some(3));
    let (out, ..) = run(&["query", &archive, "lane"], "road_id,s,lane_id\n2,5,-1\n");
    assert!(out.contains("road 2 has its reference line alone: "), "{out}");
    let (out, ..) = run(&["query", &archive, "inertial"], "road_id,s,t\n2,5,0\n1,5,0\n");
    let rows: Vec<&str> = out.lines().collect();
    assert!(rows[1].ends_with(",road 2,") && rows[2].ends_with(",,"), "{out}");
}

/// Objects and signals that are gone with their road could not be told from such as the file never had.
#[test]
fn the_map_knows_why_an_id_is_missing() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = broken(folder.path(), "x=\"0\" y=\"20\" hdg=\"0\"", "x=\"0\" y=\"20\" hdg=\"east\"");
    let snapshot = mapd_tests::maps::open(&file);
    let map = snapshot.map();
    use mapd_query::vocabulary::QuarantinedKind::{Junction, Object, Road, Signal};
    for (kind, id, lost) in [
        (Road, "2", true),
        (Object, "o1", true),
        (Signal, "s1", true),
        (Road, "1", false),
        (Object, "s1", false),
        (Junction, "2", false),
    ] {
        let found = map.left_out(kind, id).map(|part| (part.to_string(), part.rule()));
        let wanted = lost.then(|| ("road 2".to_owned(), "mapd:value.type"));
        assert_eq!(found, wanted, "{kind:?} {id}");
    }
}

/// A list that is empty because of a hole says so.
#[test]
fn an_empty_list_at_a_hole_is_no_silent_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = broken(folder.path(), "s=\"50\" t=\"4\"", "s=\"50\" t=\"4+2i\"");
    let path = file.display().to_string();
    for kind in ["objects", "landmarks"] {
        let (out, ..) = run(&["query", &path, kind], "x,y,radius\n50,24,9\n5,-4,1\n");
        let rows: Vec<&str> = out.lines().collect();
        assert_eq!(rows.len(), 2, "{kind}: {out}");
        assert!(
            rows[1].ends_with(
                ",object o1 of road 2,\"nothing found, but something is left out of the map there\""
            ),
            "{kind}: {out}"
        );
    }
}

#[test]
fn a_complex_number_in_an_object_costs_that_object_and_not_its_road() {
    let Some(maps) = mapd_tests::shared("maps") else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let file = maps.join("ivsg/scenario1_3_WithObjects_WithSigns.xodr").display().to_string();
    let (out, _, code) = run(&["check", &file], "");
    assert_eq!(code, Some(3));
    let lost: Vec<&str> = out.lines().filter(|line| line.contains(" is left out: ")).collect();
    assert_eq!(lost.len(), 2, "{lost:?}");
    assert!(lost[0].contains(": object 12 of road 0 is left out: mapd:value.type"), "{lost:?}");
    assert!(lost[1].contains(": object 47 of road 0 is left out: mapd:value.type"), "{lost:?}");
    // The road is there to its end.
    let (out, err, _) = run(&["query", &file, "inertial"], "road_id,s,t\n0,1464,0\n");
    assert!(out.lines().nth(1).is_some_and(|row| row.ends_with(',')), "{out}{err}");
}

/// Such lanes had no points, or points that were off by more than the tolerance, and nobody was told.
#[test]
fn lanes_whose_points_cannot_be_written_are_named() {
    let road = |id: u32, z: &str, slope: &str| {
        format!(
            r#"<road id="{id}" length="100" junction="-1"><planView><geometry s="0" x="{id}" y="0" hdg="0" length="100"><line/></geometry></planView><elevationProfile><elevation s="0" a="{z}" b="{slope}" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        )
    };
    const UNUSABLE: (&str, &str) =
        ("mapd:compile.unusable", "OpenDRIVE/road[@id=2]/elevationProfile/elevation");
    let cases = [
        ("1e308", "0", Some(UNUSABLE)),
        ("1e39", "0", Some(UNUSABLE)),
        ("1e12", "1e12", None),
        ("0", "0", None),
    ];
    for (z, slope, wanted) in cases {
        let text = format!(
            "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{}{}</OpenDRIVE>",
            road(1, "0", "0"),
            road(2, z, slope)
        );
        let compiled = mapd_compiler::compile(text.as_bytes(), &Default::default(), &mut |_| {});
        let compiled = compiled.expect("reading works");
        let mut lost = compiled.diagnostics.iter().filter(|told| told.rejects);
        let found = lost.next().map(|told| (told.finding.rule, told.finding.path.as_str()));
        assert_eq!(found, wanted, "z = {z}, slope {slope}: {:?}", compiled.diagnostics);
        assert_eq!(compiled.rows.is_some(), wanted.is_none(), "z = {z}, slope {slope}");
    }
}
