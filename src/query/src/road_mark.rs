//! Road marks along the lanes' borders.

use crate::error::QueryError;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::marks::MarkKinds;
use crate::nearest::LaneTypes;
use crate::profile::{self, At};
use crate::region::{BoundarySegment, Region};
use mapd_archive::{
    ArchivedRoadMarkLineRow, ArchivedRoadMarkRow, ArchivedRoadMarkStyleRow, MarkLaneChange,
    RoadMarkColor, RoadMarkKind, RoadMarkRule, RoadMarkWeight, string,
};
use mapd_geometry::clamp;

/// Width of a mark for which the file gives none `[m]`: the standard says only that `bold` is wider than `standard`; these are
/// usual on town roads.
const DEFAULT_WIDTH: f64 = 0.12;
/// As [`DEFAULT_WIDTH`], for bold marks `[m]`.
const DEFAULT_BOLD_WIDTH: f64 = 0.25;

/// A `roadMark` record of a lane: what lies on the lane's outer border (for lane 0 on its own line) from `s` to `s_end`
/// (OpenDRIVE 1.8.1, 11.10).
#[derive(Clone, Copy)]
pub struct RoadMark<'a> {
    map: Map<'a>,
    lane: Lane<'a>,
    style: &'a ArchivedRoadMarkStyleRow,
    s: f64,
    s_end: f64,
    /// Where it begins as written, which is before `s` where the lane goes on from another section.
    written_s: f64,
}

/// A line of a road mark's pattern, or an explicit one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoadMarkLine {
    /// Length of the line `[m]`.
    pub length: f64,
    /// Gap to the next one `[m]`; `None` for an explicit line, which is there once.
    pub space: Option<f64>,
    /// Of the line's middle from the lane's border `[m]`, positive to the left of the reference line.
    pub t_offset: f64,
    /// Start of the (first) line after the mark's start `[m]`.
    pub s_offset: f64,
    /// Width `[m]`, if given.
    pub width: Option<f64>,
    /// Who may cross it, seen from inside.
    pub rule: RoadMarkRule,
    /// Colour of its own, if given.
    pub color: RoadMarkColor,
}

/// Where one line of a road mark is painted along its road.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoadMarkExtent {
    /// Where it begins and ends on the road `[m]`; nothing is painted if it ends before it begins.
    pub s: [f64; 2],
    /// s at which a dash begins: the pattern counts from there, also where the mark goes on from another section `[m]`.
    pub pattern_s: f64,
    /// Lengths of a dash and of the gap behind it `[m]`; none of a line without gaps.
    pub dashes: Option<[f64; 2]>,
}

/// Dashes of one line at most; one with more, which nobody paints, counts as one without gaps.
const MOST_DASHES: f64 = 16_384.0;

impl RoadMarkExtent {
    /// Whether s is painted, between both ends.
    pub(crate) fn is_in_dash(&self, s: f64) -> bool {
        self.dashes.is_none_or(|[dash, gap]| (s - self.pattern_s).rem_euclid(dash + gap) <= dash)
    }

    /// What is painted, in ascending s: both ends of each dash, or of the whole line.
    pub fn painted(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let ([from, to], pattern_s) = (self.s, self.pattern_s);
        let period = self.dashes.map_or(f64::INFINITY, |[dash, gap]| dash + gap);
        let first = ((from - pattern_s) / period).floor();
        let count = ((to - pattern_s) / period).ceil() - first;
        let dashes = self.dashes.filter(|_| count <= MOST_DASHES && first.is_finite());
        // Casts saturate.
        let count = if dashes.is_some() { count as u32 } else { 1 };
        let dash = move |number: u32| {
            let Some([dash, _]) = dashes else { return [from, to] };
            let begin = pattern_s + (first + f64::from(number)) * period;
            [begin.max(from), (begin + dash).min(to)]
        };
        (0..count).map(dash).filter(|[begin, end]| begin < end)
    }
}

/// A straight piece of a road mark's course.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoadMarkSegment {
    /// The piece of the lane's border.
    pub segment: BoundarySegment,
    /// Kind of the mark.
    pub kind: RoadMarkKind,
    /// Its colour.
    pub color: RoadMarkColor,
    /// Its width `[m]`: as [`RoadMark::width_or_default`].
    pub width: f64,
}

fn given(value: f64) -> Option<f64> {
    (value >= 0.0).then_some(value)
}

