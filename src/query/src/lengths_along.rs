//! How long lanes of very many records are up to some of these.
//!
//! Each edge of a section is added up once, as cubics of its own, and serves the lanes on both its sides: with every lane adding
//! up the widths of all lanes within, the time would grow with their third power.

use crate::begun::begun;
use crate::beside::Beside;
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::lane_length::{ASSUMED_SPEED, CachedGeometry, Measures, Stretch, travel_speed};
use crate::profile::{self, Record};
use crate::road::Road;
use crate::rules::SpeedRecords;
use crate::section::LaneSection;
use mapd_archive::{ArchivedCubicRow, LaneLengthRow, lane_flags};

/// Records between two places of a lane up to which its length is stored.
const RECORDS_PER_LENGTH: usize = 16;
/// Records of a lane of which no lengths are stored: so many are looked at for each length along it.
const FEW_RECORDS: usize = 32;
/// A cubic changes its sign so often at most.
const SIGN_CHANGES: usize = 3;

/// Lengths along the lanes of a section, lane by lane: after each 16 records of a lane of more than 32, none of another. Where the archive
/// has them, [`Lane::length_between`] looks at no more than 16 at either end.
pub fn lengths_along(section: &LaneSection<'_>) -> Vec<LaneLengthRow> {
    let mut along = Vec::new();
    if let Some(walk) = Walk::of_many(section) {
        walk.each_lane(section, |lane, edges| walk.along(lane, edges, &mut along));
    }
    along
}

/// Changes of speed and pieces of a section's lanes, times its lanes, up to which each piece of a lane is measured by itself.
const MEASURED_ONE_BY_ONE: usize = 1 << 10;

/// Length and time of each piece of each lane of a section, from lane to lane and from piece to piece towards +s: as [`measures_between`](crate::compiling::measures_between) has them one by one.
/// Pieces go from one of these places, which ascend, to the next. None for a section of few, and for a damaged archive.
pub fn measures_along(section: &LaneSection<'_>, places: &[f64]) -> Option<Vec<Vec<Measures>>> {
    let (road, lanes) = (section.road()?, section.rows().len());
    let own: usize = section.lanes().map(|lane| lane.speeds().len()).sum();
    if (road.type_rows().len() + own + places.len()).saturating_mul(lanes) <= MEASURED_ONE_BY_ONE {
        return None;
    }
    let first = section.lanes().next()?.row_number();
    let walk = Walk::over(section)?;
    let mut measured = vec![Vec::new(); lanes];
    walk.each_lane(section, |lane, edges| {
        let own = (lane.row_number() - first) as usize;
        if let Some(own) = measured.get_mut(own) {
            *own = walk.measures(lane, edges, places);
        }
    });
    Some(measured)
}

/// Records that hold one after the other between two places, each by the distance from where it begins to hold.
fn pieces(records: &[ArchivedCubicRow], from: f64, to: f64) -> Vec<Record> {
    let mut pieces = Vec::new();
    each_held(records, from, to, |row, s, _| pieces.push(Record::of(row).from(s)));
    pieces
}

/// As [`pieces`], of widths: they are none where they are not positive.
fn widths(records: &[ArchivedCubicRow], from: f64, to: f64) -> Vec<Record> {
    let mut pieces = Vec::new();
    each_held(records, from, to, |row, from, to| {
        let (record, mut s) = (Record::of(row), from);
        for changes in 0..=SIGN_CHANGES {
            let may_change = changes < SIGN_CHANGES && !record.is_constant();
            let change = row.filter(|_| may_change);
            let change = change.and_then(|row| profile::sign_change(row, s, to));
            let end = change.filter(|end| *end > s).unwrap_or(to);
            let is_open = record.value(0.5 * (s + end)) > 0.0;
            pieces.push(if is_open { record } else { Record::NONE }.from(s));
            s = end;
            if s >= to {
                break;
            }
        }
    });
    pieces
}

