//! How parts of a curve bend at most, told from their ends alone.

use crate::parametric::Parametric;
use crate::spiral::Spiral;
use glam::DVec2;

/// What holds all along a part of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bends {
    /// The signed curvature `[1/m]`, positive to the left: it is at least the first, and at most the second.
    pub curvature: [f64; 2],
    /// The curvature changes by at most this per metre of the curve `[1/m²]`.
    pub change: f64,
    /// The square of the part's true length is at most this `[m²]`.
    pub squared_length: f64,
}

/// Tells of the parts of a curve one behind the other; see [`Curve::bends_from`](crate::Curve::bends_from).
#[derive(Clone, Copy, Debug)]
pub struct BendsFrom<'a> {
    pub(crate) length: f64,
    /// Where the next part begins; not-a-number once a part was not on the curve.
    pub(crate) u: f64,
    pub(crate) of: Of<'a>,
}

/// What is told of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Of<'a> {
    /// A line or an arc.
    Even(f64),
    Spiral(Spiral<'a>),
    Cubics(CubicsFrom<'a>),
}

impl BendsFrom<'_> {
    /// What holds up to u `[m]`, from where the last part ended. None for a part so long that its ends do not tell, where u is not on
    /// the curve or lies before that end, and for all that follows such a u.
    pub fn up_to(&mut self, u: f64) -> Option<Bends> {
        let is_next = 0.0 <= self.u && self.u <= u && u <= self.length;
        let from = std::mem::replace(&mut self.u, if is_next { u } else { f64::NAN });
        if !is_next {
            return None;
        }
        let squared_length = (u - from) * (u - from);
        match &mut self.of {
            Of::Even(curvature) => {
                Some(Bends { curvature: [*curvature; 2], change: 0.0, squared_length })
            }
            Of::Spiral(spiral) => {
                let (a, b) = (spiral.curvature(from), spiral.curvature(u));
                let curvature = [smaller(a, b), larger(a, b)];
                Some(Bends { curvature, change: spiral.curvature_change(), squared_length })
            }
            Of::Cubics(cubics) => cubics.up_to(u),
        }
    }
}

/// A poly3 or paramPoly3 from one place on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CubicsFrom<'a> {
    parametric: Parametric<'a>,
    /// r''' by the parameter, and its length.
    third: DVec2,
    most_third: f64,
    begin: End,
}

/// The end of a part of cubics.
#[derive(Clone, Copy, Debug)]
struct End {
    parameter: f64,
    /// r' and r'' by the parameter.
    first: DVec2,
    second: DVec2,
    /// r'·r', r' × r'' and r'·r''.
    squared: f64,
    cross: f64,
    along: f64,
}

impl End {
    #[inline]
    fn at(parametric: &Parametric<'_>, u: f64) -> Self {
        let p = parametric.parameter(u);
        let (first, second) = (parametric.cubics.first(p), parametric.cubics.second(p));
        Self {
            parameter: p,
            first,
            second,
            squared: first.length_squared(),
            cross: first.perp_dot(second),
            along: first.dot(second),
        }
    }
}

impl<'a> CubicsFrom<'a> {
    pub(crate) fn new(parametric: Parametric<'a>, u: f64) -> Self {
        let third = parametric.cubics.third();
        let begin = End::at(&parametric, u);
        Self { parametric, third, most_third: third.length(), begin }
    }

    /// None where the speed may fall to 0 on the way, for all that the ends tell.
    ///
    /// Over a step Δ of the parameter, a function leaves what it has at the ends by at most Δ²/8 of its second derivative.
    fn up_to(&mut self, u: f64) -> Option<Bends> {
        let b = End::at(&self.parametric, u);
        let a = std::mem::replace(&mut self.begin, b);
        let (third, most_third) = (self.third, self.most_third);
        let step = b.parameter - a.parameter;
        let off = step * step / 8.0;

        // r'' is linear: longest at an end.
        let squared_second = larger(a.second.length_squared(), b.second.length_squared());
        let (least_squared, most_squared) =
            (smaller(a.squared, b.squared), larger(a.squared, b.squared));
        let most_first = most_squared.sqrt() + off * most_third;

        // r'·r' has the second derivative 2·(r''·r'' + r'·r''').
        let off_squared = off * 2.0 * (squared_second + most_first * most_third);
        let (slow, fast) = (least_squared - off_squared, most_squared + off_squared);
        if !(slow > 0.0 && fast.is_finite()) {
            return None;
        }
        // In the mean a function leaves what it has at the ends by two thirds of that.
        let mean = 0.5 * (a.squared + b.squared) + 2.0 / 3.0 * off_squared;

        // r' × r'' has the derivative r' × r''', which is linear, and the second one r'' × r''', which is the same everywhere.
        let off_cross = off * a.second.perp_dot(third).abs();
        let low = smaller(a.cross, b.cross) - off_cross;
        let high = larger(a.cross, b.cross) + off_cross;
        let most_growth = larger(a.first.perp_dot(third).abs(), b.first.perp_dot(third).abs());

        // r'·r'', half the growth of r'·r', has the second derivative 3·r''·r'''.
        let most_along =
            larger(a.along.abs(), b.along.abs()) + off * 3.0 * squared_second.sqrt() * most_third;

        // The curvature is (r' × r'')/|r'|³, and grows by its derivative by the parameter over |r'|.
        let (slow_cubed, fast_cubed) = (slow * slow.sqrt(), fast * fast.sqrt());
        let inverse = 1.0 / slow;
        let most_cross = larger(low.abs(), high.abs());
        Some(Bends {
            curvature: [
                low / if low < 0.0 { slow_cubed } else { fast_cubed },
                high / if high > 0.0 { slow_cubed } else { fast_cubed },
            ],
            change: inverse * inverse * (most_growth + 3.0 * most_cross * most_along * inverse),
            squared_length: step * step * mean,
        })
    }
}

// One instruction each, where `min` and `max` look for what is not a number: such ends have no length either, and so tell nothing.

fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
