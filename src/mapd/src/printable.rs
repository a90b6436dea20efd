//! Text that comes from a map, or is the name of a file, for a terminal or a log.

use std::borrow::Cow;
use std::path::Path;

/// Whether a character would do something to a terminal instead of being seen, or break a line in two.
fn is_unseen(c: char) -> bool {
    // What turns the direction of writing around, and line breaks that are no control characters.
    let turns = matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || turns || matches!(c, '\u{2028}' | '\u{2029}')
}

/// The text with a dot for each character that is not to be seen, a space for a tab: a map may come from anywhere. One for one, so that
/// columns stay.
pub(crate) fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_unseen) {
        return Cow::Borrowed(text);
    }
    let shown = |c| match c {
        '\t' => ' ',
        c if is_unseen(c) => '·',
        c => c,
    };
    Cow::Owned(text.chars().map(shown).collect())
}

/// The name of a file likewise.
pub(crate) fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy()).into_owned()
}

/// Lines of text likewise, each for itself: those of another process, which has seen to what is in a line.
pub(crate) fn printable_lines(text: &str) -> String {
    text.split_inclusive('\n')
        .map(|line| match line.strip_suffix('\n') {
            Some(line) => printable(line).into_owned() + "\n",
            None => printable(line).into_owned(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{printable, printable_lines};

    #[test]
    fn what_does_something_to_a_terminal_is_a_dot() {
        for (text, shown) in [
            ("", ""),
            ("Gärtnerstraße 7 → 道", "Gärtnerstraße 7 → 道"),
            ("a\tb", "a b"),
            ("9\nmapd: serving", "9·mapd: serving"),
            ("\u{1b}[31mred\u{9b}0m\r\0\u{7f}", "·[31mred·0m···"),
            ("a\u{202e}b\u{2028}c\u{85}", "a·b·c·"),
        ] {
            assert_eq!(printable(text), shown);
        }
        assert_eq!(printable_lines("a\u{1b}[2J\nb\rc\n\nd"), "a·[2J\nb·c\n\nd");
    }
}
