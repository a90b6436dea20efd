//! Signals near a point and in a rectangle, by where they stand.

use super::Signal;
use crate::error::QueryError;
use crate::ids::SignalId;
use crate::map::Map;
use crate::packed;
use crate::region::Region;
use glam::DVec2;

/// A signal near a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearSignal {
    /// The signal.
    pub signal: SignalId,
    /// Plan-view distance of the point from where it stands `[m]`.
    pub distance: f64,
}

impl<'a> Map<'a> {
    /// Every signal that stands as near to a point as `radius` `[m]` in plan view, nearest first, whatever lanes it is for.
    /// `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite.
    pub fn signals_near(
        &self,
        point: DVec2,
        radius: f64,
        out: &mut Vec<NearSignal>,
    ) -> Result<(), QueryError> {
        out.clear();
        let region = Region::around_circle(point, radius)?;
        self.visit_signals(region, |signal| {
            let distance = signal.position().truncate().distance(point);
            if distance <= radius {
                out.push(NearSignal { signal: signal.signal_id(), distance });
            }
        });
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| {
            a.distance.total_cmp(&b.distance).then(a.signal.cmp(&b.signal))
        });
        Ok(())
    }

    /// Every signal that stands in a rectangle in plan view, in the order of their rows. `out` is emptied first; it grows
    /// only if its capacity is too small.
    ///
    /// Errors: a rectangle that is not finite.
    pub fn signals_in(&self, region: Region, out: &mut Vec<SignalId>) -> Result<(), QueryError> {
        out.clear();
        region.check()?;
        self.visit_signals(region, |signal| out.push(signal.signal_id()));
        out.sort_unstable();
        Ok(())
    }

    /// Signals that stand in a rectangle, in no order.
    pub(crate) fn visit_signals(&self, region: Region, mut visit: impl FnMut(Signal<'a>)) {
        let (map, tables) = (*self, self.tables());
        let index = packed::PackedIndex {
            levels: tables.signal_index_levels,
            nodes: tables.signal_index_nodes,
            items: tables.signal_index_items,
        };
        packed::visit_items(index, region.local(self.origin()), |item| {
            let signal = Signal::new(map, item);
            signal
                .filter(|signal| region.holds(signal.position().truncate()))
                .into_iter()
                .for_each(&mut visit);
        });
    }
}
