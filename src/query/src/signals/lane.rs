//! Signals of a lane.

use super::{Signal, SignalPlace};
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::{ArchivedSignalLaneRow, Class, LaneMethod};

/// A signal at a place, for a lane.
#[derive(Clone, Copy)]
pub struct LaneSignal<'a> {
    map: Map<'a>,
    row: &'a ArchivedSignalLaneRow,
    place: SignalPlace<'a>,
    signal: Signal<'a>,
}

impl<'a> LaneSignal<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        let row = map.tables().signal_lanes.get(number as usize)?;
        let place = SignalPlace::new(map, row.place())?;
        Some(Self { map, row, place, signal: place.signal()? })
    }

    /// The signal.
    #[inline]
    pub fn signal(&self) -> Signal<'a> {
        self.signal
    }

    /// Where it counts.
    #[inline]
    pub fn place(&self) -> SignalPlace<'a> {
        self.place
    }

    /// The lane.
    pub fn lane(&self) -> Option<Lane<'a>> {
        Lane::new(self.map, self.row.lane())
    }

    /// How signal and lane belong together.
    pub fn method(&self) -> LaneMethod {
        LaneMethod::from_code(self.row.method())
    }

    /// Distance of the signal's s and t from the lane's area, in plan view `[m]`.
    pub fn distance(&self) -> f64 {
        f64::from(self.row.distance())
    }

    /// s on the lane `[m]`: within its section.
    pub fn s_on(&self, lane: &Lane<'_>) -> f64 {
        let section = lane.section();
        let start = section.s_start();
        mapd_geometry::clamp(self.place.s(), start, section.s_end().max(start))
    }

    /// Whether it is for traffic that travels towards +s, or for that towards −s: as its orientation says. Where the file names a
    /// lane that travels the other way, the lane is meant (RoadRunner writes lights of connecting roads so).
    pub fn is_for(&self, forward: bool) -> bool {
        self.place.orientation().is_for(forward) || self.is_for_lane_alone(forward)
    }

    /// Whether it is a light for vehicles on the roadway, those of public transport included.
    pub fn is_vehicle_light(&self) -> bool {
        matches!(self.signal.class(), Class::TrafficLight | Class::PublicTransportLight)
    }

    /// Whether the lane is named against the orientation, and this is the direction in which it is travelled.
    fn is_for_lane_alone(&self, forward: bool) -> bool {
        self.method() == LaneMethod::Validity
            && self.lane().is_some_and(|lane| {
                !lane.is_bidirectional()
                    && lane.is_forward() == forward
                    && !self.place.orientation().is_for(lane.is_forward())
            })
    }

    /// Its number among all places of signals.
    pub(super) fn place_number(&self) -> u32 {
        self.place.number
    }
}

/// Signals of all lanes, lane by lane, in the order of [`Lane::signals`].
pub fn signals_of_lanes(map: Map<'_>) -> impl Iterator<Item = LaneSignal<'_>> {
    let order = map.tables().lane_signals.iter();
    order.filter_map(move |at| LaneSignal::new(map, *at))
}

impl<'a> Lane<'a> {
    /// Signals that are for the lane, ascending in s.
    pub fn signals(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        let (map, own) = (self.map, self.row_number());
        let (order, rows) = (map.tables().lane_signals, map.tables().signal_lanes);
        let lane = move |at: &u32| rows.get(*at as usize).map_or(u32::MAX, |row| row.lane());
        let from = order.partition_point(|at| lane(at) < own);
        let rest = order.get(from..).unwrap_or(&[]).iter();
        rest.take_while(move |at| lane(at) == own).filter_map(move |at| LaneSignal::new(map, *at))
    }

    fn of_classes(
        &self,
        classes: &'static [Class],
    ) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        self.signals().filter(move |one| classes.contains(&one.signal().class()))
    }

    /// Lights for the lane's traffic, ascending in s.
    pub fn traffic_lights(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        const LIGHTS: &[Class] = &[
            Class::TrafficLight,
            Class::BicycleLight,
            Class::PublicTransportLight,
            Class::LaneLight,
            Class::LevelCrossingLight,
        ];
        self.of_classes(LIGHTS)
    }

    /// Lines at which the lane's traffic stops or gives way, ascending in s.
    pub fn stop_lines(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        self.of_classes(&[Class::StopLine, Class::WaitingLine])
    }

    /// Crosswalks over the lane that are written as signals, ascending in s.
    pub fn crosswalks(&self) -> impl Iterator<Item = LaneSignal<'a>> + use<'a> {
        self.of_classes(&[Class::Crosswalk, Class::BicycleCrossing])
    }
}
