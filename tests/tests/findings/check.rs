//! What `mapd check` says, and how it ends.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Output};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

const PLAN: &str = "<planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><line/></geometry></planView>";
const LANES: &str =
    "<lanes><laneSection s=\"0\"><center><lane id=\"0\"/></center></laneSection></lanes>";

fn run(file: &Path, args: &[&str]) -> Output {
    Command::new(MAPD).arg("check").arg(file).args(args).output().expect("starts")
}

/// Writes a document and checks it; its standard output without the folder's name, and how it ends.
fn check(name: &str, text: &[u8], args: &[&str]) -> (String, Option<i32>) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join(name);
    std::fs::write(&file, text).expect("written");
    std::fs::write(
        folder.path().join("more.xodr"),
        format!("<OpenDRIVE>\n<road id=\"2\" length=\"10\" junction=\"-1\">{PLAN}\n{LANES}\n<tree/></road></OpenDRIVE>"),
    )
    .expect("written");
    let output = run(&file, args);
    let base = format!("{}/", folder.path().display());
    (String::from_utf8_lossy(&output.stdout).replace(&base, ""), output.status.code())
}

fn document(inner: &str) -> String {
    format!(
        "<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"8\"/>\n<road id=\"1\" length=\"10\" junction=\"-1\">{PLAN}\n{LANES}\n{inner}</road>\n</OpenDRIVE>"
    )
}

#[test]
fn text_shows_the_line_and_the_place() {
    let text = document("\t<lights ü=\"1\"/>");
    let expected = "\
a.xodr:5:2: warning[mapd:structure.unknown_element]: expected no element lights, which the standard does not have here, found it; kept as text
    at OpenDRIVE/road[@id=1]
 5 |  <lights ü=\"1\"/></road>
   |  ^
      1 mapd:structure.unknown_element
a.xodr: accepted; states 1.8, checked as 1.8.1; errors 0, warnings 1, information 0
";
    assert_eq!(check("a.xodr", text.as_bytes(), &[]), (expected.to_owned(), Some(0)));
    // The same, compressed.
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(text.as_bytes()).expect("compresses");
    let gzip = gzip.finish().expect("compresses");
    let expected = expected.replace("a.xodr", "a.xodrz");
    assert_eq!(check("a.xodrz", &gzip, &[]), (expected, Some(0)));
}

#[test]
fn what_rejects_the_map_says_so() {
    let text = document("")
        .replace("hdg=\"0\"", "hdg=\"east\"")
        .replace("id=\"1\"", "id=\"1\" rule=\"UP\"");
    let (out, code) = check("a.xodr", text.as_bytes(), &[]);
    assert_eq!(code, Some(4), "{out}");
    assert!(out.contains("a.xodr:3:20: warning[mapd:value.enumeration]: expected"), "{out}");
    assert!(
        out.contains("error[mapd:value.type], rejects the map: expected a number in @hdg"),
        "{out}"
    );
    assert!(out.contains("a.xodr: rejected; states 1.8"), "{out}");
}

#[test]
fn json_is_one_document() {
    let text = document("").replace("hdg=\"0\"", "hdg=\"east\"");
    let (out, code) = check("a.xodr", text.as_bytes(), &["--format", "json"]);
    assert_eq!(code, Some(4), "{out}");
    let json: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(json["verdict"], "rejected");
    assert_eq!(
        (&json["stated_version"], &json["checked_version"]),
        (&"1.8".into(), &"1.8.1".into())
    );
    assert_eq!(json["counts"]["errors"], 1);
    assert_eq!(json["rules"][0]["rule"], "mapd:value.type");
    let column = text.lines().nth(2).and_then(|line| line.find("east")).expect("the value") + 1;
    let expected = serde_json::json!({
        "rule": "mapd:value.type", "asam_rule": "asam.net:xodr:1.0.0:xml.valid_schema",
        "severity": "error", "rejects": true, "file": "a.xodr", "line": 3, "column": column,
        "offset": text.find("east"), "length": 4,
        "path": "OpenDRIVE/road[@id=1]/planView/geometry[@s=0]", "subject": "hdg",
        "message": "expected a number in @hdg, found something else; refused: \"east\"",
        "expected": "a number in @hdg", "found": "something else; refused: \"east\"", "hint": ""
    });
    assert_eq!(json["findings"], serde_json::json!([expected]));
}

