//! Questions about what is laid over a map.

use crate::along::steps;
use crate::numbers::{NOTHING, Numbers, hash, signal_bits};
use crate::{Asker, Random, Result, place};
use mapd_client::Map;
use mapd_client::glam::DMat3;
use mapd_client::localisation::{MatchOptions, VehiclePose};
use mapd_client::path::{Corridor, PathBuffer, PathOptions};
use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::rules::SpeedOrigin;
use mapd_client::signals::SignalsAhead;
use mapd_client::view::Restriction;
use mapd_client::vocabulary::VehicleClass;
use std::fmt::Write as _;
use std::time::{Duration, UNIX_EPOCH};

/// Who drives.
const CAR: VehicleClass = VehicleClass::PassengerCar;
/// The stretch that one entry is about `[m]`.
const STRETCH: f64 = 20.0;
/// How many entries there are of each kind.
const OF_A_KIND: usize = 4;
/// Moments are within so many seconds of the epoch; half of the entries end within.
const SECONDS: f64 = 1e6;

fn restriction(a: &mut Numbers, one: Option<&Restriction<'_>>) {
    match one {
        Some(one) => {
            a.u(one.entry.number()).id(one.lane.to_bits()).f(one.s_from).f(one.s_to);
        }
        None => {
            a.u(NOTHING);
        }
    }
}

