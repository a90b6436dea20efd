//! Points to lanes and to track coordinates against looking everywhere: a search of its own, which knows neither index nor
//! projection, only where (s, t) lies.

use mapd_client::glam::DVec2;
use mapd_client::vocabulary::LaneType;
use mapd_client::{Lane, LaneTypes, Map, NearestOptions, Road, Track};
use mapd_geometry::clamp;
use mapd_tests::graph_maps::{Line, document, road, section, wide};
use mapd_tests::maps::{Random, carried_and, open, open_text};

/// Maps besides the carried ones.
const MAPS: [&str; 10] = [
    "carla/Town05",
    "carla/Town03",
    "Scenic/Issue295a",
    "Scenic/Issue189",
    "esmini/velodrome",
    "esmini/soderleden",
    "esmini/multi_intersections",
    "drone_dataset/rdb2",
    "gdal/5g_living_lab_A39_Wolfsburg-West",
    "sumo/adlershof_dlr_netconvert",
];
/// Points of each map; a tenth of them in builds with debug assertions.
const POINTS: usize = if cfg!(debug_assertions) { 1_000 } else { 10_000 };
/// Distance between two cross-sections `[m]`.
const STEP: f64 = 1.0;
/// Records that hold for less than this share of a section are not seen: polylines store s in single precision.
const SLIVER: f64 = 2.0 * f32::EPSILON as f64;
/// Added to the circle around two neighbouring cross-sections, for what bulges out of it `[m]`, and as its share.
const MARGIN: (f64, f64) = (0.05, 0.1);
/// Cross-sections looked at between two neighbours before the search narrows.
const PARTS: usize = 8;
/// Narrowings by the golden section: of a metre to 1e-11 m.
const NARROWINGS: usize = 53;
/// What is left of a stretch that is cut by the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Farthest search `[m]`.
const RADIUS: f64 = 50.0;
/// Allowed difference of two distances `[m]`: where cross-sections cross, the search narrows to a neighbour.
const TOLERANCE: f64 = 1e-7;
/// Points of which every one is also looked for on some road that is not near: each of so many.
const OTHER_ROAD: usize = 10;

/// A stretch between two cross-sections, without what begins at its end.
struct Stretch<'a> {
    lane: Option<Lane<'a>>,
    road: Road<'a>,
    from: f64,
    to: f64,
    center: DVec2,
    radius: f64,
}

impl<'a> Stretch<'a> {
    fn new(lane: Option<Lane<'a>>, road: Road<'a>, from: f64, to: f64) -> Self {
        let to = to.next_down().max(from);
        let mut stretch = Self { lane, road, from, to, center: DVec2::ZERO, radius: 0.0 };
        let ends = [stretch.ends(from), stretch.ends(0.5 * (from + to)), stretch.ends(to)];
        let corners = ends.as_flattened();
        stretch.center = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let reach = corners.iter().map(|c| c.distance(stretch.center)).fold(0.0, f64::max);
        stretch.radius = reach * (1.0 + MARGIN.1) + MARGIN.0;
        stretch
    }

    /// Both ends of the cross-section at s: of the lane, or of the reference line, where they are one.
    fn ends(&self, s: f64) -> [DVec2; 2] {
        let at = |t: f64| {
            let pose = self.road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
            pose.position.truncate()
        };
        match self.lane {
            Some(lane) => {
                let edges = lane.edges_at(s);
                [at(edges.inner), at(edges.outer)]
            }
            None => [at(0.0); 2],
        }
    }

    /// Distance of a point from the cross-section at s.
    fn distance_at(&self, point: DVec2, s: f64) -> f64 {
        let [a, b] = self.ends(s);
        let along = b - a;
        let squared = along.length_squared();
        let share =
            if squared > 0.0 { clamp((point - a).dot(along) / squared, 0.0, 1.0) } else { 0.0 };
        point.distance(a + along * share)
    }

