//! Questions of who drives: the lane from fix to fix, how the vehicle stands, what its sensors see.

use crate::numbers::{NOTHING, Numbers, lane_id_bits, object_bits, short, signal_bits};
use crate::{Asker, Result};
use mapd_client::glam::{DMat3, DVec2};
use mapd_client::localisation::{
    GroundScratch, LandmarkSource, MarkFilter, MarkSource, Sensor, Tracked, Tracker, TrackerFix,
    TrackerOptions, VehiclePose,
};
use mapd_client::vocabulary::ClassSet;
use mapd_client::{Nearest, Point, Region};

/// Fixes of a drive.
const FIXES: u32 = 6;
/// Where the wheels stand, from the reference point `[m]`.
const WHEELS: [DVec2; 4] =
    [DVec2::new(2.0, 0.8), DVec2::new(2.0, -0.8), DVec2::new(-1.0, 0.8), DVec2::new(-1.0, -0.8)];

impl Asker<'_> {
    pub(crate) fn drive(&mut self) -> Result<()> {
        let (map, (lane, s)) = (self.map, self.place());
        let side = if lane.is_forward() { 1.0 } else { -1.0 };
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let mut tracker = Tracker::new();
        q.id(lane.lane_id().to_bits());
        for i in 0..FIXES {
            let on = lane.pose_at(s + side * 4.0 * f64::from(i), 0.0)?;
            let noise = DVec2::new(self.random.between(-0.8, 0.8), self.random.between(-0.8, 0.8));
            let (time, xy) = (0.5 * f64::from(i), on.position.truncate() + noise);
            let heading = on.heading + self.random.between(-0.1, 0.1);
            let odometer = (i % 3 != 2).then_some(4.0 * f64::from(i));
            q.f(time).f(xy.x).f(xy.y).f(heading).option(odometer);
            let pose = VehiclePose { position: xy.into(), heading };
            let covariance = DMat3::from_diagonal([0.5, 0.5, 0.02].into());
            let fix = TrackerFix { time, pose, covariance, odometer };
            match tracker.update(map, &fix, &TrackerOptions::default())? {
                Tracked::Lane(found) => {
                    a.u(0u64).u(u64::from(found.forward)).f(found.probability);
                    a.nearest(&Nearest { lane: found.lane, position: found.position });
                }
                Tracked::NoLane => {
                    a.u(1u64);
                }
                Tracked::Unknown => {
                    a.u(2u64);
                }
            }
            a.f(tracker.none()).u(tracker.hypotheses().len() as u64);
            a.f(tracker.probability_in(&[lane.lane_id()]));
        }
        self.write("tracker", &q, &a);

        let on = lane.pose_at(s, self.random.between(-2.0, 2.0))?;
        let (at, heading) = (on.position.truncate(), on.heading);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let (z, has_z, expected) = (on.position.z, self.random.next() % 2, self.expected_at(at)?);
        q.f(at.x).f(at.y).f(z).u(has_z).f(heading).u(lane_id_bits(expected));
        let position = Point { xy: at, z: (has_z == 1).then_some(z) };
        let (pose, mut ground) = (VehiclePose { position, heading }, GroundScratch::default());
        let found = map.stance(&pose, &WHEELS, expected.as_slice(), &mut ground)?;
        let is_told = found != map.stance(&pose, &WHEELS, &[], &mut ground)?;
        match found {
            Some(own) => {
                a.u(1u64).f(own.z).f(own.roll).f(own.pitch);
                own.wheels.iter().for_each(|wheel| {
                    a.option(*wheel);
                });
            }
            None => {
                a.u(0u64);
            }
        }
        self.told_by_expected[1] |= self.write("stance", &q, &a) && is_told;

        let (range, field_of_view) =
            (self.random.between(5.0, 80.0), self.random.between(0.5, 7.0));
        let (mut q, mut a, mut seen) = (Numbers::default(), Numbers::default(), Vec::new());
        let sensor = Sensor { position: at, heading, range, field_of_view };
        map.landmarks_in_view(&sensor, ClassSet::LANDMARKS, &mut seen)?;
        a.u(seen.len() as u64);
        for one in &seen {
            let (signal, object, copy) = match one.landmark.source {
                LandmarkSource::Signal(signal) => (Some(signal), None, None),
                LandmarkSource::Object(place) => (None, Some(place.object), place.copy),
            };
            a.u(signal_bits(signal)).u(object_bits(object)).u(copy.map_or(NOTHING, u64::from));
            a.f(one.landmark.distance).f(one.bearing).f(one.facing);
        }
        self.write("sees", q.f(at.x).f(at.y).f(heading).f(range).f(field_of_view), &a);

        let size = DVec2::new(self.random.between(1.0, 20.0), self.random.between(1.0, 20.0));
        let (region, spacing) =
            (Region { low: at - size, high: at + size }, self.random.between(0.5, 4.0));
        let (mut q, mut a, mut paint) = (Numbers::default(), Numbers::default(), Vec::new());
        map.mark_points(region, spacing, &MarkFilter::default(), &mut paint)?;
        a.u(paint.len() as u64);
        for one in &paint {
            let (lane, place, is_outline) = match one.source {
                MarkSource::Lane(lane) => (Some(lane), None, false),
                MarkSource::Line(place) => (None, Some(place), false),
                MarkSource::Outline(place) => (None, Some(place), true),
            };
            let (object, copy) = (place.map(|place| place.object), place.and_then(|p| p.copy));
            a.v(one.position)
                .u(lane.map_or(NOTHING, |lane| short(lane.to_bits())))
                .u(object_bits(object));
            a.u(copy.map_or(NOTHING, u64::from)).u(u64::from(is_outline));
            a.f(one.s).f(one.width).u(one.kind.code()).u(one.color.code());
        }
        q.f(region.low.x).f(region.low.y).f(region.high.x).f(region.high.y).f(spacing);
        self.write("paint", &q, &a);
        Ok(())
    }
}
