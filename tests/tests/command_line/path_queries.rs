//! `mapd query … path`, `corridor`, `project`, `conflicts` and `speed`: columns, values, and JSON of every kind.

use mapd_tests::command;
use mapd_tests::json_schema::{schema, wrong};
use std::collections::BTreeSet;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const ROUTE: &str = "from_road,from_s,from_lane,to_road,to_s,to_lane";

/// The answer of a query on the carried town.
fn query(map: &str, args: &[&str], input: &str) -> String {
    let map = mapd_tests::carried(map).display().to_string();
    let output = command::run(MAPD, &[&["query", &map], args].concat(), input);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{args:?}: {:?}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("text")
}

fn rows(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    let fields = |row: csv::StringRecord| row.iter().map(str::to_owned).collect();
    reader.records().map(|row| fields(row.expect("a row"))).collect()
}

#[test]
fn a_path_is_told_station_by_station() {
    let input = format!("{ROUTE}\n1,2,-1,1,12,-1\n");
    let found = rows(&query("one_road.xodr", &["path", "--step", "4"], &input));
    let columns = "S,x,y,z,hdg,curvature,lane,left,right,speed,error";
    assert_eq!(found[0].join(","), format!("{ROUTE},{columns}"));
    let stations: Vec<&str> = found[1..].iter().map(|row| row[6].as_str()).collect();
    assert_eq!(stations, ["0.0", "4.0", "8.0", "10.0"]);
    assert_eq!(
        &found[1][7..],
        ["2.0", "-1.75", "10.0", "0.0", "0.0", "1:0:-1", "1.75", "1.75", &found[1][15], ""]
    );
}

#[test]
fn a_corridor_has_both_edges_and_their_marks() {
    let input = format!("{ROUTE}\n1,2,-1,1,3,-1\n");
    let found = rows(&query("one_road.xodr", &["corridor"], &input));
    let columns = "S,left_x,left_y,right_x,right_y,left_mark,right_mark,left_may_cross,right_may_cross,\
         left_edge,right_edge,speed,friction,error";
    assert_eq!(found[0].join(","), format!("{ROUTE},{columns}"));
    assert_eq!(&found[1][6..11], ["0.0", "2.0", "0.0", "2.0", "-3.5"]);
    assert_eq!(found.len(), 3);
}

#[test]
fn points_are_projected_on_a_path() {
    let input = format!(
        "{ROUTE},x,y,hdg\n1,2,-1,1,12,-1,5,-1,0.25\n1,2,-1,1,12,-1,0,-1.75,0\n1,2,-1,1,12,-1,20,-1.75,0\n1,2,-1,x,12,-1,0,0,0\n1,2,-1,1,12,-1,NaN,0,0\n"
    );
    let found = rows(&query("one_road.xodr", &["project"], &input));
    assert_eq!(found[0][9..].join(","), "S,d,heading_difference,lane,clamped,error");
    assert_eq!(&found[1][9..], ["3.0", "0.75", "0.25", "1:0:-1", "", ""]);
    assert_eq!(&found[2][9..], ["0.0", "0.0", "0.0", "1:0:-1", "before", ""]);
    assert_eq!(&found[3][9..], ["10.0", "0.0", "0.0", "1:0:-1", "after", ""]);
    assert_eq!(found[4][14], "the map has no road \"x\"");
    assert!(found[5][14].contains("finite number in column x"));
}

#[test]
fn conflicts_and_speeds_have_their_columns() {
    let input = format!("{ROUTE}\n1,2,-1,1,12,-1\n");
    let found = rows(&query("one_road.xodr", &["conflicts"], &input));
    let columns = "S_from,S_to,other_lane,other_s_from,other_s_to,kind,yields,reason,wait_S,basis,other_lanes,error";
    assert_eq!(
        found,
        [format!("{ROUTE},{columns}").split(',').map(str::to_owned).collect::<Vec<_>>()]
    );
    let found = rows(&query("one_road.xodr", &["speed"], "road_id,s,lane_id\n1,5,-1\n1,5,99\n"));
    assert_eq!(found[0].join(","), "road_id,s,lane_id,speed,origin,error");
    let known = ["written", "sign", "entry", "default", "depends", "unknown"];
    assert!(known.contains(&found[1][4].as_str()), "{found:?}");
    assert!(found[2][5].contains("has no lane 99"), "{found:?}");
}

