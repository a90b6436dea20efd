//! Shapes that were compiled before. Networks repeat a few bends thousands of times, and fitting a parametric cubic takes longer than all else
//! about it.

use mapd_geometry::{CompileError, Compiled, ParameterRange, Primitive, compile};
use std::cell::RefCell;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Shapes that a thread remembers.
const SHAPES: usize = 128;

/// Most coefficients of a shape that is remembered: a thread holds no more than 256 KiB of them.
const COEFFICIENTS: usize = 256;

/// All that a parametric cubic is compiled from, by its bits: what is equal to the last bit compiles to the same.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Written {
    numbers: [u64; 8],
    is_normalized: bool,
    length: u64,
}

impl Written {
    /// None of shapes that are compiled as fast as they are found.
    fn new(primitive: &Primitive, length: f64) -> Option<Self> {
        let Primitive::ParamPoly3 { u, v, range } = primitive else { return None };
        let mut numbers = [0; 8];
        for (place, number) in numbers.iter_mut().zip(u.iter().chain(v)) {
            *place = number.to_bits();
        }
        let is_normalized = *range == ParameterRange::Normalized;
        Some(Self { numbers, is_normalized, length: length.to_bits() })
    }

    /// Where it is remembered: others that belong there replace it.
    fn place(&self) -> usize {
        let mut hasher = DefaultHasher::new();
        self.hash(&mut hasher);
        hasher.finish() as usize % SHAPES
    }
}

/// Shapes by their places; all are empty until one is remembered.
type Remembered = Vec<Option<(Written, Compiled)>>;

thread_local! {
    static REMEMBERED: RefCell<Remembered> = const { RefCell::new(Vec::new()) };
}

/// As [`compile`], which always gives the same for the same.
pub(crate) fn compiled(primitive: &Primitive, length: f64) -> Result<Compiled, CompileError> {
    let Some(written) = Written::new(primitive, length) else { return compile(primitive, length) };
    let place = written.place();
    REMEMBERED.with_borrow_mut(|remembered| {
        if let Some(Some((known, compiled))) = remembered.get(place)
            && *known == written
        {
            return Ok(compiled.clone());
        }
        let compiled = compile(primitive, length)?;
        if compiled.coefficients.len() <= COEFFICIENTS {
            remembered.resize(SHAPES, None);
            if let Some(room) = remembered.get_mut(place) {
                *room = Some((written, compiled.clone()));
            }
        }
        Ok(compiled)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shapes, most of which differ from another one in a single number, or in its sign alone.
    fn shapes() -> Vec<(Primitive, f64)> {
        let bends = (0..SHAPES / 2).map(|i| {
            let c = 0.01 * i as f64;
            ([0.0, 10.0, 0.0, 0.0], [0.0, 0.0, c, -0.5 * c], 10.0 + c)
        });
        let of_ranges = bends.flat_map(|(u, v, length)| {
            let opposite = v.map(|number: f64| -number);
            [ParameterRange::Normalized, ParameterRange::ArcLength].into_iter().flat_map(
                move |range| [v, opposite].map(|v| (Primitive::ParamPoly3 { u, v, range }, length)),
            )
        });
        let others = [
            (Primitive::Line, 10.0),
            (Primitive::Arc { curvature: 0.1 }, 10.0),
            (Primitive::Arc { curvature: f64::NAN }, 10.0),
            (
                Primitive::ParamPoly3 {
                    u: [0.0; 4],
                    v: [0.0; 4],
                    range: ParameterRange::Normalized,
                },
                1.0,
            ),
        ];
        of_ranges.chain(others).collect()
    }

    #[test]
    fn what_is_remembered_is_what_would_be_compiled() {
        let bits = |made: Result<Compiled, CompileError>| {
            made.map(|compiled| {
                compiled.coefficients.iter().map(|c| c.to_bits()).collect::<Vec<_>>()
            })
            .map_err(|error| error.to_string())
        };
        let shapes = shapes();
        // Each twice at once, and all again when others have replaced them.
        let mut remembered = 0;
        for (primitive, length) in shapes.iter().flat_map(|shape| [shape; 2]).chain(&shapes) {
            let expected = bits(compile(primitive, *length));
            assert_eq!(bits(compiled(primitive, *length)), expected, "{primitive:?}");
            let Some(written) = Written::new(primitive, *length) else { continue };
            let found = REMEMBERED.with_borrow(|all| all.get(written.place()).cloned().flatten());
            remembered += usize::from(found.is_some_and(|(known, _)| known == written));
        }
        // All but those that cannot be compiled or take too much room.
        assert!(remembered > 2 * shapes.len(), "{remembered} of {}", 3 * shapes.len());
    }
}
