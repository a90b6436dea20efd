//! A particle filter on the map: 5,000 particles, a simulated drive with a receiver of satellites, odometry, and a camera that sees how the vehicle lies
//! in its lane and how far away the nearest road mark is.
//!
//! `particle_filter MAP`: drives 40 s over the map, prints the error every 5 s beside that of the receiver alone, and ends with an error if the filter does not
//! converge.

use anyhow::{Context, Result, ensure};
use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::glam::DVec2;
use mapd_client::localisation::{MarkFilter, NearMark};
use mapd_client::path::{PathBuffer, PathOptions};
use mapd_client::route::{PositionOnLane, Reach, RouteRequest, RouteScratch, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Client, LaneTypes, Map, NearestOptions};
use std::f64::consts::{PI, TAU};
use std::io::Write;
use std::time::Duration;

/// How long the map may take to come.
const PATIENCE: Duration = Duration::from_secs(30);
const PARTICLES: usize = 5_000;
/// Steps of the drive, time between them `[s]`, and speed `[m/s]`.
const STEPS: usize = 400;
const STEP: f64 = 0.1;
const SPEED: f64 = 8.0;
/// Every so many steps the receiver has a fix, and the camera an image.
const FIX: usize = 10;
const IMAGE: usize = 5;
/// Standard deviations of a fix `[m]`; of odometry, as a share of the way and in `[rad]` for each step; of what the camera sees `[m]`, `[rad]`.
const FIX_NOISE: f64 = 2.5;
const WAY_NOISE: f64 = 0.02;
const TURN_NOISE: f64 = 0.003;
const OFFSET_NOISE: f64 = 0.2;
const HEADING_NOISE: f64 = 0.05;
/// Probability of an image that shows something else.
const WRONG: f64 = 0.05;
/// The last quarter of the drive is no farther off than this on average `[m]`.
const GOOD: f64 = 1.0;

/// A generator of numbers that look like chance (xorshift).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Normally distributed (Box and Muller).
    fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.unit()).ln()).sqrt() * (TAU * self.unit()).cos()
    }
}

/// Where a vehicle may be, a column for each part.
#[derive(Default)]
struct Particles {
    x: Vec<f64>,
    y: Vec<f64>,
    heading: Vec<f64>,
    weight: Vec<f64>,
    /// Where they are, and the nearest mark to each.
    places: Vec<DVec2>,
    marks: Vec<Option<NearMark>>,
    /// Room for the next generation.
    next: [Vec<f64>; 3],
}

/// What a camera sees: the vehicle's place across its lane, to the left of its centre, and its turn from the lane's direction; and the distance of the nearest
/// mark, on roads that have marks.
#[derive(Clone, Copy)]
struct Image {
    offset: f64,
    turn: f64,
    mark: Option<f64>,
}

impl Particles {
    /// Anywhere around a fix, turned anyhow.
    fn around(fix: DVec2, random: &mut Random) -> Self {
        let mut own = Self::default();
        for _ in 0..PARTICLES {
            own.x.push(fix.x + 1.5 * FIX_NOISE * random.normal());
            own.y.push(fix.y + 1.5 * FIX_NOISE * random.normal());
            own.heading.push(TAU * random.unit() - PI);
        }
        own.weight.resize(PARTICLES, 1.0);
        own
    }

    /// Each drives as odometry says, and as it may err.
    fn drive(&mut self, way: f64, turn: f64, random: &mut Random) {
        for i in 0..PARTICLES {
            let heading = self.heading[i] + turn + 2.0 * TURN_NOISE * random.normal();
            let way = way * (1.0 + 2.0 * WAY_NOISE * random.normal());
            self.x[i] += way * heading.cos();
            self.y[i] += way * heading.sin();
            self.heading[i] = heading;
        }
    }

    fn weigh_fix(&mut self, fix: DVec2) {
        for i in 0..PARTICLES {
            let away = DVec2::new(self.x[i], self.y[i]) - fix;
            self.weight[i] *= (-0.5 * away.length_squared() / FIX_NOISE.powi(2)).exp();
        }
    }

    /// Weighs all by what the camera should see from there: one question about the lanes of all particles, one about their marks.
    fn weigh_image(
        &mut self,
        map: Map<'_>,
        seen: Image,
        scratch: &mut BatchScratch,
        lanes: &mut NearestLanes,
    ) -> Result<()> {
        let places = Places { x: &self.x, y: &self.y, z: None, heading: Some(&self.heading) };
        map.nearest_lanes(places, &options(), scratch, lanes)?;
        if seen.mark.is_some() {
            self.places.clear();
            self.places.extend(self.x.iter().zip(&self.y).map(|(x, y)| DVec2::new(*x, *y)));
            map.nearest_marks(&self.places, &MarkFilter::default(), &mut self.marks)?;
        }
        for i in 0..PARTICLES {
            let mut fits = 0.0;
            if lanes.lane[i].is_some() {
                let off = (lanes.offset[i] - seen.offset) / OFFSET_NOISE;
                let turned = wrapped(self.heading[i] - lanes.heading[i] - seen.turn);
                let turned = turned / HEADING_NOISE;
                fits = (-0.5 * (off * off + turned * turned)).exp();
            }
            if let Some(distance) = seen.mark {
                let off = self.marks[i].map_or(f64::INFINITY, |mark| mark.distance - distance);
                fits *= WRONG + (-0.5 * (off / OFFSET_NOISE).powi(2)).exp();
            }
            self.weight[i] *= WRONG + fits;
        }
        Ok(())
    }

