//! A part of a poly3 or paramPoly3 by the parameter of its cubics: there it is smooth, where arc length comes in pieces.

use crate::parametric::{Cubics, Parametric};

/// A part of such a curve; see [`Curve::cubic_part`](crate::Curve::cubic_part).
#[derive(Clone, Copy, Debug)]
pub struct CubicPart<'a> {
    cubics: Cubics<'a>,
    from: f64,
    to: f64,
}

impl<'a> Parametric<'a> {
    /// The part between two u; none where rounding leaves nothing of it.
    pub(crate) fn part(&self, from: f64, to: f64) -> Option<CubicPart<'a>> {
        let [from, to] = [from, to].map(|u| self.parameter(u));
        (from < to).then_some(CubicPart { cubics: self.cubics, from, to })
    }
}

impl CubicPart<'_> {
    /// The parameter at both ends, ascending.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Metres of the curve per unit of the parameter, and its signed curvature there `[1/m]`, positive to the left.
    #[must_use]
    #[inline]
    pub fn speed_and_curvature(&self, parameter: f64) -> [f64; 2] {
        self.cubics.speed_and_curvature(parameter)
    }
}
