//! Elevation grids of junctions.

use crate::junction::Junction;
use crate::map::Map;
use glam::{DVec2, DVec3};
use mapd_archive::{ArchivedElevationGridRow, ArchivedGridRowRow, ArchivedGridTransitionRow};
use mapd_geometry::surface::{CellCorner, grid_cell, transition};
use mapd_geometry::{clamp, floor};

/// The rows of one grid.
struct Grid<'a> {
    map: Map<'a>,
    rows: &'a [ArchivedGridRowRow],
}

impl Grid<'_> {
    /// Height at row i and column j, columns counted to the left from the reference line.
    fn point(&self, i: i64, j: i64) -> Option<f64> {
        let row = self.rows.get(usize::try_from(i).ok()?)?;
        let (side, at) = match j {
            0 => return Some(row.center()),
            1.. => (row.left(), j - 1),
            _ => (row.right(), -j - 1),
        };
        side.of(self.map.tables().grid_heights).get(usize::try_from(at).ok()?).copied()
    }

    /// Half the difference of a value's neighbours; of the point itself and the only neighbour, where one lacks.
    fn slope(before: Option<f64>, here: f64, behind: Option<f64>) -> f64 {
        match (before, behind) {
            (Some(before), Some(behind)) => 0.5 * (behind - before),
            (Some(before), None) => here - before,
            (None, Some(behind)) => behind - here,
            (None, None) => 0.0,
        }
    }

    fn across(&self, i: i64, j: i64) -> Option<f64> {
        let here = self.point(i, j)?;
        Some(Self::slope(self.point(i, j - 1), here, self.point(i, j + 1)))
    }

    fn corner(&self, i: i64, j: i64) -> Option<CellCorner> {
        let z = self.point(i, j)?;
        let across = self.across(i, j)?;
        Some(CellCorner {
            z,
            along: Self::slope(self.point(i - 1, j), z, self.point(i + 1, j)),
            across,
            twist: Self::slope(self.across(i - 1, j), across, self.across(i + 1, j)),
        })
    }

    /// Smallest and largest column that both row i and the next one have.
    fn columns(&self, i: i64) -> Option<(i64, i64)> {
        let at = usize::try_from(i).ok()?;
        let (a, b) = (self.rows.get(at)?, self.rows.get(at + 1)?);
        let right = a.right().count.min(b.right().count);
        let left = a.left().count.min(b.left().count);
        Some((-i64::from(right), i64::from(left)))
    }

    /// Height and slopes per cell at a place in units of the spacing. Beyond the grid its edge holds.
    fn height(&self, along: f64, across: f64) -> Option<[f64; 3]> {
        let last = self.rows.len().checked_sub(1)? as f64;
        if last == 0.0 {
            return self.point(0, 0).map(|z| [z, 0.0, 0.0]);
        }
        let inside_along = clamp(along, 0.0, last);
        let i = floor(inside_along.min(last - 1.0));
        let (right, left) = self.columns(i as i64)?;
        if right == left {
            // Heights on the reference line only: level across.
            let corners = [self.corner(i as i64, 0)?, self.corner(i as i64 + 1, 0)?];
            let cell = corners.map(|c| [CellCorner { across: 0.0, twist: 0.0, ..c }; 2]);
            let [z, slope, _] = grid_cell(&cell, inside_along - i, 0.0);
            return Some([z, if inside_along == along { slope } else { 0.0 }, 0.0]);
        }
        let inside_across = clamp(across, right as f64, left as f64);
        let j = floor(inside_across).min((left - 1) as f64);
        let (row, column) = (i as i64, j as i64);
        let cell = [
            [self.corner(row, column)?, self.corner(row, column + 1)?],
            [self.corner(row + 1, column)?, self.corner(row + 1, column + 1)?],
        ];
        let [z, by_along, by_across] = grid_cell(&cell, inside_along - i, inside_across - j);
        Some([
            z,
            if inside_along == along { by_along } else { 0.0 },
            if inside_across == across { by_across } else { 0.0 },
        ])
    }
}

