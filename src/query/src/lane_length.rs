//! Lengths along a lane's centre line, and the speed limit there.

use crate::beside::Beside;
use crate::integral::integral;
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::profile::{self, At};
use crate::road::{GeometryPiece, Road};
use crate::rules::SpeedRecords;
use mapd_archive::{ArchivedCubicRow, ArchivedLaneLengthRow};

/// Speed assumed where the file states none `[m/s]`: 50 km/h, the usual limit in towns.
pub(crate) const ASSUMED_SPEED: f64 = 50.0 / 3.6;
/// Speed assumed where there is no limit `[m/s]`: 130 km/h, the recommended one on motorways.
const UNLIMITED_SPEED: f64 = 130.0 / 3.6;
/// Lowest speed counted `[m/s]`: a limit of 0 must not make a lane take for ever.
const LOWEST_SPEED: f64 = 0.1;

/// The speed that travel times count for a limit `[m/s]`.
pub fn travel_speed(limit: f64) -> f64 {
    mapd_geometry::clamp(limit, LOWEST_SPEED, UNLIMITED_SPEED)
}

/// Whether the speed that travel times count for a recorded limit is none of the file's.
fn is_assumed(limit: Option<f64>) -> bool {
    limit.is_none_or(|limit| travel_speed(limit) != limit)
}

/// Time along a lane at the recorded limits `[s]`.
struct TravelTime {
    whole: f64,
    /// What of it is at speeds that no record states.
    assumed: f64,
}

/// What travelling along a lane between two places takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// As [`Lane::length_between`] has it `[m]`.
    pub length: f64,
    /// As [`Lane::time_between`] has it `[s]`.
    pub time: f64,
}

/// Both between two places of a lane: where one speed holds all along, the length is integrated once.
pub fn measures_between(lane: &Lane<'_>, a: f64, b: f64) -> Measures {
    let whole = lane.length_between(a, b);
    let (low, high) = (a.min(b), a.max(b));
    if !(low.is_finite() && high.is_finite()) {
        return Measures { length: whole, time: f64::NAN };
    }
    let length = |from: f64, to: f64| {
        if from == low && to == high { whole } else { lane.length_between(from, to) }
    };
    Measures { length: whole, time: lane.time_of(low, high, &length).whole }
}

/// A piece of the reference line, from which s on and up to which one it holds. Places that are asked for one behind the other
/// mostly lie on the same.
pub(crate) struct CachedGeometry<'a> {
    piece: Option<GeometryPiece<'a>>,
    from: f64,
    pub(crate) to: f64,
}

impl<'a> CachedGeometry<'a> {
    /// Holds nowhere.
    pub(crate) const NONE: Self = Self { piece: None, from: f64::INFINITY, to: f64::NEG_INFINITY };

    /// The piece that holds at s, as [`Road::piece_at`] finds it.
    #[inline]
    pub(crate) fn at(&mut self, road: &Road<'a>, s: f64) -> Option<GeometryPiece<'a>> {
        if !(s >= self.from && s < self.to) {
            let rows = road.geometries();
            let next = rows.partition_point(|g| g.s() <= s);
            let own = next.saturating_sub(1);
            self.piece = rows.get(own).and_then(|g| road.piece(g));
            // Before the first geometry, that one holds.
            self.from = if own == 0 { f64::NEG_INFINITY } else { rows.get(own)?.s() };
            self.to = rows.get(next).map_or(f64::INFINITY, |g| g.s());
        }
        self.piece
    }
}

/// A stretch on one piece of the reference line, all along which the same records hold.
#[derive(Clone, Copy)]
pub(crate) struct Stretch<'a> {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// None in a damaged archive.
    pub(crate) piece: Option<GeometryPiece<'a>>,
    /// Whether none of the records changes.
    pub(crate) is_constant: bool,
}

impl Stretch<'_> {
    /// Length of a line that lies beside the reference line as `beside` has it.
    #[inline(always)]
    pub(crate) fn length(&self, beside: impl Fn(At) -> Beside) -> f64 {
        let Self { from, to, piece, is_constant } = *self;
        // A damaged archive.
        let Some(piece) = piece else { return to - from };
        let hold = 0.5 * (from + to);
        if is_constant {
            let beside = beside(At::new(hold));
            if piece.curve.even_curvature_up_to(to - piece.s).is_some() {
                return (to - from) * beside.growth(piece.speed_and_curvature(hold));
            }
            // The same integral with another variable: by that of its cubics a curve has no joints, and needs far fewer places.
            if let Some(part) = piece.curve.cubic_part(from - piece.s, to - piece.s) {
                let [from, to] = part.range();
                return integral(&mut |p| beside.growth(part.speed_and_curvature(p)), from, to);
            }
            return integral(&mut |s| beside.growth(piece.speed_and_curvature(s)), from, to);
        }
        integral(&mut |s| beside(At { s, hold }).growth(piece.speed_and_curvature(s)), from, to)
    }
}

