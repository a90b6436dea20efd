//! Writes questions with their answers by Rust, for programs in other languages to be compared with bit by bit.
//!
//! `answers FOLDER [COUNT]`: for each map that the project carries `FOLDER/MAP.mapd` and `FOLDER/MAP.answers`, with COUNT questions of every kind
//! (default 2000). A line is a question's kind, its numbers, `|` and the answer's numbers, in hexadecimal: bits of doubles, ids as
//! `row + content * 2^32`, counts and codes as they are. An answer that is an option begins with 1 or is 0; a list begins with its count.

use mapd_archive::{VehicleClass, encode};
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::{
    ClassSet, LandmarkSource, Lane, LaneId, LanePlace, LaneSequences, LineSource, Map, Nearest,
    NearestOptions, ObjectId, Point, Pose, Road, RouteScratch, ShortestLength, ShortestTime,
    SignalId, SignalsAhead, Snapshot, Track,
};
use mapd_compiler::{CompileOptions, compile};
use std::fmt::Write as _;
use std::path::Path;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Maps that the project carries.
const MAPS: &[&str] = &["town", "objects", "marks", "surfaces", "one_road"];

/// Numbers of an answer.
#[derive(Default)]
struct Numbers(Vec<u64>);

impl Numbers {
    fn f(&mut self, value: f64) -> &mut Self {
        self.0.push(value.to_bits());
        self
    }

    fn u(&mut self, value: impl Into<u64>) -> &mut Self {
        self.0.push(value.into());
        self
    }

    fn v(&mut self, at: DVec3) -> &mut Self {
        self.f(at.x).f(at.y).f(at.z)
    }

    fn option(&mut self, value: Option<f64>) -> &mut Self {
        self.u(u64::from(value.is_some())).f(value.unwrap_or(0.0))
    }

    fn pose(&mut self, pose: &Pose) -> &mut Self {
        self.v(pose.position).f(pose.heading).f(pose.curvature).f(pose.slope);
        self.f(pose.superelevation).u(clamped(pose.clamped))
    }

    fn nearest(&mut self, one: &Nearest) -> &mut Self {
        let p = one.position;
        self.u(one.lane.to_bits()).f(p.s).f(p.t).f(p.offset).f(p.offset_of_reference_line);
        self.f(p.distance).f(p.z).f(p.heading).f(p.heading_of_reference_line).u(clamped(p.clamped))
    }

    fn lanes(&mut self, lanes: impl Iterator<Item = LaneId>) -> &mut Self {
        let all: Vec<u64> = lanes.map(LaneId::to_bits).collect();
        self.u(all.len() as u64);
        self.0.extend(all);
        self
    }
}

fn clamped(clamped: mapd_client::Clamped) -> u64 {
    match clamped.name() {
        "before" => 1,
        "after" => 2,
        _ => 0,
    }
}

/// What names nothing.
const NOTHING: u64 = u32::MAX as u64;

fn signal_bits(id: Option<SignalId>) -> u64 {
    id.map_or(NOTHING, SignalId::to_bits)
}

fn object_bits(id: Option<ObjectId>) -> u64 {
    id.map_or(NOTHING, ObjectId::to_bits)
}

fn lane_bits(lane: Option<Lane<'_>>) -> u64 {
    lane.map_or(NOTHING, |lane| lane.lane_id().to_bits())
}

/// FNV-1a of a text.
fn hash(text: &str) -> u64 {
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3))
}

/// Steele, Lea and Flood's SplitMix64: the same questions everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() % all.len() as u64) as usize]
    }
}

/// Asks about one map.
struct Asker<'a> {
    map: Map<'a>,
    lanes: Vec<Lane<'a>>,
    roads: Vec<Road<'a>>,
    random: Random,
    out: String,
}

impl<'a> Asker<'a> {
    fn point(&mut self) -> DVec2 {
        let (low, high) = self.map.bounds();
        let x = self.random.between(low.x - 10.0, high.x + 10.0);
        DVec2::new(x, self.random.between(low.y - 10.0, high.y + 10.0))
    }

