//! What commands print as JSON is what the published schemas say: every field is there, and no other.

use super::trust::write_keys;
use mapd_client::{Attach, Client};
use mapd_tests::json_schema::{schema, wrong};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::{carried, workspace};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Commands with `--json`, and the schema of what they print then.
const PRINTED: [(&str, &str); 17] = [
    ("activate", "change"),
    ("bench", "bench"),
    ("check", "report"),
    ("compile", "tiles"),
    ("doctor", "doctor"),
    ("inspect", "inspect"),
    ("match", "answers"),
    ("overlay apply", "overlay-list"),
    ("overlay clear", "overlay-list"),
    ("overlay list", "overlay-list"),
    ("overlay remove", "overlay-list"),
    ("overlay show", "overlay-list"),
    ("query", "answers"),
    ("reload", "change"),
    ("rollback", "change"),
    ("sign", "signatures"),
    ("status", "status"),
];

/// Commands that report nothing: they write a file, a page, a script or help.
const SILENT: [&str; 5] = ["completions", "export", "help", "man", "view"];

/// Commands that have no others below them, by name.
fn commands(command: &clap::Command, path: &str, all: &mut Vec<(String, bool)>) {
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        let name = format!("{path}{}", below.get_name());
        if below.has_subcommands() {
            commands(below, &format!("{name} "), all);
        } else {
            let is_json = |arg: &clap::Arg| arg.get_long() == Some("json");
            let has_json = below.get_arguments().any(is_json);
            all.push((name, has_json));
        }
    }
}

/// A domain and a folder.
struct Scene {
    place: TestDomain,
    folder: tempfile::TempDir,
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