#[test]
fn included_files_have_places_of_their_own() {
    let text = document("").replace("</OpenDRIVE>", "<include file=\"more.xodr\"/>\n</OpenDRIVE>");
    let (out, code) = check("a.xodr", text.as_bytes(), &[]);
    assert_eq!(code, Some(0), "{out}");
    assert!(out.contains("more.xodr:4:1: warning[mapd:structure.unknown_element]"), "{out}");
    assert!(out.contains(" 4 | <tree/></road></OpenDRIVE>\n   | ^"), "{out}");
    let elsewhere = tempfile::tempdir().expect("a folder");
    let base = elsewhere.path().display().to_string();
    let (out, code) = check("a.xodr", text.as_bytes(), &["--include-base", &base]);
    assert_eq!(code, Some(4), "{out}");
    assert!(out.contains("error[mapd:xml.include], rejects the map"), "{out}");
}

/// Messages had `found expected`, twice a number, or a version of the standard that there is not.
#[test]
fn messages_are_sentences() {
    let line = "s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><line/>";
    let lane = "<center><lane id=\"0\" type=\"none\" level=\"no\"/></center>";
    for (from, to, words) in [
        (
            line,
            "s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><arc curvature=\"1000\"/>",
            "expected a curve that turns by at most 256 rad, found 10000 rad",
        ),
        (
            line,
            "s=\"2\" x=\"0\" y=\"0\" hdg=\"0\" length=\"10\"><line/>",
            "expected s = 0, found 2",
        ),
        ("revMinor=\"8\"", "revMinor=\"99\"", "deprecated in OpenDRIVE 1.9, found"),
    ] {
        let text = document("").replace("<center><lane id=\"0\"/></center>", lane);
        assert!(text.contains(from), "{from}");
        let (out, _) = check("a.xodr", text.replace(from, to).as_bytes(), &[]);
        assert!(out.contains(words), "{words}: {out}");
    }
}

/// Lanes without links that nobody drives along were called driving lanes.
#[test]
fn only_driving_lanes_are_dead() {
    let road = |id: u32, x: u32, link: &str, kind: &str| {
        format!(
            "<road id=\"{id}\" length=\"10\" junction=\"-1\"><link>{link}</link><planView><geometry s=\"0\" x=\"{x}\" y=\"0\" hdg=\"0\" \
             length=\"10\"><line/></geometry></planView><lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right><lane \
             id=\"-1\" type=\"{kind}\"><width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road>"
        )
    };
    for (kind, is_told) in [
        ("driving", true),
        ("bus", true),
        ("border", false),
        ("restricted", false),
        ("stop", false),
    ] {
        let next = "<successor elementType=\"road\" elementId=\"2\" contactPoint=\"start\"/>";
        let last = "<predecessor elementType=\"road\" elementId=\"1\" contactPoint=\"end\"/>";
        let text = format!(
            "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{}{}</OpenDRIVE>",
            road(1, 0, next, kind),
            road(2, 10, last, kind)
        );
        let (out, _) = check("a.xodr", text.as_bytes(), &[]);
        assert_eq!(out.contains("topology.dead_lane"), is_told, "{kind}: {out}");
    }
}

/// A file that was missing below the root took out whichever part stood before it, and the rest was accepted.
#[test]
fn a_missing_file_is_not_blamed_on_what_stands_before() {
    let include = "<include file=\"nope.xodr\"/>\n";
    let road = |id: u32| document("").replace("id=\"1\"", &format!("id=\"{id}\""));
    let road =
        |id| road(id).split_once("<road").map(|(_, rest)| format!("<road{rest}")).expect("a road");
    let two = document("").replace("</OpenDRIVE>", &road(2));
    for (text, verdict, code) in [
        (two.replace("<road id=\"2\"", &format!("{include}<road id=\"2\"")), "rejects the map", 4),
        (two.replace("</OpenDRIVE>", &format!("{include}</OpenDRIVE>")), "rejects the map", 4),
        (two.replacen("</road>", &format!("{include}</road>"), 1), "takes out the part", 3),
    ] {
        let (out, ended) = check("a.xodr", text.as_bytes(), &[]);
        assert!(out.contains(&format!("error[mapd:xml.include], {verdict}: expected")), "{out}");
        assert!(out.contains(", found nope.xodr: No such file"), "{out}");
        assert_eq!(ended, Some(code), "{out}");
    }
}

