//! mapd for Python: the module `mapd._mapd`, on which the package `mapd` stands.
//!
//! Batches first: arrays are taken in under the interpreter's lock, answered without it, and handed back as named columns. What points
//! into a map keeps its mapping alive. A process that was forked off may read what it inherited and never gives back what is its
//! parent's.
//!
//! Invariants: no query panics or changes a map; no thread, signal handler or output; every wait has a deadline and heeds signals of
//! Python's. Deliberately absent: what needs no Rust (`python/mapd`: columns, results, errors, views).

mod along;
mod batch;
mod client;
mod compile;
mod copies;
mod errors;
mod ground;
mod held;
mod input;
mod junction;
mod lane;
mod map;
mod matching;
mod object;
mod path;
mod propose;
mod raw;
mod request;
mod road;
mod room;
mod route;
mod sensing;
mod signal;
mod tracker;
mod view;

use mapd_client::vocabulary::{
    AnnotationKind, AnnotationOwner, Class, ConflictKind, ContactPoint, EdgeKind,
    JunctionGroupKind, LaneType, QuarantinedKind, Relation, RelationReason, RoadMarkColor,
    RoadMarkKind, StructureKind, VehicleClass,
};
use pyo3::prelude::*;
use std::collections::BTreeMap;

/// Words by their codes.
fn words<T>(all: &[T], of: impl Fn(&T) -> (u8, &'static str)) -> BTreeMap<u8, &'static str> {
    all.iter().map(of).collect()
}

/// Words by their codes, of every vocabulary of which tables have codes and answers words.
fn vocabularies() -> BTreeMap<&'static str, BTreeMap<u16, &'static str>> {
    macro_rules! words_of {
        ($($name:literal = $type:ident),* $(,)?) => {
            BTreeMap::from([$((
                $name,
                $type::ALL.iter().chain([&$type::Unknown]).map(|one| (u16::from(one.code()), one.name())).collect(),
            )),*])
        };
    }
    words_of! {
        "annotation_kind" = AnnotationKind,
        "annotation_owner" = AnnotationOwner,
        "class" = Class,
        "conflict_kind" = ConflictKind,
        "contact_point" = ContactPoint,
        "edge_kind" = EdgeKind,
        "junction_group_kind" = JunctionGroupKind,
        "lane_type" = LaneType,
        "quarantined_kind" = QuarantinedKind,
        "relation" = Relation,
        "relation_reason" = RelationReason,
        "road_mark_color" = RoadMarkColor,
        "road_mark_kind" = RoadMarkKind,
        "structure_kind" = StructureKind,
        "vehicle_class" = VehicleClass,
    }
}

/// The compiled part of `mapd`.
#[pymodule]
fn _mapd(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add_class::<client::Client>()?;
    m.add_class::<client::Events>()?;
    m.add_class::<map::Map>()?;
    m.add_class::<lane::Lane>()?;
    m.add_class::<road::Road>()?;
    m.add_class::<junction::Junction>()?;
    m.add_class::<signal::Signal>()?;
    m.add_class::<object::Object>()?;
    m.add_class::<path::Path>()?;
    m.add_class::<view::View>()?;
    m.add_class::<tracker::Tracker>()?;
    m.add_class::<route::LaneSequences>()?;
    m.add_class::<room::Memory>()?;
    m.add_function(wrap_pyfunction!(map::open_archive, m)?)?;
    m.add_function(wrap_pyfunction!(compile::read_file, m)?)?;
    m.add_function(wrap_pyfunction!(along::outline, m)?)?;
    m.add_function(wrap_pyfunction!(propose::propose, m)?)?;
    m.add("NONE", input::NONE_ID)?;
    m.add(
        "LANE_TYPES",
        words(mapd_client::vocabulary::LaneType::ALL, |one| (one.code(), one.name())),
    )?;
    m.add(
        "MARK_KINDS",
        words(mapd_client::vocabulary::RoadMarkKind::ALL, |one| (one.code(), one.name())),
    )?;
    m.add(
        "MARK_COLORS",
        words(mapd_client::vocabulary::RoadMarkColor::ALL, |one| (one.code(), one.name())),
    )?;
    m.add("WORDS", vocabularies())?;
    m.add("SPEED_ORIGINS", batch::SPEED_ORIGINS)?;
    m.add("EDGES", along::EDGES)?;
    m.add("TRACKED", tracker::STATES)?;
    m.add("__version__", env!("CARGO_PKG_VERSION"))
}
