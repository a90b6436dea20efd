//! The current value, read as its type and checked against the schema.

use crate::attribute::{Attribute, Enumeration, PositionOrEnd};
use crate::cursor::{Current, Cursor};
use crate::finding::{Severity, Span};
use crate::findings::About;
use crate::generated::schema_words::{COUNTRY_CODE, ROAD_END};
use crate::rule_ids;
use crate::same::same;
use crate::schema::{Kind, NAMES, Range, V1_6, WordList, alike};
use crate::values::{self, Lexical, Quirk, Speed};

impl Cursor<'_> {
    /// The value's bytes as written.
    #[inline]
    fn raw(&self) -> &[u8] {
        match self.current {
            Current::Attribute(raw) => self.bytes(raw.value),
            Current::Content => self.content.trim_ascii().as_bytes(),
        }
    }

    /// A value with its place.
    #[inline]
    fn placed<T>(&self, value: T) -> Attribute<T> {
        let (offset, len) = match self.current {
            Current::Attribute(raw) => {
                (raw.value.0 as usize, raw.value.1.saturating_sub(raw.value.0) as usize)
            }
            Current::Content => {
                let start = self.content_start.unwrap_or(self.element.start);
                let offset = start.saturating_sub(self.element.start);
                (usize::try_from(offset).unwrap_or(0), self.content.trim_ascii().len())
            }
        };
        Attribute::new(value, offset, len)
    }

    fn span(&self) -> Span {
        self.placed(()).span(self.element)
    }

    /// How findings name the value.
    fn what(&self) -> String {
        match self.current {
            Current::Attribute(_) => format!("@{}", self.schema.name),
            Current::Content => "the text".to_owned(),
        }
    }

    /// The value as a finding shows it.
    fn shown(&self) -> String {
        /// Characters of a value that are shown.
        const SHOWN: usize = 80;
        let text = String::from_utf8_lossy(self.raw()).into_owned();
        match text.char_indices().nth(SHOWN) {
            Some((at, _)) => format!("{:?}…", &text[..at]),
            None => format!("{text:?}"),
        }
    }

    /// Whether the version takes any text here.
    fn is_loose(&self) -> bool {
        self.schema.loose >> self.version & 1 == 1
    }

    /// Adds a finding about the value.
    #[cold]
    fn about(&mut self, rule: &'static str, severity: Severity, expected: &str, done: &str) {
        let message =
            format!("expected {expected} in {}, found {}{done}", self.what(), self.shown());
        let (span, name) = (self.span(), self.schema.name);
        if matches!(self.current, Current::Attribute(_)) {
            self.find_key();
        }
        // What a version's schema takes is no error against it.
        let severity = if self.is_loose() { severity.min(Severity::Warning) } else { severity };
        self.add(rule, severity, span, name, message);
    }

    /// Adds the finding about an unusual text.
    #[cold]
    fn quirk(&mut self, quirk: Quirk, value_is_used: bool) {
        let rule = match quirk {
            Quirk::Empty => rule_ids::EMPTY,
            Quirk::Space => rule_ids::SPACE,
            Quirk::NotFinite | Quirk::TooLarge => rule_ids::FINITE,
            _ if value_is_used => rule_ids::LEXICAL,
            _ => rule_ids::VALUE,
        };
        let (expected, found) = quirk.sentence();
        let message =
            format!("expected {expected} in {}, found {found}: {}", self.what(), self.shown());
        let mut severity = quirk.severity();
        if quirk == Quirk::Empty && self.schema.required >> self.version & 1 == 1 {
            severity = Severity::Error;
        }
        if self.is_loose() {
            severity = severity.min(Severity::Warning);
        }
        let (span, name) = (self.span(), self.schema.name);
        if matches!(self.current, Current::Attribute(_)) {
            self.find_key();
        }
        self.add(rule, severity, span, name, message);
    }

    /// The value of a text, after saying what is unusual about it.
    #[inline]
    fn lexical<T>(&mut self, lexical: Lexical<T>) -> Option<T> {
        if let Some(quirk) = lexical.quirk {
            self.quirk(quirk, lexical.value.is_some());
        }
        lexical.value
    }

    #[inline]
    fn in_range(&mut self, value: f64) {
        let range = self.schema.ranges[self.version];
        if range != Range::Any && !range.has(value) {
            self.out_of_range(range);
        }
    }

    #[cold]
    fn out_of_range(&mut self, range: Range) {
        let expected = format!("{} ({})", range.words(), self.standard());
        self.about(rule_ids::RANGE, Severity::Error, &expected, "");
    }

    /// A finite number.
    #[inline]
    pub(crate) fn double(&mut self) -> Option<Attribute<f64>> {
        let lexical = values::double(self.raw());
        let value = self.lexical(lexical)?;
        self.in_range(value);
        Some(self.placed(value))
    }

    fn whole(&mut self) -> Option<i64> {
        let lexical = values::integer(self.raw());
        let value = self.lexical(lexical)?;
        self.in_range(value as f64);
        Some(value)
    }

    /// A whole number.
    pub(crate) fn int(&mut self) -> Option<Attribute<i32>> {
        let value = self.whole()?;
        match i32::try_from(value) {
            Ok(value) => Some(self.placed(value)),
            Err(_) => self.too_large("a whole number of 32 bits"),
        }
    }

    /// A whole number that is not negative.
    pub(crate) fn uint(&mut self) -> Option<Attribute<u32>> {
        let value = self.whole()?;
        match u32::try_from(value) {
            Ok(value) => Some(self.placed(value)),
            Err(_) => self.too_large("a whole number of at least 0 and 32 bits"),
        }
    }

    fn too_large<T>(&mut self, expected: &str) -> Option<T> {
        self.about(rule_ids::RANGE, Severity::Error, expected, "; not used");
        None
    }

    /// Yes or no, in the words of the type.
    pub(crate) fn boolean(&mut self) -> Option<Attribute<bool>> {
        let raw = self.raw();
        let plain = match (self.schema.kind, raw) {
            (Kind::YesNo, b"yes") | (Kind::XsBoolean, b"1") => Some(true),
            (Kind::YesNo, b"no") | (Kind::XsBoolean, b"0") => Some(false),
            _ => None,
        };
        if let Some(value) = plain {
            return Some(self.placed(value));
        }
        let mut lexical = values::boolean(raw);
        if matches!(self.schema.kind, Kind::YesNo) && lexical.value.is_some() {
            lexical.quirk = Some(Quirk::OtherBoolean);
        }
        let value = self.lexical(lexical)?;
        Some(self.placed(value))
    }

    /// A speed limit.
    pub(crate) fn speed_limit(&mut self) -> Option<Attribute<Speed>> {
        let lexical = values::speed(self.raw());
        let value = self.lexical(lexical)?;
        match value {
            Speed::Limit(value) => self.in_range(value),
            _ if matches!(self.schema.kind, Kind::LaneSpeedLimit) => {
                let expected = format!("a number ({})", self.standard());
                self.about(
                    rule_ids::VALUE,
                    Severity::Warning,
                    &expected,
                    "; read as a road's speed limit would be",
                );
            }
            _ => {}
        }
        Some(self.placed(value))
    }

    /// A distance along a road, or one of its ends.
    pub(crate) fn position_or_end(&mut self) -> Option<Attribute<PositionOrEnd>> {
        let value = match self.raw() {
            // The standard's schema has `start`, its examples have `begin`.
            b"start" => PositionOrEnd::Start,
            b"begin" => {
                self.about(
                    rule_ids::ENUMERATION,
                    Severity::Warning,
                    ROAD_END.words[0].text,
                    "; read as that",
                );
                PositionOrEnd::Start
            }
            b"end" => PositionOrEnd::End,
            raw => {
                let lexical = values::double(raw);
                let value = self.lexical(lexical)?;
                // The schema of 1.8 wants more than 0, which would leave out the road's start; its text does not.
                if value < 0.0 {
                    self.out_of_range(Range::AtLeast0);
                }
                PositionOrEnd::At(value)
            }
        };
        Some(self.placed(value))
    }

    /// Text, references resolved.
    pub(crate) fn text(&mut self) -> Option<Attribute<Box<str>>> {
        let value: Box<str> = match self.current {
            Current::Attribute(_) => {
                values::text(std::str::from_utf8(self.raw()).unwrap_or_default()).into()
            }
            Current::Content => self.content.trim().into(),
        };
        if value.len() != value.trim_ascii().len() && self.is_identifier() {
            let expected = "no white space around an identifier";
            self.about(rule_ids::SPACE, Severity::Info, expected, "; kept");
        }
        if self.schema.numeric >> self.version & 1 == 1 {
            let lexical = values::double(value.as_bytes());
            if lexical.value.is_none() {
                let expected = format!("a number ({})", self.standard());
                self.about(rule_ids::VALUE, Severity::Error, &expected, "; kept as text");
            }
        }
        if !self.schema.fixed.is_empty() && *value != *self.schema.fixed {
            self.about(rule_ids::ENUMERATION, Severity::Error, self.schema.fixed, "");
        }
        Some(self.placed(value))
    }

    /// Whether the value is an identifier or refers to one, as its name says.
    fn is_identifier(&self) -> bool {
        let name = self.schema.name;
        name == "id" || name == "junction" || name.ends_with("Id") || name.ends_with("Road")
    }

    /// The code or name of a country, as written.
    pub(crate) fn country(&mut self) -> Option<Attribute<Box<str>>> {
        let lexical = values::country(self.raw());
        if lexical.quirk == Some(Quirk::Empty) {
            self.quirk(Quirk::Empty, false);
            return None;
        }
        let raw = self.raw();
        let letters = raw.iter().all(u8::is_ascii_uppercase);
        let fits = match raw.len() {
            2 => letters && self.version >= usize::from(V1_6),
            3 => letters,
            _ => COUNTRY_CODE.words.iter().any(|word| word.text.as_bytes() == raw),
        };
        if !fits && !self.is_loose() {
            let form = if self.version >= usize::from(V1_6) { "two or three" } else { "three" };
            let expected =
                format!("{form} capital letters or a country's name ({})", self.standard());
            // The text is kept, and a lookup by it finds the generic catalogue: nothing is lost.
            self.about(rule_ids::VALUE, Severity::Warning, &expected, "; kept as text");
        } else if lexical.value.is_none() {
            self.quirk(Quirk::UnknownCountry, true);
        }
        let value = values::text(std::str::from_utf8(self.raw()).unwrap_or_default()).into();
        Some(self.placed(value))
    }

    /// A word of an enumeration; `Unlisted` for one that the standard does not list.
    pub(crate) fn word<T: Enumeration>(&mut self) -> Option<Attribute<T>> {
        let rank = self.word_of(T::list())?;
        Some(self.placed(rank.map_or(T::UNLISTED, T::of_rank)))
    }

    /// As [`Self::word`], as the text that is written: for callers that need the words that the standard does not list.
    pub(crate) fn word_as_text<T: Enumeration>(&mut self) -> Option<Attribute<Box<str>>> {
        let rank = self.word_of(T::list())?;
        let listed = rank.and_then(|rank| T::list().words.get(rank));
        let text = listed.map(|word| word.text.into()).unwrap_or_else(|| {
            values::text(std::str::from_utf8(self.raw()).unwrap_or_default()).trim().into()
        });
        Some(self.placed(text))
    }

    /// The rank of a word; none within for one that is not known, none at all for an empty value.
    pub(crate) fn word_of(&mut self, list: &'static WordList) -> Option<Option<usize>> {
        let raw = self.raw();
        let Some(rank) = list.words.iter().position(|word| same(word.text.as_bytes(), raw)) else {
            return self.unusual_word(list);
        };
        let word = &list.words[rank];
        let bit = 1 << self.version;
        if word.versions & alike(self.version as u8) == 0 || word.deprecated & bit != 0 {
            self.old_word(word.text, word.versions & bit != 0);
        }
        Some(Some(rank))
    }

    #[cold]
    fn old_word(&mut self, text: &str, is_known: bool) {
        let standard = self.standard();
        if is_known {
            let expected = format!("a word that {standard} does not deprecate");
            self.about(rule_ids::DEPRECATED, Severity::Info, &expected, "");
        } else if !self.is_loose() && self.schema.versions & alike(self.version as u8) != 0 {
            // Of an attribute that is of another version itself, its words need no finding of their own.
            let expected = format!("a word of {standard}");
            self.about(
                rule_ids::OTHER_VERSION,
                Severity::Warning,
                &expected,
                &format!(", which other versions have; read as {text}"),
            );
        }
    }

    #[cold]
    fn unusual_word(&mut self, list: &'static WordList) -> Option<Option<usize>> {
        let text = values::text(std::str::from_utf8(self.raw()).unwrap_or_default()).into_owned();
        let trimmed = text.trim_matches([' ', '\t', '\n', '\r']);
        if trimmed.is_empty() {
            self.quirk(Quirk::Empty, false);
            return None;
        }
        if let Some(rank) = list.words.iter().position(|word| word.text == trimmed) {
            if text.len() != trimmed.len() {
                self.quirk(Quirk::Space, true);
            }
            return Some(Some(rank));
        }
        let synonym = list.synonyms.iter().find(|(own, _)| own.eq_ignore_ascii_case(trimmed));
        if let Some((_, word)) = synonym {
            self.about(rule_ids::LEXICAL, Severity::Warning, word, "; read as that");
            return Some(list.words.iter().position(|own| own.text == *word));
        }
        if !self.is_loose() {
            let known = list.words.iter().filter(|w| w.versions & alike(self.version as u8) != 0);
            let known: Vec<&str> = known.map(|word| word.text).collect();
            let expected = format!("a word of {} ({})", list.name, known.join(", "));
            self.about(rule_ids::ENUMERATION, Severity::Error, &expected, "");
        }
        Some(None)
    }

    /// Takes the version from the header's attributes, which have been split but not read yet.
    pub(crate) fn set_version(&mut self) {
        let span = self.tag.span;
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|n| n.fract() == 0.0);
        let (major, minor) = (self.attribute_text("revMajor"), self.attribute_text("revMinor"));
        let newest = NAMES.len() - 1;
        let (version, problem) = match (number(&major), number(&minor)) {
            (Some(1.0), Some(minor)) if minor < 4.0 => (0, Some("checked as the oldest")),
            (Some(1.0), Some(minor)) => {
                // 1.8 is checked as 1.8.1, with what 1.8.0 alone has as information.
                let rank = match minor as u32 {
                    minor @ 4..=7 => Some(minor as usize - 4),
                    8 => Some(5),
                    9 => Some(6),
                    _ => None,
                };
                (rank.unwrap_or(newest), rank.is_none().then_some("checked as the newest"))
            }
            _ => (newest, Some("checked as the newest")),
        };
        self.version = version;
        self.stated = if major.is_empty() && minor.is_empty() {
            String::new()
        } else {
            format!("{major}.{minor}")
        };
        if let Some(done) = problem {
            let stated = if self.stated.is_empty() { "none" } else { &self.stated };
            let message = format!("expected revision 1.4 to 1.9, found {stated}; {done}");
            let path = format!("{}/header", self.path());
            // What is none is worse than one that is not known.
            let is_stated = [&major, &minor].map(|number| number.trim().parse::<u16>().is_ok());
            let severity = if is_stated == [true; 2] { Severity::Warning } else { Severity::Error };
            let about =
                About { element: "Header", tag: "header", top: "header", detail: "revMinor" };
            self.findings.add(rule_ids::VERSION, severity, span, about, || (path, message));
        }
    }
}
