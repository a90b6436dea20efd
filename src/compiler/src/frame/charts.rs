//! Two projections in a row, as polynomials on squares of the plane.
//!
//! A projection costs microseconds, a map has millions of points, and over two kilometres the way from one plane to another
//! is as good as a polynomial of low degree. Squares are computed when they are first asked for and depend on nothing but
//! their place, so that the result is the same for any number of threads.

use glam::{DVec2, DVec3};
use mapd_geodesy::Projector;
use mapd_geometry::Chart;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::{Arc, PoisonError, RwLock};

/// Side of a square `[m]`; a power of two, so that differences from its centre are exact.
const SIDE: f64 = 2048.0;
/// How far beyond a place of a square its polynomial still holds `[m]`.
const REACH: f64 = 1024.0;
/// Half the side of what a polynomial is fitted to `[m]`.
const HALF: f64 = 0.5 * SIDE + REACH;
/// Terms of a polynomial in one direction: the first left out is of the order of (2 km / 6,378 km)⁵ · 2 km, 1e-14 m, where a
/// projection bends as much as the Earth does; [`TOLERANCE`] bounds it where one bends more.
const TERMS: usize = 5;
/// Distance of a polynomial from the projections that a square may have `[m]`. Only next to a pole or the edge of a
/// projection is it more than the rounding of coordinates, some nanometres.
const TOLERANCE: f64 = 1e-6;
/// What the largest distance seen is multiplied by to bound those that are not.
const UNSEEN: f64 = 1.5;
/// Number of squares along an axis that there is room for: beyond, no projection has coordinates.
const FARTHEST: f64 = 1e9 / SIDE;

/// The way from one plane to another through the place on Earth.
#[derive(Clone, Debug)]
pub(crate) struct Way {
    pub(crate) from: Projector,
    pub(crate) to: Projector,
}

impl Way {
    /// The exact image of a point; none outside the area of either projection.
    pub(crate) fn image(&self, point: DVec3) -> Option<DVec3> {
        let place = self.from.to_geodetic(point).ok()?;
        // The inverse of some projections is good to 0.1 µm only; once more makes it good to nanometres.
        let again = self.from.from_geodetic(place).ok()?;
        let place = self.from.to_geodetic(point + (point - again)).ok()?;
        let image = self.to.from_geodetic(place).ok()?;
        image.is_finite().then_some(image)
    }
}

/// A square's polynomials: x and y of the image relative to that of the centre, in units of [`HALF`].
#[derive(Debug)]
struct Square {
    center: DVec2,
    origin: DVec2,
    terms: [[DVec2; TERMS]; TERMS],
    error: f64,
}

/// A square in use.
#[derive(Clone, Debug)]
pub(crate) struct Local(Arc<Square>);

impl Local {
    /// Image of a point, both inertial `[m]`.
    pub(crate) fn whole(&self, point: DVec2) -> DVec2 {
        self.0.origin + self.image(point - self.0.center)
    }

    /// Derivatives of the image by x and by y at a point, inertial.
    pub(crate) fn slopes_at(&self, point: DVec2) -> [DVec2; 2] {
        self.slopes(point - self.0.center)
    }

    /// Bound of the distance of images from the exact ones `[m]`.
    pub(crate) fn error(&self) -> f64 {
        self.0.error
    }

    /// Whether the polynomials hold at a point.
    pub(crate) fn holds(&self, point: DVec2) -> bool {
        (point - self.0.center).abs().max_element() <= HALF
    }
}

impl Chart for Local {
    fn center(&self) -> DVec2 {
        self.0.center
    }

    fn origin(&self) -> DVec2 {
        self.0.origin
    }

    fn reach(&self) -> f64 {
        REACH
    }

    fn image(&self, point: DVec2) -> DVec2 {
        let at = point / HALF;
        self.0.terms.iter().rev().fold(DVec2::ZERO, |value, row| {
            value * at.x + row.iter().rev().fold(DVec2::ZERO, |inner, c| inner * at.y + *c)
        })
    }

