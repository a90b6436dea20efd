//! What a configuration file says, as the daemon would read it.

use super::finding::Finding;
use crate::daemon::{Configuration, check_name};
use mapd_transport::open_regular;
use std::collections::BTreeSet;
use std::path::Path;

/// Reads the file as the daemon does, and opens each map that it names.
pub(super) fn examine(path: &Path, out: &mut Vec<Finding>) {
    let check = "configuration";
    let configuration = match Configuration::read(path) {
        Ok(configuration) => configuration,
        Err(error) => {
            let advice = "correct it there; docs/service.md lists the keys";
            out.push(Finding::problem(check, format!("{error:#}"), advice));
            return;
        }
    };
    let maps = configuration.maps;
    if maps.is_empty() {
        let found = format!("{}: no maps", path.display());
        out.push(Finding::note(check, found, "add a [[map]], or start with --load"));
        return;
    }
    out.push(Finding::ok(check, format!("{}: {} map(s)", path.display(), maps.len())));
    let mut names = BTreeSet::new();
    for map in maps {
        let found = format!("{}: {}", map.name, map.source.display());
        if let Err(wrong) = check_name(&map.name, &mut names) {
            out.push(Finding::problem("configured map", found, wrong.to_string()));
            continue;
        }
        if let Err(wrong) = map.options.parse() {
            let found = format!("{found}: {wrong:#}");
            out.push(Finding::problem("configured map", found, "correct its options there"));
            continue;
        }
        out.push(match open_regular(&map.source) {
            Ok(_) => Finding::ok("configured map", found),
            Err(error) => Finding::problem(
                "configured map",
                format!("{found}: {error}"),
                "the daemon's user must be able to read this file",
            ),
        });
    }
}
