//! What the daemon says while it runs.

use std::io::Write;

/// Says something to the operator.
pub(crate) fn say(message: &str) {
    // A closed stderr is no reason to stop serving.
    let _ = writeln!(std::io::stderr(), "mapd: {message}");
}
