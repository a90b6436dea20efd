//! Layers of a road's lanes (1.9): what is there for good, and what replaces it for a time.

use crate::attribute::Value as _;
use crate::generated::{Lane, LaneSection, Lanes, LayerType, Road};

impl Road {
    /// The lanes that are there for good: the first ones whose layer is not `temporary`. Before 1.9 all are.
    pub fn permanent_lanes(&self) -> Option<&Lanes> {
        self.lanes.iter().find(|lanes| lanes.layer.value() != Some(LayerType::Temporary))
    }

    /// The lanes that replace others for a time: the first ones whose layer is `temporary`.
    pub fn temporary_lanes(&self) -> Option<&Lanes> {
        self.lanes.iter().find(|lanes| lanes.layer.value() == Some(LayerType::Temporary))
    }

    /// Sections of the lanes that are there for good; empty where there are none.
    pub fn permanent_sections(&self) -> &[LaneSection] {
        self.permanent_lanes().map_or(&[], |lanes| &lanes.lane_section)
    }
}

impl LaneSection {
    /// Lanes with a width: those to the left, then those to the right, in file order.
    pub fn side_lanes(&self) -> impl Iterator<Item = &Lane> {
        let sides = [self.left.as_deref(), self.right.as_deref()];
        sides.into_iter().flatten().flat_map(|side| &side.lane)
    }
}