    /// Distance of a point from all cross-sections of the stretch, which are its area.
    fn distance(&self, point: DVec2) -> f64 {
        let at = |part: f64| {
            let share = part / PARTS as f64;
            self.distance_at(point, self.from + (self.to - self.from) * share)
        };
        let (mut best, mut nearest) = (f64::INFINITY, 0.0);
        for part in 0..=PARTS {
            let distance = at(part as f64);
            if distance < best {
                (best, nearest) = (distance, part as f64);
            }
        }
        let (mut low, mut high) = ((nearest - 1.0).max(0.0), (nearest + 1.0).min(PARTS as f64));
        // Each narrowing needs one more place: the other is one of those before.
        let inner = |low: f64, high: f64| {
            let length = GOLDEN * (high - low);
            [high - length, low + length]
        };
        let [mut a, mut b] = inner(low, high);
        let (mut at_a, mut at_b) = (at(a), at(b));
        for _ in 0..NARROWINGS {
            best = best.min(at_a).min(at_b);
            if at_a < at_b {
                (high, b, at_b) = (b, a, at_a);
                a = inner(low, high)[0];
                at_a = at(a);
            } else {
                (low, a, at_a) = (a, b, at_b);
                b = inner(low, high)[1];
                at_b = at(b);
            }
        }
        best.min(at_a).min(at_b)
    }
}

/// Stretches whose circles lie in order of their centres' x.
struct Stretches<'a> {
    all: Vec<Stretch<'a>>,
    largest: f64,
}

impl<'a> Stretches<'a> {
    fn new(mut all: Vec<Stretch<'a>>) -> Self {
        all.sort_by(|a, b| a.center.x.total_cmp(&b.center.x));
        let largest = all.iter().map(|stretch| stretch.radius).fold(0.0, f64::max);
        Self { all, largest }
    }

    /// Those that may come within a limit of a point: no other circle reaches so far along x.
    fn around(&self, point: DVec2, limit: f64) -> &[Stretch<'a>] {
        let reach = limit + self.largest;
        let from = self.all.partition_point(|stretch| stretch.center.x < point.x - reach);
        let to = self.all.partition_point(|stretch| stretch.center.x <= point.x + reach);
        &self.all[from..to]
    }
}

/// The smallest distance of a point from any of these, infinite beyond a limit.
fn nearest(stretches: &Stretches<'_>, point: DVec2, limit: f64) -> f64 {
    // A circle holds a place of its stretch, so none is farther than the far side of the nearest circle.
    let (mut candidates, mut limit) = (Vec::new(), limit);
    for stretch in stretches.around(point, limit) {
        let away = point.distance(stretch.center);
        if away - stretch.radius <= limit {
            candidates.push((away - stretch.radius, stretch));
            limit = limit.min(away + stretch.radius);
        }
    }
    candidates.retain(|(bound, _)| *bound <= limit);
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut best = f64::INFINITY;
    for (bound, stretch) in candidates {
        if bound > best {
            break;
        }
        best = best.min(stretch.distance(point));
    }
    best
}

/// Neighbouring places at which to cut: a step apart, and wherever a record begins.
fn cuts(start: f64, end: f64, breaks: impl Iterator<Item = f64>) -> Vec<f64> {
    let steps = ((end - start) / STEP).ceil().max(1.0) as usize;
    let mut cuts: Vec<f64> =
        (0..=steps).map(|i| start + (end - start) * i as f64 / steps as f64).collect();
    cuts.extend(breaks.filter(|s| *s > start && *s < end));
    cuts.sort_by(f64::total_cmp);
    cuts
}

/// Neighbours among cuts.
fn pairs(cuts: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let sliver = cuts.last().zip(cuts.first()).map_or(0.0, |(end, start)| (end - start) * SLIVER);
    cuts.windows(2).map(|pair| (pair[0], pair[1])).filter(move |(a, b)| b - a > sliver)
}

fn lanes(map: Map<'_>) -> Stretches<'_> {
    let of = |lane: Lane<'_>| {
        let section = lane.section();
        cuts(
            section.s_start(),
            section.s_end().min(lane.road().reference_end()),
            lane.shape_breaks(),
        )
    };
    let stretches = map.lanes().flat_map(|lane| {
        let cuts = of(lane);
        let pairs: Vec<_> = pairs(&cuts).collect();
        pairs.into_iter().map(move |(a, b)| Stretch::new(Some(lane), lane.road(), a, b))
    });
    Stretches::new(stretches.collect())
}

