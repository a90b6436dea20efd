//! What is wrong with a map is found, named with its place, and takes out no more than it must.

// What ASAM's checker finds in the files of its own tests, mapd finds too: the same rule, as bad, as often.
mod asam_checker;
// Every shape, reference, dependency and controller, valid and broken.
mod broken_parts;
// What only building finds has an entry in the catalog, whose examples behave as they say and which a configuration grades.
mod building;
// The maps that generators write are what those write, and the quarter has no finding in any profile.
mod carried_maps;
// What `mapd check` says, and how it ends.
mod check;
// The maps of CARLA, esmini and RoadRunner have no errors but those that docs/checks.md justifies.
mod clean_maps;
// How many findings are kept does not decide what is left out.
mod counted_parts;
// Cycles that a map must not have are errors like others: the policy decides what is left out for them.
mod cycles;
// An error takes its part out of the map, or rejects the map.
mod errors;
// What is missing is said once.
mod follow_on;
// What the command line says and does about a map that lost parts.
mod holes;
// What links of lanes break, within a road, between roads and through the connections of junctions.
mod linked_lanes;
// Seeded mutations of good maps: none is accepted silently with another answer, unless what it changes is lawful either way.
mod mutations;
// One broken part of each kind: the map still loads, its neighbours answer, ways do not cross the hole, and answers near it say so.
mod quarantine;
// Every map of the shared corpus is read to its end, and each of its known quirks is found or tolerated on purpose.
mod quirks;
// Steps, bends and numbers that are easily missed.
mod easily_missed;
// What signals and objects write in place of a country's code or a unit.
mod signal_codes;
// Signals that are wrong or odd: findings, not crashes, and the rest of the map stays.
mod signal_faults;
// A fault takes out no more than cannot be used for it.
mod smallest_parts;
// Commands that write never write over what they read, however it is named.
mod sources_are_safe;
