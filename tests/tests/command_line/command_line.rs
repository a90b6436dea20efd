//! What the command line promises: exit codes, columns, errors in rows.

use mapd_tests::command;
use std::io::Read;
use std::process::{Command, Output, Stdio};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn run(args: &[&str], input: &str) -> Output {
    command::run(env!("CARGO_BIN_EXE_mapd_under_test"), args, input)
}

fn one_road() -> String {
    mapd_tests::carried("one_road.xodr").display().to_string()
}

/// Runs a query on the one-road map and compares the whole output.
fn check(kind: &[&str], input: &str, expected: &str) {
    let road = one_road();
    let mut args = vec!["query", road.as_str()];
    args.extend(kind);
    let output = run(&args, input);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected, "{kind:?}: {errors}");
    assert_eq!(output.status.code(), Some(0), "{kind:?}: {errors}");
}

#[test]
fn inertial_echoes_and_answers_in_order() {
    check(
        &["inertial"],
        "t,s,road_id,note\n2,10,1,a\n-1.5,0,1,\"b,c\"\n",
        "t,s,road_id,note,x,y,z,hdg,error\n2,10,1,a,10.0,2.0,10.0,0.0,\n-1.5,0,1,\"b,c\",0.0,-1.5,10.0,0.0,\n",
    );
}

#[test]
fn rows_that_fail_keep_their_place() {
    check(
        &["inertial"],
        "road_id,s,t\n1,5,0\nx,5,0\n1,NaN,0\n1,201,0\n1,6,0\n",
        "road_id,s,t,x,y,z,hdg,error\n1,5,0,5.0,0.0,10.0,0.0,\nx,5,0,,,,,\"the map has no road \"\"x\"\"\"\n1,NaN,0,,,,,\"expected a finite number in column s, found \"\"NaN\"\"\"\n1,201,0,,,,,\"s must lie between 0 and the road's length 200.0, found 201.0\"\n1,6,0,6.0,0.0,10.0,0.0,\n",
    );
}

#[test]
fn lanes_have_edges_and_centres() {
    check(
        &["lane"],
        "road_id,s,lane_id\n1,20,-1\n1,20,2\n1,20,5\n",
        "road_id,s,lane_id,width,t_inner,t_outer,x,y,z,hdg,error\n1,20,-1,3.5,0.0,-3.5,20.0,-1.75,10.0,0.0,\n1,20,2,1.5,3.5,5.0,20.0,4.25,10.0,3.141592653589793,\n1,20,5,,,,,,,,\"road \"\"1\"\" has no lane 5 at s = 20.0\"\n",
    );
}

#[test]
fn nearest_finds_the_lane_or_says_so() {
    check(
        &["nearest"],
        "x,y\n20,-1\n20,-7\n20,300\n",
        "x,y,lane,road_id,lane_id,s,t,offset,distance,error\n20,-1,1:0:-1,1,-1,20.0,-1.0,0.75,0.0,\n20,-7,1:0:-2,1,-2,20.0,-7.0,-2.75,2.0,\n20,300,,,,,,,,no lane within 10 m\n",
    );
}

#[test]
fn nearest_takes_types_radius_vehicle_and_z() {
    check(
        &["nearest", "--types", "drivable"],
        "x,y\n20,-7\n",
        "x,y,lane,road_id,lane_id,s,t,offset,distance,error\n20,-7,1:0:-1,1,-1,20.0,-7.0,-5.25,3.5,\n",
    );
    check(
        &["nearest", "--radius", "1"],
        "x,y\n20,-7\n",
        "x,y,lane,road_id,lane_id,s,t,offset,distance,error\n20,-7,,,,,,,,no lane within 1 m\n",
    );
    // Lane -2 is a sidewalk.
    check(
        &["nearest", "--vehicle", "passengerCar"],
        "x,y\n20,-7\n",
        "x,y,lane,road_id,lane_id,s,t,offset,distance,error\n20,-7,1:0:-1,1,-1,20.0,-7.0,-5.25,3.5,\n",
    );
    check(
        &["nearest", "--z-tolerance", "2"],
        "x,y,z\n20,-1,50\n20,-1,11\n",
        "x,y,z,lane,road_id,lane_id,s,t,offset,distance,error\n20,-1,50,,,,,,,,no lane within 10 m\n20,-1,11,1:0:-1,1,-1,20.0,-1.0,0.75,0.0,\n",
    );
}