/// What a road authority might say about some of the lanes, as JSON.
pub(crate) fn said(map: Map<'_>, random: &mut Random) -> String {
    let lanes: Vec<_> = map.lanes().collect();
    let mut entries = Vec::new();
    for kind in ["closed", "speed", "wet", "open"] {
        for number in 0..OF_A_KIND {
            let (lane, s) = place(&lanes, random);
            let mut entry =
                format!(r#"{{"id":"{kind}-{number}","kind":"{kind}","source":"road works""#);
            if kind == "speed" {
                entry.push_str(r#","value":5.5"#);
            }
            if kind == "open" {
                entry.push_str(r#","vehicles":["passengerCar"]"#);
            }
            if number % 2 == 1 {
                entry.push_str(r#","until":"1970-01-06T00:00:00Z","confidence":0.5"#);
            }
            let section = lane.section();
            let from = s.min(section.s_end() - 1.0).max(section.s_start());
            let to = (from + STRETCH).min(section.s_end());
            let _ = write!(
                entry,
                r#","lanes":[{{"road":"{}","s":[{from},{to}],"lane":{}}}]}}"#,
                lane.road().id(),
                lane.number()
            );
            entries.push(entry);
        }
    }
    if let Some(signal) = map.signals().next() {
        entries.push(format!(
            r#"{{"id":"off","kind":"signal-off","signals":["{}"],"until":"1970-01-06T00:00:00Z"}}"#,
            signal.id()
        ));
    }
    format!(r#"{{"entries":[{}]}}"#, entries.join(","))
}

impl Asker<'_> {
    pub(crate) fn today(&mut self, scratch: &mut RouteScratch) -> Result<()> {
        let under = self.under;
        let at = self.random.between(0.0, SECONDS);
        let ((lane, s), (to, s_to)) = (self.place(), self.place());
        let limit = self.random.between(10.0, 300.0);
        let signals: Vec<_> = self.map.signals().map(|one| one.signal_id()).collect();
        let signal = (!signals.is_empty()).then(|| self.random.one_of(&signals));
        let mut q = Numbers::default();
        q.f(at).id(lane.lane_id().to_bits()).f(s).id(to.lane_id().to_bits()).f(s_to);
        q.f(limit).u(signal_bits(signal));

        let view = under.view(UNIX_EPOCH + Duration::from_secs_f64(at));
        let mut a = Numbers::default();
        a.u(view.entries().count() as u64);
        for entry in view.entries() {
            a.u(hash(entry.id())).u(hash(entry.kind().name())).u(hash(entry.source()));
            a.f(entry.value().unwrap_or(-1.0)).f(entry.confidence());
            a.u(u64::from(entry.concerns(VehicleClass::Pedestrian)));
            a.u(u64::from(view.holds(&entry)));
        }
        a.u(view.restrictions().count() as u64);
        let permission = view.allows(lane.lane_id(), s, CAR)?;
        a.u(u64::from(permission.is_allowed));
        restriction(&mut a, permission.restriction.as_ref());
        let speed = view.speed_rule_at(lane.lane_id(), s, CAR)?;
        a.option(speed.max).option(speed.map.max);
        restriction(&mut a, speed.restriction.as_ref());
        let here: Vec<_> = view.restrictions_at(lane.lane_id(), s)?.collect();
        a.u(here.len() as u64);
        here.iter().for_each(|one| restriction(&mut a, Some(one)));
        let off = signal.map(|signal| view.signal_out_of_service(signal)).transpose()?.flatten();
        a.u(off.map_or(NOTHING, |entry| u64::from(entry.number())));

        let (from, goal) = (
            PositionOnLane { lane: lane.lane_id(), s },
            PositionOnLane { lane: to.lane_id(), s: s_to },
        );
        let (cost, mut own) = (ShortestLength::default(), Vec::new());
        let route = view.route(from, goal, CAR, &cost, scratch, &mut own)?;
        a.u(u64::from(route.is_some())).f(route.map_or(0.0, |route| route.cost));
        steps(&mut a, if route.is_some() { &own } else { &[] });
        let mut along = Vec::new();
        view.restrictions_along(if route.is_some() { &own } else { &[] }, CAR, &mut along)?;
        a.u(along.len() as u64);
        along.iter().for_each(|one| restriction(&mut a, Some(one)));
        let mut buffer = PathBuffer::default();
        let path = view.map().path(&own, &PathOptions::default(), &mut buffer);
        let path = path.ok().filter(|_| route.is_some());
        a.u(u64::from(path.is_some()));
        if let Some(path) = path {
            let (mut met, mut room) = (Vec::new(), Corridor::default());
            view.restrictions_on_path(&path, CAR, &mut met)?;
            a.u(met.len() as u64);
            for one in &met {
                a.f(one.along[0]).f(one.along[1]);
                restriction(&mut a, Some(&one.restriction));
            }
            let middle = view.speed_on_path(&path, 0.5 * path.length(), CAR)?;
            a.option(middle.max);
            restriction(&mut a, middle.restriction.as_ref());
            let step = path.length() / 4.0;
            view.corridor(&path, 0.0, path.length(), step, CAR, &mut room)?;
            a.u(room.len() as u64);
            for i in 0..room.len() {
                a.v(room.outer_left[i]).v(room.outer_right[i]);
                a.u(u64::from(room.left_mark[i].may_cross));
                a.option(room.speed[i].max);
                a.u(u64::from(room.speed[i].origin == SpeedOrigin::Overlay));
            }
            let (mut speeds, mut segments) = (Vec::new(), Vec::new());
            view.speeds_on_path(&path, CAR, &mut speeds)?;
            a.u(speeds.len() as u64);
            for one in &speeds {
                a.f(one.along[0]).f(one.along[1]).option(one.today.max);
                restriction(&mut a, one.today.restriction.as_ref());
            }
            let time = view.travel_time_on_path(&path, [0.0, path.length()], CAR)?;
            a.f(time.time).f(time.unlimited);
            view.segments_on_path(&path, CAR, &mut segments)?;
            a.u(segments.len() as u64);
            for one in &segments {
                a.f(one.along[0]).f(one.along[1]).id(one.lane.to_bits()).u(one.changes);
                a.f(one.last_change);
            }
        }
        let mut reached = Vec::new();
        view.reachable(from, limit, CAR, &cost, scratch, &mut reached)?;
        a.u(reached.len() as u64);
        for one in &reached {
            a.id(one.lane.to_bits()).u(u64::from(one.forward));
            // C has the smaller end first.
            a.f(one.s_from.min(one.s_to)).f(one.s_from.max(one.s_to)).f(one.cost);
        }
        let mut ahead = SignalsAhead::default();
        view.signals_ahead(from, limit, CAR, &mut ahead)?;
        a.u(ahead.iter().len() as u64);
        for one in ahead.iter() {
            a.id(one.signal.to_bits()).id(one.lane.to_bits()).f(one.distance).f(one.s);
        }
        let on = lane.pose_at(s, 0.0)?;
        let pose = VehiclePose { position: on.position.truncate().into(), heading: on.heading };
        let covariance = DMat3::from_diagonal([0.5, 0.5, 0.01].into());
        let options = MatchOptions { vehicle: Some(CAR), ..MatchOptions::default() };
        let mut matches = Vec::new();
        a.f(view.match_pose(&pose, &covariance, &options, &mut matches)?);
        a.u(matches.len() as u64);
        for one in &matches {
            a.id(one.lane.to_bits()).u(u64::from(one.forward)).f(one.probability);
        }
        let at = on.position;
        self.write("today", q.f(at.x).f(at.y).f(on.heading), &a);
        Ok(())
    }
}
