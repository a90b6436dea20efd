//! How many points a document may make of itself.

use crate::findings::finding;
use mapd_archive::Rows;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity, Span};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Points that the lanes of any map may have, however small its file is: 64 MB of table.
const LEAST: usize = 1 << 22;
/// Points beyond these for each geometry, lane and record of a width, height or offset: maps have some ten.
const FOR_A_RECORD: usize = 1 << 10;

/// Points of lanes that a map may still make. Whether they suffice is the same for any order in which they are taken.
pub(crate) struct Allowance {
    most: usize,
    taken: AtomicUsize,
}

impl Allowance {
    /// That of a map whose records are in these tables.
    pub(crate) fn of(rows: &Rows) -> Self {
        let records = rows.geometries.len() + rows.lanes.len() + rows.cubics.len();
        let most = LEAST.saturating_add(records.saturating_mul(FOR_A_RECORD));
        Self { most, taken: AtomicUsize::new(0) }
    }

    /// Takes the points of a line.
    pub(crate) fn take(&self, points: usize) {
        self.taken.fetch_add(points, Ordering::Relaxed);
    }

    /// Whether more was taken than there is: the map is rejected, and sampling it makes no sense any longer.
    pub(crate) fn is_exceeded(&self) -> bool {
        self.taken.load(Ordering::Relaxed) > self.most
    }

    /// What is said of a map that has more points.
    pub(crate) fn finding(&self) -> Finding {
        let message = format!(
            "expected lanes of at most {} points in all, which is what {LEAST} and {FOR_A_RECORD} for each record of the file make, found more",
            self.most
        );
        let hint = "split the map, or compile with larger tolerances";
        let path = "OpenDRIVE".to_owned();
        finding(&building::TOO_LARGE, Severity::Error, Span::default(), path, message, hint)
    }
}
