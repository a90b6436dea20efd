//! What pages say of the program is in the program: messages that a page explains, and calls that it names.

use mapd_tests::{say, workspace};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crates whose messages a user may see.
const SPEAKERS: [&str; 7] = [
    "src/query",
    "src/client",
    "src/transport",
    "src/archive",
    "src/mapd",
    "src/overlay",
    "src/export",
];

fn page(name: &str) -> String {
    fs::read_to_string(workspace().join("docs").join(name)).expect("the page can be read")
}

/// Text of all sources below folders, with texts that go on in the next line joined.
fn sources(folders: &[&str]) -> String {
    fn collect(folder: &Path, out: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("the folder can be read").flatten() {
            let path = entry.path();
            if path.is_dir() {
                collect(&path, out);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                out.push(path);
            }
        }
    }
    let mut files = Vec::new();
    for folder in folders {
        collect(&workspace().join(folder).join("src"), &mut files);
    }
    let mut text = String::new();
    for file in files {
        let source = fs::read_to_string(file).expect("a source can be read");
        let mut lines = source.lines();
        while let Some(line) = lines.next() {
            match line.strip_suffix('\\') {
                Some(begun) => {
                    text.push_str(begun);
                    text.push_str(lines.next().unwrap_or_default().trim_start());
                }
                None => text.push_str(line),
            }
            text.push('\n');
        }
    }
    text
}

/// What of the folders beside the pages the site holds, as `docs/build` copies it; of others it has the pages.
const ON_THE_SITE: [&str; 5] = ["examples", "schemas", ".ci", "LICENSE-APACHE", "LICENSE-MIT"];

#[test]
fn pages_link_only_to_what_the_site_holds() {
    let build = fs::read_to_string(workspace().join("docs/build")).expect("the script can be read");
    let copied = build.lines().find(|line| line.starts_with("git ls-files")).expect("it copies");
    assert!(ON_THE_SITE.iter().all(|part| copied.contains(part)), "{copied}");
    let mut links = 0;
    for entry in fs::read_dir(workspace().join("docs")).expect("there are pages").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.ends_with(".md") {
            continue;
        }
        let text = page(&name);
        for target in text.split("](../").skip(1).filter_map(|rest| rest.split([')', '#']).next()) {
            // The site leaves out what is written about the tests.
            let is_page = target.ends_with(".md") && !target.starts_with("tests/");
            let is_there =
                is_page || ON_THE_SITE.iter().any(|part| Path::new(target).starts_with(part));
            assert!(is_there, "{name} links to {target}, which the site has not");
            links += 1;
        }
    }
    assert!(links > 0, "no page links beyond its folder");
}

#[test]
fn messages_that_troubleshooting_explains_exist() {
    let told = sources(&SPEAKERS);
    let page = page("troubleshooting.md");
    let messages: Vec<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `"))
        .filter_map(|line| line.split('`').next())
        .collect();
    assert!(messages.len() > 20, "the page has {} messages", messages.len());
    let gone: Vec<&&str> = messages.iter().filter(|message| !told.contains(**message)).collect();
    assert!(gone.is_empty(), "no source says {gone:?}");
}

/// Variables of the page and the types that they have.
const OWNERS: [(&str, &str); 6] = [
    ("map", "mapd_query::Map"),
    ("lane", "mapd_query::Lane"),
    ("road", "mapd_query::Road"),
    ("node", "mapd_query::graph::LaneNode"),
    ("path", "mapd_query::path::Path"),
    ("projector", "mapd_geodesy::Projector"),
];

