//! Batches answer as single calls do, bit for bit and in the caller's order, and name what is wrong by its number.

use mapd_client::batch::{
    BatchScratch, NearestLanes, Places, PoseError, PoseMatches, Poses, TrackPositions, Tracks,
};
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{
    GroundScratch, MarkFilter, MatchError, MatchOptions, VehicleOutline, VehiclePose,
};
use mapd_client::{Clamped, LaneTypes, Map, NearestOptions, Point, Pose, QueryError, Road, Track};
use mapd_tests::carried;
use mapd_tests::maps::{self, Random};

/// Places of all kinds: strewn over the map, in a cloud of a few metres, along a lane, on its borders, and again and again the same.
fn places(map: Map<'_>, random: &mut Random) -> Vec<DVec2> {
    let mut all: Vec<DVec2> = (0..300).map(|_| random.point(map)).collect();
    let lanes: Vec<_> = map.lanes().filter(|lane| !lane.is_temporary()).collect();
    for _ in 0..6 {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let section = lane.section();
        let s = section.s_start() + random.unit() * (section.s_end() - section.s_start());
        let edges = lane.edges_at(s);
        let at = |s: f64, t: f64| {
            let pose = lane.road().to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
            pose.position.truncate()
        };
        let middle = at(s, edges.center());
        all.extend(
            (0..150)
                .map(|_| middle + DVec2::new(random.between(-5.0, 5.0), random.between(-5.0, 5.0))),
        );
        all.extend((0..60).map(|i| at(s + 0.1 * f64::from(i), edges.center())));
        all.extend((0..30).map(|i| at(s + 0.1 * f64::from(i), edges.outer)));
        all.extend((0..30).map(|i| at(section.s_end(), edges.inner + 0.1 * f64::from(i))));
        all.extend([middle; 10]);
    }
    all
}

/// Roads of a map whose places are compared.
const ROADS: usize = 40;

/// All places, with these options, against single calls.
fn check(map: Map<'_>, places: Places<'_>, options: &NearestOptions) {
    let (mut scratch, mut out) = (BatchScratch::default(), NearestLanes::default());
    map.nearest_lanes(places, options, &mut scratch, &mut out).expect("answers");
    assert_eq!(out.len(), places.x.len());
    for i in 0..places.x.len() {
        let point = Point { xy: DVec2::new(places.x[i], places.y[i]), z: places.z.map(|z| z[i]) };
        let heading = places.heading.map(|heading| heading[i]).or(options.heading);
        let single = map.nearest_lane(point, &NearestOptions { heading, ..*options });
        assert_eq!(out.get(i), single.expect("an answer"), "place {i}, {point:?}");
    }
}

#[test]
fn nearest_lanes_are_those_of_single_calls() {
    for path in maps::carried_and(&["carla/Town05", "esmini/velodrome"]) {
        let snapshot = maps::open(&path);
        let (map, random) = (snapshot.map(), &mut Random(31));
        let points = places(map, random);
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.x, p.y)).unzip();
        let z: Vec<f64> = x.iter().map(|_| random.between(-3.0, 12.0)).collect();
        let heading: Vec<f64> = x.iter().map(|_| random.between(-4.0, 4.0)).collect();
        let plain = Places { x: &x, y: &y, z: None, heading: None };
        let full = Places { z: Some(&z), heading: Some(&heading), ..plain };
        let default = NearestOptions::default();
        check(map, plain, &default);
        check(map, full, &default);
        let strict = NearestOptions {
            radius: 2.0,
            types: LaneTypes::routable(),
            z_tolerance: Some(4.0),
            heading_tolerance: Some(1.0),
            ..default
        };
        check(map, full, &strict);
        check(map, plain, &NearestOptions { heading: Some(0.5), radius: 0.0, ..default });
    }
}

