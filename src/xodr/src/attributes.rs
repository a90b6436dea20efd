//! The attributes of one start tag, and reading them as numbers and words.

use crate::finding::{Finding, Severity, Span};
use crate::rule_ids;
use std::ops::Range;

/// Attributes of a start tag, copied so that they outlive the read buffer.
#[derive(Debug, Default)]
pub(crate) struct Attributes {
    /// The tag's bytes, from behind `<`.
    tag: Vec<u8>,
    entries: Vec<(Range<usize>, Range<usize>)>,
    /// The whole start tag.
    pub(crate) span: Span,
}

/// Where findings about attributes go.
pub(crate) struct Context<'a> {
    pub(crate) findings: &'a mut Vec<Finding>,
    pub(crate) path: String,
}

impl Attributes {
    /// Splits a tag. `start` is the offset of `<`. The error is a message and the offset in the tag.
    pub(crate) fn parse(&mut self, tag: &[u8], start: u64) -> Result<(), (String, usize)> {
        self.tag.clear();
        self.tag.extend_from_slice(tag);
        self.entries.clear();
        self.span = Span { start, len: u32::try_from(tag.len() + 2).unwrap_or(u32::MAX) };
        let name_end = tag.iter().position(|b| b.is_ascii_whitespace()).unwrap_or(tag.len());
        let base = tag.as_ptr() as usize;
        let text = std::str::from_utf8(tag)
            .map_err(|e| ("the tag is not UTF-8".to_owned(), e.valid_up_to()))?;
        let attributes = quick_xml::events::attributes::Attributes::new(text, name_end);
        for attribute in attributes {
            let attribute = attribute.map_err(|e| (e.to_string(), name_end))?;
            let key = attribute.key.as_ref();
            let key_at = key.as_ptr() as usize - base;
            let value_at = attribute.value.as_ptr() as usize - base;
            self.entries
                .push((key_at..key_at + key.len(), value_at..value_at + attribute.value.len()));
        }
        Ok(())
    }

    /// Raw text of an attribute with its place.
    fn raw(&self, name: &str) -> Option<(&str, Span)> {
        let (_, value) = self
            .entries
            .iter()
            .find(|(key, _)| self.tag.get(key.clone()) == Some(name.as_bytes()))?;
        let text = std::str::from_utf8(self.tag.get(value.clone())?).ok()?;
        // One more for `<`, which is not part of the tag's bytes.
        let start = self.span.start + 1 + value.start as u64;
        Some((text, Span { start, len: u32::try_from(value.len()).unwrap_or(u32::MAX) }))
    }

    /// Text of an attribute, entities resolved, empty or not.
    pub(crate) fn text(&self, name: &str, context: &mut Context<'_>) -> Option<(String, Span)> {
        let (raw, span) = self.raw(name)?;
        if !raw.contains('&') {
            return Some((raw.to_owned(), span));
        }
        match quick_xml::escape::unescape(raw) {
            Ok(text) => Some((text.into_owned(), span)),
            Err(error) => {
                context.add(rule_ids::XML, Severity::Error, span, format!("@{name}: {error}"));
                None
            }
        }
    }

    /// Text of an optional attribute; an empty one counts as absent, with a warning.
    pub(crate) fn optional_text(
        &self,
        name: &str,
        context: &mut Context<'_>,
    ) -> Option<(String, Span)> {
        let (text, span) = self.text(name, context)?;
        if text.is_empty() {
            context.add(
                rule_ids::EMPTY,
                Severity::Warning,
                span,
                format!("@{name} is empty; read as absent"),
            );
            return None;
        }
        Some((text, span))
    }

    /// Text of a required attribute; none with an error.
    pub(crate) fn required_text(&self, name: &str, context: &mut Context<'_>) -> Option<String> {
        match self.text(name, context) {
            Some((text, _)) if !text.is_empty() => Some(text),
            Some((_, span)) => {
                context.add(
                    rule_ids::MISSING,
                    Severity::Error,
                    span,
                    format!("expected text in @{name}, found none"),
                );
                None
            }
            None => {
                self.missing(name, context);
                None
            }
        }
    }