/// Where the records that hold at a place give way to others.
struct Records {
    to: f64,
    /// Whether none of them changes up to there.
    is_constant: bool,
}

impl Records {
    /// Looks at those of one profile, too: returns the one that holds, if it is not the same all along.
    fn and<'r>(
        &mut self,
        records: &'r [ArchivedCubicRow],
        from: f64,
    ) -> Option<&'r ArchivedCubicRow> {
        let next = records.partition_point(|record| record.s() <= from);
        // Before the first record, profiles are 0.
        let own = next.checked_sub(1).and_then(|own| records.get(own));
        let changes = own.filter(|own| own.b() != 0.0 || own.c() != 0.0 || own.d() != 0.0);
        self.is_constant &= changes.is_none();
        if let Some(next) = records.get(next) {
            self.to = self.to.min(next.s());
        }
        changes
    }

    /// As [`Self::and`], of widths: they are none where they are negative.
    fn and_widths(&mut self, records: &[ArchivedCubicRow], from: f64) {
        let changes = self.and(records, from);
        let closed = changes.and_then(|own| profile::sign_change(own, from, self.to));
        self.to = closed.filter(|s| *s > from).map_or(self.to, |s| self.to.min(s));
    }
}

/// Most steps towards the place at a length along a lane: by halves alone there are fewer.
const MOST_STEPS: u32 = 64;
/// A place at a length along a lane is found when it is this near `[m]`.
const FOUND: f64 = 1e-10;

impl<'a> Lane<'a> {
    /// s at a length along the centre line from one place towards another `[m]`: in a bend the two are not in one proportion.
    pub(crate) fn s_after(&self, from: f64, to: f64, wanted: f64) -> f64 {
        if wanted <= 0.0 {
            return from;
        }
        let whole = self.length_between(from, to);
        if wanted >= whole || wanted.is_nan() {
            return to;
        }
        let way = (to - from).signum();
        // Between these lies the place, and this is the length up to the last one that was looked at.
        let (mut near, mut far) = (from, to);
        let (mut s, mut gone) = (from, 0.0);
        let mut step = (to - from).abs() * (wanted / whole);
        for _ in 0..MOST_STEPS {
            // By Newton's method, but by halves where it leads out of what is left.
            let next = s + way * step;
            let next = if (next - near) * way > 0.0 && (far - next) * way > 0.0 {
                next
            } else {
                0.5 * (near + far)
            };
            gone += self.length_between(s, next).copysign((next - s) * way);
            s = next;
            let missing = wanted - gone;
            if missing.abs() <= FOUND {
                break;
            }
            *(if missing > 0.0 { &mut near } else { &mut far }) = s;
            step = missing / self.growth_at(s);
        }
        s
    }

    /// Metres of the centre line per metre of s in plan view.
    fn growth_at(&self, s: f64) -> f64 {
        let at = self.at(s);
        self.road
            .piece_at(at)
            .map_or(1.0, |piece| self.middle(at).growth(piece.speed_and_curvature(s)))
    }

    /// Length of the centre line in plan view between two places on the road `[m]`, from the file's own polynomials and within a nanometre per record where
    /// they are smooth. In a map of another frame than its file's it is that of the line in that frame. s outside the lane's section and the reference line counts as their
    /// nearer end; with one that is not finite: NaN.
    pub fn length_between(&self, a: f64, b: f64) -> f64 {
        if !(a.is_finite() && b.is_finite()) {
            return f64::NAN;
        }
        let (start, section_end) = (self.section().s_start(), self.section().s_end());
        // Beyond the reference line there is no more of it, whatever length is written.
        let end = section_end.min(self.road.reference_end());
        let inside = |s: f64| mapd_geometry::clamp(s, start, end.max(start));
        let (from, to) = (inside(a.min(b)), inside(a.max(b)));
        if !self.map.tables().lane_lengths.is_empty() {
            return self.length_by_stored(from, to);
        }
        self.length_of_records(from, to)
    }

    /// Length between two places, the lower one first, in a map that has lengths of some lanes.
    #[inline(never)]
    fn length_by_stored(&self, from: f64, to: f64) -> f64 {
        let Some([first, last]) = self.stored_lengths(from, to) else {
            return self.length_of_records(from, to);
        };
        let (before, behind) =
            (self.length_of_records(from, first.s()), self.length_of_records(last.s(), to));
        before + (last.length() - first.length()) + behind
    }

    /// The first and the last place of two or more between two others up to which the lane's length is stored.
    fn stored_lengths(&self, from: f64, to: f64) -> Option<[&'a ArchivedLaneLengthRow; 2]> {
        let stored = self.map.tables().lane_lengths;
        let is_before = |row: &ArchivedLaneLengthRow, s: f64| {
            row.lane() < self.row_number() || (row.lane() == self.row_number() && row.s() < s)
        };
        let first = stored.partition_point(|row| is_before(row, from));
        let last = stored.partition_point(|row| is_before(row, to)).checked_sub(1)?;
        let ends = [stored.get(first)?, stored.get(last)?];
        (first < last && ends.iter().all(|row| row.lane() == self.row_number())).then_some(ends)
    }