#[test]
fn poses_ground_and_marks_answer_as_single_calls() {
    let snapshot = maps::open(&carried("town.xodr"));
    let (map, random) = (snapshot.map(), &mut Random(32));
    let points = places(map, random);
    let poses: Vec<VehiclePose> = points
        .iter()
        .take(600)
        .map(|point| VehiclePose { position: (*point).into(), heading: random.between(-3.0, 3.0) })
        .collect();
    let covariance = |size: f64| DMat3::from_diagonal(DVec3::new(size, size, 0.01));
    let each: Vec<DMat3> = poses.iter().map(|_| covariance(random.between(0.01, 2.0))).collect();
    let one = [covariance(0.25)];
    let (mut scratch, mut out, mut single) =
        (BatchScratch::default(), PoseMatches::default(), Vec::new());
    let outline = VehicleOutline { front: 3.6, back: 1.0, left: 0.9, right: 0.9 };
    let vehicle = MatchOptions { outline: Some(outline), ..MatchOptions::default() };
    let ways = [(&each[..], MatchOptions::default(), 600), (&one, MatchOptions::default(), 600)];
    for (covariances, options, count) in ways.into_iter().chain([(&each[..60], vehicle, 60)]) {
        let poses = &poses[..count];
        map.match_poses(poses, covariances, &options, &mut scratch, &mut out).expect("answers");
        for (i, pose) in poses.iter().enumerate() {
            let covariance = &covariances[i.min(covariances.len() - 1)];
            let none = map.match_pose(pose, covariance, &options, &mut single);
            assert_eq!((out.none()[i], out.of(i)), (none.expect("an answer"), &single[..]));
        }
    }
    let heights: Vec<Point> = points.iter().map(|point| (*point).into()).collect();
    let (mut room, mut ground) = (GroundScratch::default(), Vec::new());
    map.ground_below(&heights, &[], &mut room, &mut ground).expect("answers");
    let (filter, mut marks) = (MarkFilter::default(), Vec::new());
    map.nearest_marks(&points, &filter, &mut marks).expect("answers");
    for (i, point) in points.iter().enumerate() {
        assert_eq!(ground[i], map.ground_at(*point, &[], &mut room).expect("an answer"));
        assert_eq!(marks[i], map.nearest_mark(*point, &filter).expect("an answer"));
    }
}

/// Places of a road against single calls: feet of points, and the poses of places that are in no order and beyond the ends, too.
fn check_road(road: &Road<'_>, points: &[DVec2]) {
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.x, p.y)).unzip();
    let mut feet = TrackPositions::default();
    let places = Places { x: &x, y: &y, z: None, heading: None };
    road.to_track_batch(places, &mut feet).expect("feet");
    for (i, point) in points.iter().enumerate() {
        let at = road.to_track(*point).expect("a foot");
        assert_eq!((feet.s[i], feet.t[i], feet.exact[i]), (at.s, at.t, at.exact));
    }
    let beyond =
        |(i, s): (usize, &f64)| if i % 5 == 0 { s + 3.0 * (i % 7) as f64 - 9.0 } else { *s };
    let s: Vec<f64> = feet.s.iter().enumerate().map(beyond).collect();
    let h: Vec<f64> = (0..s.len()).map(|i| 0.1 * (i % 4) as f64).collect();
    let mut out = Poses::default();
    for h in [None, Some(h.as_slice())] {
        check_poses(road, Tracks { s: &s, t: &feet.t, h }, &mut out);
    }
}

/// Poses of places of a road against single calls, bit by bit.
fn check_poses(road: &Road<'_>, tracks: Tracks<'_>, out: &mut Poses) {
    let Tracks { s, t, h } = tracks;
    road.to_inertial_batch(tracks, out).expect("places");
    assert_eq!((out.x.len(), out.clamped.len()), (s.len(), s.len()));
    for (i, (s, t)) in s.iter().zip(t).enumerate() {
        let track = Track { s: *s, t: *t, h: h.map_or(0.0, |h| h[i]) };
        let pose = road.to_inertial(track).expect("a place");
        let Pose { position: p, heading, curvature, slope, superelevation, clamped } = pose;
        let expected = [p.x, p.y, p.z, heading, curvature, slope, superelevation];
        let Poses { x, y, z, heading, curvature, slope, superelevation, .. } = &*out;
        let found = [x, y, z, heading, curvature, slope, superelevation];
        assert_eq!(found.map(|column| column[i].to_bits()), expected.map(f64::to_bits));
        assert_eq!(out.clamped[i], clamped);
    }
}

/// A road whose heights begin behind its start, change twice at one s, and whose second geometry is an arc.
const UNEVEN: &str = r#"<?xml version="1.0"?><OpenDRIVE><header revMajor="1" revMinor="8"/>
<road id="1" length="100" junction="-1"><planView>
<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>
<geometry s="50" x="50" y="0" hdg="0" length="50"><arc curvature="0.01"/></geometry></planView>
<elevationProfile><elevation s="10" a="1" b="0.1" c="0" d="0"/><elevation s="40" a="4" b="0" c="0" d="0"/>
<elevation s="40" a="4" b="-0.02" c="0.001" d="0"/></elevationProfile>
<lateralProfile><superelevation s="20" a="0" b="0.002" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#;

