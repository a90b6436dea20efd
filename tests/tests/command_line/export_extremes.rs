//! `mapd export` of maps with nothing in them, with very much, and with names that would be markup.

use mapd_tests::carried;
use mapd_tests::maps::open_text;
use quick_xml::Reader;
use quick_xml::events::Event;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
/// All formats, each with what keeps the time of writing short.
const FORMATS: [&[&str]; 5] =
    [&["svg"], &["geojson", "--layers", "lanes,edges"], &["flatgeobuf"], &["html"], &["lanelet2"]];
/// Roads of the large map, and lanes on each side of them.
const LARGE: (usize, i32) = (10_000, 5);
/// Address space in which the large map must be written, with its archive and the program itself `[kB]`.
const SPACE: usize = 500_000;

fn export(folder: &Path, map: &str, format: &[&str], limit: &str) -> Output {
    let command = format!("{limit} exec \"$0\" export {map} -o out --format \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &command, MAPD]).args(format).current_dir(folder).output().expect("runs")
}

fn document(roads: &str) -> String {
    let place = "<geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference>";
    format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\">{place}</header>{roads}</OpenDRIVE>")
}

#[test]
fn a_map_without_lanes_is_a_file_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("map.xodr"), document("")).expect("written");
    for format in FORMATS {
        let output = export(folder.path(), "map.xodr", format, "");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{format:?}: {said}");
        let bytes = fs::read(folder.path().join("out")).expect("written");
        match format[0] {
            "geojson" => {
                let document: serde_json::Value = serde_json::from_slice(&bytes).expect("JSON");
                assert_eq!(document["features"], serde_json::json!([]));
            }
            "flatgeobuf" => assert_eq!(&bytes[..3], b"fgb"),
            "html" => assert!(bytes.starts_with(b"<!doctype html>")),
            _ => {
                let text = std::str::from_utf8(&bytes).expect("UTF-8");
                assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
                texts(text);
            }
        }
    }
}

/// Memory grows with the map, by less than what a planner has for it.
#[test]
fn a_hundred_thousand_lanes_need_little_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut roads = String::new();
    let lane = |number: i32| {
        format!(
            "<lane id=\"{number}\" type=\"driving\"><width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane>"
        )
    };
    let (count, side) = LARGE;
    let left: String = (1..=side).rev().map(lane).collect();
    let right: String = (1..=side).map(|number| lane(-number)).collect();
    for road in 0..count {
        let (x, y) = (500_000 + 60 * (road % 300), 5_400_000 + 60 * (road / 300));
        write!(
            roads,
            "<road id=\"{road}\" length=\"50\" junction=\"-1\"><planView><geometry s=\"0\" x=\"{x}\" y=\"{y}\" hdg=\"0\" length=\"50\"><line/>\
             </geometry></planView><lanes><laneSection s=\"0\"><left>{left}</left><center><lane id=\"0\" type=\"none\"/></center>\
             <right>{right}</right></laneSection></lanes></road>"
        )
        .expect("a string");
    }
    let snapshot = open_text(&document(&roads));
    fs::write(folder.path().join("map.mapd"), snapshot.bytes()).expect("written");
    for format in FORMATS {
        let limit = format!("ulimit -v {SPACE};");
        let output = export(folder.path(), "map.mapd", format, &limit);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{format:?}: {said}");
    }
}

/// All text of a document, which must be well-formed.
fn texts(document: &str) -> Vec<String> {
    let mut reader = Reader::from_str(document);
    let mut texts = vec![String::new()];
    loop {
        let mut add = |text: &str| texts.last_mut().expect("one").push_str(text);
        match reader.read_event().expect("well-formed XML") {
            Event::Eof => return texts,
            Event::Text(text) => add(&text),
            Event::GeneralRef(name) => add(match &*name {
                "lt" => "<",
                "gt" => ">",
                "amp" => "&",
                other => panic!("{other}"),
            }),
            Event::Start(_) | Event::End(_) => texts.push(String::new()),
            _ => {}
        }
    }
}

#[test]
fn names_are_text_in_a_drawing() {
    let folder = tempfile::tempdir().expect("a folder");
    let hostile = "</title></path><script>alert(1)</script><![CDATA[\"'&amp;";
    let escaped = hostile.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let text = fs::read_to_string(carried("one_road.xodr")).expect("a map");
    let things = format!(
        "</lanes><objects><object id=\"{escaped}\" name=\"{escaped}\" type=\"barrier\" s=\"9\" t=\"9\" zOffset=\"0\" length=\"1\" width=\"1\"/>\
         </objects><signals><signal s=\"20\" t=\"-5\" id=\"{escaped}\" dynamic=\"no\" orientation=\"+\" zOffset=\"2\" type=\"274\" subtype=\"-1\"/></signals>"
    );
    let id = format!("id=\"{escaped}\" junction");
    let text = text.replacen("</lanes>", &things, 1).replacen("id=\"1\" junction", &id, 1);
    fs::write(folder.path().join("map.xodr"), text).expect("written");
    let output = export(folder.path(), "map.xodr", &["svg"], "");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let drawing = fs::read_to_string(folder.path().join("out")).expect("written");
    assert!(!drawing.contains("<script"), "{drawing}");
    let told = texts(&drawing).iter().filter(|text| text.contains(hostile)).count();
    // Lanes are called by their keys, which escape ids.
    assert_eq!(told, 2, "an object and a signal");
}
