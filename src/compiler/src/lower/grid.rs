//! Elevation grids of junctions.

use super::need::{ElementContext, ElementPath};
use crate::draft::{Draft, Joint, between};
use mapd_archive::{ContactPoint, ElevationGridRow, GridRowRow, Range};
use mapd_rules::catalog::building;
use mapd_rules::line::ReferenceLine;
use mapd_xodr::{Finding, Junction, PositionOrEnd, SegmentType, Severity, Text as _, Value as _};

/// A list of numbers, separated by blanks, commas or semicolons.
fn numbers(text: &str) -> Option<Vec<f64>> {
    let parts = text.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
    parts
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().ok().filter(|n: &f64| n.is_finite()))
        .collect()
}

impl Draft {
    /// Appends the grid of the junction whose row comes next.
    pub(super) fn elevation_grid(
        &mut self,
        junction: &Junction,
        line: &ReferenceLine,
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        let Some(grid) = junction.elevation_grid.as_deref() else { return };
        let mut part = ElementContext {
            span: grid.span,
            path: ElementPath::new(path, "elevationGrid"),
            findings,
        };
        let mut refuse = |message: &str| {
            let message = format!("{message}; the junction's roads keep their own heights");
            part.add(&building::ELEVATION_GRID, Severity::Warning, message);
        };
        let geometries = junction.plan_view.as_deref().map_or(&[][..], |plan| &plan.geometry);
        let is_straight = geometries.len() == 1 && geometries.iter().all(|g| g.line.is_some());
        let Some(piece) = line.piece(0).filter(|_| is_straight) else {
            return refuse("expected one straight reference line of the junction");
        };
        let (x, y, heading) = (piece.start.x, piece.start.y, piece.start.heading);
        let number = |text: &str| numbers(text).filter(|n| n.len() == 1).map(|n| n[0]);
        let place = (number(grid.s_start.text()), number(grid.grid_spacing.text()));
        let (Some(s_start), Some(spacing)) = place else {
            return refuse("expected a number each in @sStart and @gridSpacing");
        };
        if spacing <= 0.0 {
            return refuse("expected a positive @gridSpacing");
        }
        let rows: Option<Vec<_>> = grid
            .elevation
            .iter()
            .map(|row| {
                let sides = [numbers(row.left.text())?, numbers(row.right.text())?];
                Some((number(row.center.text())?, sides))
            })
            .collect();
        let Some(rows) = rows.filter(|rows| !rows.is_empty()) else {
            return refuse(
                "expected rows with a number in @center and numbers in @left and @right",
            );
        };
        let before = self.rows.grid_rows.len();
        for (center, sides) in rows {
            let [left, right] = sides.map(|heights| {
                let first = self.rows.grid_heights.len();
                self.rows.grid_heights.extend_from_slice(&heights);
                between(first, self.rows.grid_heights.len())
            });
            self.rows.grid_rows.push(GridRowRow { center, left, right });
        }
        let (cos, sin) = mapd_geometry::cos_sin(heading);
        let number = self.rows.elevation_grids.len();
        self.rows.elevation_grids.push(ElevationGridRow {
            x,
            y,
            cos,
            sin,
            s_start,
            spacing,
            junction: self.rows.junctions.len() as u32,
            rows: between(before, self.rows.grid_rows.len()),
            transitions: Range::default(),
            reserved: 0,
        });
        self.joints(junction, number);
    }

    fn joints(&mut self, junction: &Junction, grid: usize) {
        let segments = junction.boundary.iter().flat_map(|boundary| &boundary.segment);
        for segment in segments.filter(|s| s.r#type.value() == Some(SegmentType::Joint)) {
            let length = segment.transition_length.value().unwrap_or(0.0);
            if length <= 0.0 {
                continue;
            }
            self.joints.push(Joint {
                grid,
                road: segment.road_id.text().to_owned(),
                contact: match segment.contact_point.value() {
                    Some(PositionOrEnd::End) => ContactPoint::End,
                    _ => ContactPoint::Start,
                },
                lanes: [segment.joint_lane_start.value(), segment.joint_lane_end.value()],
                length,
            });
        }
    }
}
