//! What OpenDRIVE means beyond its schema: a catalog of rules, each in one place with its id, severity, meaning, bounds and
//! one valid and one invalid example.
//!
//! A [`Checker`] is shown each top-level element of a document once, then looks at the compact [`Network`] that it kept of
//! them; a [`Examiner`] does the former on any thread. To add a rule, write its function and an entry beside it in a file of [`catalog`].
//!
//! Invariants: rules read, they change nothing, and what they looked at is what is built: records out of order are sorted between
//! the rules on order and all others, and a geometry becomes a curve in [`mod@line`] alone; the document is never whole in memory; nothing panics, whatever a document
//! says. Deliberately absent: a look at what reading and building find, of which the catalog has entries alone, at what the schema says already (see [`structural`]), and any decision about what to do.
//!
//! ```
//! # use mapd_xodr::{Limits, Reader};
//! let map = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="9" junction="-1">
//!   <planView><geometry s="0" x="0" y="0" hdg="0" length="5"><line/></geometry></planView>
//!   <lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road></OpenDRIVE>"#;
//! let mut reader = Reader::new(map.as_bytes(), Limits::default());
//! let mut checker = mapd_rules::Checker::new(&Default::default());
//! while let Some(mut item) = reader.next().unwrap() {
//!     checker.item(&mut item);
//! }
//! checker.finish();
//! let findings = checker.take_findings();
//! assert!(findings.iter().any(|f| f.rule == "asam.net:xodr:1.9.0:road.length_sum_geometries"));
//! ```

pub mod catalog;
mod checker;
mod cycles;
mod documentation;
mod examiner;
mod example;
pub mod line;
pub mod network;
mod order;
mod place;
mod profile;
mod rule;
mod settings;
mod shapes;
mod sink;
pub mod structural;
mod walk;
mod whole;

pub use checker::Checker;
pub use documentation::{ERROR, Page, documentation, with_errors};
pub use examiner::{Examined, ExaminedItem, Examiner};
pub use example::Example;
pub use network::{Network, extent};
pub use place::{LaneIn, ObjectIn, RoadIn, SectionIn, Side, SignalIn};
pub use rule::{Check, JointCheck, Minor, NEWEST, Rule, Tolerance};
pub use settings::{Grade, Profile, Settings};
pub use sink::Sink;
pub use whole::Whole;
