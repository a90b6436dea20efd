//! Archives: opened in constant time, damaged in any way, and defects that came back as tests.

// Attaching costs the same for every size, and nobody but the daemon can write: counted faults, mapped rights.
mod constant_time;
// Damaged archives: typed errors or merely wrong answers, never a panic or a read outside.
mod corruption;
// What is compiled is proved.
mod extremes;
// What is compared of kept archives is complete: each field of each table changes a line of the texts beside them.
mod facts;
// One test for each defect that was found after the fact.
mod regressions;
// Archives of releases of other ages: what this one does not know is left alone, what it would misread is refused by name.
mod releases;