impl<'a> RoadMark<'a> {
    /// Where the mark begins: s on the road `[m]`, not before the lane's section.
    pub fn s(&self) -> f64 {
        self.s
    }

    /// Where the lane's next mark or the section's end takes over `[m]`.
    pub fn s_end(&self) -> f64 {
        self.s_end
    }

    /// Kind.
    pub fn kind(&self) -> RoadMarkKind {
        RoadMarkKind::from_code(self.style.kind())
    }

    /// Colour.
    pub fn color(&self) -> RoadMarkColor {
        RoadMarkColor::from_code(self.style.color())
    }

    /// Visual weight.
    pub fn weight(&self) -> RoadMarkWeight {
        RoadMarkWeight::from_code(self.style.weight())
    }

    /// Which lane changes the mark says it allows.
    pub fn lane_change(&self) -> MarkLaneChange {
        MarkLaneChange::from_code(self.style.lane_change())
    }

    /// Width `[m]`, if given; of marks of two lines, that of each.
    pub fn width(&self) -> Option<f64> {
        given(self.style.width())
    }

    /// Width `[m]`; where the file gives none, or 0, 0.12 m, for bold marks 0.25 m. 0 for the kind `none`.
    pub fn width_or_default(&self) -> f64 {
        if self.kind() == RoadMarkKind::None {
            return 0.0;
        }
        let bold = self.weight() == RoadMarkWeight::Bold;
        let default = if bold { DEFAULT_BOLD_WIDTH } else { DEFAULT_WIDTH };
        self.width().filter(|width| *width > 0.0).unwrap_or(default)
    }

    /// Height above the road `[m]`, if given.
    pub fn height(&self) -> Option<f64> {
        given(self.style.height())
    }

    /// Material as written; empty if not given.
    pub fn material(&self) -> &'a str {
        string(self.map.tables(), self.style.material())
    }

    /// Name of the pattern (`roadMark/type/@name`); empty if not given.
    pub fn pattern_name(&self) -> &'a str {
        string(self.map.tables(), self.style.name())
    }

    /// Lines of the pattern and explicit ones, in file order; none where the kind says all.
    pub fn lines(&self) -> impl ExactSizeIterator<Item = RoadMarkLine> + use<'a> {
        self.style.lines().of(self.map.tables().road_mark_lines).iter().map(line)
    }

    /// Where the mark is painted as a whole, with these dashes: for kinds whose lines the file does not give.
    pub fn extent(&self, dashes: Option<[f64; 2]>) -> RoadMarkExtent {
        RoadMarkExtent { s: [self.s, self.s_end], pattern_s: self.written_s, dashes }
    }

    /// Where one of the mark's lines is painted.
    pub fn extent_of(&self, line: &RoadMarkLine) -> RoadMarkExtent {
        let start = self.written_s + line.s_offset;
        // An explicit line is there once.
        let end = if line.space.is_none() { start + line.length } else { f64::INFINITY };
        RoadMarkExtent {
            s: [self.s.max(start), self.s_end.min(end)],
            pattern_s: start,
            dashes: line.space.filter(|space| *space > 0.0).map(|space| [line.length, space]),
        }
    }

    /// Whether the mark leaves the lane's border anywhere (`sway`).
    pub fn sways(&self) -> bool {
        self.style.sway().count > 0
    }

    /// Lateral shift of the mark from the lane's border at s `[m]` (`sway`); 0 for most. s outside the mark counts as its nearer
    /// end; of an s that is not finite: NaN.
    pub fn sway_at(&self, s: f64) -> f64 {
        self.place(s).map_or(f64::NAN, |at| self.sway(at))
    }

    pub(crate) fn sway(&self, at: At) -> f64 {
        profile::value(self.style.sway().of(self.map.tables().cubics), at)
    }

    /// The place that an s means: on the mark. None for an s that is not finite.
    fn place(&self, s: f64) -> Option<At> {
        let inside = mapd_geometry::clamp(s, self.s, self.s_end);
        s.is_finite().then(|| At::within(inside, self.s, self.s_end))
    }

    /// t of the mark's middle at s `[m]`: the border's plus the sway. As [`RoadMark::sway_at`] otherwise.
    pub fn t_at(&self, s: f64) -> f64 {
        let outer = |at| self.lane.edges(at).outer;
        self.place(s).map_or(f64::NAN, |at| outer(at) + self.sway(at))
    }
}

