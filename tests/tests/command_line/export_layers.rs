//! `mapd export --format geojson` and `flatgeobuf`: every feature arrives, where the map has it, as text, and read by GDAL.

use mapd_client::Bounds;
use mapd_client::objects::Object;
use mapd_client::rules::{LaneLine, LineSource};
use mapd_client::vocabulary::Class;
use mapd_client::{Lane, Map, Snapshot};
use mapd_tests::maps::open;
use mapd_tests::{carried, say};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
/// The georeference that maps without one are given.
pub(super) const UTM: &str = "+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs";
/// A plane that no EPSG code names.
const OWN_PLANE: &str = "+proj=tmerc +lat_0=48 +lon_0=11 +k=0.9999 +x_0=1000 +ellps=GRS80 +units=m";
/// A plane on an ellipsoid for which the file would have to name a datum.
const OTHER_ELLIPSOID: &str = "+proj=tmerc +lat_0=48 +lon_0=11 +ellps=bessel +units=m";
/// Length of the strips of which areas are summed up `[m]`.
const STRIP: f64 = 0.25;
/// Half a millimetre on the ground, in degrees of latitude.
const HALF_A_MILLIMETRE: f64 = 5e-9;

fn run(arguments: &[&str], folder: &Path) -> Output {
    let mut command = Command::new(MAPD);
    command.arg("export").args(arguments).current_dir(folder).output().expect("runs")
}

/// Runs it; it must be well.
pub(super) fn export(arguments: &[&str], folder: &Path) -> Output {
    let output = run(arguments, folder);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output
}

/// A folder with the carried maps, each of which has a georeference.
pub(super) fn folder(georeference: &str) -> (TempDir, Vec<PathBuf>) {
    let folder = tempfile::tempdir().expect("a folder");
    let names = ["one_road.xodr", "town.xodr", "objects.xodr", "marks.xodr", "surfaces.xodr"];
    let place = |name: &str| {
        let text = fs::read_to_string(carried(name)).expect("a map");
        let element = format!("<geoReference><![CDATA[{georeference}]]></geoReference>");
        let text = match (text.find("<geoReference>"), text.find("</header>")) {
            (Some(at), _) => {
                let end = text.find("</geoReference>").expect("its end") + "</geoReference>".len();
                format!("{}{element}{}", &text[..at], &text[end..])
            }
            (None, Some(at)) => format!("{}{element}{}", &text[..at], &text[at..]),
            (None, None) => {
                let at = text.find("<header").expect("a header");
                let end = at + text[at..].find("/>").expect("its end");
                format!("{}>{element}</header>{}", &text[..end], &text[end + 2..])
            }
        };
        let path = folder.path().join(name);
        fs::write(&path, text).expect("written");
        path
    };
    let paths = names.iter().map(|name| place(name)).collect();
    (folder, paths)
}

/// Lanes, temporary ones too.
fn lanes<'a>(map: Map<'a>) -> Vec<Lane<'a>> {
    let roads = map.roads();
    let sections = roads.flat_map(|road| road.sections().chain(road.temporary_sections()));
    sections.flat_map(|section| section.lanes()).filter(|lane| lane.number() != 0).collect()
}

