//! What GDAL reads in exported tables, feature by feature: where queries say that it lies, with z. Also the commands that the pages show.

use crate::export_layers::{UTM, counts, export, folder};
use flatgeobuf::FgbReader;
use mapd_client::document::Quarantined;
use mapd_client::geodesy::{Geodetic, Projector};
use mapd_client::glam::DVec3;
use mapd_client::rules::LineSource;
use mapd_client::{Attach, Client, Lane, Map, Track};
use mapd_tests::maps::open;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::{carried, say};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::BufReader;
use std::path::Path;
use std::process::Command;
use std::time::SystemTime;

/// How far apart the same places may be, in the plane and in height `[m]`: GeoJSON has degrees to 1e-9.
const SAME: f64 = 1e-3;

/// The features of a table as GDAL has read it; none, said aloud, where GDAL is missing.
fn read(file: &Path) -> Option<Vec<Value>> {
    let mut command = Command::new("ogr2ogr");
    let output = command.args(["-f", "GeoJSON", "/vsistdout/"]).arg(file).output();
    let Ok(output) = output else {
        say("SKIPPED: no ogr2ogr of GDAL");
        return None;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{}: {said}", file.display());
    let mut document: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let Value::Array(features) = document["features"].take() else { panic!("{document}") };
    Some(features)
}

/// All places of a geometry, in the map's frame.
fn places(coordinates: &Value, geodetic: Option<&Projector>, out: &mut Vec<DVec3>) {
    let items = coordinates.as_array().expect("an array");
    if !items.iter().all(Value::is_number) {
        return items.iter().for_each(|item| places(item, geodetic, out));
    }
    let numbers: Vec<f64> = items.iter().filter_map(Value::as_f64).collect();
    let [x, y, z] = numbers[..] else { panic!("{coordinates} has no z") };
    let place = Geodetic { latitude: y, longitude: x, altitude: z };
    let place = geodetic.map(|projector| projector.from_geodetic(place).expect("on the map"));
    out.push(place.unwrap_or(DVec3::new(x, y, z)));
}

/// Places that a feature must have, by queries about what its columns name; of several lists one.
fn expected(map: Map<'_>, layer: &str, columns: &Value) -> Vec<Vec<DVec3>> {
    let text = |column: &str| columns[column].as_str().unwrap_or_default();
    let number = |column: &str| columns[column].as_f64().expect("a number");
    let lane = |column: &str| -> Lane<'_> {
        map.lane_by_key(&text(column).parse().expect("a key")).expect("a lane")
    };
    let across = |s: f64| lane("key").edge_points_at(s).expect("edges").to_vec();
    let both = || [across(number("s_from_m")), across(number("s_to_m"))].concat();
    match layer {
        "lanes" | "overlay" => vec![both()],
        "center_lines" => vec![lane("key").center_line().positions().collect()],
        "borders" => {
            let lane = lane("key");
            let [from, to] = ["s_from_m", "s_to_m"].map(number);
            let middle = 0.5 * (from + to);
            let mark = lane.road_marks().find(|mark| (mark.s() < middle) & (middle < mark.s_end()));
            assert_eq!(columns["mark"].as_str(), mark.map(|mark| mark.kind().name()), "{columns}");
            let place = |s: f64| {
                let track = Track { s, t: lane.edges_at(s).outer, h: 0.0 };
                lane.road().to_inertial(track).expect("a place").position
            };
            vec![vec![place(from), place(to)]]
        }
        "stop_lines" => vec![across(number("s_m"))],
        "crosswalks" if text("source") == "signal" => {
            let lines = map.lane_by_key(&text("lanes").parse().expect("a key")).expect("a lane");
            let edges = |s: f64| lines.edge_points_at(s).expect("edges").to_vec();
            lines.crossings().map(|line| edges(line.s)).collect()
        }
        "crosswalks" | "objects" => {
            let object = map.object_by_id(text("id")).expect("an object");
            let of = object.placements().flat_map(|place| {
                let mut corners = Vec::new();
                place.footprint(&mut corners);
                let outlines = place.outlines().map(|one| one.positions().collect());
                outlines.chain([corners]).collect::<Vec<Vec<DVec3>>>()
            });
            of.filter(|places| !places.is_empty()).collect()
        }
        "signals" => vec![vec![map.signal_by_id(text("id")).expect("a signal").position()]],
        "edges" => {
            let middle = 0.5 * (number("from_s_from_m") + number("from_s_to_m"));
            vec![vec![lane("from").pose_at(middle, 0.0).expect("a pose").position]]
        }
        "findings" => {
            let is_it = |part: &Quarantined<'_>| part.id() == text("id");
            let part = map.quarantined().find(is_it).expect("a part");
            let extent = part.extent().expect("a place");
            let low = map.bounds().low.z;
            vec![vec![extent.low.extend(low), extent.high.extend(low)]]
        }
        _ => panic!("no layer {layer}"),
    }
}

