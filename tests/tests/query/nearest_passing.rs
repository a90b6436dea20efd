//! Nearest lanes under options that exclude places: as near as the nearest of all places that they let pass, wherever the index cuts a
//! lane.

use mapd_client::glam::{DVec2, DVec3};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map, NearestOptions, Point, Snapshot, Track};
use mapd_geometry::{clamp, normalize_angle};
use mapd_tests::maps::{Random, carried_and, open, open_text};

/// Maps besides the carried ones.
const MAPS: [&str; 4] =
    ["carla/Town05", "esmini/multi_intersections", "esmini/velodrome", "Scenic/Issue189"];
/// Points of each map; a tenth of them in builds with debug assertions.
const POINTS: usize = if cfg!(debug_assertions) { 100 } else { 1_000 };
/// Distance between two cross-sections `[m]`.
const STEP: f64 = 0.5;
/// Farthest search `[m]`.
const RADIUS: f64 = 30.0;
/// Allowed difference of two distances `[m]`.
const TOLERANCE: f64 = 1e-6;
/// Allowed beyond a tolerance, for what rounds differently (rad, m).
const ROUNDING: f64 = 1e-6;

/// A lane across.
struct Across<'a> {
    lane: Lane<'a>,
    s: f64,
    ends: [DVec3; 2],
    /// Heading of the reference line `[rad]`, and the cosine of the superelevation.
    line: f64,
    roll: f64,
}

impl<'a> Across<'a> {
    fn new(lane: Lane<'a>, s: f64) -> Self {
        let edges = lane.edges_at(s);
        let pose = |t: f64| lane.road().to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
        let ends = [pose(edges.inner), pose(edges.outer)];
        let (line, roll) = (ends[0].heading, ends[0].superelevation.cos());
        Self { lane, s, line, roll, ends: ends.map(|pose| pose.position) }
    }

    /// The lane's heading where a point lies beside its centre `[rad]`.
    fn heading(&self, point: DVec2) -> f64 {
        let middle = 0.5 * (self.ends[0] + self.ends[1]).truncate();
        let left = (point - middle).dot(DVec2::from_angle(self.line).perp()) / self.roll;
        let offset = if self.lane.is_forward() { left } else { -left };
        self.lane.pose_at(self.s, offset).expect("a pose").heading
    }

    /// The place nearest to a point in plan view.
    fn nearest(&self, point: DVec2) -> DVec3 {
        let along = self.ends[1] - self.ends[0];
        let squared = along.truncate().length_squared();
        let share = (point - self.ends[0].truncate()).dot(along.truncate()) / squared;
        self.ends[0] + along * if squared > 0.0 { clamp(share, 0.0, 1.0) } else { 0.0 }
    }

    /// By how much it fails what is asked for; negative where it passes.
    fn excess(&self, point: Point, options: &NearestOptions) -> f64 {
        let mut excess = f64::NEG_INFINITY;
        if let (Some(heading), Some(tolerance)) = (options.heading, options.heading_tolerance) {
            let along = normalize_angle(heading - self.heading(point.xy)).abs();
            let against = std::f64::consts::PI - along;
            let is_both = self.lane.is_bidirectional();
            let difference = if is_both { along.min(against) } else { along };
            excess = excess.max(difference - tolerance);
        }
        if let (Some(z), Some(tolerance)) = (point.z, options.z_tolerance) {
            excess = excess.max((z - self.nearest(point.xy).z).abs() - tolerance);
        }
        excess
    }
}

fn all_across(map: Map<'_>) -> Vec<Across<'_>> {
    let of = |lane: Lane<'_>| {
        let section = lane.section();
        let (start, end) = (section.s_start(), section.s_end().min(lane.road().reference_end()));
        let steps = ((end - start) / STEP).ceil().max(1.0) as usize;
        // Not at the ends, where rounding decides which section holds.
        (0..steps).map(move |i| start + (end - start) * (i as f64 + 0.5) / steps as f64).collect()
    };
    let places = map.lanes().flat_map(|lane| {
        let places: Vec<f64> = of(lane);
        places.into_iter().map(move |s| Across::new(lane, s))
    });
    places.collect()
}