/// Per road, its reference line.
fn reference_lines(map: Map<'_>) -> Vec<Stretches<'_>> {
    let of = |road: Road<'_>| {
        let breaks = road.section(0).and_then(|section| section.lane(0));
        let breaks = breaks.into_iter().flat_map(|lane| lane.shape_breaks());
        cuts(0.0, road.reference_end(), breaks)
    };
    map.roads()
        .map(|road| {
            let cuts = of(road);
            let stretches = cuts.windows(2).map(|pair| Stretch::new(None, road, pair[0], pair[1]));
            Stretches::new(stretches.collect())
        })
        .collect()
}

/// A point of the map: anywhere, or, more often, on or beside a lane.
fn point(map: Map<'_>, Stretches { all: lanes, .. }: &Stretches<'_>, random: &mut Random) -> DVec2 {
    if random.unit() < 0.2 {
        return random.point(map);
    }
    let stretch = &lanes[(random.unit() * lanes.len() as f64) as usize];
    let reach = if random.unit() < 0.5 { 1.0 } else { 10.0 };
    stretch.center + DVec2::new(random.between(-reach, reach), random.between(-reach, reach))
}

#[test]
fn what_is_found_is_the_nearest_of_all() {
    let options = NearestOptions { radius: RADIUS, ..NearestOptions::default() };
    for path in carried_and(&MAPS) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let (lanes, lines) = (lanes(map), reference_lines(map));
        let mut random = Random(30);
        let mut found = 0;
        for i in 0..POINTS {
            let point = point(map, &lanes, &mut random);
            let context = || format!("{}, {point}", path.display());
            let expected = nearest(&lanes, point, RADIUS);
            let hit = map.nearest_lane(point, &options).expect("an answer");
            let Some(hit) = hit else {
                assert!(expected > RADIUS - TOLERANCE, "{} missed {expected}", context());
                continue;
            };
            found += 1;
            let lane = map.lane(hit.lane).expect("the map's own lane");
            let error = (hit.position.distance - expected).abs();
            // Where a stretch ends is stored with 24 bits of the section's length.
            let section = lane.section();
            let allowed = TOLERANCE + SLIVER * (section.s_end() - section.s_start());
            assert!(
                error <= allowed,
                "{}: expected {expected}, found {} {hit:?}",
                context(),
                lane.key()
            );
            if hit.position.distance == 0.0 {
                let (s, offset) = (hit.position.s, hit.position.offset);
                let again = lane.pose_at(s, offset).expect("a pose").position.truncate();
                assert!(again.distance(point) <= 1e-8, "{}: {} {hit:?}", context(), lane.key());
            }
            // The lane's own road, and some road of the map.
            let own = lane.road().road_id().row() as usize;
            let other = (i % OTHER_ROAD == 0).then_some(i / OTHER_ROAD % lines.len());
            for row in [Some(own), other].into_iter().flatten() {
                let road = map.roads().nth(row).expect("a road");
                let expected = nearest(&lines[row], point, f64::INFINITY);
                let track = road.to_track(point).expect("a foot");
                assert!(
                    (track.distance - expected).abs() <= TOLERANCE,
                    "{}, road {}: expected {expected}, found {track:?}",
                    context(),
                    road.id()
                );
            }
        }
        assert!(found > POINTS / 2, "{}: only {found} points were near lanes", path.display());
    }
}

/// Of one lane: as near as its nearest cross-section, or in it.
fn check(map: Map<'_>, lanes: &Stretches<'_>, point: DVec2, context: &str) {
    check_types(map, LaneTypes::ALL, lanes, point, context);
}

