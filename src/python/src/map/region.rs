//! What lies in a rectangle, beside lanes, signals and objects.

use super::Map;
use crate::batch::columns;
use crate::errors::query;
use crate::held::{content, id};
use crate::input::{classes_of, region_of, types_of};
use crate::object::placement;
use crate::room::Column;
use mapd_client::LaneTypes;
use mapd_client::glam::DVec2;
use mapd_client::roads::BoundarySegment;
use pyo3::prelude::*;

impl Map {
    /// lane, s of both ends, x, y, z of both ends.
    fn segment_columns<'a>(&self, all: impl Iterator<Item = &'a BoundarySegment>) -> Vec<Column> {
        let content = content(self.map());
        let (mut lanes, mut numbers) = (Vec::new(), std::array::from_fn::<_, 8, _>(|_| Vec::new()));
        for one in all {
            lanes.push(id(content, one.lane.row()));
            let [a, b] = one.ends;
            let values = [one.s[0], one.s[1], a.x, a.y, a.z, b.x, b.y, b.z];
            numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        let mut columns = vec![Column::Ids(lanes)];
        columns.extend(numbers.into_iter().map(Column::Numbers));
        columns
    }
}

#[pymethods]
impl Map {
    /// As landmarks_near, of those in a rectangle (x_min, y_min, x_max, y_max) [m]: signals first, then objects, and no distance.
    #[pyo3(signature = (region, *, classes = None))]
    fn landmarks_in<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
        classes: Option<Vec<String>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (region, mut found) = (region_of(region), Vec::new());
        self.map().landmarks_in(region, classes_of(classes)?, &mut found).map_err(query)?;
        found.iter().map(|one| crate::sensing::landmark(py, &self.0, one)).collect()
    }

    /// Pieces of the borders of lanes in a rectangle (x_min, y_min, x_max, y_max) [m], by their lanes.
    #[pyo3(signature = (region, *, types = None))]
    fn boundary_segments<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
        types: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
        let (mut lanes, mut found) = (Vec::new(), Vec::new());
        self.map()
            .boundary_segments(region_of(region), types, &mut lanes, &mut found)
            .map_err(query)?;
        columns(py, "BoundarySegments", self.segment_columns(found.iter()))
    }

    /// As boundary_segments, where they carry road marks: cut where one mark ends and another begins.
    #[pyo3(signature = (region, *, types = None))]
    fn road_mark_segments<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
        types: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
        let (mut lanes, mut borders, mut found) = (Vec::new(), Vec::new(), Vec::new());
        self.map()
            .road_mark_segments(region_of(region), types, &mut lanes, &mut borders, &mut found)
            .map_err(query)?;
        let mut all = vec![
            Column::Codes(found.iter().map(|one| one.kind.code() as i8).collect()),
            Column::Codes(found.iter().map(|one| one.color.code() as i8).collect()),
            Column::Numbers(found.iter().map(|one| one.width).collect()),
        ];
        all.extend(self.segment_columns(found.iter().map(|one| &one.segment)));
        columns(py, "RoadMarkSegments", all)
    }

    /// As objects_near, with the place of each instead of the object.
    fn placements_near<'py>(
        &self,
        py: Python<'py>,
        point: (f64, f64),
        radius: f64,
    ) -> PyResult<Vec<(Bound<'py, PyAny>, f64)>> {
        let mut found = Vec::new();
        let point = DVec2::new(point.0, point.1);
        self.map().objects_near(point, radius, &mut found).map_err(query)?;
        let place = |near: &mapd_client::objects::NearObject| {
            let own = self.map().placement(near.place).map_err(query)?;
            Ok((placement(py, &self.0, &own)?, near.distance))
        };
        found.iter().map(place).collect()
    }

    /// As objects_in, with the place of each instead of the object.
    fn placements_in<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let mut found = Vec::new();
        self.map().objects_in(region_of(region), &mut found).map_err(query)?;
        let place = |id: &mapd_client::objects::PlacementId| {
            placement(py, &self.0, &self.map().placement(*id).map_err(query)?)
        };
        found.iter().map(place).collect()
    }
}
