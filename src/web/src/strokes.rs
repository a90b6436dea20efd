//! Road marks as strokes along a lane's border, each broken as the file says.

use mapd_query::glam::DVec3;
use mapd_query::roads::{LinePoint, RoadMark, RoadMarkExtent};
use mapd_query::vocabulary::{RoadMarkColor, RoadMarkKind};
use mapd_query::{Lane, Track};

/// Length and gap of a broken line for which the file gives none `[m]`.
const BROKEN: [f64; 2] = [3.0, 6.0];
/// Diameter of and gap between Botts' dots `[m]`.
const DOTS: [f64; 2] = [0.1, 1.2];
/// Distance between places of a mark that sways `[m]`.
const SWAY_STEP: f64 = 0.5;
/// Such places of one mark at most: none is so long but in a damaged archive.
const MOST_PLACES: f64 = 65_536.0;
/// Gap between the two lines of a double mark, in widths of one line.
const DOUBLE_GAP: f64 = 1.0;

/// One stroke along a lane's border.
#[derive(Clone, Copy, Debug)]
pub struct MarkStroke {
    /// Its middle from the border `[m]`, positive to the left of the reference line.
    pub t_offset: f64,
    /// Width `[m]`.
    pub width: f64,
    /// Where it is painted along the road.
    pub extent: RoadMarkExtent,
    /// Colour.
    pub color: RoadMarkColor,
}

impl MarkStroke {
    /// The strokes of a mark of a lane: the mark's own lines, or those that its kind stands for.
    pub fn of(mark: &RoadMark<'_>, lane: i32) -> Vec<Self> {
        let (width, color) = (mark.width_or_default(), mark.color());
        if mark.lines().len() > 0 && mark.kind() != RoadMarkKind::None {
            let own = mark.lines().map(|line| Self {
                t_offset: line.t_offset,
                width: line.width.filter(|width| *width > 0.0).unwrap_or(width),
                extent: mark.extent_of(&line),
                color: if line.color == RoadMarkColor::NotGiven { color } else { line.color },
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
            extent: mark.extent(*dashes),
            color,
        };
        lines.iter().enumerate().map(stroke).collect()
    }

    /// The stroke's line from end to end, with points where the lane's border has them: that is within the border's tolerance. Less than two
    /// points where there is nothing to draw.
    pub fn line(&self, lane: &Lane<'_>, mark: &RoadMark<'_>) -> Vec<LinePoint> {
        let [from, to] = self.extent.s;
        if from >= to {
            return Vec::new();
        }
        let mut places: Vec<f64> = lane.border().stations().collect();
        if mark.sways() {
            let count = ((to - from) / SWAY_STEP).min(MOST_PLACES) as usize;
            places.extend((0..count).map(|i| from + i as f64 * SWAY_STEP));
            places.sort_by(f64::total_cmp);
        }
        places.retain(|s| *s > from && *s < to);
        places.insert(0, from);
        places.push(to);
        let place = |s: f64| {
            let t = mark.t_at(s) + self.t_offset;
            let pose = lane.road().to_inertial(Track { s, t, h: 0.0 }).ok()?;
            Some(LinePoint { s, position: pose.position })
        };
        places.into_iter().filter_map(place).collect()
    }

    /// What is painted of a line of the stroke ([`Self::line`]): each dash by itself.
    pub fn painted(&self, line: &[LinePoint]) -> Vec<Vec<DVec3>> {
        let at = |s: f64| {
            let next = line.partition_point(|point| point.s < s);
            let (a, b) = (line.get(next.saturating_sub(1))?, line.get(next)?);
            let share = if b.s > a.s { (s - a.s) / (b.s - a.s) } else { 1.0 };
            Some(a.position.lerp(b.position, share))
        };
        let dash = |[begin, end]: [f64; 2]| {
            let first = line.partition_point(|point| point.s <= begin);
            let within = line.get(first..).unwrap_or(&[]).iter();
            let within = within.take_while(|point| point.s < end).map(|point| point.position);
            at(begin).into_iter().chain(within).chain(at(end)).collect()
        };
        self.extent.painted().map(dash).collect()
    }
}
