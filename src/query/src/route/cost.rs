//! What a route costs.

use crate::graph::LaneNode;

/// A bound that a cost keeps, which lets a search go straight for its target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
        /// Every second at the speed limit costs at least this.
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

    /// What every way costs at least. Landmarks hold for motor vehicles; others search without.
    fn bound(&self) -> CostBound {
        CostBound::None
    }
}

/// Metres along centre lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShortestLength {
    /// What a change of lane costs `[m]`. Default 20: rather a change than a way round by more than that.
    pub lane_change: f64,
}

/// Seconds at the speed limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShortestTime {
    /// What a change of lane costs `[s]`. Default 2.
    pub lane_change: f64,
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