/// What is found is excluded by nothing, and no other place that passes is nearer. Returns how far it is, if anything is.
fn check(
    map: Map<'_>,
    all: &[Across<'_>],
    point: Point,
    options: &NearestOptions,
    context: &str,
) -> Option<f64> {
    let hit = map.nearest_lane(point, options).expect("an answer");
    let passing = all.iter().filter(|across| across.excess(point, options) <= -ROUNDING);
    let expected = passing
        .map(|across| across.nearest(point.xy).truncate().distance(point.xy))
        .fold(f64::INFINITY, f64::min);
    let distance = hit.map_or(options.radius, |hit| hit.position.distance);
    assert!(
        distance <= expected + TOLERANCE,
        "{context}: {point:?} {options:?}: {expected} is nearer than {hit:?}"
    );
    let hit = hit?;
    let lane = map.lane(hit.lane).expect("the map's own lane");
    let own = Across::new(lane, hit.position.s).excess(point, options);
    assert!(own <= ROUNDING, "{context}: {point:?} {options:?}: {hit:?} is over by {own}");
    Some(distance)
}

#[test]
fn the_nearest_place_that_passes_is_found() {
    for path in carried_and(&MAPS) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let all = all_across(map);
        let mut random = Random(31);
        let mut beyond = 0;
        for _ in 0..POINTS {
            let near = &all[(random.unit() * all.len() as f64) as usize];
            let away = DVec2::new(random.between(-6.0, 6.0), random.between(-6.0, 6.0));
            let xy = near.ends[0].truncate() + away;
            let level = NearestOptions { radius: RADIUS, ..NearestOptions::default() };
            let free = check(map, &all, Point { xy, z: None }, &level, "all").expect("a lane");
            let headed = NearestOptions {
                heading: Some(near.line + random.between(-0.5, 0.5)),
                heading_tolerance: Some(random.between(0.02, 0.6)),
                ..level
            };
            let z = Some(near.ends[0].z + random.between(-0.6, 0.6));
            let high = NearestOptions { z_tolerance: Some(random.between(0.02, 0.6)), ..level };
            for (point, options) in [(Point { xy, z: None }, headed), (Point { xy, z }, high)] {
                let name = path.display().to_string();
                let found = check(map, &all, point, &options, &name);
                beyond += usize::from(found.is_none_or(|found| found > free + TOLERANCE));
            }
        }
        assert!(beyond > 0, "{}: the options exclude nothing", path.display());
    }
}

/// An arc of 90° on which one lane turns to the left; where it passes is farther than where it is nearest.
#[test]
fn a_bend_passes_where_its_heading_does() {
    let radius = 50.0;
    let text = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="{length}" junction="-1"><planView>
        <geometry s="0" x="0" y="0" hdg="0" length="{length}"><arc curvature="{curvature}"/></geometry></planView>
        <lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
        <width sOffset="0" a="4" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#,
        length = radius * std::f64::consts::FRAC_PI_2,
        curvature = 1.0 / radius,
    );
    let snapshot = open_text(&text);
    let map = snapshot.map();
    // Beside the lane's start, driving as the lane does after 0.5 rad.
    for (tolerance, angle) in [(0.1, 0.4), (0.3, 0.2), (0.45, 0.05)] {
        let point = DVec2::new(0.0, -6.0);
        let options = NearestOptions {
            radius: 100.0,
            heading: Some(0.5),
            heading_tolerance: Some(tolerance),
            ..NearestOptions::default()
        };
        let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
        // Seen from the arc's centre.
        let outwards = -DVec2::from_angle(angle).perp();
        let away = point - DVec2::new(0.0, radius);
        let nearest = outwards * clamp(away.dot(outwards), radius, radius + 4.0);
        let (expected, found) = (nearest.distance(away), hit.position.distance);
        assert!((found - expected).abs() < 1e-9, "{tolerance}: {found}, expected {expected}");
        assert!((hit.position.s - radius * angle).abs() < 1e-6, "{tolerance}: {hit:?}");
    }
}

