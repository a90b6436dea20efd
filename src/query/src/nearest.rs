//! The nearest lane to a point.

use crate::area::{self, Cross, Slab, SlabPosition};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index::{self, LaneSegment};
use crate::lane::Lane;
use crate::map::Map;
use crate::rank::Rank;
use crate::types::{LanePosition, Point};
use glam::DVec2;
use mapd_archive::{LaneType, VehicleClass};
use mapd_geometry::{clamp, normalize_angle};
use std::cmp::Ordering;

/// Default search radius `[m]`.
const DEFAULT_RADIUS: f64 = 10.0;

/// A set of lane types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneTypes(u64);

impl LaneTypes {
    /// Every type, unknown ones too.
    pub const ALL: Self = Self(u64::MAX);
    /// No type.
    pub const NONE: Self = Self(0);

    /// Types that are built for motor vehicles ([`LaneType::is_drivable`]), whoever may use them: borders, stop and restricted lanes too.
    pub fn drivable() -> Self {
        LaneType::ALL
            .iter()
            .filter(|kind| kind.is_drivable())
            .fold(Self::NONE, |set, kind| set.with(*kind))
    }

    /// Types that motor vehicles other than those of emergency services may use where no access record says otherwise: those that routes
    /// lead over, as the lane graph has it.
    pub fn routable() -> Self {
        Self::open_to_any(VehicleClass::MOTOR & !VehicleClass::Emergency.bit())
    }

    /// What a word stands for: `all`, `drivable`, `routable`, or a type as OpenDRIVE names it. None for any other word.
    pub fn from_word(word: &str) -> Option<Self> {
        match word {
            "all" => Some(Self::ALL),
            "drivable" => Some(Self::drivable()),
            "routable" => Some(Self::routable()),
            name => match LaneType::from_name(name) {
                LaneType::Unknown => None,
                kind => Some(Self::NONE.with(kind)),
            },
        }
    }

    /// The types of either set.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Types that a class of vehicles may use where no access record says otherwise, as the lane graph has it. What records say of a
    /// place counts too with [`NearestOptions::vehicle`].
    pub fn open_to(vehicle: VehicleClass) -> Self {
        Self::open_to_any(vehicle.bit())
    }

    fn open_to_any(classes: u16) -> Self {
        let open = |kind: &&LaneType| VehicleClass::of_lane_type(**kind) & classes != 0;
        LaneType::ALL.iter().filter(open).fold(Self::NONE, |set, kind| set.with(*kind))
    }

    /// The set with one more type.
    #[must_use]
    pub fn with(self, kind: LaneType) -> Self {
        Self(self.0 | Self::bit(kind))
    }

    /// Whether a type is in the set.
    pub fn contains(self, kind: LaneType) -> bool {
        self.0 & Self::bit(kind) != 0
    }

    /// The set as a number: the bit of a type is that of its code, the highest one stands for unknown types.
    pub const fn bits(self) -> u64 {
        self.0
    }

    /// The set of [`Self::bits`].
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    fn bit(kind: LaneType) -> u64 {
        // Codes stay below 63; what is unknown has the last bit.
        1 << kind.code().min(63)
    }
}

/// What counts as a match.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct NearestOptions {
    /// Largest plan-view distance from the lane's area `[m]`; the search is always bounded. Default 10.
    pub radius: f64,
    /// Lane types that count. Default all.
    pub types: LaneTypes,
    /// Only places that this class of vehicles may use count, by lane type and access records, in either direction that the lane is
    /// travelled. Default all places.
    pub vehicle: Option<VehicleClass>,
    /// Largest difference between the point's z and the lane's `[m]`, beside the lane that of its nearer edge; needs a point with
    /// z. Default none.
    pub z_tolerance: Option<f64>,
    /// Heading of travel `[rad]`: breaks ties, and excludes places by `heading_tolerance`. Default none.
    pub heading: Option<f64>,
    /// Largest difference between `heading` and the lane's driving direction `[rad]`. Default none.
    pub heading_tolerance: Option<f64>,
    /// The answer for a point nearby, such as the one before on a trajectory: tried first where no lane holds the point, so that
    /// the search can leave out what is farther. It changes the cost, never the answer; one of another map is ignored. Default none.
    pub hint: Option<Nearest>,
}

