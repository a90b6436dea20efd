//! The configuration file: TOML, with errors that name line and column.

use super::settings::MapSettings;
use super::sources;
use crate::args::CompileArguments;
use crate::args::ShareWith;
use crate::args::Size;
use crate::args::ThreadCount;
use crate::oversight::OversightSettings;
use crate::small_text::{self, at};
use anyhow::{Context, Result};
use mapd_client::Domain;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::net::SocketAddr;
use std::num::NonZeroU32;
use std::path::{Path, PathBuf};
use toml::{Spanned, Value};

/// What the file says, put to use.
#[derive(Debug, Default)]
pub(crate) struct Configuration {
    pub(crate) domain: Option<Domain>,
    pub(crate) cache: Option<PathBuf>,
    pub(crate) no_cache: bool,
    pub(crate) cache_size: Option<Size>,
    pub(crate) compile_memory: Option<Size>,
    pub(crate) threads: Option<ThreadCount>,
    pub(crate) lock_memory: bool,
    pub(crate) overlay_may_loosen: bool,
    pub(crate) overlay_entries: Option<usize>,
    pub(crate) overlay_bytes: Option<Size>,
    pub(crate) overlay_from: Option<PathBuf>,
    pub(crate) overlay_trust: Option<PathBuf>,
    pub(crate) share: Option<ShareWith>,
    pub(crate) trust: Option<PathBuf>,
    pub(crate) oversight: OversightSettings,
    pub(crate) watch: bool,
    pub(crate) stage: bool,
    pub(crate) last_good: bool,
    pub(crate) options: CompileArguments,
    pub(crate) maps: Vec<MapSettings>,
}

/// The file. Paths in it are relative to its folder.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    prefix: Option<Spanned<String>>,
    cache: Option<PathBuf>,
    #[serde(default)]
    no_cache: bool,
    cache_size: Option<Size>,
    compile_memory: Option<Size>,
    threads: Option<ThreadCount>,
    #[serde(default)]
    lock_memory: bool,
    #[serde(default)]
    overlay_may_loosen: bool,
    overlay_entries: Option<usize>,
    overlay_bytes: Option<Size>,
    overlay_from: Option<PathBuf>,
    overlay_trust: Option<PathBuf>,
    share: Option<ShareWith>,
    trust: Option<PathBuf>,
    metrics: Option<SocketAddr>,
    #[serde(default)]
    metrics_open: bool,
    scrub: Option<NonZeroU32>,
    #[serde(default)]
    watch: bool,
    #[serde(default)]
    stage: bool,
    #[serde(default)]
    last_good: bool,
    #[serde(default)]
    options: Options,
    #[serde(default, rename = "map")]
    maps: Vec<MapEntry>,
}

/// One map.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MapEntry {
    file: Spanned<PathBuf>,
    name: Option<String>,
    watch: Option<bool>,
    stage: Option<bool>,
    last_good: Option<bool>,
    max_bytes: Option<Size>,
    #[serde(default)]
    options: Options,
}

/// Options of compiling, named as the arguments are.
type Options = BTreeMap<Spanned<String>, Spanned<Value>>;

impl Configuration {
    /// Reads a file.
    ///
    /// Errors: it cannot be read; with line and column, what is wrong in it.
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let reading = || format!("reading {}", path.display());
        let text = small_text::read(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::parse(&text, folder).map_err(anyhow::Error::msg).with_context(reading)
    }

    fn parse(text: &str, folder: &Path) -> Result<Self, String> {
        let file: File = small_text::toml(text)?;
        let domain = match &file.prefix {
            Some(prefix) => Some(
                Domain::new(prefix.as_ref())
                    .map_err(|error| at(text, prefix.span().start, &error.to_string()))?,
            ),
            None => None,
        };
        let for_all = arguments(text, &file.options, folder)?;
        let mut maps = Vec::new();
        for entry in file.maps {
            let wrong = |error: &dyn Display| at(text, entry.file.span().start, &error.to_string());
            let files = sources::expand(&[folder.join(entry.file.as_ref())]);
            let files = files.map_err(|error| wrong(&format!("{error:#}")))?;
            if entry.name.is_some() && files.len() > 1 {
                return Err(wrong(&format!("a name goes with one map, found {}", files.len())));
            }
            let options = arguments(text, &entry.options, folder)?.or(&for_all);
            for source in files {
                let stem = || sources::stem(&source).map_err(|error| wrong(&error));
                maps.push(MapSettings {
                    name: entry.name.clone().map_or_else(stem, Ok)?,
                    source,
                    options: options.clone(),
                    watch: entry.watch.unwrap_or(file.watch),
                    stage: entry.stage.unwrap_or(file.stage),
                    last_good: entry.last_good.unwrap_or(file.last_good),
                    max_bytes: entry.max_bytes.map(|size| size.0),
                });
            }
        }
        Ok(Self {
            domain,
            cache: file.cache.map(|cache| folder.join(cache)),
            no_cache: file.no_cache,
            cache_size: file.cache_size,
            compile_memory: file.compile_memory,
            threads: file.threads,
            lock_memory: file.lock_memory,
            overlay_may_loosen: file.overlay_may_loosen,
            overlay_entries: file.overlay_entries,
            overlay_bytes: file.overlay_bytes,
            overlay_from: file.overlay_from.map(|policy| folder.join(policy)),
            overlay_trust: file.overlay_trust.map(|key| folder.join(key)),
            share: file.share,
            trust: file.trust.map(|key| folder.join(key)),
            oversight: OversightSettings {
                metrics: file.metrics,
                metrics_open: file.metrics_open,
                scrub: file.scrub,
            },
            watch: file.watch,
            stage: file.stage,
            last_good: file.last_good,
            options: for_all,
            maps,
        })
    }
}

