//! Which speed limit holds on a lane, and who says so: decided in [`Limits`] and nowhere else.
//!
//! What comes onto a lane with its traffic is known of one way ([`Path`](crate::path::Path)), or gathered over all ways that lead there.

use super::speed_records::{SpeedRecords, StatedSpeed};
use super::speed_signs::{SpeedSigns, Zone};
use crate::extents::SRange;
use crate::ids::SignalId;
use crate::lane::Lane;

/// Lanes of junctions that are followed back one behind the other at most.
const MOST_BEHIND: usize = 64;
/// Lanes that are looked at in all when the ways into a junction are followed back; beyond them the limit depends, and may be any.
const MOST_LOOKED_AT: u32 = 256;

/// Where a speed limit comes from, the strongest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum SpeedOrigin {
    /// An entry of today's overlay: only a view's answers have it ([`View`](crate::view::View)).
    Overlay,
    /// A sign.
    Signal,
    /// The lane's own record.
    Lane,
    /// The road's type.
    RoadType,
    /// What holds where the junction is entered: on each lane that leads to the place, or on that of a path.
    Entry,
    /// The header's regulations for the road's type (1.8).
    Default,
    /// What came in with the vehicle, into the junction or a zone, which is not the same on all lanes that lead to the place; a path
    /// knows ([`Path::speed_at`](crate::path::Path::speed_at)).
    Depends,
    /// Nothing in the map.
    None,
}

impl SpeedOrigin {
    /// `overlay`, `written` (lane and road type), `sign`, `entry`, `default`, `depends` or `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Overlay => "overlay",
            Self::Signal => "sign",
            Self::Lane | Self::RoadType => "written",
            Self::Entry => "entry",
            Self::Default => "default",
            Self::Depends => "depends",
            Self::None => "unknown",
        }
    }
}

/// The speed limit at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpeedRule {
    /// Limit `[m/s]`; infinite where there is none; `None` where the map says nothing.
    #[cfg_attr(feature = "serde", serde(with = "crate::numbers::limit"))]
    pub max: Option<f64>,
    /// Who says so.
    pub origin: SpeedOrigin,
    /// The sign, if one does.
    pub signal: Option<SignalId>,
}

/// A stretch of a lane on which one speed limit holds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpeedStretch {
    /// From where to where on the road `[m]`.
    pub s: SRange,
    /// What holds there.
    pub rule: SpeedRule,
    /// The limit, or where it depends on the way ([`SpeedOrigin::Depends`]) the lowest that may hold `[m/s]`; none where nothing is known.
    #[cfg_attr(feature = "serde", serde(with = "crate::numbers::limit"))]
    pub lowest: Option<f64>,
}

/// Nothing is known.
pub(crate) const NOTHING: SpeedRule =
    SpeedRule { max: None, origin: SpeedOrigin::None, signal: None };
/// Which limit holds depends on the way that one has come.
const DEPENDS: SpeedRule = SpeedRule { max: None, origin: SpeedOrigin::Depends, signal: None };
/// The lowest limit where nobody knows how low it may be `[m/s]`.
const LOWEST: f64 = 0.0;

/// A limit that somebody states; of one that cannot be read nothing is known.
fn rule(max: Option<f64>, origin: SpeedOrigin, signal: Option<SignalId>) -> SpeedRule {
    if max.is_some() { SpeedRule { max, origin, signal } } else { NOTHING }
}

