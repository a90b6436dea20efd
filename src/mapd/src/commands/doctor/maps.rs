//! The maps that are served: who serves them, in which versions, and whether attaching works.

use super::domain::segments;
use super::finding::{Finding, size};
use crate::control::{AskError, Request, ask};
use crate::faults::minor_faults;
use mapd_archive::FORMAT;
use mapd_client::{Attach, Client, Domain};
use mapd_transport::{MapStatus, TRANSPORT_REVISION, list_maps, revision_of};
use std::time::{Duration, Instant};

/// Suffix of iceoryx2's counters of nodes, of which there is one for each version.
const NODE_COUNTER: &str = ".global_mgmt";

/// The version of iceoryx2 that is built in: all processes of a domain need the same.
pub(super) const ICEORYX2: &str = "0.10.0";

/// Longest wait for a daemon's own account.
const ANSWER: Duration = Duration::from_secs(2);

/// Bytes of a page.
const PAGE: usize = 4096;

/// Examines what is served; attaches to every map, waiting so long.
pub(super) fn examine(domain: &Domain, wait: Duration, out: &mut Vec<Finding>) {
    out.push(Finding::ok(
        "versions",
        format!(
            "mapd {}, iceoryx2 {ICEORYX2}, transport revision {TRANSPORT_REVISION}, archive format {FORMAT}",
            env!("CARGO_PKG_VERSION")
        ),
    ));
    let other = versions_in_use(domain).find(|version| version != ICEORYX2);
    if let Some(version) = other {
        out.push(Finding::problem(
            "versions",
            format!("iceoryx2 {version} is in use in this domain"),
            "use daemon and clients of one release; end what is of another, or take another --prefix",
        ));
    }
    let maps = match list_maps(domain) {
        Ok(maps) => maps,
        Err(error) => {
            out.push(Finding::problem("maps", error.to_string(), "see root folder"));
            return;
        }
    };
    if maps.is_empty() {
        out.push(Finding::ok("maps", "none is served"));
    }
    for map in maps {
        one(domain, &map, wait, out);
    }
}

/// Versions of iceoryx2 that have made nodes in the domain: their counters are named `…_node.0_10_0.global_mgmt`.
fn versions_in_use(domain: &Domain) -> impl Iterator<Item = String> {
    segments(domain).into_iter().filter_map(|(path, _)| {
        let name = path.file_name()?.to_str()?.strip_suffix(NODE_COUNTER)?.to_owned();
        Some(name.rsplit_once("_node.")?.1.replace('_', "."))
    })
}

fn one(domain: &Domain, map: &MapStatus, wait: Duration, out: &mut Vec<Finding>) {
    let MapStatus { name, alive, info, .. } = map;
    if !alive {
        out.push(Finding::problem(
            "daemon",
            format!(
                "{name}: its daemon was killed; readers keep what they hold, newcomers find what was served last"
            ),
            format!("start it again: mapd --load FILE --name {name}"),
        ));
        return;
    }
    let pid = info.map_or_else(|| "unknown".to_owned(), |info| info.daemon_pid.to_string());
    let asked = ask(domain, name, &Request::Status, ANSWER);
    if matches!(asked, Err(AskError::Late { .. })) {
        out.push(Finding::problem(
            "daemon",
            format!("{name}: process {pid} does not answer"),
            format!("it is stopped or hangs; if kill -CONT {pid} does not help, kill it and start it again"),
        ));
        return;
    }
    out.push(Finding::ok("daemon", format!("{name}: process {pid}")));
    if let Some(revision) = revision_of(domain, name)
        && revision != TRANSPORT_REVISION
    {
        out.push(Finding::problem(
            "versions",
            format!("{name}: served with transport revision {revision}"),
            "use daemon and clients of one release; end the old daemon and start this release's",
        ));
    }
    out.push(attach(Attach::Observer, domain, name, wait));
    // Subscribers write, and are the daemon's own user for that.
    if domain.owner() == rustix::process::geteuid().as_raw() {
        out.push(attach(Attach::Subscriber, domain, name, wait));
    }
}

/// Attaches as a client does, and touches every page.
fn attach(how: Attach, domain: &Domain, name: &str, wait: Duration) -> Finding {
    let check = if how == Attach::Subscriber { "subscribe" } else { "attach" };
    let start = Instant::now();
    let before = minor_faults();
    let client = match Client::connect_as(how, domain, name, wait) {
        Ok(client) => client,
        Err(error) => {
            let advice = "that message says what to do; if it is about iceoryx2, all processes need the same version";
            return Finding::problem(check, format!("{name}: {error}"), advice);
        }
    };
    let (attached, taken) = (minor_faults(), start.elapsed());
    let snapshot = client.snapshot();
    let bytes = snapshot.bytes();
    let start = Instant::now();
    let sum = bytes.iter().step_by(PAGE).fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
    std::hint::black_box(sum);
    let faults = minor_faults().saturating_sub(attached);
    Finding::ok(
        check,
        format!(
            "{name}: generation {} in {taken:.1?} with {} page faults; reading all of its {} took {faults} more and {:.1?}",
            snapshot.generation(),
            attached.saturating_sub(before),
            size(bytes.len() as u64),
            start.elapsed()
        ),
    )
}