/// Compares all features of a table with a map; `counts` are their numbers in each layer.
fn compare(features: &[Value], map: Map<'_>, counts: &BTreeMap<&str, usize>, is_geodetic: bool) {
    let projector = is_geodetic.then(|| map.projector().expect("a projector"));
    let mut found: BTreeMap<&str, usize> = counts.keys().map(|layer| (*layer, 0)).collect();
    for feature in features {
        let columns = &feature["properties"];
        let layer = columns["layer"].as_str().expect("a layer");
        *found.entry(layer).or_default() += 1;
        let mut own = Vec::new();
        places(&feature["geometry"]["coordinates"], projector.as_ref(), &mut own);
        let is_own = |place: &DVec3| own.iter().any(|one| (one - place).abs().max_element() < SAME);
        let wanted = expected(map, layer, columns);
        let is_there = wanted.iter().any(|places| places.iter().all(is_own));
        assert!(is_there, "{feature} is not at one of {wanted:?}");
    }
    assert_eq!(&found, counts);
}

/// Every feature of every layer in both formats, parts that are left out among them.
#[test]
fn gdal_finds_every_feature_where_the_map_has_it() {
    let (folder, mut maps) = folder(UTM);
    let whole = fs::read_to_string(folder.path().join("objects.xodr")).expect("a map");
    let part = r#"<object id="broken" type="tree" s="50" t="left" zOffset="0"/></objects><signals>
        <signal id="stop" s="40" t="-5" zOffset="2" orientation="+" dynamic="no" country="DE" type="294" subtype="-1" value="-1"/>
        <signal id="crossing" s="20" t="-5" zOffset="2" orientation="+" dynamic="no" country="DE" type="293" subtype="-1" value="-1"/></signals>"#;
    maps.push(folder.path().join("broken.xodr"));
    fs::write(&maps[maps.len() - 1], whole.replacen("</objects>", part, 1)).expect("written");
    let (mut seen, mut crossed) = (BTreeMap::new(), false);
    for path in maps {
        let snapshot = open(&path);
        let mut counts = counts(snapshot.map());
        counts.retain(|_, count| *count > 0);
        for format in ["geojson", "flatgeobuf"] {
            let out = folder.path().join("out");
            let name = path.to_str().expect("a path");
            export(&[name, "--format", format, "-o", "out"], folder.path());
            let Some(features) = read(&out) else { return };
            compare(&features, snapshot.map(), &counts, format == "geojson");
        }
        seen.append(&mut counts);
        let mut lines = snapshot.map().lanes().flat_map(|lane| lane.crossings());
        crossed |= lines.any(|line| matches!(line.source, LineSource::Signal(_)));
    }
    assert!(crossed, "no crosswalk by a signal");
    let layers: Vec<&str> = seen.into_keys().collect();
    assert_eq!(
        layers,
        [
            "borders",
            "center_lines",
            "crosswalks",
            "edges",
            "findings",
            "lanes",
            "objects",
            "signals",
            "stop_lines"
        ]
    );
}

