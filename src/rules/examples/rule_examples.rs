//! Writes both examples of every rule as whole files into a folder: `rule_examples FOLDER`. For comparing with other checkers.

use std::io;
use std::path::Path;

fn main() -> io::Result<()> {
    let Some(folder) = std::env::args().nth(1) else {
        return Err(io::Error::other("expected a folder"));
    };
    std::fs::create_dir_all(&folder)?;
    for rule in mapd_rules::catalog::all() {
        let name = rule.id.replace(':', "_");
        for (kind, example) in [("valid", rule.valid), ("invalid", rule.invalid)] {
            let Some(document) = example.document(rule.example_version()) else { continue };
            let path = Path::new(&folder).join(format!("{name}.{kind}.xodr"));
            std::fs::write(path, document)?;
        }
    }
    Ok(())
}