/// Visits the records that hold between two places with the part of it where each does; none where no record has begun.
fn each_held<'a>(
    records: &'a [ArchivedCubicRow],
    from: f64,
    to: f64,
    mut visit: impl FnMut(Option<&'a ArchivedCubicRow>, f64, f64),
) {
    let (mut next, mut s) = (begun(records, from, |row| row.s()), from);
    while s < to {
        let own = next.checked_sub(1).and_then(|own| records.get(own));
        let end = records.get(next).map_or(to, |row| row.s().min(to));
        // Of records at one place the last holds.
        if end > s {
            visit(own, s, end);
            s = end;
        }
        next += 1;
    }
}

/// An edge and so many times what lies beside it.
fn sum(edge: &[Record], times: f64, beside: &[Record]) -> Vec<Record> {
    let mut sum = Vec::with_capacity(edge.len() + beside.len());
    let (mut a, mut b) = (Held::new(edge), Held::new(beside));
    while let (Some(one), Some(other)) = (a.own(), b.own()) {
        let s = one.start().max(other.start());
        sum.push(one.plus(times, other, s));
        let next = a.next().min(b.next());
        a.go_to(next);
        b.go_to(next);
    }
    sum
}

/// The piece that holds at a place which goes on.
struct Held<'p> {
    pieces: &'p [Record],
}

impl<'p> Held<'p> {
    fn new(pieces: &'p [Record]) -> Self {
        Self { pieces }
    }

    fn own(&self) -> Option<&'p Record> {
        self.pieces.first()
    }

    /// Where the next piece begins; infinite behind the last.
    fn next(&self) -> f64 {
        self.pieces.get(1).map_or(f64::INFINITY, Record::start)
    }

    /// Goes on to a place, which lies no further than the next piece: at infinity there is none.
    fn go_to(&mut self, s: f64) {
        if self.next() <= s {
            self.pieces = self.pieces.get(1..).unwrap_or_default();
        }
    }
}

/// The part of a road along which lengths of lanes are added up.
struct Walk<'a> {
    road: Road<'a>,
    from: f64,
    to: f64,
    superelevations: Vec<Record>,
}

impl<'a> Walk<'a> {
    /// None for a damaged archive.
    fn over(section: &LaneSection<'a>) -> Option<Self> {
        let road = section.road()?;
        let (from, to) = (section.s_start(), section.s_end().min(road.reference_end()));
        Some(Self { road, from, to, superelevations: pieces(road.superelevations(), from, to) })
    }

    /// None for a section of which no lane has more than few records.
    fn of_many(section: &LaneSection<'a>) -> Option<Self> {
        let road = section.road()?;
        let (from, to) = (section.s_start(), section.s_end().min(road.reference_end()));
        let geometries = road.geometries();
        let before = geometries.partition_point(|row| row.s() <= from);
        let begin = |rows: &[ArchivedCubicRow]| {
            rows.iter().filter(|row| row.s() > from && row.s() < to).count()
        };
        let of_road = geometries.partition_point(|row| row.s() < to).saturating_sub(before)
            + begin(road.lane_offsets())
            + begin(road.temporary_lane_offsets())
            + begin(road.superelevations());
        let cubics = section.map.tables().cubics;
        // A width that changes may close between two records.
        let can_close = |row: &ArchivedCubicRow| !Record::of(Some(row)).is_constant();
        let mut sides = [0; 2];
        for lane in section.rows() {
            let widths = lane.widths().of(cubics);
            let side = &mut sides[usize::from(lane.number() > 0)];
            *side += widths.iter().map(|row| 1 + usize::from(can_close(row))).sum::<usize>();
        }
        if 1 + of_road + sides[0].max(sides[1]) <= FEW_RECORDS {
            return None;
        }
        Self::over(section)
    }