/// Each call is one of the type that the page calls it on, not only of some type.
#[test]
fn calls_that_migration_names_exist() {
    let libraries = ["mapd-query.txt", "mapd-geodesy.txt"].map(|name| page(&format!("api/{name}")));
    let known = |of: &str, name: &str| {
        let lines = libraries.iter().flat_map(|text| text.lines());
        let mut calls = lines.filter_map(|line| line.split_once(&format!("fn {of}")));
        calls.any(|(_, rest)| {
            let generic = rest.strip_prefix('<').and_then(|rest| rest.split_once('>'));
            let call = generic.map_or(rest, |(_, rest)| rest).strip_prefix("::");
            let end = call.and_then(|call| call.strip_prefix(name));
            end.is_some_and(|end| end.starts_with(['(', '<']))
        })
    };
    let page = page("migration.md");
    let mut calls = 0;
    for line in page.lines().filter(|line| line.starts_with('|')) {
        let ours = line.trim_end_matches('|').rsplit('|').next().unwrap_or_default();
        for code in ours.split('`').skip(1).step_by(2) {
            for (owner, of) in OWNERS {
                let Some((before, call)) = code.split_once(&format!("{owner}.")) else { continue };
                if before.ends_with(|c: char| c.is_alphanumeric() || c == '"') {
                    continue;
                }
                let is_name = |c: &char| c.is_ascii_alphanumeric() || *c == '_';
                let name: String = call.chars().take_while(is_name).collect();
                assert!(known(of, &name), "{of} has no `{name}`: {line}");
                calls += 1;
            }
        }
    }
    assert!(calls > 40, "the page names {calls} calls");
}

/// Formats that maps are written in, each with the page and the picture that shows what becomes of it.
const PICTURES: [(&str, &str, &[&str]); 6] = [
    ("`svg`", "export.md", &["objects.svg"]),
    ("`html`", "view.md", &["view.png"]),
    ("`geojson`", "export.md", &["geojson.png"]),
    ("`flatgeobuf`", "export.md", &["flatgeobuf.png", "qgis.png"]),
    ("`mapd-foxglove`", "export.md", &["mcap.png"]),
    ("`lanelet2`", "export.md", &["lanelet2.png"]),
];

/// Pictures that `docs/pictures/where_am_i.py` draws, with what an answer has put into each.
const ANSWERS: [(&str, &str); 3] =
    [("candidates.svg", " %</text>"), ("trace.svg", "<circle"), ("nearest_marks.svg", "<circle")];

#[test]
fn the_page_on_localisation_shows_its_answers() {
    for (picture, answer) in ANSWERS {
        assert!(page("localisation.md").contains(&format!("](pictures/{picture})")), "{picture}");
        let file = workspace().join("docs/pictures").join(picture);
        let text = fs::read_to_string(&file).expect("the picture can be read");
        assert!(text.starts_with("<?xml") && text.matches(answer).count() > 1, "{picture}");
    }
}

/// The pictures are those that this program's answers make.
#[test]
fn pictures_of_answers_are_drawn_again_alike() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = workspace().join("docs/pictures/where_am_i.py");
    let mut python = Command::new("python3");
    let program = python.arg(script).arg(env!("CARGO_BIN_EXE_mapd_under_test")).arg(folder.path());
    let drawn = match program.output() {
        Ok(drawn) => drawn,
        Err(error) if error.kind() == ErrorKind::NotFound => return say("SKIPPED: no python3"),
        Err(error) => panic!("{error}"),
    };
    assert!(drawn.status.success(), "{}", String::from_utf8_lossy(&drawn.stderr));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), ANSWERS.len());
    for (picture, _) in ANSWERS {
        let [kept, drawn] = [&workspace().join("docs/pictures"), folder.path()]
            .map(|folder| fs::read(folder.join(picture)).expect("the picture can be read"));
        assert!(kept == drawn, "run docs/pictures/where_am_i.py: {picture} is another");
    }
}

#[test]
fn every_format_has_a_picture() {
    let text = page("export.md");
    let (_, table) = text.split_once("| format | content |").expect("a table of formats");
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let formats: Vec<&str> = rows.filter_map(|row| row.split_whitespace().nth(1)).collect();
    assert_eq!(formats, PICTURES.map(|(format, ..)| format));
    for (format, name, pictures) in PICTURES {
        for picture in pictures {
            let link = format!("](pictures/{picture})");
            assert!(page(name).contains(&link), "{format}: {name} does not show {picture}");
            let file = workspace().join("docs/pictures").join(picture);
            assert!(file.is_file(), "{}", file.display());
        }
    }
}