#[test]
fn a_trace_is_matched_row_by_row() {
    let input = "time,x,y,id\n0,10,-1.7,a\n1,18,-1.8,b\nx,20,-1,c\n0.5,20,-1,d\n2,26,40,e\n";
    let output = run(&["match", &one_road()], input);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0].join(","), "time,x,y,id,lane,s,offset,probability,error");
    assert_eq!(
        (rows[1][4], rows[1][5], rows[2][4], rows[2][5]),
        ("1:0:-1", "10.0", "1:0:-1", "18.0")
    );
    assert!(
        rows[3][4].is_empty() && text.contains("expected a finite number in column time"),
        "{text}"
    );
    assert!(rows[4][4].is_empty() && text.contains("time must not decrease"), "{text}");
    assert!(rows[5][4].is_empty() && !rows[5][7].is_empty() && rows[5][8].is_empty(), "{text}");
    let output = run(&["match", &one_road(), "--format", "json"], "time,x,y\n0,10,-1.7\n");
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&json[0]["lane"], &json[0]["s"]), (&"1:0:-1".into(), &10.0.into()), "{json}");
    assert!(json[0]["probability"].is_f64(), "{json}");
    let output = run(&["match", &one_road()], "time,x\n0,1\n");
    assert_eq!(output.status.code(), Some(2));
    let output = run(&["match", &one_road(), "--deviation", "0"], "time,x,y\n0,1,1\n");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn ground_and_marks_have_their_columns() {
    check(
        &["ground"],
        "x,y\n20,-1\n20,30\n",
        "x,y,z,nx,ny,nz,lane,material,level,error\n20,-1,10.0,0.0,0.0,1.0,1:0:-1,,0,\n20,30,,,,,,,,no lane holds the point\n",
    );
    let marks = mapd_tests::carried("marks.xodr").display().to_string();
    let input = "x,y\n10,6\n10,20\n";
    let output = run(&["query", &marks, "nearest-marks", "--radius", "3"], input);
    let expected = "x,y,distance,side,kind,color,lane,s,painted,error\n\
        10,6,1.0,right,edge,white,1:0:2,10.0,1,\n\
        10,20,,,,,,,,no road mark within 3 m\n";
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
    // Without a radius as far as every other interface looks.
    let output = run(&["query", &marks, "nearest-marks"], "x,y\n10,20\n");
    let usual = mapd_client::localisation::MarkFilter::default().radius;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains(&format!("no road mark within {usual} m")), "{said}");
}

#[test]
fn a_pose_is_matched_with_a_row_for_each_lane_and_one_for_none() {
    let input =
        "id,x,y,hdg,sx,sy,shdg\na,30,-1,0.02,0.3,0.3,0.05\nb,500,500,0,1,1,1\nc,1,1,0,-1,1,1\n";
    let output = run(&["query", &one_road(), "match"], input);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut lines = text.lines();
    let head = "id,x,y,hdg,sx,sy,shdg,lane,direction,probability,s,offset,heading_difference,mahalanobis,error";
    assert_eq!(lines.next(), Some(head));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let of = |id: &str| rows.iter().filter(|row| row[0] == id).collect::<Vec<_>>();
    let a = of("a");
    assert_eq!((a[0][7], a[0][8], a[0][10], a[0][11]), ("1:0:-1", "+", "30.0", "0.75"), "{text}");
    assert_eq!(a.iter().filter(|row| row[7].is_empty() && row[10].is_empty()).count(), 1, "{text}");
    let sum: f64 = a.iter().map(|row| row[9].parse::<f64>().expect("a probability")).sum();
    assert!((sum - 1.0).abs() < 1e-6, "{text}");
    assert_eq!(
        of("b"),
        [&["b", "500", "500", "0", "1", "1", "1", "", "", "1.0", "", "", "", "", ""]]
    );
    assert_eq!(of("c")[0][14], "\"sx must not be negative", "{text}");
}

