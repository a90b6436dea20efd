//! Rules on roads by themselves.

mod plan_view;
mod poly;
mod records;

use crate::rule::Rule;

pub(super) static RULES: &[&[Rule]] = &[plan_view::RULES, poly::RULES, records::RULES];
