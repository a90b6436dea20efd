//! What lanes say that nothing is built from: how far one sees, and rules in words.

use crate::lane::Lane;
use mapd_archive::{ArchivedLaneRuleRow, ArchivedLaneVisibilityRow, string};

/// How far one sees from a lane (`lane/visibility` of OpenDRIVE 1.4 and 1.5).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneVisibility {
    /// Start on the road `[m]`; it holds until the next record.
    pub s: f64,
    /// Ahead `[m]`; none if not given.
    pub forward: Option<f64>,
    /// Behind `[m]`.
    pub back: Option<f64>,
    /// To the left `[m]`.
    pub left: Option<f64>,
    /// To the right `[m]`.
    pub right: Option<f64>,
}

/// A rule in words (`lane/rule`).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LaneRule<'a> {
    /// Start on the road `[m]`; it holds until the next record.
    pub s: f64,
    /// As written.
    pub value: &'a str,
}

/// Rows of a lane, of a table in the order of lanes.
fn own<T>(rows: &[T], lane: u32, of: impl Fn(&T) -> u32) -> &[T] {
    let rows = rows.get(rows.partition_point(|row| of(row) < lane)..).unwrap_or(&[]);
    rows.get(..rows.partition_point(|row| of(row) == lane)).unwrap_or(&[])
}

fn visibility(row: &ArchivedLaneVisibilityRow) -> LaneVisibility {
    let given = |distance: f64| Some(distance).filter(|distance| *distance >= 0.0);
    LaneVisibility {
        s: row.s(),
        forward: given(row.forward()),
        back: given(row.back()),
        left: given(row.left()),
        right: given(row.right()),
    }
}

impl<'a> Lane<'a> {
    /// `visibility` records in ascending s.
    pub fn visibilities(&self) -> impl ExactSizeIterator<Item = LaneVisibility> + use<'a> {
        let rows = self.map.tables().lane_visibilities;
        own(rows, self.row_number(), ArchivedLaneVisibilityRow::lane).iter().map(visibility)
    }

    /// How far one sees at s; none where no record holds.
    pub fn visibility_at(&self, s: f64) -> Option<LaneVisibility> {
        self.visibilities().take_while(|record| record.s <= s).last()
    }

    /// `rule` records in ascending s.
    pub fn rules(&self) -> impl ExactSizeIterator<Item = LaneRule<'a>> + use<'a> {
        let tables = self.map.tables();
        let rows = own(tables.lane_rules, self.row_number(), ArchivedLaneRuleRow::lane).iter();
        rows.map(move |row| LaneRule { s: row.s(), value: string(tables, row.value()) })
    }

    /// The rule in words that holds at s; none where no record holds.
    pub fn rule_at(&self, s: f64) -> Option<LaneRule<'a>> {
        self.rules().take_while(|record| record.s <= s).last()
    }
}