#[test]
fn a_vehicle_with_an_outline_is_in_lanes_by_its_shares() {
    // Lane 1 goes the other way: of a heading that is not known, both count alike.
    let input = "x,y,hdg,sx,sy,shdg\n30,0.45,0,0,0,1000\n";
    let output = run(&["query", &one_road(), "match", "--outline", "3,1,0.9,0.9"], input);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let share = |key: &str| {
        let row = rows.iter().find(|row| row[6] == key);
        row.map(|row| row[8].parse::<f64>().expect("a probability")).expect("a row")
    };
    assert!((share("1:0:1") / share("1:0:-1") - 3.0).abs() < 1e-3, "{text}");
    for wrong in ["3,1,0.9", "3,1,0.9,-0.9", "3,1,0.9,x", "3,1,0.9,101"] {
        let output = run(&["query", &one_road(), "match", "--outline", wrong], input);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains("FRONT,BACK,LEFT,RIGHT"), "{text}");
    }
}

/// Runs a query on the one-road map and compares numbers to 1e-8 (a millimetre, where they are degrees), texts exactly:
/// projections use the C library's functions, whose last digit is not the same on every machine.
fn check_nearly(kind: &str, input: &str, expected: &[&[&str]]) {
    let output = run(&["query", &one_road(), kind], input);
    assert_eq!(output.status.code(), Some(0), "{kind}");
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(&output.stdout[..]);
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("CSV")).collect();
    assert_eq!(rows.len(), expected.len(), "{kind}");
    for (row, expected) in rows.iter().zip(expected) {
        assert_eq!(row.len(), expected.len(), "{row:?}");
        for (found, expected) in row.iter().zip(*expected) {
            match (found.parse::<f64>(), expected.parse::<f64>()) {
                (Ok(a), Ok(b)) => assert!((a - b).abs() <= 1e-8, "{row:?}: {a}, expected {b}"),
                _ => assert_eq!(found, *expected, "{row:?}"),
            }
        }
    }
}

#[test]
fn places_on_earth_go_both_ways() {
    check_nearly(
        "geodetic",
        "x,y,z\n0,0,3\n0,x,0\n",
        &[
            &["x", "y", "z", "lat", "lon", "alt", "error"],
            &["0", "0", "3", "48", "11", "3", ""],
            &["0", "x", "0", "", "", "", "expected a finite number in column y, found \"x\""],
        ],
    );
    let range = "expected a latitude of −90 to 90 and a longitude of −360 to 360 degrees";
    check_nearly(
        "from-geodetic",
        "lat,lon\n48,11\n99,11\n",
        &[
            &["lat", "lon", "x", "y", "z", "error"],
            &["48", "11", "0", "0", "0", ""],
            &["99", "11", "", "", "", range],
        ],
    );
    let found = ["lane", "road_id", "lane_id", "s", "t", "offset", "distance", "error"];
    let (head, far) = ([&["lat", "lon"][..], &found].concat(), "no lane within 10 m");
    check_nearly(
        "nearest",
        "lat,lon\n47.99999,11.0001\n49,11\n",
        &[
            &head,
            // A metre south of the road's start, seven east: figures of PROJ.
            &[
                "47.99999",
                "11.0001",
                "1:0:-1",
                "1",
                "-1",
                "7.462536798",
                "-1.111898386",
                "0.638101614",
                "0",
                "",
            ],
            &["49", "11", "", "", "", "", "", "", "", far],
        ],
    );
}

