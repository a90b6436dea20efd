//! Landmarks for localisation, and signals near a point and in a rectangle: against asking everything, on real maps and on many
//! signals; and over the command line.

use mapd::commands::query::{Kind, RouteArgs};
use mapd_client::glam::DVec2;
use mapd_client::{Map, NearestOptions, Region};
use mapd_query::SignalId;
use mapd_query::localisation::{Landmark, LandmarkSource, Sensor};
use mapd_query::vocabulary::{Class, ClassSet};
use mapd_tests::maps::{self, Random};
use mapd_tests::object_maps::{PLAIN, document, open};
use std::f64::consts::{PI, TAU};

/// Signals and places of objects of these classes, by asking all of them for their distance.
fn expected(map: Map<'_>, point: DVec2, radius: f64, classes: ClassSet) -> Vec<LandmarkSource> {
    let signals = map.signals().filter(|signal| classes.contains(signal.class())).map(|signal| {
        let distance = signal.position().truncate().distance(point);
        (distance, LandmarkSource::Signal(signal.signal_id()))
    });
    let fixed = map.objects().filter(|o| classes.contains(o.class()) && !o.is_dynamic());
    let places = fixed
        .flat_map(|object| object.placements())
        .map(|place| (place.distance(point), LandmarkSource::Object(place.placement_id())));
    let near = |at: &(f64, LandmarkSource)| at.0 <= radius;
    let mut all: Vec<(f64, LandmarkSource)> = signals.chain(places).filter(near).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    all.into_iter().map(|(_, source)| source).collect()
}

/// Asks about many points in both ways; how much was found.
fn check(map: Map<'_>, questions: usize) -> usize {
    let mut random = Random(11);
    let (mut near, mut landmarks, mut inside, mut seen) = (vec![], vec![], vec![], 0);
    for i in 0..questions {
        let point = random.point(map);
        let radius = [0.0, 5.0, 30.0, 200.0][i % 4];
        map.signals_near(point, radius, &mut near).expect("an answer");
        let mut signals: Vec<(f64, SignalId)> = map
            .signals()
            .map(|s| (s.position().truncate().distance(point), s.signal_id()))
            .filter(|(distance, _)| *distance <= radius)
            .collect();
        signals.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let found: Vec<_> = near.iter().map(|found| (found.distance, found.signal)).collect();
        assert_eq!(found, signals, "{point} {radius}");
        let region = Region { low: point, high: point + DVec2::new(radius, 0.5 * radius) };
        map.signals_in(region, &mut inside).expect("an answer");
        let held = |p: DVec2| p.cmpge(region.low).all() && p.cmple(region.high).all();
        let of = map.signals().filter(|signal| held(signal.position().truncate()));
        assert_eq!(inside, of.map(|signal| signal.signal_id()).collect::<Vec<_>>());
        seen += near.len() + inside.len();
        for classes in [ClassSet::LANDMARKS, ClassSet::ALL, ClassSet::NONE.with(Class::Pole)] {
            map.landmarks_near(point, radius, classes, &mut landmarks).expect("an answer");
            let found: Vec<_> = landmarks.iter().map(|found| found.source).collect();
            assert_eq!(found, expected(map, point, radius, classes), "{point} {radius}");
            map.landmarks_in(region, classes, &mut landmarks).expect("an answer");
            // The rectangle lies in the circle around its middle; what meets it is near that.
            let (middle, reach) = (point + DVec2::new(0.5, 0.25) * radius, radius);
            let around = expected(map, middle, reach, classes);
            for one in &landmarks {
                assert!(around.contains(&one.source), "{one:?}");
                seen += 1;
            }
            let of_region = |one: &&LandmarkSource| match one {
                LandmarkSource::Signal(id) => {
                    held(map.signal(*id).expect("known").position().truncate())
                }
                LandmarkSource::Object(id) => map.placement(*id).expect("known").meets(region),
            };
            assert_eq!(landmarks.len(), around.iter().filter(of_region).count());
        }
    }
    seen
}

#[test]
fn the_index_finds_what_asking_everything_finds() {
    let names = ["Scenic/Issue189", "gdal/5g_living_lab_A39_Wolfsburg-West", "Scenic/Town07"];
    for path in maps::carried_and(&names) {
        let snapshot = maps::open(&path);
        let seen = check(snapshot.map(), 200);
        let has_any = snapshot.map().signals().len() > 0;
        assert!(seen > 100 || !has_any, "{}: {seen}", path.display());
    }
}

