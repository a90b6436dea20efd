//! What records of lanes and types of roads say of speed, along a lane.

use crate::lane::Lane;
use mapd_archive::{ArchivedLaneSpeedRow, ArchivedRoadTypeRow, SpeedKind};

/// The records of a lane and of its road's types, and how many of them have begun at the place where one stands.
#[derive(Clone, Copy)]
pub(crate) struct SpeedRecords<'a> {
    of_lane: &'a [ArchivedLaneSpeedRow],
    of_road: &'a [ArchivedRoadTypeRow],
    begun: [usize; 2],
}

/// What a record states.
#[derive(Clone, Copy)]
pub(crate) struct StatedSpeed {
    /// The limit `[m/s]`, infinite for `no limit`; none where it cannot be read.
    pub(crate) max: Option<f64>,
    /// Whether it is the lane's own record, not that of the road's type.
    pub(crate) is_of_lane: bool,
}

/// What a record states; none where it states no limit.
fn stated(kind: SpeedKind, value: f64, is_of_lane: bool) -> Option<StatedSpeed> {
    let max = match kind {
        SpeedKind::Value => Some(value),
        SpeedKind::NoLimit => Some(f64::INFINITY),
        SpeedKind::Unreadable => None,
        _ => return None,
    };
    Some(StatedSpeed { max, is_of_lane })
}

impl<'a> SpeedRecords<'a> {
    /// Those of a lane, at s.
    #[inline]
    pub(crate) fn at(lane: &Lane<'a>, s: f64) -> Self {
        let (of_lane, of_road) = (lane.speed_rows(), lane.road().type_rows());
        let begun = [
            of_lane.iter().take_while(|row| row.s() <= s).count(),
            of_road.iter().take_while(|row| row.s() <= s).count(),
        ];
        Self { of_lane, of_road, begun }
    }

    /// Goes on to a larger s: returns where the next record begins, infinity behind the last.
    pub(crate) fn pass(&mut self, s: f64) -> f64 {
        let [lane, road] = &mut self.begun;
        while self.of_lane.get(*lane).is_some_and(|row| row.s() <= s) {
            *lane += 1;
        }
        while self.of_road.get(*road).is_some_and(|row| row.s() <= s) {
            *road += 1;
        }
        let next = [
            self.of_lane.get(*lane).map(|row| row.s()),
            self.of_road.get(*road).map(|row| row.s()),
        ];
        next.into_iter().flatten().fold(f64::INFINITY, f64::min)
    }

    /// Goes back to what holds just before s: returns where it begins, minus infinity before the first.
    pub(crate) fn pass_back(&mut self, s: f64) -> f64 {
        let before = |begun: usize| begun.checked_sub(1);
        let [lane, road] = &mut self.begun;
        let own = |lane: usize| Some(self.of_lane.get(before(lane)?)?.s());
        while own(*lane).is_some_and(|begin| begin >= s) {
            *lane -= 1;
        }
        let of_road = |road: usize| Some(self.of_road.get(before(road)?)?.s());
        while of_road(*road).is_some_and(|begin| begin >= s) {
            *road -= 1;
        }
        let last = [own(*lane), of_road(*road)];
        last.into_iter().flatten().fold(f64::NEG_INFINITY, f64::max)
    }

    /// What holds: the lane's own record before that of the road's type.
    pub(crate) fn stated(&self) -> Option<StatedSpeed> {
        let own = self.begun[0].checked_sub(1).and_then(|at| self.of_lane.get(at));
        let own = own.and_then(|row| {
            stated(
                SpeedKind::from_code(u8::try_from(row.kind()).unwrap_or(u8::MAX)),
                row.max(),
                true,
            )
        });
        own.or_else(|| {
            let row = self.road_type_row()?;
            stated(SpeedKind::from_code(row.speed_kind()), row.speed(), false)
        })
    }

    /// The limit that is stated `[m/s]`.
    pub(crate) fn max(&self) -> Option<f64> {
        self.stated()?.max
    }

    /// The code of the road's type.
    pub(crate) fn road_type(&self) -> Option<u8> {
        Some(self.road_type_row()?.kind())
    }

    fn road_type_row(&self) -> Option<&'a ArchivedRoadTypeRow> {
        self.begun[1].checked_sub(1).and_then(|at| self.of_road.get(at))
    }
}