impl Default for NearestOptions {
    fn default() -> Self {
        Self {
            radius: DEFAULT_RADIUS,
            types: LaneTypes::ALL,
            vehicle: None,
            z_tolerance: None,
            heading: None,
            heading_tolerance: None,
            hint: None,
        }
    }
}

impl NearestOptions {
    /// Errors: numbers that are not finite.
    pub(crate) fn check(&self, point: Point) -> Result<(), QueryError> {
        let numbers = [self.z_tolerance, self.heading, self.heading_tolerance];
        let finite = point.is_place()
            && self.radius.is_finite()
            && numbers.iter().flatten().all(|n| n.is_finite());
        if finite { Ok(()) } else { Err(QueryError::NotFinite) }
    }

    /// Whether the offset alone decides among lanes that hold a point: one whose centre is farther than that of the best cannot be better.
    #[inline]
    pub(crate) fn is_by_offset(&self, point: Point) -> bool {
        point.z.is_none() && self.heading.is_none()
    }

    /// Between which heights lanes count, if only some do.
    pub(crate) fn heights(&self, point: Point) -> Option<[f64; 2]> {
        match (point.z, self.z_tolerance) {
            (Some(z), Some(tolerance)) => Some([z - tolerance, z + tolerance]),
            _ => None,
        }
    }
}

/// The nearest lane and the point in its coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Nearest {
    /// The lane.
    pub lane: LaneId,
    /// The point's place with respect to it.
    pub position: LanePosition,
}

/// A lane's stretch, as near as it comes.
#[derive(Clone, Copy)]
pub(crate) struct Candidate<'a> {
    lane: u32,
    pub(crate) place: SlabPosition<'a>,
    heading_difference: f64,
    z_difference: f64,
}

impl<'a> Candidate<'a> {
    /// None where the options exclude it.
    #[inline(always)]
    pub(crate) fn new(
        lane: &Lane<'a>,
        place: SlabPosition<'a>,
        point: Point,
        options: &NearestOptions,
    ) -> Option<Self> {
        let z_difference = point.z.map_or(0.0, |z| (z - place.level(lane)).abs());
        let heading_difference = options.heading.map_or(0.0, |heading| {
            heading_difference(lane, driving_direction(lane, &place), heading)
        });
        let too_far = |limit: Option<f64>, known: bool, difference: f64| {
            known && limit.is_some_and(|limit| difference > limit)
        };
        let excluded = too_far(options.z_tolerance, point.z.is_some(), z_difference)
            || too_far(options.heading_tolerance, options.heading.is_some(), heading_difference)
            || options.vehicle.is_some_and(|vehicle| is_closed(lane, place.s(), vehicle));
        let lane = lane.row_number();
        (!excluded).then_some(Self { lane, place, heading_difference, z_difference })
    }

