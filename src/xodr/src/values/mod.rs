//! What the text of an attribute means: numbers, yes and no, speeds, countries, in all the ways that files in the wild write
//! them.
//!
//! One policy decides what is accepted: a text is read, with a finding, where it has exactly one plausible meaning; where it
//! has several or none, it is refused with a finding. Nothing is ever read as 0 for want of a number.
//!
//! | written | as a number | why |
//! |---|---|---|
//! | `1.5`, `.5`, `5.`, `+1e-3` | as written, rounded correctly | `xs:double` |
//! | ` 1.5 ` | 1.5, [`Quirk::Space`] | the standard's schema allows it |
//! | *(empty)* | none, [`Quirk::Empty`] | exporters write it for absent |
//! | `INF`, `NaN`, `inf`, `-nan(ind)`, `1.#QNAN` | none, [`Quirk::NotFinite`] | no quantity of a road is infinite |
//! | `1e999` | none, [`Quirk::TooLarge`] | no double is that large |
//! | `0x1p3` | none, [`Quirk::Hexadecimal`] | C reads it, nobody else does |
//! | `4.0+0` | 4, [`Quirk::NoExponentLetter`] | a lost `e` or a sum: both mean 4 |
//! | `4.0+2` | none, [`Quirk::Ambiguous`] | 400 or 6 |
//! | `1.5D+02` | 150, [`Quirk::FortranExponent`] | Fortran's double precision |
//! | `1,5` | 1.5, [`Quirk::DecimalComma`] | a German or French locale |
//! | `1,500`, `1,5,0` | none, [`Quirk::Ambiguous`] | 1.5 or 1500; a list |
//! | `1.5+0i`, `(1.5,0)` | 1.5, [`Quirk::Complex`] | MATLAB's numbers, nothing lost |
//! | `1.5+2i` | none, [`Quirk::Ambiguous`] | a number of two parts |
//! | `3.5 m`, `1 000`, `abc`, `None` | none, [`Quirk::NotANumber`] | |
//!
//! Pure functions of the raw text: references are resolved where there are any.

mod country;
mod number;
mod text;
mod word;

pub use country::{Country, CountryForm, country};
pub use number::{double, integer};
pub use text::text;
pub(crate) use text::{push_resolved, reference, reference_end};
pub use word::{Speed, boolean, speed};

use crate::finding::Severity;
use std::fmt;

/// A value, and what was unusual about its text. Without a value there always is a quirk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lexical<T> {
    /// The value; none where the text is refused or empty.
    pub value: Option<T>,
    /// What was unusual.
    pub quirk: Option<Quirk>,
}

impl<T> Lexical<T> {
    fn clean(value: T) -> Self {
        Self { value: Some(value), quirk: None }
    }

    fn some(value: T, quirk: Quirk) -> Self {
        Self { value: Some(value), quirk: Some(quirk) }
    }

    fn none(quirk: Quirk) -> Self {
        Self { value: None, quirk: Some(quirk) }
    }

    fn map<U>(self, change: impl FnOnce(T) -> U) -> Lexical<U> {
        Lexical { value: self.value.map(change), quirk: self.quirk }
    }
}

/// What is unusual about the text of a value. Printed, it says what was expected, what was found and what was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quirk {
    /// Nothing, or white space. Read as absent.
    Empty,
    /// White space before or after. Passed over; `xs:double` allows it.
    Space,
    /// Infinity or not a number. Refused.
    NotFinite,
    /// A number beyond the largest one that is stored. Refused.
    TooLarge,
    /// Hexadecimal. Refused.
    Hexadecimal,
    /// No number, or one with something behind it. Refused.
    NotANumber,
    /// A number with two plausible readings. Refused.
    Ambiguous,
    /// An exponent of zero without its letter. Accepted.
    NoExponentLetter,
    /// `d` for `e`. Accepted.
    FortranExponent,
    /// A comma for the point. Accepted.
    DecimalComma,
    /// A complex number without an imaginary part. Accepted.
    Complex,
    /// A whole number with a point and zeros. Accepted.
    PointInInteger,
    /// A number with a fraction where a whole one is due. Refused.
    NotAnInteger,
    /// A yes or no in other words than `true` and `false`. Accepted.
    OtherBoolean,
    /// Neither yes nor no. Refused.
    NotABoolean,
    /// A word in another case or spelling. Accepted.
    OtherCase,
    /// A country that is not known. Refused.
    UnknownCountry,
}

impl Quirk {
    /// How bad it is: an error where the text is refused, a warning where it is absent or accepted against the standard's
    /// schema, information where the schema allows it.
    pub fn severity(self) -> Severity {
        match self {
            Self::Space => Severity::Info,
            Self::Empty
            | Self::NoExponentLetter
            | Self::FortranExponent
            | Self::DecimalComma
            | Self::Complex
            | Self::PointInInteger
            | Self::OtherBoolean
            | Self::OtherCase
            | Self::UnknownCountry => Severity::Warning,
            Self::NotFinite
            | Self::TooLarge
            | Self::Hexadecimal
            | Self::NotANumber
            | Self::Ambiguous
            | Self::NotAnInteger
            | Self::NotABoolean => Severity::Error,
        }
    }

    /// The two halves of a finding's message: what was expected, and what was found and done.
    pub fn sentence(self) -> (&'static str, &'static str) {
        match self {
            Self::Empty => ("a value or no attribute", "an empty one; read as absent"),
            Self::Space => ("no white space around a value", "some; passed over"),
            Self::NotFinite => ("a finite number", "an infinite one or none; refused"),
            Self::TooLarge => ("a number that can be stored", "a larger one; refused"),
            Self::Hexadecimal => ("a decimal number", "a hexadecimal one; refused"),
            Self::NotANumber => ("a number", "something else; refused"),
            Self::Ambiguous => ("a number", "something with several readings; refused"),
            Self::NoExponentLetter => {
                ("an exponent with e", "one of zero without it; read as the number before")
            }
            Self::FortranExponent => ("an exponent with e", "one with d; read as e"),
            Self::DecimalComma => ("a decimal point", "a comma; read as the point"),
            Self::Complex => {
                ("a real number", "a complex one without imaginary part; read as real")
            }
            Self::PointInInteger => {
                ("a whole number", "one with a point and zeros; read without them")
            }
            Self::NotAnInteger => ("a whole number", "one with a fraction; refused"),
            Self::OtherBoolean => ("true or false", "another word for it; read as that"),
            Self::NotABoolean => ("true or false", "something else; refused"),
            Self::OtherCase => ("the standard's spelling", "another one; read as that"),
            Self::UnknownCountry => {
                ("a country's code of ISO 3166 or OpenDRIVE", "something else; kept as text")
            }
        }
    }
}

impl fmt::Display for Quirk {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (expected, found) = self.sentence();
        write!(out, "expected {expected}, found {found}")
    }
}

/// The text without XML's white space around it, and the quirk if there was some.
fn trimmed(raw: &[u8]) -> (&[u8], Option<Quirk>) {
    let is_space = |byte: &u8| matches!(byte, b' ' | b'\t' | b'\n' | b'\r');
    let start = raw.iter().position(|b| !is_space(b)).unwrap_or(raw.len());
    let end = raw.iter().rposition(|b| !is_space(b)).map_or(start, |last| last + 1);
    (&raw[start..end], (end - start < raw.len()).then_some(Quirk::Space))
}
