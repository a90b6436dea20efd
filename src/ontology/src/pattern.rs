//! Patterns of types and names: `*` stands for any text, `?` for any character, `#` for a digit, capital letters do not count.

/// What stands for other characters.
pub(crate) const WILD: [char; 3] = ['*', '?', '#'];

/// A pattern in lower case.
#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    text: Box<str>,
    /// Whether it is one text, as nearly all are.
    is_exact: bool,
}

impl Pattern {
    pub(crate) fn new(text: &str) -> Self {
        Self { text: text.to_lowercase().into(), is_exact: !text.contains(WILD) }
    }

    /// Whether a text, already in lower case, fits.
    pub(crate) fn fits(&self, text: &str) -> bool {
        if self.is_exact {
            return *self.text == *text;
        }
        let (pattern, text) = (self.text.as_bytes(), text.as_bytes());
        // Where the last star stood, and where in the text the try after it began.
        let (mut p, mut t) = (0, 0);
        let mut star: Option<(usize, usize)> = None;
        while t < text.len() {
            match pattern.get(p) {
                Some(b'*') => {
                    star = Some((p, t));
                    p += 1;
                }
                Some(&letter)
                    if letter == b'?'
                        || letter == text[t]
                        || letter == b'#' && text[t].is_ascii_digit() =>
                {
                    p += 1;
                    t += 1;
                }
                _ => match star {
                    Some((at, from)) => {
                        star = Some((at, from + 1));
                        (p, t) = (at + 1, from + 1);
                    }
                    None => return false,
                },
            }
        }
        pattern[p..].iter().all(|&letter| letter == b'*')
    }

    /// Whether the pattern is one text.
    pub(crate) fn is_exact(&self) -> bool {
        self.is_exact
    }
}

#[cfg(test)]
mod tests {
    use super::Pattern;

    #[test]
    fn patterns_fit() {
        for (pattern, text, expected) in [
            ("274", "274", true),
            ("274", "2741", false),
            ("274.*", "274.1", true),
            ("44?", "449", true),
            ("44?", "44", false),
            ("*cone*", "trafficcone01", true),
            ("a*b*c", "axxbyyc", true),
            ("a*b*c", "axxbyy", false),
            ("", "", true),
            ("*", "", true),
            ("speed_#*", "speed_30_2", true),
            ("speed_#*", "speed_bump", false),
        ] {
            assert_eq!(Pattern::new(pattern).fits(text), expected, "{pattern} {text}");
        }
    }
}
