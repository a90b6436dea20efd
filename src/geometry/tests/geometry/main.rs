//! Curves, surfaces and transforms against what their definitions give, computed by other means.
#![allow(clippy::disallowed_methods, reason = "what is compared with may come from the system")]

mod double;
mod oracle;

mod accuracy;
mod bends;
mod extended_precision;
mod hostile;
mod projection;
mod rates;
mod surface;
mod transform;
