//! Signals: what they are, where they stand, for which lanes they are.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::{mapd_lane_id, mapd_road_id, mapd_signal_id};
use crate::list::{List, finite, get_mut, put};
use crate::lookup::lane_of;
use crate::point::{mapd_region, mapd_vec2, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::mapd_text;
use mapd_client::rules::{SpeedOrigin, SpeedRule, SpeedStretch};
use mapd_client::signals::{LaneSignal, LightStates, Signal};

/// A traffic sign, light or marking.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_signal_facts {
    /// The signal itself.
    pub signal: mapd_signal_id,
    /// The road that it is written in.
    pub road: mapd_road_id,
    /// Of a sign on a board: the signal that carries the board.
    pub carrier: mapd_signal_id,
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// Code as written: country.
    pub country: mapd_text,
    /// Code as written: its revision.
    pub country_revision: mapd_text,
    /// Code as written: type.
    pub kind: mapd_text,
    /// Code as written: subtype.
    pub subtype: mapd_text,
    /// Text shown.
    pub text: mapd_text,
    /// Unit as written; counts only with `has_written_value`.
    pub unit: mapd_text,
    /// Value as written; counts only with `has_written_value`.
    pub written_value: f64,
    /// What the class means by its value: \[m/s\], \[m\] or \[kg\]; counts only with `has_value`.
    pub value: f64,
    /// Where it stands, inertial \[m\].
    pub position: mapd_vec3,
    /// Direction of the face's normal in plan view \[rad\], in (−π, π].
    pub facing: f64,
    /// Pitch of what stands there \[rad\].
    pub pitch: f64,
    /// Roll of what stands there \[rad\].
    pub roll: f64,
    /// As written \[m\].
    pub s: f64,
    /// As written \[m\].
    pub t: f64,
    /// Width \[m\]; negative where not given.
    pub width: f64,
    /// Height \[m\]; negative where not given.
    pub height: f64,
    /// Length \[m\]; negative where not given.
    pub length: f64,
    /// What it means: a `MAPD_CLASS_…`.
    pub class_code: u16,
    /// Direction of travel that it is for, on its own road: a `MAPD_ORIENTATION_…`.
    pub orientation: u8,
    /// Where the place in space comes from: a `MAPD_SIGNAL_POSITION_…`.
    pub position_source: u8,
    /// 1: `written_value` and `unit` are there.
    pub has_written_value: u8,
    /// 1: `value` is there.
    pub has_value: u8,
    /// 1: its state changes.
    pub is_dynamic: u8,
    /// 1: it stands for a limited time.
    pub is_temporary: u8,
    /// 1: it no longer holds.
    pub is_invalidated: u8,
    /// Of a light its lamps: 1 red, 2 yellow, 4 green; 0 for what is no light.
    pub bulbs: u8,
    /// Of a light its phases: 1 red, 2 red and yellow, 4 yellow, 8 green, 16, 32, 64 flashing red, yellow, green, 128 off.
    pub phases: u8,
    /// Of a light the movements that it is for, 0 all: 1 left, 2 straight on, 4 right, 8 back.
    pub arrows: u8,
}

/// A signal that is for a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_lane_signal {
    /// The signal.
    pub signal: mapd_signal_id,
    /// The lane.
    pub lane: mapd_lane_id,
    /// Where it counts on the lane's road, within the lane's section \[m\].
    pub s: f64,
    /// Where it counts, lateral on its road \[m\].
    pub t: f64,
    /// Distance of that place from the lane's area in plan view \[m\].
    pub distance: f64,
    /// What it means: a `MAPD_CLASS_…`.
    pub class_code: u16,
    /// How signal and lane belong together: a `MAPD_LANE_METHOD_…`.
    pub method: u8,
    /// 1: it is for traffic that travels towards +s.
    pub is_for_forward: u8,
    /// 1: it is for traffic that travels towards −s.
    pub is_for_backward: u8,
}

/// A signal near a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_near_signal {
    /// The signal.
    pub signal: mapd_signal_id,
    /// Plan-view distance of the point from where it stands \[m\].
    pub distance: f64,
}

