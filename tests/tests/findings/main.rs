//! What is wrong with a map is found, named with its place, and takes out no more than it must.

mod asam_checker;
mod broken_parts;
mod building;
mod check;
mod clean_maps;
mod cycles;
mod holes;
mod linked_lanes;
mod mutations;
mod quarantine;
mod quirks;
mod signal_codes;
mod signal_faults;
mod smallest_parts;
mod sources_are_safe;
