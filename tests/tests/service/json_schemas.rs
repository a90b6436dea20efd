//! What commands print as JSON is what the published schemas say: every field is there, and no other.

use mapd_client::{Attach, Client};
use mapd_tests::json_schema::wrong;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::{carried, workspace};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A domain and a folder.
struct Scene {
    place: TestDomain,
    folder: tempfile::TempDir,
}

fn schema(name: &str) -> Value {
    let file = workspace().join(format!("schemas/{name}.schema.json"));
    serde_json::from_slice(&fs::read(&file).expect("read")).expect("JSON")
}

impl Scene {
    fn new() -> Self {
        Self { place: TestDomain::new(MAPD), folder: tempfile::tempdir().expect("a folder") }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// What a command prints, whatever its exit code is.
    fn prints(&self, args: &[&str]) -> Value {
        let output = self.place.command().args(args).output().expect("runs");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|error| panic!("{args:?}: {error}: {said}"))
    }

    /// What a command prints, which a schema describes.
    fn conforms(&self, name: &str, args: &[&str]) -> Value {
        let value = self.prints(args);
        assert_eq!(wrong(&schema(name), &value), None, "{args:?}: {value:#}");
        value
    }
}

#[test]
fn status_and_doctor() {
    let scene = Scene::new();
    let map = scene.path("town.xodr");
    let text = fs::read_to_string(carried("town.xodr")).expect("read");
    fs::write(&map, &text).expect("written");
    assert_eq!(scene.conforms("status", &["status", "--json"]), Value::Array(Vec::new()));
    let config = scene.path("mapd.toml");
    fs::write(&config, "[[map]]\nfile = \"no-such.xodr\"\n").expect("written");
    let config = ["--config", config.to_str().expect("a name")];
    let doctor = scene.conforms("doctor", &[&["doctor", "--json"], &config[..]].concat());
    let state = |state: &str| {
        doctor["findings"].as_array().expect("findings").iter().any(|one| one["state"] == state)
    };
    assert!(state("ok") && state("problem"), "{doctor:#}");
    let daemon = scene.place.serve(&[map.to_str().expect("a name")]);
    let first = scene.conforms("status", &["status", "--json"]);
    assert_eq!(first[0]["state"]["last_reload"], Value::Null);
    let _held = Client::connect_as(Attach::Subscriber, &scene.place.domain(), "town", PATIENCE)
        .expect("attaches")
        .snapshot();
    for round in 1..=2 {
        let name = format!("name=\"Road {round}\"");
        fs::write(&map, text.replacen("name=\"Street 1\"", &name, 1)).expect("written");
        let stage = if round == 2 { &["--stage"][..] } else { &[] };
        let output = scene.place.command().args(["reload", "town"]).args(stage).output();
        assert!(output.expect("runs").status.success());
    }
    let full = scene.conforms("status", &["status", "--json"]);
    let said = &full[0]["state"];
    for field in ["served", "staged", "last_reload", "held"] {
        assert!(
            !said[field].is_null() && said[field] != Value::Array(Vec::new()),
            "{field}: {said:#}"
        );
    }
    scene.conforms("doctor", &["doctor", "--json"]);
    daemon.kill();
    let dead = scene.conforms("status", &["status", "--json"]);
    assert_eq!((&dead[0]["alive"], &dead[0]["daemon"]), (&Value::Bool(false), &Value::Null));
    // The next daemon cleans up.
    scene.place.serve(&[map.to_str().expect("a name")]).stop();
}

#[test]
fn inspect_and_findings() {
    let scene = Scene::new();
    let [town, objects, placed] = ["town.xodr", "objects.xodr", "one_road.xodr"]
        .map(|name| carried(name).display().to_string());
    // A road that is left out, an attribute that nothing knows, user data, a junction group, a signal and an object of no class.
    let more = r#"<objects><object id="o" s="1" t="0" zOffset="0" type="odd" subtype="thing"/></objects><signals><signal s="20" t="-5" id="x" name="odd" dynamic="no" orientation="+" zOffset="2" country="DE" type="odd" subtype="-1"/></signals><userData code="own" value="1"/></road>"#;
    let text = fs::read_to_string(&town).expect("read");
    let text = text.replacen("</road>", more, 1).replacen("<road ", "<road odd=\"1\" ", 1);
    let text = text.replacen("length=\"76\" id=\"2\"", "length=\"-1\" id=\"2\"", 1);
    let group = r#"<junctionGroup id="g" name="ring" type="roundabout"><junctionReference junction="1000"/></junctionGroup></OpenDRIVE>"#;
    let odd = scene.path("odd.xodr");
    fs::write(&odd, text.replace("</OpenDRIVE>", group)).expect("written");
    let odd = odd.to_str().expect("a name");
    let archive = scene.path("town.mapd").display().to_string();
    let report = scene.path("report.json").display().to_string();
    for (options, is_written) in [(&[][..], true), (&["--crs", "enu:48,11"], false)] {
        let compile = [&["compile", &town, "-o", &archive, "--report", &report], options].concat();
        let output = scene.place.command().args(&compile).output().expect("runs");
        assert_eq!(output.status.success(), is_written, "{compile:?}");
        let report = serde_json::from_slice(&fs::read(&report).expect("read")).expect("JSON");
        assert_eq!(wrong(&schema("report"), &report), None, "{report:#}");
        assert_eq!(report["archive"].is_object(), is_written, "{report:#}");
    }
    scene.conforms("report", &["check", odd, "--json"]);
    for args in [
        &[&town[..]][..],
        &[&objects],
        &[&archive, "--verify"],
        &[&placed, "--crs", "enu:48,11"],
        &[odd],
    ] {
        scene.conforms("inspect", &[&["inspect", "--json"], args].concat());
    }
    let full = scene.prints(&["inspect", "--json", odd]);
    for field in [
        "/quarantined/0",
        "/findings/by_rule/0",
        "/besides/junction_groups/0",
        "/besides/by_kind/user-data/own",
        "/signals/unknown/DE odd -1 odd",
        "/objects/unmapped/odd~1thing",
    ] {
        let own = full.pointer(field);
        assert!(own.is_some_and(|own| !own.is_null()), "{field}: {full:#}");
    }
}

/// A schema that anything could be, or that differs from the output, is found out.
#[test]
fn what_differs_is_found() {
    let scene = Scene::new();
    let good = scene.prints(&["doctor", "--json"]);
    let schema = schema("doctor");
    for (change, place) in [
        (&(|value: &mut Value| value["more"] = 1.into()) as &dyn Fn(&mut Value), "more"),
        (&|value| drop(value.as_object_mut().expect("an object").remove("state")), "required"),
        (&|value| value["state"] = "fine".into(), ".state"),
        (&|value| value["findings"][0]["found"] = 1.into(), ".findings[0].found"),
    ] {
        let mut bad = good.clone();
        change(&mut bad);
        let told = wrong(&schema, &bad).expect("it differs");
        assert!(told.contains(place), "{told}");
    }
}

/// Each schema is named where promises are, and goes with the packages.
#[test]
fn schemas_are_listed() {
    let page = fs::read_to_string(workspace().join("docs/promises.md")).expect("read");
    let files = fs::read_dir(workspace().join("schemas")).expect("the folder").flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    let names: Vec<String> = names.filter(|name| name.ends_with(".schema.json")).collect();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        assert!(
            page.contains(&format!("(../schemas/{name})")),
            "{name} is not in docs/promises.md"
        );
    }
}