/// The lower of two limits, as far as they are known.
fn lower(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// What traffic carries into a junction, by one way or by all that are looked at.
#[derive(Clone, Copy)]
pub(crate) struct Carried {
    /// What is stated where the last lane that states something is left; none where none does.
    rule: Option<SpeedRule>,
    /// The lowest of what the ways state `[m/s]`.
    lowest: Option<f64>,
    /// Whether nothing is stated on one of them.
    is_open: bool,
}

impl Carried {
    /// Of one way.
    pub(crate) fn by(rule: Option<SpeedRule>) -> Self {
        let own = rule.unwrap_or(NOTHING);
        let held = match own.origin {
            SpeedOrigin::Depends | SpeedOrigin::None => own,
            _ => SpeedRule { origin: SpeedOrigin::Entry, ..own },
        };
        let depends = own.origin == SpeedOrigin::Depends;
        let lowest = if depends { Some(LOWEST) } else { own.max };
        Self { rule: rule.map(|_| held), lowest, is_open: rule.is_none() }
    }

    /// Nothing can be said of the ways.
    const ANY: Self = Self { rule: Some(DEPENDS), lowest: Some(LOWEST), is_open: false };

    /// Of this way, too.
    fn and(self, other: Self) -> Self {
        let rule = match (self.rule, other.rule) {
            (None, None) => None,
            (Some(a), Some(b)) if a.max == b.max && a.origin == b.origin => {
                Some(SpeedRule { signal: a.signal.filter(|_| a.signal == b.signal), ..a })
            }
            _ => Some(DEPENDS),
        };
        let lowest = lower(self.lowest, other.lowest);
        Self { rule, lowest, is_open: self.is_open || other.is_open }
    }
}

/// Lanes of junctions on the way back, from one whose limit is asked for.
struct Trail {
    lanes: [u32; MOST_BEHIND],
    length: usize,
    /// How many may still be looked at.
    left: u32,
}

impl Trail {
    /// Adds what all ways into a lane carry; none as long as no way is known.
    fn gather(&mut self, lane: &Lane<'_>, mut sum: Option<Carried>) -> Option<Carried> {
        for id in lane.predecessors() {
            let Some(before) = Lane::new(lane.map, id.row()) else { continue };
            let Some(left) = self.left.checked_sub(1) else { return Some(Carried::ANY) };
            self.left = left;
            let stated = before.limits().stated_at(before.exit_s());
            let is_inside = stated.is_none() && before.is_in_junction();
            if !is_inside {
                let own = Carried::by(stated);
                sum = Some(sum.map_or(own, |sum| sum.and(own)));
                continue;
            }
            let known = self.lanes.get(..self.length).unwrap_or(&[]);
            // Around a ring comes what has come into it.
            if known.contains(&before.row_number()) {
                continue;
            }
            let Some(place) = self.lanes.get_mut(self.length) else { return Some(Carried::ANY) };
            *place = before.row_number();
            self.length += 1;
            sum = self.gather(&before, sum);
            self.length -= 1;
        }
        sum
    }
}

/// The speed limits of a lane for traffic that comes onto it by one way, or by any.
#[derive(Clone, Copy)]
pub(crate) struct Limits<'a, F> {
    pub(crate) lane: Lane<'a>,
    /// Signs that hold where it comes onto the lane.
    pub(crate) signs: SpeedSigns<'a>,
    /// What it carries into a junction: asked for only where nothing else is stated.
    pub(crate) carried: F,
}

impl<'a, F: Fn() -> Carried> Limits<'a, F> {
    /// What holds at s, which lies within the lane's section.
    pub(crate) fn at(&self, s: f64) -> SpeedRule {
        let stated = self.stated_at(s);
        stated.unwrap_or_else(|| self.unstated(SpeedRecords::at(&self.lane, s).road_type()))
    }

    /// What a sign, the lane's record or the road's type says at s.
    pub(crate) fn stated_at(&self, s: f64) -> Option<SpeedRule> {
        let signs = self.lane.speed_signs_after(self.signs, Some(s));
        of_signs(&signs).or_else(|| SpeedRecords::at(&self.lane, s).rule())
    }

    /// What holds where nothing is stated, on a type of road: in a junction what comes in, before the header's regulations.
    fn unstated(&self, road_type: Option<u8>) -> SpeedRule {
        let carried = self.lane.is_in_junction().then(|| (self.carried)().rule);
        carried.flatten().unwrap_or_else(|| self.lane.default_speed(road_type))
    }

    /// The lowest limit where the limit depends.
    fn lowest(&self, signs: &SpeedSigns<'_>, records: &SpeedRecords<'_>) -> Option<f64> {
        let default = || self.lane.default_speed(records.road_type()).max;
        let carried = || {
            let carried = (self.carried)();
            if carried.is_open { lower(carried.lowest, default()) } else { carried.lowest }
        };
        let without_signs = || match records.rule() {
            Some(rule) => rule.max,
            None if self.lane.is_in_junction() => carried(),
            None => default(),
        };
        match signs.zone {
            // Some way may be in no zone.
            Zone::Depends(sign) => {
                let lowest = sign.map_or(Some(LOWEST), |sign| sign.value());
                lower(lowest, without_signs())
            }
            _ => without_signs(),
        }
    }

    /// The stretches from one end of the lane's section to the other, in ascending or descending s, without gaps. Two in a row may say the same.
    pub(crate) fn stretches(self, ascending: bool) -> impl Iterator<Item = SpeedStretch> {
        let section = self.lane.section();
        let (start, end) = (section.s_start(), section.s_end());
        let mut at = if ascending { start } else { end };
        let mut records = SpeedRecords::at(&self.lane, at);
        let (mut signs, mut next_sign) = (self.signs, at);
        std::iter::from_fn(move || {
            if if ascending { at >= end } else { at <= start } {
                return None;
            }
            let beyond = |s: f64| if ascending { s > at } else { s < at };
            let nearer = |a: f64, b: f64| if ascending == (b < a) && b != a { b } else { a };
            let last = if ascending { end } else { start };
            if !beyond(next_sign) {
                let ahead = self.lane.speed_signs().filter(|s| beyond(*s));
                next_sign =
                    ahead.fold(if ascending { f64::INFINITY } else { f64::NEG_INFINITY }, nearer);
                let middle = 0.5 * (at + nearer(last, next_sign));
                signs = self.lane.speed_signs_after(self.signs, Some(middle));
            }
            let next_record = if ascending { records.pass(at) } else { records.pass_back(at) };
            let next = nearer(nearer(last, next_sign), next_record);
            let rule = of_signs(&signs)
                .or_else(|| records.rule())
                .unwrap_or_else(|| self.unstated(records.road_type()));
            let lowest = match rule.origin {
                SpeedOrigin::Depends => self.lowest(&signs, &records),
                _ => rule.max,
            };
            let s = SRange { low: at.min(next), high: at.max(next) };
            at = next;
            Some(SpeedStretch { s, rule, lowest })
        })
    }
}

