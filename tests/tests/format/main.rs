//! Archives: opened in constant time, damaged in any way, and defects that came back as tests.

mod constant_time;
mod corruption;
mod extremes;
mod facts;
mod regressions;
mod releases;