#[test]
fn limits_are_options() {
    let text = document(&"<tree/>".repeat(5));
    for (limit, words) in [
        ("2", "3 more findings like this"),
        ("4", "one more finding like this"),
        ("0", ": 5 findings like this"),
    ] {
        let (out, _) = check("a.xodr", text.as_bytes(), &["--all", "--max-findings", limit]);
        assert!(out.contains(words), "{out}");
    }
    for limit in [
        ["--max-depth", "3"],
        ["--max-attribute-length", "20"],
        ["--max-attributes", "2"],
        ["--max-bytes", "300"],
    ] {
        let (out, code) = check("a.xodr", text.as_bytes(), &limit);
        assert_eq!(code, Some(4), "{limit:?}: {out}");
        assert!(out.contains("error[mapd:xml.limit], rejects the map"), "{limit:?}: {out}");
    }
}

/// Line breaks and control characters that a map wrote as references came raw: they made lines of their own, and reached the terminal.
#[test]
fn what_a_map_says_makes_no_lines_and_steers_no_terminal() {
    let link = "<link><successor elementType=\"junction\" elementId=\"9&#10;mapd: forged&#x9b;31m&#x85;\"/></link>";
    let text = document("").replace("<planView>", &format!("{link}<planView>"));
    let text = text.replace("road id=\"1\"", "road id=\"1&#10;mapd: forged\"");
    let (out, _) = check("a.xodr", text.as_bytes(), &["--all"]);
    assert!(out.contains("9·mapd: forged·31m·"), "{out}");
    assert!(out.contains("road[@id=1·mapd: forged]"), "{out}");
    assert!(out.chars().all(|c| c == '\n' || !c.is_control()), "{out:?}");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.xodr");
    std::fs::write(&file, text).expect("written");
    let compiled = Command::new(MAPD).arg("compile").arg(&file).output().expect("starts");
    let said = String::from_utf8(compiled.stderr).expect("UTF-8");
    assert!(said.contains("9·mapd: forged"), "{said}");
    assert!(said.chars().all(|c| c == '\n' || !c.is_control()), "{said:?}");
}

/// The id was missing in the path where a bad attribute stands before it, and was not decoded; rules wrote ids of any length.
#[test]
fn paths_have_ids_wherever_they_stand() {
    let long = "x".repeat(100_000);
    for (id, shown) in [("7", "7"), ("a&amp;b", "a&b"), (&*long, &long[..64])] {
        let road = format!("<road length=\"abc\" foo=\"1\" id=\"{id}\" ");
        let text = document("").replace("<road id=\"1\" length=\"10\" ", &road);
        let (out, _) = check("a.xodr", text.as_bytes(), &["--json", "-q"]);
        let told: serde_json::Value = serde_json::from_str(&out).expect("JSON");
        let path = format!("OpenDRIVE/road[@id={shown}]");
        let mut about_road = 0;
        for finding in told["findings"].as_array().expect("a list") {
            let found = finding["path"].as_str().expect("a path");
            assert!(finding["message"].as_str().is_some_and(|text| text.len() < 1100), "{id}");
            about_road += usize::from(found.starts_with(&path));
            assert!(!found.starts_with("OpenDRIVE/road") || found.starts_with(&path), "{found}");
        }
        assert!(about_road >= 2, "{out}");
    }
}

