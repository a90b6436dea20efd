//! How a drawing looks: one class per lane type that stands out, and one per kind of line.

use mapd_client::vocabulary::LaneType;

/// Style sheet. Widths are metres on the ground. What an overlay says has the colours of the page's light theme.
pub(super) const SHEET: &str = "\
.ground{fill:#eef0e8}\
.lane{stroke:none;fill:#c9c9c4}\
.drive{fill:#8d9299}.slow{fill:#a9a3b5}.bike{fill:#b9745f}.walk{fill:#d9cfb8}.edge{fill:#b9bdb0}\
.park{fill:#8fa5c4}.rail{fill:#7a6a58}.green{fill:#a9c48f}.works{fill:#d8a24a}\
.bound{fill:none;stroke:#5d6168;stroke-width:.04;stroke-linejoin:round}\
.reference{fill:none;stroke:#d9822b;stroke-width:.05;stroke-linejoin:round}\
.mark{fill:none;stroke-linejoin:round}.white{stroke:#fff}.yellow{stroke:#f2c230}.blue{stroke:#2f6fd0}\
.grass{stroke:#3f9a4a}.red{stroke:#cf3a34}.black{stroke:#222}.orange{stroke:#ee8a2a}.violet{stroke:#8a4fc0}\
.object{fill:#6b4fa0;fill-opacity:.45;stroke:#4b2f80;stroke-width:.08;stroke-linejoin:round}.line{fill:none}\
.way{fill:#fff;fill-opacity:.8}\
.signal{fill:none;stroke:#c0272d;stroke-width:.35;stroke-linecap:round}\
.overlay{stroke:none;fill-opacity:.85}.closed{fill:#dd3536}.opened{fill:#547e3f}.slower{fill:#e36f06}.told{fill:#f1d43f}\
.route{fill:none;stroke:#d6246e;stroke-width:.5;stroke-opacity:.85;stroke-linejoin:round}\
.node{fill:none;stroke:#2b6cd9;stroke-width:.25;stroke-opacity:.6}\
.leaf{fill:#2bd98a;fill-opacity:.08;stroke:#0a8f52;stroke-width:.04}";

/// Class of a lane, from how it is used.
pub(super) fn class(kind: LaneType) -> &'static str {
    match kind {
        LaneType::Driving
        | LaneType::Bidirectional
        | LaneType::Stop
        | LaneType::Entry
        | LaneType::Exit
        | LaneType::OnRamp
        | LaneType::OffRamp
        | LaneType::ConnectingRamp
        | LaneType::SlipLane
        | LaneType::MwyEntry
        | LaneType::MwyExit => "lane drive",
        LaneType::Bus | LaneType::Taxi | LaneType::Hov => "lane slow",
        LaneType::Biking => "lane bike",
        LaneType::Sidewalk | LaneType::Walking => "lane walk",
        LaneType::Shoulder | LaneType::Border | LaneType::Curb => "lane edge",
        LaneType::Parking => "lane park",
        LaneType::Rail | LaneType::Tram => "lane rail",
        LaneType::Median | LaneType::Restricted => "lane green",
        LaneType::RoadWorks => "lane works",
        _ => "lane",
    }
}
