//! What the schema says of an element, in the form that the reader checks against. The table in `schemas/opendrive`
//! fills it; see `generated`.

/// Versions of the standard as bits, oldest first.
pub(crate) type Versions = u8;

/// Number of versions.
pub(crate) const COUNT: usize = 7;
/// Names of the versions.
pub(crate) const NAMES: [&str; COUNT] = ["1.4", "1.5", "1.6", "1.7", "1.8", "1.8.1", "1.9"];

pub(crate) const V1_4: u8 = 0;
pub(crate) const V1_5: u8 = 1;
pub(crate) const V1_6: u8 = 2;
pub(crate) const V1_7: u8 = 3;
pub(crate) const V1_8: u8 = 4;
pub(crate) const V1_8_1: u8 = 5;
pub(crate) const V1_9: u8 = 6;
/// Every version.
pub(crate) const ALL: Versions = (1 << COUNT) - 1;

/// A version and all later ones.
pub(crate) const fn from(version: u8) -> Versions {
    ALL & !((1 << version) - 1)
}

/// From a version to another, both included.
pub(crate) const fn between(first: u8, last: u8) -> Versions {
    from(first) & ((1 << (last + 1)) - 1)
}

/// The versions as bits that a file of a version may follow. Files cannot say whether they follow 1.8 or 1.8.1.
pub(crate) const fn alike(version: u8) -> Versions {
    if version == V1_8_1 { 1 << V1_8 | 1 << V1_8_1 } else { 1 << version }
}

/// How a value is read.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Text,
    Double,
    Int,
    Uint,
    /// `true` or `false`.
    Boolean,
    /// `yes` or `no`.
    YesNo,
    /// `true`, `false`, `1`, `0`.
    XsBoolean,
    /// Two or three letters, or a name.
    Country,
    /// A number, `no limit` or `undefined`.
    SpeedLimit,
    /// A number; the words of a speed limit are read with a warning.
    LaneSpeedLimit,
    /// A number, `start` or `end`.
    PositionOrEnd,
    Words(&'static WordList),
}

/// What a number may be.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Range {
    Any,
    AtLeast0,
    AtLeast1,
    Above0,
    ZeroToOne,
    Not0,
    Exactly(i32),
}

impl Range {
    pub(crate) fn has(self, value: f64) -> bool {
        match self {
            Range::Any => true,
            Range::AtLeast0 => value >= 0.0,
            Range::AtLeast1 => value >= 1.0,
            Range::Above0 => value > 0.0,
            Range::ZeroToOne => (0.0..=1.0).contains(&value),
            Range::Not0 => value != 0.0,
            Range::Exactly(fixed) => value == f64::from(fixed),
        }
    }

    pub(crate) fn words(self) -> &'static str {
        match self {
            Range::Any => "any number",
            Range::AtLeast0 => "a number of at least 0",
            Range::AtLeast1 => "a number of at least 1",
            Range::Above0 => "a number above 0",
            Range::ZeroToOne => "a number from 0 to 1",
            Range::Not0 => "a number other than 0",
            Range::Exactly(0) => "0",
            Range::Exactly(1) => "1",
            Range::Exactly(_) => "another number",
        }
    }
}

/// A word of an enumeration.
pub(crate) struct Word {
    pub(crate) text: &'static str,
    pub(crate) versions: Versions,
    pub(crate) deprecated: Versions,
}

/// A word of all versions, to be narrowed.
pub(crate) const fn word(text: &'static str) -> Word {
    Word { text, versions: ALL, deprecated: 0 }
}

impl Word {
    pub(crate) const fn only(mut self, versions: Versions) -> Self {
        self.versions = versions;
        self
    }

    pub(crate) const fn deprecated(mut self, versions: Versions) -> Self {
        self.deprecated = versions;
        self
    }
}

/// The words of an enumeration.
pub(crate) struct WordList {
    /// Name of the enumeration in the standard's schema.
    pub(crate) name: &'static str,
    pub(crate) words: &'static [Word],
    /// Other spellings, in any case, each with the word that it can only mean.
    pub(crate) synonyms: &'static [(&'static str, &'static str)],
}

