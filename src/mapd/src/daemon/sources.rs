//! Files and folders of maps.

use crate::exit::UsageError;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};

/// Files, with folders replaced by the maps in them.
pub(crate) fn expand(files: &[PathBuf]) -> Result<Vec<PathBuf>> {
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
            let message = format!("{} contains no .xodr, .xodrz or .mapd file", file.display());
            bail!(UsageError(message));
        }
        maps.sort();
        out.extend(maps);
    }
    Ok(out)
}

/// Whether a folder's file is a map. One whose name begins with a dot is passed over, as by shells: programs write under such names.
fn is_map(path: &Path) -> bool {
    let is_hidden = path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
    !is_hidden && path.extension().is_some_and(|e| e == "xodr" || e == "xodrz" || e == "mapd")
}

pub(crate) fn stem(file: &Path) -> Result<String> {
    let stem = file.file_stem().and_then(|stem| stem.to_str());
    let nameless =
        || UsageError(format!("{} has no name that is text; give one with --name", file.display()));
    Ok(stem.ok_or_else(nameless)?.to_owned())
}
