//! What is wrong with a map is found, named with its place, and takes out no more than it must.

mod broken_parts;
mod check;
mod clean_maps;
mod cycles;
mod holes;
mod mutations;
mod quarantine;
mod quirks;
mod signal_faults;
mod sources_are_safe;