/// `origin` of a speed rule: a sign.
pub const MAPD_SPEED_ORIGIN_SIGNAL: u8 = 0;
/// `origin` of a speed rule: the lane's own record.
pub const MAPD_SPEED_ORIGIN_LANE: u8 = 1;
/// `origin` of a speed rule: the road's type.
pub const MAPD_SPEED_ORIGIN_ROAD_TYPE: u8 = 2;
/// `origin` of a speed rule: the header's regulations for the road's type.
pub const MAPD_SPEED_ORIGIN_DEFAULT: u8 = 3;
/// `origin` of a speed rule: nothing in the map.
pub const MAPD_SPEED_ORIGIN_NONE: u8 = 4;
/// `origin` of a speed rule: what holds where the junction is entered.
pub const MAPD_SPEED_ORIGIN_ENTRY: u8 = 5;
/// `origin` of a speed rule: what holds where the junction is entered, which is not the same on all lanes that lead to the place.
pub const MAPD_SPEED_ORIGIN_DEPENDS: u8 = 6;

/// `origin` of a speed rule: an entry of today's overlay, in what a view says.
pub const MAPD_SPEED_ORIGIN_OVERLAY: u8 = 7;

/// The speed limit at a place.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_speed_rule {
    /// Limit \[m/s\], infinite where there is none; counts only with `has_max`.
    pub max: f64,
    /// The sign, if one says so.
    pub signal: mapd_signal_id,
    /// 1: the map says something.
    pub has_max: u8,
    /// Who says so: a `MAPD_SPEED_ORIGIN_…`.
    pub origin: u8,
}

/// A stretch of a lane on which one speed limit holds.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_speed_stretch {
    /// Its smaller s on the road \[m\].
    pub s_low: f64,
    /// Its larger s \[m\].
    pub s_high: f64,
    /// What holds there.
    pub rule: mapd_speed_rule,
    /// The limit, or where it depends on the way the lowest that may hold \[m/s\], infinite where there is none; counts only with `has_lowest`.
    pub lowest: f64,
    /// 1: something is known.
    pub has_lowest: u8,
}

/// `which` of `mapd_lane_signals`: all that are for the lane.
pub const MAPD_LANE_SIGNALS_ALL: u32 = 0;
/// `which` of `mapd_lane_signals`: lights.
pub const MAPD_LANE_SIGNALS_LIGHTS: u32 = 1;
/// `which` of `mapd_lane_signals`: lines at which the lane's traffic stops or gives way.
pub const MAPD_LANE_SIGNALS_STOP_LINES: u32 = 2;
/// `which` of `mapd_lane_signals`: crosswalks that are written as signals.
pub const MAPD_LANE_SIGNALS_CROSSWALKS: u32 = 3;

fn facts(signal: &Signal<'_>) -> mapd_signal_facts {
    let [country, country_revision, kind, subtype] = signal.code();
    let written = signal.written_value();
    let [s, t, ..] = signal.track();
    let [width, height, length] = signal.size().map(|size| size.unwrap_or(-1.0));
    let light = signal.light().unwrap_or(LightStates { bulbs: 0, phases: 0, arrows: 0 });
    mapd_signal_facts {
        signal: signal.signal_id().into(),
        road: signal.road().map(|road| road.road_id()).into(),
        carrier: signal.carrier().map(|signal| signal.signal_id()).into(),
        id: signal.id().into(),
        name: signal.name().into(),
        country: country.into(),
        country_revision: country_revision.into(),
        kind: kind.into(),
        subtype: subtype.into(),
        text: signal.shown_text().into(),
        unit: written.map_or("", |written| written.unit).into(),
        written_value: written.map_or(0.0, |written| written.value),
        value: signal.value().unwrap_or(0.0),
        position: signal.position().into(),
        facing: signal.facing(),
        pitch: signal.pitch(),
        roll: signal.roll(),
        s,
        t,
        width,
        height,
        length,
        class_code: signal.class().code(),
        orientation: signal.orientation().code(),
        position_source: signal.position_source().code(),
        has_written_value: written.is_some().into(),
        has_value: signal.value().is_some().into(),
        is_dynamic: signal.is_dynamic().into(),
        is_temporary: signal.is_temporary().into(),
        is_invalidated: signal.is_invalidated().into(),
        bulbs: light.bulbs,
        phases: light.phases,
        arrows: light.arrows,
    }
}

/// A signal of a lane; of a damaged archive one without lane.
pub(crate) fn lane_signal(one: &LaneSignal<'_>) -> mapd_lane_signal {
    let lane = one.lane();
    mapd_lane_signal {
        signal: one.signal().signal_id().into(),
        lane: lane.map(|lane| lane.lane_id()).into(),
        s: lane.map_or(0.0, |lane| one.s_on(&lane)),
        t: one.place().t(),
        distance: one.distance(),
        class_code: one.signal().class().code(),
        method: one.method().code(),
        is_for_forward: one.is_for(true).into(),
        is_for_backward: one.is_for(false).into(),
    }
}