#[test]
fn without_a_georeference_every_row_says_so() {
    let town = mapd_tests::carried("town.xodr").display().to_string();
    let output = run(&["query", town.as_str(), "geodetic"], "x,y\n0,0\n");
    let expected = "x,y,lat,lon,alt,error\n0,0,,,,the map has no georeference that can be used\n";
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn track_inverts() {
    check(
        &["track"],
        "road_id,x,y,z\n1,30,2,11\n1,30,2,\n",
        "road_id,x,y,z,s,t,h,clamped,exact,error\n1,30,2,11,30.0,2.0,1.0,,1,\n1,30,2,,30.0,2.0,,,1,\n",
    );
}

#[test]
fn successors_follow_the_driving_direction() {
    check(
        &["successors"],
        "road_id,s,lane_id\n1,20,-1\n1,20,-2\n1,150,1\n1,150,-1\n1,20,1\n",
        "road_id,s,lane_id,successors,error\n1,20,-1,1:1:-1,\n1,20,-2,1:1:-3,\n1,150,1,1:0:1,\n1,150,-1,,\n1,20,1,,\n",
    );
}

#[test]
fn routes_name_their_lanes() {
    // Straight on; onto the exit lane, which lies 4 m outside a bend of 50 m; across the road; backwards; beyond its end.
    check(
        &["route"],
        "from_road,from_s,from_lane,to_road,to_s,to_lane\n1,10,-1,1,50,-1\n1,130,-1,1,150,-2\n1,150,1,1,150,-1\n1,50,-1,1,10,-1\n1,10,-1,1,9999,-1\n",
        "from_road,from_s,from_lane,to_road,to_s,to_lane,length,lane_changes,lanes,error\n1,10,-1,1,50,-1,40.0,0,1:0:-1,\n1,130,-1,1,150,-2,21.375710000460977,1,1:1:-1;1:1:-2,\n1,150,1,1,150,-1,,,,no way for passengerCar\n1,50,-1,1,10,-1,,,,no way for passengerCar\n1,10,-1,1,9999,-1,,,,\"s must lie between 0 and the road's length 200.0, found 9999.0\"\n",
    );
    check(
        &["route", "--vehicle", "pedestrian"],
        "from_road,from_s,from_lane,to_road,to_s,to_lane\n1,10,-1,1,50,-1\n",
        "from_road,from_s,from_lane,to_road,to_s,to_lane,length,lane_changes,lanes,error\n1,10,-1,1,50,-1,,,,no way for pedestrian\n",
    );
}

/// On a ring road with a way across, the way round is the alternative, and the only way where the other is avoided.
#[test]
fn alternatives_and_lanes_to_avoid() {
    let map = mapd_tests::carried("town.xodr").display().to_string();
    let head = "from_road,from_s,from_lane,to_road,to_s,to_lane";
    let lines = |args: &[&str], asked: &str| {
        let args = [&["query", &map, "route"], args].concat();
        let output = run(&args, &format!("{head}\n{asked}\n"));
        assert!(output.status.success(), "{output:?}");
        let text = String::from_utf8(output.stdout).expect("text");
        text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    };
    let asked = "1,10,-1,4,10,1";
    let best = lines(&[], asked);
    let [best] = &best[..] else { panic!("{best:?}") };
    let three = lines(&["--alternatives", "3"], asked);
    assert_eq!(&three[0], best);
    assert!(three.len() > 1 && three.iter().all(|line| line.ends_with(',')), "{three:?}");
    let lanes: Vec<&str> = best.split(',').nth(8).expect("lanes").split(';').collect();
    let middle = lanes[lanes.len() / 2];
    let around = lines(&["--avoid", middle], asked);
    let other: Vec<&str> = around[0].split(',').nth(8).expect("lanes").split(';').collect();
    assert!(other.len() > 1 && !other.contains(&middle), "{around:?}");
    for (key, why) in [("nowhere:0:-1", "no such lane"), ("1:0", "")] {
        let output = run(&["query", &map, "route", "--avoid", key], &format!("{head}\n{asked}\n"));
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(
            (output.status.code(), output.stdout.as_slice()),
            (Some(2), &b""[..]),
            "{errors}"
        );
        assert!(errors.contains(&format!("--avoid {key}: {why}")), "{errors}");
    }
}

#[test]
fn wrong_usage_ends_with_two() {
    let road = one_road();
    for args in [
        &["query", &road, "nothing"][..],
        &["nonsense"],
        &[],
        &["query", &road, "nearest", "--types", "sky"],
        &["query", &road, "route", "--vehicle", "broom"],
        &["compile", &road, "--cycles", "some"],
        &["compile", &road, "--landmarks", "33"],
    ] {
        let output = run(args, "");
        assert_eq!(
            output.status.code(),
            Some(2),
            "{args:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    let output = run(&["query", &road, "lane"], "road_id,s\n1,2\n");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("road_id,s,lane_id"));
}

#[test]
fn missing_files_end_with_one_and_bad_maps_with_four() {
    assert_eq!(run(&["inspect", "no/such.xodr"], "").status.code(), Some(1));
    assert_eq!(run(&["inspect", "no/such.mapd"], "").status.code(), Some(1));
    let folder = tempfile::tempdir().expect("a folder");
    for (text, place) in [
        ("<OpenDRIVE>\n<road id=\"1\" length=\"nan\"/></OpenDRIVE>", ":2:22: error"),
        ("<ODrive/>", ":1:1: error"),
        ("<OpenDRIVE>\n  <road>", ":2:9: error"),
        ("", ":1:1: error"),
        ("<OpenDRIVE></ODrive>", ":1:1"),
    ] {
        let path = folder.path().join("bad.xodr");
        std::fs::write(&path, text).expect("written");
        let output = run(&["compile", path.to_str().expect("text")], "");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(4), "{text:?}: {errors}");
        assert!(errors.contains(place), "{text:?}: {errors}");
        assert!(!folder.path().join("bad.mapd").exists());
    }
}

#[test]
fn compile_writes_archive_and_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let output =
        run(&["compile", &one_road(), "-o", &path("a.mapd"), "--report", &path("r.json")], "");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let report: serde_json::Value =
        serde_json::from_slice(&std::fs::read(path("r.json")).expect("a report")).expect("JSON");
    assert_eq!(report["verdict"], "accepted");
    let inspected = run(&["inspect", &path("a.mapd"), "--json", "--verify"], "");
    let facts: serde_json::Value = serde_json::from_slice(&inspected.stdout).expect("JSON");
    assert_eq!(facts["map"]["roads"], 1);
    assert_eq!(facts["map"]["lanes"], 9);
    assert_eq!(facts["verified"], true);
    assert_eq!(facts["input_hash"], report["input_hash"]);
    let left: Vec<_> = std::fs::read_dir(folder.path()).expect("the folder").flatten().collect();
    assert_eq!(left.len(), 2, "temporary files are left: {left:?}");
}

#[test]
fn surfaces_have_a_normal() {
    check(
        &["surface"],
        "road_id,s,t\n1,20,-1\n",
        "road_id,s,t,x,y,z,nx,ny,nz,friction,roughness,error\n1,20,-1,20.0,-1.0,10.0,0.0,0.0,1.0,,,\n",
    );
}

#[test]
fn signals_are_a_row_each() {
    use mapd_tests::crossroads::{crossroads, light, signal};
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("crossing.xodr");
    let arm = light("L") + &signal("V", 60.0, 5.0, "-", "274", "value=\"50\" unit=\"km/h\"");
    let signals = [arm, String::new(), String::new(), String::new()];
    std::fs::write(&path, crossroads(signals, "", "")).expect("written");
    let source = path.display().to_string();
    let input = "road_id,s,lane_id,distance\n0,80,1,100\n0,30,-1,100\n0,80,1,x\n";
    let output = run(&["query", &source, "signals"], input);
    let errors = String::from_utf8_lossy(&output.stderr);
    let expected = "lane_id,id,class,distance,road_id,s,t,x,y,z,state_machine,method,value,out_of_service,error\n\
        1,V,speed_limit,20.0,0,60.0,5.0,70.0,5.0,2.0,,orientation,13.88888888888889,,\n\
        1,L,traffic_light,79.0,0,1.0,5.0,11.0,5.0,3.0,red yellow green:red red_yellow yellow green flashing_yellow off,orientation,,,\n\
        1,,,,,,,,,,,,,,\"expected a finite number in column distance, found \"\"x\"\"\"\n";
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected, "{errors}");
    let output = run(&["inspect", &source], "");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.contains("signals       2, 0 references, 0 controllers, 0 for no lane"), "{text}");
    assert!(text.contains("on lanes: 0 validity, 2 orientation, 0 s and t"), "{text}");
    assert!(text.contains("speed_limit"), "{text}");
}

