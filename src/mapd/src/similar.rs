//! What a mistyped word may have meant.

/// How alike two words must be, from 0 (not at all) to 1; as for commands and options.
const ALIKE: f64 = 0.7;

/// `; did you mean "word"?` with the word that is most like this one; empty if none is like it.
pub(crate) fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let likeness = |one: &'a str| (strsim::jaro(&word.to_lowercase(), &one.to_lowercase()), one);
    let alike = known.into_iter().map(likeness).filter(|(likeness, _)| *likeness > ALIKE);
    match alike.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((_, meant)) => format!("; did you mean {meant:?}?"),
        None => String::new(),
    }
}

/// The same for a message that quotes the word and then all that are known, as those of serde do.
pub(crate) fn did_you_mean_of(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    match (message.contains("unknown"), quoted.next()) {
        (true, Some(word)) => did_you_mean(word, quoted),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_similar_word() {
        let known = ["town", "tower", "ring"];
        for (word, meant) in
            [("twon", "; did you mean \"town\"?"), ("Town", "; did you mean \"town\"?"), ("x", "")]
        {
            assert_eq!(did_you_mean(word, known), meant, "{word}");
        }
        assert_eq!(did_you_mean("town", []), "");
    }

    #[test]
    fn words_of_a_message() {
        for (message, meant) in [
            ("unknown field `nmae`, expected one of `file`, `name`", "; did you mean \"name\"?"),
            ("unknown variant `x`, expected `closed`", ""),
            ("invalid type: integer `3`, expected `4`", ""),
            ("unknown", ""),
        ] {
            assert_eq!(did_you_mean_of(message), meant, "{message}");
        }
    }
}
