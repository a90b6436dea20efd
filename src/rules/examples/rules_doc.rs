//! Writes `docs/rules.md`, the pages of examples and the list of errors in `docs/checks.md` from the catalog. A test proves
//! them clean.

use std::io;
use std::path::Path;

fn main() -> io::Result<()> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    std::fs::create_dir_all(docs.join("rules"))?;
    for mapd_rules::Page { path, text } in mapd_rules::documentation() {
        std::fs::write(docs.join(path), text)?;
    }
    let checks = docs.join("checks.md");
    let page = std::fs::read_to_string(&checks)?;
    let page = mapd_rules::with_errors(&page);
    std::fs::write(checks, page.ok_or_else(|| io::Error::other("checks.md has no list of errors"))?)
}