#[test]
fn what_files_say_besides_is_a_row_each() {
    use mapd_tests::annotated::{NESTED, document, road, roundabout};
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("besides.xodr");
    let lane = r#"<visibility sOffset="0" forward="50" back="40" left="30" right="20"/><rule sOffset="5" value="no stopping"/>"#;
    let map = document(5, "", &road("1", 0.0, "junction=\"-1\"", NESTED, lane));
    std::fs::write(&path, map).expect("written");
    let source = path.display().to_string();
    let check = |kind: &str, input: &str, expected: &str| {
        let output = run(&["query", &source, kind], input);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(String::from_utf8_lossy(&output.stdout), expected, "{kind}: {errors}");
    };
    check(
        "annotations",
        "owner,id\nroad,1\nlane,1:0:-1\nroad,7\nhouse,1\n",
        "owner,id,kind,path,name,value,text,file,line,column,error\n\
         road,1,user-data,,vendor,v,\"<a b=\"\"1\"\"><c/></a>\",,4,240,\n\
         road,7,,,,,,,,,\"the map has no road \"\"7\"\"\"\n\
         house,1,,,,,,,,,\"owner must be one of document, road, section, lane, junction, connection, object, signal, controller, junction-group, station, found \"\"house\"\"\"\n",
    );
    check(
        "visibility",
        "road_id,s,lane_id\n1,3,-1\n",
        "road_id,s,lane_id,forward,back,left,right,error\n1,3,-1,50.0,40.0,30.0,20.0,\n",
    );
    check(
        "lane-rule",
        "road_id,s,lane_id\n1,3,-1\n1,7,-1\n",
        "road_id,s,lane_id,rule,error\n1,3,-1,,\n1,7,-1,no stopping,\n",
    );
    let inspected = |more: &[&str]| {
        let output = run(&[&["inspect", source.as_str()], more].concat(), "");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let text = inspected(&[]);
    assert!(text.contains("annotations   1: 1 of road"), "{text}");
    assert!(text.contains("user-data            1: 1 \"vendor\""), "{text}");
    assert!(text.contains("lane records  1 of visibility, 1 rules as text"), "{text}");
    let json: serde_json::Value = serde_json::from_str(&inspected(&["--json"])).expect("JSON");
    assert_eq!(json["besides"]["by_kind"]["user-data"]["vendor"], 1);
    let archive = folder.path().join("bare.mapd").display().to_string();
    let bare = ["compile", &source, "-o", &archive, "--without", "user-data,visibility"];
    assert_eq!(run(&bare, "").status.code(), Some(0));
    let output = run(&["inspect", &archive], "");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(!text.contains("vendor"), "{text}");
    assert!(text.contains("lane records  0 of visibility, 1 rules as text"), "{text}");
    let group = r#"<junctionGroup id="g" name="" type="roundabout"><junctionReference junction="A"/><junctionReference junction="B"/></junctionGroup>"#;
    std::fs::write(&path, roundabout(group)).expect("written");
    check(
        "junction-groups",
        "junction_id\nA\n",
        "junction_id,group,name,type,junctions,ring,error\n\
         A,g,,roundabout,A;B,1:0:-1;2:0:-1;3:0:-1;4:0:-1,\n",
    );
}

#[test]
fn a_table_of_ones_own_changes_what_signals_mean() {
    use mapd_tests::crossroads::{crossroads, signal};
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let odd = signal("X", 60.0, 5.0, "-", "strange", "");
    let signals = [odd, String::new(), String::new(), String::new()];
    std::fs::write(at("map.xodr"), crossroads(signals, "", "")).expect("written");
    let table = "name = \"own\"\ncountries = [\"DE\"]\nsignals = [{ type = \"strange\", class = \"CLASS\" }]\n";
    for (file, class) in [("own.toml", "stop"), ("wrong.toml", "sotp")] {
        std::fs::write(at(file), table.replace("CLASS", class)).expect("written");
    }
    let compile = |more: &[&str]| {
        let (map, out) = (at("map.xodr"), at("map.mapd"));
        let mut args = vec!["compile", map.as_str(), "-o", out.as_str()];
        args.extend(more);
        let code = run(&args, "").status.code();
        let text = run(&["inspect", &out], "").stdout;
        (code, String::from_utf8_lossy(&text).into_owned())
    };
    let (code, text) = compile(&[]);
    assert_eq!(code, Some(0));
    assert!(text.contains("no class for \"DE strange -1 \": 1"), "{text}");
    let (code, text) = compile(&["--ontology", &at("own.toml")]);
    assert_eq!(code, Some(0));
    assert!(text.contains("  stop   ") && !text.contains("no class for"), "{text}");
    // Whatever compiles a map takes tables; what is compiled already does not.
    let with_own = |command: &[&str], input: &str| {
        let args: Vec<&str> = command.iter().copied().chain(["--ontology"]).collect();
        let own = at("own.toml");
        let output = run(&[&args[..], &[own.as_str()]].concat(), input);
        let text = [output.stdout, output.stderr].map(|t| String::from_utf8_lossy(&t).into_owned());
        (output.status.code(), text.concat())
    };
    let (map, archive) = (at("map.xodr"), at("map.mapd"));
    let question = "x,y,radius\n70,5,1\n";
    let (code, text) = with_own(&["query", &map, "landmarks"], question);
    assert!(code == Some(0) && text.contains("1,X,stop,0.0,0,60.0,5.0,"), "{text}");
    let (code, text) = with_own(&["inspect", &map], "");
    assert!(code == Some(0) && text.contains("  stop   "), "{text}");
    assert_eq!(with_own(&["export", &map, "--format", "svg"], "").0, Some(0));
    let (code, text) = with_own(&["query", &archive, "landmarks"], question);
    assert!(code == Some(2) && text.contains("this source is compiled already"), "{text}");
    let refused = run(&["compile", &at("map.xodr"), "--ontology", &at("wrong.toml")], "");
    let told = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{told}");
    assert!(told.contains("wrong.toml") && told.contains("class `sotp`"), "{told}");
}

/// An archive was read as a document: "expected text in UTF-8", then "the map has no roads".
#[test]
fn an_archive_is_known_by_its_first_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (archive, renamed) = (path("road.mapd"), path("road.xodr"));
    let made = run(&["compile", &one_road(), "-o", &archive], "");
    assert_eq!(made.status.code(), Some(0), "{}", String::from_utf8_lossy(&made.stderr));
    std::fs::copy(&archive, &renamed).expect("copied");
    for args in [
        &["check", &archive][..],
        &["check", &renamed],
        &["compile", &archive, "-o", &path("other.mapd")],
        &["compile", &renamed, "-o", &path("other.mapd")],
    ] {
        let output = run(args, "");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains("is an archive, compiled already"), "{args:?}: {said}");
        assert!(!said.contains("UTF-8"), "{args:?}: {said}");
        assert_eq!(output.status.code(), Some(1), "{args:?}: {said}");
    }
}

