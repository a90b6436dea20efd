//! Questions and answers as numbers.

use mapd_client::glam::DVec3;
use mapd_client::{Lane, LaneId, Nearest, ObjectId, Pose, SignalId};

/// Numbers of an answer.
#[derive(Default)]
pub(crate) struct Numbers(pub(crate) Vec<u64>);

impl Numbers {
    pub(crate) fn f(&mut self, value: f64) -> &mut Self {
        self.0.push(value.to_bits());
        self
    }

    pub(crate) fn u(&mut self, value: impl Into<u64>) -> &mut Self {
        self.0.push(value.into());
        self
    }

    pub(crate) fn id(&mut self, bits: u128) -> &mut Self {
        self.u(short(bits))
    }

    pub(crate) fn v(&mut self, at: DVec3) -> &mut Self {
        self.f(at.x).f(at.y).f(at.z)
    }

    pub(crate) fn option(&mut self, value: Option<f64>) -> &mut Self {
        self.u(u64::from(value.is_some())).f(value.unwrap_or(0.0))
    }

    pub(crate) fn pose(&mut self, pose: &Pose) -> &mut Self {
        self.v(pose.position).f(pose.heading).f(pose.curvature).f(pose.slope);
        self.f(pose.superelevation).u(clamped(pose.clamped))
    }

    pub(crate) fn nearest(&mut self, one: &Nearest) -> &mut Self {
        let p = one.position;
        self.id(one.lane.to_bits()).f(p.s).f(p.t).f(p.offset).f(p.offset_of_reference_line);
        self.f(p.distance).f(p.z).f(p.heading).f(p.heading_of_reference_line).u(clamped(p.clamped))
    }

    pub(crate) fn lanes(&mut self, lanes: impl Iterator<Item = LaneId>) -> &mut Self {
        let all: Vec<u64> = lanes.map(|lane| short(lane.to_bits())).collect();
        self.u(all.len() as u64);
        self.0.extend(all);
        self
    }
}

pub(crate) fn clamped(clamped: mapd_client::Clamped) -> u64 {
    match clamped.name() {
        "before" => 1,
        "after" => 2,
        _ => 0,
    }
}

/// An id as one number: the lower half of what it is bound to, then its row.
pub(crate) fn short(bits: u128) -> u64 {
    (bits as u64) << 32 | u64::from((bits >> 64) as u32)
}

/// What names nothing.
pub(crate) const NOTHING: u64 = u32::MAX as u64;

pub(crate) fn signal_bits(id: Option<SignalId>) -> u64 {
    id.map_or(NOTHING, |id| short(id.to_bits()))
}

pub(crate) fn object_bits(id: Option<ObjectId>) -> u64 {
    id.map_or(NOTHING, |id| short(id.to_bits()))
}

pub(crate) fn lane_bits(lane: Option<Lane<'_>>) -> u64 {
    lane_id_bits(lane.map(|lane| lane.lane_id()))
}

pub(crate) fn lane_id_bits(lane: Option<LaneId>) -> u64 {
    lane.map_or(NOTHING, |lane| short(lane.to_bits()))
}

/// FNV-1a of a text.
pub(crate) fn hash(text: &str) -> u64 {
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3))
}
