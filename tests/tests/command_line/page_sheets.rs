//! What the page says of a lane: everything that the map knows of it.

use mapd_tests::object_maps::{ObjectRoad, PLAIN, document, open};
use mapd_web::{Kind, Link, Sheet};
use std::time::UNIX_EPOCH;

/// Children of lane −1 behind its width.
const WRITTEN: &str = r#"<material sOffset="0" surface="asphalt" friction="0.8"/><material sOffset="40" surface="cobble" friction="0.6" roughness="0.01"/>
<visibility sOffset="0" forward="70" back="30"/><speed sOffset="0" max="10"/><speed sOffset="60" max="50" unit="km/h"/>
<access sOffset="0" restriction="truck"/><access sOffset="25" restriction="none"/>
<height sOffset="0" inner="0.1" outer="0.15"/><rule sOffset="0" value="no parking at night"/><userData code="colour" value="b&lt;"/>"#;

const OBJECTS: &str = r#"<object id="cover" type="obstacle" s="30" t="-1" zOffset="0" orientation="none" length="2" width="1" height="0.1" hdg="0"/>
<tunnel id="t" s="10" length="30" name="Mole" type="standard" lighting="0.5" daylight="0"/>
<bridge id="b" s="90" length="5" name="" type="steel"><validity fromLane="1" toLane="2"/></bridge>"#;

#[test]
fn a_lane_says_everything_that_is_known_of_it() {
    let text = document(&ObjectRoad { version: "1.5", ..PLAIN }, OBJECTS);
    let end = r#"b="0" c="0" d="0"/></lane>"#;
    let (before, lane) = text.split_once(r#"<lane id="-1""#).expect("the lane");
    let lane = lane.replacen(end, &format!(r#"b="0" c="0" d="0"/>{WRITTEN}</lane>"#), 1);
    let snapshot = open(&format!(r#"{before}<lane id="-1"{lane}"#));
    let map = snapshot.map();
    let row = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("the lane").lane_id().row();
    let sheet =
        Sheet::of(snapshot.view(UNIX_EPOCH), Link { kind: Kind::Lane, row }).expect("a sheet");
    let facts = sheet.facts.iter().map(|fact| {
        (fact.name, fact.values.iter().map(|words| words.text.as_str()).collect::<Vec<_>>())
    });
    let facts: Vec<(&str, Vec<&str>)> = facts.collect();
    let expected: [(&str, &[&str]); 9] = [
        (
            "speed limit",
            &[
                "36 km/h (10.00 m/s), written, s 0.00 … 60.00 m",
                "50 km/h (13.89 m/s), written, s 60.00 … 100.00 m",
            ],
        ),
        ("objects", &["cover obstacle s 29.00 … 31.00 m"]),
        (
            "surface",
            &[
                "asphalt from s 0.00 m, friction 0.8",
                "cobble from s 40.00 m, friction 0.6, roughness 0.01",
            ],
        ),
        ("above the road", &["inner edge 0.10 … 0.10 m, outer edge 0.15 … 0.15 m"]),
        ("tunnel or bridge", &["tunnel t Mole standard s 10.00 … 40.00 m"]),
        ("sees", &["70 m ahead, 30 m behind from s 0.00 m"]),
        ("rules", &["no parking at night from s 0.00 m"]),
        ("written besides", &["colour b<"]),
        ("right of it", &["1:0:-2"]),
    ];
    for (name, values) in expected {
        let said = facts.iter().find(|(fact, _)| *fact == name).map(|(_, values)| &values[..]);
        assert_eq!(said, Some(values), "{name}");
    }
    let (_, open) = facts.iter().find(|(fact, _)| *fact == "open to").expect("a fact");
    let trucks = open.iter().map(|piece| (piece.contains("truck"), piece.rsplit(", ").next()));
    let pieces = [(false, Some("s 0.00 … 25.00 m")), (true, Some("s 25.00 … 100.00 m"))];
    assert_eq!(trucks.collect::<Vec<_>>(), pieces);
}

/// Where the road's type brings another limit, no record or sign of the lane says so.
#[test]
fn a_limit_changes_with_the_type_of_the_road() {
    let types = r#"<type s="0" type="town"><speed max="50" unit="km/h"/></type><type s="40" type="rural"><speed max="100" unit="km/h"/></type>"#;
    let text = document(&PLAIN, "").replacen("<planView>", &format!("{types}<planView>"), 1);
    let snapshot = open(&text);
    let map = snapshot.map();
    let row = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("the lane").lane_id().row();
    let link = Link { kind: Kind::Lane, row };
    let sheet = Sheet::of(snapshot.view(UNIX_EPOCH), link).expect("a sheet");
    let limits = sheet.facts.iter().find(|fact| fact.name == "speed limit").expect("a fact");
    let said: Vec<&str> = limits.values.iter().map(|words| words.text.as_str()).collect();
    let expected = [
        "50 km/h (13.89 m/s), written, s 0.00 … 40.00 m",
        "100 km/h (27.78 m/s), written, s 40.00 … 100.00 m",
    ];
    assert_eq!(said, expected);
}