/// Columns of names, which stay text also where they look like numbers.
const NAMES: [&str; 7] = ["road_id", "from_road", "to_road", "junction_id", "group", "id", "value"];

/// Every kind answers the same in both forms, and as the schema of answers says.
#[test]
fn every_kind_answers_as_json() {
    let route = format!("{ROUTE}\n1,2,-1,1,12,-1\n");
    let path = format!("{ROUTE},x,y\n1,2,-1,1,12,-1,5,-1\n");
    let schema = schema("answers");
    let mut asked = BTreeSet::new();
    for (kind, input) in [
        ("inertial", "road_id,s,t\n1,5,0\nx,5,0\n"),
        ("surface", "road_id,s,t\n1,5,0\n"),
        ("lane", "road_id,s,lane_id\n1,5,-1\n"),
        ("nearest", "x,y\n5,-1\n"),
        ("track", "road_id,x,y\n1,5,1\n"),
        ("successors", "road_id,s,lane_id\n1,5,-1\n"),
        ("objects", "x,y,radius\n5,0,20\n"),
        ("signals", "road_id,s,lane_id,distance\n1,5,-1,50\n"),
        ("speed", "road_id,s,lane_id\n1,5,-1\n"),
        ("match", "x,y,hdg,sx,sy,shdg\n5,-1,0,1,1,1\n"),
        ("ground", "x,y\n5,-1\n"),
        ("nearest-marks", "x,y\n5,-1\n"),
        ("geodetic", "x,y\n5,-1\n"),
        ("from-geodetic", "lat,lon\n48.1,11.5\n"),
        ("landmarks", "x,y,radius\n5,0,20\n"),
        ("annotations", "owner,id\ndocument,\nroad,1\nnone,1\n"),
        ("visibility", "road_id,s,lane_id\n1,5,-1\n"),
        ("lane-rule", "road_id,s,lane_id\n1,5,-1\n"),
        ("junction-groups", "junction_id\n1\n"),
        ("route", &route),
        ("path", &route),
        ("corridor", &route),
        ("conflicts", &route),
        ("project", &path),
    ] {
        asked.insert(kind.to_owned());
        let table = rows(&query("one_road.xodr", &[kind], input));
        let json = query("one_road.xodr", &[kind, "--json"], input);
        let value = serde_json::from_str(&json).expect("JSON");
        assert_eq!(wrong(&schema, &value), None, "{kind}: {json}");
        for column in &table[0] {
            assert!(schema["items"]["properties"].get(column).is_some(), "{kind}: {column}");
        }
        assert_eq!(json, query("one_road.xodr", &[kind, "--format", "json"], input));
        let json: Vec<serde_json::Map<String, serde_json::Value>> =
            serde_json::from_str(&json).unwrap_or_else(|error| panic!("{kind}: {error}: {json}"));
        assert_eq!(json.len(), table.len() - 1, "{kind}");
        for (object, row) in json.iter().zip(&table[1..]) {
            assert_eq!(object.len(), row.len(), "{kind}: {object:?}");
            for (name, value) in table[0].iter().zip(row) {
                let same = match &object[name] {
                    serde_json::Value::Null => value.is_empty(),
                    serde_json::Value::Number(n) => n.as_f64() == value.parse::<f64>().ok(),
                    other => other.as_str() == Some(value),
                };
                assert!(same, "{kind}: {name} is {value:?} and {:?}", object[name]);
                let is_number = value.parse::<f64>().is_ok() && !NAMES.contains(&name.as_str());
                assert_eq!(object[name].is_number(), is_number, "{kind}: {name}");
            }
        }
    }
    let program = mapd::cli::command();
    let query = program.find_subcommand("query").expect("a command");
    let kinds = query.get_arguments().find(|arg| arg.get_id() == "kind").expect("an argument");
    let kinds = kinds.get_possible_values();
    assert_eq!(asked, kinds.iter().map(|kind| kind.get_name().to_owned()).collect());
}