    /// A lane, and an s that may lie a little outside.
    fn place(&mut self) -> (Lane<'a>, f64) {
        let lane = self.random.one_of(&self.lanes);
        let section = lane.section();
        (lane, self.random.between(section.s_start() - 1.0, section.s_end() + 1.0))
    }

    fn write(&mut self, kind: &str, question: &Numbers, answer: &Numbers) {
        self.out.push_str(kind);
        for number in &question.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push_str(" |");
        for number in &answer.0 {
            let _ = write!(self.out, " {number:x}");
        }
        self.out.push('\n');
    }

    fn points(&mut self) -> Result<()> {
        let map = self.map;
        let at = self.point();
        let (radius, has_z) = (self.random.between(0.5, 30.0), self.random.next() % 2);
        let z = self.random.between(-2.0, 2.0);
        let point = Point { xy: at, z: (has_z == 1).then_some(z) };
        let options = NearestOptions { radius, ..NearestOptions::default() };
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y).f(z).u(has_z).f(radius);
        match map.nearest_lane(point, &options)? {
            Some(hit) => a.u(1u64).nearest(&hit),
            None => a.u(0u64),
        };
        self.write("nearest", &q, &a);

        let (mut near, mut a) = (Vec::new(), Numbers::default());
        map.lanes_near(point, &options, &mut near)?;
        a.u(near.len() as u64);
        near.iter().for_each(|one| {
            a.nearest(one);
        });
        self.write("near", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y).f(radius);
        let mut objects = Vec::new();
        map.objects_near(at, radius, &mut objects)?;
        a.u(objects.len() as u64);
        for one in &objects {
            let copy = one.place.copy.map_or(NOTHING, u64::from);
            a.u(one.place.object.to_bits()).u(copy).f(one.distance);
        }
        self.write("objects", &q, &a);

        let (mut landmarks, mut a) = (Vec::new(), Numbers::default());
        map.landmarks_near(at, radius, ClassSet::LANDMARKS, &mut landmarks)?;
        a.u(landmarks.len() as u64);
        for one in &landmarks {
            let (signal, place) = match one.source {
                LandmarkSource::Signal(signal) => (Some(signal), None),
                LandmarkSource::Object(place) => (None, Some(place.object)),
            };
            a.u(signal_bits(signal)).u(object_bits(place)).u(one.class.code()).v(one.position);
            a.f(one.heading).f(one.size[0]).f(one.size[1]).f(one.size[2]).f(one.distance);
        }
        self.write("landmarks", &q, &a);

        let road = self.random.one_of(&self.roads);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.u(road.road_id().to_bits()).f(at.x).f(at.y).f(z).u(has_z);
        let track = road.to_track(point)?;
        a.f(track.s).f(track.t).option(track.h).f(track.distance).u(clamped(track.clamped));
        a.u(u64::from(track.exact));
        self.write("track", &q, &a);

