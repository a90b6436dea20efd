//! Records along a road stand in the order of s.
//!
//! A record holds from its s on until the next one begins, so that the order in the file says nothing that s does not say:
//! records are sorted, once the rules on their order have looked. What the other rules look at is then what is built.
//! Geometries and lane sections are not: a geometry follows the one before it, and keys of lanes count the sections.

use crate::place::number;
use mapd_xodr::{Attribute, Coefficients, CubicRecord, Road, RoadMark};

/// Sorts records by where they begin; those that begin at one place keep their order.
fn sort<R>(records: &mut [R], start: impl Fn(&R) -> f64) {
    if !records.is_sorted_by(|a, b| start(a) <= start(b)) {
        records.sort_by(|a, b| start(a).total_cmp(&start(b)));
    }
}

fn cubics<R: CubicRecord>(records: &mut [R]) {
    sort(records, |record| record.start().unwrap_or(0.0));
}

fn coefficients(records: &mut [Coefficients]) {
    sort(records, |record| number(&record.s));
}

fn road_marks(marks: &mut [RoadMark]) {
    let start = |mark: &RoadMark| number(&mark.s_offset);
    sort(marks, start);
    marks.iter_mut().for_each(|mark| sort(&mut mark.sway, |sway| number(&sway.ds)));
}

/// Sorts the records of a lane that begin at `sOffset`.
macro_rules! lane {
    ($lane:expr) => {{
        let lane = &mut *$lane;
        let start = |s: &Option<Attribute<f64>>| number(s);
        cubics(&mut lane.width);
        cubics(&mut lane.border);
        road_marks(&mut lane.road_mark);
        sort(&mut lane.height, |record| start(&record.s_offset));
        sort(&mut lane.material, |record| start(&record.s_offset));
        sort(&mut lane.speed, |record| start(&record.s_offset));
        sort(&mut lane.access, |record| start(&record.s_offset));
        sort(&mut lane.rule, |record| start(&record.s_offset));
    }};
}

/// Sorts all records of a road but for geometries and lane sections.
pub(crate) fn sort_records(road: &mut Road) {
    sort(&mut road.r#type, |record| number(&record.s));
    if let Some(profile) = &mut road.elevation_profile {
        cubics(&mut profile.elevation);
    }
    if let Some(profile) = &mut road.lateral_profile {
        cubics(&mut profile.superelevation);
        cubics(&mut profile.crossfall);
        sort(&mut profile.shape, |shape| number(&shape.s));
        for station in profile.shape.chunk_by_mut(|a, b| number(&a.s) == number(&b.s)) {
            sort(station, |shape| number(&shape.t));
        }
        if let Some(surface) = &mut profile.cross_section_surface {
            if let Some(offset) = &mut surface.t_offset {
                coefficients(&mut offset.coefficients);
            }
            for strip in surface.surface_strips.iter_mut().flat_map(|strips| &mut strips.strip) {
                if let Some(of) = &mut strip.width {
                    coefficients(&mut of.coefficients);
                }
                if let Some(of) = &mut strip.constant {
                    coefficients(&mut of.coefficients);
                }
                if let Some(of) = &mut strip.linear {
                    coefficients(&mut of.coefficients);
                }
                if let Some(of) = &mut strip.quadratic {
                    coefficients(&mut of.coefficients);
                }
                if let Some(of) = &mut strip.cubic {
                    coefficients(&mut of.coefficients);
                }
            }
        }
    }
    for lanes in &mut road.lanes {
        cubics(&mut lanes.lane_offset);
        for section in &mut lanes.lane_section {
            let sides = [&mut section.left, &mut section.right].into_iter().flatten();
            for side in sides {
                for lane in &mut side.lane {
                    lane!(lane);
                    sort(&mut lane.visibility, |record| number(&record.s_offset));
                }
            }
            for lane in section.center.iter_mut().flat_map(|center| &mut center.lane) {
                lane!(lane);
            }
        }
    }
}
