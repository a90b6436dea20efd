//! Cubic polynomials of OpenDRIVE's records.

/// a + b·ds + c·ds² + d·ds³, with ds the distance from the record's start (OpenDRIVE 1.8.1, 7.2).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cubic {
    /// Value at the start.
    pub a: f64,
    /// Slope at the start.
    pub b: f64,
    /// Quadratic part.
    pub c: f64,
    /// Cubic part.
    pub d: f64,
}

impl Cubic {
    /// From coefficients in ascending order.
    #[inline]
    pub fn new([a, b, c, d]: [f64; 4]) -> Self {
        Self { a, b, c, d }
    }

    /// Value at ds.
    #[inline]
    pub fn value(&self, ds: f64) -> f64 {
        self.a + ds * (self.b + ds * (self.c + ds * self.d))
    }

    /// First derivative at ds.
    #[inline]
    pub fn derivative(&self, ds: f64) -> f64 {
        self.b + ds * (2.0 * self.c + ds * 3.0 * self.d)
    }

    /// Second derivative at ds.
    #[inline]
    pub fn second_derivative(&self, ds: f64) -> f64 {
        2.0 * self.c + 6.0 * self.d * ds
    }
}