/// The road of `object_maps` with these signals too.
fn with_signals(objects: &str, signals: &str) -> String {
    let signals = format!("</objects><signals>{signals}</signals>");
    document(&PLAIN, objects).replace("</objects>", &signals)
}

fn signal(id: usize, s: f64, t: f64, kind: &str, size: &str) -> String {
    format!(
        r#"<signal id="{id}" s="{s}" t="{t}" zOffset="2" orientation="+" dynamic="no" country="DE" type="{kind}" subtype="-1" {size}/>"#
    )
}

#[test]
fn many_signals_are_found_one_by_one() {
    // 5,000 signs, so that the index has four levels; each hundred at one place.
    let signs: String = (0..5000)
        .map(|i| signal(i, (i / 100) as f64 * 2.0, -7.0, "206", "width=\"0.6\" height=\"0.7\""))
        .collect();
    let snapshot = open(&with_signals("", &signs));
    assert_eq!(snapshot.map().tables().signal_index_levels.len(), 5);
    assert!(check(snapshot.map(), 40) > 1000);
}

/// A pole, a car that moves, a wall that stands askew, a stop sign and a board's post without a meaning.
fn few() -> String {
    let objects = r#"<object id="pole" type="pole" s="30" t="8" zOffset="0.5" radius="0.2" height="4" orientation="none"/>
<object id="gate" type="barrier" dynamic="yes" s="32" t="8" zOffset="0" length="3" width="0.2" orientation="none"/>
<object id="wall" type="building" s="40" t="10" zOffset="0" hdg="0.5" length="6" width="2" height="3" orientation="none"/>
<object id="bush" type="vegetation" s="30" t="7" zOffset="0" radius="1" orientation="none"/>"#;
    let signals = signal(1, 30.0, -6.0, "206", "width=\"0.9\" height=\"0.8\"");
    with_signals(objects, &signals)
}

#[test]
fn each_has_its_pose_size_and_class() {
    let snapshot = open(&few());
    let map = snapshot.map();
    let mut found: Vec<Landmark> = Vec::new();
    let at = DVec2::new(30.0, 0.0);
    map.landmarks_near(at, 100.0, ClassSet::LANDMARKS, &mut found).expect("an answer");
    let classes: Vec<Class> = found.iter().map(|one| one.class).collect();
    assert_eq!(classes, [Class::Stop, Class::Pole, Class::Building]);
    let [sign, pole, wall] = found[..] else { panic!("{found:?}") };
    assert!(matches!(sign.source, LandmarkSource::Signal(_)));
    assert_eq!((sign.distance, sign.size), (6.0, [0.0, 0.9, 0.8]));
    // Its face looks against the traffic that goes along s.
    assert!((sign.heading.abs() - std::f64::consts::PI).abs() < 1e-12);
    assert!(matches!(pole.source, LandmarkSource::Object(_)));
    assert_eq!(pole.position.to_array(), [30.0, 8.0, 0.5]);
    let radius = f64::from(0.2f32);
    assert_eq!(pole.size, [2.0 * radius, 2.0 * radius, 4.0]);
    assert!((pole.distance - (8.0 - radius)).abs() < 1e-12);
    assert_eq!((wall.heading, wall.size), (0.5, [6.0, 2.0, 3.0]));
    let LandmarkSource::Object(place) = wall.source else { panic!("{wall:?}") };
    let mut corners = Vec::new();
    map.placement(place).expect("known").footprint(&mut corners);
    assert_eq!(corners.len(), 4, "the building's corners");
    map.landmarks_near(at, 100.0, ClassSet::ALL, &mut found).expect("an answer");
    assert_eq!(found.len(), 4, "what moves is none");
}

#[test]
fn classes_say_themselves_whether_they_are_landmarks() {
    for class in Class::ALL.iter().copied().chain([Class::Unknown]) {
        assert_eq!(ClassSet::LANDMARKS.contains(class), class.is_landmark(), "{class:?}");
        assert!(ClassSet::ALL.contains(class) && !ClassSet::NONE.contains(class));
        let one = ClassSet::NONE.with(class);
        assert!(Class::ALL.iter().all(|other| one.contains(*other) == (*other == class)));
    }
    for class in [Class::Pole, Class::TrafficLight, Class::SpeedLimit, Class::GuardRail] {
        assert!(class.is_landmark(), "{class:?}");
    }
    for class in [Class::Vehicle, Class::Vegetation, Class::LaneLine, Class::Unknown] {
        assert!(!class.is_landmark(), "{class:?}");
    }
}