    fn slopes(&self, point: DVec2) -> [DVec2; 2] {
        let at = point / HALF;
        let (mut by_x, mut by_y, mut value) = (DVec2::ZERO, DVec2::ZERO, DVec2::ZERO);
        for row in self.0.terms.iter().rev() {
            let (inner, slope) = row
                .iter()
                .rev()
                .fold((DVec2::ZERO, DVec2::ZERO), |(v, s), c| (v * at.y + *c, s * at.y + v));
            (by_x, by_y, value) = (by_x * at.x + value, by_y * at.x + slope, value * at.x + inner);
        }
        [by_x / HALF, by_y / HALF]
    }
}

/// All squares of a map, those that projections do not reach included.
pub(crate) struct Charts {
    way: Way,
    /// Height of all points `[m]`.
    z: f64,
    basis: Basis,
    squares: RwLock<HashMap<(i64, i64), Option<Local>>>,
}

impl Charts {
    /// Nothing yet, for points at a height `[m]`.
    pub(crate) fn new(way: Way, z: f64) -> Self {
        Self { way, z, basis: Basis::new(), squares: RwLock::default() }
    }

    /// The square that a point lies in; none where a projection does not reach all of it and its surroundings, or bends
    /// without measure.
    pub(crate) fn at(&self, point: DVec2) -> Option<Local> {
        let place = (point / SIDE).round();
        let axis = -FARTHEST..=FARTHEST;
        if !(axis.contains(&place.x) && axis.contains(&place.y)) {
            return None;
        }
        let key = (place.x as i64, place.y as i64);
        {
            let squares = self.squares.read().unwrap_or_else(PoisonError::into_inner);
            if let Some(known) = squares.get(&key) {
                return known.clone();
            }
        }
        let local = self.basis.square(place * SIDE, self.z, &self.way).map(|s| Local(Arc::new(s)));
        let mut squares = self.squares.write().unwrap_or_else(PoisonError::into_inner);
        squares.entry(key).or_insert(local).clone()
    }
}

/// Where squares are sampled, and what turns samples into polynomials.
struct Basis {
    nodes: [f64; TERMS],
    /// Row k: coefficients, in ascending order of power, of the polynomial that is 1 at node k and 0 at the others.
    cardinals: [[f64; TERMS]; TERMS],
}

impl Basis {
    /// At the roots of a Chebyshev polynomial.
    fn new() -> Self {
        let nodes: [f64; TERMS] = std::array::from_fn(|k| {
            -mapd_geometry::cos_sin(PI * (k as f64 + 0.5) / TERMS as f64).0
        });
        let cardinals = std::array::from_fn(|k| {
            let mut product = [0.0; TERMS];
            product[0] = 1.0;
            for (j, node) in nodes.iter().enumerate().filter(|(j, _)| *j != k) {
                let factor = 1.0 / (nodes[k] - node);
                // The product so far has at most j + 1 terms.
                for power in (0..TERMS.min(j + 2)).rev() {
                    let below = if power > 0 { product[power - 1] } else { 0.0 };
                    product[power] = (below - node * product[power]) * factor;
                }
            }
            product
        });
        Self { nodes, cardinals }
    }

    fn square(&self, center: DVec2, z: f64, way: &Way) -> Option<Square> {
        let exact = |x: f64, y: f64| {
            let point = center + DVec2::new(x, y) * HALF;
            Some(way.image(point.extend(z))?.truncate())
        };
        let origin = exact(0.0, 0.0)?;
        let mut terms = [[DVec2::ZERO; TERMS]; TERMS];
        for (i, x) in self.nodes.iter().enumerate() {
            for (j, y) in self.nodes.iter().enumerate() {
                let sample = exact(*x, *y)? - origin;
                for (row, along) in terms.iter_mut().zip(&self.cardinals[i]) {
                    for (term, across) in row.iter_mut().zip(&self.cardinals[j]) {
                        *term += sample * (along * across);
                    }
                }
            }
        }
        // What rounding left there; the image of the centre is the origin itself.
        terms[0][0] = DVec2::ZERO;
        let mut square = Square { center, origin, terms, error: 0.0 };
        let checks = [-1.0, -0.5, 0.5, 1.0];
        let local = Local(Arc::new(square));
        let mut error = 0.0_f64;
        for x in checks {
            for y in checks {
                let image = local.image(DVec2::new(x, y) * HALF);
                error = error.max(UNSEEN * (exact(x, y)? - origin).distance(image));
            }
        }
        square = Arc::into_inner(local.0)?;
        square.error = error;
        (error <= TOLERANCE).then_some(square)
    }
}
