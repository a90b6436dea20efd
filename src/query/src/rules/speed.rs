//! Which speed limit holds on a lane, and who says so.

use super::speed_signs::{SpeedSigns, Zone};
use crate::ids::SignalId;
use crate::lane::Lane;
use crate::lane_length::stated;

/// Lanes of a junction that are followed back at most; a damaged archive might lead round in a circle.
const MOST_PIECES: usize = 64;
/// Lanes that lead to a place in a junction that are compared at most.
const MOST_ENTRIES: usize = 64;

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

/// Nothing is known.
const NOTHING: SpeedRule = SpeedRule { max: None, origin: SpeedOrigin::None, signal: None };
/// Which limit holds depends on the way that one has come.
const DEPENDS: SpeedRule = SpeedRule { max: None, origin: SpeedOrigin::Depends, signal: None };

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
        let s = mapd_geometry::clamp(s, section.s_start(), section.s_end());
        if let Some(written) = self.written_speed(s) {
            return written;
        }
        let entry = self.speed_at_entry();
        if let Some(entry) = entry {
            return entry;
        }
        self.default_speed(s)
    }

    /// What the header's regulations say for the road's type at s; nothing else is looked at.
    pub(crate) fn default_speed(&self, s: f64) -> SpeedRule {
        let kind = self.road().types().take_while(|record| record.s <= s).last();
        let kind = kind.map(|record| record.kind.code());
        let mut defaults = self.map.tables().default_speeds.iter();
        match kind.and_then(|kind| defaults.find(|row| row.kind() == kind)) {
            Some(row) => {
                let (max, origin) = (Some(row.max()), SpeedOrigin::Default);
                SpeedRule { max, origin, signal: None }
            }
            None => NOTHING,
        }
    }

    /// What holds where the junction is entered, for a lane of one; none elsewhere and where nothing is known of the entries.
    fn speed_at_entry(&self) -> Option<SpeedRule> {
        self.road().junction_row()?;
        let (map, mut common) = (self.map, None::<SpeedRule>);
        // What is written on an earlier lane of the junction goes on holding, too.
        let mut lane = *self;
        for _ in 0..MOST_PIECES {
            let mut before = lane.predecessors().filter_map(|id| Lane::new(map, id.row()));
            let sole = before.next().filter(|_| before.next().is_none());
            match sole.filter(|sole| sole.road().junction_row() == self.road().junction_row()) {
                Some(sole) => match sole.written_speed(sole.exit_s()) {
                    Some(written) => {
                        return Some(SpeedRule { origin: SpeedOrigin::Entry, ..written });
                    }
                    None => lane = sole,
                },
                None => break,
            }
        }
        for id in lane.predecessors().take(MOST_ENTRIES) {
            let entry = Lane::new(map, id.row())?;
            let own = entry.written_speed(entry.exit_s());
            let (max, signal) = own.map_or((None, None), |own| (own.max, own.signal));
            match &mut common {
                None => common = Some(SpeedRule { max, origin: SpeedOrigin::Entry, signal }),
                Some(known) if known.max != max => return Some(DEPENDS),
                Some(known) if known.signal != signal => known.signal = None,
                Some(_) => {}
            }
        }
        common.filter(|rule| rule.max.is_some())
    }

    /// s where the lane's traffic leaves it.
    pub(crate) fn exit_s(&self) -> f64 {
        let section = self.section();
        if self.is_forward() { section.s_end() } else { section.s_start() }
    }

    /// What a sign, the lane's record or the road's type says at s.
    fn written_speed(&self, s: f64) -> Option<SpeedRule> {
        self.speed_with(self.speed_signs_at_entry(), s)
    }

    /// As `written_speed`, for a vehicle that has entered the lane with these signs.
    pub(crate) fn speed_with(&self, entry: SpeedSigns<'_>, s: f64) -> Option<SpeedRule> {
        let signs = self.speed_signs_after(entry, Some(s));
        let sign = match (signs.limit, signs.zone) {
            (Some(sign), _) | (None, Zone::Of(sign)) => Some(sign),
            (None, Zone::None) => None,
            (None, Zone::Depends) => return Some(DEPENDS),
        };
        if let Some(sign) = sign {
            return Some(rule(sign.value(), SpeedOrigin::Signal, Some(sign.signal_id())));
        }
        let own = self.speeds().take_while(|record| record.s <= s).last();
        if let Some(max) = own.and_then(|record| stated(record.kind, record.max)) {
            return Some(rule(max, SpeedOrigin::Lane, None));
        }
        let of_road = self.road().types().take_while(|record| record.s <= s).last();
        let max = of_road.and_then(|record| stated(record.speed_kind, record.speed))?;
        Some(rule(max, SpeedOrigin::RoadType, None))
    }
}

/// A limit that somebody states; of one that cannot be read nothing is known.
fn rule(max: Option<f64>, origin: SpeedOrigin, signal: Option<SignalId>) -> SpeedRule {
    if max.is_some() { SpeedRule { max, origin, signal } } else { NOTHING }
}