/// Into how many pieces road marks cut a lane's border: where one begins or ends, another piece begins.
fn pieces(lane: &Lane<'_>) -> usize {
    let (from, to) = (lane.section().s_start(), lane.section().s_end());
    let marks = lane.road_marks().flat_map(|mark| [mark.s(), mark.s_end()]);
    let inside = marks.filter(|s| (from < *s) & (*s < to));
    let mut cuts: Vec<f64> = inside.chain([from, to]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    cuts.len() - 1
}

/// Numbers of features that a map must have.
pub(super) fn counts(map: Map<'_>) -> BTreeMap<&'static str, usize> {
    let lanes = lanes(map);
    let outlines = |object: Object<'_>| {
        object.placements().map(|place| place.outlines().len().max(1)).sum::<usize>()
    };
    let is_crossing =
        |object: &Object<'_>| matches!(object.class(), Class::Crosswalk | Class::BicycleCrossing);
    let is_signal = |line: &LaneLine| matches!(line.source, LineSource::Signal(_));
    let across = lanes.iter().flat_map(|lane| lane.crossings()).filter(is_signal).count();
    let crosswalks = map.objects().filter(is_crossing).map(outlines).sum::<usize>();
    let sections = map.roads().flat_map(|road| road.sections().chain(road.temporary_sections()));
    let borders = sections.flat_map(|section| section.lanes()).map(|lane| pieces(&lane));
    let stops = lanes.iter().map(|lane| lane.lines_to_stop_at().count()).sum();
    [
        ("lanes", lanes.len()),
        ("center_lines", lanes.len()),
        ("borders", borders.sum()),
        ("stop_lines", stops),
        ("crosswalks", crosswalks + across),
        ("signals", map.signals().len()),
        ("objects", map.objects().map(outlines).sum()),
        ("edges", map.lane_nodes().map(|node| node.edges().len()).sum()),
        ("findings", map.quarantined().len()),
    ]
    .into()
}

/// Area of all lanes in plan view `[m²]`, by strips between their exact edges.
fn area(map: Map<'_>) -> f64 {
    let lane = |lane: &Lane<'_>| {
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        let count = ((to - from) / STRIP).ceil().max(1.0) as usize;
        let edges = |i: usize| {
            let s = from + (to - from) * i as f64 / count as f64;
            lane.edge_points_at(s).expect("edges").map(|point| point.truncate())
        };
        let strip = |i: usize| {
            let ([a, b], [c, d]) = (edges(i), edges(i + 1));
            0.5 * (d - a).perp_dot(c - b).abs()
        };
        (0..count).map(strip).sum::<f64>()
    };
    lanes(map).iter().map(lane).sum()
}

/// All numbers of a coordinate array, position by position.
fn positions(value: &Value, out: &mut Vec<Vec<f64>>) {
    let items = value.as_array().expect("an array");
    if items.iter().all(Value::is_number) {
        out.push(items.iter().filter_map(Value::as_f64).collect());
    } else {
        items.iter().for_each(|item| positions(item, out));
    }
}

#[test]
fn geojson_has_every_feature_at_its_place() {
    let (folder, maps) = folder(UTM);
    for path in maps {
        let snapshot = open(&path);
        let map = snapshot.map();
        let name = path.to_str().expect("a path");
        export(&[name, "--format", "geojson", "-o", "out.geojson"], folder.path());
        let text = fs::read_to_string(folder.path().join("out.geojson")).expect("written");
        let document: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(document["type"], "FeatureCollection");
        let features = document["features"].as_array().expect("features");
        for (layer, expected) in counts(map) {
            let of_layer = features.iter().filter(|f| f["properties"]["layer"] == layer);
            assert_eq!(of_layer.count(), expected, "{layer} of {name}");
        }
        let projector = map.projector().expect("a projector");
        let Bounds { low, high } = map.bounds();
        for feature in features {
            let mut places = Vec::new();
            positions(&feature["geometry"]["coordinates"], &mut places);
            assert!(places.iter().all(|place| place.len() == 3), "{feature}");
            if feature["properties"]["layer"] != "center_lines" {
                continue;
            }
            let key = feature["properties"]["key"].as_str().expect("a key").parse().expect("a key");
            let lane = map.lane_by_key(&key).expect("a lane");
            for place in places {
                let [longitude, latitude, altitude] = place[..] else { panic!("{place:?}") };
                let geodetic = mapd_client::geodesy::Geodetic { latitude, longitude, altitude };
                let point = projector.from_geodetic(geodetic).expect("a point");
                assert!((low.x - 1.0..high.x + 1.0).contains(&point.x), "{point}");
                let near = |p: mapd_client::glam::DVec3| (p - point).length() < 1e-3;
                assert!(lane.continues() || lane.center_line().positions().any(near), "{point}");
            }
        }
    }
}