/// A straight road of 100 m along x that rises; its lane is open to cars on half a metre.
fn rising(slope: f64) -> Snapshot {
    open_text(&format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="100" junction="-1"><planView>
        <geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>
        <elevationProfile><elevation s="0" a="0" b="{slope}" c="0" d="0"/></elevationProfile>
        <lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
        <width sOffset="0" a="4" b="0" c="0" d="0"/><access sOffset="0" rule="deny" restriction="passengerCar"/>
        <access sOffset="70" rule="allow" restriction="passengerCar"/><access sOffset="70.5" rule="deny" restriction="passengerCar"/>
        </lane></right></laneSection></lanes></road></OpenDRIVE>"#
    ))
}

/// Where it passes is short beside the stretch of the index, which is all of the road.
#[test]
fn a_short_part_of_a_stretch_passes() {
    let level = NearestOptions { radius: 100.0, ..NearestOptions::default() };
    let xy = DVec2::new(20.0, -2.0);
    for slope in [0.002, 0.05, -0.3] {
        let snapshot = rising(slope);
        let map = snapshot.map();
        for (height, tolerance) in [(70.0, 0.03), (70.0, 1e-4), (3.0, 0.03), (55.5, 1e-6)] {
            let point = Point { xy, z: Some(slope * height) };
            let options = NearestOptions { z_tolerance: Some(tolerance), ..level };
            let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
            let expected = (height - xy.x).abs() - tolerance / f64::abs(slope);
            let (found, s) = (hit.position.distance, hit.position.s);
            assert!(
                (found - expected.max(0.0)).abs() < 1e-8,
                "{slope} {height} {tolerance}: {hit:?}"
            );
            assert!(
                ((s - xy.x).abs() - found).abs() < 1e-8,
                "{slope} {height} {tolerance}: {hit:?}"
            );
        }
        let vehicle = Some(VehicleClass::PassengerCar);
        for (x, expected) in [(20.0, 50.0), (70.25, 0.0), (80.0, 9.5)] {
            let options = NearestOptions { vehicle, ..level };
            let hit = map.nearest_lane(DVec2::new(x, -2.0), &options).expect("an answer");
            let found = hit.expect("a lane").position.distance;
            assert!((found - expected).abs() < 1e-8, "{slope} {x}: {hit:?}");
        }
        // Open and as high as that, at once.
        let point = Point { xy, z: Some(slope * 70.0) };
        let options = NearestOptions { vehicle, z_tolerance: Some(1e-6), ..level };
        let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
        assert!((hit.position.distance - 50.0).abs() < 1e-8, "{slope}: {hit:?}");
        let point = Point { xy, z: Some(slope * 69.0) };
        assert_eq!(map.nearest_lane(point, &options), Ok(None), "{slope}");
    }
}

/// A lane on which cars may and may not drive in turns, in thousands of pieces on one stretch of the index.
#[test]
fn the_nearest_of_many_open_pieces_is_found() {
    const PIECE: f64 = 0.2;
    let record = |i: u32| {
        let (s, rule) = (f64::from(i) * PIECE, if i.is_multiple_of(2) { "deny" } else { "allow" });
        format!(r#"<access sOffset="{s}" rule="{rule}" restriction="passengerCar"/>"#)
    };
    let records: String = (0..5_000).map(record).collect();
    let snapshot = open_text(&format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="1000" junction="-1"><planView>
        <geometry s="0" x="0" y="0" hdg="0" length="1000"><line/></geometry></planView>
        <lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
        <width sOffset="0" a="4" b="0" c="0" d="0"/>{records}</lane></right></laneSection></lanes></road></OpenDRIVE>"#
    ));
    let options =
        NearestOptions { vehicle: Some(VehicleClass::PassengerCar), ..NearestOptions::default() };
    for i in (0..5_000u32).step_by(97) {
        let x = (f64::from(i) + 0.25) * PIECE;
        let hit = snapshot.map().nearest_lane(DVec2::new(x, -2.0), &options).expect("an answer");
        let found = hit.expect("a lane").position;
        // Of a closed piece the nearer end, but where the road begins.
        let expected = match i {
            0 => 0.75 * PIECE,
            _ if i.is_multiple_of(2) => 0.25 * PIECE,
            _ => 0.0,
        };
        assert!((found.distance - expected).abs() < 1e-4, "{x}: {found:?}, expected {expected}");
    }
}