    /// Visits the stretches from a place to another along each of which the same records hold.
    #[inline]
    fn each_stretch(&self, from: f64, to: f64, mut visit: impl FnMut(&Stretch<'a>)) {
        let (mut held, mut s) = (CachedGeometry::NONE, from);
        while s < to {
            let piece = held.at(&self.road, s);
            let Records { to: end, is_constant } = self.records_from(s, to.min(held.to));
            // Records of a damaged archive may begin nowhere.
            let end = if end > s { end } else { to };
            visit(&Stretch { from: s, to: end, piece, is_constant });
            s = end;
        }
    }

    /// Length between two places, the lower one first, by all records between. There once: three ask.
    #[inline(never)]
    fn length_of_records(&self, from: f64, to: f64) -> f64 {
        let mut sum = 0.0;
        self.each_stretch(from, to, |stretch| sum += self.smooth_length(stretch));
        sum
    }

    /// Length of a stretch.
    #[inline]
    fn smooth_length(&self, stretch: &Stretch<'_>) -> f64 {
        stretch.length(|at| self.middle(at))
    }

    /// What holds of the profiles that shape the centre line from a place on, up to another at most.
    fn records_from(&self, from: f64, to: f64) -> Records {
        let cubics = self.map.tables().cubics;
        let mut records = Records { to, is_constant: true };
        records.and(self.own_lane_offsets(), from);
        records.and(self.road.superelevations(), from);
        self.walk_outwards(|lane| records.and_widths(lane.widths().of(cubics), from));
        records
    }

    /// Where the centre line lies at a place.
    fn middle(&self, at: At) -> Beside {
        self.middle_between(at, &self.edge_slopes(at))
    }

    /// As [`Self::middle`], where the lane's edges there are known.
    #[inline]
    pub(crate) fn middle_between(&self, at: At, edges: &EdgeSlopes) -> Beside {
        Beside::new(&self.road, at, self.road.roll(at), edges.center())
    }

    /// What a route by time counts for the centre line between two places on the road `[s]`: its length at [`Lane::recorded_speed_limit_at`], at 50 km/h where no limit is recorded,
    /// at 130 km/h where there is none, and never slower than 0.1 m/s. Signs and what comes into a junction do not count: the time at the limits of a way is
    /// [`Path::travel_time`](crate::path::Path::travel_time)'s. s outside the lane's section counts as its nearer end; with one that is not finite: NaN.
    pub fn time_between(&self, a: f64, b: f64) -> f64 {
        if !(a.is_finite() && b.is_finite()) {
            return f64::NAN;
        }
        let length = |from, to| self.length_between(from, to);
        self.time_of(a.min(b), a.max(b), &length).whole
    }

    /// How much of a time between two finite places is at a speed that no record states `[s]`.
    pub(crate) fn assumed_time(&self, a: f64, b: f64, time: f64) -> f64 {
        let (from, to) = (a.min(b), a.max(b));
        let mut records = SpeedRecords::at(self, from);
        if records.pass(from) >= to {
            return if is_assumed(records.max()) { time } else { 0.0 };
        }
        let length = |from, to| self.length_between(from, to);
        let TravelTime { whole, assumed } = self.time_of(from, to, &length);
        if whole > 0.0 { time * (assumed / whole) } else { 0.0 }
    }

    /// As [`Self::time_between`], of finite s that ascend. `length` is that of a stretch.
    #[inline(never)]
    fn time_of(&self, from: f64, to: f64, length: &dyn Fn(f64, f64) -> f64) -> TravelTime {
        let mut records = SpeedRecords::at(self, from);
        let (mut sum, mut last) = (TravelTime { whole: 0.0, assumed: 0.0 }, from);
        loop {
            let next = records.pass(last).min(to);
            let limit = records.max();
            let time = length(last, next) / travel_speed(limit.unwrap_or(ASSUMED_SPEED));
            sum.whole += time;
            if is_assumed(limit) {
                sum.assumed += time;
            }
            if next >= to {
                return sum;
            }
            last = next;
        }
    }

    /// The speed limit that is recorded at s `[m/s]`: in the lane's own record, else in that of the road's type (OpenDRIVE 1.8.1, 11.8.2, 10.4). Infinite where the file
    /// says `no limit`; none where it says nothing or states a limit that cannot be read, and for an s that is not finite. What holds may be another:
    /// [`Lane::speed_rule_at`] also knows signs, junctions and the header's regulations.
    pub fn recorded_speed_limit_at(&self, s: f64) -> Option<f64> {
        if !s.is_finite() {
            return None;
        }
        SpeedRecords::at(self, s).max()
    }
}
