//! Objects near a point and in a rectangle.

use super::object::Object;
use super::placement::{ObjectPlacement, PlacementId};
use crate::error::QueryError;
use crate::map::Map;
use crate::packed;
use crate::region::Region;
use glam::DVec2;

/// An object near a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearObject {
    /// Where it stands.
    pub place: PlacementId,
    /// Plan-view distance of the point from what it covers `[m]`; 0 on it.
    pub distance: f64,
}

impl<'a> Map<'a> {
    /// An object where it stands.
    ///
    /// Errors: an id of another map content; a damaged archive.
    pub fn placement(&self, id: PlacementId) -> Result<ObjectPlacement<'a>, QueryError> {
        let object = self.object(id.object)?;
        match id.copy {
            None => Some(object.template()),
            Some(copy) => object.copy(copy),
        }
        .ok_or(QueryError::Corrupt)
    }

    /// Every place of an object whose area comes as near to a point as `radius` `[m]` in plan view, nearest first. `out` is
    /// emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite.
    pub fn objects_near(
        &self,
        point: DVec2,
        radius: f64,
        out: &mut Vec<NearObject>,
    ) -> Result<(), QueryError> {
        out.clear();
        let region = Region::around_circle(point, radius)?;
        self.visit_places(region, |place| {
            let distance = place.distance(point);
            if distance <= radius {
                out.push(NearObject { place: place.placement_id(), distance });
            }
        });
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| a.distance.total_cmp(&b.distance).then(a.place.cmp(&b.place)));
        Ok(())
    }

    /// Every place of an object whose area meets a rectangle in plan view, in the order of their rows. `out` is emptied
    /// first; it grows only if its capacity is too small.
    ///
    /// Errors: a rectangle that is not finite.
    pub fn objects_in(&self, region: Region, out: &mut Vec<PlacementId>) -> Result<(), QueryError> {
        out.clear();
        region.check()?;
        self.visit_places(region, |place| {
            if place.meets(region) {
                out.push(place.placement_id());
            }
        });
        out.sort_unstable();
        Ok(())
    }

    /// Places whose boxes meet a rectangle.
    pub(crate) fn visit_places(&self, region: Region, mut visit: impl FnMut(ObjectPlacement<'a>)) {
        let (map, tables) = (*self, self.tables());
        let index = packed::PackedIndex {
            levels: tables.object_index_levels,
            nodes: tables.object_index_nodes,
            items: tables.object_index_items,
        };
        packed::visit_items(index, region.local(self.origin()), |item| {
            if let Some(place) = map.place_of_item(item) {
                visit(place);
            }
        });
    }

    /// The place that an item of the index names.
    fn place_of_item(&self, item: u32) -> Option<ObjectPlacement<'a>> {
        let tables = self.tables();
        let objects = tables.objects.len() as u32;
        match item.checked_sub(objects) {
            None => Some(Object::new(*self, item)?.template()),
            Some(copy) => {
                let row = tables.object_copies.get(copy as usize)?;
                ObjectPlacement::of_copy(Object::new(*self, row.object())?, copy)
            }
        }
    }
}
