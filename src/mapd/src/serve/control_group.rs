//! Memory limits of control groups, version 1 and 2: a process beyond them is killed by the kernel.

use super::memory::field;
use std::fs;
use std::path::Path;

/// A version of control groups: where it is mounted and what its files are called.
struct Version {
    root: &'static str,
    limit: &'static str,
    usage: &'static str,
    /// Fields of `memory.stat`: cached files, which the kernel takes back by itself. Shared memory is not among them.
    cached: [&'static str; 2],
}

const V1: Version = Version {
    root: "/sys/fs/cgroup/memory",
    limit: "memory.limit_in_bytes",
    usage: "memory.usage_in_bytes",
    cached: ["total_inactive_file", "total_active_file"],
};

const V2: Version = Version {
    root: "/sys/fs/cgroup",
    limit: "memory.max",
    usage: "memory.current",
    cached: ["inactive_file", "active_file"],
};

/// Bytes that the tightest of this process's groups and those around it leaves; `None` without limits.
pub(crate) fn available() -> Option<u64> {
    groups(&fs::read_to_string("/proc/self/cgroup").ok()?)
        .filter_map(|(version, own)| {
            let root = Path::new(version.root);
            // In a container the path may be the host's, of which only the root is mounted: it is among the ancestors.
            let own = root.join(own.trim_start_matches('/'));
            own.ancestors()
                .take_while(|folder| folder.starts_with(root))
                .filter_map(|folder| left_in(folder, version))
                .min()
        })
        .min()
}

/// The groups that limit memory, as `/proc/self/cgroup` names them: `0::/path` and `4:cpu,memory:/path`.
fn groups(text: &str) -> impl Iterator<Item = (&'static Version, &str)> {
    text.lines().filter_map(|line| {
        let mut parts = line.splitn(3, ':');
        let (number, controllers, path) = (parts.next()?, parts.next()?, parts.next()?);
        match controllers {
            "" if number == "0" => Some((&V2, path)),
            _ if controllers.split(',').any(|name| name == "memory") => Some((&V1, path)),
            _ => None,
        }
    })
}

/// What a group leaves; `None` if it has no limit or no such files.
fn left_in(folder: &Path, version: &Version) -> Option<u64> {
    let read = |name: &str| fs::read_to_string(folder.join(name)).ok();
    let limit: u64 = read(version.limit)?.trim().parse().ok()?;
    let usage: u64 = read(version.usage)?.trim().parse().ok()?;
    let stat = read("memory.stat").unwrap_or_default();
    let cached: u64 = version.cached.iter().filter_map(|name| field(&stat, name)).sum();
    Some(limit.saturating_sub(usage.saturating_sub(cached)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_of_both_versions_are_found() {
        let text = "9:name=systemd:/\n4:cpu,memory:/a/b:c\n3:cpuset:/\n0::/d\n";
        let found: Vec<_> = groups(text).map(|(version, path)| (version.limit, path)).collect();
        assert_eq!(found, [(V1.limit, "/a/b:c"), (V2.limit, "/d")]);
    }

    #[test]
    fn what_a_group_leaves() {
        let folder = tempfile::tempdir().expect("a folder");
        let folder = folder.path();
        let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
        for version in [&V1, &V2] {
            assert_eq!(left_in(folder, version), None, "no controller, no limit");
            write(version.limit, "1000\n");
            write(version.usage, "700\n");
            write("memory.stat", "");
            assert_eq!(left_in(folder, version), Some(300));
            write(
                "memory.stat",
                &format!("rss 1\n{} 50\n{} 40\n", version.cached[0], version.cached[1]),
            );
            assert_eq!(left_in(folder, version), Some(390));
            write(version.limit, "max\n");
            assert_eq!(left_in(folder, version), None, "no limit set");
        }
    }
}
