//! Writes `docs/rules.md` and the pages of examples from the catalog. A test proves them clean.

use std::io;
use std::path::Path;

fn main() -> io::Result<()> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    std::fs::create_dir_all(docs.join("rules"))?;
    for (path, text) in mapd_rules::documentation() {
        std::fs::write(docs.join(path), text)?;
    }
    Ok(())
}