    /// The nearest place on a stretch of a lane that the options let pass, wherever the point is.
    #[inline]
    pub(crate) fn on(
        lane: &Lane<'a>,
        segment: u16,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Self> {
        let slab = area::slab(lane, usize::from(segment))?;
        let (map, stretch) = (lane.map, LaneSegment { lane: lane.row_number(), segment });
        Self::new(lane, area::place(lane, &slab, local), point, options)
            .or_else(|| Self::passing(map, stretch, point, local, options))
    }

    /// As [`Self::new`], in a stretch that holds the point.
    #[inline(always)]
    pub(crate) fn around(
        lane: &Lane<'a>,
        cross: &impl Cross,
        slab: &Slab<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Self> {
        Self::new(lane, area::place_inside(lane, cross, slab, local)?, point, options)
    }

    #[inline]
    pub(crate) fn distance(&self) -> f64 {
        self.place.distance
    }

    pub(crate) fn nearest(&self, map: Map<'a>) -> Option<Nearest> {
        Some(self.nearest_on(&Lane::new(map, self.lane)?))
    }

    /// As [`Self::nearest`], where its lane is known.
    #[inline]
    pub(crate) fn nearest_on(&self, lane: &Lane<'a>) -> Nearest {
        Nearest { lane: lane.lane_id(), position: self.place.position(lane) }
    }

    #[inline]
    pub(crate) fn rank(&self) -> Rank {
        Rank {
            lane: self.lane,
            distance: self.place.distance,
            heading_difference: self.heading_difference,
            z_difference: self.z_difference,
            offset: self.place.offset,
            s: self.place.s(),
            t: self.place.t,
        }
    }

    #[cold]
    fn heading(&self, map: Map<'a>) -> f64 {
        Lane::new(map, self.lane).map_or(0.0, |lane| self.place.heading_of_reference_line(&lane))
    }

    /// By rank; and what two geometries that meet round differently.
    #[inline]
    fn order(&self, other: &Self, map: Map<'a>) -> Ordering {
        self.rank()
            .order(&other.rank(), map)
            .then_with(|| self.heading(map).total_cmp(&other.heading(map)))
    }
}

/// The best candidate so far.
#[derive(Default)]
pub(crate) struct Best<'a>(Option<Candidate<'a>>);

impl<'a> Best<'a> {
    /// The candidate, if there was one.
    #[inline]
    pub(crate) fn found(&self) -> Option<&Candidate<'a>> {
        self.0.as_ref()
    }

    /// Whether it is the best now.
    #[inline(always)]
    pub(crate) fn consider(
        &mut self,
        found: Option<&Candidate<'a>>,
        map: Map<'a>,
        options: &NearestOptions,
    ) -> bool {
        let found = found.filter(|found| found.distance() <= options.radius);
        let Some(found) = found else { return false };
        let is_better = self.0.as_ref().is_none_or(|best| found.order(best, map).is_lt());
        if is_better {
            self.0 = Some(*found);
        }
        is_better
    }

    /// Whether it lies in a lane whose centre is nearer than this `[m]`. One without an offset may be a lane without width, which any other
    /// comes before.
    #[inline]
    pub(crate) fn is_nearer_than(&self, off_center: f32) -> bool {
        self.0.as_ref().is_some_and(|best| {
            let offset = best.place.offset;
            best.distance() == 0.0 && offset != 0.0 && offset.abs() < f64::from(off_center)
        })
    }
}

impl<'a> Map<'a> {
    /// The lane whose area is nearest to a point in plan view, within the options' radius; distance 0 inside. Ties go
    /// by heading difference, z difference, lanes that have a width there first, |offset|, then key. `None` if nothing is near enough.
    ///
    /// The index proposes stretches of lanes; each that may be the nearest is decided on the exact curve.
    ///
    /// Errors: coordinates or options that are not finite.
    pub fn nearest_lane(
        &self,
        point: impl Into<Point>,
        options: &NearestOptions,
    ) -> Result<Option<Nearest>, QueryError> {
        self.nearest_lane_to(point.into(), options)
    }

    /// As [`Map::nearest_lane`]: generated once, here, however many programs and places ask.
    fn nearest_lane_to(
        &self,
        point: Point,
        options: &NearestOptions,
    ) -> Result<Option<Nearest>, QueryError> {
        options.check(point)?;
        let local = point.xy - self.origin();
        // Whether a lane holds the point is cheaper to tell than how far off it is, and mostly one does.
        let mut best = Best::default();
        self.lane_around(&mut best, point, local, options);
        Ok(self.nearest_of(&mut best, point, local, options))
    }

