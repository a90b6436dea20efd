//! Records along a road stand in the order of s.
//!
//! A record holds from its s on until the next one begins, so that the order in the file says nothing that s does not say:
//! records are sorted, once the rules on their order have looked. What the other rules look at is then what is built.
//! Geometries are if they are one line then; else it is unclear which one each of them continues. Lane sections are not, as keys of lanes count them.

use crate::line::ReferenceLine;
use crate::place::number;
use mapd_xodr::{Attribute, Coefficients, CubicRecord, Geometry, PlanView, Road, RoadMark};

/// The geometries of a road or junction in the order of s, if they are not and are one line then: each begins where the one before it ends, along s, in
/// place and in heading.
pub(crate) fn sorted_line(plan_view: &PlanView) -> Option<Vec<Geometry>> {
    let start = |geometry: &Geometry| number(&geometry.s);
    if plan_view.geometry.is_sorted_by(|a, b| start(a) <= start(b)) {
        return None;
    }
    let mut sorted = plan_view.clone();
    sorted.geometry.sort_by(|a, b| start(a).total_cmp(&start(b)));
    ReferenceLine::new(Some(&sorted)).is_whole().then_some(sorted.geometry)
}

/// A pass over all records of a road but lane sections.
struct Pass {
    /// Whether records are sorted that are not; else nothing is changed.
    is_sorting: bool,
    /// Whether all were sorted before.
    were_sorted: bool,
}

impl Pass {
    /// Records by where they begin; those that begin at one place keep their order.
    fn sort<R>(&mut self, records: &mut [R], start: impl Fn(&R) -> f64) {
        if !records.is_sorted_by(|a, b| start(a) <= start(b)) {
            self.were_sorted = false;
            if self.is_sorting {
                records.sort_by(|a, b| start(a).total_cmp(&start(b)));
            }
        }
    }

    fn cubics<R: CubicRecord>(&mut self, records: &mut [R]) {
        self.sort(records, |record| record.start().unwrap_or(0.0));
    }

    fn coefficients(&mut self, records: &mut [Coefficients]) {
        self.sort(records, |record| number(&record.s));
    }

    fn road_marks(&mut self, marks: &mut [RoadMark]) {
        let start = |mark: &RoadMark| number(&mark.s_offset);
        self.sort(marks, start);
        marks.iter_mut().for_each(|mark| self.sort(&mut mark.sway, |sway| number(&sway.ds)));
    }
}

/// Passes over the records of a lane that begin at `sOffset`.
macro_rules! lane {
    ($pass:ident, $lane:expr) => {{
        let lane = &mut *$lane;
        let start = |s: &Option<Attribute<f64>>| number(s);
        $pass.cubics(&mut lane.width);
        $pass.cubics(&mut lane.border);
        $pass.road_marks(&mut lane.road_mark);
        $pass.sort(&mut lane.height, |record| start(&record.s_offset));
        $pass.sort(&mut lane.material, |record| start(&record.s_offset));
        $pass.sort(&mut lane.speed, |record| start(&record.s_offset));
        $pass.sort(&mut lane.access, |record| start(&record.s_offset));
        $pass.sort(&mut lane.rule, |record| start(&record.s_offset));
    }};
}

impl Pass {
    fn over(mut self, road: &mut Road) -> Self {
        if let Some(plan_view) = &mut road.plan_view
            && let Some(sorted) = sorted_line(plan_view)
        {
            self.were_sorted = false;
            if self.is_sorting {
                plan_view.geometry = sorted;
            }
        }
        self.sort(&mut road.r#type, |record| number(&record.s));
        if let Some(profile) = &mut road.elevation_profile {
            self.cubics(&mut profile.elevation);
        }
        if let Some(profile) = &mut road.lateral_profile {
            self.cubics(&mut profile.superelevation);
            self.cubics(&mut profile.crossfall);
            self.sort(&mut profile.shape, |shape| number(&shape.s));
            for station in profile.shape.chunk_by_mut(|a, b| number(&a.s) == number(&b.s)) {
                self.sort(station, |shape| number(&shape.t));
            }
            if let Some(surface) = &mut profile.cross_section_surface {
                if let Some(offset) = &mut surface.t_offset {
                    self.coefficients(&mut offset.coefficients);
                }
                for strip in surface.surface_strips.iter_mut().flat_map(|strips| &mut strips.strip)
                {
                    if let Some(of) = &mut strip.width {
                        self.coefficients(&mut of.coefficients);
                    }
                    if let Some(of) = &mut strip.constant {
                        self.coefficients(&mut of.coefficients);
                    }
                    if let Some(of) = &mut strip.linear {
                        self.coefficients(&mut of.coefficients);
                    }
                    if let Some(of) = &mut strip.quadratic {
                        self.coefficients(&mut of.coefficients);
                    }
                    if let Some(of) = &mut strip.cubic {
                        self.coefficients(&mut of.coefficients);
                    }
                }
            }
        }
        for lanes in &mut road.lanes {
            self.cubics(&mut lanes.lane_offset);
            for section in &mut lanes.lane_section {
                let sides = [&mut section.left, &mut section.right].into_iter().flatten();
                for side in sides {
                    for lane in &mut side.lane {
                        lane!(self, lane);
                        self.sort(&mut lane.visibility, |record| number(&record.s_offset));
                    }
                }
                for lane in section.center.iter_mut().flat_map(|center| &mut center.lane) {
                    lane!(self, lane);
                }
            }
        }
        self
    }
}

/// Whether all records of a road are in order, but for lane sections, and geometries that are no line in any order. (It is not changed.)
pub(crate) fn are_records_sorted(road: &mut Road) -> bool {
    Pass { is_sorting: false, were_sorted: true }.over(road).were_sorted
}

/// Sorts all records of a road but for these.
pub(crate) fn sort_records(road: &mut Road) {
    Pass { is_sorting: true, were_sorted: true }.over(road);
}
