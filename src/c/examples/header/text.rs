//! The text of the C header.

use cbindgen::{
    Builder, Config, DocumentationStyle, EnumConfig, Language, RenameRule, SortKey, Style,
};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Sources in the order in which they stand in the header.
pub(crate) const SOURCES: &[&str] = &[
    "code",
    "text",
    "ids",
    "point",
    "scratch",
    "client",
    "events",
    "snapshot",
    "lookup",
    "nearest",
    "road",
    "lane",
    "matching",
    "tracker",
    "ground",
    "polyline",
    "graph",
    "route",
    "path",
    "along",
    "path_facts",
    "path_steps",
    "corridor",
    "conflicts",
    "view",
    "view_path",
    "view_ways",
    "propose",
    "request",
    "junction",
    "signals",
    "signals_ahead",
    "movement",
    "objects",
    "landmarks",
    "marks",
    "surface",
    "details",
    "groups",
    "earth",
    "names",
];

/// What stands at the top.
const PREAMBLE: &str = "\
/* mapd for C: attach to a served map, or open a .mapd file, and query its lanes in place. Made from the sources of the crate mapd-c by cbindgen.
 *
 * Every function that can fail returns a mapd_code and takes an optional mapd_error of the caller's, which it writes only on an error.
 * A handle is closed with the function that takes its address and sets it to null. Lists go into the caller's buffer: capacity goes in, the number
 * of all entries comes out, and MAPD_CODE_TOO_SMALL says that only as many as there was room for were written; the buffer may be null where the
 * capacity is 0.
 *
 * Threads: a client, a snapshot, a view, a path and a projector may be used by several threads at once; a scratch, a tracker and events by one at
 * a time.
 * Lengths are metres, angles radians, times seconds, speeds metres per second; t is positive to the left of the reference line. A uint8_t that
 * answers yes or no is 1 or 0. docs/cpp.md begins with examples. */";

/// Where the header lies.
pub(crate) fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("include/mapd.h")
}

/// A name in capitals, words separated by one underscore each.
fn constant(name: &str) -> String {
    let mut out = String::new();
    let mut before = ' ';
    for c in name.chars() {
        let begins = c.is_ascii_uppercase() && before.is_ascii_lowercase();
        if (begins || !c.is_ascii_alphanumeric()) && !out.ends_with('_') && !out.is_empty() {
            out.push('_');
        }
        if c.is_ascii_alphanumeric() {
            out.push(c.to_ascii_uppercase());
        }
        before = c;
    }
    out.trim_end_matches('_').to_owned()
}

/// Enumerations of the codes that stand in results.
fn words() -> String {
    let mut out = String::from("/* `vocabulary` of mapd_word. */\nenum {\n");
    for (name, number) in mapd_c::vocabulary_numbers() {
        let _ = writeln!(out, "  {name} = {number},");
    }
    out.push_str("};\n");
    for vocabulary in mapd_c::vocabularies() {
        let prefix = vocabulary.prefix;
        let _ = write!(out, "\n/* {prefix}_…: codes, with the words of mapd_word. */\nenum {{\n");
        for (code, name, word) in vocabulary.words {
            let _ = writeln!(out, "  {prefix}_{} = {code}, /* {word} */", constant(&name));
        }
        out.push_str("};\n");
    }
    out
}

/// The header, whose codes have no tag where the name is that of a number: in C++ one name cannot be both, of which compilers of C warn.
fn without_tag(header: String) -> String {
    const SIZED: &str = "defined(__cplusplus) || __STDC_VERSION__ >= 202311L";
    let tagged = format!("enum mapd_code\n#if {SIZED}\n  : int32_t\n#endif // {SIZED}\n {{\n");
    assert!(header.contains(&tagged), "cbindgen writes the codes in another way");
    let both = format!("#if {SIZED}\nenum mapd_code : int32_t\n#else\nenum\n#endif\n{{\n");
    header.replace(&tagged, &both)
}

/// The header.
pub(crate) fn header() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let config = Config {
        language: Language::C,
        cpp_compat: true,
        include_guard: Some("MAPD_H".into()),
        header: Some(PREAMBLE.into()),
        after_includes: Some(words()),
        no_includes: true,
        sys_includes: vec!["stddef.h".into(), "stdint.h".into()],
        style: Style::Both,
        usize_is_size_t: true,
        documentation_style: DocumentationStyle::C,
        line_length: 120,
        enumeration: EnumConfig {
            prefix_with_name: true,
            rename_variants: RenameRule::ScreamingSnakeCase,
            ..EnumConfig::default()
        },
        function: cbindgen::FunctionConfig {
            sort_by: Some(SortKey::None),
            ..cbindgen::FunctionConfig::default()
        },
        ..Config::default()
    };
    let mut builder = Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(folder.join(source).with_extension("rs"));
    }
    let mut out = Vec::new();
    match builder.generate() {
        Ok(bindings) => bindings.write(&mut out),
        Err(error) => panic!("cbindgen refuses the sources: {error}"),
    }
    let text = without_tag(String::from_utf8(out).unwrap_or_default());
    // Rustdoc's brackets and marks mean nothing here.
    text.replace("\\[", "[").replace("\\]", "]")
}
