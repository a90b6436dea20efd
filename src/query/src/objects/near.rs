//! Objects near a point and in a rectangle, through a packed R-tree of 16 children a node.

use super::object::Object;
use super::placement::{ObjectPlacement, PlacementId};
use crate::error::QueryError;
use crate::map::Map;
use crate::region::Region;
use glam::DVec2;
use mapd_archive::Tables;

/// Children of a node.
const WIDTH: usize = 16;
/// Levels of the index: 16⁸ places. A damaged archive may state more.
const LEVELS: usize = 8;
/// Places on the search stack: 15 siblings on each of these levels and some more.
const STACK: usize = 160;

/// An object near a point.
#[derive(Clone, Copy, Debug, PartialEq)]
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
        if !(point.is_finite() && radius.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        self.visit_places(Region::around(point, radius.max(0.0)), |place| {
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
    fn visit_places(&self, region: Region, mut visit: impl FnMut(ObjectPlacement<'a>)) {
        let (low, high) = (region.low - self.origin(), region.high - self.origin());
        let map = *self;
        items_in(self.tables(), low, high, |item| {
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

/// Items of the index whose boxes meet a box, relative to the local origin.
fn items_in(tables: &Tables<'_>, low: DVec2, high: DVec2, mut visit: impl FnMut(u32)) {
    let depth = tables.object_index_levels.len().checked_sub(1);
    let Some(depth) = depth.filter(|depth| (1..=LEVELS).contains(depth)) else { return };
    let (low_x, low_y, high_x, high_y) = (low.x as f32, low.y as f32, high.x as f32, high.y as f32);
    let mut stack = [(0u32, 0u32); STACK];
    let mut top = 1;
    while top > 0 {
        top -= 1;
        let Some((level, at)) = stack.get(top).copied() else { return };
        if level as usize >= depth {
            tables.object_index_items.get(at as usize).copied().into_iter().for_each(&mut visit);
            continue;
        }
        let first = tables.object_index_levels.get(level as usize).copied().unwrap_or(0);
        let node = tables.object_index_nodes.get(first.wrapping_add(at) as usize);
        let Some(node) = node else { continue };
        let (min_x, min_y, max_x, max_y) = (node.min_x(), node.min_y(), node.max_x(), node.max_y());
        for k in 0..WIDTH {
            let meets =
                min_x[k] <= high_x && max_x[k] >= low_x && min_y[k] <= high_y && max_y[k] >= low_y;
            if !meets {
                continue;
            }
            let Some(place) = stack.get_mut(top) else { return };
            *place = (level + 1, at.wrapping_mul(WIDTH as u32).wrapping_add(k as u32));
            top += 1;
        }
    }
}
