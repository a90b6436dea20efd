//! The map under test: served by a daemon that runs, or by this process for the time of the benchmark.

use crate::clock::since_epoch;
use crate::serve::{PublishMeta, Server, StopSignal};
use crate::source::{self, Attaching, Compiling, Opened, Source};
use anyhow::{Context, Result, bail};
use mapd_archive::LAYOUT_ID;
use mapd_client::{Client, Domain, Snapshot};
use mapd_compiler::{CompileOptions, ReadOptions};
use mapd_transport::list_maps;
use std::fs::File;
use std::io::Write;
use std::os::unix::fs::OpenOptionsExt;
use std::path::PathBuf;
use std::sync::mpsc;
use std::time::Duration;

/// Name of the map that this process serves.
const NAME: &str = "bench";

/// Longest wait for this process's own server.
const WAIT: Duration = Duration::from_secs(10);

/// A map in shared memory, and a file of the same bytes.
pub(crate) struct Served {
    pub(crate) domain: Domain,
    pub(crate) name: String,
    pub(crate) snapshot: Snapshot,
    pub(crate) file: PathBuf,
    _client: Client,
}

/// Removes a file at the end.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        // Nothing more can be done about a file that cannot be removed.
        let _ = std::fs::remove_file(&self.0);
    }
}

/// Has `work` run on a served map: on that of a running daemon for `shm:NAME`, and where no source is named and a daemon
/// serves just one map; on one that this process serves meanwhile, in a domain of its own, for a file.
///
/// Errors: no source; it cannot be read, is rejected or does not fit into shared memory; what `work` says.
pub(crate) fn with<T>(
    source: Option<&Source>,
    attaching: Attaching<'_>,
    work: impl FnOnce(&Served) -> Result<T>,
) -> Result<T> {
    let source = match source {
        None => &Source::Live(the_only_map(attaching.domain)?),
        Some(source) => source,
    };
    let path = match source {
        Source::File(path) => path,
        Source::Live(name) => {
            let Attaching { domain, attach, wait } = attaching;
            let client = Client::connect_as(attach, domain, name, wait)?;
            let snapshot = client.snapshot();
            let copy = copy_of(&snapshot)?;
            let (domain, name, file) = (domain.clone(), name.clone(), copy.0.clone());
            return work(&Served { domain, name, snapshot, file, _client: client });
        }
    };
    let (reading, options) = (ReadOptions::default(), CompileOptions::default());
    let compiling = Compiling { reading: &reading, options: &options };
    let opened = source::open(source, compiling, attaching, &mut |_| {})?;
    let archive = match opened {
        Opened::Map(snapshot, _) => snapshot,
        Opened::Rejected(_) => bail!("{source} is rejected; `mapd check {source}` says why"),
    };
    // Clients are told of the file in words.
    let is_named = source::is_archive(path) && path.to_str().is_some();
    let copy = (!is_named).then(|| copy_of(&archive)).transpose()?;
    let file = copy.as_ref().map_or_else(|| path.clone(), |copy| copy.0.clone());
    serve_meanwhile(&archive, |domain| {
        let client = Client::connect_as(attaching.attach, domain, NAME, WAIT)?;
        let snapshot = client.snapshot();
        let (domain, name) = (domain.clone(), NAME.to_owned());
        work(&Served { domain, name, snapshot, file, _client: client })
    })
}

fn the_only_map(domain: &Domain) -> Result<String> {
    let mut alive: Vec<String> =
        list_maps(domain)?.into_iter().filter(|map| map.alive).map(|map| map.name).collect();
    match (alive.pop(), alive.is_empty()) {
        (Some(name), true) => Ok(name),
        (None, _) => bail!(
            "no daemon serves a map here (prefix {}), and this program carries none: name a SOURCE, such as map.xodr",
            domain.prefix()
        ),
        (Some(_), false) => bail!("several maps are served: name one as SOURCE, shm:NAME"),
    }
}

fn copy_of(snapshot: &Snapshot) -> Result<Temporary> {
    // A name that nobody has made before: every user can put files and links there.
    let name = format!("mapd-bench-{}-{}.mapd", std::process::id(), since_epoch().as_nanos());
    let path = std::env::temp_dir().join(name);
    let writing = || format!("writing {}", path.display());
    let made = File::options().write(true).create_new(true).mode(0o600).open(&path);
    let mut file = made.with_context(writing)?;
    let temporary = Temporary(path.clone());
    file.write_all(snapshot.bytes()).with_context(writing)?;
    Ok(temporary)
}

/// Publishes an archive in a domain of this process alone and serves it while `work` runs.
fn serve_meanwhile<T>(archive: &Snapshot, work: impl FnOnce(&Domain) -> Result<T>) -> Result<T> {
    /// Stops the server even if the work panics: the scope waits for its thread.
    struct StopAtEnd<'a>(&'a StopSignal);
    impl Drop for StopAtEnd<'_> {
        fn drop(&mut self) {
            self.0.request();
        }
    }
    let domain = Domain::new(&format!("mapdb{}_", std::process::id()))?;
    let stop = StopSignal::new()?;
    let (ready, served) = mpsc::channel();
    std::thread::scope(|scope| {
        let (domain, stopped) = (&domain, &stop);
        let _at_end = StopAtEnd(&stop);
        let serving = scope.spawn(move || -> Result<()> {
            let mut server = Server::start(domain)?;
            let bytes = archive.bytes();
            let header = archive.header();
            let mut layout_id = [0; 32];
            layout_id[..LAYOUT_ID.len()].copy_from_slice(&LAYOUT_ID);
            server.publish(NAME, bytes.len(), |loan| {
                loan.copy_from_slice(bytes);
                Ok(PublishMeta {
                    layout_id,
                    content_hash: header.content_hash,
                    input_hash: header.provenance.input_hash,
                })
            })?;
            // The receiver waits for it.
            let _ = ready.send(());
            Ok(server.run(stopped)?)
        });
        if served.recv().is_err() {
            let end = serving.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            return Err(end.err().unwrap_or_else(|| anyhow::anyhow!("the server ended")));
        }
        work(domain)
    })
}