    /// The mean place.
    fn mean(&self) -> DVec2 {
        let all = self.x.iter().zip(&self.y).zip(&self.weight);
        let sum: DVec2 = all.map(|((x, y), weight)| DVec2::new(*x, *y) * *weight).sum();
        sum / self.weight.iter().sum::<f64>()
    }

    /// Draws all anew by their weights, where these differ much.
    fn draw(&mut self, random: &mut Random) {
        let sum: f64 = self.weight.iter().sum();
        let squares: f64 = self.weight.iter().map(|weight| weight * weight).sum();
        if sum * sum > 0.5 * PARTICLES as f64 * squares {
            return;
        }
        let step = sum / PARTICLES as f64;
        let (mut at, mut reached) = (0, self.weight[0]);
        let first = step * random.unit();
        self.next.iter_mut().for_each(Vec::clear);
        for i in 0..PARTICLES {
            while reached < first + step * i as f64 && at + 1 < PARTICLES {
                at += 1;
                reached += self.weight[at];
            }
            let values = [self.x[at], self.y[at], self.heading[at]];
            self.next.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        let [x, y, heading] = &mut self.next;
        std::mem::swap(&mut self.x, x);
        std::mem::swap(&mut self.y, y);
        std::mem::swap(&mut self.heading, heading);
        self.weight.fill(1.0);
    }
}

/// Lanes that cars drive on, by the heading too.
fn options() -> NearestOptions {
    NearestOptions {
        types: LaneTypes::routable(),
        heading_tolerance: Some(0.5 * PI),
        ..NearestOptions::default()
    }
}

fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

fn main() -> Result<()> {
    let name = std::env::args().nth(1).context("usage: particle_filter MAP")?;
    let client = Client::connect(&name, PATIENCE).context("the map did not come in time")?;
    filter(client.snapshot().map())
}

/// Places and headings of a drive: to the farthest place that is reached without a change of lane.
fn drive(map: Map<'_>) -> Result<Vec<(DVec2, f64)>> {
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    let (mut network, mut buffer) = (Reach::default(), PathBuffer::default());
    let cost = ShortestLength { lane_change: f64::INFINITY };
    let vehicle = VehicleClass::PassengerCar;
    let wanted = STEPS as f64 * STEP * SPEED;
    for lane in map.lanes().filter(|lane| lane.kind().is_drivable()) {
        let section = lane.section();
        let s = if lane.is_forward() { section.s_start() } else { section.s_end() };
        let start = PositionOnLane { lane: lane.lane_id(), s };
        let starts = [start.into()];
        let request =
            RouteRequest { starts: &starts, goals: &[], vehicle, cost: &cost, avoid: &[] };
        map.reach(&request, 2.0 * wanted, &mut scratch, &mut network)?;
        let Some(last) = network.reached().last().filter(|last| last.cost > wanted) else {
            continue;
        };
        let goal = PositionOnLane { lane: last.lane, s: last.s_to };
        map.route(start, goal, vehicle, &cost, &mut scratch, &mut steps)?;
        let path = map.path(&steps, &PathOptions::default(), &mut buffer)?;
        let place = |i: usize| {
            let at = path.at(i as f64 * STEP * SPEED)?;
            Ok((at.position.truncate(), at.heading))
        };
        return (0..STEPS).map(place).collect();
    }
    anyhow::bail!("the map has no way of {wanted} m")
}

fn filter(map: Map<'_>) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let random = &mut Random(0x5eed_1234_5678_9abc);
    let truth = drive(map)?;
    let (mut scratch, mut lanes) = (BatchScratch::default(), NearestLanes::default());
    let mut fix = truth[0].0 + FIX_NOISE * DVec2::new(random.normal(), random.normal());
    let mut particles = Particles::around(fix, random);
    let (mut late, mut receiver) = (0.0, 0.0);
    for (i, pair) in truth.windows(2).enumerate() {
        let [(before, was), (place, heading)] = [pair[0], pair[1]];
        let way = before.distance(place) * (1.0 + WAY_NOISE * random.normal());
        let turn = wrapped(heading - was) + TURN_NOISE * random.normal();
        particles.drive(way, turn, random);
        if i % FIX == 0 {
            fix = place + FIX_NOISE * DVec2::new(random.normal(), random.normal());
            particles.weigh_fix(fix);
        }
        let seen =
            map.nearest_lane(place, &NearestOptions { heading: Some(heading), ..options() })?;
        if let Some(lane) = seen.filter(|_| i % IMAGE == 0) {
            let mark = map.nearest_mark(place, &MarkFilter::default())?;
            let image = Image {
                offset: lane.position.offset + OFFSET_NOISE * random.normal(),
                turn: wrapped(heading - lane.position.heading) + HEADING_NOISE * random.normal(),
                mark: mark.map(|mark| mark.distance + OFFSET_NOISE * random.normal()),
            };
            particles.weigh_image(map, image, &mut scratch, &mut lanes)?;
        }
        let (error, alone) = (particles.mean().distance(place), fix.distance(place));
        if i % 50 == 0 {
            writeln!(out, "{:.0} s: {error:.2} m off, the last fix {alone:.2} m", i as f64 * STEP)?;
        }
        if 4 * i >= 3 * STEPS {
            late += 4.0 * error / STEPS as f64;
            // A fix is as old as the steps since.
            receiver += if i % FIX == 0 { (4 * FIX) as f64 * alone / STEPS as f64 } else { 0.0 };
        }
        particles.draw(random);
    }
    ensure!(late < GOOD, "{late:.2} m off at the end: the filter has not converged");
    writeln!(
        out,
        "converged: {late:.2} m off on average at the end, the receiver alone {receiver:.2} m"
    )?;
    Ok(())
}
