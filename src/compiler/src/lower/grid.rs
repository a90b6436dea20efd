//! Elevation grids of junctions.

use super::need::Part;
use super::{Lowering, between};
use glam::DVec2;
use mapd_archive::{ContactPoint, ElevationGridRow, GridRowRow, GridTransitionRow, Range, Rows};
use mapd_query::{Map, Road, Track};
use mapd_rules::catalog::building;
use mapd_rules::line::ReferenceLine;
use mapd_xodr::{Finding, Junction, PositionOrEnd, SegmentType, Severity, Text as _, Value as _};

/// A joint of a junction with a grid, until its road is known.
pub(crate) struct Joint {
    pub(super) grid: usize,
    road: String,
    contact: ContactPoint,
    /// Lanes between whose outer edges the joint lies; none: the whole road.
    lanes: [Option<i32>; 2],
    /// Length of the transition `[m]`.
    length: f64,
}

/// A list of numbers, separated by blanks, commas or semicolons.
fn numbers(text: &str) -> Option<Vec<f64>> {
    let parts = text.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
    parts
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().ok().filter(|n: &f64| n.is_finite()))
        .collect()
}

impl Lowering {
    /// Appends the grid of the junction whose row comes next.
    pub(super) fn elevation_grid(
        &mut self,
        (junction, line): (&Junction, &ReferenceLine),
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        let Some(grid) = junction.elevation_grid.as_deref() else { return };
        let mut part = Part { span: grid.span, path: (path, "elevationGrid"), findings };
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
            self.links.joints.push(Joint {
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

/// Fills the grids' transitions, once all roads are there. Joints of roads that the map does not have are left out: the
/// finding about the boundary is the rules'.
pub(crate) fn transitions(rows: &mut Rows, joints: &[Joint]) {
    let placed: Vec<(usize, GridTransitionRow)> = {
        let archive = crate::lanes::view(rows);
        let map = Map::new(&archive, 0);
        let placed = |joint: &Joint| Some((joint.grid, place(map, joint)?));
        joints.iter().filter_map(placed).collect()
    };
    for of_one in placed.chunk_by(|(a, _), (b, _)| a == b) {
        let before = rows.grid_transitions.len();
        rows.grid_transitions.extend(of_one.iter().map(|(_, row)| *row));
        let range = between(before, rows.grid_transitions.len());
        if let Some((grid, _)) = of_one.first() {
            rows.elevation_grids[*grid].transitions = range;
        }
    }
}

/// Where a joint lies, the junction to its left.
fn place(map: Map<'_>, joint: &Joint) -> Option<GridTransitionRow> {
    let road = map.road_by_id(&joint.road)?;
    let at_end = joint.contact == ContactPoint::End;
    let s = if at_end { road.reference_end() } else { 0.0 };
    let [a, b] = edges(&road, s, joint.lanes)?.map(|t| {
        let pose = road.to_inertial(Track { s, t, h: 0.0 }).ok()?;
        Some((pose.position.truncate() - map.local_origin(), pose.heading))
    });
    let ((a, heading), (b, _)) = (a?, b?);
    let out_of_road = DVec2::from_angle(heading) * if at_end { 1.0 } else { -1.0 };
    let (start, end) = if (b - a).perp_dot(out_of_road) > 0.0 { (a, b) } else { (b, a) };
    Some(GridTransitionRow {
        start_x: start.x,
        start_y: start.y,
        end_x: end.x,
        end_y: end.y,
        length: joint.length,
    })
}

/// t of both ends of a joint: the outer edges of its lanes, or of the road's outermost ones.
fn edges(road: &Road<'_>, s: f64, lanes: [Option<i32>; 2]) -> Option<[f64; 2]> {
    let section = road.section_at(s)?;
    let outermost: Vec<i32> = section.lanes().map(|lane| lane.number()).collect();
    let ends = [lanes[0].or(outermost.first().copied())?, lanes[1].or(outermost.last().copied())?];
    let [a, b] = ends.map(|number| section.lane(number).map(|lane| lane.edges_at(s)));
    let (a, b) = (a?, b?);
    // The two edges that lie farthest apart: lanes may be named in either order.
    let all = [a.inner, a.outer, b.inner, b.outer];
    let low = all.iter().fold(f64::INFINITY, |low, t| low.min(*t));
    let high = all.iter().fold(f64::NEG_INFINITY, |high, t| high.max(*t));
    (low < high).then_some([low, high])
}
