//! The cubic profile that every OpenDRIVE record along s uses.

/// `a + b·ds + c·ds² + d·ds³`, where `ds` `[m]` is the distance from the start of the record.
///
/// Elevation, superelevation, lane offset, lane width and border records all have this form. The value has the unit of
/// the record (m or rad); nothing is clamped, so a negative width or a `ds` beyond the record is evaluated literally.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cubic {
    /// Value at `ds = 0`.
    pub a: f64,
    /// Slope at `ds = 0` `[per m]`.
    pub b: f64,
    /// Quadratic coefficient `[per m²]`.
    pub c: f64,
    /// Cubic coefficient [per m³].
    pub d: f64,
}

impl Cubic {
    /// The value at `ds` `[m]`.
    #[must_use]
    #[inline]
    pub fn value(&self, ds: f64) -> f64 {
        self.a + ds * (self.b + ds * (self.c + ds * self.d))
    }

    /// The first derivative at `ds` `[m]`.
    #[must_use]
    #[inline]
    pub fn derivative(&self, ds: f64) -> f64 {
        self.b + ds * (2.0 * self.c + ds * (3.0 * self.d))
    }

    /// The second derivative at `ds` `[m]`.
    #[must_use]
    #[inline]
    pub fn second_derivative(&self, ds: f64) -> f64 {
        2.0 * self.c + ds * (6.0 * self.d)
    }

    /// From coefficients in ascending order of power.
    #[must_use]
    #[inline]
    pub fn new([a, b, c, d]: [f64; 4]) -> Self {
        Self { a, b, c, d }
    }
}