/// All findings beyond a limit counted as one.
#[test]
fn numbers_are_those_of_all_findings() {
    const PARTS: usize = 150;
    let parts = |part: &str| {
        let part = |id: usize| part.replace("ID", &id.to_string());
        (2..2 + PARTS).map(part).collect::<String>()
    };
    let roads =
        |road: &str| document("").replace("</OpenDRIVE>", &format!("{}</OpenDRIVE>", parts(road)));
    let bare = format!("<road id=\"ID\" junction=\"-1\">{PLAN}{LANES}</road>\n");
    let signal = |rest: &str| {
        let signal = format!("<signal id=\"ID\" t=\"3\" zOffset=\"0\" {rest}/>\n");
        document(&format!("<signals>{}</signals>", parts(&signal)))
    };
    let folder = tempfile::tempdir().expect("a folder");
    let [file, rules, report, archive] =
        ["a.xodr", "r.toml", "r.json", "a.mapd"].map(|name| folder.path().join(name));
    let json = |text: &[u8]| serde_json::from_slice::<serde_json::Value>(text).expect("JSON");
    let sum = |list: &serde_json::Value| {
        list.as_array().expect("a list").iter().filter_map(|one| one["count"].as_u64()).sum::<u64>()
    };
    for (text, what, due) in [
        (document(&parts("<tree/>")), "warnings", "mapd:structure.unknown_element"),
        // The compiler finds that there is no length, too.
        (roads(&bare), "errors", "mapd:structure.missing_attribute"),
        (
            signal("s=\"\" dynamic=\"no\" orientation=\"+\" type=\"x\" subtype=\"x\""),
            "errors",
            "mapd:value.empty",
        ),
        (
            signal("s=\"1\" orientation=\"+\" type=\"x\" subtype=\"x\""),
            "warnings",
            "mapd:structure.missing_attribute",
        ),
        // Information and warnings of a rule.
        (
            roads(&bare.replace(" junction", " length=\"10.5\" junction")),
            "warnings",
            "asam.net:xodr:1.9.0:road.length_sum_geometries",
        ),
    ] {
        std::fs::write(&file, text).expect("written");
        let checked = ["0", "2", "100", "100000"].map(|limit| {
            std::fs::write(&rules, format!("max_findings = {limit}")).expect("written");
            let rules = rules.to_str().expect("UTF-8");
            let args = ["-q", "--max-findings", limit, "--rules", rules];
            let told = json(&run(&file, &[&args[..], &["--json"]].concat()).stdout);
            let counts = &told["counts"];
            let all: u64 = ["errors", "warnings", "information"]
                .map(|severity| counts[severity].as_u64().expect("a number"))
                .iter()
                .sum();
            assert_eq!(sum(&told["rules"]), all, "{due}");
            let of =
                told["rules"].as_array().expect("a list").iter().find(|one| one["rule"] == due);
            assert!(of.is_some_and(|of| of["count"].as_u64() >= Some(PARTS as u64)), "{told:#}");
            let text = String::from_utf8(run(&file, &args).stdout).expect("UTF-8");
            let last = text.lines().last().unwrap_or_default().to_owned();
            assert!(last.contains(&format!("{what} {}", counts[what])), "{last}");
            (
                counts.clone(),
                told["rules"].clone(),
                last,
                told["quarantined"].as_array().map(Vec::len),
            )
        });
        assert!(checked.iter().all(|one| *one == checked[0]), "{due}: {checked:#?}");
        let of_others =
            |args: &[&str]| Command::new(MAPD).args(args).arg(&file).output().expect("starts");
        let inspected = json(&of_others(&["inspect", "--json"]).stdout);
        let found = &inspected["findings"];
        assert_eq!(found[what], checked[0].0[what], "{due}: {found:#}");
        assert_eq!(sum(&found["by_rule"]), sum(&checked[0].1), "{due}: {found:#}");
        let [to, archive] = [&report, &archive].map(|path| path.to_str().expect("UTF-8"));
        let compiled = of_others(&["compile", "--report", to, "-o", archive]);
        let said = String::from_utf8_lossy(&compiled.stderr).into_owned();
        let told = json(&std::fs::read(&report).unwrap_or_default());
        assert_eq!(told["counts"], checked[0].0, "{due}: {said}");
        let more = "147 more warnings; `--report` writes 97 of them, the others are only counted";
        assert!(due != "mapd:structure.unknown_element" || said.contains(more), "{said}");
    }
}

/// What was found between the children of an element counted for whichever element within them was read last. So it was told again for each kind
/// of those, and how often depended on the number of threads.
#[test]
fn what_is_between_children_is_their_parents() {
    const ROADS: usize = 2000;
    let road = |id: usize| {
        let inner = ["", "<objects/>", "<signals/>"][id % 3];
        format!(
            "<road id=\"{id}\" length=\"10\" junction=\"-1\">{PLAN}\n{LANES}\n{inner}</road><u/>\n"
        )
    };
    let roads: String = (2..2 + ROADS).map(road).collect();
    let junction = "<junction id=\"7\" name=\"\"/>\n";
    let text = document("").replace("</OpenDRIVE>", &format!("{junction}{roads}</OpenDRIVE>"));
    let told = |threads: &str| {
        let (out, _) =
            check("a.xodr", text.as_bytes(), &["--max-findings", "2", "--threads", threads]);
        let structure = out.lines().filter(|line| line.contains("[mapd:structure."));
        structure.map(str::to_owned).collect::<Vec<_>>()
    };
    let one = told("1");
    for kind in ["(OpenDrive, road)", "(OpenDrive, u)"] {
        let all = format!("{} more findings like this {kind}", ROADS - 2);
        assert_eq!(one.iter().filter(|line| line.contains(&all)).count(), 1, "{one:#?}");
    }
    assert_eq!(told("2"), one);
    assert_eq!(told("8"), one);
}