/// Height of a grid at a point (relative to the local origin) and its slopes by x and y; none in a damaged grid.
fn at(map: &Map<'_>, row: &ArchivedElevationGridRow, point: DVec2) -> Option<(f64, DVec2)> {
    let grid = Grid { map: *map, rows: row.rows().of(map.tables().grid_rows) };
    let direction = DVec2::new(row.cos(), row.sin());
    let away = point - DVec2::new(row.x(), row.y());
    let spacing = row.spacing();
    if spacing <= 0.0 {
        return None;
    }
    let along = (away.dot(direction) - row.s_start()) / spacing;
    let across = direction.perp_dot(away) / spacing;
    let [z, by_along, by_across] = grid.height(along, across)?;
    Some((z, (direction * by_along + direction.perp() * by_across) / spacing))
}

/// The grid of a junction.
pub(crate) fn of_junction<'a>(
    map: &Map<'a>,
    junction: u32,
) -> Option<&'a ArchivedElevationGridRow> {
    let rows = map.tables().elevation_grids;
    let at = rows.partition_point(|grid| grid.junction() < junction);
    rows.get(at).filter(|grid| grid.junction() == junction)
}

/// An elevation grid at a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GridHeight {
    /// Height `[m]`.
    pub height: f64,
    /// Metres upwards per metre of x and of y.
    pub slope: DVec2,
}

impl Junction<'_> {
    /// The junction's elevation grid at a point in plan view, its edge held beyond it
    /// (OpenDRIVE 1.8.1, 12.8); none without a grid. What a road of the junction looks like there, joints with their transitions
    /// included, is [`crate::Road::surface_at`].
    pub fn grid_height_at(&self, point: DVec2) -> Option<GridHeight> {
        let row = of_junction(&self.map, self.junction_id().row())?;
        let (height, slope) = at(&self.map, row, point - self.map.origin())?;
        Some(GridHeight { height, slope })
    }

    /// Places along the junction's reference line where rows of its elevation grid lie `[m]`, ascending; none without a grid.
    pub fn grid_stations(&self) -> impl Iterator<Item = f64> + use<> {
        let row = of_junction(&self.map, self.junction_id().row());
        let (start, spacing, count) = row.map_or((0.0, 0.0, 0), |row| {
            (row.s_start(), row.spacing(), row.rows().of(self.map.tables().grid_rows).len())
        });
        (0..count).map(move |i| start + i as f64 * spacing)
    }
}

/// A point of a road's own surface (relative to the local origin) moved to the height of the grid, or between the two
/// within a joint's transition; and the slopes of z by x and y there, from those of the road's own surface. A damaged grid
/// changes nothing.
pub(crate) fn replace(
    map: &Map<'_>,
    row: &ArchivedElevationGridRow,
    position: DVec3,
    own: DVec2,
) -> (DVec3, DVec2) {
    let Some((z, slopes)) = at(map, row, position.truncate()) else { return (position, own) };
    let joints = row.transitions().of(map.tables().grid_transitions);
    // Of several transitions the one that is least done decides.
    let (share, share_slope) = joints
        .iter()
        .filter_map(|joint| share_of(joint, position.truncate()))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((1.0, DVec2::ZERO));
    let weight = share * share * (3.0 - 2.0 * share);
    let weight_slope = share_slope * (6.0 * share * (1.0 - share));
    let slope = own + (slopes - own) * weight + weight_slope * (z - position.z);
    (position.truncate().extend(transition(position.z, z, share)), slope)
}

/// How far a point has come through a joint's transition, in [0, 1], with its slopes by x and y; `None` beside the joint
/// and beyond the transition. What lies before the joint by less than its own width has not begun.
fn share_of(joint: &ArchivedGridTransitionRow, point: DVec2) -> Option<(f64, DVec2)> {
    let start = DVec2::new(joint.start_x(), joint.start_y());
    let end = DVec2::new(joint.end_x(), joint.end_y());
    let width = start.distance(end);
    let along = (end - start).normalize_or_zero();
    let away = point - start;
    let (beside, into) = (away.dot(along), along.perp_dot(away));
    let covers = (0.0..=width).contains(&beside) && (-width..joint.length()).contains(&into);
    if !covers || joint.length() <= 0.0 {
        return None;
    }
    let slope = if into > 0.0 { along.perp() / joint.length() } else { DVec2::ZERO };
    Some(((into / joint.length()).max(0.0), slope))
}
