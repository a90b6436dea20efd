//! Lists and batches of places, marks and landmarks.

use crate::settles;
use mapd_client::batch::{Places, Poses, TrackPositions, Tracks};
use mapd_client::geodesy::GeodeticPoint;
use mapd_client::localisation::{GroundScratch, MarkFilter, MarkSource, Sensor, VehiclePose};
use mapd_client::vocabulary::ClassSet;
use mapd_client::{LaneTypes, NearestOptions, Point, Region, glam::DVec2};
use mapd_tests::object_maps;

/// Lists of places, marks and landmarks: what goes into a caller's buffer grows once.
#[test]
fn lists_of_places_do_not_allocate_after_the_first_call() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("town.xodr"));
    let painted_map = mapd_tests::maps::open(&mapd_tests::carried("marks.xodr"));
    let furnished = object_maps::open(&mapd_tests::crossroads::furnished());
    let crossing = "<object id=\"c\" type=\"crosswalk\" s=\"30\" t=\"0\" zOffset=\"0\" length=\"2\" width=\"4\" orientation=\"none\"><markings><marking side=\"left\" width=\"0.3\" color=\"white\" lineLength=\"0.5\" spaceLength=\"0.5\" startOffset=\"0\" stopOffset=\"0\"/></markings></object>";
    let crossing = object_maps::open(&object_maps::document(&object_maps::PLAIN, crossing));
    let (map, painted_map) = (snapshot.map(), painted_map.map());
    let mut random = mapd_tests::maps::Random(5);
    let near_paint: Vec<DVec2> = (0..100).map(|_| random.point(painted_map)).collect();
    let projector = mapd_client::geodesy::Projector::new(
        "+proj=tmerc +lat_0=48 +lon_0=11 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7",
        mapd_client::geodesy::Offset::default(),
    )
    .expect("a projector");
    let flat: Vec<DVec2> =
        (0..100).map(|i| DVec2::new(f64::from(i), f64::from(i * 3 % 100))).collect();
    let points: Vec<Point> = flat.iter().map(|point| Point::from(*point)).collect();
    let raised: Vec<_> = flat.iter().map(|point| point.extend(1.0)).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = flat.iter().map(|point| (point.x, point.y)).unzip();
    let road = map.road_by_id("1").expect("a road");
    let (mut ground, mut grounds) = (GroundScratch::default(), Vec::new());
    let (mut marks, mut painted, mut landmarks) = (Vec::new(), Vec::new(), Vec::new());
    let mut on_objects = Vec::new();
    let (mut work, mut borders, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let (mut poses, mut feet) = (Poses::default(), TrackPositions::default());
    let (mut earth, mut places, mut back) = (Vec::new(), Vec::new(), Vec::new());
    let wheels = [[2.7, 0.8], [2.7, -0.8], [0.0, 0.8], [0.0, -0.8]].map(DVec2::from);
    let sensor = Sensor { position: DVec2::ZERO, heading: 0.5, range: 200.0, field_of_view: 6.2 };
    let round = || {
        map.ground_below(&points, &[], &mut ground, &mut grounds).expect("heights");
        let mut stands = 0;
        for position in &points {
            let pose = VehiclePose { position: *position, heading: 0.3 };
            let stance = map.stance(&pose, &wheels, &[], &mut ground).expect("an answer");
            stands += usize::from(stance.is_some());
        }
        let filter = MarkFilter::default();
        painted_map.nearest_marks(&near_paint, &filter, &mut marks).expect("marks");
        let region = Region::around(near_paint[0], 100.0);
        painted_map.mark_points(region, 0.5, &filter, &mut painted).expect("points");
        let whole = Region { low: DVec2::splat(-1e4), high: DVec2::splat(1e4) };
        crossing.map().mark_points(whole, 0.5, &filter, &mut on_objects).expect("points");
        assert!(on_objects.iter().any(|point| !matches!(point.source, MarkSource::Lane(_))));
        painted_map
            .road_mark_segments(region, LaneTypes::ALL, &mut work, &mut borders, &mut lines)
            .expect("lines");
        let seen = furnished.map().landmarks_in_view(&sensor, ClassSet::ALL, &mut landmarks);
        seen.expect("landmarks");
        let places_on = Places { x: &x, y: &y, ..Places::default() };
        road.to_track_batch(places_on, &mut feet).expect("feet");
        let tracks = Tracks { s: &feet.s, t: &feet.t, h: None };
        road.to_inertial_batch(tracks, &mut poses).expect("places");
        projector.to_geodetic_batch(&raised, &mut earth);
        places.clear();
        places.extend(earth.iter().flatten());
        projector.from_geodetic_batch(&places, &mut back);
        let mut lanes = 0;
        for place in &places {
            let at = GeodeticPoint {
                latitude: place.latitude,
                longitude: place.longitude,
                altitude: Some(place.altitude),
            };
            let found = map.nearest_lane_geodetic(&projector, at, &NearestOptions::default());
            lanes += usize::from(found.expect("an answer").is_some());
        }
        [
            lanes,
            grounds.iter().flatten().count(),
            stands,
            marks.iter().flatten().count(),
            painted.len(),
            lines.len(),
            landmarks.len(),
            feet.s.len(),
            poses.x.len(),
            back.iter().flatten().count(),
        ]
    };
    settles("lists of places", 0, round);
}
