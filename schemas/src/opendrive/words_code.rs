//! Enumerations.

use super::names::{constant, variant};
use super::schema_code::set_code;
use super::{Table, VersionSet, Words, note};
use std::fmt::Write as _;

/// One enum for each enumeration.
pub(super) fn enums(table: &Table) -> String {
    let mut out = format!("//! Enumerations.\n{}", note("words"));
    out += "use super::schema_words::*;\nuse crate::attribute::enumeration;\n";
    for words in &table.words {
        let _ = write!(
            out,
            "\nenumeration! {{\n    /// {} (`{}`).\n    {}: {} {{\n",
            words.doc,
            words.schema,
            words.name,
            constant(&words.name)
        );
        // Two spellings of one word are one variant, named as the newer one.
        for (rank, word) in words.words.iter().enumerate() {
            let name = variant(&word.word);
            if words.words[rank + 1..].iter().all(|later| variant(&later.word) != name) {
                let _ = writeln!(out, "        {name} = {:?},", word.word);
            }
        }
        let ranks: Vec<String> = words.words.iter().map(|word| variant(&word.word)).collect();
        let _ = write!(out, "    }} words {{ {} }}\n}}\n", ranks.join(" "));
    }
    out
}

/// One list of words for each enumeration.
pub(super) fn lists(table: &Table) -> String {
    let mut out = format!("//! The words of enumerations.\n{}", note("words"));
    out +=
        "use crate::schema::{V1_4, V1_5, V1_6, V1_7, V1_8, V1_9, WordList, between, from, word};\n";
    for words in &table.words {
        out += &list(words);
    }
    out
}

fn list(words: &Words) -> String {
    let mut out = format!(
        "\npub(crate) static {}: WordList = WordList {{\nname: \"{}\",\nwords: &[\n",
        constant(&words.name),
        words.schema
    );
    for word in &words.words {
        let _ = write!(out, "word({:?})", word.word);
        let versions = word.versions();
        if versions != VersionSet::ALL {
            let _ = write!(out, ".only({})", set_code(versions));
        }
        let deprecated = word.deprecations();
        if deprecated != VersionSet::NONE {
            let _ = write!(out, ".deprecated({})", set_code(deprecated));
        }
        out += ",\n";
    }
    out += "],\nsynonyms: &[";
    for one in &words.synonyms {
        let _ = write!(out, "({:?}, {:?}), ", one.written, one.word);
    }
    out += "],\n};\n";
    out
}
