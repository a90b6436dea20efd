//! What makes XML well-formed beyond what quick-xml looks at: names, white space between attributes, duplicates, references,
//! `]]>`, the declaration, the document type, one root with nothing around it. Characters are looked at by the
//! [`source`](crate::source).
//!
//! Pure functions of pieces of markup, which add to [`Faults`]; [`Structure`] follows the order of the pieces; [`scan()`] puts
//! all of it together. libxml2 is the judge: `tests/differential/well_formed.py` compares the two on mutated documents.
//!
//! Deliberately absent: namespaces (an unbound prefix is no matter of well-formedness) and everything in a document type,
//! which is never applied.

mod fault;
mod name;
mod scan;
mod structure;
mod tag;
mod text;

pub use fault::{Fault, Faults};
pub use name::is_name;
pub use scan::{Scan, scan};
pub use structure::Structure;
pub use tag::{Attribute, Attributes, duplicates};
pub use text::{comment, declaration, instruction, references, text};
