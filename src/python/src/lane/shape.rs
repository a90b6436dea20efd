//! What a lane is made of at s: edges, height, marks, surface.

use super::Lane;
use crate::batch::{fields, material, result};
use crate::errors::query;
use crate::input::{finite, triple};
use crate::object::Object;
use mapd_client::roads::RoadMark;
use pyo3::prelude::*;

/// x, y, z [m] of the left and of the right edge.
type Bounds = ((f64, f64, f64), (f64, f64, f64));

fn mark<'py>(py: Python<'py>, mark: &RoadMark<'_>) -> PyResult<Bound<'py, PyAny>> {
    let fields = fields!(
        py,
        s = mark.s(),
        s_end = mark.s_end(),
        kind = mark.kind().name(),
        color = mark.color().name(),
        width = mark.width_or_default(),
    );
    result(py, "RoadMark", &fields)
}

#[pymethods]
impl Lane {
    /// t [m] of the inner and of the outer edge at s [m], on its road.
    fn edges_at(&self, s: f64) -> PyResult<(f64, f64)> {
        let edges = self.lane()?.edges_at(finite(s).map_err(query)?);
        Ok((edges.inner, edges.outer))
    }

    /// Left and right edge at s [m] as its traffic has them; None where it has no area.
    fn bounds_at(&self, s: f64) -> PyResult<Option<Bounds>> {
        let bounds = self.lane()?.bounds_at(finite(s).map_err(query)?);
        Ok(bounds.map(|[left, right]| (triple(left), triple(right))))
    }

    /// How far the inner and the outer edge lie above the road [m] at s [m], as `<height>` writes it.
    fn height_at(&self, s: f64) -> PyResult<(f64, f64)> {
        let height = self.lane()?.height_at(finite(s).map_err(query)?);
        Ok((height.inner, height.outer))
    }

    /// Length of the centre line between two places [m] in plan view.
    fn length_between(&self, s_from: f64, s_to: f64) -> PyResult<f64> {
        let [from, to] = [s_from, s_to].map(finite);
        Ok(self.lane()?.length_between(from.map_err(query)?, to.map_err(query)?))
    }

    /// The surface at s [m] as `<material>` writes it; None where nothing is written.
    fn material_at<'py>(&self, py: Python<'py>, s: f64) -> PyResult<Option<Bound<'py, PyAny>>> {
        material(py, self.lane()?.material_at(finite(s).map_err(query)?))
    }

    /// Marks on its outer border, or on the centre line for lane 0, by s.
    fn road_marks<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.lane()?.road_marks().map(|one| mark(py, &one)).collect()
    }

    /// The mark on its outer border at s [m].
    fn road_mark_at<'py>(&self, py: Python<'py>, s: f64) -> PyResult<Option<Bound<'py, PyAny>>> {
        let found = self.lane()?.road_mark_at(finite(s).map_err(query)?);
        found.map(|one| mark(py, &one)).transpose()
    }

    /// Objects that are on the lane or belong to it.
    fn objects(&self) -> PyResult<Vec<Object>> {
        let objects = self.lane()?.objects().filter_map(|one| one.object());
        Ok(objects.map(|one| Object::new(&self.held, one.object_id())).collect())
    }
}
