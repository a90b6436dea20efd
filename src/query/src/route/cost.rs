//! What a route costs.

use crate::graph::LaneNode;
use crate::rules::Turn;

/// A bound that a cost keeps, which lets a search go straight for its target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum CostBound {
    /// None: Dijkstra's algorithm.
    #[default]
    None,
    /// By length.
    PerMetre {
        /// Every metre of centre line costs at least this.
        metre: f64,
        /// Every change of lane costs at least this.
        change: f64,
    },
    /// By time.
    PerSecond {
        /// Every second, as [`ShortestTime`] counts them, costs at least this.
        second: f64,
        /// Every change of lane costs at least this.
        change: f64,
    },
}

/// What a route costs. Costs that are negative or no number close the way, as infinite ones do.
pub trait RouteCost {
    /// To pass a node from its beginning to its end.
    fn pass(&self, node: &LaneNode<'_>) -> f64;

    /// To change from a node to one beside it.
    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64;

    /// To go on from a node's end into the next one, beside what both cost: for turns, say. Default nothing.
    #[inline]
    fn enter(&self, _from: &LaneNode<'_>, _to: &LaneNode<'_>) -> f64 {
        0.0
    }

    /// What every way costs at least. Landmarks hold for motor vehicles; others search without.
    fn bound(&self) -> CostBound {
        CostBound::None
    }
}

/// Metres along centre lines.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ShortestLength {
    /// What a change of lane costs `[m]`. Default 20: rather a change than a way round by more than that.
    pub lane_change: f64,
}

/// Seconds as the graph counts them ([`Route::travel_time`](super::Route::travel_time)): at recorded limits, where there is none at an assumed speed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ShortestTime {
    /// What a change of lane costs `[s]`. Default 2.
    pub lane_change: f64,
}

/// Another cost, times a factor for each lane: what bindings and configuration give instead of code.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WithFactors<'f, C> {
    /// The cost without factors.
    pub base: C,
    /// A factor for each lane by its row ([`crate::LaneId::row`]; lanes 0 have rows, too): 1 changes nothing, infinity closes the lane, as does what is negative or
    /// no number. Lanes beyond the slice have the factor 1.
    pub factors: &'f [f64],
}

/// Another cost, and what turns at junctions cost beside it, in its unit; straight on costs nothing. A turn costs where its junction is entered.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WithTurns<C> {
    /// The cost without turns.
    pub base: C,
    /// Of a turn to the left.
    pub left: f64,
    /// Of a turn to the right.
    pub right: f64,
    /// Of a turn back.
    pub back: f64,
}

impl<C: RouteCost> RouteCost for WithTurns<C> {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        self.base.pass(node)
    }

    #[inline]
    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        self.base.change(from, to)
    }

    fn enter(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        let base = self.base.enter(from, to);
        let (Some(before), Some(lane)) = (from.lane(), to.lane()) else { return base };
        let junction = lane.road().junction_row();
        if junction.is_none() || before.road().junction_row() == junction {
            return base;
        }
        // Driven against the lane's own direction, the same bend goes to the other side.
        let along = lane.is_forward() == to.is_forward();
        base + match (lane.turn(), along) {
            (Turn::Straight, _) => 0.0,
            (Turn::Back, _) => self.back,
            (Turn::Left, true) | (Turn::Right, false) => self.left,
            (Turn::Right, true) | (Turn::Left, false) => self.right,
        }
    }

    fn bound(&self) -> CostBound {
        self.base.bound()
    }
}

impl<C> WithFactors<'_, C> {
    /// The factor of a node's lane; none where it closes the lane: nothing times infinity is closed, too.
    #[inline]
    fn factor(&self, node: &LaneNode<'_>) -> Option<f64> {
        let factor = self.factors.get(node.row.lane() as usize).copied().unwrap_or(1.0);
        (0.0..f64::INFINITY).contains(&factor).then_some(factor)
    }
}

impl<C: RouteCost> RouteCost for WithFactors<'_, C> {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        match self.factor(node) {
            Some(factor) => self.base.pass(node) * factor,
            None => f64::INFINITY,
        }
    }

    #[inline]
    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        if self.factor(to).is_some() { self.base.change(from, to) } else { f64::INFINITY }
    }

    #[inline]
    fn enter(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        if self.factor(to).is_some() { self.base.enter(from, to) } else { f64::INFINITY }
    }

    /// Landmarks are bounds as long as no factor is below 1; with one that is, the search goes without.
    fn bound(&self) -> CostBound {
        if self.factors.iter().any(|factor| *factor < 1.0) {
            CostBound::None
        } else {
            self.base.bound()
        }
    }
}

impl Default for ShortestLength {
    fn default() -> Self {
        Self { lane_change: 20.0 }
    }
}

impl Default for ShortestTime {
    fn default() -> Self {
        Self { lane_change: 2.0 }
    }
}

impl RouteCost for ShortestLength {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        node.length()
    }

    #[inline]
    fn change(&self, _: &LaneNode<'_>, _: &LaneNode<'_>) -> f64 {
        self.lane_change
    }

    fn bound(&self) -> CostBound {
        CostBound::PerMetre { metre: 1.0, change: self.lane_change }
    }
}

impl RouteCost for ShortestTime {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        node.travel_time()
    }

    #[inline]
    fn change(&self, _: &LaneNode<'_>, _: &LaneNode<'_>) -> f64 {
        self.lane_change
    }

    fn bound(&self) -> CostBound {
        CostBound::PerSecond { second: 1.0, change: self.lane_change }
    }
}