#[test]
fn areas_of_geojson_run_counter_clockwise() {
    let (folder, maps) = folder(UTM);
    for path in maps {
        let name = path.to_str().expect("a path");
        let output = export(&[name, "--format", "geojson", "--layers", "lanes"], folder.path());
        let document: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let features = document["features"].as_array().expect("features");
        assert!(!features.is_empty());
        for feature in features {
            let mut ring = Vec::new();
            positions(&feature["geometry"]["coordinates"], &mut ring);
            assert_eq!(ring.first(), ring.last(), "{feature}");
            let origin = ring[0].clone();
            let cross = |p: &[Vec<f64>]| {
                let [ax, ay] = [p[0][0] - origin[0], p[0][1] - origin[1]];
                ax * (p[1][1] - origin[1]) - (p[1][0] - origin[0]) * ay
            };
            let twice: f64 = ring.windows(2).map(cross).sum();
            assert!(twice >= -HALF_A_MILLIMETRE * HALF_A_MILLIMETRE, "{feature}");
        }
    }
}

#[test]
fn what_a_map_says_is_text_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let hostile = "</script><script>alert(\"1\")</script>'\\\",\"x\":[";
    let attribute = hostile.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let text = fs::read_to_string(carried("one_road.xodr")).expect("a map");
    assert!(text.contains("Hill Road"));
    fs::write(folder.path().join("map.xodr"), text.replace("Hill Road", &attribute))
        .expect("written");
    for format in ["geojson", "flatgeobuf"] {
        export(&["map.xodr", "--format", format, "-o", "out"], folder.path());
        let bytes = fs::read(folder.path().join("out")).expect("written");
        if format == "geojson" {
            let document: Value = serde_json::from_slice(&bytes).expect("JSON");
            let names = document["features"].as_array().expect("features").iter();
            let mut names = names.filter_map(|f| f["properties"]["road_name"].as_str());
            assert!(names.all(|name| name == hostile));
        } else {
            assert!(bytes.windows(hostile.len()).any(|bytes| bytes == hostile.as_bytes()));
        }
    }
}

#[test]
fn a_map_without_a_georeference_is_told_what_to_add() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = carried("town.xodr");
    let name = map.to_str().expect("a path");
    let output = run(&[name, "--format", "geojson", "-o", "out.geojson"], folder.path());
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("header/geoReference") && said.contains("+proj="), "{said}");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0, "a half file");
    export(&[name, "--format", "flatgeobuf", "-o", "out.fgb"], folder.path());
}

#[test]
fn a_file_that_cannot_be_finished_leaves_the_old_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = carried("one_road.xodr");
    let name = map.to_str().expect("a path");
    for format in ["svg", "geojson", "flatgeobuf", "lanelet2", "html"] {
        fs::write(folder.path().join("out"), "old").expect("written");
        // The bound on a file's size stands for a full disk: writing fails on the way.
        let command = format!(
            "trap '' XFSZ; ulimit -f 1; exec {MAPD} export {name} --format {format} -o out"
        );
        let mut shell = Command::new("sh");
        let output =
            shell.args(["-c", &command]).current_dir(folder.path()).output().expect("runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{format}: {said}");
        let is_plain = said.contains("File too large (os error 27)") && !said.contains("serializ");
        assert!(is_plain, "{format}: {said}");
        assert_eq!(fs::read_to_string(folder.path().join("out")).expect("there"), "old");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "a half file");
        let output = run(&[name, "--format", format, "-o", "/dev/full"], folder.path());
        assert_eq!(output.status.code(), Some(1), "{format}");
    }
}

/// What `ogrinfo` says of a file; none, said aloud, where GDAL is missing.
fn ogrinfo(file: &Path, arguments: &[&str]) -> Option<String> {
    match Command::new("ogrinfo").args(["-ro", "-al"]).args(arguments).arg(file).output() {
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success() && said.is_empty(), "{}: {said}", file.display());
            Some(String::from_utf8_lossy(&output.stdout).into_owned())
        }
        Err(error) => {
            say(&format!("SKIPPED in part: no ogrinfo of GDAL: {error}"));
            None
        }
    }
}