#[test]
fn gdal_finds_what_an_overlay_says_now() {
    let (folder, _) = folder(UTM);
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let file = folder.path().join("surfaces.xodr");
    let _daemon = place.serve(&[&file.display().to_string()]);
    let text = r#"{"entries":[{"id":"works","kind":"closed","lanes":[{"road":"shape"}]},{"id":"slow","kind":"speed","value":5,"lanes":[{"road":"crossfall","s":[10,20]}]}]}"#;
    let entries = folder.path().join("works.json");
    fs::write(&entries, text).expect("written");
    let mut command = place.command();
    let laid = command.args(["overlay", "surfaces", "apply"]).arg(&entries).output().expect("ends");
    assert!(laid.status.success(), "{laid:?}");
    let client = Client::connect_as(Attach::Observer, &place.domain(), "surfaces", PATIENCE);
    let snapshot = client.expect("attaches").snapshot();
    let count = snapshot.view(SystemTime::now()).restrictions().count();
    assert!(count > 1, "{count} stretches");
    for format in ["geojson", "flatgeobuf"] {
        let out = folder.path().join("out");
        let mut command = place.command();
        command.args(["export", "shm:surfaces", "--format", format, "--layers", "overlay", "-o"]);
        let written = command.arg(&out).output().expect("ends");
        assert!(written.status.success(), "{written:?}");
        let Some(features) = read(&out) else { return };
        compare(&features, snapshot.map(), &[("overlay", count)].into(), format == "geojson");
    }
}

/// GDAL's commands of docs/export.md do what they say.
#[test]
fn commands_of_the_page_run() {
    let (folder, _) = folder(UTM);
    export(&["objects.xodr", "--format", "flatgeobuf", "-o", "map.fgb"], folder.path());
    let page =
        carried("objects.xodr").ancestors().nth(3).expect("the workspace").join("docs/export.md");
    let page = fs::read_to_string(page).expect("a page");
    let is_gdal = |line: &&str| line.starts_with("ogrinfo ") || line.starts_with("ogr2ogr ");
    let commands: Vec<&str> = page.lines().filter(is_gdal).collect();
    assert_eq!(commands.len(), 4, "{commands:?}");
    let counts = counts(open(&folder.path().join("objects.xodr")).map());
    if read(&folder.path().join("map.fgb")).is_none() {
        return;
    }
    for command in commands {
        let mut shell = Command::new("sh");
        let output = shell.args(["-c", command]).current_dir(folder.path()).output().expect("runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{command}: {said}");
    }
    for layer in ["lanes", "borders"] {
        let mut info = Command::new("ogrinfo");
        info.args(["-ro", "-so", "map.gpkg", layer]).current_dir(folder.path());
        let output = info.output().expect("runs");
        let summary = String::from_utf8_lossy(&output.stdout);
        assert!(summary.contains(&format!("Feature Count: {}\n", counts[layer])), "{summary}");
        assert!(summary.contains("Geometry: 3D "), "{summary}");
    }
}

/// How many features the index of a file finds in a box; the file must have one.
fn found_by_index(file: &Path, [a, b, c, d]: [f64; 4]) -> usize {
    let reader = BufReader::new(fs::File::open(file).expect("a file"));
    let reader = FgbReader::open(reader).expect("FlatGeobuf");
    let found = reader.select_bbox(a, b, c, d).expect("an index");
    found.features_count().expect("a number")
}

