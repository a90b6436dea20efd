//! The tables of `schemas/ontology`, as text.

pub(crate) mod tables;