fn arguments(text: &str, options: &Options, folder: &Path) -> Result<CompileArguments, String> {
    let mut arguments = CompileArguments::default();
    for (name, value) in options {
        let values = match value.as_ref() {
            Value::Array(values) => values.iter().map(plain).collect(),
            value => plain(value).map(|value| vec![value]),
        };
        let values: Vec<String> = values.ok_or_else(|| {
            at(text, value.span().start, "expected a number, a text, or a list of them")
        })?;
        arguments
            .add(name.as_ref(), &values, folder)
            .map_err(|error| at(text, name.span().start, &error))?;
    }
    Ok(arguments)
}

fn plain(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Integer(number) => Some(number.to_string()),
        Value::Float(number) => Some(number.to_string()),
        Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::Table(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "prefix = 'veh_'\ncache_size = '1 GiB'\nthreads = 4\nwatch = true\noptions = { landmarks = 4 }\n\
        [[map]]\nfile = 'town.xodr'\n\
        [[map]]\nfile = '/maps/a.xodr'\nname = 'ring'\nwatch = false\nmax_bytes = 1000\noptions.landmarks = 0\noptions.ontology = ['x.toml']\n";

    #[test]
    fn maps_have_their_own_names_and_options() {
        let file = Configuration::parse(GOOD, Path::new("/etc/mapd")).expect("good");
        assert_eq!(file.domain, Domain::new("veh_").ok());
        assert_eq!(file.threads.map(ThreadCount::get), Some(4));
        let [town, ring] = file.maps.as_slice() else { panic!("two maps") };
        assert_eq!((town.name.as_str(), town.watch, town.max_bytes), ("town", true, None));
        assert_eq!(town.source, Path::new("/etc/mapd/town.xodr"));
        assert_eq!((ring.name.as_str(), ring.watch, ring.max_bytes), ("ring", false, Some(1000)));
        assert_eq!(town.options.as_slice(), ["--landmarks", "4"]);
        assert_eq!(ring.options.as_slice(), ["--landmarks", "0", "--ontology", "/etc/mapd/x.toml"]);
    }

    #[test]
    fn a_folder_is_its_maps() {
        let folder = tempfile::tempdir().expect("a folder");
        let parse = |text: &str| Configuration::parse(text, folder.path());
        let empty = parse("[[map]]\nfile = '.'").expect_err("nothing in it");
        assert!(empty.contains("line 2, column 8") && empty.contains("no .xodr"), "{empty}");
        for name in ["b.xodr", "a.mapd", "c.txt"] {
            std::fs::write(folder.path().join(name), "").expect("written");
        }
        let file = parse("[[map]]\nfile = '.'\nwatch = true").expect("good");
        let maps: Vec<_> = file.maps.iter().map(|map| (map.name.as_str(), map.watch)).collect();
        assert_eq!(maps, [("a", true), ("b", true)]);
        let named = parse("[[map]]\nfile = '.'\nname = 'x'").expect_err("one name for two");
        assert!(named.contains("line 2, column 8") && named.contains("found 2"), "{named}");
    }

    #[test]
    fn errors_name_line_and_column() {
        for (text, place, word) in [
            ("wach = true", "line 1, column 1", "wach"),
            ("metrics = 'here'", "line 1, column 11", "address"),
            ("scrub = 0", "line 1, column 9", "nonzero"),
            ("threads = 0", "line 1, column 11", "from 1 to 512"),
            ("threads = 513", "line 1, column 11", "from 1 to 512"),
            ("scrub = inf", "line 1, column 9", "float"),
            ("options.index_tolerance = nan", "line 1, column 9", "finite"),
            ("watch = 3", "line 1, column 9", "boolean"),
            ("cache_size = 'big'", "line 1, column 14", "bytes"),
            ("\nprefix = 'a_b_'", "line 2, column 10", "prefix"),
            ("[options]\nlandmark = 3", "line 2, column 1", "did you mean \"landmarks\"?"),
            ("[options]\nlandmarks = 99", "line 2, column 1", "99"),
            ("[options]\nlandmarks = true", "line 2, column 13", "number"),
            ("[[map]]\nname = 'x'", "line 1, column 1", "file"),
            ("[[map]\n", "line 1", "expected"),
            ("wach = true", "line 1, column 1", "did you mean \"watch\"?"),
            ("[[map]]\nfile = 'x'\nnmae = 'y'", "line 3, column 1", "did you mean \"name\"?"),
        ] {
            let error = Configuration::parse(text, Path::new("")).expect_err("wrong");
            assert!(error.contains(place) && error.contains(word), "{text:?}: {error}");
        }
    }
}
