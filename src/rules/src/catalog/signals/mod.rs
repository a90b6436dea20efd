//! Rules on signals, boards and controllers.

mod basics;
mod boards;
mod controllers;

use crate::rule::Rule;

pub(super) static RULES: &[&[Rule]] = &[basics::RULES, boards::RULES, controllers::RULES];