    fn missing(&self, name: &str, context: &mut Context<'_>) {
        let message = format!("expected the attribute {name}, found none");
        context.add(rule_ids::MISSING, Severity::Error, self.span, message);
    }

    /// A required finite number; none with an error.
    pub(crate) fn number(&self, name: &str, context: &mut Context<'_>) -> Option<f64> {
        match self.raw(name) {
            None => {
                self.missing(name, context);
                None
            }
            Some((raw, span)) => number(name, raw, span, context),
        }
    }

    /// An optional finite number.
    pub(crate) fn optional_number(&self, name: &str, context: &mut Context<'_>) -> Option<f64> {
        let (raw, span) = self.raw(name)?;
        if raw.is_empty() {
            context.add(
                rule_ids::EMPTY,
                Severity::Warning,
                span,
                format!("@{name} is empty; read as absent"),
            );
            return None;
        }
        number(name, raw, span, context)
    }

    /// Several required numbers at once; none if one is missing, after naming each.
    pub(crate) fn numbers<const N: usize>(
        &self,
        names: [&str; N],
        context: &mut Context<'_>,
    ) -> Option<[f64; N]> {
        let values = names.map(|name| self.number(name, context));
        values.iter().all(Option::is_some).then(|| values.map(Option::unwrap_or_default))
    }

    /// A required whole number; none with an error.
    pub(crate) fn integer(&self, name: &str, context: &mut Context<'_>) -> Option<i32> {
        let Some((raw, span)) = self.raw(name) else {
            self.missing(name, context);
            return None;
        };
        match trimmed(name, raw, span, context).parse() {
            Ok(value) => Some(value),
            Err(_) => {
                let message = format!("expected a whole number in @{name}, found {raw:?}");
                context.add(rule_ids::VALUE, Severity::Error, span, message);
                None
            }
        }
    }

    /// A yes or no in any of the forms in use; `false` where it is absent or none of them, the latter with a warning.
    pub(crate) fn boolean(&self, name: &str, context: &mut Context<'_>) -> bool {
        let Some((raw, span)) = self.raw(name) else { return false };
        match raw.trim().to_ascii_lowercase().as_str() {
            "true" | "1" | "yes" => true,
            "false" | "0" | "no" => false,
            _ => {
                let message =
                    format!("expected true or false in @{name}, found {raw:?}; read as false");
                context.add(rule_ids::VALUE, Severity::Warning, span, message);
                false
            }
        }
    }

    /// A word of an enumeration. None where it is absent, empty or unknown, the latter two with a warning.
    pub(crate) fn word<T>(
        &self,
        name: &str,
        read: impl Fn(&str) -> Option<T>,
        context: &mut Context<'_>,
    ) -> Option<T> {
        let (text, span) = self.optional_text(name, context)?;
        let value = read(&text);
        if value.is_none() {
            let message = format!("@{name} has {text:?}, which the standard does not know");
            context.add(rule_ids::ENUMERATION, Severity::Warning, span, message);
        }
        value
    }
}

impl Context<'_> {
    pub(crate) fn add(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        message: String,
    ) {
        let path = self.path.clone();
        self.findings.push(Finding { rule, severity, span, path, message, hint: String::new() });
    }
}

fn trimmed<'a>(name: &str, raw: &'a str, span: Span, context: &mut Context<'_>) -> &'a str {
    let text = raw.trim();
    if text.len() != raw.len() {
        let message = format!("expected a number without white space in @{name}, found {raw:?}");
        context.add(rule_ids::SPACE, Severity::Warning, span, message);
    }
    text
}

fn number(name: &str, raw: &str, span: Span, context: &mut Context<'_>) -> Option<f64> {
    let text = trimmed(name, raw, span, context);
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Some(value),
        Ok(_) => {
            let message = format!("expected a finite number in @{name}, found {raw:?}");
            context.add(rule_ids::FINITE, Severity::Error, span, message);
            None
        }
        Err(_) => {
            let message = format!("expected a number in @{name}, found {raw:?}");
            context.add(rule_ids::VALUE, Severity::Error, span, message);
            None
        }
    }
}
