//! Lanes as polylines, made through the queries that will answer later; and what else is cut into points.

mod allowance;
mod cuts;
mod flatten;
mod lanes;

pub(crate) use allowance::Allowance;
pub(crate) use flatten::{Fault, Sample, distance_to_segment, flatten};
pub(crate) use lanes::{sample as lanes, view};
