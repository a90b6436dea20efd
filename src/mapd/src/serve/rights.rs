//! Rights of what iceoryx2 creates for everybody.

use mapd_transport::{Domain, SHARED_MEMORY_FOLDER};
use std::fs::Permissions;
use std::io;
use std::os::unix::fs::PermissionsExt;

/// Suffix of iceoryx2's counter of nodes, one for each domain and version.
pub(crate) const NODE_COUNTER: &str = ".global_mgmt";

/// Rights of a domain's files: its user alone.
const OWN: u32 = 0o600;

/// Removes other users' rights to the counter of nodes: iceoryx2 0.10 lets everybody write it, whatever the umask. A process that
/// truncates a file that others have mapped kills them with SIGBUS.
///
/// Errors: what the system says.
pub(crate) fn tighten(domain: &Domain) -> io::Result<()> {
    for entry in std::fs::read_dir(SHARED_MEMORY_FOLDER)? {
        let entry = entry?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(domain.prefix()) && name.ends_with(NODE_COUNTER) {
            std::fs::set_permissions(entry.path(), Permissions::from_mode(OWN))?;
        }
    }
    Ok(())
}