/// An attribute as the schema describes it.
pub(crate) struct AttributeSchema {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    /// Versions that have it.
    pub(crate) versions: Versions,
    /// Versions whose schema requires it.
    pub(crate) required: Versions,
    /// Versions whose text requires it although their schema does not.
    pub(crate) by_text: Versions,
    /// The text of 1.9 does not require it although the schema does.
    pub(crate) not_by_text: bool,
    /// Versions that take any text.
    pub(crate) loose: Versions,
    /// Versions that want a number in this text.
    pub(crate) numeric: Versions,
    pub(crate) deprecated: Versions,
    /// Variants of the element that have it, as bits.
    pub(crate) when: u8,
    pub(crate) ranges: [Range; COUNT],
    /// The one text that it may have; empty for any.
    pub(crate) fixed: &'static str,
}

/// An optional attribute of all versions, to be narrowed.
pub(crate) const fn attribute(name: &'static str, kind: Kind) -> AttributeSchema {
    AttributeSchema {
        name,
        kind,
        versions: ALL,
        required: 0,
        by_text: 0,
        not_by_text: false,
        loose: 0,
        numeric: 0,
        deprecated: 0,
        when: u8::MAX,
        ranges: [Range::Any; COUNT],
        fixed: "",
    }
}

impl AttributeSchema {
    pub(crate) const fn only(mut self, versions: Versions) -> Self {
        self.versions = versions;
        self
    }

    pub(crate) const fn required(mut self, versions: Versions) -> Self {
        self.required = versions;
        self
    }

    pub(crate) const fn by_text(mut self, versions: Versions) -> Self {
        self.by_text = versions;
        self
    }

    pub(crate) const fn not_by_text(mut self) -> Self {
        self.not_by_text = true;
        self
    }

    pub(crate) const fn loose(mut self, versions: Versions) -> Self {
        self.loose = versions;
        self
    }

    pub(crate) const fn numeric(mut self, versions: Versions) -> Self {
        self.numeric = versions;
        self
    }

    pub(crate) const fn deprecated(mut self, versions: Versions) -> Self {
        self.deprecated = versions;
        self
    }

    pub(crate) const fn when(mut self, variants: u8) -> Self {
        self.when = variants;
        self
    }

    pub(crate) const fn fixed(mut self, text: &'static str) -> Self {
        self.fixed = text;
        self
    }

    pub(crate) const fn range(mut self, range: Range, versions: Versions) -> Self {
        let mut version = 0;
        while version < COUNT {
            if versions >> version & 1 == 1 {
                self.ranges[version] = range;
            }
            version += 1;
        }
        self
    }
}

/// Any number of times.
pub(crate) const MANY: u16 = u16::MAX;

/// A child as the schema describes it.
pub(crate) struct ChildSchema {
    pub(crate) name: &'static str,
    pub(crate) element: &'static ElementSchema,
    pub(crate) versions: Versions,
    pub(crate) deprecated: Versions,
    pub(crate) order: u16,
    /// At least and at most, by version.
    pub(crate) occurs: [(u16, u16); COUNT],
    /// Variants of the parent that have it, as bits.
    pub(crate) when: u8,
    pub(crate) choice: bool,
}

/// A child of all versions, any number of times, to be narrowed.
pub(crate) const fn child(
    name: &'static str,
    element: &'static ElementSchema,
    order: u16,
) -> ChildSchema {
    ChildSchema {
        name,
        element,
        versions: ALL,
        deprecated: 0,
        order,
        occurs: [(0, MANY); COUNT],
        when: u8::MAX,
        choice: false,
    }
}

impl ChildSchema {
    pub(crate) const fn only(mut self, versions: Versions) -> Self {
        self.versions = versions;
        self
    }

    #[allow(dead_code, reason = "no version so far deprecates an element")]
    pub(crate) const fn deprecated(mut self, versions: Versions) -> Self {
        self.deprecated = versions;
        self
    }

    pub(crate) const fn when(mut self, variants: u8) -> Self {
        self.when = variants;
        self
    }

    pub(crate) const fn choice(mut self) -> Self {
        self.choice = true;
        self
    }

    pub(crate) const fn occurs(mut self, min: u16, max: u16, versions: Versions) -> Self {
        let mut version = 0;
        while version < COUNT {
            if versions >> version & 1 == 1 {
                self.occurs[version] = (min, max);
            }
            version += 1;
        }
        self
    }
}

/// How many of the children in a choice an element has.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Choice {
    /// Exactly one kind.
    One,
    /// One kind or none.
    AtMostOne,
    /// Any mixture.
    Any,
}

