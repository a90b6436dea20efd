//! The area that an object covers in plan view.

use super::outline::ObjectOutline;
use super::placement::ObjectPlacement;
use crate::region::{Region, crosses};
use glam::{DVec2, DVec3};
use mapd_archive::ObjectShape;
use mapd_geometry::clamp;
use std::f64::consts::TAU;

/// Corners of the polygon that stands for a circle.
const CIRCLE: u32 = 32;

impl<'a> ObjectPlacement<'a> {
    /// Corners of the area that the object covers, at its foot, inertial `[m]`: those of the first outer outline, of the box,
    /// or of a polygon of 32 corners inside the circle; its origin alone where no extent is written. `out` is emptied
    /// first; it grows only if its capacity is too small.
    pub fn footprint(&self, out: &mut Vec<DVec3>) {
        out.clear();
        match self.shape() {
            ObjectShape::Outlines => {
                let outer = self.outlines().find(ObjectOutline::is_outer);
                if let Some(outline) = outer.or_else(|| self.outlines().next()) {
                    out.extend(outline.positions());
                }
            }
            ObjectShape::Box => out.extend(self.corners()),
            ObjectShape::Cylinder => {
                let (origin, axes, radius) = (self.position(), self.attitude(), self.radius());
                out.extend((0..CIRCLE).map(|i| {
                    let (cos, sin) = mapd_geometry::cos_sin(TAU * f64::from(i) / f64::from(CIRCLE));
                    origin + axes.to_parent(DVec3::new(radius * cos, radius * sin, 0.0))
                }));
            }
            _ => out.push(self.position()),
        }
    }

    /// The lower corners of the box, counter-clockwise from the right front one.
    pub(crate) fn corners(&self) -> [DVec3; 4] {
        let (origin, axes) = (self.position(), self.attitude());
        let (u, v) = (0.5 * self.length(), 0.5 * self.width());
        let at = |u, v| origin + axes.to_parent(DVec3::new(u, v, 0.0));
        [at(u, -v), at(u, v), at(-u, v), at(-u, -v)]
    }

    /// Points along the edge of the area, at most `step` `[m]` apart but for no more than `most` of them, and its origin:
    /// enough to see what it lies on. `out` is emptied first.
    pub fn probes(&self, step: f64, most: usize, out: &mut Vec<DVec2>) {
        out.clear();
        if self.shape() != ObjectShape::Outlines {
            out.push(self.position().truncate());
        }
        let mut around = 0.0;
        self.edges(|a, b, _| around += a.distance(b));
        let step = step.max(around / most.max(1) as f64);
        self.edges(|a, b, _| {
            let parts = clamp((a.distance(b) / step).ceil(), 1.0, most.max(1) as f64) as u32;
            out.extend((0..parts).map(|i| a.lerp(b, f64::from(i) / f64::from(parts))));
        });
    }

    /// Every edge of the outlines or box, in plan view; whether it belongs to something that encloses an area.
    fn edges(&self, mut visit: impl FnMut(DVec2, DVec2, bool)) {
        if self.shape() == ObjectShape::Box {
            let corners = self.corners().map(DVec3::truncate);
            (0..corners.len())
                .for_each(|i| visit(corners[i], corners[(i + 1) % corners.len()], true));
            return;
        }
        for outline in self.outlines() {
            let closed = outline.is_closed();
            let mut before =
                if closed { outline.positions().next_back().map(DVec3::truncate) } else { None };
            for position in outline.positions().map(DVec3::truncate) {
                if let Some(before) = before {
                    visit(before, position, closed);
                }
                before = Some(position);
            }
        }
    }

    /// Distance of a point from the area that the object covers, in plan view `[m]`; 0 on it. A hole is not covered.
    pub fn distance(&self, point: DVec2) -> f64 {
        let from_origin = point.distance(self.position().truncate());
        match self.shape() {
            ObjectShape::Cylinder => return (from_origin - self.radius()).max(0.0),
            ObjectShape::Box | ObjectShape::Outlines => {}
            _ => return from_origin,
        }
        let (mut nearest, mut inside) = (f64::INFINITY, false);
        self.edges(|a, b, encloses| {
            let d = b - a;
            let squared = d.length_squared();
            let along =
                if squared > 0.0 { clamp((point - a).dot(d) / squared, 0.0, 1.0) } else { 0.0 };
            nearest = nearest.min(point.distance(a + d * along));
            inside ^= encloses && crosses(a, b, point);
        });
        match (inside, nearest.is_finite()) {
            (true, _) => 0.0,
            (false, true) => nearest,
            (false, false) => from_origin,
        }
    }

    /// Whether the area that the object covers and a rectangle have a point in common.
    pub fn meets(&self, region: Region) -> bool {
        let origin = self.position().truncate();
        match self.shape() {
            ObjectShape::Cylinder => return region.distance(origin) <= self.radius(),
            ObjectShape::Box | ObjectShape::Outlines => {}
            _ => return region.holds(origin),
        }
        let middle = 0.5 * (region.low + region.high);
        let (mut meets, mut inside, mut any) = (false, false, false);
        self.edges(|a, b, encloses| {
            any = true;
            meets |= region.holds(a) || region.meets(a, b);
            inside ^= encloses && crosses(a, b, middle);
        });
        meets || inside || (!any && region.holds(origin))
    }

    /// The smallest rectangle in plan view that holds the area.
    pub fn bounds(&self) -> Region {
        let origin = self.position().truncate();
        if self.shape() == ObjectShape::Cylinder {
            return Region::around(origin, self.radius());
        }
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        self.edges(|a, b, _| (low, high) = (low.min(a).min(b), high.max(a).max(b)));
        if low.is_finite() && high.is_finite() {
            Region { low, high }
        } else {
            Region { low: origin, high: origin }
        }
    }
}
