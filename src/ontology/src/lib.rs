//! Maps what OpenDRIVE, countries and vendors call signals and objects to one vocabulary.
//!
//! The vocabulary is [`Class`]; the mapping is data (`schemas/ontology`, `docs/ontology.md`), which a user's file extends or
//! overrides. Nothing here knows a country by name.
//!
//! Invariants: an [`Ontology`] is read once and never changes; looking up never fails, it gives `Unknown`. Deliberately
//! absent: files, and where signals stand.
//!
//! ```
//! use mapd_ontology::{Class, Ontology, SignalCode};
//!
//! let ontology = Ontology::standard();
//! let code = SignalCode { country: "DE", r#type: "274", subtype: "55", ..SignalCode::default() };
//! let meaning = ontology.signal(&code);
//! assert_eq!(meaning.class, Class::SpeedLimit);
//! assert!((meaning.value.unwrap() - 50.0 / 3.6).abs() < 1e-12);
//! ```

mod entry;
mod file;
mod generated;
mod light;
mod lookup;
mod pattern;
mod value;

pub use file::OntologyError;
pub use light::{Light, arrow, bulb, phase};
pub use lookup::{Meaning, ObjectCode, Ontology, SignalCode};
pub use mapd_archive::{Class, ClassGroup};