    /// The nearest lane, where the best of the lanes that hold the point is known.
    #[inline]
    pub(crate) fn nearest_of(
        &self,
        best: &mut Best<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Nearest> {
        // Just beside an edge, by no more than rounding, another lane may be nearer.
        if best.found().is_none_or(|found| found.distance() != 0.0) {
            self.lane_beside(best, point, local, options);
        }
        best.found().and_then(|found| found.nearest(*self))
    }

    /// Considers the other lanes, where none holds the point.
    fn lane_beside(
        &self,
        best: &mut Best<'a>,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) {
        let heights = options.heights(point);
        let hinted = options.hint.and_then(|hint| self.hinted(&hint));
        if let Some(place) = hinted {
            best.consider(self.candidate(place, point, local, options).as_ref(), *self, options);
        }
        // Single precision rounds the bound; a little more loses nothing, the exact test follows.
        let distance = |best: &Best<'_>| {
            round_up(best.0.as_ref().map_or(options.radius, |best| best.distance()))
        };
        let start = distance(best);
        index::visit(self.tables(), local, heights, start, |leaf, qx, qy, mut bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            let mut open = index::places_within(&lower, bound);
            // The most promising comes first: what it yields excludes most of the others before they cost a projection.
            while let Some(k) = index::least(&lower, open) {
                open &= !(1 << k);
                let place = LaneSegment { lane: lanes[k], segment: segments[k] };
                if hinted != Some(place) {
                    let found = self.candidate(place, point, local, options);
                    best.consider(found.as_ref(), *self, options);
                }
                bound = bound.min(distance(best));
                open &= index::places_within(&lower, bound);
            }
            bound
        });
    }

    /// The stretch of a lane that a hint names.
    fn hinted(&self, hint: &Nearest) -> Option<LaneSegment> {
        // Queries in space leave temporary lanes out.
        let lane = self.lane(hint.lane).ok().filter(|lane| !lane.is_temporary())?;
        let segment = u16::try_from(area::segment_at(&lane, hint.position.s)?).ok()?;
        Some(LaneSegment { lane: hint.lane.row(), segment })
    }

    /// What a place on a lane is compared by.
    pub(crate) fn rank_of(
        &self,
        found: &Nearest,
        point: Point,
        options: &NearestOptions,
    ) -> Option<Rank> {
        let LanePosition { s, t, distance, z, .. } = found.position;
        let offset = found.position.offset_of_reference_line;
        let heading = found.position.heading;
        let row = found.lane.row();
        // Mostly nothing of the lane itself counts.
        let lane = || Lane::new(*self, row);
        let heading_difference = match options.heading {
            Some(travel) => heading_difference(&lane()?, heading, travel),
            None => 0.0,
        };
        let z_difference = match point.z {
            Some(point) => {
                let lane = lane()?;
                let (at, edges) = (lane.at(s), lane.edges_at(s));
                let (low, high) = (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
                // As a candidate has it; within the lane z is that already.
                let beside = if distance == 0.0 { 0.0 } else { t - clamp(t, low, high) };
                (point - (z - beside * lane.road.roll(at).1)).abs()
            }
            None => 0.0,
        };
        Some(Rank { lane: row, distance, heading_difference, z_difference, offset, s, t })
    }

    /// A lane's stretch as a candidate; `None` where the options exclude it. Generated once.
    #[inline(never)]
    pub(crate) fn candidate(
        &self,
        stretch: LaneSegment,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Candidate<'a>> {
        let lane = Lane::new(*self, stretch.lane);
        let lane = lane.filter(|lane| options.types.contains(lane.kind()))?;
        Candidate::on(&lane, stretch.segment, point, local, options)
    }
}

/// Whether a class of vehicles may use a lane at s in no direction.
#[inline(never)]
fn is_closed(lane: &Lane<'_>, s: f64, vehicle: VehicleClass) -> bool {
    let open = |forward| lane.node_at(s, forward).is_some_and(|node| node.allows(vehicle));
    !open(true) && !open(false)
}

/// The driving direction at a place of a lane `[rad]`.
#[inline]
pub(crate) fn driving_direction(lane: &Lane<'_>, place: &SlabPosition<'_>) -> f64 {
    place.driven_heading(lane, place.heading_of_reference_line(lane))
}

/// Angle between a heading of travel and a lane's driving direction `[rad]`, the smaller one for lanes used both ways.
pub(crate) fn heading_difference(lane: &Lane<'_>, driving: f64, heading: f64) -> f64 {
    let along = normalize_angle(heading - driving).abs();
    if lane.is_bidirectional() { along.min(std::f64::consts::PI - along) } else { along }
}

/// To single precision, never smaller.
pub(crate) fn round_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}
