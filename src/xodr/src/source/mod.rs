//! From the bytes of a file to text that XML can be read from, with places.
//!
//! [`Inputs`] opens the files of one document; each is a [`Source`], a `BufRead` of valid UTF-8. Gzip is recognised by its
//! first bytes, the encoding by byte order mark or declaration. [`Places`] turns offsets back into file, line and column.
//!
//! Invariants: memory is bounded by the limits whatever the input is; text is never replaced silently; nothing is fetched.

mod characters;
mod encoding;
mod gzip;
mod include;
mod limits;
mod line_index;
mod note;
mod places;
mod prolog;
mod text;

pub(crate) use characters::is_legal;
pub use include::{IncludeRefusal, Inputs};
pub use limits::SourceLimits;
pub use line_index::{LineIndex, Position};
pub use note::{Note, NoteKind, Refusal, RefusalKind};
pub use places::{NearPlaces, Places, SourceLocation};
pub use text::Source;
pub(crate) use text::WINDOW;