/// What signs say.
fn of_signs(signs: &SpeedSigns<'_>) -> Option<SpeedRule> {
    let sign = match (signs.limit, signs.zone) {
        (Some(sign), _) | (None, Zone::Of(sign)) => sign,
        (None, Zone::None) => return None,
        (None, Zone::Depends(_)) => return Some(DEPENDS),
    };
    Some(rule(sign.value(), SpeedOrigin::Signal, Some(sign.signal_id())))
}

impl SpeedRecords<'_> {
    /// What they state where they stand.
    fn rule(&self) -> Option<SpeedRule> {
        let StatedSpeed { max, is_of_lane } = self.stated()?;
        let origin = if is_of_lane { SpeedOrigin::Lane } else { SpeedOrigin::RoadType };
        Some(rule(max, origin, None))
    }
}

impl<'a> Lane<'a> {
    /// The speed limit at s: sign before lane before road type, in a junction then what came in with the vehicle, before the header's
    /// regulations. s outside the lane's section counts as its nearer end; for one that is not finite nothing is known, nor where the one that goes first
    /// states a limit that cannot be read.
    ///
    /// A sign holds from its place on, in driving direction, until another sign ends or replaces it, over lanes that lead
    /// on alone; that of a zone until a sign ends it, junctions or not, and where lanes of different zones lead to a place the answer
    /// is [`SpeedOrigin::Depends`]. In a junction, where the connecting road has no record of its own, what holds on the lane that leads into it goes on
    /// holding; where several lead to the place and differ, the answer is [`SpeedOrigin::Depends`].
    pub fn speed_rule_at(&self, s: f64) -> SpeedRule {
        if !s.is_finite() {
            return NOTHING;
        }
        let section = self.section();
        self.limits().at(mapd_geometry::clamp(s, section.s_start(), section.s_end()))
    }

    /// The speed limits along the lane, in ascending s without gaps, each as [`Lane::speed_rule_at`] has it between the ends of its stretch; where the limit depends on the
    /// way, with the lowest that may hold.
    pub fn speed_rules(&self) -> impl Iterator<Item = SpeedStretch> + use<'a> {
        let mut all = self.limits().stretches(true).peekable();
        std::iter::from_fn(move || {
            let mut own = all.next()?;
            let same = |next: &SpeedStretch| (next.rule, next.lowest) == (own.rule, own.lowest);
            while let Some(next) = all.next_if(same) {
                own.s.high = next.s.high;
            }
            Some(own)
        })
    }

    /// Every s at which the limit may change, in no order.
    pub(crate) fn speed_breaks(&self) -> impl Iterator<Item = f64> + use<'a> {
        let records = self.speed_rows().iter().map(|row| row.s());
        self.speed_signs().chain(records).chain(self.road().type_rows().iter().map(|row| row.s()))
    }

    /// The limits for traffic that may have come by any way.
    pub(crate) fn limits(&self) -> Limits<'a, impl Fn() -> Carried + Copy + use<'a>> {
        let lane = *self;
        let carried = move || lane.carried_by_all();
        Limits { lane, signs: self.speed_signs_at_entry(), carried }
    }

    /// What all ways carry into the junction that the lane is in.
    pub(crate) fn carried_by_all(&self) -> Carried {
        let mut trail = Trail { lanes: [0; MOST_BEHIND], length: 1, left: MOST_LOOKED_AT };
        if let Some(first) = trail.lanes.first_mut() {
            *first = self.row_number();
        }
        trail.gather(self, None).unwrap_or(Carried::by(None))
    }

    /// What the header's regulations say for a type of road.
    fn default_speed(&self, road_type: Option<u8>) -> SpeedRule {
        let mut defaults = self.map.tables().default_speeds.iter();
        match road_type.and_then(|kind| defaults.find(|row| row.kind() == kind)) {
            Some(row) => rule(Some(row.max()), SpeedOrigin::Default, None),
            None => NOTHING,
        }
    }

    pub(crate) fn is_in_junction(&self) -> bool {
        self.road().junction_row().is_some()
    }

    /// s where the lane's traffic leaves it.
    pub(crate) fn exit_s(&self) -> f64 {
        let section = self.section();
        if self.is_forward() { section.s_end() } else { section.s_start() }
    }
}