#[test]
fn it_ends_as_the_other_commands_do() {
    assert_eq!(run(Path::new("no/such.xodr"), &[]).status.code(), Some(1));
    assert_eq!(run(Path::new("a.xodr"), &["--format", "sky"]).status.code(), Some(2));
    let folder = tempfile::tempdir().expect("a folder");
    assert_eq!(run(folder.path(), &[]).status.code(), Some(1));
}

#[test]
fn sarif_and_xqar_have_every_finding() {
    let text = document("<lights/>");
    let (out, _) = check("a.xodr", text.as_bytes(), &["--format", "sarif"]);
    let log: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let run = &log["runs"][0];
    assert_eq!(
        (&log["version"], &run["properties"]["verdict"]),
        (&"2.1.0".into(), &"accepted".into())
    );
    let result = &run["results"][0];
    assert_eq!(result["ruleId"], "mapd:structure.unknown_element");
    assert_eq!(result["level"], "warning");
    assert_eq!(run["tool"]["driver"]["rules"][0]["id"], result["ruleId"]);
    let region = &result["locations"][0]["physicalLocation"]["region"];
    assert_eq!(
        (&region["startLine"], &region["byteOffset"]),
        (&5.into(), &text.find("<lights").into())
    );
    let (out, _) = check("a.xodr", text.as_bytes(), &["--format", "xqar"]);
    let issue = "level=\"2\" ruleUID=\"asam.net:xodr:1.0.0:xml.valid_schema\">";
    assert_eq!(out.matches("<Issue ").count(), 1, "{out}");
    assert!(out.contains(issue) && out.contains("<FileLocation column=\"1\" row=\"5\"/>"), "{out}");
}

#[test]
fn rules_are_graded_by_profile_and_file() {
    let text = document("").replace("length=\"10\" junction", "length=\"11\" junction");
    let rule = "asam.net:xodr:1.9.0:road.length_sum_geometries";
    let (out, code) = check("a.xodr", text.as_bytes(), &[]);
    assert!(out.contains(&format!("warning[{rule}]")), "{out}");
    assert_eq!(code, Some(0), "{out}");
    // The only road is lost.
    let (out, code) = check("a.xodr", text.as_bytes(), &["--profile", "strict"]);
    assert!(out.contains(&format!("error[{rule}], rejects the map")), "{out}");
    assert_eq!(code, Some(4), "{out}");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("rules.toml");
    let path = file.display().to_string();
    for (grade, expected, code) in
        [("off", None, 0), ("information", Some("info["), 0), ("error", Some("error["), 4)]
    {
        std::fs::write(&file, format!("[rules]\n\"{rule}\" = \"{grade}\"\n")).expect("written");
        let (out, ended) = check("a.xodr", text.as_bytes(), &["--rules", &path]);
        assert_eq!(ended, Some(code), "{grade}: {out}");
        match expected {
            Some(expected) => assert!(out.contains(&format!("{expected}{rule}]")), "{out}"),
            None => assert!(!out.contains(rule), "{out}"),
        }
    }
    for refused in ["mapd:no.such_rule", "mapd:compile.unusable", "mapd:xml.well_formed"] {
        std::fs::write(&file, format!("[rules]\n\"{refused}\" = \"off\"\n")).expect("written");
        assert_eq!(check("a.xodr", text.as_bytes(), &["--rules", &path]).1, Some(2), "{refused}");
    }
    for (wrong, said) in [
        ("profile = \"strict\"\nsky = 1\n", "unknown field `sky`"),
        ("\nmax_quarantined_share = 2.0\n", "expected a share from 0 to 1, found 2"),
    ] {
        std::fs::write(&file, wrong).expect("written");
        let output = run(&mapd_tests::carried("one_road.xodr"), &["--rules", &path]);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{errors}");
        for part in [said, "line 2", &path] {
            assert!(errors.contains(part), "{part:?} in {errors}");
        }
    }
    let output = run(Path::new("a.xodr"), &["--max-quarantined-share", "2"]);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{errors}");
    assert!(
        errors.contains("--max-quarantined-share") && errors.contains("from 0 to 1"),
        "{errors}"
    );
}
