//! `mapd --load`: the main job.

use crate::control::{Board, GenerationStatus};
use crate::exit::Exit;
use crate::oversight::log::{self, say};
use crate::oversight::{Oversight, OversightArgs};
use crate::progress::Bar;
use crate::serve::{PublishMeta, Server, StopSignal};
use crate::trust::signable;
use crate::{report, source};
use anyhow::{Context, Result, bail};
use mapd_archive::{LAYOUT_ID, Rows, encode_into, encoded_length, verify};
use mapd_client::{Domain, Snapshot, TrustedKey};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions};
use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A map that is ready to be published.
enum Ready {
    Compiled(Box<Rows>, Box<Compilation>),
    Archive(Snapshot),
}

/// Serves every map until stopped. All are compiled before the first is published: either all are served or none.
///
/// Errors: files, shared memory, or another daemon that serves a map of the same name.
pub(crate) fn run(
    files: &[PathBuf],
    name: Option<&str>,
    (reading, options): (&ReadOptions, &CompileOptions),
    (key, oversight): (Option<&TrustedKey>, &OversightArgs),
    domain: &Domain,
) -> Result<Exit> {
    oversight.log.init();
    let files = expand(files)?;
    if name.is_some() && files.len() != 1 {
        bail!("--name goes with one map, found {}", files.len());
    }
    let mut names = BTreeSet::new();
    let mut maps = Vec::new();
    let mut exit = Exit::Done;
    for file in &files {
        let name = match name {
            Some(name) => name.to_owned(),
            None => stem(file)?,
        };
        if !names.insert(name.clone()) {
            bail!(
                "two maps would be named {name}; serve them from daemons of their own with --name"
            );
        }
        if key.is_some() {
            signable(file)?;
        }
        match prepare(file, reading, options)? {
            Some(ready) => maps.push((name, file, ready)),
            None => exit = exit.worst(Exit::Rejected),
        }
    }
    if exit != Exit::Done {
        say("nothing is served: a map was rejected");
        return Ok(exit);
    }
    let stop = StopSignal::install().context("installing the handlers of SIGINT and SIGTERM")?;
    let mut server = Server::start_with(domain, log::notice)?;
    let board = Arc::new(Board::new(domain, None));
    for (name, file, ready) in maps {
        let trust = key.map(|key| (key, file.as_path()));
        let (generation, length) = publish(&mut server, &name, ready, trust)?;
        tracing::info!(map = %name, generation, bytes = length, "serving {name}, generation {generation}, {length} bytes");
        let served = GenerationStatus { generation, bytes: length as u64, ..Default::default() };
        board.map(&name, |map| map.served = Some(served));
    }
    let watched = Oversight::start(oversight, domain, &board, names.into_iter().collect())?;
    server.run(&stop)?;
    drop(watched);
    say("stopped");
    Ok(Exit::Done)
}

/// Files, with folders replaced by the maps in them.
fn expand(files: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut out = Vec::new();
    for file in files {
        if !file.is_dir() {
            out.push(file.clone());
            continue;
        }
        let entries = std::fs::read_dir(file)
            .with_context(|| format!("reading folder {}", file.display()))?;
        let mut maps: Vec<PathBuf> = entries
            .filter_map(|entry| Some(entry.ok()?.path()))
            .filter(|path| is_map(path))
            .collect();
        if maps.is_empty() {
            bail!("{} holds no .xodr, .xodrz or .mapd file", file.display());
        }
        maps.sort();
        out.extend(maps);
    }
    Ok(out)
}

fn is_map(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "xodr" || e == "xodrz" || e == "mapd")
}

fn stem(file: &Path) -> Result<String> {
    let stem = file.file_stem().and_then(|stem| stem.to_str());
    Ok(stem
        .with_context(|| {
            format!("{} has no name that is text; give one with --name", file.display())
        })?
        .to_owned())
}

fn prepare(file: &Path, reading: &ReadOptions, options: &CompileOptions) -> Result<Option<Ready>> {
    if source::is_archive(file) {
        return Ok(Some(Ready::Archive(Snapshot::open(file)?)));
    }
    let bar = Bar::new(file);
    let mut compiled = source::compile_file_with(file, reading, options, &mut |p| bar.show(p))?;
    bar.finish();
    report::print(&file.display().to_string(), &compiled);
    Ok(compiled.rows.take().map(|rows| Ready::Compiled(Box::new(rows), Box::new(compiled))))
}

/// Publishes one map: written straight into the loan, verified there, then sent. What is trusted is proved there too: it is
/// the bytes that readers see, whatever becomes of the file.
fn publish(
    server: &mut Server,
    name: &str,
    ready: Ready,
    trust: Option<(&TrustedKey, &Path)>,
) -> Result<(u64, usize)> {
    let length = match &ready {
        Ready::Compiled(rows, _) => encoded_length(rows)?,
        Ready::Archive(snapshot) => snapshot.bytes().len(),
    };
    let fill = |loan: &mut [u8]| -> Result<PublishMeta, Box<dyn Error + Send + Sync>> {
        match &ready {
            Ready::Compiled(rows, compiled) => {
                encode_into(rows, &compiled.provenance, loan)?;
            }
            Ready::Archive(snapshot) => loan.copy_from_slice(snapshot.bytes()),
        }
        if let Some((key, archive)) = trust {
            key.verify_beside(archive, loan)?;
        }
        let header = verify(loan)?.header;
        let mut layout_id = [0; 32];
        layout_id[..LAYOUT_ID.len()].copy_from_slice(&LAYOUT_ID);
        Ok(PublishMeta {
            layout_id,
            content_hash: header.content_hash,
            input_hash: header.provenance.input_hash,
        })
    };
    Ok((server.publish(name, length, fill)?, length))
}
