//! Objects near a point and in a rectangle: against asking every place, on real maps and on many copies; and over the
//! command line.

use mapd::commands::query::{Kind, RouteArgs};
use mapd_client::glam::DVec2;
use mapd_client::{Map, NearestOptions, Region};
use mapd_query::objects::PlacementId;
use mapd_tests::maps::{self, Random};
use mapd_tests::object_maps::{PLAIN, document, open};

/// Asks for objects about many points in both ways.
fn check(map: Map<'_>, questions: usize) -> usize {
    let mut random = Random(7);
    let (mut near, mut inside, mut seen) = (Vec::new(), Vec::new(), 0);
    for i in 0..questions {
        let point = random.point(map);
        let radius = [0.0, 3.0, 20.0, 150.0][i % 4];
        map.objects_near(point, radius, &mut near).expect("an answer");
        let places = || map.objects().flat_map(|object| object.placements());
        let mut expected: Vec<(f64, PlacementId)> = places()
            .map(|place| (place.distance(point), place.placement_id()))
            .filter(|(distance, _)| *distance <= radius)
            .collect();
        expected.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let found: Vec<_> = near.iter().map(|found| (found.distance, found.place)).collect();
        assert_eq!(found, expected, "{point} {radius}");
        let region = Region { low: point, high: point + DVec2::new(radius, 0.5 * radius) };
        map.objects_in(region, &mut inside).expect("an answer");
        let mut expected: Vec<PlacementId> = places()
            .filter(|place| place.meets(region))
            .map(|place| place.placement_id())
            .collect();
        expected.sort();
        assert_eq!(inside, expected, "{region:?}");
        seen += near.len() + inside.len();
        for id in &inside {
            let place = map.placement(*id).expect("known");
            assert_eq!(place.placement_id(), *id);
        }
    }
    seen
}

#[test]
fn the_index_finds_what_asking_every_place_finds() {
    let names = ["Scenic/Town10HD", "gdal/5g_living_lab_A39_Wolfsburg-West", "esmini/parking_demo"];
    for path in maps::carried_and(&names) {
        let snapshot = maps::open(&path);
        let seen = check(snapshot.map(), 200);
        assert!(seen > 100 || snapshot.map().objects().next().is_none(), "{}", path.display());
    }
}

#[test]
fn many_copies_are_found_one_by_one() {
    // 9,001 posts, so that the index has four levels.
    let posts = r#"<object id="1" type="pole" s="0" t="6" zOffset="0" radius="0.1" orientation="none"><repeat s="0" length="90" distance="0.01" tStart="6" tEnd="9" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#;
    let snapshot = open(&document(&PLAIN, posts));
    assert_eq!(snapshot.map().tables().object_copies.len(), 9001);
    assert_eq!(snapshot.map().tables().object_index_levels.len(), 5);
    assert!(check(snapshot.map(), 60) > 1000);
}

#[test]
fn the_command_line_lists_a_row_for_each() {
    let objects = r#"<object id="a" type="tree" s="30" t="8" zOffset="0.5" orientation="none"/>
<object id="b" type="parkingSpace" s="0" t="-4.75" zOffset="0" length="5" width="2.4" orientation="none"><repeat s="20" length="12" distance="6" tStart="-4.75" tEnd="-4.75" heightStart="0" heightEnd="0" zOffsetStart="0" zOffsetEnd="0"/></object>"#;
    let snapshot = open(&document(&PLAIN, objects));
    let mut out = Vec::new();
    let input = "x,y,radius\n30,0,9\n0,0,1\n30,0,-1\n";
    let (options, route) = (NearestOptions::default(), RouteArgs::default());
    let asking = mapd::commands::query::Asking {
        document: "the document",
        options: &options,
        outline: None,
        route: &route,
        format: mapd::commands::query::Format::Csv,
    };
    mapd::commands::query::run(snapshot.map(), Kind::Objects, asking, input.as_bytes(), &mut out)
        .expect("runs");
    let text = String::from_utf8(out).expect("text");
    // The nearest corners of the spaces: (28.5, −3.55) of the one about 26, (29.5, −3.55) of the one about 32; of the one
    // about 20, (22.5, −3.55).
    let d = |x: f64, y: f64| format!("{:?}", (x * x + y * y).sqrt());
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "radius,id,class,distance,road_id,s,t,x,y,z,value,error");
    let field = |line: &str, i: usize| line.split(',').nth(i).expect("a field").to_owned();
    let number = |line: &str, i: usize| field(line, i).parse::<f64>().expect("a number");
    let ids: Vec<_> =
        lines[1..5].iter().map(|l| (field(l, 1), field(l, 2), number(l, 5))).collect();
    let space = |s: f64| ("b".to_owned(), "parking_space".to_owned(), s);
    assert_eq!(
        ids,
        [space(32.0), space(26.0), ("a".to_owned(), "tree".to_owned(), 30.0), space(20.0)]
    );
    assert!((number(lines[1], 3) - 3.55).abs() < 1e-6, "{}", lines[1]);
    assert!((number(lines[4], 3) - d(7.5, 3.55).parse::<f64>().expect("a number")).abs() < 1e-6);
    assert_eq!(lines[3], "9,a,tree,8.0,1,30.0,8.0,30.0,8.0,0.5,,");
    // Nothing is near the second point; the third asks for what there is not.
    assert_eq!(lines.len(), 6);
    assert!(lines[5].contains("radius must not be negative, found -1.0"), "{}", lines[5]);
}