#[test]
fn places_of_an_uneven_road_are_those_of_single_calls() {
    let snapshot = maps::open_text(UNEVEN);
    let road = snapshot.map().roads().next().expect("a road");
    // Every quarter of a metre, from before the start to behind the end, and back.
    let ahead = (-8..=408).map(|i| 0.25 * f64::from(i));
    let s: Vec<f64> =
        ahead.clone().chain(ahead.rev()).chain([-0.0, 40.0_f64.next_down()]).collect();
    let t: Vec<f64> = s.iter().map(|s| 0.1 * s - 3.0).collect();
    let mut out = Poses::default();
    check_poses(&road, Tracks { s: &s, t: &t, h: Some(&t) }, &mut out);
    let kinds = [Clamped::No, Clamped::Before, Clamped::After];
    assert!(kinds.iter().all(|kind| out.clamped.contains(kind)));
    assert!(out.slope.contains(&0.0) && out.superelevation.contains(&0.16));
}

#[test]
fn places_of_roads_are_those_of_single_calls() {
    for path in maps::carried_and(&["esmini/velodrome", "Scenic/Issue295a"]) {
        let snapshot = maps::open(&path);
        let map = snapshot.map();
        let points = places(map, &mut Random(33));
        // Of many roads some, evenly spread.
        let step = map.roads().count().div_ceil(ROADS).max(1);
        for road in map.roads().step_by(step) {
            check_road(&road, &points);
        }
    }
}

#[test]
fn what_is_wrong_is_named_by_its_number() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let map = snapshot.map();
    let (mut scratch, mut out) = (BatchScratch::default(), NearestLanes::default());
    let good = [1.0, 2.0, 3.0];
    let wrong = [1.0, 2.0, f64::NAN];
    let plain = Places { x: &good, y: &good, z: None, heading: None };
    let mut ask = |places: Places<'_>, options: &NearestOptions| {
        map.nearest_lanes(places, options, &mut scratch, &mut out).map(|()| out.len())
    };
    let default = NearestOptions::default();
    assert_eq!(ask(plain, &default), Ok(3));
    assert_eq!(ask(Places::default(), &default), Ok(0));
    assert_eq!(ask(Places { y: &wrong, ..plain }, &default), Err(QueryError::NotFiniteAt(2)));
    assert_eq!(ask(Places { y: &good[1..], ..plain }, &default), Err(QueryError::Length("y")));
    let short = Places { heading: Some(&good[1..]), ..plain };
    assert_eq!(ask(short, &default), Err(QueryError::Length("heading")));
    let endless = NearestOptions { radius: f64::INFINITY, ..default };
    assert_eq!(ask(plain, &endless), Err(QueryError::NotFinite));

    let pose = |x: f64| VehiclePose { position: DVec2::new(x, 0.0).into(), heading: 0.0 };
    // The second one is wrong; along the curve others come first.
    let poses = [pose(50.0), pose(f64::NAN), pose(10.0), pose(f64::INFINITY)];
    let mut found = PoseMatches::default();
    let mut ask = |poses: &[VehiclePose], covariances: &[DMat3]| {
        let options = MatchOptions::default();
        map.match_poses(poses, covariances, &options, &mut scratch, &mut found)
    };
    let one = [DMat3::IDENTITY];
    assert_eq!(ask(&poses[..1], &one), Ok(()));
    assert_eq!(ask(&[], &[]), Ok(()));
    let source = MatchError::Pose("x");
    assert_eq!(ask(&poses, &one), Err(PoseError { pose: 1, source }));
    let source = MatchError::Covariances;
    assert_eq!(ask(&poses[..1], &[]), Err(PoseError { pose: 0, source }));
    let two = [DMat3::IDENTITY; 2];
    assert_eq!(ask(&[pose(0.0); 3], &two), Err(PoseError { pose: 2, source }));

    let road = map.roads().next().expect("a road");
    let tracks = Tracks { s: &good, t: &wrong, h: None };
    let mut out = Poses::default();
    let error = road.to_inertial_batch(tracks, &mut out);
    assert_eq!(error, Err(QueryError::NotFiniteAt(2)));
    // Too far for a coordinate. Nothing is left of those before.
    road.to_inertial_batch(Tracks { s: &good, t: &good, h: None }, &mut out).expect("places");
    assert_eq!(out.x.len(), good.len());
    let far = [1.0, 2.0, 1e300];
    let error = road.to_inertial_batch(Tracks { s: &good, t: &far, h: None }, &mut out);
    assert_eq!(error, Err(QueryError::NotFiniteAt(2)));
    assert_eq!(out, Poses::default());
}
