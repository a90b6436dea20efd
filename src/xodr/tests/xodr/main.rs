//! What reading yields: values, findings and their places, in whatever form a document comes, and a bound on time and memory for hostile ones.

mod bombs;
mod findings;
mod forms;
mod fuzzed;
mod includes;
mod mutations;
mod prefixes;
mod source;
mod values;
mod well_formed;