/// Beyond the limit the rest was read on for its hash, without a bound.
#[test]
fn a_document_beyond_the_limit_is_not_read_to_an_end_that_it_has_not() {
    let ends = |source: &str, stdin: Stdio| {
        let mut child = Command::new(MAPD)
            .args(["check", source, "--max-bytes", "1000", "--format", "json"])
            .stdin(stdin)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("starts");
        let start = std::time::Instant::now();
        loop {
            if let Some(status) = child.try_wait().expect("waits") {
                return status.code();
            }
            if start.elapsed().as_secs() > 60 {
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
    };
    let mut endless = Command::new("yes")
        .arg("<userData code='a' value='b'/>")
        .stdout(Stdio::piped())
        .spawn()
        .expect("starts");
    let pipe = endless.stdout.take().expect("a pipe");
    assert_eq!(ends("/dev/stdin", pipe.into()), Some(4));
    // A process whose pipe has no reader ends.
    let _ = endless.wait();
    assert_eq!(ends("/dev/zero", Stdio::null()), Some(4));
}

/// A pipe was opened twice: who wrote quickly and left had written to the first reader, and the second waited for ever.
#[test]
fn a_pipe_is_opened_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let pipe = folder.path().join("map.xodr");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("runs").success());
    let archive = folder.path().join("map.mapd").display().to_string();
    let whole = std::fs::read(mapd_tests::carried("town.xodr")).expect("the map can be read");
    let text = String::from_utf8(whole.clone()).expect("text");
    let broken = text.replacen("length=\"76\" id=\"2\"", "length=\"-1\" id=\"2\"", 1);
    let run = |args: &[&str], text: &[u8]| {
        let mut command = Command::new(MAPD);
        let command = command.args(args).arg(&pipe).stdout(Stdio::null());
        let mut child = command.stderr(Stdio::piped()).spawn().expect("starts");
        // Opens when somebody reads, writes all that the pipe takes, and leaves.
        let (to, text) = (pipe.clone(), text.to_vec());
        let writer = std::thread::spawn(move || std::fs::write(to, text));
        let patience = std::time::Instant::now();
        while child.try_wait().expect("waits").is_none() {
            if patience.elapsed() > mapd_tests::test_domain::PATIENCE {
                child.kill().expect("killed");
            }
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        // Who ended without having opened the pipe has left the writer waiting: a reader that comes and goes lets it end.
        while !writer.is_finished() {
            // A pipe that is opened for both waits for nobody.
            drop(std::fs::File::options().read(true).write(true).open(&pipe).expect("opens"));
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        // What could not be written, the exit code tells.
        let _ = writer.join().expect("a thread");
        let mut said = String::new();
        let mut stderr = child.stderr.take().expect("a pipe");
        stderr.read_to_string(&mut said).expect("text");
        (child.wait().expect("ended").code(), said)
    };
    // One that ends before it opens the pipe does not keep this test waiting.
    assert_eq!(run(&["check", "--no-such-option"], &whole).0, Some(2));
    for _ in 0..5 {
        assert_eq!(run(&["compile", "--quiet", "-o", &archive], &whole).0, Some(0));
        assert_eq!(run(&["check"], &whole).0, Some(0));
    }
    let (exit, said) = run(&["check"], broken.as_bytes());
    assert!(exit == Some(1) && said.contains("a pipe cannot be read again"), "{exit:?}: {said}");
}

/// Exit code 0 came with an archive that `inspect --verify` refused.
#[test]
fn what_compile_writes_is_proved() {
    let folder = tempfile::tempdir().expect("a folder");
    let [map, archive] = ["map.xodr", "map.mapd"].map(|name| folder.path().join(name));
    let plain = std::fs::read_to_string(one_road()).expect("the map can be read");
    let [map_path, archive_path] = [&map, &archive].map(|path| path.display().to_string());
    for (from, to, exit) in [
        ("", "", 0),
        (r#"<lane id="2""#, r#"<lane id="2147483647""#, 4),
        (r#"<laneSection s="0"#, r#"<laneSection s="-1e308"#, 4),
    ] {
        assert!(plain.contains(from), "{from}");
        std::fs::write(&map, plain.replacen(from, to, 1)).expect("written");
        let output = run(&["compile", &map_path, "-o", &archive_path], "");
        assert_eq!(output.status.code(), Some(exit), "{to}: {output:?}");
        assert_eq!(archive.exists(), exit == 0, "{to}");
        if exit == 0 {
            let output = run(&["inspect", &archive_path, "--verify"], "");
            assert_eq!(output.status.code(), Some(0), "{output:?}");
            std::fs::remove_file(&archive).expect("removed");
        }
    }
}