pub(crate) fn speed_rule(rule: SpeedRule) -> mapd_speed_rule {
    mapd_speed_rule {
        max: rule.max.unwrap_or(0.0),
        signal: rule.signal.into(),
        has_max: rule.max.is_some().into(),
        origin: match rule.origin {
            SpeedOrigin::Signal => MAPD_SPEED_ORIGIN_SIGNAL,
            SpeedOrigin::Lane => MAPD_SPEED_ORIGIN_LANE,
            SpeedOrigin::RoadType => MAPD_SPEED_ORIGIN_ROAD_TYPE,
            SpeedOrigin::Default => MAPD_SPEED_ORIGIN_DEFAULT,
            SpeedOrigin::None => MAPD_SPEED_ORIGIN_NONE,
            SpeedOrigin::Entry => MAPD_SPEED_ORIGIN_ENTRY,
            SpeedOrigin::Depends => MAPD_SPEED_ORIGIN_DEPENDS,
            SpeedOrigin::Overlay => MAPD_SPEED_ORIGIN_OVERLAY,
            // One that has no name in C yet.
            _ => MAPD_SPEED_ORIGIN_NONE,
        },
    }
}

/// What a signal is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signal_facts_of(
    snapshot: *const mapd_snapshot,
    signal: mapd_signal_id,
    out: *mut mapd_signal_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, facts(&map_of(snapshot)?.signal(signal.into())?))) }
}

/// Signals that are for a lane, ascending in s; `which` is a `MAPD_LANE_SIGNALS_…`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_signals(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    which: u32,
    out: *mut mapd_lane_signal,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            let list = List { out, capacity, count };
            match which {
                MAPD_LANE_SIGNALS_ALL => list.write(lane.signals().map(|one| lane_signal(&one))),
                MAPD_LANE_SIGNALS_LIGHTS => {
                    list.write(lane.traffic_lights().map(|one| lane_signal(&one)))
                }
                MAPD_LANE_SIGNALS_STOP_LINES => {
                    list.write(lane.stop_lines().map(|one| lane_signal(&one)))
                }
                MAPD_LANE_SIGNALS_CROSSWALKS => {
                    list.write(lane.crosswalks().map(|one| lane_signal(&one)))
                }
                _ => Err(Failure::argument(format!("{which} names no signals of a lane"))),
            }
        })
    }
}

/// The speed limit at s: sign before lane before road type before the header's regulations.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_speed_rule_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_speed_rule,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || put(out, speed_rule(lane_of(snapshot, lane)?.speed_rule_at(finite(s)?))))
    }
}

/// The speed limits along the lane, in ascending s without gaps, each as `mapd_lane_speed_rule_at` has it between the ends of its stretch; where the limit depends on the way, with
/// the lowest that may hold.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_speed_rules(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_speed_stretch,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    let stretch = |own: SpeedStretch| mapd_speed_stretch {
        s_low: own.s.low,
        s_high: own.s.high,
        rule: speed_rule(own.rule),
        lowest: own.lowest.unwrap_or(0.0),
        has_lowest: own.lowest.is_some().into(),
    };
    unsafe {
        answer(error, || {
            let all = lane_of(snapshot, lane)?.speed_rules().map(stretch);
            List { out, capacity, count }.write(all)
        })
    }
}

/// Every signal that stands as near to a point as `radius` \[m\] in plan view, nearest first, whatever lanes it is for.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signals_near(
    snapshot: *const mapd_snapshot,
    point: mapd_vec2,
    radius: f64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_near_signal,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let near = &mut get_mut(scratch, "a scratch")?.near_signals;
            map_of(snapshot)?.signals_near(point.into(), radius, near)?;
            let all = near
                .iter()
                .map(|one| mapd_near_signal { signal: one.signal.into(), distance: one.distance });
            List { out, capacity, count }.write(all)
        })
    }
}

/// Every signal that stands in a rectangle in plan view, in the order of their rows.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signals_in(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    scratch: *mut mapd_scratch,
    out: *mut mapd_signal_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let signals = &mut get_mut(scratch, "a scratch")?.signals;
            map_of(snapshot)?.signals_in(region.into(), signals)?;
            List { out, capacity, count }.write(signals.iter().map(|one| (*one).into()))
        })
    }
}
