//! Which files are compiled, and what they are written to.

use crate::exit::UsageError;
use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A file and what it is compiled into.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Tile {
    pub(super) source: PathBuf,
    pub(super) archive: PathBuf,
    pub(super) report: PathBuf,
}

/// Tiles of files and folders, sorted by path. In `output_dir` folders keep the shape that they have within an input.
///
/// Errors: folders that cannot be read or hold no map; two files that would be written to the same archive; a file that
/// would be overwritten.
pub(super) fn tiles(inputs: &[PathBuf], output_dir: Option<&Path>) -> Result<Vec<Tile>> {
    let mut tiles = Vec::new();
    for input in inputs {
        if !input.is_dir() {
            let name = input.file_name();
            let name = name.with_context(|| format!("{} names no file", input.display()))?;
            tiles.push(tile(input, Path::new(name), output_dir));
            continue;
        }
        let mut files = Vec::new();
        search(input, &mut files)?;
        if files.is_empty() {
            let message = format!("{} contains no .xodr or .xodrz file", input.display());
            bail!(UsageError(message));
        }
        for file in files {
            let within = file.strip_prefix(input).unwrap_or(&file).to_owned();
            tiles.push(tile(&file, &within, output_dir));
        }
    }
    tiles.sort();
    without_clashes(tiles)
}

fn tile(source: &Path, within: &Path, output_dir: Option<&Path>) -> Tile {
    let place = output_dir.map_or_else(|| source.to_owned(), |folder| folder.join(within));
    Tile {
        source: source.to_owned(),
        archive: place.with_extension("mapd"),
        report: place.with_extension("report.json"),
    }
}

/// Maps in a folder and all folders within it. Links to folders are not followed: they may lead in circles.
fn search(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let reading = || format!("reading folder {}", folder.display());
    for entry in fs::read_dir(folder).with_context(reading)? {
        let entry = entry.with_context(reading)?;
        let path = entry.path();
        if entry.file_type().with_context(reading)?.is_dir() {
            search(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "xodr" || e == "xodrz") && !path.is_dir() {
            files.push(path);
        }
    }
    Ok(())
}

/// The same file named twice is compiled once.
fn without_clashes(tiles: Vec<Tile>) -> Result<Vec<Tile>> {
    let mut kept: BTreeMap<PathBuf, Tile> = BTreeMap::new();
    let sources: std::collections::BTreeSet<PathBuf> =
        tiles.iter().map(|tile| place(&tile.source)).collect();
    for tile in tiles {
        let archive = place(&tile.archive);
        if sources.contains(&archive) || sources.contains(&place(&tile.report)) {
            let message = format!(
                "compiling {} would overwrite a source; see --output-dir",
                tile.source.display()
            );
            bail!(UsageError(message));
        }
        match kept.get(&archive) {
            Some(other) if place(&other.source) != place(&tile.source) => {
                bail!(UsageError(format!(
                    "{} and {} would both be written to {}; compile them one by one with -o",
                    other.source.display(),
                    tile.source.display(),
                    tile.archive.display()
                )))
            }
            Some(_) => {}
            None => drop(kept.insert(archive, tile)),
        }
    }
    let mut tiles: Vec<Tile> = kept.into_values().collect();
    tiles.sort();
    Ok(tiles)
}

/// A file's place under one name, whether it is there or not: links to its folder are followed.
fn place(file: &Path) -> PathBuf {
    let absolute = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    // Of folders that will be made, those that are there count.
    let folder = absolute.ancestors().skip(1).find_map(|folder| {
        let real = fs::canonicalize(folder).ok()?;
        Some(real.join(absolute.strip_prefix(folder).ok()?))
    });
    folder.unwrap_or(absolute)
}
