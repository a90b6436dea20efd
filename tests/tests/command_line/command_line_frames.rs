//! `--crs` on the command line.

use mapd_tests::command;
use std::process::Output;

fn run(args: &[&str], input: &str) -> Output {
    command::run(env!("CARGO_BIN_EXE_mapd_under_test"), args, input)
}

fn carried(name: &str) -> String {
    mapd_tests::carried(name).display().to_string()
}

/// Runs a command and expects a code and some words on stderr.
fn check(args: &[&str], code: i32, words: &str) -> String {
    let output = run(args, "");
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{args:?}: {errors}");
    assert!(errors.contains(words), "{args:?}: {errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Numbers of the only row that a query answers.
fn answer(source: &str, more: &[&str], kind: &str, input: &str) -> Vec<f64> {
    let mut args = vec!["query", source, kind];
    args.extend(more);
    let output = run(&args, input);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let row = text.lines().nth(1).expect("a row");
    row.split(',').filter(|cell| !cell.is_empty()).map(|cell| cell.parse().expect(row)).collect()
}

#[test]
fn a_frame_is_one_for_every_command() {
    let road = carried("one_road.xodr");
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("road.mapd").display().to_string();
    check(&["compile", &road, "--crs", "epsg:32632", "-o", &archive], 0, "");
    // The same question in s and t; a place of UTM, which lies 149 km east of the central meridian.
    let asked = "road_id,s,t\n1,20,-1\n";
    let (a, b) = (
        answer(&archive, &[], "inertial", asked),
        answer(&road, &["--crs", "epsg:32632"], "inertial", asked),
    );
    assert_eq!(a, b);
    let [x, y, z] = [a[3], a[4], a[5]];
    assert!(
        (640_000.0..660_000.0).contains(&x) && (5.31e6..5.33e6).contains(&y) && z == 10.0,
        "{a:?}"
    );
    // The same place on Earth from either frame: within what t·(scale − 1) leaves, 2 mm.
    let of = |at: &[f64]| format!("x,y,z\n{},{},{}\n", at[3], at[4], at[5]);
    let own = answer(&road, &[], "inertial", asked);
    let (here, there) =
        (answer(&road, &[], "geodetic", &of(&own)), answer(&archive, &[], "geodetic", &of(&a)));
    assert!(
        (here[3] - there[3]).abs() < 2e-8 && (here[4] - there[4]).abs() < 2e-8,
        "{here:?} {there:?}"
    );
    // From latitude and longitude to the same lane.
    let nearest =
        run(&["query", &archive, "nearest"], &format!("lat,lon\n{},{}\n", here[3], here[4]));
    assert!(String::from_utf8_lossy(&nearest.stdout).contains("1:0:-1"));
    let text = check(&["inspect", &archive, "--verify"], 0, "");
    for part in
        ["target        epsg:32632", "file frame  +proj=tmerc", "projection    +proj=utm +zone=32"]
    {
        assert!(text.contains(part), "{text}");
    }
    let json = check(&["inspect", &road, "--json", "--crs", "enu:48,11"], 0, "");
    let facts: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let frame = &facts["map"]["file_frame"];
    assert_eq!(frame["target"], "enu:48,11");
    assert!(frame["error_m"].as_f64().is_some_and(|error| error < 1e-6), "{frame}");
    assert!(frame["scale_max"].as_f64().is_some_and(|scale| (scale - 1.0).abs() < 1e-6), "{frame}");
    let own: serde_json::Value =
        serde_json::from_str(&check(&["inspect", &road, "--json"], 0, "")).expect("JSON");
    assert!(own["map"]["file_frame"].is_null());
    let bounds = |facts: &serde_json::Value| facts["map"]["geodetic_bounds"].clone();
    assert!(bounds(&own).is_array() && bounds(&facts).is_array());
    let svg = check(&["export", &road, "--format", "svg", "--crs", "utm"], 0, "");
    assert!(svg.contains("<svg"));
    check(&["check", &road, "--crs", "utm"], 0, "");
}

#[test]
fn what_is_no_frame_is_wrong_usage() {
    let (road, town) = (carried("one_road.xodr"), carried("town.xodr"));
    for (crs, words) in [
        ("epsg:99999", "99999"),
        ("epsg:4326", "degrees"),
        ("enu:48", "enu:LAT,LON"),
        ("+proj=utm +zone=32 +nadgrids=a.gsb", "grids are not supported"),
        ("+proj=nonsense", ""),
        ("", "EPSG"),
    ] {
        for command in ["compile", "inspect", "check"] {
            check(&[command, &road, "--crs", crs], 2, words);
        }
        check(&["--load", &road, "--crs", crs], 2, words);
    }
    // A map that lies nowhere is rejected, by checking too; nothing is left behind or served.
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("town.mapd").display().to_string();
    check(&["compile", &town, "--crs", "utm", "-o", &out], 4, "no georeference");
    check(&["inspect", &town, "--crs", "utm"], 4, "no georeference");
    check(&["--load", &town, "--crs", "utm"], 4, "no georeference");
    let told = check(&["check", &town, "--crs", "utm"], 4, "");
    assert!(told.contains("mapd:compile.target_frame"), "{told}");
    // What is compiled keeps its frame.
    check(&["compile", &town, "-o", &out], 0, "");
    check(&["inspect", &out, "--crs", "utm"], 2, "keeps the frame");
    check(&["query", "shm:town", "nearest", "--crs", "utm"], 2, "keeps the frame");
    check(&["--load", &out, "--crs", "utm"], 2, "keeps what it was compiled with");
}