        let mut a = Numbers::default();
        if let Ok(place) =
            map.projector().map_err(drop).and_then(|p| p.to_geodetic(at.extend(z)).map_err(drop))
        {
            a.u(1u64).f(place.latitude).f(place.longitude).f(place.altitude);
        } else {
            a.u(0u64);
        }
        let mut q = Numbers::default();
        self.write("geodetic", q.f(at.x).f(at.y).f(z), &a);
        Ok(())
    }

    fn roads(&mut self) -> Result<()> {
        let road = self.random.one_of(&self.roads);
        let s = self.random.between(-1.0, road.length() + 1.0);
        let (t, h) = (self.random.between(-12.0, 12.0), self.random.between(-1.0, 1.0));
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.u(road.road_id().to_bits()).f(s).f(t).f(h);
        a.pose(&road.to_inertial(Track { s, t, h })?);
        self.write("inertial", &q, &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let surface = road.surface_at(s, t)?;
        a.v(surface.position).v(surface.normal).u(surface.lane.map_or(NOTHING, LaneId::to_bits));
        a.u(u64::from(surface.material.is_some()));
        a.f(surface.material.and_then(|one| one.friction).unwrap_or(-1.0))
            .u(clamped(surface.clamped));
        self.write("surface", q.u(road.road_id().to_bits()).f(s).f(t), &a);
        Ok(())
    }

    fn lanes(&mut self) -> Result<()> {
        let map = self.map;
        let (lane, s) = self.place();
        let id = lane.lane_id().to_bits();
        let offset = self.random.between(-2.0, 2.0);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.pose(&lane.pose_at(s, offset)?);
        self.write("pose", q.u(id).f(s).f(offset), &a);

        let at = lane.pose_at(s, offset * 3.0)?.position.truncate();
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.nearest(&Nearest { lane: lane.lane_id(), position: lane.position_of(at)? });
        self.write("position", q.u(id).f(at.x).f(at.y), &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let (edges, waypoint) = (lane.edges_at(s), lane.waypoint_at(s)?);
        a.f(edges.inner).f(edges.outer).f(lane.width_at(s)).option(lane.speed_limit_at(s));
        a.f(waypoint.s).v(waypoint.position).f(waypoint.heading).f(waypoint.width);
        let [left, right] = lane.bounds_at(s).ok_or("bounds")?;
        a.v(left).v(right).f(lane.length_between(s, lane.section().s_end()));
        let rule = lane.speed_rule_at(s);
        a.option(rule.max).u(signal_bits(rule.signal));
        match lane.road_mark_at(s) {
            Some(mark) => {
                a.u(1u64).u(mark.kind().code()).u(mark.color().code()).f(mark.width_or_default())
            }
            None => a.u(0u64),
        };
        self.write("at", q.u(id).f(s), &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        a.u(hash(&lane.key().to_string())).u(lane.number() as u32).u(lane.kind().code());
        a.u(u64::from(lane.is_forward())).f(lane.section().s_start()).f(lane.section().s_end());
        a.u(lane_bits(lane.left())).u(lane_bits(lane.right())).u(lane_bits(lane.opposite()));
        a.lanes(lane.successors()).lanes(lane.predecessors());
        a.lanes(lane.entries().map(|one| one.lane_id()));
        a.lanes(lane.movement_lanes().map(|one| one.lane_id()));
        a.u(lane.turn().bit());
        let ways: Vec<_> = lane.right_of_way().collect();
        a.u(ways.len() as u64);
        for one in &ways {
            a.u(lane_bits(one.other())).u(one.relation().code()).u(one.reason().code());
        }
        let lights: Vec<_> = lane.movement_lights().collect();
        a.u(lights.len() as u64);
        for one in &lights {
            a.u(one.signal().signal_id().to_bits()).u(lane_bits(one.lane()));
        }
        self.write("lane", q.u(id), &a);

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let line = lane.center_line();
        a.u(line.len() as u64);
        line.points().for_each(|(s, at)| {
            a.f(s).v(at);
        });
        self.write("line", q.u(id), &a);

        let reach = self.random.between(5.0, 150.0);
        let from = LanePlace { lane: lane.lane_id(), s };
        let (mut q, mut ahead) = (Numbers::default(), SignalsAhead::default());
        q.u(id).f(s).f(reach);
        map.signals_ahead(from, reach, VehicleClass::PassengerCar, &mut ahead)?;
        let mut a = Numbers::default();
        a.u(ahead.iter().len() as u64);
        for one in ahead.iter() {
            a.u(one.signal.to_bits()).u(one.lane.to_bits()).f(one.distance).f(one.s);
        }
        self.write("ahead", &q, &a);

        let (mut sequences, mut a) = (LaneSequences::default(), Numbers::default());
        map.lane_sequences_ahead(from, reach, VehicleClass::PassengerCar, &mut sequences)?;
        a.u(sequences.iter().len() as u64);
        for lanes in sequences.iter() {
            a.lanes(lanes.iter().copied());
        }
        self.write("sequences", &q, &a);

        let mut a = Numbers::default();
        match map.next_junction(from, reach, VehicleClass::PassengerCar)? {
            Some(next) => a.u(1u64).u(next.junction.to_bits()).f(next.distance),
            None => a.u(0u64),
        };
        self.write("junction", &q, &a);
        Ok(())
    }

    fn routes(&mut self, scratch: &mut RouteScratch) -> Result<()> {
        let map = self.map;
        let ((from, s_from), (to, s_to)) = (self.place(), self.place());
        let by_time = self.random.next() % 2;
        let places = [
            LanePlace { lane: from.lane_id(), s: s_from },
            LanePlace { lane: to.lane_id(), s: s_to },
        ];
        let (mut q, mut a, mut steps) = (Numbers::default(), Numbers::default(), Vec::new());
        q.u(from.lane_id().to_bits()).f(s_from).u(to.lane_id().to_bits()).f(s_to).u(by_time);
        let class = VehicleClass::PassengerCar;
        let route = if by_time == 1 {
            map.route_via(&places, class, &ShortestTime::default(), scratch, &mut steps)?
        } else {
            map.route_via(&places, class, &ShortestLength::default(), scratch, &mut steps)?
        };
        a.u(u64::from(route.is_some()));
        if let Some(route) = route {
            a.f(route.cost).f(route.length).f(route.travel_time).u(route.lane_changes);
            a.u(steps.len() as u64);
            for step in &steps {
                a.u(step.lane.to_bits()).u(u64::from(step.forward)).u(step.enter as u64);
                a.f(step.s_from).f(step.s_to).f(step.s_latest);
            }
            let mut lines = Vec::new();
            map.lines_along(&steps, &mut lines)?;
            a.u(lines.len() as u64);
            for one in &lines {
                let (signal, object) = match one.line.source {
                    LineSource::Signal(signal) => (Some(signal), None),
                    LineSource::Object(object) => (None, Some(object)),
                };
                a.u(signal_bits(signal)).u(object_bits(object)).u(one.line.lane.to_bits());
                a.f(one.line.s).f(one.distance).u(one.line.class.code());
            }
        }
        self.write("route", &q, &a);

        let limit = self.random.between(10.0, 300.0);
        let (mut q, mut a, mut reached) = (Numbers::default(), Numbers::default(), Vec::new());
        map.reachable(places[0], limit, class, &ShortestLength::default(), scratch, &mut reached)?;
        a.u(reached.len() as u64);
        for one in &reached {
            a.u(one.node.to_bits()).f(one.cost);
        }
        self.write("reachable", q.u(from.lane_id().to_bits()).f(s_from).f(limit), &a);
        Ok(())
    }
}

fn main() -> Result<()> {
    let mut args = std::env::args().skip(1);
    let folder = args.next().ok_or("usage: answers FOLDER [COUNT]")?;
    let count: u32 = args.next().map_or(Ok(2000), |text| text.parse())?;
    std::fs::create_dir_all(&folder)?;
    for name in MAPS {
        let file = std::fs::File::open(mapd_tests::carried(&format!("{name}.xodr")))?;
        let compiled = compile(file, &CompileOptions::default(), &mut |_| {})?;
        let rows = compiled.rows.as_ref().ok_or("the map was rejected")?;
        let bytes = encode(rows, &compiled.provenance)?;
        let path = Path::new(&folder).join(name);
        std::fs::write(path.with_extension("mapd"), &bytes[..])?;
        let snapshot = Snapshot::from_bytes(bytes)?;
        let map = snapshot.map();
        let random = Random(0x6d61_7064);
        let (lanes, roads) = (map.lanes().collect(), map.roads().collect());
        let mut asker = Asker { map, lanes, roads, random, out: String::new() };
        let mut scratch = RouteScratch::default();
        for _ in 0..count {
            asker.points()?;
            asker.roads()?;
            asker.lanes()?;
            asker.routes(&mut scratch)?;
        }
        std::fs::write(path.with_extension("answers"), asker.out)?;
    }
    Ok(())
}