/// As [`check`], of lanes of some types, of which all stretches are.
fn check_types(map: Map<'_>, types: LaneTypes, lanes: &Stretches<'_>, point: DVec2, context: &str) {
    let options = NearestOptions { radius: RADIUS, types, ..NearestOptions::default() };
    let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
    let (distance, s) = (hit.position.distance, hit.position.s);
    if distance > 0.0 {
        let expected = nearest(lanes, point, RADIUS);
        let error = (distance - expected).abs();
        assert!(error <= TOLERANCE, "{context}, {point}: expected {expected}, found {hit:?}");
    } else {
        // Where it is said to lie, it lies: that tells more than a search, which may miss a foot.
        let lane = map.lane(hit.lane).expect("the map's own lane");
        let again = lane.pose_at(s, hit.position.offset).expect("a pose");
        let off = again.position.truncate().distance(point);
        let edges = lane.edges_at(s);
        let [low, high] = [edges.inner.min(edges.outer), edges.inner.max(edges.outer)];
        let is_between = low - 1e-8 <= hit.position.t && hit.position.t <= high + 1e-8;
        assert!(off <= 1e-8 && is_between, "{context}, {point}: off by {off}, {edges:?}, {hit:?}");
    }
}

/// Beside an edge that bends by its width as well as with the road: Newton's method, which knows of the road alone, may swing to and fro about its foot.
#[test]
fn the_foot_on_an_edge_that_bends_by_itself_is_found() {
    let mut random = Random(32);
    for bend in [-0.09, -0.05, -0.014, -0.003, 0.003, 0.014, 0.05, 0.09] {
        let snapshot = open_text(&format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="24" junction="-1"><planView>
            <geometry s="0" x="0" y="0" hdg="0" length="24"><paramPoly3 pRange="normalized" aU="0" bU="25.4" cU="0" dU="-2.9"
            aV="0" bV="0" cV="-9.3" dV="-0.4"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
            <right><lane id="-1" type="driving"><width sOffset="0" a="9.4" b="0" c="0" d="0"/>
            <width sOffset="16" a="9.4" b="0" c="{bend}" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#
        ));
        let map = snapshot.map();
        let lanes = lanes(map);
        let road = map.road_by_id("1").expect("the road");
        for _ in 0..POINTS {
            let track =
                Track { s: random.between(12.0, 24.0), t: random.between(-22.0, -6.0), h: 0.0 };
            let point = road.to_inertial(track).expect("a pose").position.truncate();
            check(map, &lanes, point, &bend.to_string());
        }
    }
}

/// On lanes that reach beyond the centre of their road's curvature: their cross-sections cross, and points have several feet.
#[test]
fn what_lies_beyond_the_centre_of_curvature_is_found() {
    let mut random = Random(33);
    let bends = [
        r#"<arc curvature="0.2"/>"#,
        r#"<spiral curvStart="0.02" curvEnd="0.35"/>"#,
        r#"<spiral curvStart="-0.1" curvEnd="0.3"/>"#,
        r#"<paramPoly3 pRange="normalized" aU="0" bU="9" cU="0" dU="-4" aV="0" bV="0" cV="9" dV="-2"/>"#,
        r#"<paramPoly3 pRange="normalized" aU="0" bU="10" cU="4" dU="-7" aV="0" bV="0" cV="16" dV="-9"/>"#,
    ];
    for (bend, side) in bends.into_iter().flat_map(|bend| [(bend, "left"), (bend, "right")]) {
        let id = if side == "left" { 1 } else { -1 };
        let snapshot = open_text(&format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="10" junction="-1"><planView>
            <geometry s="0" x="0" y="0" hdg="0" length="10">{bend}</geometry></planView><lanes><laneSection s="0">
            <center><lane id="0" type="none"/></center><{side}><lane id="{id}" type="driving">
            <width sOffset="0" a="7" b="0.2" c="0" d="0"/></lane></{side}></laneSection></lanes></road></OpenDRIVE>"#
        ));
        let map = snapshot.map();
        let lanes = lanes(map);
        for _ in 0..POINTS {
            let point = DVec2::new(random.between(-12.0, 16.0), random.between(-12.0, 16.0));
            check(map, &lanes, point, &format!("{bend} {side}"));
        }
    }
}

