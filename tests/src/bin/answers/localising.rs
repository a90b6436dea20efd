//! What a localiser asks: ground, marks, and which lanes a pose and a trace may be on.

use crate::numbers::{Numbers, lane_id_bits};
use crate::{Asker, Result};
use mapd_client::glam::{DMat3, DVec2};
use mapd_client::localisation::TracePosition;
use mapd_client::localisation::{
    GroundScratch, LaneMatch, MarkFilter, MatchOptions, Side, TraceFix, TraceMatch, TraceOptions,
    TraceScratch, VehiclePose,
};
use mapd_client::{LaneId, Nearest, NearestOptions, Point};

/// Fixes of a trace.
const FIXES: u32 = 5;

/// Memory of what localisers ask.
#[derive(Default)]
pub(crate) struct Localising {
    ground: GroundScratch,
    matches: Vec<LaneMatch>,
    trace: TraceScratch,
    traced: Vec<TraceMatch>,
}

impl Asker<'_> {
    /// One of the lanes that hold a place, or none: what an answer there may be told to expect.
    pub(crate) fn expected_at(&mut self, at: DVec2) -> Result<Option<LaneId>> {
        let options = NearestOptions { radius: 0.0, ..NearestOptions::default() };
        let mut lanes = Vec::new();
        self.map.lanes_near(at, &options, &mut lanes)?;
        let chosen = (self.random.next() % (2 * lanes.len() as u64 + 1)) as usize;
        Ok(lanes.get(chosen).map(|one| one.lane))
    }

    pub(crate) fn poses(&mut self, scratch: &mut Localising) -> Result<()> {
        let (map, (lane, s)) = (self.map, self.place());
        let offset = self.random.between(-3.0, 3.0);
        let on = lane.pose_at(s, offset)?;
        let at = on.position.truncate();
        let (z, has_z) = (on.position.z + self.random.between(-3.0, 3.0), self.random.next() % 2);
        let point = Point { xy: at, z: (has_z == 1).then_some(z) };
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        let expected = self.expected_at(at)?;
        q.f(at.x).f(at.y).f(z).u(has_z).u(lane_id_bits(expected));
        let found = map.ground_at(point, expected.as_slice(), &mut scratch.ground)?;
        let is_told = found != map.ground_at(point, &[], &mut scratch.ground)?;
        match found {
            Some(one) => a
                .u(1u64)
                .f(one.z)
                .v(one.normal)
                .f(one.s)
                .f(one.t)
                .id(one.lane.to_bits())
                .u(one.level)
                .u(one.levels),
            None => a.u(0u64),
        };
        self.told_by_expected[0] |= self.write("ground", &q, &a) && is_told;

        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y);
        match map.nearest_mark(at, &MarkFilter::default())? {
            Some(one) => a
                .u(1u64)
                .id(one.lane.to_bits())
                .f(one.s)
                .f(one.place.x)
                .f(one.place.y)
                .f(one.distance)
                .f(one.width)
                .u(u64::from(one.side_of_reference_line == Side::Left))
                .u(one.kind.code())
                .u(one.color.code())
                .u(one.painted.map_or(2, u64::from)),
            None => a.u(0u64),
        };
        self.write("mark", &q, &a);

        let heading = on.heading + self.random.between(-0.5, 0.5);
        let deviations = [
            self.random.between(0.1, 3.0),
            self.random.between(0.1, 3.0),
            self.random.between(0.01, 1.0),
        ];
        let share = self.random.between(-0.9, 0.9) * deviations[0] * deviations[1];
        let [x, y, h] = deviations.map(|one| one * one);
        let covariance = DMat3::from_cols_array(&[x, share, 0.0, share, y, 0.0, 0.0, 0.0, h]);
        let (mut q, mut a) = (Numbers::default(), Numbers::default());
        q.f(at.x).f(at.y).f(z).u(has_z).f(heading);
        covariance.to_cols_array().iter().for_each(|one| {
            q.f(*one);
        });
        let pose = VehiclePose { position: point, heading };
        let options = MatchOptions::default();
        a.f(map.match_pose(&pose, &covariance, &options, &mut scratch.matches)?);
        a.u(scratch.matches.len() as u64);
        for one in &scratch.matches {
            a.u(u64::from(one.forward)).f(one.probability).f(one.mahalanobis);
            a.f(one.heading_difference);
            a.nearest(&Nearest { lane: one.lane, position: one.position });
        }
        self.write("match", &q, &a);

        let (mut q, mut a, mut fixes) = (Numbers::default(), Numbers::default(), Vec::new());
        for i in 0..FIXES {
            let next = lane.pose_at(s + 5.0 * f64::from(i), offset)?;
            let (time, noise) = (0.5 * f64::from(i), self.random.between(-1.0, 1.0));
            let xy = next.position.truncate() + noise;
            let heading = (i % 2 == 0).then_some(next.heading);
            fixes.push(TraceFix { time, position: xy.into(), heading });
            q.f(time).f(xy.x).f(xy.y).option(heading);
        }
        let options = TraceOptions::default();
        map.match_trace(&fixes, &options, &mut scratch.trace, &mut scratch.traced)?;
        for one in &scratch.traced {
            a.u(u64::from(one.forward)).f(one.probability).u(u64::from(one.place.is_some()));
            if let Some(TracePosition { lane, position }) = one.place {
                a.nearest(&Nearest { lane, position });
            }
        }
        self.write("trace", &q, &a);
        Ok(())
    }
}
