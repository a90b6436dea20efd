//! What does not fit the tables.

use crate::findings::finding;
use mapd_archive::{MOST_OF_LANE, NONE, Rows, string};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity, Span};

/// A table outgrew 32-bit row numbers.
#[derive(Debug)]
pub(crate) struct TooLarge {
    table: &'static str,
    /// Row of the road whose rows no longer fit, where rows come road by road.
    road: Option<u32>,
    /// Rows that there may be.
    most: usize,
}

impl TooLarge {
    pub(crate) fn new(table: &'static str) -> Self {
        Self { table, road: None, most: NONE as usize }
    }

    /// The rows of a lane no longer fit.
    pub(crate) fn at_lane(table: &'static str, rows: &Rows, lane: u32) -> Self {
        Self { road: road_of(rows, lane), ..Self::new(table) }
    }

    /// One lane has more rows than lanes may have.
    pub(crate) fn of_lane(table: &'static str, rows: &Rows, lane: u32) -> Self {
        Self { most: MOST_OF_LANE, ..Self::at_lane(table, rows, lane) }
    }
}

impl std::fmt::Display for TooLarge {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let of = if self.most == MOST_OF_LANE { " of one lane" } else { "" };
        write!(
            f,
            "expected at most {} rows{of} in the table `{}`, found more",
            self.most, self.table
        )
    }
}

impl std::error::Error for TooLarge {}

/// Row of the road that a lane lies on.
fn road_of(rows: &Rows, lane: u32) -> Option<u32> {
    let section = rows.sections.get(rows.lanes.get(lane as usize)?.section as usize)?;
    rows.roads.get(section.road as usize).map(|_| section.road)
}

/// A road's id and start tag.
type NamedRoad = (String, Span);

fn named(rows: &Rows, road_spans: &[Span], road: u32) -> Option<NamedRoad> {
    let row = rows.roads.get(road as usize)?;
    let span = road_spans.get(road as usize).copied().unwrap_or_default();
    Some((string(&rows.as_tables(), row.id).to_owned(), span))
}

/// What the document asks for does not fit the tables, which are finished but for their indexes.
pub(crate) fn too_large(error: &TooLarge, rows: &Rows, road_spans: &[Span]) -> Finding {
    at_road(error, error.road.and_then(|road| named(rows, road_spans, road)))
}

/// As [`too_large`], while ids are not in the tables yet: `named` knows the id and start tag of a road by its row.
pub(crate) fn too_large_in(
    error: &TooLarge,
    named: impl FnOnce(u32) -> Option<(String, Span)>,
) -> Finding {
    at_road(error, error.road.and_then(named))
}

/// At the road whose rows no longer fit, so that it can be left out.
fn at_road(error: &TooLarge, road: Option<NamedRoad>) -> Finding {
    let Some((id, span)) = road else { return of_document(error.to_string()) };
    let path = format!("OpenDRIVE/road[@id={id}]");
    let message = format!("{error} for road {id}");
    let hint = "split the road, or compile the map in smaller tiles";
    finding(&building::TOO_LARGE, Severity::Error, span, path, message, hint)
}

/// The rules cannot keep all ids that the document has and names.
pub(crate) fn too_many_ids() -> Finding {
    of_document("expected ids of at most 4 GiB together, found more".to_owned())
}

/// More than so many bytes follow the document, all of which its hash would count.
pub(crate) fn too_much_behind(most: u64) -> Finding {
    of_document(format!("expected at most {most} bytes behind the document, found more"))
}

/// More roads lie over one another than the rules look at.
pub(crate) fn too_many_overlaps() -> Finding {
    let message = "expected roads that lie beside one another, found so many over one another that their overlaps are not all looked for";
    let (span, path) = (Span::default(), "OpenDRIVE".to_owned());
    let hint = "remove copies of roads";
    finding(&building::OVERLAPS, Severity::Warning, span, path, message.to_owned(), hint)
}

fn of_document(message: String) -> Finding {
    let (span, path) = (Span::default(), "OpenDRIVE".to_owned());
    let hint = "compile the map in smaller tiles";
    finding(&building::TOO_LARGE, Severity::Error, span, path, message, hint)
}

/// A lane bends so often that its polyline outgrows what a lane can have, or one of its length; or its section is so large that
/// its points cannot be written within the tolerances.
pub(crate) fn unfit(rows: &Rows, lane: u32, road_spans: &[Span]) -> Finding {
    let road = road_of(rows, lane).and_then(|road| named(rows, road_spans, road));
    let (id, span) = road.unwrap_or_default();
    let number = rows.lanes.get(lane as usize).map_or(0, |lane| lane.number);
    let path = format!("OpenDRIVE/road[@id={id}]");
    let message = format!(
        "expected lanes of at most {MOST_OF_LANE} points, no more than their lengths explain, that can be written within the tolerances, found others for lane {number} of road {id}"
    );
    let hint = "split the road, compile with larger tolerances, or mend its coordinates";
    finding(&building::TOO_LARGE, Severity::Error, span, path, message, hint)
}
