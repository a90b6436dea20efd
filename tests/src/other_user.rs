//! Processes of another user, which only root can start.

use crate::test_domain::TestDomain;
use std::path::Path;
use std::process::Command;

/// A group that daemons share with; no list of groups needs to have it.
pub const GROUP: u32 = 61_002;

/// Whose process it is: a user that no file belongs to.
pub const USER: u32 = 61_001;

/// A program of another user in this domain, in these groups; `None`, with the reason on stderr, where that cannot be done.
pub fn command(place: &TestDomain, groups: &str, program: impl AsRef<Path>) -> Option<Command> {
    let as_other = || {
        let mut command = place.command_of("setpriv");
        command.arg(format!("--reuid={USER}")).arg(format!("--regid={USER}"));
        match groups {
            "" => command.arg("--clear-groups"),
            groups => command.arg(format!("--groups={groups}")),
        };
        command.arg("--no-new-privs").env_remove("MAPD_CACHE");
        command
    };
    // The program may lie in a folder that other users may not enter.
    let reads = as_other().args(["test", "-x"]).arg(program.as_ref()).status();
    if !reads.is_ok_and(|status| status.success()) {
        crate::say(
            "SKIPPED: this user may not start processes of other users, or they may not read the program",
        );
        return None;
    }
    let mut command = as_other();
    command.arg(program.as_ref());
    Some(command)
}
