//! Rules on lanes within their road.

mod access;
mod center;
mod folds;
mod layers;
mod marks;
mod numbering;
mod offsets;
mod sections;
mod widths;

use crate::rule::Rule;
use mapd_xodr::{LaneAdvisory, LaneType};

pub(super) static RULES: &[&[Rule]] = &[
    sections::RULES,
    numbering::RULES,
    center::RULES,
    widths::RULES,
    folds::RULES,
    offsets::RULES,
    marks::RULES,
    access::RULES,
    layers::RULES,
];

/// Whether vehicles drive on lanes of a type (annex on smoothness of OpenDRIVE 1.9).
pub(crate) fn is_drivable(kind: LaneType) -> bool {
    use LaneType as T;
    matches!(
        kind,
        T::Driving
            | T::Entry
            | T::Exit
            | T::OnRamp
            | T::OffRamp
            | T::ConnectingRamp
            | T::SlipLane
            | T::Border
            | T::Stop
            | T::Restricted
            | T::Bidirectional
            | T::RoadWorks
            | T::Bus
            | T::Taxi
            | T::Hov
            | T::MwyEntry
            | T::MwyExit
    )
}

/// Whether vehicles drive on a lane: by its type, or on a lane for bicycles that is only advised.
pub(crate) fn is_lane_drivable(kind: LaneType, advisory: Option<LaneAdvisory>) -> bool {
    let is_advised = advisory.is_some_and(|advisory| advisory != LaneAdvisory::None);
    is_drivable(kind) || (kind == LaneType::Biking && is_advised)
}
