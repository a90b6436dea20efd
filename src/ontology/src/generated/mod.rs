//! The tables of `schemas/ontology`, as text.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

mod cn;
mod de;
mod lights;
mod opendrive;
mod se;
mod semantics;
mod us;
mod vendors;

/// Name of each file and its text.
pub(crate) const TABLES: &[(&str, &str)] = &[
    ("cn.toml", cn::TEXT),
    ("de.toml", de::TEXT),
    ("lights.toml", lights::TEXT),
    ("opendrive.toml", opendrive::TEXT),
    ("se.toml", se::TEXT),
    ("semantics.toml", semantics::TEXT),
    ("us.toml", us::TEXT),
    ("vendors.toml", vendors::TEXT),
];