#[test]
fn the_command_line_lists_a_row_for_each() {
    let snapshot = open(&few());
    let answer = |input: &str| {
        let mut out = Vec::new();
        let (options, route) = (NearestOptions::default(), RouteArgs::default());
        let asking = mapd::commands::query::Asking {
            document: "the document",
            options: &options,
            outline: None,
            route: &route,
            format: mapd::commands::query::Format::Csv,
        };
        mapd::commands::query::run(
            snapshot.map(),
            Kind::Landmarks,
            asking,
            input.as_bytes(),
            &mut out,
        )
        .expect("runs");
        String::from_utf8(out).expect("text")
    };
    let head = "id,class,distance,road_id,s,t,x,y,z,hdg,length,width,height,kind,error";
    let pi = std::f64::consts::PI;
    assert_eq!(
        answer("x,y,radius\n30,0,7\n"),
        format!(
            "radius,{head}\n7,1,stop,6.0,1,30.0,-6.0,30.0,-6.0,2.0,{pi:?},0.0,0.9,0.8,signal,\n"
        )
    );
    let other = answer("x,y,radius,classes\n30,0,7,vegetation;unknown\n30,0,7,bushes\n");
    let lines: Vec<&str> = other.lines().collect();
    assert_eq!(lines[0], format!("radius,classes,{head}"));
    assert!(lines[1].starts_with("7,vegetation;unknown,bush,vegetation,6.0,1,30.0,7.0,30.0,7.0,0.0,0.0,2.0,2.0,0.0,object,"), "{other}");
    assert!(
        lines[2].contains("expected a class of the vocabulary, found \"\"bushes\"\""),
        "{other}"
    );
    assert_eq!(lines.len(), 3);
}

/// What a sensor sees, by asking for all landmarks near it and turning each into its frame.
#[test]
fn sensors_see_what_lies_before_them_and_signs_from_the_front() {
    let snapshot = maps::open_text(&mapd_tests::crossroads::furnished());
    let (map, mut random) = (snapshot.map(), Random(13));
    let (mut seen, mut near, mut counts) = (Vec::new(), Vec::new(), [0usize; 3]);
    let turn = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    for _ in 0..200 {
        let (position, heading) = (random.point(map), random.between(-PI, PI));
        let sensor = Sensor { position, heading, range: 60.0, field_of_view: 1.2 };
        map.landmarks_in_view(&sensor, ClassSet::ALL, &mut seen).expect("an answer");
        map.landmarks_near(position, 60.0, ClassSet::ALL, &mut near).expect("an answer");
        let mut expected = Vec::new();
        for landmark in &near {
            let way = landmark.position.truncate() - position;
            let direction = way.y.atan2(way.x);
            let facing = turn(landmark.heading - direction - PI);
            let from_behind =
                matches!(landmark.source, LandmarkSource::Signal(_)) && facing.abs() >= 0.5 * PI;
            counts[0] += usize::from(from_behind);
            if !from_behind && turn(direction - heading).abs() <= 0.6 {
                expected.push((*landmark, turn(direction - heading), facing));
            }
        }
        assert_eq!(seen.len(), expected.len());
        for (seen, (landmark, bearing, facing)) in seen.iter().zip(expected) {
            assert_eq!(seen.landmark, landmark);
            assert!(turn(seen.bearing - bearing).abs() < 1e-9);
            assert!(turn(seen.facing - facing).abs() < 1e-9);
            counts[1] += 1;
        }
        let all = Sensor { field_of_view: TAU, ..sensor };
        map.landmarks_in_view(&all, ClassSet::ALL, &mut seen).expect("an answer");
        counts[2] += seen.len();
    }
    assert!(counts[0] > 0 && counts[1] > 0 && counts[2] > counts[1], "{counts:?}");
    let lost = Sensor { position: DVec2::ZERO, heading: f64::NAN, range: 10.0, field_of_view: 1.0 };
    assert!(map.landmarks_in_view(&lost, ClassSet::ALL, &mut seen).is_err());
}