/// Kinds of elements that may stand in others: rank in [`ElementSchema::additional`].
pub(crate) const USER_DATA: usize = 0;
pub(crate) const INCLUDE: usize = 1;
pub(crate) const DATA_QUALITY: usize = 2;

/// An element as the schema describes it.
pub(crate) struct ElementSchema {
    /// Name of its type.
    pub(crate) name: &'static str,
    pub(crate) attributes: &'static [AttributeSchema],
    pub(crate) children: &'static [ChildSchema],
    /// The attribute that tells one such element from another in paths.
    pub(crate) key: Option<usize>,
    /// Text inside is content.
    pub(crate) content: Option<Kind>,
    /// Whatever stands inside is allowed.
    pub(crate) any: bool,
    pub(crate) choice: Choice,
    /// Versions in which userData, include and dataQuality may stand inside.
    pub(crate) additional: [Versions; 3],
    /// The variant of an element: from its parent's variant and its `type`.
    pub(crate) variant: Option<fn(u8, &str) -> u8>,
    /// Names of the variants.
    pub(crate) variants: &'static [&'static str],

    // What follows is the above as bits of attributes or children, by version, so that a sound element is checked at once.
    /// Attributes that are allowed without remark.
    pub(crate) plain: [u64; COUNT],
    /// Attributes that are required by schema or text.
    pub(crate) wanted: [u64; COUNT],
    /// Children that are allowed without remark.
    pub(crate) plain_children: [u64; COUNT],
    /// Children that must be there.
    pub(crate) wanted_children: [u64; COUNT],
    /// Children that may be there once.
    pub(crate) single_children: [u64; COUNT],
    /// Children that must be counted.
    pub(crate) counted: u64,
    /// Children in the choice.
    pub(crate) chosen: u64,
}

impl ElementSchema {
    pub(crate) const fn new(
        name: &'static str,
        attributes: &'static [AttributeSchema],
        children: &'static [ChildSchema],
    ) -> Self {
        let mut schema = Self {
            name,
            attributes,
            children,
            key: None,
            content: None,
            any: false,
            choice: Choice::Any,
            additional: [0; 3],
            variant: None,
            variants: &[],
            plain: [0; COUNT],
            wanted: [0; COUNT],
            plain_children: [0; COUNT],
            wanted_children: [0; COUNT],
            single_children: [0; COUNT],
            counted: 0,
            chosen: 0,
        };
        let mut version = 0;
        while version < COUNT {
            let bit = 1 << version;
            let mut i = 0;
            while i < attributes.len() {
                let a = &attributes[i];
                if a.versions & bit != 0 && a.deprecated & bit == 0 && a.when == u8::MAX {
                    schema.plain[version] |= 1 << i;
                }
                if (a.required | a.by_text) & bit != 0 {
                    schema.wanted[version] |= 1 << i;
                }
                i += 1;
            }
            let mut i = 0;
            while i < children.len() {
                let c = &children[i];
                let (min, max) = c.occurs[version];
                if c.versions & bit != 0 && c.deprecated & bit == 0 && c.when == u8::MAX {
                    schema.plain_children[version] |= 1 << i;
                }
                if c.versions & bit != 0 && min > 0 && !c.choice {
                    schema.wanted_children[version] |= 1 << i;
                }
                if max == 1 {
                    schema.single_children[version] |= 1 << i;
                }
                if min > 1 || (max > 1 && max != MANY) {
                    schema.counted |= 1 << i;
                }
                if c.choice {
                    schema.chosen |= 1 << i;
                }
                i += 1;
            }
            version += 1;
        }
        schema
    }

    pub(crate) const fn key(mut self, attribute: usize) -> Self {
        self.key = Some(attribute);
        self
    }

    pub(crate) const fn content(mut self, kind: Kind) -> Self {
        self.content = Some(kind);
        self
    }

    pub(crate) const fn any(mut self) -> Self {
        self.any = true;
        self
    }

    pub(crate) const fn choice(mut self, choice: Choice) -> Self {
        self.choice = choice;
        self
    }

    pub(crate) const fn additional(
        mut self,
        user_data: Versions,
        include: Versions,
        data_quality: Versions,
    ) -> Self {
        self.additional = [user_data, include, data_quality];
        self
    }

    pub(crate) const fn variants(
        mut self,
        variants: &'static [&'static str],
        variant: fn(u8, &str) -> u8,
    ) -> Self {
        self.variants = variants;
        self.variant = Some(variant);
        self
    }
}