/// GDAL finds by the index of a FlatGeobuf file what it finds in a file without one, which it reads whole. There is an index, and it leaves out what lies far
/// away.
#[test]
fn a_box_has_the_features_that_lie_in_it() {
    let (folder, maps) = folder(UTM);
    let layers = ["lanes", "borders", "edges"];
    let run = |program: &str, arguments: &[&str]| {
        Command::new(program).args(arguments).current_dir(folder.path()).output().ok()
    };
    // Rows in any order, that of names first.
    let rows = |file: &str, sides: [f64; 4]| -> Option<BTreeSet<String>> {
        let sides = sides.map(|side| side.to_string());
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| sides[i].as_str());
        let arguments = ["-f", "CSV", "/vsistdout/", "-spat", a, b, c, d, file];
        let output = run("ogr2ogr", &arguments)?;
        assert!(output.status.success(), "{output:?}");
        Some(String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect())
    };
    // The same of each of several boxes, by one run: GDAL takes far longer to start than to read.
    let rows_of_each = |file: &str, layer: &str, boxes: &[[f64; 4]]| -> Vec<BTreeSet<String>> {
        let one = |(i, [a, b, c, d]): (usize, &[f64; 4])| {
            format!(
                "<OGRVRTLayer name=\"{i}\"><SrcDataSource>{file}</SrcDataSource><SrcLayer>{layer}</SrcLayer>\
                 <SrcRegion>POLYGON(({a} {b},{c} {b},{c} {d},{a} {d},{a} {b}))</SrcRegion></OGRVRTLayer>"
            )
        };
        let all: String = boxes.iter().enumerate().map(one).collect();
        let document = format!("<OGRVRTDataSource>{all}</OGRVRTDataSource>");
        fs::write(folder.path().join("boxes.vrt"), document).expect("written");
        let out = folder.path().join("boxes");
        // There is none the first time.
        let _ = fs::remove_dir_all(&out);
        let output = run("ogr2ogr", &["-f", "CSV", "boxes", "boxes.vrt"]).expect("GDAL");
        assert!(output.status.success(), "{output:?}");
        let read = |i: usize| fs::read_to_string(out.join(format!("{i}.csv"))).expect("a table");
        (0..boxes.len()).map(|i| read(i).lines().map(str::to_owned).collect()).collect()
    };
    let (mut some, mut left_out) = (0, 0);
    for (path, layer) in maps.iter().flat_map(|path| layers.map(|layer| (path, layer))) {
        let name = path.to_str().expect("a path");
        export(
            &[name, "--format", "flatgeobuf", "--layers", layer, "-o", "out.fgb"],
            folder.path(),
        );
        let bounds = open(path).map().bounds();
        let (low, size) = (bounds.low.truncate(), (bounds.high - bounds.low).truncate());
        let Some(all) = rows("out.fgb", [low.x, low.y, low.x + size.x, low.y + size.y]) else {
            say("SKIPPED: no ogr2ogr of GDAL");
            return;
        };
        // GDAL writes no file without features.
        if all.len() < 2 {
            continue;
        }
        // It does not write over one, and there is none the first time.
        let _ = fs::remove_file(folder.path().join("plain.fgb"));
        let plain = ["-f", "FlatGeobuf", "-lco", "SPATIAL_INDEX=NO", "plain.fgb", "out.fgb"];
        let output = run("ogr2ogr", &plain).expect("GDAL");
        assert!(output.status.success(), "{output:?}");
        let each = |(i, j): (i32, i32)| {
            let [x, y] = [low.x + size.x * f64::from(i) / 4.0, low.y + size.y * f64::from(j) / 4.0];
            [x, y, x + 0.25 * size.x, y + 0.25 * size.y]
        };
        let boxes: Vec<[f64; 4]> =
            (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(each).collect();
        let [found, expected] =
            ["out.fgb", "plain.fgb"].map(|file| rows_of_each(file, layer, &boxes));
        for ((sides, found), expected) in boxes.into_iter().zip(found).zip(expected) {
            assert_eq!(found, expected, "{name}: {layer} in {sides:?}");
            // Rows of text, the first of which has names, and alike ones are one.
            let by_index = found_by_index(&folder.path().join("out.fgb"), sides);
            let read = found.len().saturating_sub(1);
            assert!(read <= by_index, "{name}: {layer} in {sides:?}: {by_index} by the index");
            left_out += usize::from(by_index < all.len() - 1);
            some += usize::from(found.len() > 1 && found.len() < all.len());
        }
    }
    assert!(some > 0 && left_out > 0, "no box has some of the features");
}