fn line(row: &ArchivedRoadMarkLineRow) -> RoadMarkLine {
    RoadMarkLine {
        length: row.length(),
        space: given(row.space()),
        t_offset: row.t_offset(),
        s_offset: row.s_offset(),
        width: given(row.width()),
        rule: RoadMarkRule::from_code(row.rule()),
        color: RoadMarkColor::from_code(row.color()),
    }
}

impl<'a> Lane<'a> {
    /// The lane's road marks in ascending s, those that hold somewhere in its section; they lie on its outer border, lane
    /// 0's on its own line. The kind `none` is among them.
    pub fn road_marks(&self) -> impl Iterator<Item = RoadMark<'a>> + use<'a> {
        let (map, lane) = (self.map, *self);
        let (start, end) = (self.section.s_start(), self.section.s_end());
        let rows = rows_of(map, self.row.first_mark());
        // Marks count from the section that the lane is written in.
        let written = self.row.section().wrapping_sub(self.row.continues().into());
        let written = map.tables().sections.get(written as usize);
        let from = written.map_or(start, |section| section.s_start());
        let s_of = move |row: &ArchivedRoadMarkRow| from + row.s_offset();
        rows.iter().enumerate().filter_map(move |(i, row)| {
            let written_s = s_of(row);
            let s = written_s.max(start);
            let s_end = rows.get(i + 1).map_or(end, |next| s_of(next).min(end));
            let style = map.tables().road_mark_styles.get(row.style() as usize)?;
            (s < s_end).then_some(RoadMark { map, lane, style, s, s_end, written_s })
        })
    }

    /// Whether one of the lane's road marks, wherever it holds, is of one of these kinds; the kind `none` never counts.
    pub(crate) fn has_mark_of(&self, kinds: MarkKinds) -> bool {
        let styles = self.map.tables().road_mark_styles;
        rows_of(self.map, self.row.first_mark()).iter().any(|row| {
            let kind = styles.get(row.style() as usize).map(|s| RoadMarkKind::from_code(s.kind()));
            kind.is_some_and(|kind| kind != RoadMarkKind::None && kinds.contains(kind))
        })
    }

    /// The road mark that holds at s; at a boundary the later one. `None` before the first and beyond the section.
    pub fn road_mark_at(&self, s: f64) -> Option<RoadMark<'a>> {
        self.road_marks().find(|mark| mark.s <= s && (s < mark.s_end || s == self.section.s_end()))
    }
}

/// The sequence of marks from a row on.
fn rows_of<'a>(map: Map<'a>, first: u32) -> &'a [ArchivedRoadMarkRow] {
    let rows = map.tables().road_marks.get(first as usize..).unwrap_or(&[]);
    let last = rows.iter().position(|row| row.last() != 0);
    rows.get(..last.map_or(0, |last| last + 1)).unwrap_or(&[])
}

impl Map<'_> {
    /// Every piece of the road marks on the borders of lanes of these types that meets a rectangle in plan view, in the
    /// order of their lanes and of s; marks of the kind `none` are left out, and so is sway: a piece is one of the lane's
    /// border, cut where a mark begins or ends. `out` is emptied first, `lanes` and `borders` are room to work in; all grow
    /// only if their capacities are too small.
    ///
    /// Errors: a rectangle that is not finite.
    pub fn road_mark_segments(
        &self,
        region: Region,
        types: LaneTypes,
        lanes: &mut Vec<LaneId>,
        borders: &mut Vec<BoundarySegment>,
        out: &mut Vec<RoadMarkSegment>,
    ) -> Result<(), QueryError> {
        out.clear();
        self.boundary_segments(region, types, lanes, borders)?;
        for border in borders.iter() {
            let Ok(lane) = self.lane(border.lane) else { continue };
            let [from, to] = border.s;
            let along = |s: f64| {
                let share = if to > from { clamp((s - from) / (to - from), 0.0, 1.0) } else { 0.0 };
                border.ends[0].lerp(border.ends[1], share)
            };
            for mark in lane.road_marks().filter(|mark| mark.kind() != RoadMarkKind::None) {
                let s = [from.max(mark.s), to.min(mark.s_end)];
                let segment = BoundarySegment { lane: border.lane, s, ends: s.map(along) };
                if s[0] < s[1]
                    && region.meets(segment.ends[0].truncate(), segment.ends[1].truncate())
                {
                    let width = mark.width_or_default();
                    out.push(RoadMarkSegment {
                        segment,
                        kind: mark.kind(),
                        color: mark.color(),
                        width,
                    });
                }
            }
        }
        Ok(())
    }
}
