//! The tables of truth, and what follows from them.
//!
//! ```text
//! cargo run -p mapd-schemas            write what has changed
//! cargo run -p mapd-schemas -- --check change nothing; end with 1 if something would change
//! ```
//!
//! Invariant: the output depends on the tables of truth alone, so that running it twice changes nothing.
//!
//! ```
//! let table = mapd_schemas::opendrive::Table::read("opendrive".as_ref()).unwrap();
//! assert!(table.element("Geometry").unwrap().attributes.iter().any(|a| a.name == "hdg"));
//! ```

mod append_code;
mod archive;
mod archive_code;
mod archive_doc;
pub mod decode;
mod ontology;
pub mod opendrive;
mod overlay_code;
mod python_code;

use anyhow::{Context, Result};
use std::path::Path;

/// A file to be written: its path below the workspace and its text, not formatted yet.
pub type Output = (String, String);

/// Everything that follows from the tables of a workspace.
///
/// Errors: a table cannot be read, or says something that cannot be.
pub fn outputs(root: &Path) -> Result<Vec<Output>> {
    let layout = archive::Layout::read(&root.join("schemas/archive.toml"))?;
    let format_page = root.join("docs/format.md");
    let page = std::fs::read_to_string(&format_page)
        .with_context(|| format!("reading {}", format_page.display()))?;
    let folder = "src/archive/src/generated";
    let mut outputs = vec![
        (format!("{folder}/append.rs"), append_code::append(&layout)),
        (format!("{folder}/move_rows.rs"), append_code::move_rows(&layout)),
        (format!("{folder}/known_tables.rs"), archive_code::known_tables(&layout)),
        (format!("{folder}/rows.rs"), archive_code::filled(&layout)),
        (format!("{folder}/tables.rs"), archive_code::tables(&layout)),
        (format!("{folder}/unknown_codes.rs"), archive_code::unknown_codes(&layout)),
        (format!("{folder}/verify_rows.rs"), archive_code::verification(&layout)),
        ("src/python/python/mapd/_layout.py".to_owned(), python_code::layout(&layout)),
    ];
    let rows = archive_code::row_files(&layout).into_iter();
    outputs.extend(rows.map(|(name, code)| (format!("{folder}/{name}"), code)));
    let overlay = archive::Layout::read(&root.join("schemas/overlay.toml"))?;
    let page = archive_doc::splice(&page, "archive.toml", &layout)?;
    let page = archive_doc::splice(&page, "overlay.toml", &overlay)?;
    outputs.push(("docs/format.md".to_owned(), page));
    let rows = overlay_code::files(&overlay).into_iter();
    outputs.extend(rows.map(|(name, code)| (format!("{folder}/{name}"), code)));
    outputs.extend(ontology::outputs(root)?);
    let table = opendrive::Table::read(&root.join("schemas/opendrive"))?;
    outputs.extend(opendrive::outputs(&table)?);
    Ok(outputs)
}