/// Beside a tight turn the place is the point's foot to rounding: a search for it on the flat ground around the least distance was off by 3e-8 m.
#[test]
fn beside_a_tight_turn_the_nearest_place_is_the_foot() {
    const WIDTH: f64 = 3.5;
    let mut random = Random(35);
    for curvature in [0.15, 0.18, -0.17, -0.21] {
        let id = if curvature > 0.0 { 1 } else { -1 };
        let lane = wide(id, "", "", &format!("a=\"{WIDTH}\" b=\"0\" c=\"0\" d=\"0\""), "");
        let section = if id > 0 { section(0.0, &lane, "") } else { section(0.0, "", &lane) };
        let line = Line(0.0, 0.0, 0.3, 9.0, curvature);
        let snapshot = open_text(&document(&road("1", "junction=\"-1\"", line, "", &section)));
        let map = snapshot.map();
        let road = map.road_by_id("1").expect("the road");
        for _ in 0..POINTS {
            let (s, beside) = (random.between(0.1, 8.9), random.between(0.0, 0.8));
            let t = (WIDTH + beside) * f64::from(id);
            let point = road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position;
            let hit = map.nearest_lane(point.truncate(), &NearestOptions::default());
            let found = hit.expect("an answer").expect("a lane").position;
            let off = [found.s - s, found.t - t, found.distance - beside];
            assert!(off.iter().all(|off| off.abs() < 1e-11), "{curvature}, {s}, {t}: {found:?}");
        }
    }
}

/// Where a width closes or opens within one of its records, edges have a corner, on either side of which may be the nearest place.
#[test]
fn the_nearest_place_is_found_beside_a_corner() {
    const LENGTH: f64 = 20.0;
    let mut random = Random(34);
    let widths = [
        [0.03, -0.079, 0.0, 0.0],
        [0.4, -0.11, 0.004, 0.0],
        [2.0, -0.9, 0.0, 0.0],
        [-0.5, 0.3, 0.0, 0.0],
        [-1.0, 1.4, -0.3, 0.0],
        [1.0, -1.2, 0.35, -0.025],
    ];
    let bends = [r#"<line/>"#, r#"<arc curvature="0.03"/>"#, r#"<arc curvature="-0.03"/>"#];
    for ([a, b, c, d], bend) in widths.into_iter().flat_map(|width| bends.map(|bend| (width, bend)))
    {
        let snapshot = open_text(&format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="{LENGTH}" junction="-1"><planView>
            <geometry s="0" x="0" y="0" hdg="0" length="{LENGTH}">{bend}</geometry></planView><lanes><laneSection s="0">
            <center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
            <width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="sidewalk">
            <width sOffset="0" a="{a}" b="{b}" c="{c}" d="{d}"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#
        ));
        let map = snapshot.map();
        let lane = map.lanes().find(|lane| lane.number() == -2).expect("the lane");
        let is_open = |s: f64| a + s * (b + s * (c + s * d)) > 0.0;
        let places: Vec<f64> = (0..=2000).map(|i| LENGTH * f64::from(i) / 2000.0).collect();
        let corners: Vec<f64> = places
            .windows(2)
            .filter(|pair| is_open(pair[0]) != is_open(pair[1]))
            .map(|pair| {
                let (mut low, mut high) = (pair[0], pair[1]);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    *if is_open(middle) == is_open(pair[0]) { &mut low } else { &mut high } =
                        middle;
                }
                if is_open(low) { high } else { low }
            })
            .collect();
        assert!(!corners.is_empty(), "{a}, {b}, {c}, {d}");
        let all = cuts(0.0, LENGTH, corners.iter().copied().chain(places));
        let stretches = all.windows(2).filter(|pair| pair[0] < pair[1]);
        let stretches =
            stretches.map(|pair| Stretch::new(Some(lane), lane.road(), pair[0], pair[1]));
        let stretches = Stretches::new(stretches.collect());
        let types = LaneTypes::NONE.with(LaneType::Sidewalk);
        for i in 0..POINTS {
            let corner = corners[i % corners.len()];
            let reach = [0.1, 0.5, 2.0, 8.0][i / corners.len() % 4];
            let (s, t) =
                (corner + random.between(-reach, reach), random.between(-reach, reach) - 3.0);
            let track = Track { s: clamp(s, 0.0, LENGTH), t, h: 0.0 };
            let point = lane.road().to_inertial(track).expect("a pose").position.truncate();
            check_types(map, types, &stretches, point, &format!("{a}, {b}, {c}, {d}, {bend}"));
        }
    }
}
