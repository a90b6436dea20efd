//! Semantic checks of OpenDRIVE, one file per rule.
//!
//! A rule reads what the file says and returns findings; it changes nothing. Each rule has an id: ASAM's where ASAM has
//! such a rule, else one that begins with `mapd:`.
//!
//! Invariants: rules see one road at a time, never the whole document; they never panic, whatever the road says.
//!
//! ```
//! # use mapd_xodr::{Item, Limits, Reader, Severity};
//! let map = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="9" junction="-1">
//!   <planView><geometry s="0" x="0" y="0" hdg="0" length="5"><line/></geometry></planView>
//!   <lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road></OpenDRIVE>"#;
//! let mut reader = Reader::new(map.as_bytes(), Limits::default());
//! let mut findings = Vec::new();
//! while let Some(item) = reader.next().unwrap() {
//!     if let Item::Road(road) = item {
//!         mapd_rules::check_road(&road, &mut findings);
//!     }
//! }
//! assert_eq!(findings[0].rule, "asam.net:xodr:1.9.0:road.length_sum_geometries");
//! ```

mod lane_sections_ascend;
mod length_sum_geometries;
mod records_ascend;
mod reference_line_ascends;

use mapd_xodr::{Finding, Road, Severity, Span, Text as _};

/// A check of one road.
type RoadRule = fn(&Road, &mut Vec<Finding>);

/// Every rule on roads, in the order in which they run.
const ROAD_RULES: [RoadRule; 4] = [
    reference_line_ascends::check,
    length_sum_geometries::check,
    lane_sections_ascend::check,
    records_ascend::check,
];

/// Runs every rule on a road.
pub fn check_road(road: &Road, findings: &mut Vec<Finding>) {
    ROAD_RULES.iter().for_each(|rule| rule(road, findings));
}

/// A finding about a part of a road.
fn finding(
    rule: &'static str,
    severity: Severity,
    span: Span,
    road: &Road,
    part: &str,
    message: String,
) -> Finding {
    let path = format!("OpenDRIVE/road[@id={}]/{part}", road.id.text());
    Finding { rule, severity, span, path, subject: "".into(), message, hint: String::new() }
}
