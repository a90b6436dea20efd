//! Road marks as strokes along a lane's border, each broken as the file says.

use mapd_query::glam::DVec3;
use mapd_query::roads::RoadMark;
use mapd_query::vocabulary::{RoadMarkColor, RoadMarkKind};
use mapd_query::{Lane, Track};

/// Length and gap of a broken line for which the file gives none `[m]`.
const BROKEN: [f64; 2] = [3.0, 6.0];
/// Diameter of and gap between Botts' dots `[m]`.
const DOTS: [f64; 2] = [0.1, 1.2];
/// Distance between places of a mark that sways `[m]`.
const SWAY_STEP: f64 = 0.5;
/// Gap between the two lines of a double mark, in widths of one line.
const DOUBLE_GAP: f64 = 1.0;

/// One stroke along a lane's border.
#[derive(Clone, Copy, Debug)]
pub struct MarkStroke {
    /// Its middle from the border `[m]`, positive to the left of the reference line.
    pub t_offset: f64,
    /// Width `[m]`.
    pub width: f64,
    /// Line and gap `[m]`; drawn through if there is none.
    pub dashes: Option<[f64; 2]>,
    /// Where it begins and ends on the road `[m]`.
    pub s: [f64; 2],
    /// Colour.
    pub color: RoadMarkColor,
}

impl MarkStroke {
    /// The strokes of a mark of a lane: the mark's own lines, or those that its kind stands for.
    pub fn of(mark: &RoadMark<'_>, lane: i32) -> Vec<Self> {
        let (width, color) = (mark.width_or_default(), mark.color());
        let whole = [mark.s(), mark.s_end()];
        if mark.lines().len() > 0 && mark.kind() != RoadMarkKind::None {
            let own = mark.lines().map(|line| {
                let start = whole[0] + line.s_offset;
                let explicit_end = (start + line.length).min(whole[1]);
                let end = if line.space.is_none() { explicit_end } else { whole[1] };
                Self {
                    t_offset: line.t_offset,
                    width: line.width.filter(|width| *width > 0.0).unwrap_or(width),
                    dashes: line
                        .space
                        .filter(|space| *space > 0.0)
                        .map(|space| [line.length, space]),
                    s: [start, end],
                    color: if line.color == RoadMarkColor::NotGiven { color } else { line.color },
                }
            });
            return own.collect();
        }
        use RoadMarkKind as Kind;
        let (solid, broken) = (None, Some(BROKEN));
        // From lane 0 outwards.
        let lines: &[Option<[f64; 2]>] = match mark.kind() {
            Kind::None => &[],
            Kind::Broken => &[broken],
            Kind::SolidSolid => &[solid, solid],
            Kind::SolidBroken => &[solid, broken],
            Kind::BrokenSolid => &[broken, solid],
            Kind::BrokenBroken => &[broken, broken],
            Kind::BottsDots => &[Some(DOTS)],
            _ => &[solid],
        };
        let outwards = if lane < 0 { -1.0 } else { 1.0 };
        let middle = 0.5 * (lines.len() as f64 - 1.0);
        let place = |i: usize| outwards * (i as f64 - middle) * width * (1.0 + DOUBLE_GAP);
        let stroke = |(i, dashes): (usize, &Option<[f64; 2]>)| Self {
            t_offset: place(i),
            width,
            dashes: *dashes,
            s: whole,
            color,
        };
        lines.iter().enumerate().map(stroke).collect()
    }

    /// The stroke's line, with points where the lane's border has them: that is within the border's tolerance. Less than two
    /// points where there is nothing to draw.
    pub fn line(&self, lane: &Lane<'_>, mark: &RoadMark<'_>) -> Vec<DVec3> {
        let [from, to] = self.s;
        if from >= to {
            return Vec::new();
        }
        let mut places: Vec<f64> = lane.border().stations().collect();
        if mark.sways() {
            places.extend(
                (0..((to - from) / SWAY_STEP) as usize).map(|i| from + i as f64 * SWAY_STEP),
            );
            places.sort_by(f64::total_cmp);
        }
        places.retain(|s| *s > from && *s < to);
        places.insert(0, from);
        places.push(to);
        let place = |s: f64| {
            let t = mark.t_at(s) + self.t_offset;
            lane.road().to_inertial(Track { s, t, h: 0.0 }).ok()
        };
        places.into_iter().filter_map(place).map(|pose| pose.position).collect()
    }
}