    /// Visits all lanes with their inner and outer edges, lane 0 first and then outwards on either side: each edge is added up once.
    fn each_lane(
        &self,
        section: &LaneSection<'a>,
        mut visit: impl FnMut(&Lane<'a>, [&[Record]; 2]),
    ) {
        let lanes: Vec<_> = section.lanes().collect();
        let Some(center) = lanes.iter().position(|lane| lane.number() == 0) else { return };
        let (left, right) = lanes.split_at(center);
        let Some((center, right)) = right.split_first() else { return };
        let cubics = section.map.tables().cubics;
        let offset = pieces(center.own_lane_offsets(), self.from, self.to);
        visit(center, [&offset, &offset]);
        for (sign, side) in [
            (1.0, &mut left.iter().rev() as &mut dyn Iterator<Item = _>),
            (-1.0, &mut right.iter()),
        ] {
            let mut inner = offset.clone();
            for lane in side {
                let records = lane.row.widths().of(cubics);
                let outer = if lane.row.flags() & lane_flags::BORDER != 0 {
                    pieces(records, self.from, self.to)
                } else {
                    sum(&inner, sign, &widths(records, self.from, self.to))
                };
                visit(lane, [&inner, &outer]);
                inner = outer;
            }
        }
    }

    /// Measures a lane with an inner and an outer edge from each of some places to the next.
    fn measures(&self, lane: &Lane<'_>, edges: [&[Record]; 2], places: &[f64]) -> Vec<Measures> {
        let mut records = SpeedRecords::at(lane, self.from);
        let none = Measures { length: 0.0, time: 0.0 };
        let mut measured = vec![none; places.len().saturating_sub(1)];
        let mut number = 0;
        self.each_stretch(edges, |stretch, middle| {
            let mut from = stretch.from;
            while from < stretch.to {
                let next = records.pass(from);
                while number + 1 < measured.len()
                    && places.get(number + 1).is_some_and(|place| *place <= from)
                {
                    number += 1;
                }
                let place = places.get(number + 1).filter(|place| **place > from);
                let place = place.copied().unwrap_or(f64::INFINITY);
                let to = stretch.to.min(next).min(place);
                let length = self.length(&Stretch { from, to, ..*stretch }, middle);
                let speed = records.max().unwrap_or(ASSUMED_SPEED);
                if let Some(piece) = measured.get_mut(number) {
                    piece.length += length;
                    piece.time += length / travel_speed(speed);
                }
                from = to;
            }
        });
        measured
    }

    /// Length of the middle between two edges.
    #[inline]
    fn length(&self, stretch: &Stretch<'a>, edges: [&Record; 2]) -> f64 {
        stretch.length(|at| {
            let [inner, outer] = edges.map(|edge| edge.slope(at.s));
            let t = EdgeSlopes { inner, outer }.center();
            Beside::new(&self.road, at, self.road.roll(at), t)
        })
    }

    /// Adds the lengths along a lane with an inner and an outer edge.
    fn along(&self, lane: &Lane<'_>, edges: [&[Record]; 2], along: &mut Vec<LaneLengthRow>) {
        let mut records = 0;
        self.each_stretch(edges, |_, _| records += 1);
        if records <= FEW_RECORDS {
            return;
        }
        let (mut number, mut length) = (0, 0.0);
        self.each_stretch(edges, |stretch, middle| {
            number += 1;
            length += self.length(stretch, middle);
            if number % RECORDS_PER_LENGTH == 0 && number < records {
                let (s, lane) = (stretch.to, lane.row_number());
                along.push(LaneLengthRow { s, length, lane, reserved: 0 });
            }
        });
    }

    /// Visits the stretches along each of which the same records hold, with those of the edges.
    fn each_stretch(
        &self,
        edges: [&[Record]; 2],
        mut visit: impl FnMut(&Stretch<'a>, [&Record; 2]),
    ) {
        let [inner, outer] = edges.map(Held::new);
        let (mut held, mut geometry) =
            ([inner, outer, Held::new(&self.superelevations)], CachedGeometry::NONE);
        let mut s = self.from;
        while let [Some(inner), Some(outer), Some(superelevation)] = held.each_ref().map(Held::own)
        {
            let piece = geometry.at(&self.road, s);
            let next = held.iter().map(Held::next).fold(geometry.to, f64::min);
            let to = next.min(self.to);
            let is_constant = [inner, outer, superelevation].into_iter().all(Record::is_constant);
            visit(&Stretch { from: s, to, piece, is_constant }, [inner, outer]);
            if next >= self.to {
                break;
            }
            held.iter_mut().for_each(|held| held.go_to(next));
            s = next;
        }
    }
}