    /// What a command prints, which the schema of this name describes.
    fn conforms(&self, name: &str, args: &[&str]) -> Value {
        let commands =
            || PRINTED.iter().filter(|(command, _)| command.split(' ').next() == Some(args[0]));
        assert!(commands().any(|(_, schema)| *schema == name), "{args:?}: {name}");
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
        let told = scene.conforms("change", &[&["reload", "town", "--json"], stage].concat());
        assert_eq!(told["result"], if round == 2 { "staged" } else { "published" });
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
    scene.conforms("change", &["activate", "town", "--json"]);
    scene.conforms("change", &["rollback", "town", "--json"]);
    fs::write(&map, "no map").expect("written");
    let failed = scene.conforms("change", &["reload", "town", "--json"]);
    assert_eq!((&failed["result"], failed["reason"] == ""), (&"failed".into(), false));
    fs::write(&map, text).expect("written");
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

#[test]
fn tiles_signatures_and_figures() {
    let scene = Scene::new();
    let town = fs::read_to_string(carried("town.xodr")).expect("read");
    let write = |name: &str, text: &str| fs::write(scene.path(name), text).expect("written");
    let part = town.replacen("length=\"76\" id=\"2\"", "length=\"-1\" id=\"2\"", 1);
    // Tiles are told in the order of their names.
    let outcomes = ["accepted", "quarantined", "rejected"];
    for (outcome, text) in outcomes.iter().zip([&town[..], &part, "no map"]) {
        write(&format!("{outcome}.xodr"), text);
    }
    let path = |name: &str| scene.path(name).display().to_string();
    let (folder, out) = (scene.folder.path().display().to_string(), path("out"));
    let compile = ["compile", "--json", "--output-dir", &out, &folder];
    let told = scene.conforms("tiles", &compile);
    let found = told["tiles"].as_array().expect("tiles").iter().map(|tile| &tile["outcome"]);
    assert!(found.eq(&outcomes), "{told:#}");
    let skipped = scene.conforms("tiles", &compile);
    assert_eq!(skipped["sums"]["up_to_date"], 2, "{skipped:#}");
    let tight = [&compile[..], &["--force", "--max-memory", "1MiB"]].concat();
    let failed = scene.conforms("tiles", &tight);
    assert!(failed["tiles"][0]["reason"].is_string(), "{failed:#}");

    write_keys(scene.folder.path());
    write("works.json", r#"{"entries":[]}"#);
    let (archive, works, key) = (path("out/accepted.mapd"), path("works.json"), path("ours.key"));
    let signed = scene.conforms("signatures", &["sign", "--json", "--key", &key, &archive, &works]);
    assert!(signed[0]["content_hash"].is_string() && signed[1]["overlay"].is_string());
    let few = ["--clients", "1", "--queries", "10", "--routes", "1"];
    scene.conforms("bench", &[&["bench", "--json", &archive], &few[..]].concat());
}

#[test]
fn overlays() {
    let scene = Scene::new();
    let map = scene.path("town.xodr");
    fs::copy(carried("town.xodr"), &map).expect("copied");
    let _daemon = scene.place.serve(&[map.to_str().expect("a name")]);
    let entries = scene.path("entries.json");
    // Every field; and one whose road goes.
    let text = r#"{"entries":[
        {"id":"all","kind":"speed","source":"a","feed":"f","text":"b","value":5,"lanes":[{"road":"1","s":[1,9],"lane":-1}],
         "vehicles":["truck"],"from":"2096-05-04T07:00:00Z","until":4000000000,"confidence":0.5,
         "weekly":[{"days":["mon"],"from":"07:00","until":"09:00"}]},
        {"id":"lost","kind":"closed","lanes":[{"road":"3"}]}]}"#;
    fs::write(&entries, text).expect("written");
    let entries = entries.to_str().expect("a name");
    let overlay = |args: &[&str]| {
        scene.conforms("overlay-list", &[&["overlay", "town"], args, &["--json"]].concat())
    };
    overlay(&["apply", entries]);
    fs::copy(carried("one_road.xodr"), &map).expect("copied");
    scene.prints(&["reload", "town", "--json"]);
    let list = overlay(&["list"]);
    let state = |state: &str| {
        list["entries"].as_array().expect("entries").iter().any(|one| one["state"] == state)
    };
    assert!(state("waiting") && state("unplaced"), "{list:#}");
    let later = overlay(&["list", "--at", "4000000000"]);
    assert_eq!(later["entries"][0]["state"], "ended", "{later:#}");
    let one = scene.prints(&["overlay", "town", "show", "all", "--json"]);
    assert_eq!(one, list["entries"][0]);
    overlay(&["remove", "lost"]);
    overlay(&["clear"]);
}

#[test]
fn answers() {
    let scene = Scene::new();
    let map = carried("town.xodr").display().to_string();
    // Without questions: tests of the command line ask each kind.
    let none = |args: &[&str], columns: &str| {
        let input = scene.path("input.csv");
        fs::write(&input, format!("{columns}\n")).expect("written");
        let mut command = scene.place.command();
        let output = command.args(args).stdin(fs::File::open(&input).expect("opens")).output();
        let told: Value = serde_json::from_slice(&output.expect("runs").stdout).expect("JSON");
        assert_eq!((wrong(&schema("answers"), &told), told), (None, Value::Array(Vec::new())));
    };
    none(&["query", &map, "nearest", "--json"], "x,y");
    none(&["match", &map, "--json"], "time,x,y");
    for command in [&["query", &map, "nearest"][..], &["match", &map], &["check", &map]] {
        let both = [command, &["--json", "--format", "json"]].concat();
        let output = scene.place.command().args(&both).output().expect("runs");
        assert_eq!(output.status.code(), Some(2), "{both:?}: one of them is enough");
    }
}

/// Every command that reports something has `--json`, a schema, and its line on the page of promises.
#[test]
fn commands_that_report_have_json_and_a_schema() {
    let mut all = Vec::new();
    commands(&mapd::cli::command(), "", &mut all);
    let page = fs::read_to_string(workspace().join("docs/promises.md")).expect("read");
    for (name, has_json) in &all {
        let schema = PRINTED.iter().find(|(command, _)| command == name);
        assert_eq!(*has_json, schema.is_some(), "{name}: --json and a schema");
        assert_ne!(*has_json, SILENT.contains(&name.as_str()), "{name}: --json");
        if let Some((_, schema)) = schema {
            let first = name.split(' ').next().unwrap_or_default();
            let link = format!("](../schemas/{schema}.schema.json)");
            let mut cells = page.lines().filter(|line| line.contains(&link));
            assert!(cells.any(|line| line.contains(&format!("`{first}`"))), "{name}: {link}");
        }
    }
    assert_eq!(all.iter().filter(|(_, has_json)| *has_json).count(), PRINTED.len());
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