/// The number of features in `ogrinfo`'s summary.
fn feature_count(summary: &str) -> usize {
    let line = summary.lines().find_map(|line| line.strip_prefix("Feature Count: "));
    line.and_then(|count| count.trim().parse().ok()).unwrap_or_else(|| panic!("{summary}"))
}

/// GDAL reads layer by layer as many features as there are, with z, in the frame that is meant.
fn check(format: &str, georeference: &str, frame: &[&str]) {
    let (folder, maps) = folder(georeference);
    for path in maps {
        let snapshot: Snapshot = open(&path);
        let name = path.to_str().expect("a path");
        export(&[name, "--format", format, "-o", "all"], folder.path());
        let mut all = counts(snapshot.map());
        // GDAL knows no columns of a GeoJSON file without features.
        all.retain(|_, count| *count > 0 || format != "geojson");
        let Some(listed) = ogrinfo(&folder.path().join("all"), &["-q", "-geom=NO"]) else { return };
        // By a filter once, which takes a run of its own.
        if let Some((layer, expected)) = all.iter().next() {
            let clause = format!("layer = '{layer}'");
            let summary = ogrinfo(&folder.path().join("all"), &["-so", "-where", &clause]);
            assert_eq!(feature_count(&summary.expect("GDAL")), *expected, "{layer} of {name}");
        }
        for (layer, expected) in &all {
            let column = format!("layer (String) = {layer}");
            let found = listed.lines().filter(|line| line.trim() == column).count();
            assert_eq!(found, *expected, "{layer} of {name}");
            export(&[name, "--format", format, "--layers", layer, "-o", "one"], folder.path());
            let summary = ogrinfo(&folder.path().join("one"), &["-so"]).expect("GDAL");
            assert_eq!(feature_count(&summary), *expected, "{layer} of {name} alone");
            for words in frame {
                assert!(summary.contains(words), "{words} of {layer}: {summary}");
            }
            if *layer == "lanes" {
                assert!(summary.contains("Geometry: 3D Polygon"), "{summary}");
            }
        }
    }
}

#[test]
fn gdal_reads_geojson() {
    check("geojson", UTM, &["GEOGCRS[\"WGS 84\""]);
}

#[test]
fn gdal_reads_flatgeobuf() {
    check("flatgeobuf", UTM, &["ID[\"EPSG\",32632]"]);
}

#[test]
fn gdal_reads_flatgeobuf_in_a_plane_of_its_own() {
    check("flatgeobuf", OWN_PLANE, &["PROJCRS[", "298.257222101", "0.9999"]);
}

#[test]
fn gdal_reads_flatgeobuf_of_another_ellipsoid() {
    check("flatgeobuf", OTHER_ELLIPSOID, &["ID[\"EPSG\",4326]"]);
}

#[test]
fn areas_that_gdal_computes_are_those_of_the_queries() {
    let (folder, maps) = folder(UTM);
    for path in maps {
        let snapshot = open(&path);
        let name = path.to_str().expect("a path");
        export(
            &[name, "--format", "flatgeobuf", "--layers", "lanes", "-o", "out.fgb"],
            folder.path(),
        );
        let sql = ["-q", "-sql", "SELECT OGR_GEOM_AREA AS area FROM lanes"];
        let mut info = Command::new("ogrinfo");
        info.arg("-ro").args(sql).arg("out.fgb").current_dir(folder.path());
        let Ok(output) = info.output() else {
            say("SKIPPED: no ogrinfo of GDAL");
            return;
        };
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let areas = said.lines().filter_map(|line| line.trim().strip_prefix("area (Real) = "));
        let found: f64 = areas.map(|area| area.parse::<f64>().expect("a number")).sum();
        let expected = area(snapshot.map());
        assert!((found - expected).abs() <= 2e-3 * expected, "{name}: {found}, {expected}");
    }
}
